//! Statements from which models are put together: edges, loops of them, copies of patches.

use super::ast::{Copies, Document, Edge, Expression, LoopEdge, Motion, Name, PatchBlock};
use super::expression::Builder;
use super::parser::{Parsed, Rule};
use super::statement::{Block, internal, take};
use crate::diagnostic::{Code, Diagnostic, Span};

/// `edge …`, which declares an edge outside blocks and adds one to a loop inside.
pub struct EdgeStatement {
    name: Option<Name>,
    curve: Expression,
    across: Option<Expression>,
    reversed: Option<Span>,
    continuity: Option<Name>,
    /// The whole statement.
    pub(super) span: Span,
}

impl EdgeStatement {
    /// Adds the statement to `document`: to its last loop if that is `open`.
    pub fn add_to(self, document: &mut Document, open: Option<Block>) -> Result<(), Diagnostic> {
        let EdgeStatement { name, curve, across, reversed, continuity, span } = self;
        if open.is_none() {
            let Some(name) = name else {
                return Err(unexpected("an edge outside a loop has a name", span).hint("write `edge NAME = [x, y, z]`"));
            };
            if let Some(place) = reversed {
                return Err(unexpected("only a use of an edge can be reversed", place));
            }
            document.edges.push(Edge { name, curve, across, continuity, span });
            return Ok(());
        }
        let Some(block) = open_loop(document, open) else {
            return Err(unexpected("an edge stands in a patch", span).hint(
                "declare it before the patches, and use it with `at u = 0: join NAME`; a loop of edges is `nsided NAME { … }`",
            ));
        };
        if let Some(name) = name {
            return Err(unexpected("an edge with a name stands in a loop", name.span)
                .hint("declare it before the loop, and write `edge NAME` here"));
        }
        if let Some(continuity) = continuity {
            return Err(unexpected("how smooth an edge is stands where it is declared", continuity.span));
        }
        let edge = LoopEdge { curve, across, is_reversed: reversed.is_some(), span };
        block.statements.loop_edges.push(edge);
        Ok(())
    }
}

/// Adds `centre = …` to the loop that is open.
pub fn add_centre(
    document: &mut Document,
    open: Option<Block>,
    centre: Expression,
    span: Span,
) -> Result<(), Diagnostic> {
    match open_loop(document, open) {
        Some(block) => {
            block.statements.centres.push(centre);
            Ok(())
        }
        None => {
            Err(unexpected("a centre belongs to a loop of edges", span).hint("it stands inside `nsided NAME { … }`"))
        }
    }
}

fn open_loop(document: &mut Document, open: Option<Block>) -> Option<&mut PatchBlock> {
    document.patches.last_mut().filter(|block| open == Some(Block::Patch) && block.is_loop)
}

fn unexpected(message: &str, place: Span) -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, message).at(place)
}

impl Builder<'_> {
    /// Builds an `edge` statement.
    pub(super) fn edge<'a>(
        &mut self,
        parts: impl Iterator<Item = Parsed<'a>>,
        span: Span,
    ) -> Result<EdgeStatement, Diagnostic> {
        let words = [Rule::kw_edge, Rule::kw_keeping];
        let mut inner = parts.filter(|part| !words.contains(&part.as_rule())).peekable();
        let name = inner.next_if(|part| part.as_rule() == Rule::name).map(|name| self.name(&name));
        let curve = self.expression(take(&mut inner, Rule::expression)?)?;
        let mut edge = EdgeStatement { name, curve, across: None, reversed: None, continuity: None, span };
        for part in inner {
            let place = self.span(&part);
            let is_new = match part.as_rule() {
                Rule::name => edge.continuity.replace(self.name(&part)).is_none(),
                Rule::reversed => edge.reversed.replace(place).is_none(),
                _ => {
                    let mut inner = part.into_inner().filter(|part| part.as_rule() == Rule::expression);
                    edge.across.replace(self.take_expression(&mut inner)?).is_none()
                }
            };
            if !is_new {
                let finding = Diagnostic::new(Code::DuplicateStatement, "this is said twice of the same edge");
                return Err(finding.at(place));
            }
        }
        Ok(edge)
    }

    /// Builds a `mirror` statement.
    pub(super) fn mirror<'a>(
        &mut self,
        parts: impl Iterator<Item = Parsed<'a>>,
        span: Span,
    ) -> Result<Copies, Diagnostic> {
        let (mut patches, mut motion) = (Vec::new(), None);
        for part in parts {
            match part.as_rule() {
                Rule::name => patches.push(self.name(&part)),
                Rule::plane => {
                    let mut inner = part.into_inner();
                    motion = Some(Motion::Mirrored(self.take_name(&mut inner)?, self.take_expression(&mut inner)?));
                }
                _ => {}
            }
        }
        Ok(Copies { patches, motion: motion.ok_or_else(internal)?, span })
    }

    /// Builds a `repeat` statement.
    pub(super) fn repeat<'a>(
        &mut self,
        parts: impl Iterator<Item = Parsed<'a>>,
        span: Span,
    ) -> Result<Copies, Diagnostic> {
        let (mut patches, mut count, mut motion) = (Vec::new(), 0, None);
        for part in parts {
            let rule = part.as_rule();
            match rule {
                Rule::name => patches.push(self.name(&part)),
                // A number too large to be one is above every limit.
                Rule::integer => count = part.as_str().trim().parse().unwrap_or(usize::MAX),
                Rule::rotated | Rule::moved => {
                    let mut inner =
                        part.into_inner().filter(|part| matches!(part.as_rule(), Rule::name | Rule::expression));
                    motion = Some(if rule == Rule::rotated {
                        let axis = self.take_name(&mut inner)?;
                        Motion::Rotated(count, axis, self.take_expression(&mut inner)?)
                    } else {
                        Motion::Moved(count, self.take_expression(&mut inner)?)
                    });
                }
                _ => {}
            }
        }
        Ok(Copies { patches, motion: motion.ok_or_else(internal)?, span })
    }
}
