//! Symbolic derivatives in u, v and t.
//!
//! Each order is simplified before the next is taken, and every shared subexpression is differentiated once,
//! so the graph grows by a constant factor an order, not exponentially.

use std::fmt;

use rustc_hash::FxHashMap;

use super::display::{Notation, superscripts};
use super::function::Function;
use super::graph::{ExprId, Graph, Node, Variable};
use crate::diagnostic::{Code, Diagnostic};

/// Orders of differentiation in u, v and t.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, PartialOrd, Ord)]
pub struct Derivative {
    /// Order in u.
    pub u: usize,
    /// Order in v.
    pub v: usize,
    /// Order in t.
    pub t: usize,
}

impl Derivative {
    /// No differentiation.
    pub const NONE: Derivative = Derivative::new(0, 0, 0);

    /// `u` times in u, `v` times in v, `t` times in t.
    #[must_use]
    pub const fn new(u: usize, v: usize, t: usize) -> Self {
        Derivative { u, v, t }
    }

    /// Reads the compact spelling: `uuv`, `tt`; the order of letters does not matter.
    #[must_use]
    pub fn parse(text: &str) -> Option<Derivative> {
        let mut orders = Derivative::NONE;
        for letter in text.chars() {
            match letter {
                'u' => orders.u += 1,
                'v' => orders.v += 1,
                't' => orders.t += 1,
                _ => return None,
            }
        }
        Some(orders)
    }

    /// The derivative of `what` as mathematicians write it: `∂⁴S/∂u²∂v²`, `d4S/du2dv2`, `\frac{\partial^{4} S}{…}`.
    #[must_use]
    pub fn of(self, what: &str, notation: Notation) -> String {
        let total = self.u.saturating_add(self.v).saturating_add(self.t);
        if total == 0 {
            return what.to_owned();
        }
        let power = |order: usize| match (order, notation) {
            (1, _) => String::new(),
            (_, Notation::Ascii) => order.to_string(),
            (_, Notation::Unicode) => superscripts(order),
            (_, Notation::Latex) => format!("^{{{order}}}"),
        };
        let d = match notation {
            Notation::Ascii => "d",
            Notation::Unicode => "∂",
            Notation::Latex => r"\partial ",
        };
        let below = Variable::ALL.into_iter().filter(|variable| self.order(*variable) > 0);
        let below: Vec<String> =
            below.map(|variable| format!("{d}{}{}", variable.name(), power(self.order(variable)))).collect();
        match notation {
            Notation::Latex => {
                format!(r"\frac{{\partial{} {what}}}{{{}}}", power(total), below.join(r"\, "))
            }
            _ => format!("{d}{}{what}/{}", power(total), below.concat()),
        }
    }

    /// The order in one variable.
    #[must_use]
    pub fn order(self, variable: Variable) -> usize {
        match variable {
            Variable::U => self.u,
            Variable::V => self.v,
            Variable::T => self.t,
        }
    }

    /// The largest of the three orders.
    #[must_use]
    pub fn largest(self) -> usize {
        self.u.max(self.v).max(self.t)
    }
}

impl fmt::Display for Derivative {
    /// The compact spelling, for example `uuv`; empty for no differentiation.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for variable in Variable::ALL {
            f.write_str(&variable.name().repeat(self.order(variable)))?;
        }
        Ok(())
    }
}

/// What stopped a differentiation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotDifferentiable {
    /// A function without a derivative, such as `abs`.
    Function(Function),
    /// A spline whose pieces meet less smoothly.
    Spline {
        /// What the user calls it.
        name: String,
        /// The highest derivative it has.
        highest: usize,
    },
}

/// Why a bounded differentiation ended without a result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DerivativeFault {
    /// There is no derivative.
    NotDifferentiable(NotDifferentiable),
    /// The graph grew past what was allowed.
    TooLarge,
}

impl DerivativeFault {
    /// The finding for a derivative of the given orders that was to stay within `allowed`; it has no place yet.
    #[must_use]
    pub fn to_diagnostic(self, orders: Derivative, allowed: usize) -> Diagnostic {
        match self {
            DerivativeFault::NotDifferentiable(NotDifferentiable::Function(function)) => {
                let name = function.row().name;
                let message = format!("`{name}` has no derivative, and its derivative `{orders}` is needed");
                Diagnostic::new(Code::NotDifferentiable, message).hint("use a smooth function in its place")
            }
            DerivativeFault::NotDifferentiable(NotDifferentiable::Spline { name, highest }) => {
                let message = format!(
                    "`{name}` is made of polynomials that fit together up to derivative {highest}, and its derivative \
                     `{orders}` is needed"
                );
                Diagnostic::new(Code::NotDifferentiable, message)
                    .hint("`solve fourier` needs no derivatives of boundary data; or take an equation of lower order")
            }
            DerivativeFault::TooLarge => {
                let message =
                    format!("the derivatives have more distinct parts than the limit `graph-nodes` of {allowed}");
                Diagnostic::new(Code::LimitReached, message).hint("use fewer factors, or functions nested less deeply")
            }
        }
    }
}

impl From<NotDifferentiable> for DerivativeFault {
    fn from(fault: NotDifferentiable) -> Self {
        DerivativeFault::NotDifferentiable(fault)
    }
}

/// Operands that may be merged for each unit of size that is allowed; problems of papers take a few in all.
const WORK_PER_SIZE: usize = 10;

/// What a differentiation may reach.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    size: usize,
    work: usize,
}

impl Graph {
    /// The derivative of `expr`, in canonical form.
    ///
    /// # Errors
    /// [`NotDifferentiable`] names a function of the differentiation variable that has no derivative.
    pub fn derivative(&mut self, expr: ExprId, orders: Derivative) -> Result<ExprId, NotDifferentiable> {
        self.derivative_within(expr, orders, usize::MAX).map_err(|fault| match fault {
            DerivativeFault::NotDifferentiable(fault) => fault,
            DerivativeFault::TooLarge => unreachable!("no graph has a size of usize::MAX"),
        })
    }

    /// The derivative of `expr`, as [`Graph::derivative`], while the graph's [`size`](Graph::size) is at most `allowed`.
    ///
    /// Each order multiplies the size of nested functions and products, so it is watched at every node.
    ///
    /// # Errors
    /// [`DerivativeFault`].
    pub fn derivative_within(
        &mut self,
        expr: ExprId,
        orders: Derivative,
        allowed: usize,
    ) -> Result<ExprId, DerivativeFault> {
        let bounds = Bounds { size: allowed, work: self.work().saturating_add(allowed.saturating_mul(WORK_PER_SIZE)) };
        let mut result = expr;
        for variable in Variable::ALL {
            for _ in 0..orders.order(variable) {
                result = self.derivative_once(result, variable, bounds)?;
            }
        }
        Ok(result)
    }

    fn derivative_once(&mut self, expr: ExprId, variable: Variable, bounds: Bounds) -> Result<ExprId, DerivativeFault> {
        if let Some(known) = self.known_derivative(expr, variable) {
            return Ok(known);
        }
        let zero = self.integer(0);
        let mut known: FxHashMap<ExprId, ExprId> = FxHashMap::default();
        for id in self.reachable(&[expr]) {
            if let Some(derivative) = self.known_derivative(id, variable) {
                known.insert(id, derivative);
                continue;
            }
            let depends = self.dependence(id);
            let depends_on_variable = match variable {
                Variable::U => depends.u,
                Variable::V => depends.v,
                Variable::T => depends.t,
            };
            let result = if depends_on_variable { self.derivative_of_node(id, &known, bounds)? } else { zero };
            known.insert(id, result);
            self.remember_derivative(id, variable, result);
        }
        Ok(known.get(&expr).copied().unwrap_or(zero))
    }

    /// The derivative of a node that depends on the variable, from those of its operands.
    fn derivative_of_node(
        &mut self,
        id: ExprId,
        known: &FxHashMap<ExprId, ExprId>,
        bounds: Bounds,
    ) -> Result<ExprId, DerivativeFault> {
        self.check(bounds)?;
        let zero = self.integer(0);
        let inner = |id: &ExprId| known.get(id).copied().unwrap_or(zero);
        match self.node(id).clone() {
            Node::Variable(_) => Ok(self.integer(1)),
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Ok(zero),
            Node::Sum(terms) => {
                let derivatives: Vec<ExprId> = terms.iter().map(inner).collect();
                Ok(self.sum(derivatives))
            }
            Node::Product(factors) => {
                let mut terms = Vec::with_capacity(factors.len());
                for (index, factor) in factors.iter().enumerate() {
                    let derivative = inner(factor);
                    if !self.is_zero(derivative) {
                        let others = factors.iter().enumerate().filter(|(other, _)| *other != index);
                        let product: Vec<ExprId> = others.map(|(_, &other)| other).chain([derivative]).collect();
                        terms.push(self.product(product));
                        self.check(bounds)?;
                    }
                }
                Ok(self.sum(terms))
            }
            Node::Power(base, exponent) => {
                Ok(self.power_derivative(id, (base, inner(&base)), (exponent, inner(&exponent))))
            }
            Node::Call(function, arguments) => {
                let mut terms = Vec::with_capacity(arguments.len());
                for (index, argument) in arguments.iter().enumerate() {
                    let derivative = inner(argument);
                    if !self.is_zero(derivative) {
                        let partial =
                            function.partial(self, &arguments, index).ok_or(NotDifferentiable::Function(function))?;
                        terms.push(self.product([partial, derivative]));
                    }
                }
                Ok(self.sum(terms))
            }
            Node::Spline(call, arguments) => {
                let mut terms = Vec::with_capacity(arguments.len());
                for (index, argument) in arguments.iter().enumerate() {
                    let derivative = inner(argument);
                    if !self.is_zero(derivative) {
                        let name = call.spline.name();
                        let partial = call
                            .differentiated(index)
                            .map_err(|highest| NotDifferentiable::Spline { name: name.to_owned(), highest })?;
                        let partial = self.spline(partial, &arguments);
                        terms.push(self.product([partial, derivative]));
                    }
                }
                Ok(self.sum(terms))
            }
        }
    }

    fn check(&self, bounds: Bounds) -> Result<(), DerivativeFault> {
        let is_within = self.size() <= bounds.size && self.work() <= bounds.work;
        if is_within { Ok(()) } else { Err(DerivativeFault::TooLarge) }
    }

    /// `(f^g)' = g f^(g-1) f' + f^g ln(f) g'`
    fn power_derivative(&mut self, power: ExprId, base: (ExprId, ExprId), exponent: (ExprId, ExprId)) -> ExprId {
        let mut terms = Vec::new();
        if !self.is_zero(base.1) {
            let minus_one = self.integer(-1);
            let reduced = self.sum([exponent.0, minus_one]);
            let lowered = self.power(base.0, reduced);
            terms.push(self.product([exponent.0, lowered, base.1]));
        }
        if !self.is_zero(exponent.1) {
            let logarithm = self.call(Function::Ln, &[base.0]);
            terms.push(self.product([power, logarithm, exponent.1]));
        }
        self.sum(terms)
    }
}
