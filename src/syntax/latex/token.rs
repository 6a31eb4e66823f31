//! The tokens of LaTeX mathematics, by hand: there is no nesting in them.

use crate::diagnostic::Span;
use crate::expr::greek_letter;

/// What a token is; its text says which one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TokenKind {
    /// `\name` or `\,`; the text is without the backslash.
    Command,
    /// A single Latin or Greek letter.
    Letter,
    /// `5` or `0.8`; digits that follow each other are one number.
    Number,
    /// `{`
    Open,
    /// `}`
    Close,
    /// `\\`, with the length that may follow it in square brackets.
    Break,
    /// A line end of the source.
    LineEnd,
    /// `$$`
    Dollars,
    /// Any other character.
    Symbol,
}

/// A token and where it stands in the source.
#[derive(Debug, Clone, Copy)]
pub struct Token<'a> {
    /// What it is.
    pub kind: TokenKind,
    /// Its text.
    pub text: &'a str,
    /// Its place.
    pub span: Span,
}

impl Token<'_> {
    /// Whether it is this command.
    pub fn is_command(&self, name: &str) -> bool {
        self.kind == TokenKind::Command && self.text == name
    }

    /// Whether it is this character.
    pub fn is_symbol(&self, symbol: &str) -> bool {
        self.kind == TokenKind::Symbol && self.text == symbol
    }

    /// Whether it is this letter.
    pub fn is_letter(&self, letter: &str) -> bool {
        self.kind == TokenKind::Letter && self.text == letter
    }
}

/// The token that begins at `at` or after the blanks and comments there; `None` at the end of the text.
pub fn next(source: &str, mut at: usize) -> Option<Token<'_>> {
    loop {
        let rest = source.get(at..)?;
        let first = rest.chars().next()?;
        if first == '%' {
            // The line end belongs to the comment, as in TeX, but it ends the row all the same.
            at += rest.find('\n').unwrap_or(rest.len());
        } else if first == '~' || (first.is_whitespace() && first != '\n') {
            at += first.len_utf8();
        } else {
            let (kind, skipped, length) = measure(rest, first);
            let text = rest.get(skipped..length)?;
            return Some(Token { kind, text, span: Span::new(at, at + length) });
        }
    }
}

/// Kind, bytes before the text, and length of the token that `rest` begins with.
fn measure(rest: &str, first: char) -> (TokenKind, usize, usize) {
    match first {
        '\\' if rest.starts_with("\\\\") => (TokenKind::Break, 0, 2 + row_gap(rest.get(2..).unwrap_or(""))),
        '\\' => {
            let name = rest.get(1..).unwrap_or("");
            let letters = name.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(name.len());
            let length = if letters > 0 { letters } else { name.chars().next().map_or(0, char::len_utf8) };
            (TokenKind::Command, 1, 1 + length)
        }
        '\n' => (TokenKind::LineEnd, 0, 1),
        '{' => (TokenKind::Open, 0, 1),
        '}' => (TokenKind::Close, 0, 1),
        '$' if rest.starts_with("$$") => (TokenKind::Dollars, 0, 2),
        _ if is_letter(first) => (TokenKind::Letter, 0, first.len_utf8()),
        _ => match number(rest) {
            0 => (TokenKind::Symbol, 0, first.len_utf8()),
            length => (TokenKind::Number, 0, length),
        },
    }
}

/// The length of `[2pt]` after `\\`.
fn row_gap(rest: &str) -> usize {
    let Some(inside) = rest.strip_prefix('[') else { return 0 };
    let digits = inside.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | '-'));
    let unit = ["pt", "ex", "em", "mm", "cm"].iter().find_map(|unit| digits.strip_prefix(unit));
    match unit.and_then(|rest| rest.strip_prefix(']')) {
        Some(after) => rest.len() - after.len(),
        None => 0,
    }
}

fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic() || greek_letter(c).is_some() || ('À'..='ɏ').contains(&c)
}

/// The length of digits with a fraction: a point that no digit follows ends a sentence.
fn number(rest: &str) -> usize {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let whole = digits(rest);
    let fraction = rest.get(whole..).and_then(|rest| rest.strip_prefix('.')).map_or(0, digits);
    if fraction > 0 { whole + 1 + fraction } else { whole }
}
