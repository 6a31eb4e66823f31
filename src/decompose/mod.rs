//! Factors boundary expressions into basis functions `F_j(v, t)` and vector coefficients.
//!
//! Input: a patch of a [`Problem`]; output: a [`Decomposition`] such that for every condition i
//! `g_i(v, t) = Σ_j c_ij F_j(v, t)` (docs/methods.md, D1; You, Ugail and Zhang 2012, Eq. 6, where the c_ij of
//! the four conditions are b_j, b̄_j, d_j, d̄_j).
//!
//! A basis function is a product of factors that depend on v or t; everything that depends on parameters alone
//! goes to the coefficients. Invariant: the order of the basis is first use in the source, so equal documents
//! give equal bytes. Absent on purpose: numbers. Parameters stay symbols; see
//! [`Bindings`](crate::problem::Bindings).

mod closure;
mod expand;
mod force;
mod latex;
mod text;

pub use closure::{Closure, DerivativeMatrix, close};
pub use force::{SplitForce, split_force};

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Graph};
use crate::limits::Limits;
use crate::problem::{Constraint, Patch, PdeOperator, PdeTerm, Problem};

/// The boundary data of one patch in terms of one basis.
#[derive(Debug, Clone)]
pub struct Decomposition {
    /// The problem's graph, extended by what the decomposition made.
    pub graph: Graph,
    /// The patch it belongs to.
    pub patch: Patch,
    /// The patch's equation, without the terms that [`Decomposition::specialise`] found to be zero.
    pub operator: PdeOperator,
    /// The basis, in order of first use.
    pub basis: Vec<BasisFunction>,
    /// For each condition of the patch, in order, the vector coefficient of each basis function.
    pub coefficients: Vec<Vec<[ExprId; 3]>>,
}

/// One `F_j(v, t)` and the derivatives of it that the equation takes.
#[derive(Debug, Clone)]
pub struct BasisFunction {
    /// The function.
    pub expr: ExprId,
    /// The boundary expression it was first found in.
    pub origin: Option<Span>,
    /// Derivatives in v and t, those of [`PdeOperator::basis_derivatives`](crate::problem::PdeOperator::basis_derivatives)
    /// that exist.
    pub derivatives: Vec<(Derivative, ExprId)>,
    /// Why one of them does not; a problem for methods that take it.
    pub fault: Option<Diagnostic>,
}

impl BasisFunction {
    /// The derivatives that `equation` takes of it, and that do not exist.
    pub fn missing(&self, equation: &PdeOperator) -> impl Iterator<Item = Derivative> {
        let exists = |orders: &Derivative| self.derivatives.iter().any(|(known, _)| known == orders);
        equation.basis_derivatives().into_iter().filter(move |orders| !exists(orders))
    }
}

/// Decomposes the boundary data of `patch`, which belongs to `problem`.
///
/// Where all four sides carry data there is nothing to factor: the basis is empty.
///
/// Cost: the number of monomials of the expanded data, which is bounded.
///
/// # Errors
/// [`Code::LimitReached`] when an expansion or the basis grows past its limit, with the function and its place.
pub fn decompose(problem: &Problem, patch: &Patch, limits: &Limits) -> Result<Decomposition, Diagnostic> {
    let mut graph = problem.graph.clone();
    if patch.is_four_sided() {
        let coefficients = vec![Vec::new(); patch.conditions.len()];
        let operator = patch.operator.clone();
        return Ok(Decomposition { graph, patch: patch.clone(), operator, basis: Vec::new(), coefficients });
    }
    let zero = graph.integer(0);
    let mut forms = expand::Forms::default();
    // For each basis function: its place, and its coefficient in each condition and component.
    type Row = (Option<Span>, Vec<[ExprId; 3]>);
    let mut rows: IndexMap<ExprId, Row, FxBuildHasher> = IndexMap::default();
    for (condition, component) in in_source_order(patch) {
        let Some(stated) = patch.conditions.get(condition) else { continue };
        let (Some(&value), origin) = (stated.value.get(component), stated.origins.get(component).copied().flatten())
        else {
            continue;
        };
        let monomials = expand::expand(&mut graph, value, &mut forms, limits).map_err(|finding| finding.at(origin))?;
        for (function, coefficient) in monomials {
            let empty = || (origin, vec![[zero; 3]; patch.conditions.len()]);
            let (_, coefficients) = rows.entry(function).or_insert_with(empty);
            if let Some(slot) = coefficients.get_mut(condition).and_then(|each| each.get_mut(component)) {
                *slot = coefficient;
            }
            if rows.len() > limits.basis_functions {
                let limit = limits.basis_functions;
                let message =
                    format!("the boundary data need more basis functions than the limit `basis-functions` of {limit}");
                return Err(Diagnostic::new(Code::LimitReached, message).at(origin));
            }
        }
    }
    let wanted = patch.operator.basis_derivatives();
    let mut basis = Vec::with_capacity(rows.len());
    for (&expr, (origin, _)) in &rows {
        let mut derivatives = Vec::with_capacity(wanted.len());
        let mut fault = None;
        for &orders in &wanted {
            match bounded_derivative(&mut graph, expr, orders, limits, *origin) {
                Ok(derivative) => derivatives.push((orders, derivative)),
                Err(finding) if finding.code == Code::NotDifferentiable => fault = fault.or(Some(finding)),
                Err(finding) => return Err(finding),
            }
        }
        basis.push(BasisFunction { expr, origin: *origin, derivatives, fault });
    }
    let coefficients = (0..patch.conditions.len())
        .map(|condition| rows.values().map(|(_, each)| each.get(condition).copied().unwrap_or([zero; 3])).collect())
        .collect();
    Ok(Decomposition { graph, patch: patch.clone(), operator: patch.operator.clone(), basis, coefficients })
}

impl Decomposition {
    /// The derivatives of S that the equation multiplies by zero for these values of the params.
    ///
    /// Never all that decide the order in u: where they vanish, the conditions ask for too much, which a method
    /// explains.
    #[must_use]
    pub fn vanishing(&self, params: &[f64]) -> Vec<Derivative> {
        let terms = &self.patch.operator.terms;
        let is_zero = |expr: &ExprId| {
            self.graph.dependence(*expr).is_constant() && self.graph.value(*expr, params, [f64::NAN; 3]) == 0.0
        };
        let vanishes = |term: &&PdeTerm| term.coefficient.iter().all(is_zero);
        let order = self.patch.operator.order_in_u();
        let leading_vanish = terms.iter().filter(|term| term.derivative.u == order).all(|term| vanishes(&term));
        let found = terms.iter().filter(vanishes).map(|term| term.derivative);
        found.filter(|derivative| derivative.u < order || !leading_vanish).collect()
    }

    /// The constraints of a patch with data on four sides, which no basis stands for; none of any other.
    pub fn sides(&self) -> impl Iterator<Item = Constraint> {
        self.patch.constraints().filter(|_| self.patch.is_four_sided())
    }

    /// Refuses a basis function without a derivative that the patch's equation takes.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`], with the function's place.
    pub fn check_differentiable(&self) -> Result<(), Diagnostic> {
        self.basis.iter().find_map(|function| function.fault.clone()).map_or(Ok(()), Err)
    }

    /// The decomposition with basis functions that have every derivative the equation takes, where splines lack some:
    /// those of their pieces.
    ///
    /// `None` if another function lacks one, or a spline one below half the equation's order in v: its pieces would
    /// meet at an angle that the equation gives no finite energy.
    #[must_use]
    pub fn piecewise(&self, limits: &Limits) -> Option<Decomposition> {
        let mut graph = self.graph.clone();
        let shared = Derivative::new(0, self.operator.order_in_v().div_ceil(2).saturating_sub(1), 0);
        let wanted = self.operator.basis_derivatives();
        let mut basis = Vec::with_capacity(self.basis.len());
        for function in &self.basis {
            if function.fault.is_none() {
                basis.push(function.clone());
                continue;
            }
            graph.derivative_within(function.expr, shared, limits.graph_nodes).ok()?;
            let expr = graph.piecewise(function.expr);
            let mut derived =
                |orders: &Derivative| Some((*orders, graph.derivative_within(expr, *orders, limits.graph_nodes).ok()?));
            let derivatives = wanted.iter().map(&mut derived).collect::<Option<Vec<_>>>()?;
            basis.push(BasisFunction { expr, origin: function.origin, derivatives, fault: None });
        }
        Some(Decomposition { graph, basis, ..self.clone() })
    }

    /// Whether [`Decomposition::operator`] is the equation for these values of the params.
    #[must_use]
    pub fn is_specialised_to(&self, params: &[f64]) -> bool {
        let vanishing = self.vanishing(params);
        let is_left = |derivative: &Derivative| !vanishing.contains(derivative);
        let left = self.patch.operator.terms.iter().map(|term| term.derivative).filter(is_left);
        left.eq(self.operator.terms.iter().map(|term| term.derivative))
    }

    /// Leaves the terms that are zero for these values of the params out of [`Decomposition::operator`]: derivatives
    /// that it no longer takes need not exist, and need no closure.
    #[must_use]
    pub fn specialise(mut self, params: &[f64]) -> Decomposition {
        let vanishing = self.vanishing(params);
        self.operator = self.patch.operator.clone();
        self.operator.terms.retain(|term| !vanishing.contains(&term.derivative));
        self
    }
}

/// Conditions and components in the order in which they are written; those without a place keep theirs.
fn in_source_order(patch: &Patch) -> Vec<(usize, usize)> {
    let mut all: Vec<(usize, usize)> =
        (0..patch.conditions.len()).flat_map(|condition| (0..3).map(move |component| (condition, component))).collect();
    all.sort_by_key(|(condition, component)| {
        patch.conditions.get(*condition).and_then(|stated| stated.origins.get(*component).copied().flatten())
    });
    all
}

/// A derivative of a basis function, or why there is none.
pub(crate) fn bounded_derivative(
    graph: &mut Graph,
    expr: ExprId,
    orders: Derivative,
    limits: &Limits,
    origin: Option<Span>,
) -> Result<ExprId, Diagnostic> {
    let result = graph.derivative_within(expr, orders, limits.graph_nodes);
    result.map_err(|fault| fault.to_diagnostic(orders, limits.graph_nodes).at(origin))
}
