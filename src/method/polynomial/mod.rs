//! The method of You and Zhang 2003 (Eqs. 4-12, corrected): powers of u up to u^N for each basis function, fitted to
//! the equation at L x M collocation points by least squares.
//!
//! With `G_j(u) = Σ_i ξ_i(u) c_ij + Σ_n w_n(u) p_jn`, n up to N, the residual of the equation at a point is
//! `Σ_j Σ_p a_jp(u, v, t) G_j^(p)(u) - q` (docs/methods.md, Q2). The equation's coefficients may be any functions of u, v
//! and t, which the paper calls shape functions, and may differ between components.
//!
//! At each instant the p_jn are fitted as if they were constant, all basis functions of a component together (`joint`,
//! as the paper has it) or each alone (`per-basis`). Their true dependence on t follows by differentiating the fit,
//! so that derivatives of the surface in t are its own. Basis functions that differ by a factor of t alone are
//! multiples of each other at one instant: a joint fit then leaves terms undetermined, which is reported.

mod settings;

use std::sync::Arc;

use super::fitting::{Fitting, Plan};
use super::{Method, Options, Solution, Solver};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic};
use crate::limits::Limits;
use crate::trial::Powers;

use settings::plan;

/// The method `polynomial`.
pub struct Polynomial;

impl Method for Polynomial {
    fn name(&self) -> &'static str {
        "polynomial"
    }

    fn description(&self) -> &'static str {
        "powers up to u^N per basis function, fitted at L x M points (You and Zhang 2003, corrected)"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["terms", "points", "fit"]
    }

    fn accepts(&self, decomposition: &Decomposition, _limits: &Limits) -> Result<(), Diagnostic> {
        let operator = &decomposition.patch.operator;
        if decomposition.basis.is_empty() && !operator.is_homogeneous(&decomposition.graph) {
            let message = "the method `polynomial` spans its surface by the boundary data, which are zero: \
                           nothing can balance the force";
            return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(operator.origin));
        }
        Ok(())
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let plan = plan(decomposition, options)?;
        let fitting = Fitting::compile(self.name(), decomposition, options)?;
        Ok(Box::new(PolynomialSolver { lowest: decomposition.patch.conditions.len(), plan, fitting }))
    }
}

struct PolynomialSolver {
    /// The lowest power that is fitted: the number of boundary conditions.
    lowest: usize,
    plan: Plan,
    fitting: Fitting,
}

impl Solver for PolynomialSolver {
    fn solve(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let family = Arc::new(Powers::new(self.lowest));
        Ok(self.fitting.solve(&self.plan, family, (params, ranges, t))?.solution)
    }
}
