//! `at u = c:` blocks to boundary conditions, counted against the order of the equation.

use super::form::components;
use super::lower::Lowering;
use super::scope::Value;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, MOST_FINDINGS, Span};
use crate::expr::{ExprId, Variable};
use crate::numeric::CardinalPolynomials;
use crate::problem::{BoundaryCondition, describe_condition};
use crate::syntax::ast::{Boundary, Constraint, Kind};

/// A condition that is still being collected.
struct Collected {
    position: f64,
    u: ExprId,
    order: usize,
    value: [Option<(ExprId, Span)>; 3],
}

/// Resolves all boundary blocks. `position_of` gives the number behind a constant expression.
pub fn resolve(
    boundaries: &[Boundary],
    lowering: &mut Lowering<'_>,
    order_in_u: usize,
    range: [f64; 2],
    position_of: impl Fn(ExprId, Span, &crate::expr::Graph) -> Result<f64, Diagnostic>,
) -> Result<Vec<BoundaryCondition>, Diagnostics> {
    let mut found = Diagnostics::new();
    let mut collected: Vec<Collected> = Vec::new();
    for boundary in boundaries {
        let place = lowering.tree.span(boundary.position);
        let position = position(boundary, lowering).and_then(|u| Ok((u, position_of(u, place, lowering.graph)?)));
        match position {
            Ok((_, position)) if !(range[0]..=range[1]).contains(&position) => found.push(
                Diagnostic::new(
                    Code::DependentConstraints,
                    format!("u = {position} lies outside the domain u in [{}, {}]", range[0], range[1]),
                )
                .at(place),
            ),
            Ok((u, position)) => {
                for constraint in &boundary.constraints {
                    if let Err(finding) = add(constraint, (u, position), order_in_u, lowering, &mut collected) {
                        found.push(finding);
                        if found.len() >= MOST_FINDINGS {
                            return Err(found);
                        }
                    }
                }
            }
            Err(finding) => found.push(finding),
        }
        if found.len() >= MOST_FINDINGS {
            return Err(found);
        }
    }
    if !found.is_empty() {
        return Err(found);
    }
    collected.sort_by(|a, b| a.position.total_cmp(&b.position).then(a.order.cmp(&b.order)));
    check_complete(&collected, boundaries, lowering, order_in_u, range)?;
    let conditions = collected.into_iter().map(|condition| BoundaryCondition {
        u: condition.u,
        order: condition.order,
        value: condition.value.map(|value| value.map_or(condition.u, |(expr, _)| expr)),
        origins: condition.value.map(|value| value.map(|(_, span)| span)),
    });
    Ok(conditions.collect())
}

fn position(boundary: &Boundary, lowering: &mut Lowering<'_>) -> Result<ExprId, Diagnostic> {
    if boundary.variable.text != Variable::U.name() {
        let message = format!("boundaries are at values of u, not of `{}`", boundary.variable.text);
        return Err(Diagnostic::new(Code::UnexpectedText, message)
            .at(boundary.variable.span)
            .hint("u runs across the blend, from one trimline to the other; write `at u = 0:`"));
    }
    lowering.constant(boundary.position, "the position of a boundary")
}

fn add(
    constraint: &Constraint,
    (u, position): (ExprId, f64),
    order_in_u: usize,
    lowering: &mut Lowering<'_>,
    collected: &mut Vec<Collected>,
) -> Result<(), Diagnostic> {
    let target = constraint.target;
    let order = target.derivative.u;
    if target.derivative.v > 0 || target.derivative.t > 0 {
        return Err(Diagnostic::new(Code::UnexpectedText, "a boundary constraint is on S or its derivatives in u")
            .at(target.span)
            .hint("derivatives along the trimline follow from S there"));
    }
    if order >= order_in_u {
        let message =
            format!("an equation of order {order_in_u} in u takes no constraint on a derivative of order {order}");
        return Err(Diagnostic::new(Code::WrongConstraintCount, message).at(target.span));
    }
    let value = lowering.value(constraint.value)?;
    let place = lowering.tree.span(constraint.value);
    let wanted = match (target.component, value) {
        (None, Value::Scalar(expr)) if !lowering.graph.is_zero(expr) => {
            return Err(Diagnostic::new(Code::NotScalar, "S is a vector, so its constraint must be one")
                .at(place)
                .hint("write `[x, y, z]`, or constrain one component: `S_x = …`"));
        }
        (None, value) => components(value).map(Some),
        (Some(_), Value::Vector(_)) => {
            return Err(Diagnostic::new(Code::NotScalar, "a component of S is a number, not a vector").at(place));
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
    for (expr, place) in wanted.into_iter().zip(places) {
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
    for (component, ((slot, expr), place)) in condition.value.iter_mut().zip(wanted).zip(places).enumerate() {
        match (slot.as_ref(), expr) {
            (Some((_, first)), Some(_)) => {
                let what = describe_condition(Some(component), order, position);
                return Err(Diagnostic::new(Code::DuplicateConstraint, format!("{what} is given twice"))
                    .at(constraint.span)
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
    boundaries: &[Boundary],
    lowering: &Lowering<'_>,
    order_in_u: usize,
    range: [f64; 2],
) -> Result<(), Diagnostics> {
    let whole = boundaries.last().map(|boundary| lowering.tree.span(boundary.position));
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
