//! Texts in quotes: names of data files, which the grammar sees as fillers.

use crate::diagnostic::{Code, Diagnostic, Span, is_deceptive};

/// What stands for each byte of a text and its quotes; no text contains it, since preflight refuses it elsewhere.
pub const FILLER: &str = "\u{04}";

/// The length of the text in quotes that `rest` begins with, or of the rest of the line; and whether it is closed.
pub fn extent(rest: &str) -> (usize, bool) {
    let line = rest.split('\n').next().unwrap_or("");
    match line.get(1..).and_then(|tail| tail.find('"')) {
        Some(end) => (end + 2, true),
        None => (line.len(), false),
    }
}

/// What stands between the quote that `rest` begins with, at `at`, and the next on the line.
pub fn read(rest: &str, at: usize) -> Result<&str, Diagnostic> {
    let line = rest.split('\n').next().unwrap_or("");
    let Some((inside, _)) = line.get(1..).and_then(|tail| tail.split_once('"')) else {
        return Err(Diagnostic::new(Code::UnbalancedBracket, "the text in quotes does not end on its line")
            .at(Span::new(at, at + 1))
            .hint("a data file is named in quotes: `points(\"ring.csv\")`"));
    };
    match inside.char_indices().find(|(_, letter)| is_deceptive(*letter) || *letter == '\t') {
        None => Ok(inside),
        Some((place, letter)) => {
            let message = format!("the name of a file holds the invisible character U+{:04X}", u32::from(letter));
            let start = at + 1 + place;
            Err(Diagnostic::new(Code::DeceptiveCharacter, message)
                .at(Span::new(start, start + letter.len_utf8()))
                .hint("remove it"))
        }
    }
}
