//! Three-sided patches: four-sided ones whose side at the high end of u is a point, the apex (docs/methods.md, M1).

use super::vector::{End, at, hermite, scaled, slope};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{Graph, Variable};
use crate::limits::Limits;
use crate::problem::{BoundaryCondition, Patch};

/// Closes `patch`, which states position and tangent at the low end of u and at both ends of v, at an apex.
///
/// The side at the high end of u becomes the point where the curves on the sides of v end, and the tangent there turns
/// from one of them to the other, so that positions, tangents and twists fit in every corner. The curves must end in
/// one point and the tangents on these sides in zero; [`Code::SidesDisagree`] says so when the patch is solved.
///
/// # Errors
/// [`Code::UnsupportedByMethod`] if other conditions are stated; [`Code::NotDifferentiable`] for a side without slope.
pub fn close_at_apex(graph: &mut Graph, patch: &mut Patch, limits: &Limits) -> Result<(), Diagnostic> {
    let origin = patch.boundary_origin();
    let [[_, high_u], [low_v, high_v], _] = patch.domain.ends;
    let orders = |found: Vec<usize>, expected: &[usize]| found == expected;
    let is_three_sided = orders(patch.conditions.iter().map(|condition| condition.order).collect(), &[0, 1])
        && orders(patch.side_conditions.iter().map(|condition| condition.order).collect(), &[0, 1, 0, 1]);
    let sides: Vec<_> = patch.side_conditions.iter().map(|condition| condition.value).collect();
    let ([curve, tangent, other_curve, other_tangent], true) = (sides.as_slice(), is_three_sided) else {
        let message = "a patch with an apex needs position and tangent at the low end of u and at both ends of v";
        return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(origin));
    };
    let apex = at(graph, *curve, Variable::U, high_u);
    let v = graph.variable(Variable::V);
    let (from, length) = (graph.difference(v, low_v), graph.difference(high_v, low_v));
    let share = graph.quotient(from, length);
    let mut end = |curve, tangent| -> Result<End, Diagnostic> {
        let leaving = slope(graph, curve, Variable::U, limits, origin)?;
        let turning = slope(graph, tangent, Variable::U, limits, origin)?;
        let turning = scaled(graph, length, turning);
        Ok(End { position: at(graph, leaving, Variable::U, high_u), slope: at(graph, turning, Variable::U, high_u) })
    };
    let (start, stop) = (end(*curve, *tangent)?, end(*other_curve, *other_tangent)?);
    let fan = hermite(graph, share, start, stop);
    for (order, value) in [apex, fan].into_iter().enumerate() {
        patch.conditions.push(BoundaryCondition { u: high_u, order, value, origins: [origin; 3] });
    }
    Ok(())
}
