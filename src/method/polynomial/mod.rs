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
mod system;

use std::sync::Arc;

use nalgebra::DMatrix;

use super::equation::{Equation, place};
use super::{Fit, Method, Options, Report, Solution, Solver};
use crate::decompose::{Decomposition, bounded_derivative};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId};
use crate::limits::Limits;
use crate::numeric::{LeastSquares, nodes};
use crate::problem::COMPONENTS;
use crate::surface::{Coefficients, SeparableSurface};
use crate::trial::{Modes, Powers};

use settings::Plan;
use system::{Collocation, Group};

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
        let plan = Plan::new(decomposition, options)?;
        Ok(Box::new(PolynomialSolver {
            plan,
            equation: Equation::compile(decomposition, options)?,
            force: force(decomposition, &options.limits)?,
            operator_origin: decomposition.patch.operator.origin,
        }))
    }
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

struct PolynomialSolver {
    plan: Plan,
    equation: Equation,
    force: Option<Arc<dyn Evaluator>>,
    operator_origin: Option<Span>,
}

impl Solver for PolynomialSolver {
    fn solve(&self, params: &[f64], [range_u, range_v]: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let (equation, points) = (&self.equation, self.plan.points);
        let boundary = equation.boundary(params)?;
        let modes = equation.modes(Arc::new(Powers::new(self.plan.lowest)), self.plan.terms, range_u, &boundary)?;
        let u = nodes(points.kind, points.u, range_u);
        let v = nodes(points.kind, points.v, range_v);
        let is_visible = equation.visible_on(&v, range_v, t, params)?;
        let u_of_points: Vec<f64> = u.iter().flat_map(|&u| v.iter().map(move |_| u)).collect();
        let v_of_points: Vec<f64> = u.iter().flat_map(|_| v.iter().copied()).collect();
        let symbols = equation.symbols_at(&u_of_points, &v_of_points, t, params)?;
        let force = self.force_at(&u_of_points, &v_of_points, t, params)?;
        let collocation = Collocation::new(equation, &modes, (&u, v.len()), (&symbols, &force));

        let count = equation.basis.len();
        let stated: Vec<DMatrix<f64>> = (0..count).map(|j| boundary.stated(j)).collect();
        let mut coefficients: Vec<Coefficients> = vec![vec![[0.0; 3]; modes.count() * count]; equation.orders_in_t + 1];
        if let Some(first) = coefficients.first_mut() {
            for (j, stated) in stated.iter().enumerate() {
                place(first, (j, count), 0, &[0, 1, 2], stated);
            }
        }
        let mut report = self.empty_report();
        for group in &self.plan.groups {
            let fits = self.fit(&collocation, group, (&stated, &is_visible), t, &mut report)?;
            for (coefficients, fit) in coefficients.iter_mut().zip(&fits) {
                for (&j, first) in group.members.iter().zip((0..).step_by(self.plan.terms)) {
                    let rows = fit.rows(first, self.plan.terms).into_owned();
                    place(coefficients, (j, count), equation.orders.len(), &group.components, &rows);
                }
            }
        }
        let surface = SeparableSurface {
            modes: Arc::new(modes),
            basis: Arc::clone(&equation.basis),
            params: params.to_vec(),
            coefficients,
            instant: Some(t),
        };
        Ok(Solution { surface: Arc::new(surface), report })
    }
}

impl PolynomialSolver {
    fn force_at(&self, u: &[f64], v: &[f64], t: f64, params: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let Some(force) = &self.force else { return Ok(Vec::new()) };
        let mut values = vec![0.0; force.program().outputs() * u.len()];
        force
            .evaluate(params, Samples { u, v, t: &vec![t; u.len()] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let Some(at) = values.iter().position(|value| !value.is_finite()) else { return Ok(values) };
        let point = at % u.len().max(1);
        let [u, v] = [u, v].map(|all| all.get(point).copied().unwrap_or(f64::NAN));
        let message = format!("the force is not finite at u = {u}, v = {v}, t = {t}");
        Err(Diagnostic::new(Code::DataNotFinite, message).at(self.operator_origin))
    }

    /// The fitted coefficients of a group and their derivatives in t: rows by member and term, a column per component.
    fn fit(
        &self,
        collocation: &Collocation<'_>,
        group: &Group,
        (stated, is_visible): (&[DMatrix<f64>], &[bool]),
        t: f64,
        report: &mut Report,
    ) -> Result<Vec<DMatrix<f64>>, Diagnostic> {
        let unknowns = self.plan.terms * group.members.len();
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
            let message = format!("the system of {} {reason}", self.name(group));
            let origin = group.members.first().and_then(|&j| self.equation.origin(j));
            Diagnostic::new(Code::SolutionNotFinite, message).at(origin)
        };
        let matrix = systems.first().ok_or_else(|| failed("is empty".to_owned()))?;
        let solver = LeastSquares::new(matrix).map_err(|error| failed(format!("cannot be solved: {error}")))?;
        report.condition = report.condition.map(|condition| condition.max(solver.condition()));
        report.rank += solver.rank();
        if solver.rank() < unknowns {
            report.warnings.push(self.deficiency(group, &solver, t));
        }
        let derivatives = solver.derivatives(&systems, &rights);
        if derivatives.iter().flatten().any(|value| !value.is_finite()) {
            return Err(failed("has a solution that is not finite".to_owned()));
        }
        Ok(derivatives)
    }

    /// The finding that names the basis functions whose terms are not determined.
    fn deficiency(&self, group: &Group, solver: &LeastSquares, t: f64) -> Diagnostic {
        let takes_part = |place: usize| {
            let rows = solver.null_space().map(|null| null.rows(place * self.plan.terms, self.plan.terms).norm());
            rows.is_some_and(|norm| norm > LEAST_SHARE)
        };
        let dependent: Vec<usize> =
            group.members.iter().enumerate().filter(|(place, _)| takes_part(*place)).map(|(_, j)| *j).collect();
        let (rank, unknowns, name) = (solver.rank(), solver.unknowns(), self.name(group));
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
            "the points determine {rank} of {unknowns} terms of {name}: on them {} depend on each other at t = {t}; \
             the smallest solution is taken",
            names.join(", ")
        );
        finding(message).hint("fit each basis function alone (`fit = per-basis`), or use more points")
    }

    /// What a system determines, for messages.
    fn name(&self, group: &Group) -> String {
        match (self.plan.fit, group.members.as_slice()) {
            (Fit::PerBasis, [j]) => format!("basis function F{}", j + 1),
            _ => {
                let names = group.components.iter().filter_map(|&component| COMPONENTS.get(component));
                names.map(|name| format!("S_{name}")).collect::<Vec<_>>().join(", ")
            }
        }
    }

    fn empty_report(&self) -> Report {
        Report {
            method: Polynomial.name(),
            is_exact: false,
            basis_size: self.equation.basis.len(),
            closure_size: None,
            modes: self.plan.terms,
            condition: Some(1.0),
            amplification: None,
            truncation: None,
            rank: 0,
            unknowns: 0,
            warnings: self.equation.note.iter().cloned().collect::<Diagnostics>(),
        }
    }
}

/// A basis function takes part in a dependency if its share in the orthonormal directions of the null space is more
/// than what rounding leaves of nothing.
const LEAST_SHARE: f64 = 1e-6;
