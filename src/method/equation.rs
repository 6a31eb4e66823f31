//! The equation on a basis, as programs that fitted methods run at their collocation points.
//!
//! For `S = Σ_j F_j(v, t) G_j(u)` the equation reads `Σ_j Σ_p a_jp(u, v, t) G_j^(p)(u) = q`, where
//! `a_jp = Σ_r c_r ∂F_j` collects the terms of order p in u (docs/methods.md, S1). Here are the a_jp with their
//! derivatives in t, the boundary data as numbers, and the check that points see every basis function. Everything
//! but the numbers is compiled once.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::{Options, Size};
use crate::decompose::{Decomposition, bounded_derivative};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId, Graph, Node};
use crate::limits::Limits;
use crate::numeric::nodes;
use crate::surface::{Basis, Coefficients, SeparableSurface};
use crate::trial::{CorrectedTrial, TrialFamily};

/// What a fit at L x M points begins with.
pub struct Discretisation {
    /// The numbers of the boundary conditions.
    pub boundary: Boundary,
    /// The functions of u.
    pub modes: CorrectedTrial,
    /// Nodes in u.
    pub u: Vec<f64>,
    /// Nodes in v.
    pub v: Vec<f64>,
    /// Which basis functions the nodes in v see.
    pub is_visible: Vec<bool>,
}

/// A compiled equation.
pub struct Equation {
    /// The order of each boundary condition.
    pub orders: Vec<usize>,
    /// The orders in u that occur.
    pub orders_in_u: Vec<usize>,
    /// The highest derivative in t.
    pub orders_in_t: usize,
    /// The basis F_j.
    pub basis: Arc<Basis>,
    /// What the user should know about the machine.
    pub note: Option<Diagnostic>,
    is_vector: bool,
    origins: Vec<Option<Span>>,
    symbol_values: Arc<dyn Evaluator>,
    /// As the symbols, over the basis function; zeros where that leaves something that depends on v or t.
    quotient_values: Arc<dyn Evaluator>,
    /// Which basis functions the equation only multiplies by functions of u.
    has_quotients: Vec<bool>,
    boundary_values: Arc<dyn Evaluator>,
}

/// The numbers of the boundary conditions.
pub struct Boundary {
    /// Position and order of each condition.
    pub functionals: Vec<(f64, usize)>,
    /// By condition, basis function and component.
    coefficients: Vec<f64>,
    count: usize,
}

impl Boundary {
    /// The boundary coefficients of basis function `j`: a row per condition, columns x, y, z.
    pub fn stated(&self, j: usize) -> DMatrix<f64> {
        DMatrix::from_fn(self.functionals.len(), 3, |condition, component| {
            self.coefficients.get((condition * self.count + j) * 3 + component).copied().unwrap_or(f64::NAN)
        })
    }
}

impl Equation {
    /// Compiles the equation of `decomposition`; its basis is evaluated as `options` say.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] when a derivative in t that the solution needs does not exist,
    /// [`Code::LimitReached`] when it grows too large.
    pub fn compile(decomposition: &Decomposition, options: &Options) -> Result<Equation, Diagnostic> {
        decomposition.check_differentiable()?;
        let backend = options.backend;
        let orders_in_t = decomposition.patch.operator.order_in_t();
        let mut graph = decomposition.graph.clone();
        let symbols = Symbols::build(&mut graph, decomposition, orders_in_t, &options.limits)?;
        let quotients = Quotients::build(&mut graph, decomposition, (&symbols, orders_in_t), &options.limits)?;
        // These run over a handful of nodes for each solution: interpreting them is done before compiling would be.
        let nodal = if backend == Backend::Auto { Backend::Interpreter } else { backend };
        let program = |outputs: &[ExprId]| compile(Program::compile(&graph, outputs), nodal);
        let (symbol_values, note) = program(&symbols.outputs);
        let (quotient_values, _) = program(&quotients.outputs);
        let (boundary_values, _) = program(&boundary(decomposition));
        let functions: Vec<_> = decomposition.basis.iter().map(|function| (function.expr, function.origin)).collect();
        Ok(Equation {
            orders: decomposition.patch.conditions.iter().map(|condition| condition.order).collect(),
            orders_in_u: symbols.orders_in_u,
            orders_in_t,
            is_vector: symbols.is_vector,
            origins: decomposition.basis.iter().map(|function| function.origin).collect(),
            symbol_values,
            quotient_values,
            has_quotients: quotients.exist,
            boundary_values,
            basis: Arc::new(Basis::new(&graph, &functions, backend, &options.limits)),
            note,
        })
    }

    /// Whether coefficients differ between components.
    pub fn is_vector(&self) -> bool {
        self.is_vector
    }

    /// How many values of [`Equation::symbols_at`] belong to one basis function and component: derivatives in t times
    /// orders in u times `points`.
    pub fn values_per_component(&self, points: usize) -> usize {
        (self.orders_in_t + 1) * self.orders_in_u.len() * points
    }

    /// How many values of [`Equation::symbols_at`] belong to one basis function.
    pub fn values_per_function(&self, points: usize) -> usize {
        self.values_per_component(points) * if self.is_vector { 3 } else { 1 }
    }

    /// Positions and coefficients of the boundary data.
    ///
    /// # Errors
    /// [`Code::ParameterNotFinite`] when one is not finite.
    pub fn boundary(&self, params: &[f64]) -> Result<Boundary, Diagnostic> {
        let mut values = vec![0.0; self.boundary_values.program().outputs()];
        let nowhere = [0.0];
        self.boundary_values
            .evaluate(params, Samples { u: &nowhere, v: &nowhere, t: &nowhere }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            let j = at.saturating_sub(self.orders.len()) / 3 % self.basis.len().max(1);
            let message = format!("the coefficient of basis function F{} in the boundary data is not finite", j + 1);
            return Err(Diagnostic::new(Code::ParameterNotFinite, message).at(self.origin(j)));
        }
        let (positions, coefficients) = values.split_at_checked(self.orders.len()).unwrap_or_default();
        Ok(Boundary {
            functionals: positions.iter().copied().zip(self.orders.iter().copied()).collect(),
            coefficients: coefficients.to_vec(),
            count: self.basis.len(),
        })
    }

    /// Evaluates the boundary, and `count` functions of `family` that are corrected for it, for a grid of points.
    ///
    /// # Errors
    /// As [`Equation::boundary`] and [`Basis::values`]; [`Code::DependentConstraints`].
    pub fn discretise(
        &self,
        (family, count): (Arc<dyn TrialFamily>, usize),
        points: Size,
        (params, [range_u, range_v], t): (&[f64], [[f64; 2]; 2], f64),
    ) -> Result<Discretisation, Diagnostic> {
        let boundary = self.boundary(params)?;
        let modes = self.modes(family, count, range_u, &boundary)?;
        let (u, v) = (nodes(points.kind, points.u, range_u), nodes(points.kind, points.v, range_v));
        let is_visible = self.visible_on(&v, range_v, t, params)?;
        Ok(Discretisation { boundary, modes, u, v, is_visible })
    }

    /// Coefficients for `modes` functions of u and their derivatives in t, all zero.
    pub fn no_coefficients(&self, modes: usize) -> Vec<Coefficients> {
        vec![vec![[0.0; 3]; modes * self.basis.len()]; self.orders_in_t + 1]
    }

    /// The surface with these coefficients, which hold at `t` alone.
    pub fn surface(
        &self,
        modes: Arc<CorrectedTrial>,
        coefficients: Vec<Coefficients>,
        params: &[f64],
        t: f64,
    ) -> SeparableSurface {
        SeparableSurface {
            modes,
            basis: Arc::clone(&self.basis),
            params: params.to_vec(),
            coefficients: Arc::new(coefficients),
            instant: Some(t),
        }
    }

    /// `count` functions of `family`, corrected for the boundary.
    ///
    /// # Errors
    /// [`Code::DependentConstraints`].
    pub fn modes(
        &self,
        family: Arc<dyn TrialFamily>,
        count: usize,
        range: [f64; 2],
        boundary: &Boundary,
    ) -> Result<CorrectedTrial, Diagnostic> {
        CorrectedTrial::new(family, count, range, &boundary.functionals).ok_or_else(|| {
            let message = "with these parameters the constraints do not determine a surface";
            Diagnostic::new(Code::DependentConstraints, message)
        })
    }

    /// The a_jp at points (u, v): by basis function, component (one if they agree), derivative in t, order in u, point.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`] for the first that is not finite.
    pub fn symbols_at(&self, u: &[f64], v: &[f64], t: f64, params: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        self.finite_values(&*self.symbol_values, (u, v, t), params)
    }

    /// Whether the equation only multiplies basis function `j`, by functions κ_jp of u.
    pub fn has_quotients(&self, j: usize) -> bool {
        self.has_quotients.get(j).copied().unwrap_or(false)
    }

    /// The κ_jp = a_jp / F_j at `u`, in the order of [`Equation::symbols_at`]; zeros of functions without.
    ///
    /// # Errors
    /// As [`Equation::symbols_at`].
    pub fn quotients_at(&self, u: &[f64], t: f64, params: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        // They do not depend on v or t, so any will do.
        self.finite_values(&*self.quotient_values, (u, u, t), params)
    }

    fn finite_values(
        &self,
        evaluator: &dyn Evaluator,
        (u, v, t): (&[f64], &[f64], f64),
        params: &[f64],
    ) -> Result<Vec<f64>, Diagnostic> {
        let times = vec![t; v.len()];
        let mut values = vec![0.0; evaluator.program().outputs() * v.len()];
        evaluator
            .evaluate(params, Samples { u, v, t: &times }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let Some(at) = values.iter().position(|value| !value.is_finite()) else { return Ok(values) };
        let j = at / self.values_per_function(v.len()).max(1);
        let node = at % v.len().max(1);
        let [u, v] = [u, v].map(|all| Shortest(all.get(node).copied().unwrap_or(f64::NAN)));
        let t = Shortest(t);
        let message = format!("the equation for basis function F{} is not finite at u = {u}, v = {v}, t = {t}", j + 1);
        let finding = Diagnostic::new(Code::DataNotFinite, message).at(self.origin(j));
        Err(finding.hint("a derivative of the function or a coefficient of the equation has a pole, or overflows"))
    }

    /// Which basis functions are not zero on all nodes, compared with their size between the nodes.
    ///
    /// # Errors
    /// As [`Basis::values`].
    pub fn visible_on(
        &self,
        v: &[f64],
        [low, high]: [f64; 2],
        t: f64,
        params: &[f64],
    ) -> Result<Vec<bool>, Diagnostic> {
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

    /// The finding for a basis function that the points do not see.
    pub fn vanishes(&self, j: usize) -> Diagnostic {
        let message =
            format!("basis function F{} is zero on every collocation point, so nothing determines its terms", j + 1);
        Diagnostic::new(Code::VanishesOnGrid, message)
            .at(self.origin(j))
            .hint("use midpoints, or another number of points in v")
    }

    /// Where basis function `j` is written.
    pub fn origin(&self, j: usize) -> Option<Span> {
        self.origins.get(j).copied().flatten()
    }
}

/// The functions a_jp and their derivatives in t, for each component that differs.
struct Symbols {
    outputs: Vec<ExprId>,
    orders_in_u: Vec<usize>,
    is_vector: bool,
}

impl Symbols {
    /// Outputs in the order: basis function, component (one if they agree), derivative in t, order in u.
    fn build(
        graph: &mut Graph,
        decomposition: &Decomposition,
        orders_in_t: usize,
        limits: &Limits,
    ) -> Result<Symbols, Diagnostic> {
        let operator = &decomposition.patch.operator;
        let terms = &operator.terms;
        // Asked for here so that a coefficient at fault is named with its own place, not that of a basis function.
        for coefficient in terms.iter().flat_map(|term| term.coefficient) {
            let in_time = Derivative::new(0, 0, orders_in_t);
            bounded_derivative(graph, coefficient, in_time, limits, operator.origin)?;
        }
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
                        outputs.push(bounded_derivative(graph, *symbol, in_time, limits, function.origin)?);
                    }
                }
            }
        }
        Ok(Symbols { outputs, orders_in_u, is_vector })
    }
}

/// The κ_jp, in the order of [`Symbols`].
struct Quotients {
    outputs: Vec<ExprId>,
    exist: Vec<bool>,
}

impl Quotients {
    fn build(
        graph: &mut Graph,
        decomposition: &Decomposition,
        (symbols, orders_in_t): (&Symbols, usize),
        limits: &Limits,
    ) -> Result<Quotients, Diagnostic> {
        // Terms that are zero would leave 0/t of them.
        let terms = &decomposition.operator.terms;
        let (mut outputs, mut exist) = (Vec::with_capacity(symbols.outputs.len()), Vec::new());
        let per_function = symbols.outputs.len().checked_div(decomposition.basis.len()).unwrap_or(0);
        let zero = graph.integer(0);
        for function in &decomposition.basis {
            let mut of_function = Vec::with_capacity(per_function);
            for component in 0..if symbols.is_vector { 3 } else { 1 } {
                let mut quotients = Vec::with_capacity(symbols.orders_in_u.len());
                for &order in &symbols.orders_in_u {
                    let mut parts = Vec::new();
                    for term in terms.iter().filter(|term| term.derivative.u == order) {
                        let along = Derivative { u: 0, ..term.derivative };
                        let derivative = function.derivatives.iter().find(|(orders, _)| *orders == along);
                        let derivative = derivative.map_or(function.expr, |(_, expr)| *expr);
                        let share = over(graph, derivative, function.expr);
                        let coefficient = term.coefficient.get(component).copied().unwrap_or(share);
                        parts.push(graph.product([coefficient, share]));
                    }
                    quotients.push(graph.sum(parts));
                }
                // One that depends on t may have a pole where the function has a zero.
                let is_of_u = |quotient: &ExprId| !graph.dependence(*quotient).v && !graph.dependence(*quotient).t;
                quotients.retain(is_of_u);
                for order in 0..=orders_in_t {
                    for quotient in &quotients {
                        let in_time = Derivative::new(0, 0, order);
                        of_function.push(bounded_derivative(graph, *quotient, in_time, limits, function.origin)?);
                    }
                }
            }
            // Others are missing.
            let exists = of_function.len() == per_function;
            exist.push(exists);
            outputs.extend(if exists { of_function } else { vec![zero; per_function] });
        }
        Ok(Quotients { outputs, exist })
    }
}

/// `value / function`, divided factor by factor so that equal ones cancel.
fn over(graph: &mut Graph, value: ExprId, function: ExprId) -> ExprId {
    let factors = match graph.node(function) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![function],
    };
    let inverse: Vec<ExprId> = factors.into_iter().map(|factor| graph.power_integer(factor, -1)).collect();
    graph.product(inverse.into_iter().chain([value]))
}

/// The positions of the conditions, then the coefficients c_ij by condition, basis function and component.
fn boundary(decomposition: &Decomposition) -> Vec<ExprId> {
    let positions = decomposition.patch.conditions.iter().map(|condition| condition.u);
    positions.chain(decomposition.coefficients.iter().flatten().flatten().copied()).collect()
}

/// Writes rows `from..` of the coefficients of basis function `j`, one row per mode and the columns `components`, into
/// those of all `count` functions.
pub fn place(
    coefficients: &mut Coefficients,
    (j, count): (usize, usize),
    from: usize,
    components: &[usize],
    rows: &DMatrix<f64>,
) {
    for (row, slot) in rows.row_iter().zip(coefficients.iter_mut().skip(j).step_by(count.max(1)).skip(from)) {
        for (&component, value) in components.iter().zip(row.iter()) {
            if let Some(target) = slot.get_mut(component) {
                // Adding zero turns -0 into 0, which reads better.
                *target = *value + 0.0;
            }
        }
    }
}
