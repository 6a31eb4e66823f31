//! Patch blocks, and what they share, to patches.

use super::boundary;
use super::declarations;
use super::deformation;
use super::edges;
use super::equation;
use super::loops;
use super::reading::Reading;
use super::scope::Scope;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::Variable;
use crate::multisided::close_at_apex;
use crate::problem::{Bindings, Domain, Parameter, Patch, PdeOperator, RequestedSetting, SolveRequest};
use crate::syntax::ast::{Document, Name, PatchBlock, PdeStatement, Range, SolveStatement, Statements};

/// A patch whose boundary is still to be read.
pub struct Section<'a> {
    /// What the user calls it.
    pub name: String,
    /// Where its name is written.
    pub place: Option<Span>,
    /// Whether it is a loop of edges.
    pub is_loop: bool,
    /// What it states.
    pub statements: &'a Statements,
    /// What names mean inside.
    pub scope: Scope<'a>,
    /// Its ranges.
    pub domain: Domain,
    /// `None` if it is at fault.
    pub operator: Option<PdeOperator>,
    /// How it is to be solved.
    pub solve: SolveRequest,
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
        let section = Section { name, place: None, is_loop: false, statements: shared, scope, domain, operator, solve };
        return (vec![section], of_all);
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
            is_loop: block.is_loop,
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

/// The patch, or the patches of a loop; none if anything about it is at fault. Without `bindings` positions are not known.
pub fn resolve(section: Section<'_>, bindings: Option<&Bindings>, reading: &mut Reading<'_>) -> Vec<Patch> {
    if section.is_loop {
        return loops::resolve(section, bindings, reading).unwrap_or_default();
    }
    patch(section, bindings, reading).into_iter().collect()
}

fn patch(section: Section<'_>, bindings: Option<&Bindings>, reading: &mut Reading<'_>) -> Option<Patch> {
    let Section { name, place, statements, scope, domain, operator, solve, .. } = section;
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
        along: domain.ends[1],
        place,
    };
    let frame_v = boundary::Frame {
        across: Variable::V,
        order: operator.as_ref().map(PdeOperator::order_in_v),
        numbers: numbers.map(|(bindings, values)| (bindings, values.v)),
        along: domain.ends[0],
        place,
    };
    let at_u = boundary::at_u(boundaries, &frame_u, &scope, reading);
    let at_v = boundary::at_v(boundaries, &frame_v, &scope, reading);
    let deformations = deformation::resolve(&statements.deformations, numbers, &scope, reading);
    let ((conditions, joins), side_conditions) = (at_u?, at_v?);
    let operator = operator?;
    let mut patch =
        Patch { name, domain, operator, conditions, joins, side_conditions, is_of_loop: false, deformations, solve };
    if boundaries.iter().any(|boundary| !boundary.constraints.apexes.is_empty()) {
        let closed = close_at_apex(&mut reading.graph, &mut patch, reading.limits);
        reading.keep(closed)?;
    }
    edges::name_uses(&patch.name, reading);
    Some(patch)
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
