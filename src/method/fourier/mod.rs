//! Fourier series along v: boundary data of any functions, for equations with coefficients that depend on neither v nor t
//! (González Castro, Ugail, Willis and Palmer 2006, corrected; docs/methods.md, F1 to F5).
//!
//! Each wave number is a problem of its own, solved exactly: by the equation's own exponentials where it is
//! `(∂²/∂u² + a² ∂²/∂v²)^m S = 0`, by [`exact`](super::exact) otherwise, for which a truncated series is a problem with
//! a finite closure. What the series leaves out of the data is carried across the blend by the functions of the next
//! wave number, the remainder, so that the boundary is met; the remainder does not solve the equation.
//!
//! t is a parameter: each instant has its own series.

mod ends;
mod modal;
mod series;

use std::sync::Arc;

use super::{Method, Numbers, Options, Report, Solution, Solver, Truncation};
use crate::decompose::{Decomposition, close};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::ExprId;
use crate::limits::Limits;
use crate::trial::{CardinalExponentials, Modes};

use modal::{Assembly, Numerals};
use series::{BoundaryData, Length, Series};

/// The method `fourier`.
pub struct Fourier;

const DEFAULT_TOLERANCE: f64 = 1e-12;

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
        // A force is solved for on the closure of its own functions.
        close(&Decomposition { basis: Vec::new(), ..decomposition.clone() }, limits).map(|_| ())
    }

    fn suits(&self, decomposition: &Decomposition, numbers: &Numbers<'_>) -> Result<(), Diagnostic> {
        let data = BoundaryData::compile(decomposition);
        let [start, end] = numbers.domain.t;
        let instants = if data.varies_in_time { vec![start, 0.5 * (start + end), end] } else { vec![start] };
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
        Ok(Box::new(FourierSolver {
            length: length(options)?,
            has_remainder: remainder.is_some(),
            data: BoundaryData::compile(decomposition),
            constant_values: compile(Program::compile(graph, &constants), Backend::Interpreter).0,
            // The closed form is one of constant coefficients and no force.
            may_be_modal: !has_varying && operator.is_homogeneous(graph),
            decomposition: remainder.unwrap_or_else(|| decomposition.clone()),
            options: options.clone(),
        }))
    }
}

/// The number of modes that the settings ask for.
fn length(options: &Options) -> Result<Length, Diagnostic> {
    let limit = options.limits.modes;
    if let Some((tolerance, origin)) = options.settings.tolerance
        && !(1e-14..=1e-2).contains(&tolerance)
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

struct FourierSolver {
    length: Length,
    has_remainder: bool,
    data: BoundaryData,
    /// Positions, coefficients of the boundary data, coefficients of the equation.
    constant_values: Arc<dyn Evaluator>,
    may_be_modal: bool,
    decomposition: Decomposition,
    options: Options,
}

impl Solver for FourierSolver {
    fn solve(&self, params: &[f64], [range_u, range_v]: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let series = self.data.series(self.length, range_v, t, params)?;
        self.refuse_divergence(&series)?;
        let numerals = self.numerals(params, range_u)?;
        let mut warnings = Diagnostics::new();
        let mut assembly = Assembly::new(&self.decomposition, &series);
        let rates = if self.may_be_modal { numerals.rates() } else { None };
        let mut amplification = None;
        match &rates {
            Some(rates) => assembly.add_modes(&numerals, &series, rates)?,
            None => {
                let exact =
                    assembly.add_exact(&self.decomposition, &series, &self.options, (params, [range_u, range_v], t))?;
                warnings.extend(exact.warnings);
                amplification = exact.amplification;
            }
        }
        if let Some(ends) = &series.ends {
            let solution = ends.solve(&self.decomposition, &self.options, (params, range_u, t))?;
            warnings.extend(solution.report.warnings.iter().cloned());
            assembly.add_ends(ends, solution.separable()?);
        }
        let decay = rates.unwrap_or_else(|| numerals.decay());
        if self.has_remainder {
            assembly.add_remainder(&numerals, &series, &decay, &self.decomposition)?;
        }
        let highest = series.modes() + usize::from(self.has_remainder);
        warnings.extend(self.truncation_warning(&series));
        warnings.extend(self.position_warning(&numerals, &decay, series.wave_number * highest as f64));
        let instant = self.data.varies_in_time.then_some(t);
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
    /// Refuses data that as many modes as are allowed do not come near: they jump, have a pole, or vary too fast.
    fn refuse_divergence(&self, series: &Series) -> Result<(), Diagnostic> {
        if matches!(self.length, Length::Fixed(_)) || series.left_out <= LARGEST_PART_LEFT_OUT * series.size {
            return Ok(());
        }
        let (modes, left_out, size) = (series.modes(), series.left_out, series.size);
        let message =
            format!("a Fourier series of {modes} modes leaves out {left_out:.1e} of boundary data of size {size:.1e}");
        Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(series.origin).hint(
            "data that jump or have a pole in the domain of v have no useful series; fast ones need a higher limit `modes`",
        ))
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

    /// Says what the series leaves out, if that is more than was asked for.
    fn truncation_warning(&self, series: &Series) -> Option<Diagnostic> {
        let tolerance = match self.length {
            Length::Adaptive(tolerance, _) => tolerance,
            Length::Fixed(_) => DEFAULT_TOLERANCE,
        };
        if series.left_out <= 4.0 * tolerance * series.size {
            return None;
        }
        let carried = if self.has_remainder { "; the remainder carries it" } else { ", which the surface misses" };
        let message =
            format!("{} modes leave out {:.1e} of the boundary data{carried}", series.modes(), series.left_out);
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
