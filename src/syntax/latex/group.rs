//! Open groups of a block, innermost last.

use super::token::{Token, TokenKind};
use crate::diagnostic::{Code, Diagnostic, Span};

/// What is open.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Group {
    /// A bracket and what closes it.
    Bracket(char),
    /// `\left|` or `\lvert`
    Absolute,
    /// Braces of a root, which are brackets.
    Braces,
    /// Braces of an exponent.
    Exponent,
    /// Braces that TeX does not show.
    Unseen(Unseen),
    /// The numerator of a fraction.
    Above,
    /// The denominator of a fraction.
    Below,
    /// Above the bar of a derivative.
    DerivativeAbove,
    /// Below the bar of a derivative.
    DerivativeBelow,
    /// An environment of rows, such as `aligned`, and its name.
    Rows(String),
    /// An environment of components, such as `bmatrix`, its name, and what separates them: `&` or `\\`.
    Matrix(String, Option<TokenKind>),
}

/// What stands between braces that TeX does not show.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub struct Unseen {
    /// Letters, numbers, commands and groups, and what stands between them.
    pub atoms: usize,
    /// Whether an operator is among them.
    pub has_operator: bool,
}

/// An argument that begins with braces or a fraction: nothing shows where it ends.
#[derive(Debug, Clone, Copy)]
pub struct Argument {
    /// The function.
    pub function: Span,
    /// Where the argument begins.
    pub start: usize,
    /// How many groups are open around it.
    depth: usize,
}

impl Group {
    fn shown(&self) -> String {
        match self {
            Group::Bracket(')') => "`(`".to_owned(),
            Group::Bracket(']') => "`[`".to_owned(),
            Group::Bracket(_) => r"`\{`".to_owned(),
            Group::Absolute => "`|`".to_owned(),
            Group::Rows(name) | Group::Matrix(name, _) => format!(r"`\begin{{{name}}}`"),
            _ => "`{`".to_owned(),
        }
    }
}

/// The open groups.
#[derive(Debug, Default)]
pub struct Groups {
    open: Vec<(Group, Span)>,
    arguments: Vec<Argument>,
}

impl Groups {
    /// Opens a group at `place`.
    pub fn open(&mut self, group: Group, place: Span) {
        self.open.push((group, place));
    }

    /// Lets the group that opens next at `start` be the argument of a function without brackets.
    pub fn begin_argument(&mut self, function: Span, start: usize) {
        self.arguments.push(Argument { function, start, depth: self.open.len() });
    }

    /// The argument that ends with the group that was just closed.
    pub fn end_argument(&mut self) -> Option<Argument> {
        let depth = self.open.len();
        self.arguments.pop_if(|argument| argument.depth == depth)
    }

    /// The innermost group, if its braces are not shown.
    pub fn unseen(&mut self) -> Option<&mut Unseen> {
        match self.open.last_mut() {
            Some((Group::Unseen(unseen), _)) => Some(unseen),
            _ => None,
        }
    }

    /// What separates the components of the innermost group, if it is a matrix.
    pub fn separator(&mut self) -> Option<&mut Option<TokenKind>> {
        match self.open.last_mut() {
            Some((Group::Matrix(_, separator), _)) => Some(separator),
            _ => None,
        }
    }

    /// Where the innermost group opened.
    pub fn place(&self) -> Option<Span> {
        self.open.last().map(|(_, place)| *place)
    }

    /// The innermost group.
    pub fn last(&self) -> Option<&Group> {
        self.open.last().map(|(group, _)| group)
    }

    /// Whether nothing is open.
    pub fn is_empty(&self) -> bool {
        self.open.is_empty()
    }

    /// Whether only environments of rows are open.
    pub fn is_outside(&self) -> bool {
        matches!(self.last(), None | Some(Group::Rows(_)))
    }

    /// Closes the innermost group, which must be one that `token` closes.
    pub fn close(&mut self, token: &Token<'_>, is_closed: impl Fn(&Group) -> bool) -> Result<Group, Diagnostic> {
        match self.open.pop() {
            Some((group, _)) if is_closed(&group) => Ok(group),
            Some((group, place)) => {
                let message = format!("{} is closed by `{}`", group.shown(), written(token));
                Err(Diagnostic::new(Code::UnbalancedBracket, message).at(token.span).label(place, "opened here"))
            }
            None => {
                let message = format!("`{}` closes nothing", written(token));
                Err(Diagnostic::new(Code::UnbalancedBracket, message).at(token.span))
            }
        }
    }

    /// Refuses the end of a block while a group is open.
    pub fn check_closed(&self) -> Result<(), Diagnostic> {
        match self.open.last() {
            None => Ok(()),
            Some((group, place)) => {
                let message = format!("{} is never closed", group.shown());
                Err(Diagnostic::new(Code::UnbalancedBracket, message).at(*place))
            }
        }
    }
}

fn written(token: &Token<'_>) -> String {
    if token.kind == super::token::TokenKind::Command { format!("\\{}", token.text) } else { token.text.to_owned() }
}
