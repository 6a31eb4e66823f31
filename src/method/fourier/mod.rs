//! Fourier series along v: boundary data and forces of any functions of v, for equations with coefficients that depend on
//! neither v nor t (González Castro, Ugail, Willis and Palmer 2006, corrected; docs/methods.md, F1 to F6).
//!
//! Each wave number is a problem of its own, solved exactly: by the equation's own exponentials where it is
//! `(∂²/∂u² + a² ∂²/∂v²)^m S = 0`, by [`exact`](super::exact) otherwise, for which a truncated series is a problem with
//! a finite closure. What the series leaves out of the data is carried across the blend by the functions of the next
//! wave number, the remainder, so that the boundary is met; the remainder does not solve the equation.
//!
//! t is a parameter: each instant has its own series.

mod ends;
mod force;
mod modal;
mod reach;
mod series;

use std::sync::Arc;

use super::exact::Exact;
use super::{Method, Numbers, Options, Report, Settings, Solution, Solver, Truncation};
use crate::decompose::{Decomposition, close};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::ExprId;
use crate::limits::Limits;
use crate::surface::SeparableSurface;
use crate::trial::{CardinalExponentials, Modes};

use force::Force;
use modal::{Assembly, Numerals};
use series::{Length, Series, SeriesData};

/// The method `fourier`.
pub struct Fourier;

const DEFAULT_TOLERANCE: f64 = 1e-12;

/// The smallest tolerance: rounding leaves out as much.
pub const LEAST_TOLERANCE: f64 = 1e-14;

/// A sum of sizes of the position functions from which on high modes are worth a warning: at three a digit is lost
/// within a few wave numbers more.
const AMPLIFYING: f64 = 3.0;

impl Method for Fourier {
    fn name(&self) -> &'static str {
        "fourier"
    }

    fn description(&self) -> &'static str {
        "Fourier series of data along v, exact for each wave number (Gonzalez Castro et al. 2006, corrected)"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["modes", "remainder", "tolerance"]
    }

    fn accepts(&self, decomposition: &Decomposition, limits: &Limits) -> Result<(), Diagnostic> {
        let (graph, operator) = (&decomposition.graph, &decomposition.operator);
        let refuse = |message: &str| Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(operator.origin));
        let depends = |expr: ExprId| graph.dependence(expr).v || graph.dependence(expr).t;
        if operator.terms.iter().flat_map(|term| term.coefficient).any(depends) {
            return refuse("the method `fourier` needs coefficients that do not depend on v or t");
        }
        if operator.order_in_t() > 0 {
            return refuse("the method `fourier` cannot treat derivatives in t: each instant is solved alone");
        }
        Force::compile(decomposition, limits).map(|_| ())
    }

    fn suits(&self, decomposition: &Decomposition, numbers: &Numbers<'_>, limits: &Limits) -> Result<(), Diagnostic> {
        let data = SeriesData::of_boundary(decomposition);
        let force = Force::compile(decomposition, limits)?;
        let [start, end] = numbers.domain.t;
        let is_moving = data.varies_in_time || force.varies_in_time();
        let instants = if is_moving { vec![start, 0.5 * (start + end), end] } else { vec![start] };
        let length = Length::Adaptive(DEFAULT_TOLERANCE, limits.modes);
        for &t in &instants {
            let series = force.series(&data, length, numbers.domain.v, t, numbers.params)?;
            series.iter().try_for_each(|series| refuse_divergence(length, series))?;
        }
        if force.is_open() && boundary_closes(decomposition, limits) {
            return Ok(());
        }
        let are_periodic =
            instants.into_iter().try_for_each(|t| data.check_periodic(numbers.domain.v, t, numbers.params));
        // Data that do not close are for other methods, but for those without the derivatives that these need.
        match are_periodic {
            Err(reason)
                if reason.code == Code::UnsupportedByMethod && decomposition.check_differentiable().is_err() =>
            {
                Ok(())
            }
            checked => checked,
        }
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let graph = &decomposition.graph;
        let operator = &decomposition.operator;
        let positions = decomposition.patch.conditions.iter().map(|condition| condition.u);
        let stated = decomposition.coefficients.iter().flatten().flatten().copied();
        let factors = operator.terms.iter().flat_map(|term| term.coefficient);
        let constants: Vec<ExprId> = positions.chain(stated).chain(factors).collect();
        let has_varying = operator.terms.iter().flat_map(|term| term.coefficient).any(|expr| graph.dependence(expr).u);
        let remainder = remainder(decomposition, options)?;
        let has_remainder = remainder.is_some();
        let carrying = remainder.unwrap_or_else(|| decomposition.clone());
        Ok(Box::new(FourierSolver {
            length: length(options)?,
            has_remainder,
            data: SeriesData::of_boundary(decomposition),
            force: Force::compile(&carrying, &options.limits)?,
            boundary_closes: boundary_closes(decomposition, &options.limits),
            constant_values: compile(Program::compile(graph, &constants), Backend::Interpreter).0,
            // The closed form is one of constant coefficients and no force.
            may_be_modal: !has_varying && operator.is_homogeneous(graph),
            decomposition: carrying,
            options: options.clone(),
        }))
    }
}

/// Whether `exact` can treat the boundary data as they are.
fn boundary_closes(decomposition: &Decomposition, limits: &Limits) -> bool {
    let mut without_force = decomposition.clone();
    without_force.operator.force = [without_force.graph.integer(0); 3];
    close(&without_force, limits).is_ok()
}

/// Refuses a function that as many modes as are allowed do not come near: it jumps, has a pole, or varies too fast.
fn refuse_divergence(length: Length, series: &Series) -> Result<(), Diagnostic> {
    if matches!(length, Length::Fixed(_)) || series.left_out <= LARGEST_PART_LEFT_OUT * series.size {
        return Ok(());
    }
    let (modes, left_out, subject, size) = (series.modes(), series.left_out, &series.subject, series.size);
    let message =
        format!("a Fourier series of {modes} modes leaves out {left_out:.1e} of {subject} of size {size:.1e}");
    Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(series.origin).hint(
        "data that jump or have a pole in the domain of v have no useful series; fast ones need a higher limit `modes`",
    ))
}

/// The number of modes that the settings ask for.
fn length(options: &Options) -> Result<Length, Diagnostic> {
    let limit = options.limits.modes;
    if let Some((tolerance, origin)) = options.settings.tolerance
        && !(LEAST_TOLERANCE..=1e-2).contains(&tolerance)
    {
        let tolerance = Shortest(tolerance);
        let message = format!("the tolerance {tolerance} lies outside [1e-14, 1e-2]");
        return Err(Diagnostic::new(Code::SettingOutOfRange, message).at(origin));
    }
    match (options.settings.modes, options.settings.tolerance) {
        (None, tolerance) => {
            Ok(Length::Adaptive(tolerance.map_or(DEFAULT_TOLERANCE, |(tolerance, _)| tolerance), limit))
        }
        (Some((_, origin)), Some((_, other))) => {
            let finding = Diagnostic::new(Code::UnknownSetting, "`modes` and `tolerance` exclude each other");
            Err(finding.at(origin.or(other)).hint("a number of modes is taken as it is; a tolerance finds one"))
        }
        (Some((modes, origin)), None) if modes > limit => {
            let message = format!("{modes} modes are above the limit `modes` of {limit}");
            Err(Diagnostic::new(Code::LimitReached, message).at(origin))
        }
        (Some((modes, _)), None) => Ok(Length::Fixed(modes)),
    }
}

/// The decomposition with the functions of the remainder; `None` if there is to be none. The remainder has the derivatives
/// of the data: of splines those of their pieces, and without any there is no remainder.
fn remainder(decomposition: &Decomposition, options: &Options) -> Result<Option<Decomposition>, Diagnostic> {
    if options.settings.remainder.is_some_and(|(is_on, _)| !is_on) {
        return Ok(None);
    }
    let Err(fault) = decomposition.check_differentiable() else {
        return Ok(Some(decomposition.clone()));
    };
    match (decomposition.piecewise(&options.limits), options.settings.remainder) {
        (None, Some(_)) => Err(fault.hint("a series alone needs no derivatives: `remainder = off`")),
        (piecewise, _) => Ok(piecewise),
    }
}

/// Of the size of the data: a corner, the roughest data that make sense, leaves out less with 64 modes.
const LARGEST_PART_LEFT_OUT: f64 = 0.1;

/// The largest share that series of a force leave out; `None` without any.
fn share_left_out(forces: &[Series]) -> Option<f64> {
    let share = |series: &Series| if series.size > 0.0 { series.left_out / series.size } else { 0.0 };
    forces.iter().map(share).reduce(f64::max)
}

struct FourierSolver {
    length: Length,
    has_remainder: bool,
    data: SeriesData,
    force: Force,
    /// Whether the boundary data have a finite closure.
    boundary_closes: bool,
    /// Positions, coefficients of the boundary data, coefficients of the equation.
    constant_values: Arc<dyn Evaluator>,
    may_be_modal: bool,
    decomposition: Decomposition,
    options: Options,
}

impl Solver for FourierSolver {
    fn solve(&self, params: &[f64], [range_u, range_v]: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let forces = self.force.series(&self.data, self.length, range_v, t, params)?;
        forces.iter().try_for_each(|series| refuse_divergence(self.length, series))?;
        if self.force.is_open() && self.boundary_closes {
            return self.solve_for_force(&forces, (params, [range_u, range_v], t));
        }
        let series = self.data.series(self.length, range_v, t, params)?;
        refuse_divergence(self.length, &series)?;
        let numerals = self.numerals(params, range_u)?;
        let mut warnings = Diagnostics::new();
        let truncated = self.force.truncated(&self.decomposition, &forces)?;
        let mut assembly = Assembly::new(&truncated, &series);
        let rates = if self.may_be_modal { numerals.rates() } else { None };
        let mut amplification = None;
        match &rates {
            Some(rates) => assembly.add_modes(&numerals, &series, rates)?,
            None => {
                let options = self.exact_options(forces.iter().chain([&series]));
                let exact = assembly.add_exact(&truncated, &series, &options, (params, [range_u, range_v], t))?;
                warnings.extend(exact.warnings);
                amplification = exact.amplification;
            }
        }
        if let Some(ends) = &series.ends {
            let solution = ends.solve(&self.decomposition, &self.options, (params, range_u, t))?;
            warnings.extend(solution.report.warnings.iter().cloned());
            warnings.extend(self.boundary_reach((&series, ends, &solution), (params, [range_u, range_v], t))?);
            assembly.add_ends(ends, solution.separable()?);
        }
        let decay = rates.unwrap_or_else(|| numerals.decay());
        if self.has_remainder {
            assembly.add_remainder(&numerals, &series, &decay, &self.decomposition)?;
        }
        let highest = series.modes() + usize::from(self.has_remainder);
        let carried = if self.has_remainder { "; the remainder carries it" } else { ", which the surface misses" };
        warnings.extend(self.truncation_warning(&series, carried));
        warnings.extend(self.force_warnings(&forces));
        warnings.extend(self.force_reach(&forces, (params, [range_u, range_v], t))?);
        warnings.extend(self.position_warning(&numerals, &decay, series.wave_number * highest as f64));
        let instant = (self.data.varies_in_time || self.force.varies_in_time()).then_some(t);
        let unknowns = numerals.functionals.len() * (2 * series.modes() + 1);
        let surface = assembly.finish(params, instant, &self.options)?;
        let report = Report {
            method: Fourier.name(),
            is_exact: false,
            basis_size: self.decomposition.basis.len(),
            closure_size: None,
            modes: series.modes(),
            condition: None,
            amplification,
            truncation: Some(Truncation {
                left_out: series.left_out,
                of_force: share_left_out(&forces),
                places: series.places,
                has_remainder: self.has_remainder,
            }),
            rank: unknowns,
            unknowns,
            limit: None,
            warnings,
        };
        Ok(Solution { surface: Arc::new(surface), report })
    }
}

impl FourierSolver {
    /// The exact solution for boundary data as they are and the truncated force.
    fn solve_for_force(
        &self,
        forces: &[Series],
        (params, ranges, t): (&[f64], [[f64; 2]; 2], f64),
    ) -> Result<Solution, Diagnostic> {
        let truncated = self.force.truncated(&self.decomposition, forces)?;
        let solution = Exact.prepare(&truncated, &self.exact_options(forces))?.solve(params, ranges, t)?;
        let surface = solution.separable()?.clone();
        let mut warnings = solution.report.warnings;
        warnings.extend(self.force_warnings(forces));
        warnings.extend(self.force_reach(forces, (params, ranges, t))?);
        let report = Report {
            method: Fourier.name(),
            is_exact: false,
            modes: forces.iter().map(Series::modes).max().unwrap_or(0),
            truncation: Some(Truncation {
                left_out: 0.0,
                of_force: share_left_out(forces),
                places: Vec::new(),
                has_remainder: true,
            }),
            warnings,
            ..solution.report
        };
        let instant = self.force.varies_in_time().then_some(t);
        Ok(Solution { surface: Arc::new(SeparableSurface { instant, ..surface }), report })
    }

    /// What `exact` is given to solve for truncated series: room for their functions.
    fn exact_options<'a>(&self, series: impl IntoIterator<Item = &'a Series>) -> Options {
        let waves = series.into_iter().map(|series| 2 * series.modes() + 1).max().unwrap_or(0);
        let closure = self.options.limits.closure.saturating_add(waves);
        let limits = Limits { closure, ..self.options.limits.clone() };
        Options { settings: Settings::default(), limits, ..self.options.clone() }
    }

    /// Says what the series of the force leave out, if that is more than was asked for.
    fn force_warnings(&self, forces: &[Series]) -> Diagnostics {
        forces.iter().filter_map(|series| self.truncation_warning(series, ", which the equation misses")).collect()
    }

    fn numerals(&self, params: &[f64], range: [f64; 2]) -> Result<Numerals, Diagnostic> {
        let nowhere = [0.0];
        let mut values = vec![0.0; self.constant_values.program().outputs()];
        self.constant_values
            .evaluate(params, Samples { u: &nowhere, v: &nowhere, t: &nowhere }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let conditions = &self.decomposition.patch.conditions;
        let count = self.decomposition.basis.len();
        let (positions, rest) = values.split_at_checked(conditions.len()).unwrap_or_default();
        let (stated, factors) = rest.split_at_checked(3 * conditions.len() * count).unwrap_or_default();
        if let Some(at) = stated.iter().position(|value| !value.is_finite()) {
            let j = at / 3 % count.max(1);
            let message = format!("the coefficient of basis function F{} in the boundary data is not finite", j + 1);
            let origin = self.decomposition.basis.get(j).and_then(|function| function.origin);
            return Err(Diagnostic::new(Code::ParameterNotFinite, message).at(origin));
        }
        let terms = self.decomposition.operator.terms.iter().map(|term| term.derivative);
        Ok(Numerals {
            range,
            functionals: positions.iter().copied().zip(conditions.iter().map(|condition| condition.order)).collect(),
            stated: stated.to_vec(),
            terms: terms
                .zip(factors.chunks(3).map(|each| [0, 1, 2].map(|c| each.get(c).copied().unwrap_or(f64::NAN))))
                .collect(),
        })
    }

    /// Says what a series leaves out, if that is more than was asked for, and what becomes of it.
    fn truncation_warning(&self, series: &Series, consequence: &str) -> Option<Diagnostic> {
        let tolerance = match self.length {
            Length::Adaptive(tolerance, _) => tolerance,
            Length::Fixed(_) => DEFAULT_TOLERANCE,
        };
        if series.keeps(tolerance) {
            return None;
        }
        let (modes, left_out, subject) = (series.modes(), series.left_out, &series.subject);
        let message = format!("{modes} modes leave out {left_out:.1e} of {subject}{consequence}");
        let finding = Diagnostic::new(Code::SeriesTruncated, message).at(series.origin);
        let jump = series.corner;
        Some(if jump > 1e-3 * series.size {
            finding.hint(format!(
                "a slope jumps by {jump:.2} where v closes: what N modes leave out falls as slowly as 1/N"
            ))
        } else if series.modes() >= self.options.limits.modes {
            finding.hint(format!(
                "these are as many as the limit `modes` allows; raise it with --limits modes={}, or smooth the data",
                2 * series.modes()
            ))
        } else {
            finding.hint("more modes leave out less: `modes = N`, up to the limit `modes`")
        })
    }

    /// Says how positions inside the blend amplify the highest wave number.
    fn position_warning(&self, numerals: &Numerals, rates: &[f64; 3], wave_number: f64) -> Option<Diagnostic> {
        let rate = rates.iter().fold(0.0_f64, |most, rate| most.max(*rate)) * wave_number;
        let functions = CardinalExponentials::new(rate, numerals.range, &numerals.functionals)?;
        let [low, high] = numerals.range;
        let size_at = |step: u32| -> f64 {
            let u = low + (high - low) * f64::from(step) / 200.0;
            let positions = functions.derivatives(0, u).into_iter().zip(&numerals.functionals);
            positions.filter(|(_, (_, order))| *order == 0).map(|(value, _)| value.abs()).sum()
        };
        let lebesgue = (0..=200).map(size_at).fold(0.0, f64::max);
        if lebesgue < AMPLIFYING {
            return None;
        }
        let message = format!(
            "between these positions the highest mode grows {lebesgue:.1e} times, since e^({rate:.3} u) must pass through all of them"
        );
        let origin =
            self.decomposition.patch.conditions.iter().flat_map(|condition| condition.origins).flatten().next();
        Some(
            Diagnostic::new(Code::PositionsAmplify, message)
                .at(origin)
                .hint("state positions and tangents at the ends instead, bring the inner positions closer to the ends, or take fewer modes"),
        )
    }
}
