//! Open groups of a block, innermost last.

use super::token::Token;
use crate::diagnostic::{Code, Diagnostic, Span};

/// What is open.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Group {
    /// A bracket and what closes it.
    Bracket(char),
    /// `\left|` or `\lvert`
    Absolute,
    /// Braces that are brackets.
    Braces,
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
    /// An environment of components, such as `bmatrix`, and its name.
    Matrix(String),
}

impl Group {
    fn shown(&self) -> String {
        match self {
            Group::Bracket(')') => "`(`".to_owned(),
            Group::Bracket(']') => "`[`".to_owned(),
            Group::Bracket(_) => r"`\{`".to_owned(),
            Group::Absolute => "`|`".to_owned(),
            Group::Rows(name) | Group::Matrix(name) => format!(r"`\begin{{{name}}}`"),
            _ => "`{`".to_owned(),
        }
    }
}

/// The open groups.
#[derive(Debug, Default)]
pub struct Groups {
    open: Vec<(Group, Span)>,
}

impl Groups {
    /// Opens a group at `place`.
    pub fn open(&mut self, group: Group, place: Span) {
        self.open.push((group, place));
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
