//! `bspline` blocks and their statements.

use super::ast::{Definition, Expression, Name, Range};
use super::expression::Builder;
use super::parser::{Parsed, Rule};
use super::statement::{Statement, internal, take};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::syntax::ast::DefinitionKind;

/// `bspline NAME { … }`
#[derive(Debug, Clone, PartialEq)]
pub struct NetBlock {
    /// What the user calls the surface.
    pub name: Name,
    /// Definitions (`let`), in source order.
    pub definitions: Vec<Definition>,
    /// `domain` entries.
    pub ranges: Vec<Range>,
    /// `knots` entries.
    pub knots: Vec<Knots>,
    /// `net` statements; more than one is an error of the next stage.
    pub nets: Vec<NetStatement>,
    /// Boundary layers, in source order.
    pub layers: Vec<Layer>,
}

/// `clamped in u, v` or `[…] in u`
#[derive(Debug, Clone, PartialEq)]
pub struct Knots {
    /// Which knots.
    pub choice: KnotChoice,
    /// The directions that have them.
    pub directions: Vec<Name>,
    /// Where the choice is written.
    pub span: Span,
}

/// Knots by name or one by one.
#[derive(Debug, Clone, PartialEq)]
pub enum KnotChoice {
    /// `uniform` or `clamped`.
    Named(Name),
    /// Every knot.
    Listed(Vec<Expression>),
}

/// `net n x m from …`
#[derive(Debug, Clone, PartialEq)]
pub struct NetStatement {
    /// The numbers of the last control points in u and in v, as written.
    pub last: [String; 2],
    /// Where they are written.
    pub size: Span,
    /// Where the layers come from, unless they are stated one by one.
    pub source: Option<NetSource>,
    /// The whole statement.
    pub span: Span,
}

/// Where all layers of a net come from.
#[derive(Debug, Clone, PartialEq)]
pub enum NetSource {
    /// `surface X sampled greville`
    Surface {
        /// The surface.
        surface: Name,
        /// `uniform` or `greville`.
        sampling: Name,
    },
    /// `points("net.csv")`, the text.
    Table(Expression),
    /// The control point as a function of its numbers or of its parameters.
    Formula(Expression),
}

/// `layer i = 0: [x, y, z]`
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// `i` or `j`.
    pub index: Name,
    /// Its value, a number or a name.
    pub position: Name,
    /// The control points of the layer.
    pub value: Expression,
}

impl NetBlock {
    /// A block that states nothing yet.
    pub fn new(name: Name) -> NetBlock {
        NetBlock {
            name,
            definitions: Vec::new(),
            ranges: Vec::new(),
            knots: Vec::new(),
            nets: Vec::new(),
            layers: Vec::new(),
        }
    }
}

impl Statement {
    /// Whether a `bspline` block may hold it.
    pub(super) fn is_of_nets(&self) -> bool {
        match self {
            Statement::Definitions(definitions) => {
                definitions.iter().all(|definition| definition.kind == DefinitionKind::Let)
            }
            Statement::Ranges(_) | Statement::Knots(_) | Statement::Net(_) | Statement::Layer(_) => true,
            _ => false,
        }
    }

    /// Adds a statement that [`Statement::is_of_nets`] to its block.
    pub(super) fn add_to_net(self, block: &mut NetBlock) -> Result<(), Diagnostic> {
        match self {
            Statement::Definitions(definitions) => block.definitions.extend(definitions),
            Statement::Ranges(ranges) => block.ranges.extend(ranges),
            Statement::Knots(knots) => block.knots.extend(knots),
            Statement::Net(net) => block.nets.push(net),
            Statement::Layer(layer) => block.layers.push(layer),
            other => return Err(other.outside_nets()),
        }
        Ok(())
    }

    /// The finding about a statement that has no place in a `bspline` block.
    pub(super) fn outside_nets(&self) -> Diagnostic {
        let place = self.place();
        let finding =
            Diagnostic::new(Code::UnexpectedText, "this statement has no place in a `bspline` block").at(place);
        finding.hint("a block holds `knots`, `net`, `layer`, `let` and `domain`; its equation is ∂⁶S/∂u³∂v³ = 0")
    }

    /// The finding about a statement that stands outside `bspline` blocks.
    pub(super) fn only_in_nets(&self) -> Diagnostic {
        let message = "knots, nets and their layers stand in a `bspline` block";
        Diagnostic::new(Code::UnexpectedText, message).at(self.place()).hint("open one first: `bspline NAME {`")
    }

    /// A place of the statement, for a message.
    fn place(&self) -> Option<Span> {
        match self {
            Statement::Parameters(parameters) => parameters.first().map(|parameter| parameter.name.span),
            Statement::Definitions(definitions) => definitions.first().map(|definition| definition.name.span),
            Statement::Ranges(ranges) => ranges.first().map(|range| range.variable.span),
            Statement::Equation(equation) => Some(equation.span),
            Statement::Boundary(boundary) => Some(boundary.variable.span),
            Statement::Constraints(constraints) => {
                let single = constraints.single.first().map(|constraint| constraint.span);
                let single = single.or(constraints.joins.first().map(|join| join.span));
                single.or(constraints.apexes.first().copied())
            }
            Statement::Deformation(deformation) => Some(deformation.span),
            Statement::Solve(solve) => Some(solve.method.span),
            Statement::Seam(seam) => Some(seam.span),
            Statement::Morph(morph) => morph.pairs.first().map(|[first, _]| first.span),
            Statement::Knots(knots) => knots.first().map(|knots| knots.span),
            Statement::Net(net) => Some(net.span),
            Statement::Layer(layer) => Some(layer.index.span),
            Statement::Edge(edge) => Some(edge.span),
            Statement::Centre(_, span) => Some(*span),
            Statement::Copies(copies) => Some(copies.span),
            Statement::PatchBegins(name) | Statement::NetBegins(name) | Statement::LoopBegins(name) => Some(name.span),
            Statement::BlockEnds => None,
        }
    }
}

impl Builder<'_> {
    /// `clamped in u, v`, …
    pub(super) fn all_knots<'a>(&mut self, parts: impl Iterator<Item = Parsed<'a>>) -> Result<Vec<Knots>, Diagnostic> {
        parts.filter(|part| part.as_rule() == Rule::knots).map(|part| self.knots(part)).collect()
    }

    fn knots(&mut self, part: Parsed<'_>) -> Result<Knots, Diagnostic> {
        let mut inner = part.into_inner().filter(|part| part.as_rule() != Rule::kw_in);
        let choice = inner.next().ok_or_else(internal)?;
        let span = self.span(&choice);
        let choice = match choice.as_rule() {
            Rule::knot_list => KnotChoice::Listed(self.bracket(&choice)?),
            _ => KnotChoice::Named(self.name(&choice)),
        };
        let directions = inner.filter(|part| part.as_rule() == Rule::name).map(|name| self.name(&name)).collect();
        Ok(Knots { choice, directions, span })
    }

    /// `net n x m from …`
    pub(super) fn net<'a>(
        &mut self,
        parts: impl Iterator<Item = Parsed<'a>>,
        span: Span,
    ) -> Result<NetStatement, Diagnostic> {
        let mut inner = parts.filter(|part| !matches!(part.as_rule(), Rule::kw_net | Rule::kw_from));
        let size = take(&mut inner, Rule::net_size)?;
        let place = self.span(&size);
        let mut numbers = size.into_inner().filter(|part| part.as_rule() == Rule::integer);
        let mut number = || numbers.next().map(|number| number.as_str().to_owned()).ok_or_else(internal);
        let last = [number()?, number()?];
        let source = match inner.next() {
            None => None,
            Some(part) if part.as_rule() == Rule::sampled => {
                let mut names = part.into_inner();
                let (surface, sampling) = (self.take_name(&mut names)?, self.take_name(&mut names)?);
                Some(NetSource::Surface { surface, sampling })
            }
            Some(part) if part.as_rule() == Rule::tabled => Some(NetSource::Table(self.file(&mut part.into_inner())?)),
            Some(part) => Some(NetSource::Formula(self.expression(part)?)),
        };
        Ok(NetStatement { last, size: place, source, span })
    }

    /// `layer i = 0: [x, y, z]`
    pub(super) fn layer<'a>(&mut self, parts: impl Iterator<Item = Parsed<'a>>) -> Result<Layer, Diagnostic> {
        let mut inner = parts.filter(|part| part.as_rule() != Rule::kw_layer);
        let index = self.take_name(&mut inner)?;
        let position = inner.next().ok_or_else(internal)?;
        let position = Name { text: position.as_str().trim().to_owned(), span: self.span(&position) };
        let value: Expression = self.take_expression(&mut inner)?;
        Ok(Layer { index, position, value })
    }
}
