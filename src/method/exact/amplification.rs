//! What near-resonance means for a solution: its expected error, and the coefficients to stay away from.
//!
//! The residual of the equation does not reveal it, so it is measured: see [`Factorised`](super::block::Factorised).
//! Below 10 nothing is said; to 1e3 a note, to 1e10 a warning, above that there is no solution to rely on.

use super::{Amplified, ExactSolver, MOST_TERMS, Progress};
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::features::Feature;

/// Amplifications below this cost less than one digit: nothing is said.
const SILENT: f64 = 10.0;
/// To here a note, three digits at most; then a warning.
const NOTABLE: f64 = 1e3;
/// Above this fewer than six digits remain, and no surface is returned.
pub(super) const RESONANT: f64 = 1e10;

/// Above this, a block that no number of terms resolves suffers from resonance rather than from thin layers.
const UNRELIABLE: f64 = 1e7;

impl ExactSolver {
    /// What the largest amplification means for the user.
    pub(super) fn judge(&self, progress: &mut Progress<'_>) -> Result<Diagnostics, Diagnostic> {
        let Some(worst) = progress.worst.take().filter(|worst| worst.factor >= SILENT) else {
            return Ok(Diagnostics::new());
        };
        let j = worst.members.first().copied().unwrap_or(0);
        let critical = self.critical_value(&worst, progress)?;
        let hint = |finding: Diagnostic| match &critical {
            Some(critical) => finding.hint(format!("there is no solution {critical}")),
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

    /// The finding for a block that the largest number of terms does not resolve.
    pub(super) fn unresolved(&self, members: &[usize], progress: &mut Progress<'_>) -> Diagnostic {
        let j = members.first().copied().unwrap_or(0);
        // Near resonance rounding errors grow until no number of terms helps.
        if let Some(worst) = progress.worst.take_if(|worst| worst.members == members && worst.factor > UNRELIABLE) {
            return self.resonant_at(&worst, progress);
        }
        let name = self.name(j);
        let thinnest = progress.features.iter().min_by(|a, b| a.width.total_cmp(&b.width));
        let (code, message, hint) = match (thinnest, self.fastest_rate(members, progress)) {
            (Some(Feature { at, width }), _) => (
                Code::SolutionNotFinite,
                format!(
                    "{MOST_TERMS} terms across the blend do not resolve the solution along `{name}`: the force or a coefficient \
                     changes within {width:.1e} at u = {at:.6}"
                ),
                "make it wider, or choose a fitted method and measure what it leaves of the equation",
            ),
            (None, Ok(rate)) if rate > 1.0 && rate.is_finite() => (
                Code::LayersTooThin,
                format!(
                    "the solution along `{name}` has layers too thin for {MOST_TERMS} terms across the blend, about {:.1e} wide",
                    1.0 / rate
                ),
                "the coefficient of the highest derivative in u is small or zero somewhere compared with the others; make it \
                 larger, or choose a fitted method",
            ),
            _ => (
                Code::SolutionNotFinite,
                format!("{MOST_TERMS} terms across the blend do not resolve the solution along `{name}`"),
                "the coefficient of the highest derivative in u is zero somewhere, or the force or a coefficient has a jump or \
                 a kink in u; smooth it, or choose a fitted method",
            ),
        };
        Diagnostic::new(code, message).at(self.origin(j)).hint(hint)
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
            Some(critical) => finding.hint(format!("there is no solution {critical}")),
            None => finding,
        };
        finding.hint("change a coefficient of the equation a little, or choose a fitted method such as `sine`")
    }
}
