//! Least-squares fits of trial functions to the equation at collocation points, whatever the family of functions and
//! the equation: coefficients in u, v and t, forces, any order (docs/methods.md, Q2).
//!
//! At each instant the coefficients are fitted as if they were constant, all basis functions of a component together
//! or each alone. Their true dependence on t follows by differentiating the fit, so that derivatives of the surface
//! in t are its own.

mod system;

use std::sync::{Arc, Mutex, PoisonError};

use nalgebra::DMatrix;

use super::equation::{Discretisation, Equation, place};
use super::{Fit, Options, Report, Size, Solution};
use crate::decompose::{Decomposition, bounded_derivative};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId};
use crate::limits::Limits;
use crate::numeric::{LeastSquares, LeastSquaresError, nodes};
use crate::problem::COMPONENTS;
use crate::trial::{CorrectedTrial, Modes, TrialFamily};

use system::Collocation;
pub use system::{Group, groups};

/// Terms, grid and systems of a fit.
pub struct Plan {
    /// How many trial functions are fitted.
    pub terms: usize,
    /// The collocation grid.
    pub points: Size,
    /// What is fitted together.
    pub fit: Fit,
    /// The systems.
    pub groups: Vec<Group>,
}

/// The parameters, the ranges of u and v, and the instant.
pub type State<'a> = (&'a [f64], [[f64; 2]; 2], f64);

/// A compiled problem.
pub struct Fitting {
    method: &'static str,
    equation: Equation,
    force: Option<Arc<dyn Evaluator>>,
    /// The last systems: functions that the equation multiplies alike, and other instants, have the same.
    factorised: Mutex<Vec<(DMatrix<f64>, Arc<LeastSquares>)>>,
    operator_origin: Option<Span>,
}

/// A solution with what is needed to measure it at other points.
pub struct Fitted {
    /// The solution.
    pub solution: Solution,
    modes: CorrectedTrial,
    stated: Vec<DMatrix<f64>>,
    /// The coefficients of each group.
    weights: Vec<DMatrix<f64>>,
}

/// The force and its derivatives in t, by component; `None` if it is zero.
fn force(decomposition: &Decomposition, limits: &Limits) -> Result<Option<Arc<dyn Evaluator>>, Diagnostic> {
    let operator = &decomposition.patch.operator;
    if operator.is_homogeneous(&decomposition.graph) {
        return Ok(None);
    }
    let mut graph = decomposition.graph.clone();
    let mut outputs: Vec<ExprId> = Vec::new();
    for component in operator.force {
        for order in 0..=operator.order_in_t() {
            let in_time = Derivative::new(0, 0, order);
            outputs.push(bounded_derivative(&mut graph, component, in_time, limits, operator.origin)?);
        }
    }
    Ok(Some(compile(Program::compile(&graph, &outputs), Backend::Interpreter).0))
}

/// Each basis function alone, unless a force needs them all.
pub fn fit(method: &str, decomposition: &Decomposition, options: &Options) -> Result<Fit, Diagnostic> {
    let operator = &decomposition.patch.operator;
    let has_force = !operator.is_homogeneous(&decomposition.graph);
    match options.settings.fit {
        Some((Fit::PerBasis, origin)) if has_force => {
            let message =
                format!("the method `{method}` cannot share a force among basis functions that are fitted one by one");
            let finding = Diagnostic::new(Code::UnsupportedByMethod, message);
            Err(finding.at(origin.or(operator.origin)).hint("write `fit = joint`"))
        }
        Some((fit, _)) => Ok(fit),
        None => Ok(if has_force { Fit::Joint } else { Fit::PerBasis }),
    }
}

impl Fitting {
    /// Compiles the equation for the method called `method`.
    ///
    /// # Errors
    /// As [`Equation::compile`].
    pub fn compile(
        method: &'static str,
        decomposition: &Decomposition,
        options: &Options,
    ) -> Result<Fitting, Diagnostic> {
        Ok(Fitting {
            method,
            equation: Equation::compile(decomposition, options)?,
            force: force(decomposition, &options.limits)?,
            factorised: Mutex::default(),
            operator_origin: decomposition.patch.operator.origin,
        })
    }

    /// Fits functions of `family`.
    ///
    /// # Errors
    /// Data that are not finite, a basis function that the points do not see, a system without a finite solution.
    pub fn solve(&self, plan: &Plan, family: Arc<dyn TrialFamily>, numbers: State<'_>) -> Result<Fitted, Diagnostic> {
        let (params, ranges, t) = numbers;
        let equation = &self.equation;
        let Discretisation { boundary, modes, u, v, is_visible } =
            equation.discretise((family, plan.terms), plan.points, (params, ranges, t))?;
        let count = equation.basis.len();
        // Where the equation only multiplies the functions that it is fitted to, the nodes in v make no difference.
        let is_reduced = |group: &Group| matches!(group.members.as_slice(), [j] if equation.has_quotients(*j));
        let (symbols, in_v) = match self.force.is_none() && plan.groups.iter().all(is_reduced) {
            true => ((equation.quotients_at(&u, t, params)?, Vec::new()), 1),
            false => (self.symbols_at(&u, &v, numbers)?, v.len()),
        };
        let collocation = Collocation::new(equation, &modes, (&u, in_v), (&symbols.0, &symbols.1));
        let stated: Vec<DMatrix<f64>> = (0..count).map(|j| boundary.stated(j)).collect();
        let mut coefficients = equation.no_coefficients(modes.count());
        if let Some(first) = coefficients.first_mut() {
            for (j, stated) in stated.iter().enumerate() {
                place(first, (j, count), 0, &[0, 1, 2], stated);
            }
        }
        let mut report = self.empty_report(plan);
        let mut weights = Vec::with_capacity(plan.groups.len());
        for group in &plan.groups {
            let fits = self.fit(plan, &collocation, group, (&stated, &is_visible), t, &mut report)?;
            for (coefficients, fit) in coefficients.iter_mut().zip(&fits) {
                for (&j, first) in group.members.iter().zip((0..).step_by(plan.terms)) {
                    let rows = fit.rows(first, plan.terms).into_owned();
                    place(coefficients, (j, count), equation.orders.len(), &group.components, &rows);
                }
            }
            weights.extend(fits.into_iter().next());
        }
        let surface = equation.surface(Arc::new(modes.clone()), coefficients, params, t);
        Ok(Fitted { solution: Solution { surface: Arc::new(surface), report }, modes, stated, weights })
    }

    /// The largest residual on another grid, with the coefficients taken as constant in time, over the largest single
    /// part of the equation: how well the fit holds where it was not made.
    ///
    /// # Errors
    /// Data that are not finite.
    pub fn residual(&self, plan: &Plan, fitted: &Fitted, points: Size, numbers: State<'_>) -> Result<f64, Diagnostic> {
        let (_, [range_u, range_v], _) = numbers;
        let (u, v) = (nodes(points.kind, points.u, range_u), nodes(points.kind, points.v, range_v));
        let symbols = self.symbols_at(&u, &v, numbers)?;
        let collocation = Collocation::new(&self.equation, &fitted.modes, (&u, v.len()), (&symbols.0, &symbols.1));
        let (mut largest, mut residual) = (0.0_f64, 0.0_f64);
        for (group, weights) in plan.groups.iter().zip(&fitted.weights) {
            let (systems, rights) = collocation.systems(group, &fitted.stated);
            let (Some(matrix), Some(right)) = (systems.first(), rights.first()) else { continue };
            let image = matrix * weights;
            largest = largest.max(right.amax()).max(image.amax());
            residual = residual.max((image + right).amax());
        }
        Ok(if largest > 0.0 { residual / largest } else { 0.0 })
    }

    /// The equation's symbols and the force at all points.
    fn symbols_at(&self, u: &[f64], v: &[f64], (params, _, t): State<'_>) -> Result<(Vec<f64>, Vec<f64>), Diagnostic> {
        let u_of_points: Vec<f64> = u.iter().flat_map(|&u| v.iter().map(move |_| u)).collect();
        let v_of_points: Vec<f64> = u.iter().flat_map(|_| v.iter().copied()).collect();
        let symbols = self.equation.symbols_at(&u_of_points, &v_of_points, t, params)?;
        Ok((symbols, self.force_at(&u_of_points, &v_of_points, t, params)?))
    }

    fn force_at(&self, u: &[f64], v: &[f64], t: f64, params: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let Some(force) = &self.force else { return Ok(Vec::new()) };
        let mut values = vec![0.0; force.program().outputs() * u.len()];
        force
            .evaluate(params, Samples { u, v, t: &vec![t; u.len()] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let Some(at) = values.iter().position(|value| !value.is_finite()) else { return Ok(values) };
        let point = at % u.len().max(1);
        let [u, v] = [u, v].map(|all| Shortest(all.get(point).copied().unwrap_or(f64::NAN)));
        let t = Shortest(t);
        let message = format!("the force is not finite at u = {u}, v = {v}, t = {t}");
        Err(Diagnostic::new(Code::DataNotFinite, message).at(self.operator_origin))
    }

    /// The fitted coefficients of a group and their derivatives in t: rows by member and term, a column per component.
    fn fit(
        &self,
        plan: &Plan,
        collocation: &Collocation<'_>,
        group: &Group,
        (stated, is_visible): (&[DMatrix<f64>], &[bool]),
        t: f64,
        report: &mut Report,
    ) -> Result<Vec<DMatrix<f64>>, Diagnostic> {
        let unknowns = plan.terms * group.members.len();
        report.unknowns += unknowns;
        let (systems, rights) = collocation.systems(group, stated);
        let is_zero = |matrices: &[DMatrix<f64>]| matrices.iter().flatten().all(|value| *value == 0.0);
        // Where the equation holds whatever G is, no terms are needed; nor do they arise from nothing.
        if is_zero(&rights) || is_zero(systems.get(..1).unwrap_or_default()) {
            report.rank += unknowns;
            return Ok(vec![DMatrix::zeros(unknowns, group.components.len()); systems.len()]);
        }
        // The columns of a function that is zero on the grid are rounding errors, which scaling would make visible.
        let is_hidden = |j: &&usize| !is_visible.get(**j).copied().unwrap_or(false);
        if let Some(&j) = group.members.iter().find(is_hidden) {
            return Err(self.equation.vanishes(j));
        }
        let failed = |reason: String| {
            let message = format!("the system of {} {reason}", self.name(plan, group));
            let origin = group.members.first().and_then(|&j| self.equation.origin(j));
            Diagnostic::new(Code::SolutionNotFinite, message).at(origin)
        };
        let matrix = systems.first().ok_or_else(|| failed("is empty".to_owned()))?;
        let solver = self.factorised(matrix).map_err(|error| failed(format!("cannot be solved: {error}")))?;
        report.condition = report.condition.map(|condition| condition.max(solver.condition()));
        report.rank += solver.rank();
        if solver.rank() < unknowns {
            report.warnings.push(self.deficiency(plan, group, &solver, t));
        }
        let derivatives = solver.derivatives(&systems, &rights);
        if derivatives.iter().flatten().any(|value| !value.is_finite()) {
            return Err(failed("has a solution that is not finite".to_owned()));
        }
        Ok(derivatives)
    }

    /// The factors of `matrix`, which may be known.
    fn factorised(&self, matrix: &DMatrix<f64>) -> Result<Arc<LeastSquares>, LeastSquaresError> {
        // A panic elsewhere leaves the list whole.
        let lock = || self.factorised.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = lock().iter().find(|(known, _)| known == matrix) {
            return Ok(Arc::clone(known));
        }
        let solver = Arc::new(LeastSquares::new(matrix)?);
        if matrix.len() <= LARGEST_KEPT {
            let mut all = lock();
            if all.len() >= KEPT {
                all.remove(0);
            }
            all.push((matrix.clone(), Arc::clone(&solver)));
        }
        Ok(solver)
    }

    /// The finding that names the basis functions whose terms are not determined.
    fn deficiency(&self, plan: &Plan, group: &Group, solver: &LeastSquares, t: f64) -> Diagnostic {
        let takes_part = |place: usize| {
            let rows = solver.null_space().map(|null| null.rows(place * plan.terms, plan.terms).norm());
            rows.is_some_and(|norm| norm > LEAST_SHARE)
        };
        let dependent: Vec<usize> =
            group.members.iter().enumerate().filter(|(place, _)| takes_part(*place)).map(|(_, j)| *j).collect();
        let (rank, unknowns, name) = (solver.rank(), solver.unknowns(), self.name(plan, group));
        let finding = |message: String| {
            let first = dependent.first().or(group.members.first());
            Diagnostic::new(Code::RankDeficient, message).at(first.and_then(|&j| self.equation.origin(j)))
        };
        if dependent.len() < 2 {
            let message =
                format!("the points determine {rank} of {unknowns} terms of {name}; the smallest solution is taken");
            return finding(message).hint("use midpoints, more points, or fewer terms");
        }
        let names: Vec<String> = dependent.iter().map(|j| format!("F{}", j + 1)).collect();
        let message = format!(
            "the points determine {rank} of {unknowns} terms of {name}: on them {} depend on each other at t = {}; \
             the smallest solution is taken",
            names.join(", "),
            Shortest(t)
        );
        finding(message).hint("fit each basis function alone (`fit = per-basis`), or use more points")
    }

    /// What a system determines, for messages.
    fn name(&self, plan: &Plan, group: &Group) -> String {
        match (plan.fit, group.members.as_slice()) {
            (Fit::PerBasis, [j]) => format!("basis function F{}", j + 1),
            _ => {
                let names = group.components.iter().filter_map(|&component| COMPONENTS.get(component));
                names.map(|name| format!("S_{name}")).collect::<Vec<_>>().join(", ")
            }
        }
    }

    fn empty_report(&self, plan: &Plan) -> Report {
        Report {
            method: self.method,
            is_exact: false,
            basis_size: self.equation.basis.len(),
            closure_size: None,
            modes: plan.terms,
            condition: Some(1.0),
            amplification: None,
            truncation: None,
            rank: 0,
            unknowns: 0,
            limit: None,
            warnings: self.equation.note.iter().cloned().collect::<Diagnostics>(),
        }
    }
}

/// Systems that are remembered, and the most entries that one of them has: those of single functions.
const KEPT: usize = 32;
const LARGEST_KEPT: usize = 4096;

/// A basis function takes part in a dependency if its share in the orthonormal directions of the null space is more
/// than what rounding leaves of nothing.
const LEAST_SHARE: f64 = 1e-6;
