//! The functions of u of a sum of products, as Chebyshev series.

use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;
use crate::numeric::ChebyshevSeries;
use crate::problem::DomainValues;
use crate::surface::{SeparableSurface, Surface};

/// What is cut off the series, relative to the surface: first as much as rounding hides anyway, then what solutions
/// with large coefficients that cancel leave, and those of hundreds of modes.
const TOLERANCES: [f64; 3] = [8e-15, 1e-13, 2e-12];

/// Where the formula is compared with the surface: counts without common factors with the series' nodes.
const GRID: [usize; 2] = [37, 29];

/// What is said where no series is good enough.
pub(super) fn no_series() -> Diagnostic {
    Diagnostic::new(Code::SolutionNotFinite, "the surface varies too fast in u to be written as a formula")
        .hint("use fewer terms, or state how far a B-spline may be off: --within LENGTH")
}

/// The G_j of `S(u, v, t) = Σ_j F_j(v, t) G_j(u)` as series: the x, y and z of each function, by degree.
///
/// # Errors
/// [`Code::SolutionNotFinite`] when the surface is not smooth enough in u, and what the basis reports.
pub fn amplitude_series(surface: &SeparableSurface, domain: DomainValues) -> Result<ChebyshevSeries, Diagnostic> {
    amplitudes(surface, domain.u, 0, &basis_sizes(surface, domain)?)
}

/// How far each basis function reaches on the domain: what an error in its G_j is multiplied with.
pub(super) fn basis_sizes(surface: &SeparableSurface, domain: DomainValues) -> Result<Vec<f64>, Diagnostic> {
    let instants = match surface.instant {
        Some(t) => vec![t],
        None => evenly(domain.t, 5),
    };
    let v = evenly(domain.v, 65);
    let mut sizes = vec![0.0_f64; surface.basis.len()];
    for t in instants {
        let values = surface.basis.values(Derivative::NONE, &surface.params, &v, &vec![t; v.len()])?;
        for (size, row) in sizes.iter_mut().zip(values.chunks(v.len())) {
            *size = row.iter().fold(*size, |most, value| most.max(value.abs()));
        }
    }
    Ok(sizes.into_iter().map(|size| if size > 0.0 { size } else { 1.0 }).collect())
}

fn evenly([low, high]: [f64; 2], count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| low * (1.0 - i as f64 / last) + high * (i as f64 / last)).collect()
}

/// The series of the derivative of order `order` of every G_j.
pub(super) fn amplitudes(
    surface: &SeparableSurface,
    range: [f64; 2],
    order: usize,
    sizes: &[f64],
) -> Result<ChebyshevSeries, Diagnostic> {
    // In units of the surface, so that all are cut at the same error.
    let weights: Vec<f64> = sizes.iter().flat_map(|size| [*size; 3]).collect();
    let values = |order: usize, u: f64| -> Vec<f64> {
        let values = surface.amplitudes(order, u);
        values.iter().flatten().zip(&weights).map(|(value, weight)| value * weight).collect()
    };
    // Of a surface that does not change in u, derivatives are rounding errors, which no series has to follow.
    let [low, high] = range;
    let size =
        [low, 0.5 * (low + high), high].into_iter().flat_map(|u| values(0, u)).fold(0.0, |a: f64, b| a.max(b.abs()));
    let least = size / (high - low).powi(i32::try_from(order).unwrap_or(i32::MAX));
    for tolerance in TOLERANCES {
        let series = ChebyshevSeries::fit(range, weights.len(), (tolerance, least), |u| values(order, u));
        if let Some(mut series) = series {
            let unscale = |row: &mut Vec<f64>| row.iter_mut().zip(&weights).for_each(|(c, weight)| *c /= weight);
            series.coefficients.iter_mut().for_each(unscale);
            return Ok(series);
        }
    }
    Err(no_series())
}

/// The largest difference between series and surface, in position and in S_u, over the largest value of each.
pub(super) fn deviation(
    series: &[ChebyshevSeries; 2],
    surface: &SeparableSurface,
    domain: DomainValues,
) -> Result<f64, Diagnostic> {
    let (u, v) = (evenly(domain.u, GRID[0]), evenly(domain.v, GRID[1]));
    let t = surface.instant.unwrap_or(domain.t[0]);
    let basis = surface.basis.values(Derivative::NONE, &surface.params, &v, &vec![t; v.len()])?;
    let (mut worst, mut of_surface) = (0.0_f64, 0.0_f64);
    for (order, series) in series.iter().enumerate() {
        let mut expected = vec![[0.0; 3]; u.len() * v.len()];
        surface.evaluate_grid(Derivative::new(order, 0, 0), (&u, &v, t), &mut expected)?;
        let largest = expected.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
        // As in `amplitudes`: a derivative that is far smaller than the surface is compared with that.
        let size = if order == 0 { largest } else { largest.max(of_surface / (domain.u[1] - domain.u[0])) };
        of_surface = of_surface.max(largest);
        let mut difference = 0.0_f64;
        for (u, row) in u.iter().zip(expected.chunks(v.len())) {
            let amplitudes = series.values(*u);
            for (column, expected) in row.iter().enumerate() {
                for (component, expected) in expected.iter().enumerate() {
                    let of_component = amplitudes.iter().skip(component).step_by(3);
                    let found: f64 =
                        of_component.zip(basis.iter().skip(column).step_by(v.len())).map(|(g, f)| g * f).sum();
                    let distance = (found - expected).abs();
                    difference = if distance <= difference { difference } else { distance };
                }
            }
        }
        if size > 0.0 {
            worst = if difference / size <= worst { worst } else { difference / size };
        }
    }
    Ok(worst)
}
