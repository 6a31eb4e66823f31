//! What near-resonance means for a solution: its expected error, and the coefficients to stay away from.
//!
//! The residual of the equation does not reveal it, so it is measured: see [`Factorised`](super::block::Factorised).
//! Below 10 nothing is said; to 1e3 a note, to 1e10 a warning, above that there is no solution to rely on.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::block::Factorised;
use super::discretisation::Discretisation;
use super::{Amplified, ExactSolver, MOST_TERMS, Progress};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::expr::{ExprId, Node};
use crate::features::Feature;
use crate::numeric::{NodeKind, nodes};

/// Amplifications below this cost less than one digit: nothing is said.
const SILENT: f64 = 10.0;
/// To here a note, three digits at most; then a warning.
const NOTABLE: f64 = 1e3;
/// Above this fewer than six digits remain, and no surface is returned.
pub(super) const RESONANT: f64 = 1e10;

/// Above this, a block that no number of terms resolves suffers from resonance rather than from thin layers.
const UNRELIABLE: f64 = 1e7;

/// Linear problems that are solved for one critical value.
const STEPS: usize = 12;

/// The step of a difference quotient, relative to the coefficient: its error and that of rounding are about equal.
const DIFFERENCE: f64 = 1e-5;

/// A critical value that moves by less is found; six decimals are shown.
const SETTLED: f64 = 1e-8;

/// Critical values shown in a message.
const SHOWN: usize = 2;

impl ExactSolver {
    /// What the largest amplification means for the user.
    pub(super) fn judge(&self, progress: &mut Progress<'_>) -> Result<Diagnostics, Diagnostic> {
        let Some(worst) = progress.worst.take().filter(|worst| worst.factor >= SILENT) else {
            return Ok(Diagnostics::new());
        };
        let j = worst.members.first().copied().unwrap_or(0);
        let critical = self.critical_value(&worst, progress)?;
        let hint = |finding: Diagnostic| match &critical {
            Some(critical) => finding.hint(format!("there is no solution at {critical}")),
            None => finding,
        };
        let code = if worst.factor < NOTABLE { Code::Amplified } else { Code::NearlyResonant };
        let message = format!(
            "along `{}` the equation amplifies {:.1e} times; expect a relative error of {:.1e}",
            self.name(j),
            worst.factor,
            worst.factor * f64::EPSILON
        );
        Ok(vec![hint(Diagnostic::new(code, message).at(self.origin(j)))])
    }

    /// The nearest value of each coefficient of the equation that makes a block singular, those that are relatively
    /// nearest first: `eta = -113.615, or at gamma = 10.01`.
    fn critical_value(&self, worst: &Amplified, progress: &mut Progress<'_>) -> Result<Option<String>, Diagnostic> {
        let mut critical: Vec<(f64, String)> = Vec::new();
        for (symbol, name) in &self.coefficients {
            let Some(value) = progress.params.get(*symbol).copied() else { continue };
            let Some(found) = self.nearest_singular(worst, *symbol, value, progress)? else { continue };
            let relative = (found - value).abs() / value.abs().max(f64::MIN_POSITIVE);
            critical.push((relative, format!("{name} = {found:.*}", decimals(found - value))));
        }
        critical.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let shown: Vec<String> = critical.into_iter().take(SHOWN).map(|(_, text)| text).collect();
        Ok((!shown.is_empty()).then(|| shown.join(", or at ")))
    }

    /// The value of one coefficient at which the block is singular, from `value` by successive linear problems: each
    /// takes the matrix as linear in the coefficient, as it mostly is, and goes to the nearest singular one. `None` if
    /// this settles nowhere.
    fn nearest_singular(
        &self,
        worst: &Amplified,
        symbol: usize,
        value: f64,
        progress: &mut Progress<'_>,
    ) -> Result<Option<f64>, Diagnostic> {
        let discretisation = self.discretise(worst.terms, worst.terms, progress)?;
        let u = nodes(NodeKind::Gauss, worst.terms, progress.range);
        let cardinal = discretisation.tables.cardinal;
        let matrix_at = |coefficient: f64| -> Result<Option<DMatrix<f64>>, Diagnostic> {
            let mut params = progress.params.to_vec();
            if let Some(slot) = params.get_mut(symbol) {
                *slot = coefficient;
            }
            let there =
                Discretisation { entries: self.entries_at(&params, &u)?, ..Discretisation::clone(&discretisation) };
            let (block, ..) = self.block_of(&worst.members, worst.component, &there, worst.terms, progress);
            let matrix = block.matrix(&there.tables, cardinal..cardinal + worst.terms);
            Ok(matrix.iter().all(|value| value.is_finite()).then_some(matrix))
        };
        let (mut at, mut factorised) = (value, Arc::clone(&worst.factorised));
        for _ in 0..STEPS {
            let step = DIFFERENCE * at.abs().max(1.0);
            let (Some(above), Some(below)) = (matrix_at(at + step)?, matrix_at(at - step)?) else { return Ok(None) };
            let derivative = (above - below) / (2.0 * step);
            let Some(distance) = factorised.distance_to_singular(&derivative) else { return Ok(None) };
            at += distance;
            if distance.abs() <= SETTLED * at.abs().max(1.0) {
                return Ok(Some(at));
            }
            let Some(matrix) = matrix_at(at)? else { return Ok(None) };
            match Factorised::new(matrix) {
                Some(next) => factorised = Arc::new(next),
                None => return Ok(Some(at)),
            }
        }
        Ok(None)
    }

    /// The finding for a block that the largest number of terms does not resolve.
    pub(super) fn unresolved(&self, members: &[usize], progress: &mut Progress<'_>) -> Diagnostic {
        let j = members.first().copied().unwrap_or(0);
        // Near resonance rounding errors grow until no number of terms helps.
        if let Some(worst) = progress.worst.take_if(|worst| worst.members == members && worst.factor > UNRELIABLE) {
            return self.resonant_at(&worst, progress);
        }
        let name = self.name(j);
        let thinnest = progress.features.iter().min_by(|a, b| a.width.total_cmp(&b.width));
        let (message, hint) = match (thinnest, self.fastest_rate(members, progress)) {
            (Some(Feature { at, width }), _) => (
                format!(
                    "{MOST_TERMS} terms across the blend do not resolve the solution along `{name}`: the force or a coefficient \
                     changes within {width:.1e} at u = {at:.6}"
                ),
                "make it wider, or choose a fitted method and measure what it leaves of the equation",
            ),
            (None, Ok(rate)) if rate > 1.0 && rate.is_finite() => (
                format!(
                    "the solution along `{name}` has layers too thin for {MOST_TERMS} terms across the blend, about {:.1e} wide",
                    1.0 / rate
                ),
                "the coefficient of the highest derivative in u is small or zero somewhere compared with the others; make it \
                 larger, or choose a fitted method",
            ),
            _ => (
                format!("{MOST_TERMS} terms across the blend do not resolve the solution along `{name}`"),
                "the coefficient of the highest derivative in u is zero somewhere, or the force or a coefficient has a jump or \
                 a kink in u; smooth it, or choose a fitted method",
            ),
        };
        Diagnostic::new(Code::SolutionNotFinite, message).at(self.origin(j)).hint(hint)
    }

    /// The finding for numbers that leave the doubles.
    pub(super) fn overflows(&self, j: usize) -> Diagnostic {
        let message = format!("the numbers of the equation along `{}` overflow", self.name(j));
        Diagnostic::new(Code::SolutionNotFinite, message)
            .at(self.origin(j))
            .hint("bring the coefficients and data to ordinary sizes")
    }

    /// The finding for an equation whose order in u drops below the number of conditions.
    pub(super) fn order_drops(&self, j: usize) -> Diagnostic {
        let order = self.order;
        let message = format!(
            "along `{}` the coefficient of the derivative of order {order} in u is 0, so {order} conditions cannot be met",
            self.name(j)
        );
        Diagnostic::new(Code::OrderDrops, message).at(self.origin(j)).hint(
            "the method `sine` meets the conditions and the equation as well as it can, in the sense of least squares",
        )
    }

    /// The finding for a block that amplifies too much, with the coefficients at which there is no solution.
    pub(super) fn resonant_at(&self, worst: &Amplified, progress: &mut Progress<'_>) -> Diagnostic {
        let j = worst.members.first().copied().unwrap_or(0);
        let critical = self.critical_value(worst, progress).ok().flatten();
        self.resonant(Some(worst.factor), critical.as_deref(), j)
    }

    /// The finding for an equation without a reliable solution, or without any if nothing is known of how it amplifies.
    pub(super) fn resonant(&self, amplification: Option<f64>, critical: Option<&str>, j: usize) -> Diagnostic {
        let name = self.name(j);
        let message = match amplification {
            Some(factor) => format!(
                "the equation is resonant along `{name}`: it amplifies what is prescribed {factor:.1e} times, and rounding with it"
            ),
            None => format!("the equation is resonant along `{name}`: it has no solution, or more than one"),
        };
        let finding = Diagnostic::new(Code::Resonant, message).at(self.origin(j));
        let finding = match critical {
            Some(critical) => finding.hint(format!("there is no solution at {critical}")),
            None => finding,
        };
        finding.hint("change a coefficient of the equation a little, or choose a fitted method such as `sine`")
    }
}

/// As many decimals as tell a critical value from one that is so far away: six, or two digits of the difference.
fn decimals(difference: f64) -> usize {
    let first = -libm::floor(libm::log10(difference.abs()));
    // No difference has an infinite logarithm, and 15 decimals are more than a value of size 1 has.
    (first + 1.0).clamp(6.0, 15.0) as usize
}

/// The symbols that the coefficients of the equation are made of.
pub(super) fn coefficient_symbols(decomposition: &Decomposition) -> Vec<(usize, String)> {
    let graph = &decomposition.graph;
    let coefficients: Vec<ExprId> = decomposition.operator.terms.iter().flat_map(|term| term.coefficient).collect();
    let symbol = |part: ExprId| match graph.node(part) {
        Node::Symbol(symbol) => Some((symbol.index(), graph.symbol_name(*symbol).to_owned())),
        _ => None,
    };
    graph.reachable(&coefficients).into_iter().filter_map(symbol).collect()
}
