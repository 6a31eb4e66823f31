//! How far what does not close in v drives a surface.
//!
//! On an open range of v, constraints at fixed u determine a solution up to others that grow towards the ends of v. The
//! polynomial that carries what does not close chooses one of them, and where the data are steep at an end, that one is
//! far larger than anything the data call for.

use super::FourierSolver;
use super::ends::Ends;
use super::series::Series;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;
use crate::method::exact::Exact;
use crate::method::{Method, Solution};
use crate::numeric::{NodeKind, nodes};

/// Solutions that are so many times larger than those of constant data of the same size are warned of.
const LARGE: f64 = 3.0;

/// Places in u and in v at which solutions are compared.
const PLACES: usize = 13;

type State<'a> = (&'a [f64], [[f64; 2]; 2], f64);

impl FourierSolver {
    /// Says by how much `solution`, that for the polynomials `ends` of the boundary data whose series is `series`, exceeds that
    /// for constants as large as these data.
    pub(super) fn boundary_reach(
        &self,
        (series, ends, solution): (&Series, &Ends, &Solution),
        (params, [u, [low, high]], t): State<'_>,
    ) -> Result<Option<Diagnostic>, Diagnostic> {
        let constant = ends.leveled(series.size).solve(&self.decomposition, &self.options, (params, u, t))?;
        // Both hold over a range whose middle is 0.
        let half = 0.5 * (high - low);
        let range = [u, [-half, half]];
        Ok(warning(series, largest(solution, range, t)? / largest(&constant, range, t)?))
    }

    /// The same for each function of a force that is carried by a polynomial.
    pub(super) fn force_reach(
        &self,
        forces: &[Series],
        (params, ranges, t): State<'_>,
    ) -> Result<Vec<Diagnostic>, Diagnostic> {
        let mut warnings = Vec::new();
        for (index, series) in forces.iter().enumerate() {
            let Some(ends) = &series.ends else { continue };
            let solved = |ends: Ends| {
                let all: Vec<Option<Ends>> =
                    (0..forces.len()).map(|other| (other == index).then(|| ends.clone())).collect();
                let alone = self.force.of_polynomials(&self.decomposition, &all)?;
                Exact.prepare(&alone, &self.exact_options(forces))?.solve(params, ranges, t)
            };
            let ratio =
                largest(&solved(ends.clone())?, ranges, t)? / largest(&solved(ends.leveled(series.size))?, ranges, t)?;
            warnings.extend(warning(series, ratio));
        }
        Ok(warnings)
    }
}

/// The largest coordinate of a solution.
fn largest(solution: &Solution, [u, v]: [[f64; 2]; 2], t: f64) -> Result<f64, Diagnostic> {
    let axis = |range| nodes(NodeKind::Ends, PLACES, range);
    let mut points = vec![[0.0; 3]; PLACES * PLACES];
    solution.surface.evaluate_grid(Derivative::NONE, (&axis(u), &axis(v), t), &mut points)?;
    Ok(points.iter().flatten().fold(0.0, |most, value| most.max(value.abs())))
}

fn warning(series: &Series, ratio: f64) -> Option<Diagnostic> {
    if ratio.is_nan() || ratio <= LARGE {
        return None;
    }
    let message = format!(
        "{} does not close in v, and the solution for what carries that is {ratio:.1} times larger than for constants of its size",
        series.subject
    );
    Some(Diagnostic::new(Code::EndsDominate, message).at(series.origin).hint(
        "on an open range of v the constraints leave the surface free there: widen the range until data and force are flat at its ends",
    ))
}
