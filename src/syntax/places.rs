//! Where the bytes of a prepared text stand in the source.
//!
//! A text without LaTeX is prepared byte for byte, and every place is its own. LaTeX is spelled out in the plain
//! notation, which moves things: each piece of the plain spelling then remembers what it stands for.

use crate::diagnostic::{Diagnostic, Span};

/// From places in a prepared text to places in the source.
#[derive(Debug, Default)]
pub struct Places {
    /// In order, the first at 0; none where both texts are the same.
    pieces: Vec<Piece>,
}

#[derive(Debug)]
struct Piece {
    /// Where it begins in the prepared text; it ends where the next begins.
    start: usize,
    /// What it stands for.
    source: Span,
    /// Whether it was copied byte for byte.
    is_copied: bool,
}

impl Places {
    /// Says that what begins at `start` stands for `source`.
    pub fn add(&mut self, start: usize, source: Span, is_copied: bool) {
        self.pieces.push(Piece { start, source, is_copied });
    }

    /// Lets the last piece reach to `end` of the source.
    pub fn extend(&mut self, end: usize) {
        if let Some(last) = self.pieces.last_mut() {
            last.source.end = end;
        }
    }

    /// The place in the source of a place in the prepared text.
    pub fn in_source(&self, span: Span) -> Span {
        let Some(first) = self.piece(span.start) else { return span };
        let start = first.source.start + if first.is_copied { span.start - first.start } else { 0 };
        let start = start.min(first.source.end);
        let Some(last) = span.end.checked_sub(1).filter(|last| *last >= span.start).and_then(|last| self.piece(last))
        else {
            return Span::new(start, start);
        };
        let end = if last.is_copied { last.source.start + (span.end - last.start) } else { last.source.end };
        Span::new(start, end.min(last.source.end).max(start))
    }

    /// The finding, with its places moved from the prepared text to the source.
    pub fn moved(&self, mut finding: Diagnostic) -> Diagnostic {
        finding.span = finding.span.map(|span| self.in_source(span));
        for label in &mut finding.labels {
            label.span = self.in_source(label.span);
        }
        finding
    }

    fn piece(&self, at: usize) -> Option<&Piece> {
        let next = self.pieces.partition_point(|piece| piece.start <= at);
        next.checked_sub(1).and_then(|index| self.pieces.get(index))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn place_in_a_spelling_is_the_place_of_what_it_stands_for() {
        // `a $$\pi v$$` as `a π v`.
        let mut places = Places::default();
        places.add(0, Span::new(0, 2), true);
        places.add(2, Span::new(4, 7), false);
        places.add(5, Span::new(8, 9), false);
        assert_eq!(places.in_source(Span::new(0, 1)), Span::new(0, 1));
        assert_eq!(places.in_source(Span::new(2, 4)), Span::new(4, 7));
        assert_eq!(places.in_source(Span::new(2, 6)), Span::new(4, 9));
        assert_eq!(places.in_source(Span::new(5, 5)), Span::new(8, 8));
    }

    #[test]
    fn place_in_a_text_without_pieces_is_its_own() {
        assert_eq!(Places::default().in_source(Span::new(3, 7)), Span::new(3, 7));
    }
}
