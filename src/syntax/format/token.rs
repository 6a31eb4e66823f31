//! A text as tokens that together are the whole text but for its blanks.

use std::borrow::Cow;

use crate::expr::greek_letter;
use crate::syntax::latex;

/// What a token is, as far as layout is concerned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A name, a function, a statement word, `∂⁴S`.
    Word,
    /// A number.
    Number,
    /// `²` behind a bracket.
    Superscript,
    /// `+` and `-`
    Sign,
    /// An operator that binds tighter than a sign.
    Operator,
    /// `=` or `∈`
    Relation,
    /// `,` or `;`
    Comma,
    /// `:`
    Colon,
    /// `(`, `[` or `{`
    Open,
    /// `)`, `]` or `}`
    Close,
    /// `√`
    Root,
    /// `# …`
    Comment,
    /// A block of LaTeX.
    Latex,
    /// Anything else.
    Other,
}

/// A token.
#[derive(Debug, Clone)]
pub struct Token<'a> {
    /// What it is.
    pub kind: Kind,
    /// Its text.
    pub text: Cow<'a, str>,
    /// Whether a blank stands before it.
    pub is_spaced: bool,
}

impl Token<'_> {
    /// Whether it has this text.
    pub fn is(&self, text: &str) -> bool {
        self.text == text
    }
}

/// One line of the source.
#[derive(Debug, Default)]
pub struct Line<'a> {
    /// The blanks before the first token.
    pub indent: &'a str,
    /// Its tokens; none for an empty line.
    pub tokens: Vec<Token<'a>>,
}

impl<'a> Line<'a> {
    /// The tokens without a comment at the end.
    pub fn code(&self) -> &[Token<'a>] {
        match self.tokens.split_last() {
            Some((last, code)) if last.kind == Kind::Comment => code,
            _ => &self.tokens,
        }
    }

    /// The comment at the end.
    pub fn comment(&self) -> Option<&str> {
        self.tokens.last().filter(|last| last.kind == Kind::Comment).map(|last| &*last.text)
    }
}

/// The lines of a text; a block of LaTeX is one token of the line on which it begins.
pub fn lines(text: &str) -> Vec<Line<'_>> {
    let mut blocks = latex::blocks(text).into_iter().peekable();
    let mut lines = vec![Line::default()];
    let (mut at, mut line_start) = (0, 0);
    while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
        let (kind, length) = match blocks.next_if(|block| block.start == at) {
            Some(block) => (Some(Kind::Latex), block.end - block.start),
            None => measure(rest),
        };
        let length = length.max(1);
        let token = rest.get(..length).unwrap_or(rest);
        match kind {
            Some(kind) => {
                if let Some(line) = lines.last_mut() {
                    let before = text.get(line_start..at).unwrap_or("");
                    if line.tokens.is_empty() {
                        line.indent = before;
                    }
                    let is_spaced = before.ends_with(char::is_whitespace);
                    line.tokens.push(Token { kind, text: Cow::Borrowed(token.trim_end()), is_spaced });
                }
            }
            None if token == "\n" => {
                lines.push(Line::default());
                line_start = at + 1;
            }
            None => {}
        }
        at += length;
    }
    lines
}

/// Kind and length of the token that `rest` begins with; no kind for blanks and line ends.
fn measure(rest: &str) -> (Option<Kind>, usize) {
    let Some(first) = rest.chars().next() else { return (None, 0) };
    let one = first.len_utf8();
    let kind = match first {
        '\n' => return (None, 1),
        // At the start of a file, a habit of editors.
        '\u{feff}' => return (None, one),
        _ if first.is_whitespace() => return (None, one),
        '"' => return (Some(Kind::Other), quoted(rest)),
        '#' => return (Some(Kind::Comment), rest.find('\n').unwrap_or(rest.len())),
        '*' if rest.starts_with("**") => return (Some(Kind::Operator), 2),
        'π' | 'ϖ' => return (Some(Kind::Word), one + superscripts(rest.get(one..).unwrap_or(""))),
        '∂' => return (Some(Kind::Word), word(rest, |c| c == '∂' || is_superscript(c))),
        _ if is_letter(first) => {
            let name = word(rest, |_| false);
            return (Some(Kind::Word), name + superscripts(rest.get(name..).unwrap_or("")));
        }
        '0'..='9' | '.' => return (Some(Kind::Number), number(rest)),
        '½' | '¼' | '¾' => Kind::Number,
        _ if is_superscript(first) => return (Some(Kind::Superscript), superscripts(rest)),
        '+' | '-' | '−' | '–' => Kind::Sign,
        '*' | '/' | '^' | '·' | '⋅' | '∙' | '∗' | '×' | '÷' | '∕' => Kind::Operator,
        '=' | '∈' => Kind::Relation,
        ',' | ';' => Kind::Comma,
        ':' => Kind::Colon,
        '(' | '[' | '{' => Kind::Open,
        ')' | ']' | '}' => Kind::Close,
        '√' => Kind::Root,
        _ => Kind::Other,
    };
    (Some(kind), one)
}

/// The length of a text in quotes, which end on its line.
fn quoted(rest: &str) -> usize {
    let line = rest.split('\n').next().unwrap_or(rest);
    line.get(1..).and_then(|tail| tail.find('"')).map_or(1, |end| end + 2)
}

/// The length of a name, or of a derivative with `also`.
fn word(rest: &str, also: impl Fn(char) -> bool) -> usize {
    let mut letters = rest.char_indices().peekable();
    while let Some((at, letter)) = letters.next() {
        if letter == '_' && rest.get(at..).is_some_and(|tail| tail.starts_with("_{")) {
            let Some(close) = rest.get(at..).and_then(|tail| tail.find('}')) else { return at };
            while letters.next_if(|(next, _)| *next <= at + close).is_some() {}
        } else if !is_name_part(letter) && !also(letter) {
            return at;
        }
    }
    rest.len()
}

fn superscripts(rest: &str) -> usize {
    rest.find(|c: char| !is_superscript(c)).unwrap_or(rest.len())
}

fn is_superscript(c: char) -> bool {
    matches!(c, '⁻' | '⁰' | '¹' | '²' | '³' | '⁴'..='⁹')
}

fn is_letter(c: char) -> bool {
    (c.is_ascii_alphabetic() || greek_letter(c).is_some() || ('À'..='ɏ').contains(&c))
        && !matches!(c, '×' | '÷' | 'π' | 'ϖ')
}

fn is_name_part(c: char) -> bool {
    is_letter(c) || c.is_ascii_digit() || matches!(c, '_' | '\'' | '′' | '₀'..='₉')
}

/// The length of `2`, `0.8`, `.5` or `1e-3`.
fn number(rest: &str) -> usize {
    let digits = |from: usize| {
        let tail = rest.get(from..).unwrap_or("");
        from + tail.find(|c: char| !c.is_ascii_digit()).unwrap_or(tail.len())
    };
    let mut end = digits(0);
    if rest.get(end..).is_some_and(|tail| tail.starts_with('.')) {
        end = digits(end + 1);
    }
    if rest.get(end..).is_some_and(|tail| tail.starts_with(['e', 'E'])) {
        let sign = usize::from(rest.get(end + 1..).is_some_and(|tail| tail.starts_with(['+', '-'])));
        let exponent = digits(end + 1 + sign);
        end = if exponent > end + 1 + sign { exponent } else { end };
    }
    end
}
