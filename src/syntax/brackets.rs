//! Reads what stands inside brackets, innermost first, so that no nesting reaches the parser's stack.
//!
//! Every bracket's inside is parsed on its own, with the insides of the brackets within it replaced by filler;
//! its values wait here until the expression around it takes them. Invariant: filler is as long as what it
//! replaces, so offsets never change. Cost: the length of the text times its nesting, which is bounded.

use rustc_hash::FxHashMap;

use super::ast::{Expression, Tree};
use super::bars::{BAR_CLOSES, BAR_OPENS};
use super::expression::Builder;
use super::parser;
use super::preflight::Prepared;
use crate::diagnostic::{Diagnostic, Span};

/// The byte that stands for the inside of a bracket; no text contains it, since preflight refuses it.
const FILLER: u8 = 1;

/// Values of brackets that nothing has taken yet, by the offset at which their inside begins.
#[derive(Default)]
pub struct Brackets {
    waiting: FxHashMap<usize, Vec<Expression>>,
}

impl Brackets {
    /// Reads every bracket inside `line`.
    pub fn read(prepared: &Prepared, line: Span, tree: &mut Tree) -> Result<Brackets, Diagnostic> {
        let mut brackets = Brackets::default();
        let all = &prepared.brackets;
        let first = all.partition_point(|(_, close)| *close < line.start);
        for &(open, close) in all.iter().skip(first).take_while(|(_, close)| *close < line.end) {
            let inside = Span::new(open + 1, close);
            let text = outermost(prepared, inside);
            let values = if text.trim().is_empty() {
                Vec::new()
            } else {
                let pair = parser::values(&text, inside.start).map_err(|finding| prepared.places.moved(finding))?;
                Builder::new(prepared, inside.start, tree, &mut brackets).values(pair)?
            };
            brackets.waiting.insert(inside.start, values);
        }
        Ok(brackets)
    }

    /// The values of the bracket whose inside begins at `start`.
    pub fn take(&mut self, start: usize) -> Option<Vec<Expression>> {
        self.waiting.remove(&start)
    }
}

/// The text of `span` with the insides of its brackets replaced by filler.
pub fn outermost(prepared: &Prepared, span: Span) -> String {
    let mut depth = 0_usize;
    let bytes = prepared.text.bytes().skip(span.start).take(span.end - span.start).map(|byte| {
        let closes = matches!(byte, b')' | b']') || BAR_CLOSES.as_bytes() == [byte];
        depth = depth.saturating_sub(usize::from(closes));
        let shown = if depth == 0 { byte } else { FILLER };
        depth += usize::from(matches!(byte, b'(' | b'[') || BAR_OPENS.as_bytes() == [byte]);
        shown
    });
    // Whole characters were replaced byte by byte with ASCII, so the text is still UTF-8.
    String::from_utf8(bytes.collect()).unwrap_or_default()
}
