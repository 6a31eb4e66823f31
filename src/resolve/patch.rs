//! Patch blocks, and what they share, to patches.

use super::boundary;
use super::declarations;
use super::deformation;
use super::equation;
use super::lower::Lowering;
use super::reading::{Fault, Reading};
use super::scope::Scope;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{ExprId, Variable};
use crate::problem::{Bindings, Domain, Net, Parameter, Patch, PdeOperator, RequestedSetting, Seam, SolveRequest};
use crate::syntax::ast::{Document, Name, PatchBlock, PdeStatement, Range, SeamEdge, SolveStatement, Statements};

/// A patch whose boundary is still to be read.
pub struct Section<'a> {
    name: String,
    /// Where its name is written.
    place: Option<Span>,
    statements: &'a Statements,
    scope: Scope<'a>,
    domain: Domain,
    /// `None` if it is at fault.
    operator: Option<PdeOperator>,
    solve: SolveRequest,
}

/// Everything about each patch but its boundary, and what is stated as the domain of all; coefficients of equations are
/// added to `parameters`.
pub fn sections<'a>(
    document: &'a Document,
    name: &str,
    scope: &'a Scope<'a>,
    parameters: &mut Vec<Parameter>,
    reading: &mut Reading<'_>,
) -> (Vec<Section<'a>>, Domain) {
    let shared = &document.shared;
    check_blocks(document, reading);
    let standard = Domain::standard(&mut reading.graph);
    let domain = domain(&shared.ranges, standard, scope, reading);
    let solve = solve_request(&shared.solves, reading);
    let stated = only_equation(&shared.equations, reading);
    let is_implicit = document.patches.is_empty() && document.nets.is_empty();
    let needs_shared = is_implicit || document.patches.iter().any(states_no_equation);
    let operator = if needs_shared { equation::resolve(stated, None, scope, parameters, reading) } else { None };
    if is_implicit {
        let (name, of_all) = (name.to_owned(), domain.clone());
        let scope = scope.inner();
        return (vec![Section { name, place: None, statements: shared, scope, domain, operator, solve }], of_all);
    }
    let mut sections = Vec::with_capacity(document.patches.len());
    for block in &document.patches {
        if reading.is_over {
            break;
        }
        let statements = &block.statements;
        let mut scope = scope.of_patch();
        scope.announce(statements.definitions.iter().map(|definition| &definition.name));
        declarations::definitions(&statements.definitions, &mut scope, reading);
        let operator = match only_equation(&statements.equations, reading) {
            None => operator.clone(),
            Some(own) => {
                let own = over_shared(own, stated);
                equation::resolve(Some(&own), Some(&block.name.text), &scope, parameters, reading)
            }
        };
        sections.push(Section {
            name: block.name.text.clone(),
            place: Some(block.name.span),
            statements,
            domain: self::domain(&statements.ranges, domain.clone(), &scope, reading),
            operator,
            solve: if statements.solves.is_empty() {
                solve.clone()
            } else {
                solve_request(&statements.solves, reading)
            },
            scope,
        });
    }
    (sections, domain)
}

/// The patch, or `None` if anything about it is at fault. Without `bindings` positions are not known.
pub fn resolve(section: Section<'_>, bindings: Option<&Bindings>, reading: &mut Reading<'_>) -> Option<Patch> {
    let Section { name, place, statements, scope, domain, operator, solve } = section;
    let numbers = match bindings {
        None => None,
        Some(bindings) => {
            let values = domain.evaluate_in(&reading.graph, bindings);
            reading.keep(values).map(|values| (bindings, values))
        }
    };
    let boundaries = &statements.boundaries;
    boundary::check_coordinates(boundaries, reading);
    let frame_u = boundary::Frame {
        across: Variable::U,
        order: operator.as_ref().map(PdeOperator::order_in_u),
        numbers: numbers.map(|(bindings, values)| (bindings, values.u)),
        place,
    };
    let frame_v = boundary::Frame {
        across: Variable::V,
        order: operator.as_ref().map(PdeOperator::order_in_v),
        numbers: numbers.map(|(bindings, values)| (bindings, values.v)),
        place,
    };
    let at_u = boundary::at_u(boundaries, &frame_u, &scope, reading);
    let at_v = boundary::at_v(boundaries, &frame_v, &scope, reading);
    let deformations = deformation::resolve(&statements.deformations, numbers, &scope, reading);
    let ((conditions, joins), side_conditions) = (at_u?, at_v?);
    Some(Patch { name, domain, operator: operator?, conditions, joins, side_conditions, deformations, solve })
}

/// The seams that are stated between `patches` and `nets`.
pub fn seams(
    document: &Document,
    (patches, nets): (&[Patch], &[Net]),
    scope: &Scope<'_>,
    bindings: &Bindings,
    reading: &mut Reading<'_>,
) -> Vec<Seam> {
    let mut seams = Vec::with_capacity(document.seams.len());
    for seam in &document.seams {
        let edges = seam.edges.each_ref().map(|edge| {
            let edge = seam_edge(edge, (patches, nets), bindings, &mut reading.lowering(scope));
            reading.keep(edge)
        });
        if let [Some(first), Some(second)] = edges {
            seams.push(Seam { edges: [first, second], origin: Some(seam.span) });
        }
    }
    seams
}

fn seam_edge(
    edge: &SeamEdge,
    (patches, nets): (&[Patch], &[Net]),
    bindings: &Bindings,
    lowering: &mut Lowering<'_>,
) -> Result<(usize, ExprId), Fault> {
    let name = &edge.patch;
    let names = patches.iter().map(|patch| patch.name.as_str()).chain(nets.iter().map(|net| net.name.as_str()));
    let known: Vec<&str> = names.collect();
    let Some(index) = known.iter().position(|known| *known == name.text) else {
        let finding = Diagnostic::new(Code::UnknownName, format!("there is no patch `{}`", name.text)).at(name.span);
        return Err(finding.hint(format!("patches: {}", known.join(", "))).into());
    };
    if edge.variable.text != Variable::U.name() {
        let message = format!("patches meet at values of u, not of `{}`", edge.variable.text);
        return Err(Diagnostic::new(Code::UnexpectedText, message).at(edge.variable.span).into());
    }
    let u = lowering.constant(edge.position, "the position of a seam")?;
    let place = lowering.tree.span(edge.position);
    let domain = match (patches.get(index), nets.get(index.saturating_sub(patches.len()))) {
        (Some(patch), _) => patch.domain.evaluate_in(lowering.graph, bindings)?,
        (None, Some(net)) => net.domain_in(lowering.graph, bindings)?,
        (None, None) => return Err(Fault::Follows),
    };
    let [low, high] = domain.u;
    let position = bindings.constant_in(lowering.graph, u, Some(place), "the position of a seam")?;
    if (low..=high).contains(&position) {
        return Ok((index, u));
    }
    let message = format!("u = {position} lies outside the domain u in [{low}, {high}] of `{}`", name.text);
    Err(Diagnostic::new(Code::DependentConstraints, message).at(place).into())
}

/// Refuses too many patches, two of one name, and constraints that belong to none of them.
fn check_blocks(document: &Document, reading: &mut Reading<'_>) {
    let limit = reading.limits.patches;
    let patches = document.patches.iter().map(|block| &block.name);
    let names: Vec<&Name> = patches.chain(document.nets.iter().map(|block| &block.name)).collect();
    if let Some(name) = names.get(limit) {
        let message = format!("more patches than the limit `patches` of {limit}");
        reading.report(Diagnostic::new(Code::LimitReached, message).at(name.span));
    }
    for (index, name) in names.iter().enumerate().take(limit) {
        if let Some(first) = names.iter().take(index).find(|other| other.text == name.text) {
            let message = format!("two patches are called `{}`", name.text);
            let finding = Diagnostic::new(Code::DuplicateName, message).at(name.span);
            reading.report(finding.label(first.span, "first declared here"));
        }
    }
    if document.patches.is_empty() && document.nets.is_empty() {
        return;
    }
    let outside = |what: &str, place: Span| {
        Diagnostic::new(Code::UnexpectedText, format!("a {what} stands outside the patches of the document"))
            .at(place)
            .hint(format!("each patch has its own: move the {what} into its `patch NAME {{ … }}`"))
    };
    if let Some(boundary) = document.shared.boundaries.first() {
        let place = boundary.variable.span.to(reading.tree.span(boundary.position));
        reading.report(outside("boundary", place));
    }
    if let Some(deformation) = document.shared.deformations.first() {
        reading.report(outside("deformation", deformation.span));
    }
    if document.patches.is_empty() {
        let equation = document.shared.equations.first().map(|equation| ("equation", equation.span));
        let method = document.shared.solves.first().map(|solve| ("method", solve.method.span));
        for (what, place) in equation.into_iter().chain(method) {
            let message = format!("the {what} belongs to patches, and the document has `bspline` blocks only");
            let finding = Diagnostic::new(Code::UnexpectedText, message).at(place);
            reading.report(finding.hint("nets satisfy ∂⁶S/∂u³∂v³ = 0, by the method `mask`: leave it out"));
        }
    }
}

fn states_no_equation(block: &PatchBlock) -> bool {
    block.statements.equations.is_empty()
}

fn only_equation<'a>(statements: &'a [PdeStatement], reading: &mut Reading<'_>) -> Option<&'a PdeStatement> {
    if let [first, second, ..] = statements {
        reading.report(
            Diagnostic::new(Code::DuplicateStatement, "the equation is stated twice")
                .at(second.span)
                .label(first.span, "first stated here"),
        );
    }
    statements.first()
}

/// A patch's `pde with …` changes coefficients of the equation that all patches share.
fn over_shared(own: &PdeStatement, shared: Option<&PdeStatement>) -> PdeStatement {
    let (Some(shared), None) = (shared, own.sides) else { return own.clone() };
    let of_own = |name: &str| own.coefficients.iter().find(|(other, _)| other.text == name);
    let changed = shared.coefficients.iter().map(|row| of_own(&row.0.text).unwrap_or(row));
    let is_new = |name: &str| shared.coefficients.iter().all(|(other, _)| other.text != name);
    let added = own.coefficients.iter().filter(|(name, _)| is_new(&name.text));
    PdeStatement { sides: shared.sides, coefficients: changed.chain(added).cloned().collect(), span: own.span }
}

/// `domain` with the ranges that are stated.
pub fn domain(ranges: &[Range], mut domain: Domain, scope: &Scope<'_>, reading: &mut Reading<'_>) -> Domain {
    let mut stated: [Option<Span>; 3] = [None; 3];
    for range in ranges {
        let Some(index) = Variable::ALL.iter().position(|variable| variable.name() == range.variable.text) else {
            reading.report(
                Diagnostic::new(Code::UnknownName, format!("`{}` has no domain", range.variable.text))
                    .at(range.variable.span)
                    .hint("the coordinates are u, v and t; a param has its range behind its value: `param a = 1 in [0, 2]`"),
            );
            continue;
        };
        let [low, high] = range.interval.map(|end| reading.tree.span(end));
        let Some(before) = stated.get_mut(index) else { continue };
        if let Some(first) = before {
            let message = format!("the domain of {} is stated twice", range.variable.text);
            let finding = Diagnostic::new(Code::DuplicateStatement, message).at(range.variable.span);
            reading.report(finding.label(*first, "first stated here"));
            continue;
        }
        *before = Some(low.to(high));
        let ends = range.interval.map(|end| {
            let end = reading.lowering(scope).constant(end, "a domain");
            reading.keep(end)
        });
        let slots = (domain.ends.get_mut(index), domain.origins.get_mut(index));
        if let ([Some(low), Some(high)], (Some(slot), Some(origin))) = (ends, slots) {
            *slot = [low, high];
            *origin = *before;
        }
    }
    domain
}

fn solve_request(statements: &[SolveStatement], reading: &mut Reading<'_>) -> SolveRequest {
    if let [first, second, ..] = statements {
        reading.report(
            Diagnostic::new(Code::DuplicateStatement, "the method is stated twice")
                .at(second.method.span)
                .label(first.method.span, "first stated here"),
        );
    }
    let Some(statement) = statements.first() else { return SolveRequest::default() };
    let settings = statement.settings.iter().map(|setting| RequestedSetting {
        key: setting.key.text.clone(),
        value: setting.value.clone(),
        origin: Some(setting.span),
    });
    SolveRequest {
        method: Some(statement.method.text.clone()),
        origin: Some(statement.method.span),
        settings: settings.collect(),
    }
}
