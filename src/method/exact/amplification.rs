//! What near-resonance means for a solution: its expected error, and the coefficients to stay away from.
//!
//! The residual of the equation does not reveal it, so it is measured: see [`Factorised`](super::block::Factorised).
//! Below 10 nothing is said; to 1e3 a note, to 1e10 a warning, above that there is no solution to rely on.

use super::{Amplified, Discretisation, ExactSolver, MOST_TERMS, Progress};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::expr::{ExprId, Node};

/// Amplifications below this cost less than one digit: nothing is said.
const SILENT: f64 = 10.0;
/// To here a note, three digits at most; then a warning.
const NOTABLE: f64 = 1e3;
/// Above this fewer than six digits remain, and no surface is returned.
pub(super) const RESONANT: f64 = 1e10;

/// Above this, a block that no number of terms resolves suffers from resonance rather than from thin layers.
const UNRELIABLE: f64 = 1e7;

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
        let discretisation = self.discretise(worst.terms, progress)?;
        let (here, ..) = self.block_of(&worst.members, worst.component, &discretisation, worst.terms, progress);
        let cardinal = discretisation.tables.cardinal;
        let mut critical: Vec<(f64, String)> = Vec::new();
        for (symbol, name) in &self.coefficients {
            let Some(value) = progress.params.get(*symbol).copied() else { continue };
            let step = value.abs().max(1.0);
            let mut moved = Vec::new();
            for sign in [1.0, -1.0] {
                let mut params = progress.params.to_vec();
                if let Some(slot) = params.get_mut(*symbol) {
                    *slot += sign * step;
                }
                let entries = self.entries_at(&params, worst.terms, progress.range)?;
                let there = Discretisation { entries, ..Discretisation::clone(&discretisation) };
                let (block, ..) = self.block_of(&worst.members, worst.component, &there, worst.terms, progress);
                moved.push(block.matrix(&discretisation.tables, cardinal..cardinal + worst.terms));
            }
            let [above, below] = moved.as_slice() else { continue };
            let derivative = (above - below) / (2.0 * step);
            let here = here.matrix(&discretisation.tables, cardinal..cardinal + worst.terms);
            // A distance follows from the derivative only where the matrix is linear in the coefficient.
            let bend = (above + below - here * 2.0).amax();
            if bend > 1e-9 * derivative.amax() * step {
                continue;
            }
            let Some(distance) = worst.factorised.distance_to_singular(&derivative) else { continue };
            let relative = distance.abs() / value.abs().max(f64::MIN_POSITIVE);
            critical.push((relative, format!("{name} = {:.6}", value + distance)));
        }
        critical.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let shown: Vec<String> = critical.into_iter().take(SHOWN).map(|(_, text)| text).collect();
        Ok((!shown.is_empty()).then(|| shown.join(", or at ")))
    }

    /// The finding for a block that the largest number of terms does not resolve.
    pub(super) fn unresolved(&self, members: &[usize], progress: &Progress<'_>) -> Diagnostic {
        let j = members.first().copied().unwrap_or(0);
        // Near resonance rounding errors grow until no number of terms helps.
        if let Some(worst) =
            progress.worst.as_ref().filter(|worst| worst.members == members && worst.factor > UNRELIABLE)
        {
            return self.resonant(worst.factor, j);
        }
        let message = format!(
            "the solution along `{}` has layers too thin for {MOST_TERMS} terms across the blend",
            self.name(j)
        );
        Diagnostic::new(Code::SolutionNotFinite, message).at(self.origin(j)).hint(
            "the coefficient of the highest derivative in u is small or zero somewhere compared with the others, or the force \
             or a coefficient has a jump, a pole or a spike in u; smooth it, or choose a fitted method",
        )
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

    pub(super) fn resonant(&self, amplification: f64, j: usize) -> Diagnostic {
        let how = if amplification.is_finite() { format!(" ({amplification:.1e} times)") } else { String::new() };
        let message = format!("the equation is resonant along `{}`: it has no reliable solution{how}", self.name(j));
        Diagnostic::new(Code::Resonant, message)
            .at(self.origin(j))
            .hint("change a coefficient of the equation a little, or choose a fitted method such as `sine`")
    }
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
