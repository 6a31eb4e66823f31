//! Text to [`Document`]: the only place that knows the grammar (`grammar/trimline.pest`) and the only user of pest.
//!
//! Each logical line is parsed on its own, so one file can report several errors. Nothing is resolved here: a
//! name is a name, and `h0(1 - t)` stays an application until [`resolve`](crate::resolve) knows what `h0` is.

mod ambiguity;
mod assembly;
pub mod ast;
mod bars;
mod brackets;
mod call;
mod expression;
mod files;
mod format;
mod latex;
mod net;
mod parser;
mod partial;
mod places;
mod preflight;
mod quotes;
mod statement;
mod unknown;

pub use ast::Document;
pub use format::{Alphabet, format};
pub use preflight::decode;

pub use ast::DataFile;
use ast::{Expression, Name, NetBlock, PatchBlock, Statements, Tree};
use brackets::Brackets;
use expression::Builder;
use preflight::Prepared;
use statement::Block;

use crate::diagnostic::{Code, Diagnostic, Diagnostics, MOST_FINDINGS, Source, Span};
use crate::limits::Limits;

/// Words that are no names.
const RESERVED_WORDS: &[&str] = &[
    "param", "let", "domain", "pde", "with", "at", "solve", "in", "surface", "seam", "patch", "join", "deform",
    "keeping", "curve", "morph", "bspline", "knots", "net", "layer", "nsided", "edge", "mirror", "repeat",
];

/// Parses a spec.
///
/// # Errors
/// Everything found wrong with the text, in source order; a limit ends the search.
pub fn parse(source: &Source, limits: &Limits) -> Result<Document, Diagnostics> {
    let prepared = preflight::prepare(source, limits)?;
    if prepared.lines.is_empty() {
        return Err(vec![
            Diagnostic::new(Code::EmptyDocument, "the document states nothing")
                .at(Span::new(0, 0))
                .hint("state the constraints, for example `at u = 0: S = [cos v, sin v, 0], ∂S/∂u = [0, 0, 1]`"),
        ]);
    }
    let mut document = Document::default();
    let mut found = Diagnostics::new();
    let mut open = None;
    for &line in &prepared.lines {
        if let Err(finding) = add_line(&mut document, &prepared, line, &mut open, !found.is_empty()) {
            found.push(finding);
            // A block whose first line is faulty is still a block.
            open = open_block(&mut document, &prepared, line).or(open);
            if found.len() >= MOST_FINDINGS {
                break;
            }
        }
    }
    if found.is_empty() { Ok(document) } else { Err(found) }
}

fn add_line(
    document: &mut Document,
    prepared: &Prepared,
    line: Span,
    open: &mut Option<Block>,
    is_faulty: bool,
) -> Result<(), Diagnostic> {
    let mut brackets = Brackets::read(prepared, line, &mut document.tree)?;
    let text = brackets::outermost(prepared, line);
    let pair = parser::line(&text, line.start).map_err(|finding| prepared.places.moved(finding))?;
    let mut builder = Builder::new(prepared, line.start, &mut document.tree, &mut brackets);
    builder.statement(pair)?.add_to(document, open, is_faulty)
}

/// Opens a block without a name if `line` is the first of one.
fn open_block(document: &mut Document, prepared: &Prepared, line: Span) -> Option<Block> {
    if !prepared.blocks.contains(&line.end.saturating_sub(1)) {
        return None;
    }
    let name = Name { text: String::new(), span: line };
    if prepared.text.get(line.start..line.end).is_some_and(|text| text.starts_with("bspline")) {
        document.nets.push(NetBlock::new(name));
        return Some(Block::Net);
    }
    let is_loop = prepared.text.get(line.start..line.end).is_some_and(|text| text.starts_with("nsided"));
    document.patches.push(PatchBlock { name, is_loop, statements: Statements::default() });
    Some(Block::Patch)
}

/// Parses a single expression, for example the value of a command-line option.
///
/// # Errors
/// As [`parse`].
pub fn parse_expression(source: &Source, limits: &Limits) -> Result<(Tree, Expression), Diagnostics> {
    let prepared = preflight::prepare(source, limits)?;
    let mut tree = Tree::default();
    let whole = Span::new(0, prepared.text.len());
    let expression = values(&prepared, whole, &mut tree).map_err(|finding| vec![finding])?;
    match expression.as_slice() {
        [only] => Ok((tree, *only)),
        _ => Err(vec![Diagnostic::new(Code::UnexpectedText, "expected one expression").at(whole)]),
    }
}

fn values(prepared: &Prepared, span: Span, tree: &mut Tree) -> Result<Vec<Expression>, Diagnostic> {
    let mut brackets = Brackets::read(prepared, span, tree)?;
    let text = brackets::outermost(prepared, span);
    let pair = parser::values(&text, span.start).map_err(|finding| prepared.places.moved(finding))?;
    Builder::new(prepared, span.start, tree, &mut brackets).values(pair)
}
