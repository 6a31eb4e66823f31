//! Which of the bars in `|x|` opens and which closes.
//!
//! A bar opens where no operand stands before it, and closes where none stands after it. Between two operands,
//! as in `|a|b|c|`, both are possible: it closes if it is the last one inside its bracket, and is refused otherwise.

use crate::diagnostic::{Code, Diagnostic, Span};

/// The byte that stands for a bar that opens; no text contains it, since preflight refuses it.
pub const BAR_OPENS: &str = "\u{02}";
/// The byte that stands for a bar that closes.
pub const BAR_CLOSES: &str = "\u{03}";

/// Whether the bar at `at` of `text` opens; `is_open` says whether one is open inside the innermost bracket, and
/// in `marked` the bars before it have become what they are.
pub fn opens(text: &str, at: usize, is_open: bool, marked: &[u8]) -> Result<bool, Diagnostic> {
    let before = text.get(..at).unwrap_or("").trim_end_matches([' ', '\t']);
    let follows_closed =
        before.len().checked_sub(1).and_then(|last| marked.get(last..=last)) == Some(BAR_CLOSES.as_bytes());
    if !is_open || !(before.ends_with(ends_operand) || follows_closed) {
        return Ok(true);
    }
    let after = text.get(at + 1..).unwrap_or("");
    if !after.trim_start_matches([' ', '\t']).starts_with(starts_operand) || !has_bar(after) {
        return Ok(false);
    }
    Err(Diagnostic::new(Code::AmbiguousExpression, "this bar can open or close an absolute value")
        .at(Span::new(at, at + 1))
        .hint("write `abs(…)`, or put `*` between the factors"))
}

fn ends_operand(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, ')' | ']' | '}' | '\'' | '′' | '.')
}

fn starts_operand(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '(' | '[' | '.' | '√' | '∂')
}

/// Whether another bar stands in the rest of the line, inside the same bracket.
fn has_bar(rest: &str) -> bool {
    let mut depth = 0_usize;
    for c in rest.chars() {
        match c {
            '|' if depth == 0 => return true,
            '\n' | '#' => return false,
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' if depth == 0 => return false,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
    }
    false
}
