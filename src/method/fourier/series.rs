//! The boundary data at one instant as trigonometric series in v.
//!
//! `g_i(v) = A_0 + Σ_{n <= N} A_n cos nκv + B_n sin nκv + d_i(v)` with κ the wave number of one turn over the range of
//! v (docs/methods.md, F1). Coefficients come from equally spaced samples, whose number is doubled until those
//! beyond N no longer count; what is left out is measured between the samples, not estimated from the coefficients.

use std::sync::Arc;

use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{ExprId, Notation};
use crate::numeric::trigonometric_coefficients;
use crate::problem::describe_condition;

/// How many modes to take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Length {
    /// As many as it takes to leave out no more than this share of the largest value, up to so many.
    Adaptive(f64, usize),
    /// This many.
    Fixed(usize),
}

/// The prescribed values of every condition and component, compiled.
pub struct BoundaryData {
    values: Arc<dyn Evaluator>,
    /// What each value is called, and where it is written.
    names: Vec<(String, Option<Span>)>,
    /// Whether any of them depends on t.
    pub varies_in_time: bool,
}

/// Truncated series of all prescribed values.
pub struct Series {
    /// κ: 2π over the length of the range of v.
    pub wave_number: f64,
    /// The pairs `[A_n, B_n]`, n = 0 … N, of x, y and z of the first condition, then of the second.
    pub coefficients: Vec<Vec<[f64; 2]>>,
    /// The largest part that is left out: `max |d_i|`.
    pub left_out: f64,
    /// Where the data are written of which it is left out.
    pub origin: Option<Span>,
    /// The largest prescribed value.
    pub size: f64,
    /// The largest jump of a slope where the range of v closes.
    pub corner: f64,
}

impl Series {
    /// N.
    pub fn modes(&self) -> usize {
        self.coefficients.first().map_or(0, |pairs| pairs.len().saturating_sub(1))
    }
}

/// Values at both ends that differ by more than this share of the largest one are no rounding errors.
const SAME: f64 = 1e-12;
/// Samples to begin with.
const FEWEST: usize = 64;
/// Samples at most, for coefficients of data with jumps, which no number of samples makes exact.
const MOST: usize = 1 << 14;

impl BoundaryData {
    /// Compiles the data of `decomposition`.
    pub fn compile(decomposition: &Decomposition) -> BoundaryData {
        let graph = &decomposition.graph;
        let conditions = &decomposition.patch.conditions;
        let outputs: Vec<ExprId> = conditions.iter().flat_map(|condition| condition.value).collect();
        let name = |(index, condition): (usize, &crate::problem::BoundaryCondition)| {
            let component = index % 3;
            let text = condition.value.get(component).map(|expr| graph.text(*expr, Notation::Ascii, 80));
            let text = text.and_then(Result::ok).unwrap_or_else(|| "a long expression".to_owned());
            let position = graph.value(condition.u, &[], [f64::NAN; 3]);
            let what = if position.is_finite() {
                describe_condition(Some(component), condition.order, position)
            } else {
                "its trimline".to_owned()
            };
            (format!("`{text}` ({what})"), condition.origins.get(component).copied().flatten())
        };
        let each = conditions.iter().flat_map(|condition| [condition; 3]).enumerate();
        BoundaryData {
            varies_in_time: outputs.iter().any(|expr| graph.dependence(*expr).t),
            values: compile(Program::compile(graph, &outputs), Backend::Interpreter).0,
            names: each.map(name).collect(),
        }
    }

    /// Values at `v`, one list for each condition and component.
    fn at(&self, v: &[f64], t: f64, params: &[f64]) -> Result<Vec<Vec<f64>>, Diagnostic> {
        let mut values = vec![0.0; self.values.program().outputs() * v.len()];
        self.values
            .evaluate(params, Samples { u: v, v, t: &vec![t; v.len()] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            let (name, origin) = self.name(at / v.len().max(1));
            let (value, v) = (values.get(at).copied(), v.get(at % v.len().max(1)).copied());
            let [value, v] = [value, v].map(|number| number.unwrap_or(f64::NAN));
            return Err(Diagnostic::new(Code::DataNotFinite, format!("{name} is {value} at v = {v}, t = {t}"))
                .at(origin)
                .hint("boundary data must be finite on the whole domain; change the function or the domain"));
        }
        Ok(values.chunks(v.len().max(1)).map(<[f64]>::to_vec).collect())
    }

    fn name(&self, index: usize) -> (&str, Option<Span>) {
        self.names.get(index).map_or(("?", None), |(name, origin)| (name.as_str(), *origin))
    }

    /// Refuses data whose values at both ends of the range of v differ by more than rounding.
    ///
    /// # Errors
    /// [`Code::UnsupportedByMethod`] with the values; [`Code::DataNotFinite`].
    pub fn check_periodic(&self, [low, high]: [f64; 2], t: f64, params: &[f64]) -> Result<(), Diagnostic> {
        // A few values between tell how large the data are.
        let between = [0.0, 0.13, 0.31, 0.55, 0.79, 0.93, 1.0].map(|share| low * (1.0 - share) + high * share);
        for (index, values) in self.at(&between, t, params)?.into_iter().enumerate() {
            let size = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let [first, .., last] = values.as_slice() else { continue };
            if (first - last).abs() > SAME * size {
                let (name, origin) = self.name(index);
                let message = format!(
                    "{name} is not periodic over the range of v: {} at v = {} and {} at v = {}",
                    short(*first),
                    short(low),
                    short(*last),
                    short(high)
                );
                return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(origin));
            }
        }
        Ok(())
    }

    /// The series of all values at instant `t`.
    ///
    /// # Errors
    /// As [`BoundaryData::check_periodic`].
    pub fn series(&self, length: Length, range: [f64; 2], t: f64, params: &[f64]) -> Result<Series, Diagnostic> {
        self.check_periodic(range, t, params)?;
        let mut count = FEWEST;
        let mut before: Option<Vec<Vec<[f64; 2]>>> = None;
        loop {
            let samples = self.at(&spaced(range, count, 0.0), t, params)?;
            let size = samples.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
            let coefficients = trigonometric_coefficients(&samples);
            let (modes, is_settled) = match length {
                Length::Adaptive(tolerance, most) => {
                    let needed = shortest(&coefficients, tolerance * size);
                    let is_seen = needed.is_some_and(|needed| needed <= (count / 4).min(most));
                    (needed.unwrap_or(most).min(most), is_seen || count >= MOST.max(8 * most))
                }
                Length::Fixed(modes) => {
                    let is_settled =
                        before.as_ref().is_some_and(|before| change(before, &coefficients, modes) <= 1e-14 * size);
                    (modes, (is_settled && count >= 8 * modes) || count >= MOST.max(8 * modes))
                }
            };
            if is_settled && modes < count / 2 {
                let series = self.truncated(&coefficients, modes, size, range, t, params)?;
                // A function between whose samples nothing can be seen is seen by the points of the measurement.
                let is_true = match length {
                    Length::Adaptive(tolerance, most) => {
                        series.left_out <= 4.0 * tolerance * size || count >= MOST.max(8 * most)
                    }
                    Length::Fixed(_) => true,
                };
                if is_true {
                    return Ok(series);
                }
            }
            before = Some(coefficients);
            count *= 2;
        }
    }

    /// The first `modes` of `coefficients`, turned to begin at v = 0, and what they leave out.
    fn truncated(
        &self,
        coefficients: &[Vec<[f64; 2]>],
        modes: usize,
        size: f64,
        range: [f64; 2],
        t: f64,
        params: &[f64],
    ) -> Result<Series, Diagnostic> {
        let wave_number = std::f64::consts::TAU / (range[1] - range[0]);
        // Rounding errors of the samples are no part of the data, and high modes may amplify them.
        let noise = 4.0 * f64::EPSILON * size;
        let turned = |(n, [a, b]): (usize, &[f64; 2])| {
            let angle = n as f64 * wave_number * range[0];
            let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
            [a * cosine - b * sine, a * sine + b * cosine].map(|value| if value.abs() <= noise { 0.0 } else { value })
        };
        let kept: Vec<Vec<[f64; 2]>> =
            coefficients.iter().map(|pairs| pairs.iter().take(modes + 1).enumerate().map(turned).collect()).collect();
        // Incommensurable with the samples; and the ends, where slopes may jump and the error has its peak.
        let mut v = spaced(range, (8 * modes + 97).max(257), 0.381_966);
        v.extend(range);
        let (mut left_out, mut worst) = (0.0_f64, 0);
        for (index, (pairs, values)) in kept.iter().zip(self.at(&v, t, params)?).enumerate() {
            for (v, value) in v.iter().zip(values) {
                let here = (value - sum(pairs, wave_number * v)).abs();
                if here > left_out {
                    (left_out, worst) = (here, index);
                }
            }
        }
        let corner = self.corner(range, t, params)?;
        Ok(Series { wave_number, coefficients: kept, left_out, origin: self.name(worst).1, size, corner })
    }

    /// The largest jump of a slope where the range closes, by one-sided differences. Those of smooth data shrink with the
    /// step, however fast the data vary; those of a jump do not.
    fn corner(&self, [low, high]: [f64; 2], t: f64, params: &[f64]) -> Result<f64, Diagnostic> {
        let steps = [1.0, 0.5, 0.25].map(|share| share * 1e-6 * (high - low));
        let places: Vec<f64> = steps.iter().flat_map(|step| [low, low + step, high - step, high]).collect();
        let jump = |values: Vec<f64>| {
            let jumps = values.chunks(4).zip(steps).map(|(values, step)| match values {
                [first, second, third, fourth] => ((second - first) - (fourth - third)).abs() / step,
                _ => 0.0,
            });
            let (least, most) =
                jumps.fold((f64::INFINITY, 0.0_f64), |(low, high), jump| (low.min(jump), high.max(jump)));
            if least >= 0.9 * most { most } else { 0.0 }
        };
        Ok(self.at(&places, t, params)?.into_iter().map(jump).fold(0.0, f64::max))
    }
}

/// `count` points over one turn, the first `shift` of a step behind its beginning.
fn spaced([low, high]: [f64; 2], count: usize, shift: f64) -> Vec<f64> {
    (0..count).map(|j| low + (high - low) * ((j as f64 + shift) / count as f64)).collect()
}

/// The number of modes beyond which the coefficients of every series add up to no more than `allowed`.
fn shortest(coefficients: &[Vec<[f64; 2]>], allowed: f64) -> Option<usize> {
    let mut needed = 0;
    for pairs in coefficients {
        let mut tail = 0.0;
        for (n, [a, b]) in pairs.iter().enumerate().rev() {
            tail += a.abs() + b.abs();
            if tail > allowed {
                // The highest one known says nothing about those above it.
                needed = if n + 1 == pairs.len() { return None } else { needed.max(n) };
                break;
            }
        }
    }
    Some(needed)
}

/// The largest difference of the first `modes` coefficients.
fn change(before: &[Vec<[f64; 2]>], now: &[Vec<[f64; 2]>], modes: usize) -> f64 {
    let pairs = before.iter().zip(now).flat_map(|(a, b)| a.iter().zip(b).take(modes + 1));
    pairs.fold(0.0, |most, ([a, b], [c, d])| most.max((a - c).abs()).max((b - d).abs()))
}

/// `A_0 + Σ A_n cos nθ + B_n sin nθ`
fn sum(pairs: &[[f64; 2]], angle: f64) -> f64 {
    let terms = pairs.iter().enumerate().filter(|(_, pair)| **pair != [0.0; 2]);
    terms.map(|(n, [a, b])| a * libm::cos(n as f64 * angle) + b * libm::sin(n as f64 * angle)).sum()
}

/// Six digits, for messages.
fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    if value != 0.0 && (value.abs() < 1e-3 || value.abs() >= 1e6) { format!("{value:.5e}") } else { text }
}
