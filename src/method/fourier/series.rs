//! Boundary data, or functions of a force, at one instant as trigonometric series in v.
//!
//! `g_i(v) = p_i(v) + A_0 + Σ_{n <= N} A_n cos nκv + B_n sin nκv + d_i(v)` with κ the wave number of one turn over the
//! range of v (docs/methods.md, F1), and p_i the polynomial of what is not periodic ([`Ends`]). Coefficients come from equally spaced samples, whose number is doubled until those
//! beyond N no longer count; what is left out is measured between the samples, not estimated from the coefficients.

use std::sync::{Arc, OnceLock};

use super::ends::{Ends, MOST_DERIVATIVES};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId, Graph, Notation, Number};
use crate::features::{Features, locate};
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

/// Functions of v and t that are to be expanded, compiled: the prescribed values of every condition and component, or a
/// function of a force.
pub struct SeriesData {
    /// What they are.
    subject: String,
    values: Arc<dyn Evaluator>,
    graph: Graph,
    outputs: Vec<ExprId>,
    /// Derivatives in v of all values, of order 1 and so on, as far as all have them; compiled when they are asked for.
    slopes: OnceLock<Vec<Arc<dyn Evaluator>>>,
    /// What each value is called, and where it is written.
    names: Vec<(String, Option<Span>)>,
    /// Whether any of them depends on t.
    pub varies_in_time: bool,
}

/// Truncated series of all functions of a [`SeriesData`].
pub struct Series {
    /// What is expanded.
    pub subject: String,
    /// κ: 2π over the length of the range of v.
    pub wave_number: f64,
    /// The pairs `[A_n, B_n]`, n = 0 … N, of each function: x, y and z of the first condition, then of the second.
    pub coefficients: Vec<Vec<[f64; 2]>>,
    /// The largest part that is left out: `max |d_i|`.
    pub left_out: f64,
    /// What of it may be rounding of the waves' angles, which are as large as v.
    pub rounding: f64,
    /// v where most is left out of each condition and component of which anything is.
    pub places: Vec<f64>,
    /// Where the data are written of which it is left out.
    pub origin: Option<Span>,
    /// The largest value.
    pub size: f64,
    /// The largest jump of a slope where the range of v closes.
    pub corner: f64,
    /// The polynomials of what is not periodic; `None` if all is.
    pub ends: Option<Ends>,
}

impl Series {
    /// N.
    pub fn modes(&self) -> usize {
        self.coefficients.first().map_or(0, |pairs| pairs.len().saturating_sub(1))
    }

    /// Whether no more is left out than `tolerance` allows, and rounding.
    pub fn keeps(&self, tolerance: f64) -> bool {
        self.left_out <= 4.0 * tolerance * self.size + self.rounding
    }
}

/// Values at both ends that differ by more than this share of the largest one are no rounding errors.
const SAME: f64 = 1e-12;
/// Samples to begin with.
const FEWEST: usize = 64;
/// Samples at most, for coefficients of data with jumps, which no number of samples makes exact.
const MOST: usize = 1 << 14;

impl SeriesData {
    /// Compiles the boundary data of `decomposition`.
    pub fn of_boundary(decomposition: &Decomposition) -> SeriesData {
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
        SeriesData::new("the boundary data".to_owned(), graph, outputs, each.map(name).collect())
    }

    /// Compiles one function of a force, which reads `text` and is stated at `origin`.
    pub fn of_force(graph: &Graph, function: ExprId, text: &str, origin: Option<Span>) -> SeriesData {
        let name = format!("`{text}` in the force");
        SeriesData::new(name.clone(), graph, vec![function], vec![(name, origin)])
    }

    fn new(subject: String, graph: &Graph, outputs: Vec<ExprId>, names: Vec<(String, Option<Span>)>) -> SeriesData {
        SeriesData {
            subject,
            varies_in_time: outputs.iter().any(|expr| graph.dependence(*expr).t),
            values: compile(Program::compile(graph, &outputs), Backend::Interpreter).0,
            names,
            slopes: OnceLock::new(),
            graph: graph.clone(),
            outputs,
        }
    }

    /// See [`SeriesData::slopes`].
    fn slopes(&self) -> &[Arc<dyn Evaluator>] {
        self.slopes.get_or_init(|| {
            let mut graph = self.graph.clone();
            let derivatives = |order: usize, graph: &mut Graph| -> Option<Vec<ExprId>> {
                let derivative = Derivative::new(0, order, 0);
                self.outputs.iter().map(|expr| graph.derivative(*expr, derivative).ok()).collect()
            };
            let existing = (1..=MOST_DERIVATIVES).map_while(|order| derivatives(order, &mut graph));
            let existing: Vec<Vec<ExprId>> = existing.collect();
            let compiled = |exprs: &Vec<ExprId>| compile(Program::compile(&graph, exprs), Backend::Interpreter).0;
            existing.iter().map(compiled).collect()
        })
    }

    /// Values at `v`, one list for each condition and component.
    fn at(&self, v: &[f64], t: f64, params: &[f64]) -> Result<Vec<Vec<f64>>, Diagnostic> {
        self.evaluated(&*self.values, v, t, params)
    }

    /// Values or derivatives, whichever `evaluator` computes.
    fn evaluated(
        &self,
        evaluator: &dyn Evaluator,
        v: &[f64],
        t: f64,
        params: &[f64],
    ) -> Result<Vec<Vec<f64>>, Diagnostic> {
        let mut values = vec![0.0; evaluator.program().outputs() * v.len()];
        evaluator
            .evaluate(params, Samples { u: v, v, t: &vec![t; v.len()] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            let (name, origin) = self.name(at / v.len().max(1));
            let (value, v) = (values.get(at).copied(), v.get(at % v.len().max(1)).copied());
            let [value, v, t] = [value, v, Some(t)].map(|number| Shortest(number.unwrap_or(f64::NAN)));
            return Err(Diagnostic::new(Code::DataNotFinite, format!("{name} is {value} at v = {v}, t = {t}"))
                .at(origin)
                .hint("it must be finite on the whole domain; change the function or the domain"));
        }
        Ok(values.chunks(v.len().max(1)).map(<[f64]>::to_vec).collect())
    }

    fn name(&self, index: usize) -> (&str, Option<Span>) {
        self.names.get(index).map_or(("?", None), |(name, origin)| (name.as_str(), *origin))
    }

    /// Whether each value is the same at both ends of the range of v, up to rounding; and the values there.
    fn periodicity(&self, [low, high]: [f64; 2], t: f64, params: &[f64]) -> Result<Vec<(bool, [f64; 2])>, Diagnostic> {
        // A few values between tell how large the data are.
        let between = [0.0, 0.13, 0.31, 0.55, 0.79, 0.93, 1.0].map(|share| low * (1.0 - share) + high * share);
        let compared = |values: Vec<f64>| {
            let size = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let ends = [values.first(), values.last()].map(|end| end.copied().unwrap_or(f64::NAN));
            ((ends[0] - ends[1]).abs() <= SAME * size, ends)
        };
        Ok(self.at(&between, t, params)?.into_iter().map(compared).collect())
    }

    /// Refuses data whose values at both ends of the range of v differ by more than rounding.
    ///
    /// # Errors
    /// [`Code::UnsupportedByMethod`] with the values; [`Code::DataNotFinite`].
    pub fn check_periodic(&self, [low, high]: [f64; 2], t: f64, params: &[f64]) -> Result<(), Diagnostic> {
        for (index, (is_periodic, [first, last])) in self.periodicity([low, high], t, params)?.into_iter().enumerate() {
            if !is_periodic {
                let (name, origin) = self.name(index);
                let message = format!(
                    "{name} is not periodic over the range of v: {} at v = {} and {} at v = {}",
                    short(first),
                    short(low),
                    short(last),
                    short(high)
                );
                return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(origin));
            }
        }
        Ok(())
    }

    /// The polynomials that leave of the values at instant `t` what is periodic.
    fn ends(&self, range: [f64; 2], t: f64, params: &[f64]) -> Result<Option<Ends>, Diagnostic> {
        let periodicity = self.periodicity(range, t, params)?;
        if periodicity.iter().all(|(is_periodic, _)| *is_periodic) {
            return Ok(None);
        }
        let mut given = vec![self.at(&range, t, params)?];
        for evaluator in self.slopes() {
            given.push(self.evaluated(&**evaluator, &range, t, params)?);
        }
        let is_open: Vec<bool> = periodicity.iter().map(|(is_periodic, _)| !is_periodic).collect();
        Ok(Ends::new(range, &given, &is_open))
    }

    /// The values at `v` less the polynomials of `ends`, one list for each condition and component.
    fn periodic_part(
        &self,
        ends: Option<&Ends>,
        v: &[f64],
        t: f64,
        params: &[f64],
    ) -> Result<Vec<Vec<f64>>, Diagnostic> {
        let mut values = self.at(v, t, params)?;
        if let Some(ends) = ends {
            for (index, list) in values.iter_mut().enumerate() {
                list.iter_mut().zip(v).for_each(|(value, v)| *value -= ends.value(index, *v));
            }
        }
        Ok(values)
    }

    /// The series of all values at instant `t`.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`].
    pub fn series(&self, length: Length, range: [f64; 2], t: f64, params: &[f64]) -> Result<Series, Diagnostic> {
        self.series_less(self.ends(range, t, params)?, length, range, t, params)
    }

    /// The same without polynomials, for values that jump where the range closes rather than do not close.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`].
    pub fn periodic_series(
        &self,
        length: Length,
        range: [f64; 2],
        t: f64,
        params: &[f64],
    ) -> Result<Series, Diagnostic> {
        self.series_less(None, length, range, t, params)
    }

    /// The series of what the polynomials of `ends` leave.
    fn series_less(
        &self,
        ends: Option<Ends>,
        length: Length,
        range: [f64; 2],
        t: f64,
        params: &[f64],
    ) -> Result<Series, Diagnostic> {
        // No number of samples need meet what is narrow; the measurement of what is left out must.
        let narrow = Features::refined(&locate(&self.graph, &self.outputs, params, [range; 2], t).v, &[], range);
        let of_narrow = self.at(&narrow, t, params)?.into_iter().flatten();
        let size_of_narrow = of_narrow.fold(0.0_f64, |most, value| most.max(value.abs()));
        let mut count = FEWEST;
        let mut before: Option<Vec<Vec<[f64; 2]>>> = None;
        loop {
            let places = spaced(range, count, 0.0);
            let whole = self.at(&places, t, params)?;
            let size = whole.iter().flatten().fold(size_of_narrow, |most, value| most.max(value.abs()));
            let samples = if ends.is_some() { self.periodic_part(ends.as_ref(), &places, t, params)? } else { whole };
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
                let series =
                    self.truncated((&coefficients, ends.as_ref()), (modes, size), (range, &narrow), t, params)?;
                // A function between whose samples nothing can be seen is seen by the points of the measurement.
                let is_true = match length {
                    Length::Adaptive(tolerance, most) => series.keeps(tolerance) || count >= MOST.max(8 * most),
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

    /// The first `modes` of `coefficients`, turned to begin at v = 0, and what they leave out, measured at `narrow` places too.
    fn truncated(
        &self,
        (coefficients, ends): (&[Vec<[f64; 2]>], Option<&Ends>),
        (modes, size): (usize, f64),
        (range, narrow): ([f64; 2], &[f64]),
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
        v.extend(narrow);
        let (mut left_out, mut worst, mut places) = (0.0_f64, 0, Vec::new());
        for (index, (pairs, values)) in kept.iter().zip(self.periodic_part(ends, &v, t, params)?).enumerate() {
            let (mut most, mut place) = (0.0_f64, None);
            for (v, value) in v.iter().zip(values) {
                let here = (value - sum(pairs, wave_number * v)).abs();
                if here > most {
                    (most, place) = (here, Some(*v));
                }
            }
            places.extend(place);
            if most > left_out {
                (left_out, worst) = (most, index);
            }
        }
        let corner = self.corner(ends, range, t, params)?;
        let slope = |pairs: &Vec<[f64; 2]>| -> f64 {
            pairs.iter().enumerate().map(|(n, [a, b])| n as f64 * wave_number * a.hypot(*b)).sum()
        };
        let steepest = kept.iter().map(slope).fold(0.0, f64::max);
        let farthest = range[0].abs().max(range[1].abs());
        Ok(Series {
            subject: self.subject.clone(),
            wave_number,
            coefficients: kept,
            left_out,
            rounding: 2.0 * f64::EPSILON * farthest * steepest,
            places,
            origin: self.name(worst).1,
            size,
            corner,
            ends: ends.cloned(),
        })
    }

    /// The largest jump of a slope where the range closes, by one-sided differences. Those of smooth data shrink with the
    /// step, however fast the data vary; those of a jump do not.
    fn corner(&self, ends: Option<&Ends>, [low, high]: [f64; 2], t: f64, params: &[f64]) -> Result<f64, Diagnostic> {
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
        Ok(self.periodic_part(ends, &places, t, params)?.into_iter().map(jump).fold(0.0, f64::max))
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

/// A coefficient of the series of `subject` as an expression.
///
/// # Errors
/// [`Code::DataNotFinite`] for one that left the doubles.
pub fn constant(graph: &mut Graph, value: f64, subject: &str) -> Result<ExprId, Diagnostic> {
    Number::from_f64(value).map(|number| graph.number(number)).ok_or_else(|| {
        Diagnostic::new(Code::DataNotFinite, format!("a coefficient of the series of {subject} is {value}"))
            .hint("the values and their derivatives in v overflow; bring the data to ordinary sizes")
    })
}

/// The x, y and z of which all exist.
pub fn vector(mut component: impl FnMut(usize) -> Result<ExprId, Diagnostic>) -> Result<[ExprId; 3], Diagnostic> {
    Ok([component(0)?, component(1)?, component(2)?])
}

/// Six digits, for messages.
fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    if value != 0.0 && (value.abs() < 1e-3 || value.abs() >= 1e6) { format!("{value:.5e}") } else { text }
}
