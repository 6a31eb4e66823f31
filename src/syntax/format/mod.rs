//! A spec in its canonical layout: spacing, indentation, aligned `=`; comments and LaTeX are kept.
//!
//! Input: a source that parses; output: a text that states the same. It works on tokens with their own text, so
//! nothing can be lost, and a statement it does not know is laid out by the same rules. Invariant: the result parses
//! to an equal document, places aside; this is checked every time, and otherwise there is no result.

mod align;
mod layout;
mod spell;
mod token;

use super::parse;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Source};
use crate::limits::Limits;

/// How names and operators are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Alphabet {
    /// As in the source.
    #[default]
    Kept,
    /// `beta`, `d4S/du4`, `v^2`; roots `√` and fractions `½` stay.
    Ascii,
    /// `β`, `∂⁴S/∂u⁴`, `v²`
    Unicode,
}

/// The text of `source` in its canonical layout.
///
/// # Errors
/// What [`parse`] finds wrong with it; [`Code::NotFormatted`] if the result would not state the same.
pub fn format(source: &Source, alphabet: Alphabet, limits: &Limits) -> Result<String, Diagnostics> {
    let before = parse(source, limits)?;
    let mut lines = token::lines(&source.text);
    spell::respell(&mut lines, alphabet);
    let text = align::joined(layout::lay_out(&lines));
    // The spelled text may be larger than what was allowed to be read.
    let roomy = Limits { source_bytes: limits.source_bytes.saturating_mul(4), ..limits.clone() };
    let after = parse(&Source::new(source.name.clone(), text.clone()), &roomy);
    if after.is_ok_and(|after| meaning(&after) == meaning(&before)) {
        return Ok(text);
    }
    let message = "the text cannot be laid out without changing what it states, so it is left as it is";
    let finding = Diagnostic::new(Code::NotFormatted, message);
    Err(vec![finding.hint("put brackets or blanks where things stand side by side; please report this text")])
}

/// A document without its places: the text of its tree, so that whatever a document holds is compared.
fn meaning(document: &super::Document) -> String {
    let text = format!("{document:?}");
    let mut pieces = text.split("Span { start: ");
    let first = pieces.next().unwrap_or("").to_owned();
    pieces.fold(first, |meaning, piece| meaning + piece.split_once('}').map_or(piece, |(_, rest)| rest))
}
