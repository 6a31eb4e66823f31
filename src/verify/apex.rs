//! Judges how smooth a surface is where a side of it is a point.

use crate::diagnostic::Diagnostic;
use crate::expr::{Derivative, ExprId, Variable};
use crate::numeric::{NodeKind, nodes};
use crate::problem::{Bindings, DomainValues, Patch, Problem};
use crate::surface::{Apex, Surface};

/// Places along a side.
const PLACES: usize = 61;

/// A side that is a point, as it was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ApexDeviation {
    /// The coordinate that is fixed along the side.
    pub across: Variable,
    /// Its value.
    pub position: f64,
    /// How the surface leaves the point.
    pub apex: Apex,
}

/// Measures those sides of a patch with data on four sides that are points, at instant `t` and 61 places of each.
///
/// Looked at are sides whose position is stated without the coordinate along them.
///
/// # Errors
/// What the surface says when it cannot be evaluated.
pub fn verify_apexes(
    problem: &Problem,
    patch: &Patch,
    surface: &dyn Surface,
    (bindings, domain, t): (&Bindings, &DomainValues, f64),
) -> Result<Vec<ApexDeviation>, Diagnostic> {
    let mut sides = Vec::new();
    for side in super::sides(patch).filter(|side| side.order == 0 && patch.is_four_sided()) {
        let across = side.across;
        let runs = |expr: &ExprId| {
            let depends = problem.graph.dependence(*expr);
            if across == Variable::U { depends.v } else { depends.u }
        };
        if side.value.iter().any(runs) {
            continue;
        }
        let position = bindings.constant(problem, side.position, None, "the position of a boundary")?;
        let along = nodes(NodeKind::Ends, PLACES, if across == Variable::U { domain.v } else { domain.u });
        let here = [position];
        let ((u, v), orders) = match across {
            Variable::U => ((&here[..], &along[..]), Derivative::new(1, 0, 0)),
            _ => ((&along[..], &here[..]), Derivative::new(0, 1, 0)),
        };
        let values = |derivative: Derivative| {
            let mut values = vec![[0.0; 3]; PLACES];
            surface.evaluate_grid(derivative, (u, v, t), &mut values).map(|()| values)
        };
        sides.push((across, position, values(Derivative::NONE)?, values(orders)?));
    }
    // A point at the origin has no size of its own.
    let middle = [domain.u, domain.v].map(|[low, high]| 0.5 * (low + high));
    let mut inside = [[0.0; 3]];
    if !sides.is_empty() {
        surface.evaluate(Derivative::NONE, &[[middle[0], middle[1], t]], &mut inside)?;
    }
    let placed = sides.iter().flat_map(|(_, _, positions, _)| positions).chain(&inside);
    let size = placed.flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let apex = |(across, position, positions, tangents): &(Variable, f64, Vec<[f64; 3]>, Vec<[f64; 3]>)| {
        let apex = Apex::of(positions, tangents, size)?;
        Some(ApexDeviation { across: *across, position: *position, apex })
    };
    Ok(sides.iter().filter_map(apex).collect())
}
