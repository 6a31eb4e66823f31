//! Judges how smooth a surface is where a side of it is a point.

use crate::diagnostic::Diagnostic;
use crate::expr::{Derivative, Variable};
use crate::numeric::{NodeKind, nodes};
use crate::problem::DomainValues;
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

/// Looks at the four sides of a patch at instant `t`, at 61 places of each, and measures those that are points.
///
/// # Errors
/// What the surface says when it cannot be evaluated.
pub fn verify_apexes(surface: &dyn Surface, domain: &DomainValues, t: f64) -> Result<Vec<ApexDeviation>, Diagnostic> {
    let mut sides = Vec::with_capacity(4);
    for (across, ends, along) in [(Variable::U, domain.u, domain.v), (Variable::V, domain.v, domain.u)] {
        let along = nodes(NodeKind::Ends, PLACES, along);
        for position in ends {
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
    }
    let size =
        sides.iter().flat_map(|(_, _, positions, _)| positions).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let apex = |(across, position, positions, tangents): &(Variable, f64, Vec<[f64; 3]>, Vec<[f64; 3]>)| {
        let apex = Apex::of(positions, tangents, size)?;
        Some(ApexDeviation { across: *across, position: *position, apex })
    };
    Ok(sides.iter().filter_map(apex).collect())
}
