//! The last resort for any equation and any data: integrated Legendre polynomials of u for each basis function, fitted
//! to the equation at Gauss points, with as many terms as make the residual fall (docs/methods.md, L1).
//!
//! The boundary is met. Whether the equation is depends on the basis functions: where they are no eigenfunctions of
//! its operators in v and t, or a force is no combination of them, no number of terms makes the residual vanish. It is
//! reported, and is what a user should look at.

use std::sync::Arc;

use super::fitting::{Fitted, Fitting, Group, Plan, fit, groups};
use super::{Fit, Method, Options, Size, Solution, Solver, Systems, Terms};
use crate::decompose::Decomposition;
use crate::diagnostic::{Class, Code, Diagnostic, Shortest};
use crate::limits::Limits;
use crate::numeric::NodeKind;
use crate::trial::IntegratedLegendre;

/// The method `legendre`.
pub struct Legendre;

const DEFAULT_TOLERANCE: f64 = 1e-12;
/// Terms to begin with, and at most unless the user says how many.
const TERMS: [usize; 2] = [6, 96];
/// A step that leaves more than this of the residual is none; the second of them in a row ends the search.
const PROGRESS: f64 = 0.5;
/// Points in v at least: basis functions are seldom simple where this method is needed.
const POINTS: usize = 17;

impl Method for Legendre {
    fn name(&self) -> &'static str {
        "legendre"
    }

    fn description(&self) -> &'static str {
        "any equation and data: least squares with as many Legendre terms as reduce the residual"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["terms", "fit", "tolerance"]
    }

    fn accepts(&self, decomposition: &Decomposition, _limits: &Limits) -> Result<(), Diagnostic> {
        let operator = &decomposition.patch.operator;
        if decomposition.basis.is_empty() && !operator.is_homogeneous(&decomposition.graph) {
            let message = "the method `legendre` spans its surface by the boundary data, which are zero: \
                           nothing can balance the force";
            return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(operator.origin));
        }
        Ok(())
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let operator = &decomposition.patch.operator;
        let fit = fit(self.name(), decomposition, options)?;
        let is_vector = operator.terms.iter().any(|term| matches!(term.coefficient, [x, y, z] if x != y || x != z));
        let solver = LegendreSolver {
            fixed: fixed_terms(options)?,
            tolerance: tolerance(options)?,
            order: decomposition.patch.conditions.len(),
            fit,
            groups: groups(decomposition, fit, is_vector),
            fitting: Fitting::compile(self.name(), decomposition, options)?,
            limits: options.limits.clone(),
        };
        // Whether a fit is possible at all is known before any numbers are.
        let origin = options.settings.terms.and_then(|(_, origin)| origin);
        solver.plan(solver.fixed.unwrap_or(TERMS[0])).map_err(|finding| finding.at(origin))?;
        Ok(Box::new(solver))
    }
}

fn fixed_terms(options: &Options) -> Result<Option<usize>, Diagnostic> {
    match options.settings.terms {
        None => Ok(None),
        Some((Terms { first: 0, .. }, origin)) => {
            let finding = Diagnostic::new(Code::SettingOutOfRange, "the number of terms is 0");
            Err(finding.at(origin).hint("give at least one, or none to let the residual decide"))
        }
        Some((Terms { first, second: None }, _)) => Ok(Some(first)),
        Some((Terms { second: Some(_), .. }, origin)) => {
            let finding = Diagnostic::new(Code::UnknownSetting, "the method `legendre` has one number of terms");
            Err(finding.at(origin).hint("write `terms = 12`"))
        }
    }
}

fn tolerance(options: &Options) -> Result<f64, Diagnostic> {
    match options.settings.tolerance {
        None => Ok(DEFAULT_TOLERANCE),
        Some((tolerance, _)) if (1e-15..=1e-2).contains(&tolerance) => Ok(tolerance),
        Some((tolerance, origin)) => {
            let tolerance = Shortest(tolerance);
            let message = format!("the tolerance {tolerance} lies outside [1e-15, 1e-2]");
            Err(Diagnostic::new(Code::SettingOutOfRange, message).at(origin))
        }
    }
}

struct LegendreSolver {
    fixed: Option<usize>,
    tolerance: f64,
    /// The order in u.
    order: usize,
    fit: Fit,
    groups: Vec<Group>,
    fitting: Fitting,
    limits: Limits,
}

impl LegendreSolver {
    /// A fit with so many terms, on Gauss points twice as many.
    fn plan(&self, terms: usize) -> Result<Plan, Diagnostic> {
        let members = self.groups.iter().map(|group| group.members.len()).max().unwrap_or(0);
        let count = terms.saturating_mul(2).saturating_add(1);
        let points =
            Size { u: count, v: POINTS.max(members.saturating_mul(2).saturating_add(1)), kind: NodeKind::Gauss };
        let rows = points.u.saturating_mul(points.v);
        let unknowns = terms.saturating_mul(members);
        let entries = rows.saturating_mul(self.order + 1).saturating_mul(members.max(1));
        let systems = Systems { count: self.groups.len(), rows, unknowns, entries, points: rows };
        systems.check(&self.limits)?;
        Ok(Plan { terms, points, fit: self.fit, groups: self.groups.clone() })
    }

    fn fitted(&self, plan: &Plan, numbers: (&[f64], [[f64; 2]; 2], f64)) -> Result<(Fitted, f64), Diagnostic> {
        let family = Arc::new(IntegratedLegendre::new(self.order, plan.terms));
        let fitted = self.fitting.solve(plan, family, numbers)?;
        // One node more interlaces with those of the fit.
        let between = Size { u: plan.points.u + 1, v: plan.points.v + 1, kind: NodeKind::Gauss };
        let residual = self.fitting.residual(plan, &fitted, between, numbers)?;
        Ok((fitted, residual))
    }
}

impl Solver for LegendreSolver {
    fn solve(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let numbers = (params, ranges, t);
        if let Some(terms) = self.fixed {
            return Ok(self.fitted(&self.plan(terms)?, numbers)?.0.solution);
        }
        let [mut terms, most] = TERMS;
        let (mut best, mut least) = self.fitted(&self.plan(terms)?, numbers)?;
        let mut in_vain = 0;
        while least > self.tolerance && in_vain < 2 && terms < most {
            terms = (terms * 3 / 2).min(most);
            let plan = match self.plan(terms) {
                Ok(plan) => plan,
                // What was found stands; more is not allowed.
                Err(finding) if finding.class() == Class::Limit => {
                    best.solution.report.limit = Some(finding);
                    break;
                }
                Err(finding) => return Err(finding),
            };
            let (fitted, residual) = self.fitted(&plan, numbers)?;
            in_vain = if residual <= PROGRESS * least { 0 } else { in_vain + 1 };
            if residual < least {
                (best, least) = (fitted, residual);
            }
        }
        Ok(best.solution)
    }
}
