//! Solutions over the whole time domain, for methods that solve each instant by itself.
//!
//! Their coefficients are smooth in t, if sometimes steep at an end of the domain. So the page is given the series at the
//! zeros of a Chebyshev polynomial over the time domain, which crowd at the ends, and interpolates between them, if that
//! is true to what a screen shows; the error is measured at other instants and sent along. Otherwise the page asks for
//! every instant.

use std::sync::Arc;
use std::time::Duration;

use serde::Serialize;

use trimline::diagnostic::Diagnostic;
use trimline::emit::amplitude_series;
use trimline::expr::Derivative;
use trimline::numeric::{ChebyshevSeries, NodeKind, nodes};
use trimline::problem::DomainValues;
use trimline::surface::Surface;

use super::live::Live;
use super::server::Question;
use crate::failure::Failure;
use crate::parts::Located;

/// Numbers of instants tried.
const INSTANTS: [usize; 3] = [12, 48, 192];
/// Instants at which the interpolation is measured, both ends included.
const MEASURED: usize = 8;
/// The largest error allowed, relative to the surface: a tenth of a pixel of a picture that it fills.
const TOLERANCE: f64 = 1e-4;
/// Coefficients below this, relative to the largest, are not sent: far below the tolerance in sum.
const SMALLEST: f64 = 1e-8;
/// Where the error is measured, across and along.
const GRID: [usize; 2] = [9, 13];
/// Between two instants, so that a slider is answered in between.
const PAUSE: Duration = Duration::from_micros(50);

/// The motion of every patch; `None` for one that holds at every t or that cannot be interpolated.
#[derive(Serialize)]
pub struct Motion {
    patches: Vec<Option<Interpolation>>,
}

/// Series at several instants, in single precision.
#[derive(Clone, Serialize)]
struct Interpolation {
    instants: Vec<f64>,
    /// By instant, then degree, function and component, flat.
    amplitudes: Vec<Vec<f32>>,
    /// Degrees of every series.
    terms: usize,
    error: f64,
}

/// A part solved at one instant; of a copy, its original.
struct Sample {
    original: usize,
    surface: Arc<dyn Surface + Send + Sync>,
    domain: DomainValues,
    time: f64,
}

/// The motion for the page's values.
pub fn of(live: &Live, question: &Question) -> Result<Motion, Failure> {
    let revision = *live.revision.borrow();
    let Some(now) = samples(live, question, question.time)? else { return Ok(Motion { patches: Vec::new() }) };
    let mut patches: Vec<Option<Interpolation>> = Vec::with_capacity(now.len());
    for (index, sample) in now.iter().enumerate() {
        if sample.surface.as_separable().is_none_or(|surface| surface.instant.is_none()) {
            patches.push(None);
            continue;
        }
        // A copy moves as its original does; the page puts it where it is.
        if let Some(known) = now.iter().take(index).position(|other| other.original == sample.original) {
            patches.push(patches.get(known).cloned().flatten());
            continue;
        }
        let solved_at = |t: f64| {
            std::thread::sleep(PAUSE);
            let is_edited = *live.revision.borrow() != revision;
            let samples = if is_edited { None } else { samples(live, question, Some(t))? };
            Ok(samples.and_then(|samples| samples.into_iter().nth(index)))
        };
        patches.push(interpolation(sample.domain, solved_at)?);
    }
    Ok(Motion { patches })
}

/// Every patch at one instant; `None` without a surface.
fn samples(live: &Live, question: &Question, time: Option<f64>) -> Result<Option<Vec<Sample>>, Failure> {
    live.answer(&question.changes, time, |answerable, _| {
        let Some(answerable) = answerable else { return Ok(None) };
        let answerable = answerable?;
        let times = answerable.times;
        let samples = answerable.pieces.iter().map(|piece| Sample {
            original: piece.original,
            surface: piece.of.surface(),
            domain: DomainValues { t: times, ..*piece.domain() },
            time: answerable.time,
        });
        Ok(Some(samples.collect()))
    })
}

/// `None` if too many instants would be needed, or the spec was edited meanwhile and `solved_at` has none.
fn interpolation(
    domain: DomainValues,
    solved_at: impl Fn(f64) -> Result<Option<Sample>, Failure>,
) -> Result<Option<Interpolation>, Failure> {
    let fault = |finding: Diagnostic| Failure::Found { source: None, findings: vec![finding] };
    let solved = |kind, count| -> Result<Option<Vec<Sample>>, Failure> {
        nodes(kind, count, domain.t).into_iter().map(|t| solved_at(t).transpose()).collect::<Option<_>>().transpose()
    };
    let Some(judges) = solved(NodeKind::Ends, MEASURED)? else { return Ok(None) };
    for count in INSTANTS {
        let Some(samples) = solved(NodeKind::Chebyshev, count)? else { return Ok(None) };
        let series = samples.iter().map(|sample| {
            sample.surface.as_separable().map(|surface| amplitude_series(surface, domain)).transpose().map_err(fault)
        });
        let Some(series) = series.collect::<Result<Option<Vec<ChebyshevSeries>>, _>>()? else { return Ok(None) };
        let instants: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
        let mut error = 0.0_f64;
        for judge in &judges {
            let here = distance(&instants, &series, judge).map_err(fault)?;
            error = if here <= error { error } else { here };
        }
        if error <= TOLERANCE {
            return Ok(Some(in_single_precision(instants, &series, error)));
        }
    }
    Ok(None)
}

fn in_single_precision(instants: Vec<f64>, series: &[ChebyshevSeries], error: f64) -> Interpolation {
    let rows = || series.iter().flat_map(|series| series.coefficients.iter().enumerate());
    let size = |row: &Vec<f64>| row.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let largest = rows().map(|(_, row)| size(row)).fold(0.0, f64::max);
    let needed = rows().filter(|(_, row)| size(row) > SMALLEST * largest).map(|(degree, _)| degree + 1);
    let terms = needed.max().unwrap_or(1);
    let width = series.first().and_then(|series| series.coefficients.first()).map_or(0, Vec::len);
    let flat = |series: &ChebyshevSeries| {
        let mut values: Vec<f32> = series.coefficients.iter().flatten().map(|value| *value as f32).collect();
        values.resize(terms * width, 0.0);
        values
    };
    Interpolation { instants, amplitudes: series.iter().map(flat).collect(), terms, error }
}

/// The largest distance between the interpolated surface and a solved one, relative to the largest coordinate.
fn distance(instants: &[f64], series: &[ChebyshevSeries], judge: &Sample) -> Result<f64, Diagnostic> {
    let Sample { surface, domain, time, .. } = judge;
    let Some(surface) = surface.as_separable() else { return Ok(f64::INFINITY) };
    let weights = barycentric(instants, *time);
    let (u, v) = (nodes(NodeKind::Midpoints, GRID[0], domain.u), nodes(NodeKind::Ends, GRID[1], domain.v));
    let basis = surface.basis.values(Derivative::NONE, &surface.params, &v, &vec![*time; v.len()])?;
    let mut expected = vec![[0.0; 3]; u.len() * v.len()];
    surface.evaluate_grid(Derivative::NONE, (&u, &v, *time), &mut expected)?;
    let (mut worst, mut size) = (0.0_f64, f64::MIN_POSITIVE);
    for (u, row) in u.iter().zip(expected.chunks(v.len())) {
        let mut amplitudes = vec![0.0; 3 * surface.basis.len()];
        for (series, weight) in series.iter().zip(&weights) {
            amplitudes.iter_mut().zip(series.values(*u)).for_each(|(sum, value)| *sum += weight * value);
        }
        for (column, expected) in row.iter().enumerate() {
            for (component, expected) in expected.iter().enumerate() {
                let of_component = amplitudes.iter().skip(component).step_by(3);
                let at_column = basis.iter().skip(column).step_by(v.len());
                let found: f64 = of_component.zip(at_column).map(|(g, f)| g * f).sum();
                worst = if (found - expected).abs() <= worst { worst } else { (found - expected).abs() };
                size = size.max(expected.abs());
            }
        }
    }
    Ok(worst / size)
}

/// What each node contributes to the polynomial through values at the zeros of a Chebyshev polynomial.
fn barycentric(instants: &[f64], t: f64) -> Vec<f64> {
    if let Some(hit) = instants.iter().position(|instant| *instant == t) {
        return (0..instants.len()).map(|k| f64::from(u8::from(k == hit))).collect();
    }
    let count = instants.len() as f64;
    let weights: Vec<f64> = instants
        .iter()
        .enumerate()
        .map(|(k, instant)| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            sign * (std::f64::consts::PI * (k as f64 + 0.5) / count).sin() / (t - instant)
        })
        .collect();
    let total: f64 = weights.iter().sum();
    weights.into_iter().map(|weight| weight / total).collect()
}
