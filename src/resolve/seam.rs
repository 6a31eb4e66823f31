//! `seam` statements: which sides of patches, or which parts of them, are meant to meet.

use super::lower::Lowering;
use super::reading::{Fault, Reading};
use super::scope::Scope;
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{ExprId, Variable};
use crate::problem::{Bindings, Net, Patch, PatchCopy, Seam, SeamEdge, SidePart};
use crate::syntax::ast::{self, Document, Name, Range};

/// The parts of a document that can meet: patches, nets and copies of both.
#[derive(Clone, Copy)]
pub struct Parts<'a> {
    /// Patches, loops already divided.
    pub patches: &'a [Patch],
    /// B-spline nets.
    pub nets: &'a [Net],
    /// Copies.
    pub copies: &'a [PatchCopy],
}

impl Parts<'_> {
    /// What part number `index` is, or is a copy of.
    fn original(&self, index: usize) -> usize {
        let copy = index.checked_sub(self.patches.len() + self.nets.len()).and_then(|index| self.copies.get(index));
        copy.map_or(index, |copy| copy.original)
    }

    fn names(&self) -> Vec<&str> {
        let own = self.patches.iter().map(|patch| patch.name.as_str());
        let own = own.chain(self.nets.iter().map(|net| net.name.as_str()));
        own.chain(self.copies.iter().map(|copy| copy.name.as_str())).collect()
    }
}

/// What a seam joins: an end of a part in one coordinate, between two values of the other.
#[derive(Clone, Copy, PartialEq)]
struct Side {
    part: usize,
    across: Variable,
    is_high: bool,
    along: [f64; 2],
}

/// The seams that are stated between `parts`.
pub fn seams(
    document: &Document,
    parts: Parts<'_>,
    scope: &Scope<'_>,
    bindings: &Bindings,
    reading: &mut Reading<'_>,
) -> Vec<Seam> {
    let mut seams = Vec::with_capacity(document.seams.len());
    let mut stated: Vec<([Side; 2], Span)> = Vec::with_capacity(document.seams.len());
    for seam in &document.seams {
        let edges = seam.edges.each_ref().map(|edge| {
            let edge = seam_edge(edge, parts, bindings, &mut reading.lowering(scope));
            reading.keep(edge)
        });
        let [Some((first, first_side)), Some((second, second_side))] = edges else { continue };
        if first_side == second_side {
            let finding = Diagnostic::new(Code::SeamWithoutEdge, "the seam joins an edge with itself").at(seam.span);
            reading.report(finding.hint("name the edges of two patches, or both ends of one that closes"));
            continue;
        }
        let is_same = |(other, _): &&([Side; 2], Span)| other.contains(&first_side) && other.contains(&second_side);
        if let Some((_, before)) = stated.iter().find(is_same) {
            let finding = Diagnostic::new(Code::DuplicateStatement, "the seam is stated twice").at(seam.span);
            reading.report(finding.label(*before, "first stated here"));
            continue;
        }
        stated.push(([first_side, second_side], seam.span));
        seams.push(Seam { edges: [first, second], is_smooth: false, origin: Some(seam.span) });
    }
    seams
}

fn seam_edge(
    edge: &ast::SeamEdge,
    parts: Parts<'_>,
    bindings: &Bindings,
    lowering: &mut Lowering<'_>,
) -> Result<(SeamEdge, Side), Fault> {
    let name = &edge.patch;
    let known = parts.names();
    let Some(index) = known.iter().position(|known| *known == name.text) else {
        let finding = Diagnostic::new(Code::UnknownName, format!("there is no patch `{}`", name.text)).at(name.span);
        return Err(finding.hint(format!("patches: {}", known.join(", "))).into());
    };
    let Parts { patches, nets, .. } = parts;
    let original = parts.original(index);
    let across = match edge.variable.text.as_str() {
        "u" => Variable::U,
        // A net, behind the patches, has four sides.
        "v" if patches.get(original).is_none_or(Patch::is_four_sided) => Variable::V,
        other => {
            let message = match other {
                "v" => format!("the patch `{}` has no data at fixed v: it meets others at values of u", name.text),
                _ => format!("patches meet at values of u, or of v if they have four sides, not of `{other}`"),
            };
            return Err(Diagnostic::new(Code::UnexpectedText, message).at(edge.variable.span).into());
        }
    };
    let position = lowering.constant(edge.position, "the position of a seam")?;
    let place = lowering.tree.span(edge.position);
    let domain = match (patches.get(original), nets.get(original.saturating_sub(patches.len()))) {
        (Some(patch), _) => patch.domain.evaluate_in(lowering.graph, bindings)?,
        (None, Some(net)) => net.domain_in(lowering.graph, bindings)?,
        (None, None) => return Err(Fault::Follows),
    };
    let [of_u, of_v] = [domain.u, domain.v];
    let (range, other) = if across == Variable::U { (of_u, of_v) } else { (of_v, of_u) };
    let at = bindings.constant_in(lowering.graph, position, Some(place), "the position of a seam")?;
    let is_high = end_of(across, at, range, name, place)?;
    let (part, along) = match &edge.along {
        None => (SidePart::Shares([0.0, 1.0]), other),
        Some(along) => {
            let (ends, values) = part(along, (name, across, other), bindings, lowering)?;
            (SidePart::Values(ends), values)
        }
    };
    let side = Side { part: index, across, is_high, along };
    Ok((SeamEdge { patch: index, across, position, part }, side))
}

/// Whether `position` is the higher end of `range`; a value that is neither end is no place of an edge.
fn end_of(
    across: Variable,
    position: f64,
    [low, high]: [f64; 2],
    patch: &Name,
    place: Span,
) -> Result<bool, Diagnostic> {
    // Ends that are computed may differ from it in their last bits.
    let is_at = |end: f64| (position - end).abs() <= 8.0 * f64::EPSILON * low.abs().max(high.abs());
    if is_at(low) || is_at(high) {
        return Ok(is_at(high));
    }
    let [position, low, high] = [position, low, high].map(Shortest);
    let (across, name) = (across.name(), &patch.text);
    Err(Diagnostic::new(Code::SeamWithoutEdge, format!("`{name}` has no edge at {across} = {position}"))
        .at(place)
        .hint(format!("its edges are {across} = {low} and {across} = {high}")))
}

/// The ends of a part of the side of `patch` at fixed `across`, on which the other coordinate has the range `of_side`, and
/// their values.
fn part(
    along: &Range,
    (patch, across, of_side): (&Name, Variable, [f64; 2]),
    bindings: &Bindings,
    lowering: &mut Lowering<'_>,
) -> Result<([ExprId; 2], [f64; 2]), Fault> {
    let variable = if across == Variable::U { Variable::V } else { Variable::U };
    if along.variable.text != variable.name() {
        let message = format!(
            "a part of a side of constant {} is a range of {}, not of `{}`",
            across.name(),
            variable.name(),
            along.variable.text
        );
        return Err(Diagnostic::new(Code::UnexpectedText, message).at(along.variable.span).into());
    }
    let mut ends = Vec::with_capacity(2);
    let places = along.interval.map(|end| lowering.tree.span(end));
    let mut values = [0.0; 2];
    for ((end, place), value) in along.interval.into_iter().zip(places).zip(&mut values) {
        let expr = lowering.constant(end, "a part of a seam")?;
        *value = bindings.constant_in(lowering.graph, expr, Some(place), "a part of a seam")?;
        check_inside(variable, *value, of_side, patch, place)?;
        ends.push(expr);
    }
    let [low, high] = values;
    if low >= high {
        let (name, [first, last]) = (variable.name(), values.map(Shortest));
        let finding = Diagnostic::new(Code::EmptyDomain, format!("the part {name} in [{first}, {last}] is empty"));
        let finding = if low > high {
            finding.hint(format!(
                "write the smaller end first: `{name} in [{last}, {first}]`; patches may run against each other"
            ))
        } else {
            finding.hint("the lower end must be below the upper end")
        };
        return Err(finding.at(places[0].to(places[1])).into());
    }
    Ok((<[ExprId; 2]>::try_from(ends).map_err(|_| Fault::Follows)?, values))
}

/// Refuses a value of a coordinate outside its range in a patch.
fn check_inside(
    variable: Variable,
    value: f64,
    [low, high]: [f64; 2],
    patch: &Name,
    place: Span,
) -> Result<(), Diagnostic> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    let [value, low, high] = [value, low, high].map(Shortest);
    let message =
        format!("{0} = {value} lies outside the domain {0} in [{low}, {high}] of `{1}`", variable.name(), patch.text);
    Err(Diagnostic::new(Code::DependentConstraints, message).at(place))
}
