//! `join S1 at u = u1` to boundary conditions, and the trimlines that lie on primary surfaces.

use super::boundary::Stated;
use super::form::components;
use super::lower::Lowering;
use super::reading::Fault;
use super::scope::Value;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{Derivative, ExprId, Variable};
use crate::problem;
use crate::syntax::ast::{Constraint, Join, Kind};

/// The constraints that a join stands for: position, tangent, … up to half the order of the equation.
pub fn expand(
    join: &Join,
    u: ExprId,
    order_in_u: usize,
    lowering: &mut Lowering<'_>,
) -> Result<(Vec<Stated>, problem::Join), Fault> {
    let name = &join.surface;
    if lowering.scope.is_faulty(&name.text) {
        return Err(Fault::Follows);
    }
    let surface =
        lowering.surface(&name.text).filter(|(surface, component)| surface.index.is_some() && component.is_none());
    let Some((surface, _)) = surface else {
        let hint = format!("declare it: `surface {}(u, v) = …`", name.text);
        return Err(match lowering.scope.meaning(&name.text) {
            None => lowering.scope.unknown_name(name, Some(hint)),
            Some(_) => {
                let finding = Diagnostic::new(Code::UnknownName, format!("`{}` is not a surface", name.text));
                let is_curve = lowering.surface(&name.text).is_some_and(|(surface, _)| surface.index.is_none());
                finding.at(name.span).hint(if is_curve {
                    format!("constrain S by the curve: `S = {}(v)`", name.text)
                } else {
                    hint
                })
            }
        }
        .into());
    };
    let Some((parameter, position)) = &join.at else {
        let message = format!("`{}` is a surface, and which of its curves is joined is missing", name.text);
        let finding = Diagnostic::new(Code::UnexpectedText, message).at(join.span);
        return Err(finding.hint(format!("write `join {} at u = …`", name.text)).into());
    };
    if join.is_reversed {
        let message = "a curve of a surface runs with the patch, so it cannot be reversed";
        let finding = Diagnostic::new(Code::UnexpectedText, message).at(join.span);
        return Err(finding.hint("declare the surface with the parameter running the other way").into());
    }
    let across = surface.parameter(&parameter.text).filter(|parameter| *parameter != Variable::T);
    let Some(across) = across else {
        let message = format!("a trimline of `{}` is where its first or second parameter is constant", name.text);
        let finding = Diagnostic::new(Code::UnexpectedText, message).at(parameter.span);
        return Err(finding.hint(format!("write `join {} at u = …`", name.text)).into());
    };
    let position = lowering.constant(*position, "the position of a trimline")?;
    let arguments = arguments(across, position, lowering);
    let strength = match join.strength {
        Some(strength) => lowering.scalar(strength)?,
        None => lowering.graph.integer(1),
    };
    let factor = if join.is_flipped { lowering.graph.neg(strength) } else { strength };
    let replacements = Variable::ALL
        .iter()
        .zip(arguments)
        .map(|(variable, value)| (lowering.graph.variable(*variable), value))
        .collect();
    let mut stated = Vec::new();
    for order in 0..(order_in_u / 2).max(1) {
        let orders = match across {
            Variable::V => Derivative::new(0, order, 0),
            _ => Derivative::new(order, 0, 0),
        };
        let derivative = lowering.differentiated(Value::Vector(surface.position), orders, join.span)?;
        let scale = lowering.graph.power_integer(factor, i64::try_from(order).unwrap_or(i64::MAX));
        let value = components(derivative).map(|expr| {
            let value = lowering.graph.substitute(expr, &replacements);
            Some(lowering.graph.product([scale, value]))
        });
        if lowering.graph.size() > lowering.limits.graph_nodes {
            return Err(lowering.too_large_at(join.span).into());
        }
        stated.push(Stated { order, value, places: [join.span; 3], span: join.span });
    }
    let is_flipped = Some(join.is_flipped);
    let index = surface.index.unwrap_or_default();
    let joined = problem::Join { surface: index, u, arguments, across, is_flipped, origin: Some(join.span) };
    Ok((stated, joined))
}

/// The surface's parameters along its curve `across = position`: the patch's v is the other one.
fn arguments(across: Variable, position: ExprId, lowering: &mut Lowering<'_>) -> [ExprId; 3] {
    let [v, t] = [Variable::V, Variable::T].map(|variable| lowering.graph.variable(variable));
    match across {
        Variable::V => [v, position, t],
        _ => [position, v, t],
    }
}

/// The join that a constraint `S = S1(u1, v, t)` amounts to.
pub fn written_out(constraint: &Constraint, u: ExprId, lowering: &mut Lowering<'_>) -> Option<problem::Join> {
    let is_position = constraint.target.component.is_none() && constraint.target.derivative == Derivative::NONE;
    let Kind::Application(name, arguments) = &lowering.tree.node(constraint.value).kind else { return None };
    let (surface, None) = lowering.surface(&name.text)? else { return None };
    let index = surface.index?;
    let mut values = Vec::with_capacity(3);
    for argument in arguments {
        values.push(lowering.scalar(*argument).ok()?);
    }
    values.resize(3, lowering.graph.variable(Variable::T));
    let values = <[ExprId; 3]>::try_from(values).ok()?;
    let depends = values.map(|value| lowering.graph.dependence(value).v);
    let across = if depends[0] && !depends[1] { Variable::V } else { Variable::U };
    let origin = Some(constraint.span);
    is_position.then_some(problem::Join { surface: index, u, arguments: values, across, is_flipped: None, origin })
}
