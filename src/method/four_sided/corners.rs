//! Whether four sides fit together: in their corners, and where a side is a point.

use super::apex::apex;
use super::solver::FourSidedSolver;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest};
use crate::expr::Derivative;
use crate::method::Report;
use crate::numeric::{NodeKind, nodes};
use crate::surface::{Corner, Sides};

/// Sides that differ by less than this share of their size meet; the boundary is met as closely.
const MEETS: f64 = 1e-9;
/// Places on a side at which it is looked whether the side is a point.
const APEX_SAMPLES: usize = 33;

impl FourSidedSolver {
    /// Warnings for sides that are points without a tangent plane.
    pub(super) fn apexes(
        &self,
        params: &[f64],
        ranges: [[f64; 2]; 2],
        size: f64,
        t: f64,
    ) -> Result<Diagnostics, Diagnostic> {
        let [range_u, range_v] = ranges;
        let mut warnings = Diagnostics::new();
        for (basis, name, ends, along) in [(&self.at_u, "u", range_u, range_v), (&self.at_v, "v", range_v, range_u)] {
            let along = nodes(NodeKind::Ends, APEX_SAMPLES, along);
            let values = basis.values(Derivative::NONE, params, &along, &vec![t; along.len()])?;
            let vectors = |condition: usize| -> Vec<[f64; 3]> {
                let value = |axis: usize, sample: usize| {
                    values.get((3 * condition + axis) * along.len() + sample).copied().unwrap_or(f64::NAN)
                };
                (0..along.len()).map(|sample| [0, 1, 2].map(|axis| value(axis, sample))).collect()
            };
            for (index, end) in ends.into_iter().enumerate() {
                let place = format!("{name} = {}", Shortest(end));
                let (positions, tangents) = (vectors(2 * index), vectors(2 * index + 1));
                warnings.extend(apex((&place, t), &positions, &tangents, size, self.boundary));
            }
        }
        Ok(warnings)
    }

    /// Refuses sides that do not meet in a corner; says where their twists differ.
    pub(super) fn check_corners(
        &self,
        sides: &Sides,
        params: &[f64],
        size: f64,
        t: f64,
        report: &mut Report,
    ) -> Result<[bool; 4], Diagnostic> {
        let [[low_u, high_u], [low_v, high_v]] = sides.ranges;
        let units = [1.0, high_u - low_u, high_v - low_v, (high_u - low_u) * (high_v - low_v)];
        let corners = sides.corners(params, t, 0)?;
        let place = |corner: &Corner| {
            let [i, j] = corner.ends;
            let (u, v) = (if i == 0 { low_u } else { high_u }, if j == 0 { low_v } else { high_v });
            format!("u = {}, v = {}", Shortest(u), Shortest(v))
        };
        // Written so that NaN does not meet.
        let meets = |differences: &[f64], units: &[f64]| {
            differences.iter().zip(units).all(|(difference, unit)| difference * unit <= MEETS * size)
        };
        let differences = corners.map(|corner| corner.mismatch());
        let first_open = corners.iter().zip(&differences).find(|(_, all)| !meets(all.split_at(3).0, &units));
        if let Some((corner, [s, s_u, s_v, _])) = first_open {
            let message = format!(
                "the sides do not fit together in the corner {}: S differs by {s:.1e}, ∂S/∂u by {s_u:.1e}, ∂S/∂v by {s_v:.1e}",
                place(corner)
            );
            let mut finding = Diagnostic::new(Code::SidesDisagree, message).at(self.boundary);
            for (corner, [s, s_u, s_v, s_uv]) in corners.iter().zip(&differences) {
                finding = finding.hint(format!(
                    "{}: differences in S {s:.1e}, ∂S/∂u {s_u:.1e}, ∂S/∂v {s_v:.1e}, ∂²S/∂u∂v {s_uv:.1e}",
                    place(corner)
                ));
            }
            return Err(finding.hint(
                "a side's position must end where its neighbour's begins, and its slope there must be the neighbour's tangent",
            ));
        }
        let is_twisted = differences.map(|[.., twist]| !meets(&[twist], &[units[3]]));
        for ((corner, [.., twist]), _) in
            corners.iter().zip(&differences).zip(is_twisted).filter(|(_, is_twisted)| *is_twisted)
        {
            let message = format!(
                "the sides' twists differ by {twist:.1e} in the corner {}: the surface has no second derivatives there",
                place(corner)
            );
            let finding = Diagnostic::new(Code::TwistsDisagree, message).at(self.boundary);
            report.warnings.push(finding.marked(format!("in the corner {}", place(corner))).hint(
                "for a smoother corner let ∂/∂v of the tangent at fixed u and ∂/∂u of the tangent at fixed v agree there",
            ));
        }
        Ok(is_twisted)
    }
}
