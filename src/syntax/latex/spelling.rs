//! The plain spelling of a text as it grows, with the place of every piece of it.

use crate::diagnostic::Span;
use crate::syntax::places::Places;

/// Whether a piece would run together with a word beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Piece {
    /// A name, a number or a function.
    Word,
    /// An operator, a bracket or a blank.
    Mark,
}

/// A text in the plain notation that is being written.
pub struct Spelling {
    text: String,
    places: Places,
    last: Piece,
    /// Where the next piece begins in the source, if before its own place.
    pending: Option<usize>,
}

impl Spelling {
    /// Nothing yet.
    pub fn new() -> Spelling {
        Spelling { text: String::new(), places: Places::default(), last: Piece::Mark, pending: None }
    }

    /// Copies `text`, which stands at `at` in the source.
    pub fn copy(&mut self, text: &str, at: usize) {
        if !text.is_empty() {
            self.places.add(self.text.len(), Span::new(at, at + text.len()), true);
            self.text.push_str(text);
            self.last = Piece::Mark;
        }
    }

    /// Writes `text` for what stands at `source`; words are kept apart.
    pub fn put(&mut self, text: &str, source: Span, piece: Piece) {
        let start = self.pending.take().unwrap_or(source.start);
        if self.last == Piece::Word && piece == Piece::Word {
            self.text.push(' ');
        }
        self.places.add(self.text.len(), Span::new(start, source.end), false);
        self.text.push_str(text);
        self.last = piece;
    }

    /// Lets the next piece begin at `start` of the source.
    pub fn begin(&mut self, start: usize) {
        self.pending = Some(start);
    }

    /// Lets the last piece reach to `end` of the source.
    pub fn extend(&mut self, end: usize) {
        self.places.extend(end);
    }

    /// The text and its places.
    pub fn finish(self) -> (String, Places) {
        (self.text, self.places)
    }
}
