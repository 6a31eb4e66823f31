//! `at u = c:` blocks to boundary conditions, counted against the order of the equation.

use super::join;
use super::lower::{Lowering, components};
use super::reading::{Fault, Reading};
use super::scope::{Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Span};
use crate::expr::{ExprId, Variable};
use crate::numeric::CardinalPolynomials;
use crate::problem::{Bindings, BoundaryCondition, Join, describe_condition};
use crate::syntax::ast::{Boundary, Constraint, Kind};

/// A condition that is still being collected.
struct Collected {
    position: f64,
    u: ExprId,
    order: usize,
    value: [Option<(ExprId, Span)>; 3],
}

/// What the boundary blocks of a patch are judged by.
pub struct Frame<'a> {
    /// The order of the equation, if it has one.
    pub order_in_u: Option<usize>,
    /// The values of parameters and the range of u, if they are known.
    pub numbers: Option<(&'a Bindings, [f64; 2])>,
    /// Where the patch is named.
    pub place: Option<Span>,
}

/// Resolves all boundary blocks; `None` if the boundary is at fault or cannot be judged.
pub fn resolve(
    boundaries: &[Boundary],
    frame: &Frame<'_>,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<(Vec<BoundaryCondition>, Vec<Join>)> {
    let found_before = reading.found.len();
    let mut collected: Vec<Collected> = Vec::new();
    let mut joins = Vec::new();
    for boundary in boundaries {
        let edge = edge(boundary, frame, &mut reading.lowering(scope));
        let edge = reading.keep(edge).flatten();
        for constraint in &boundary.constraints.single {
            if reading.is_over {
                return None;
            }
            let stated = stated(constraint, frame.order_in_u, &mut reading.lowering(scope));
            if let (Some(stated), Some(edge)) = (reading.keep(stated), edge) {
                let added = add(stated, edge, &mut reading.lowering(scope), &mut collected);
                reading.keep(added);
                joins.extend(join::written_out(constraint, edge.0, &mut reading.lowering(scope)));
            }
        }
        for join in &boundary.constraints.joins {
            let (Some((u, position)), Some(order_in_u)) = (edge, frame.order_in_u) else { continue };
            let expanded = join::expand(join, u, order_in_u, &mut reading.lowering(scope));
            let Some((stated, join)) = reading.keep(expanded) else { continue };
            for stated in stated {
                let added = add(stated, (u, position), &mut reading.lowering(scope), &mut collected);
                reading.keep(added);
            }
            joins.push(join);
        }
    }
    let (Some(order_in_u), Some((_, range)), true) =
        (frame.order_in_u, frame.numbers, reading.found.len() == found_before)
    else {
        return None;
    };
    collected.sort_by(|a, b| a.position.total_cmp(&b.position).then(a.order.cmp(&b.order)));
    let whole = boundaries.last().map(|boundary| reading.tree.span(boundary.position)).or(frame.place);
    let complete = check_complete(&collected, whole, order_in_u, range);
    if let Err(findings) = complete {
        findings.into_iter().for_each(|finding| reading.report(finding));
        return None;
    }
    let conditions = collected.into_iter().map(|condition| BoundaryCondition {
        u: condition.u,
        order: condition.order,
        value: condition.value.map(|value| value.map_or(condition.u, |(expr, _)| expr)),
        origins: condition.value.map(|value| value.map(|(_, span)| span)),
    });
    Some((conditions.collect(), joins))
}

/// The position of a boundary, symbolically and as a number; `None` where numbers are not known.
fn edge(boundary: &Boundary, frame: &Frame<'_>, lowering: &mut Lowering<'_>) -> Result<Option<(ExprId, f64)>, Fault> {
    if boundary.variable.text != Variable::U.name() {
        let message = format!("boundaries are at values of u, not of `{}`", boundary.variable.text);
        return Err(Diagnostic::new(Code::UnexpectedText, message)
            .at(boundary.variable.span)
            .hint("u runs across the blend, from one trimline to the other; write `at u = 0:`")
            .into());
    }
    let u = lowering.constant(boundary.position, "the position of a boundary")?;
    let Some((bindings, range)) = frame.numbers else { return Ok(None) };
    let place = lowering.tree.span(boundary.position);
    let position = bindings.constant_in(lowering.graph, u, Some(place), "the position of a boundary")?;
    if !(range[0]..=range[1]).contains(&position) {
        let message = format!("u = {position} lies outside the domain u in [{}, {}]", range[0], range[1]);
        return Err(Diagnostic::new(Code::DependentConstraints, message).at(place).into());
    }
    Ok(Some((u, position)))
}

/// A constraint with its value: for each component the prescribed function, if there is one, and its place.
pub struct Stated {
    /// The order of the derivative in u.
    pub order: usize,
    /// The prescribed function of each component.
    pub value: [Option<ExprId>; 3],
    /// Where each is written.
    pub places: [Span; 3],
    /// The whole statement.
    pub span: Span,
}

fn stated(constraint: &Constraint, order_in_u: Option<usize>, lowering: &mut Lowering<'_>) -> Result<Stated, Fault> {
    let target = constraint.target;
    let order = target.derivative.u;
    if target.derivative.v > 0 || target.derivative.t > 0 {
        return Err(Diagnostic::new(Code::UnexpectedText, "a boundary constraint is on S or its derivatives in u")
            .at(target.span)
            .hint("derivatives along the trimline follow from S there")
            .into());
    }
    if let Some(order_in_u) = order_in_u.filter(|most| order >= *most) {
        let message =
            format!("an equation of order {order_in_u} in u takes no constraint on a derivative of order {order}");
        return Err(Diagnostic::new(Code::WrongConstraintCount, message).at(target.span).into());
    }
    let value = lowering.value(constraint.value)?;
    let place = lowering.tree.span(constraint.value);
    let wanted = match (target.component, value) {
        (None, Value::Scalar(expr)) if !lowering.graph.is_zero(expr) => {
            return Err(Diagnostic::new(Code::NotScalar, "S is a vector, so its constraint must be one")
                .at(place)
                .hint("write `[x, y, z]`, or constrain one component: `S_x = …`")
                .into());
        }
        (None, value) => components(value).map(Some),
        (Some(_), Value::Vector(_)) => {
            return Err(Diagnostic::new(Code::NotScalar, "a component of S is a number, not a vector")
                .at(place)
                .into());
        }
        (Some(component), Value::Scalar(expr)) => {
            let mut wanted = [None; 3];
            if let Some(slot) = wanted.get_mut(component) {
                *slot = Some(expr);
            }
            wanted
        }
    };
    // A vector that is written out has a place for each component.
    let places = match &lowering.tree.node(constraint.value).kind {
        Kind::Vector(parts) => match parts.as_slice() {
            [x, y, z] => [x, y, z].map(|part| lowering.tree.span(*part)),
            _ => [place; 3],
        },
        _ => [place; 3],
    };
    Ok(Stated { order, value: wanted, places, span: constraint.span })
}

/// Adds a constraint to the conditions at the edge `u`.
fn add(
    stated: Stated,
    (u, position): (ExprId, f64),
    lowering: &mut Lowering<'_>,
    collected: &mut Vec<Collected>,
) -> Result<(), Diagnostic> {
    let Stated { order, value, places, span } = stated;
    for (expr, place) in value.into_iter().zip(places) {
        if let Some(expr) = expr
            && lowering.graph.dependence(expr).u
        {
            return Err(depends_on_u(expr, u, position, place, lowering));
        }
    }
    let index = collected.iter().position(|other| other.position == position && other.order == order);
    let index = index.unwrap_or_else(|| {
        collected.push(Collected { position, u, order, value: [None; 3] });
        collected.len() - 1
    });
    let Some(condition) = collected.get_mut(index) else { return Ok(()) };
    for (component, ((slot, expr), place)) in condition.value.iter_mut().zip(value).zip(places).enumerate() {
        match (slot.as_ref(), expr) {
            (Some((_, first)), Some(_)) => {
                let what = describe_condition(Some(component), order, position);
                return Err(Diagnostic::new(Code::DuplicateConstraint, format!("{what} is given twice"))
                    .at(span)
                    .label(*first, "first given here"));
            }
            (None, Some(expr)) => *slot = Some((expr, place)),
            (_, None) => {}
        }
    }
    Ok(())
}

fn depends_on_u(expr: ExprId, u: ExprId, position: f64, place: Span, lowering: &mut Lowering<'_>) -> Diagnostic {
    use crate::expr::Notation;
    let variable = lowering.graph.variable(Variable::U);
    let replaced = lowering.graph.substitute(expr, &[(variable, u)].into_iter().collect());
    let shown = |expr: ExprId, lowering: &Lowering<'_>| lowering.graph.text(expr, Notation::Ascii, 200).ok();
    let message = match shown(expr, lowering) {
        Some(text) => format!("`{text}` depends on `u`, so it is not boundary data"),
        None => "this depends on `u`, so it is not boundary data".to_owned(),
    };
    let finding = Diagnostic::new(Code::NotBoundaryData, message)
        .at(place)
        .marked(format!("at the edge u = {position} only `v`, `t` and parameters may appear"));
    match shown(replaced, lowering) {
        Some(text) => finding.hint(format!("write the value it has there, `{text}`")),
        None => finding.hint("write the value it has there"),
    }
}

/// Checks that there are as many conditions as the order, complete in every component and independent.
fn check_complete(
    collected: &[Collected],
    whole: Option<Span>,
    order_in_u: usize,
    range: [f64; 2],
) -> Result<(), Diagnostics> {
    if collected.len() != order_in_u {
        let stated: Vec<String> = collected.iter().map(|c| describe_condition(None, c.order, c.position)).collect();
        let stated = if stated.is_empty() { "none".to_owned() } else { stated.join(", ") };
        let count = collected.len();
        let message = format!(
            "an equation of order {order_in_u} in u needs {order_in_u} boundary constraints on S, {count} are stated"
        );
        let mut finding =
            Diagnostic::new(Code::WrongConstraintCount, message).at(whole).hint(format!("stated: {stated}"));
        if let Some(missing) = usual(order_in_u, range)
            .into_iter()
            .find(|(position, order)| !collected.iter().any(|c| c.position == *position && c.order == *order))
            .filter(|_| count < order_in_u)
        {
            finding = finding.hint(format!(
                "missing, if both ends are to be joined alike: {}",
                describe_condition(None, missing.1, missing.0)
            ));
        }
        return Err(vec![finding]);
    }
    let mut found = Diagnostics::new();
    for condition in collected {
        for (component, value) in condition.value.iter().enumerate() {
            if value.is_none() {
                let what = describe_condition(Some(component), condition.order, condition.position);
                let sibling = condition.value.iter().flatten().map(|(_, span)| *span).next();
                let finding = Diagnostic::new(Code::MissingConstraint, format!("the constraint on {what} is missing"));
                found.push(finding.at(sibling.or(whole)).hint("every component needs one, `0` included"));
            }
        }
    }
    if !found.is_empty() {
        return Err(found);
    }
    let functionals: Vec<(f64, usize)> = collected.iter().map(|c| (c.position, c.order)).collect();
    if CardinalPolynomials::new(&functionals).is_none() {
        let finding = Diagnostic::new(Code::DependentConstraints, "these constraints do not determine a surface")
            .hint("constrain S itself at one position at least, and each derivative together with the ones below it");
        return Err(vec![finding.at(whole)]);
    }
    Ok(())
}

/// Position, tangent, … at both ends: what most problems state.
fn usual(order_in_u: usize, range: [f64; 2]) -> Vec<(f64, usize)> {
    (0..order_in_u.div_ceil(2)).flat_map(|order| range.map(|position| (position, order))).collect()
}
