//! The method of You, Ugail and Zhang 2012 (Eqs. 9-18, corrected): K sine terms for each basis function, fitted
//! to the equation at L x M collocation points by least squares.
//!
//! With `G_j(u) = Σ_i ξ_i(u) c_ij + Σ_k ζ_k(u) P_jk` the equation, taken for each basis function alone, reads
//! `Σ_p a_p(v) G_j^(p)(u) = 0`, where `a_p(v, t) = Σ_r c_r ∂F_j` collects the terms of order p in u
//! (docs/methods.md, S1). It is a linear least-squares problem for P_jk at each instant.
//!
//! Where a basis function is no eigenfunction of the operator, the equation cannot hold for it alone, however
//! many terms are taken; the verified residual tells. The method leaves out a force, as the paper does, and
//! therefore refuses one.

mod collocation;

use std::sync::Arc;

use nalgebra::DMatrix;

use super::{Method, Options, Report, Size, Solution, Solver, Terms};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId, Graph};
use crate::limits::Limits;
use crate::numeric::{NodeKind, nodes};
use crate::surface::{Basis, Coefficients, SeparableSurface};
use crate::trial::{CorrectedTrial, Modes, Sine};

use collocation::Collocation;

/// The method `sine`.
pub struct SineSeries;

const DEFAULT_TERMS: usize = 10;
const DEFAULT_POINTS: usize = 11;

impl Method for SineSeries {
    fn name(&self) -> &'static str {
        "sine"
    }

    fn description(&self) -> &'static str {
        "K sine terms per basis function, fitted at L x M points (You, Ugail and Zhang 2012, corrected)"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["terms", "points"]
    }

    fn accepts(&self, decomposition: &Decomposition) -> Result<(), Diagnostic> {
        let (graph, operator) = (&decomposition.graph, &decomposition.patch.operator);
        let refuse = |message: &str| {
            let finding = Diagnostic::new(Code::UnsupportedByMethod, message);
            Err(finding.at(operator.origin))
        };
        if !operator.is_homogeneous(graph) {
            return refuse("the method `sine` leaves out the force, so it cannot treat an equation with one");
        }
        if operator.terms.iter().flat_map(|term| term.coefficient).any(|coefficient| graph.dependence(coefficient).u) {
            return refuse("the method `sine` needs coefficients that do not depend on u");
        }
        Ok(())
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let orders_in_t = decomposition.patch.operator.order_in_t();
        let (terms, points) = sizes(decomposition, options, orders_in_t)?;
        let mut graph = decomposition.graph.clone();
        let operator = Operator::build(&mut graph, decomposition, orders_in_t, &options.limits)?;
        // These run over a handful of nodes for each solution: interpreting them is done before compiling would be.
        let backend = if options.backend == Backend::Auto { Backend::Interpreter } else { options.backend };
        let program = |outputs: &[ExprId]| compile(Program::compile(&graph, outputs), backend);
        let (operator_values, note) = program(&operator.outputs);
        let (constant_values, _) = program(&constants(decomposition));
        let functions = decomposition.basis.iter().map(|function| (function.expr, function.origin)).collect();
        Ok(Box::new(SineSolver {
            terms,
            points,
            orders: decomposition.patch.conditions.iter().map(|condition| condition.order).collect(),
            orders_in_u: operator.orders_in_u,
            orders_in_t,
            is_vector: operator.is_vector,
            origins: decomposition.basis.iter().map(|function| function.origin).collect(),
            operator_values,
            constant_values,
            basis: Arc::new(Basis::new(graph.clone(), functions, options.backend)),
            note,
        }))
    }
}

/// The number of terms and the grid, checked.
fn sizes(decomposition: &Decomposition, options: &Options, orders_in_t: usize) -> Result<(usize, Size), Diagnostic> {
    let (terms, terms_origin) = match options.settings.terms {
        None => (DEFAULT_TERMS, None),
        Some((Terms { first, second: None }, origin)) => (first, origin),
        Some((Terms { second: Some(_), .. }, origin)) => {
            let finding = Diagnostic::new(Code::UnknownSetting, "the method `sine` has one number of terms").at(origin);
            return Err(finding.hint("write `terms = 5`"));
        }
    };
    if terms == 0 {
        let finding = Diagnostic::new(Code::SettingOutOfRange, "the number of terms is 0");
        return Err(finding.at(terms_origin).hint("give at least one: `terms = 5`"));
    }
    let default = Size { u: terms.saturating_add(1).max(DEFAULT_POINTS), v: DEFAULT_POINTS, kind: NodeKind::default() };
    let (points, points_origin) = options.settings.points.unwrap_or((default, None));
    if points.u == 0 || points.v == 0 {
        let message = format!("the grid {} x {} has no points", points.u, points.v);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message).at(points_origin));
    }
    if points.u < terms.saturating_add(1) {
        let message = format!("{} points in u do not determine {terms} terms", points.u);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message)
            .at(points_origin.or(terms_origin))
            .hint(format!("give at least {} points in u", terms.saturating_add(1))));
    }
    let limits = &options.limits;
    let per_row = decomposition.patch.operator.order_in_u() + 1;
    let reduced_rows = points.u.saturating_mul(per_row).saturating_mul(orders_in_t + 1);
    let sizes = [
        ("unknowns", limits.unknowns, terms.saturating_mul(decomposition.basis.len())),
        ("system-entries", limits.system_entries, reduced_rows.saturating_mul(terms)),
        ("samples", limits.samples, points.u.saturating_mul(points.v)),
    ];
    for (name, limit, size) in sizes {
        if size > limit {
            let message = format!(
                "{terms} terms on {} x {} points need {size}, above the limit `{name}` of {limit}",
                points.u, points.v
            );
            return Err(Diagnostic::new(Code::LimitReached, message).at(points_origin.or(terms_origin)));
        }
    }
    Ok((terms, points))
}

/// The functions a_p of every basis function and their derivatives in t, for each component that differs.
struct Operator {
    outputs: Vec<ExprId>,
    orders_in_u: Vec<usize>,
    is_vector: bool,
}

impl Operator {
    /// Outputs in the order: basis function, component (one if they agree), derivative in t, order in u.
    fn build(
        graph: &mut Graph,
        decomposition: &Decomposition,
        orders_in_t: usize,
        limits: &Limits,
    ) -> Result<Operator, Diagnostic> {
        let terms = &decomposition.patch.operator.terms;
        let mut orders_in_u: Vec<usize> = terms.iter().map(|term| term.derivative.u).collect();
        orders_in_u.sort_unstable();
        orders_in_u.dedup();
        let is_vector = terms.iter().any(|term| matches!(term.coefficient, [x, y, z] if x != y || x != z));
        let components = if is_vector { 3 } else { 1 };
        let mut outputs = Vec::new();
        for function in &decomposition.basis {
            for component in 0..components {
                let mut symbols = Vec::with_capacity(orders_in_u.len());
                for &order in &orders_in_u {
                    let mut parts = Vec::new();
                    for term in terms.iter().filter(|term| term.derivative.u == order) {
                        let along = Derivative { u: 0, ..term.derivative };
                        let derivative = function.derivatives.iter().find(|(orders, _)| *orders == along);
                        let derivative = derivative.map_or(function.expr, |(_, expr)| *expr);
                        let coefficient = term.coefficient.get(component).copied().unwrap_or(derivative);
                        parts.push(graph.product([coefficient, derivative]));
                    }
                    symbols.push(graph.sum(parts));
                }
                for order in 0..=orders_in_t {
                    for symbol in &symbols {
                        let in_time = Derivative::new(0, 0, order);
                        outputs.push(crate::decompose::bounded_derivative(
                            graph,
                            *symbol,
                            in_time,
                            limits,
                            function.origin,
                        )?);
                    }
                }
            }
        }
        Ok(Operator { outputs, orders_in_u, is_vector })
    }
}

/// The positions of the conditions, then the coefficients c_ij by condition, basis function and component.
fn constants(decomposition: &Decomposition) -> Vec<ExprId> {
    let positions = decomposition.patch.conditions.iter().map(|condition| condition.u);
    positions.chain(decomposition.coefficients.iter().flatten().flatten().copied()).collect()
}

struct SineSolver {
    terms: usize,
    points: Size,
    /// The order of each boundary condition.
    orders: Vec<usize>,
    orders_in_u: Vec<usize>,
    orders_in_t: usize,
    is_vector: bool,
    origins: Vec<Option<Span>>,
    operator_values: Arc<dyn Evaluator>,
    constant_values: Arc<dyn Evaluator>,
    basis: Arc<Basis>,
    note: Option<Diagnostic>,
}

impl Solver for SineSolver {
    fn solve(&self, params: &[f64], [range_u, range_v]: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let constants = self.constants(params)?;
        let (positions, boundary) = constants.split_at_checked(self.orders.len()).unwrap_or_default();
        let functionals: Vec<(f64, usize)> = positions.iter().copied().zip(self.orders.iter().copied()).collect();
        let modes = CorrectedTrial::new(Arc::new(Sine), self.terms, range_u, &functionals).ok_or_else(|| {
            Diagnostic::new(
                Code::DependentConstraints,
                "with these parameters the constraints do not determine a surface",
            )
        })?;
        let u = nodes(self.points.kind, self.points.u, range_u);
        let v = nodes(self.points.kind, self.points.v, range_v);
        let is_visible = self.visible_on(&v, range_v, t, params)?;
        let symbols = self.operator_on(&v, t, params)?;
        let collocation = Collocation::new(&modes, &self.orders_in_u, &u);
        let count = self.basis.len();
        let mode_count = modes.count();
        let mut coefficients: Vec<Coefficients> = vec![vec![[0.0; 3]; mode_count * count]; self.orders_in_t + 1];
        let mut report = self.empty_report();
        let components = if self.is_vector { 3 } else { 1 };
        let per_function = components * (self.orders_in_t + 1) * self.orders_in_u.len() * v.len();
        for (j, rows) in symbols.chunks(per_function.max(1)).enumerate() {
            // Columns x, y, z of the boundary coefficients of this basis function, one row per condition.
            let stated = DMatrix::from_fn(self.orders.len(), 3, |condition, component| {
                boundary.get((condition * count + j) * 3 + component).copied().unwrap_or(f64::NAN)
            });
            if !is_visible.get(j).copied().unwrap_or(false) && stated.iter().any(|value| *value != 0.0) {
                return Err(self.vanishes(j));
            }
            let fits = self.fit(&collocation, rows, v.len(), &stated, j, &mut report)?;
            for (coefficients, fit) in coefficients.iter_mut().zip(&fits) {
                place(coefficients, count, j, fit);
            }
        }
        let surface = SeparableSurface {
            modes: Arc::new(modes),
            basis: Arc::clone(&self.basis),
            params: params.to_vec(),
            coefficients,
            instant: Some(t),
        };
        Ok(Solution { surface: Arc::new(surface), report })
    }
}

impl SineSolver {
    fn constants(&self, params: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let mut values = vec![0.0; self.constant_values.program().outputs()];
        let nowhere = [0.0];
        self.constant_values
            .evaluate(params, Samples { u: &nowhere, v: &nowhere, t: &nowhere }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(values),
            Some(at) => {
                let j = at.saturating_sub(self.orders.len()) / 3 % self.basis.len().max(1);
                let message =
                    format!("the coefficient of basis function F{} in the boundary data is not finite", j + 1);
                Err(Diagnostic::new(Code::ParameterNotFinite, message).at(self.origin(j)))
            }
        }
    }

    /// The functions a_p at the nodes v, in the order of [`Operator`], each over all nodes.
    fn operator_on(&self, v: &[f64], t: f64, params: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let t = vec![t; v.len()];
        let mut values = vec![0.0; self.operator_values.program().outputs() * v.len()];
        self.operator_values
            .evaluate(params, Samples { u: v, v, t: &t }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let Some(at) = values.iter().position(|value| !value.is_finite()) else { return Ok(values) };
        let per_function = values.len() / self.basis.len().max(1);
        let j = at / per_function.max(1);
        let node = v.get(at % v.len().max(1)).copied().unwrap_or(f64::NAN);
        let message = format!("a derivative of basis function F{} is not finite at v = {node}", j + 1);
        Err(Diagnostic::new(Code::DataNotFinite, message).at(self.origin(j)))
    }

    /// Which basis functions are not zero on all nodes, compared with their size between the nodes.
    fn visible_on(&self, v: &[f64], [low, high]: [f64; 2], t: f64, params: &[f64]) -> Result<Vec<bool>, Diagnostic> {
        // A shift by the golden section of a cell: no function of a whole wave number is zero on both grids.
        let shift = 0.381_966 * (high - low) / v.len() as f64;
        let between: Vec<f64> = v.iter().map(|v| (v + shift).min(high)).collect();
        let size = |v: &[f64]| -> Result<Vec<f64>, Diagnostic> {
            let values = self.basis.values(Derivative::NONE, params, v, &vec![t; v.len()])?;
            Ok(values
                .chunks(v.len())
                .map(|row| row.iter().fold(0.0, |most: f64, value| most.max(value.abs())))
                .collect())
        };
        // Zeros of sin(5v) at rounded nodes come out near 1e-15.
        let is_visible = |(on, between): (f64, f64)| on > 1e-12 * between || between == 0.0;
        Ok(size(v)?.into_iter().zip(size(&between)?).map(is_visible).collect())
    }

    fn vanishes(&self, j: usize) -> Diagnostic {
        let message =
            format!("basis function F{} is zero on every collocation point, so nothing determines its terms", j + 1);
        Diagnostic::new(Code::VanishesOnGrid, message)
            .at(self.origin(j))
            .hint("use midpoints, or another number of points in v")
    }

    /// The boundary and fitted coefficients of one basis function and their derivatives in t: one row per mode.
    fn fit(
        &self,
        collocation: &Collocation,
        rows: &[f64],
        nodes: usize,
        stated: &DMatrix<f64>,
        j: usize,
        report: &mut Report,
    ) -> Result<Vec<DMatrix<f64>>, Diagnostic> {
        let block = (self.orders_in_t + 1) * self.orders_in_u.len() * nodes;
        let mut fits = vec![DMatrix::zeros(self.orders.len() + self.terms, 3); self.orders_in_t + 1];
        if let Some(first) = fits.first_mut() {
            first.rows_mut(0, self.orders.len()).copy_from(stated);
        }
        for (component, rows) in rows.chunks(block.max(1)).enumerate() {
            let columns = if self.is_vector { component..component + 1 } else { 0..3 };
            let right = stated.columns(columns.start, columns.len()).into_owned();
            let fit = collocation.fit(rows, nodes, &right).map_err(|error| {
                let message = format!("the system of basis function F{} cannot be solved: {error}", j + 1);
                Diagnostic::new(Code::SolutionNotFinite, message).at(self.origin(j))
            })?;
            report.condition = report.condition.map(|condition| condition.max(fit.condition));
            report.rank += fit.rank;
            report.unknowns += self.terms;
            if fit.rank < self.terms {
                let message = format!(
                    "the points determine {} of {} terms of basis function F{}; the smallest solution is taken",
                    fit.rank,
                    self.terms,
                    j + 1
                );
                let finding = Diagnostic::new(Code::RankDeficient, message);
                report
                    .warnings
                    .push(finding.at(self.origin(j)).hint("use midpoints, more points in u, or fewer terms"));
            }
            for (all, part) in fits.iter_mut().zip(&fit.derivatives) {
                all.view_mut((self.orders.len(), columns.start), (self.terms, columns.len())).copy_from(part);
            }
        }
        if fits.iter().any(|fit| fit.iter().any(|value| !value.is_finite())) {
            let message = format!("the fit of basis function F{} is not finite", j + 1);
            return Err(Diagnostic::new(Code::SolutionNotFinite, message).at(self.origin(j)));
        }
        Ok(fits)
    }

    fn empty_report(&self) -> Report {
        Report {
            method: SineSeries.name(),
            is_exact: false,
            basis_size: self.basis.len(),
            closure_size: None,
            modes: self.terms,
            condition: Some(1.0),
            amplification: None,
            rank: 0,
            unknowns: 0,
            warnings: self.note.iter().cloned().collect::<Diagnostics>(),
        }
    }

    fn origin(&self, j: usize) -> Option<Span> {
        self.origins.get(j).copied().flatten()
    }
}

/// Writes the coefficients of basis function `j`, one row per mode, into those of all.
fn place(coefficients: &mut Coefficients, count: usize, j: usize, fit: &DMatrix<f64>) {
    for (row, slot) in fit.row_iter().zip(coefficients.iter_mut().skip(j).step_by(count.max(1))) {
        for (component, value) in slot.iter_mut().zip(row.iter()) {
            // Adding zero turns -0 into 0, which reads better.
            *component = *value + 0.0;
        }
    }
}
