//! What any grid would pass over in the data, the equation and the deformations of a patch.

use super::sides;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Graph};
use crate::features::{Features, locate};
use crate::problem::{Bindings, Deformation, DomainValues, Patch, Problem, describe};
use crate::surface::is_lost;

/// Poles and narrow features of data, coefficients and force.
pub(super) fn features_of(
    problem: &Problem,
    patch: &Patch,
    (bindings, domain, t): (&Bindings, &DomainValues, f64),
) -> Features {
    let data = sides(patch).flat_map(|side| *side.value);
    let equation = patch.operator.terms.iter().flat_map(|term| term.coefficient).chain(patch.operator.force);
    let functions: Vec<ExprId> = data.chain(equation).collect();
    locate(&problem.graph, &functions, bindings.as_slice(), [domain.u, domain.v], t)
}

/// Refuses data, a coefficient or a force that has a pole inside the domain at instant `t`, whether or not
/// any grid would meet it.
///
/// # Errors
/// [`Code::DataNotFinite`] with the factor and the place of the pole.
pub fn refuse_poles(
    problem: &Problem,
    patch: &Patch,
    (bindings, domain, t): (&Bindings, &DomainValues, f64),
) -> Result<(), Diagnostic> {
    check_poles(problem, patch, &features_of(problem, patch, (bindings, domain, t)), (bindings, t))
}

/// Refuses a displacement with a pole in its region, or one that leaves less than six digits of a surface of this `size`.
///
/// # Errors
/// [`Code::DataNotFinite`], [`Code::ShapeLost`].
pub fn check_deformations(
    problem: &Problem,
    patch: &Patch,
    (bindings, t): (&Bindings, f64),
    size: f64,
) -> Result<(), Diagnostic> {
    patch.deformations.iter().try_for_each(|deformation| check_deformation(problem, deformation, (bindings, t), size))
}

/// Refuses what [`features_of`] found to be infinite.
pub(super) fn check_poles(
    problem: &Problem,
    patch: &Patch,
    features: &Features,
    (bindings, t): (&Bindings, f64),
) -> Result<(), Diagnostic> {
    if features.poles.is_empty() {
        return Ok(());
    }
    let (graph, operator) = (&problem.graph, &patch.operator);
    for side in sides(patch) {
        let position = bindings.constant(problem, side.position, None, "the position of a boundary")?;
        for (component, (value, origin)) in side.value.iter().zip(side.origins).enumerate() {
            if let Some(pole) = features.pole_of(*value) {
                let what = describe(Some(component), side.order, side.across, position);
                return Err(pole.refuse(graph, &what, t, *origin));
            }
        }
    }
    let coefficients = operator.terms.iter().flat_map(|term| term.coefficient);
    let named = coefficients.map(|expr| (expr, "a coefficient of the equation"));
    let refused = named
        .chain(operator.force.map(|expr| (expr, "the force")))
        .find_map(|(expr, what)| Some(features.pole_of(expr)?.refuse(graph, what, t, operator.origin)));
    refused.map_or(Ok(()), Err)
}

fn check_deformation(
    problem: &Problem,
    deformation: &Deformation,
    (bindings, t): (&Bindings, f64),
    size: f64,
) -> Result<(), Diagnostic> {
    let mut graph: Graph = problem.graph.clone();
    let displacement = deformation.displacement(&mut graph);
    let end = |expr: ExprId| bindings.constant(problem, expr, deformation.origin, "a region");
    let [[u_low, u_high], [v_low, v_high]] = deformation.region;
    let region = [[end(u_low)?, end(u_high)?], [end(v_low)?, end(v_high)?]];
    let features = locate(&graph, &displacement, bindings.as_slice(), region, t);
    if let Some(pole) = features.poles.first() {
        return Err(pole.refuse(&graph, "the displacement", t, deformation.origin));
    }
    let [u, v] = region.map(|[low, high]| 0.5 * (low + high));
    let moved = displacement.iter().map(|expr| graph.value(*expr, bindings.as_slice(), [u, v, t]).abs());
    let moved = moved.fold(0.0, f64::max);
    if is_lost(size, moved) {
        let message = format!("the displacement of {moved:.1e} leaves too little of a surface of size {size:.1e}");
        let finding = Diagnostic::new(Code::ShapeLost, message).at(deformation.origin);
        return Err(finding.hint("rounding takes the rest: write a displacement that is comparable with the surface"));
    }
    Ok(())
}
