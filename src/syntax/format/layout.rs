//! Spacing inside a line and indentation of it.

use super::align::Row;
use super::token::{Kind, Line, Token};
use crate::syntax::preflight::{continues, starts_statement};

/// Blanks for each level.
const INDENT: usize = 4;

/// What the lines so far say about the next one.
#[derive(Default)]
struct Reader {
    /// Braces of blocks that are open.
    blocks: usize,
    /// For each open bracket, whether it is the brace of a block.
    open: Vec<bool>,
    /// Whether constraints of an `at` block may follow.
    is_boundary: bool,
    /// Whether the statement is `solve`, whose values have a spacing of their own.
    is_solve: bool,
    /// The last token.
    before: Option<(Kind, String)>,
    /// The code of the last line that has any.
    last: String,
}

/// The rows of a text.
pub fn lay_out(lines: &[Line<'_>]) -> Vec<Row> {
    let mut reader = Reader::default();
    lines.iter().map(|line| reader.row(line)).collect()
}

impl Reader {
    fn row(&mut self, line: &Line<'_>) -> Row {
        let code = line.code();
        let comment = line.comment().map(str::to_owned);
        let Some(first) = code.first() else {
            let indent = (!line.indent.is_empty()).then(|| self.level() * INDENT);
            return Row { comment, indent, ..Row::default() };
        };
        let bare = bare(code);
        let in_bracket = self.open.last().is_some_and(|is_block| !is_block);
        let is_statement = !in_bracket && starts_statement(&bare);
        let is_continued = in_bracket || (!is_statement && continues(&self.last, &bare));
        // A comma between constraints separates them; the next one is no continuation.
        let is_sibling = !in_bracket && self.is_boundary && self.last.ends_with([',', ';']) && first.kind == Kind::Word;
        if is_statement {
            self.is_boundary = first.is("at");
            self.is_solve = first.is("solve");
        }
        if first.is("}") && !in_bracket {
            self.is_boundary = false;
            self.is_solve = false;
        }
        let closes = usize::from(first.kind == Kind::Close);
        let is_inner = is_continued && !is_sibling && closes == 0;
        let is_constraint = self.is_boundary && !is_statement && !first.is("}");
        let level = self.blocks.saturating_sub(usize::from(first.is("}") && !in_bracket))
            + usize::from(is_constraint)
            + usize::from(is_inner);
        let (text, equals) = self.spaced(code);
        self.last = bare;
        let is_latex = first.kind == Kind::Latex;
        // LaTeX is kept as it is, its place on the line included.
        let text = if is_latex { format!("{}{text}", line.indent) } else { text };
        let equals = equals.filter(|_| is_constraint && !is_inner && closes == 0 && !is_latex);
        Row { indent: Some(if is_latex { 0 } else { level * INDENT }), text, equals, comment }
    }

    /// The level of a comment that stands in a block.
    fn level(&self) -> usize {
        self.blocks + usize::from(self.is_boundary)
    }

    /// The line with its spacing, and where its first `=` outside brackets stands.
    fn spaced(&mut self, code: &[Token<'_>]) -> (String, Option<usize>) {
        let mut text = String::new();
        let mut equals = None;
        for (index, token) in code.iter().enumerate() {
            let is_block =
                token.is("{") && !self.before.as_ref().is_some_and(|(_, text)| matches!(&**text, "^" | "**"));
            let closes_block = token.is("}") && self.open.last() == Some(&true);
            if index > 0 && self.is_apart(token, is_block || closes_block) {
                text.push(' ');
            }
            if token.is("=") && equals.is_none() && self.open.last().is_none_or(|is_block| *is_block) {
                equals = Some(text.len());
            }
            text.push_str(&token.text);
            match token.kind {
                Kind::Open => {
                    self.open.push(is_block);
                    self.blocks += usize::from(is_block);
                }
                Kind::Close => self.blocks -= usize::from(self.open.pop() == Some(true)).min(self.blocks),
                _ => {}
            }
            self.before = Some((self.role(token, is_block || closes_block), token.text.to_string()));
        }
        (text, equals)
    }

    /// What a token is for the one behind it: a sign before an operand is part of it, and so is a function's.
    fn role(&self, token: &Token<'_>, is_block: bool) -> Kind {
        match token.kind {
            Kind::Sign if !self.follows_operand() => Kind::Root,
            Kind::Open | Kind::Close if is_block => Kind::Comma,
            Kind::Word
                if matches!(
                    &*token.text,
                    "in" | "with" | "param" | "let" | "domain" | "pde" | "at" | "solve" | "keeping"
                ) =>
            {
                Kind::Comma
            }
            kind => kind,
        }
    }

    fn follows_operand(&self) -> bool {
        let operand = [Kind::Word, Kind::Number, Kind::Superscript, Kind::Close, Kind::Other, Kind::Latex];
        self.before.as_ref().is_some_and(|(kind, _)| operand.contains(kind))
    }

    /// Whether a blank stands before `token`, which is not the first of its line.
    fn is_apart(&self, token: &Token<'_>, is_brace_of_block: bool) -> bool {
        let Some((before, before_text)) = &self.before else { return false };
        match (before, token.kind) {
            _ if is_brace_of_block => true,
            (_, Kind::Comma) => false,
            (Kind::Comma, _) | (_, Kind::Relation) | (Kind::Relation, _) => true,
            // `11 x 11:gauss`, `per-basis`
            (Kind::Colon, _) | (_, Kind::Colon) if self.is_solve => false,
            _ if self.is_solve => token.is_spaced,
            (_, Kind::Colon | Kind::Close) | (Kind::Open | Kind::Root, _) => false,
            (Kind::Colon, _) => true,
            (Kind::Sign, _) => true,
            // Behind an operator it belongs to the operand: `e^-t`.
            (Kind::Operator, Kind::Sign) => is_wide(before_text),
            (_, Kind::Sign) => true,
            (Kind::Operator, _) => is_wide(before_text),
            (_, Kind::Operator) => is_wide(&token.text),
            (_, Kind::Superscript) => false,
            _ => token.is_spaced,
        }
    }
}

/// `×` and `÷` have blanks around them; the other operators are narrow.
fn is_wide(operator: &str) -> bool {
    matches!(operator, "×" | "÷")
}

/// The code of a line without layout, for the rules that join lines.
fn bare(code: &[Token<'_>]) -> String {
    let mut text = String::new();
    for token in code {
        if token.is_spaced {
            text.push(' ');
        }
        text.push_str(&token.text);
    }
    text.trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::super::{align, token};
    use super::*;

    fn laid_out(text: &str) -> String {
        align::joined(lay_out(&token::lines(text)))
    }

    #[test]
    fn statements_inside_braces_are_indented_by_the_same_rules() {
        let text = "patch low{\ndomain u in [0,1]\nat u=0:\nS = S1(0,v,t)\n∂S/∂u=e^{-t} [1,0,0]\n}\npatch high {   # the rim\nat u = 1: join S1 at u=1, strength=0.5\n}\n";
        let expected = "patch low {
    domain u in [0, 1]
    at u = 0:
        S     = S1(0, v, t)
        ∂S/∂u = e^{-t} [1, 0, 0]
}
patch high {  # the rim
    at u = 1: join S1 at u = 1, strength = 0.5
}
";
        assert_eq!(laid_out(text), expected);
        assert_eq!(laid_out(expected), expected);
    }
}
