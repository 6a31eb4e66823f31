//! THE operator table: one row per function decides its name, arity, value, derivative and symmetry.
//!
//! Readers, printers, evaluators and tests all iterate [`Function::ALL`]; a new function is one row here.
//! Values come from [`kernels`](crate::kernels) and from `libm`, never from the platform, so that every machine and
//! both evaluators agree.

use crate::kernels::elementary;

use super::graph::{ExprId, Graph};
use super::number::Number;

/// What `f(-x)` is in terms of `f(x)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parity {
    /// `f(-x) = f(x)`.
    Even,
    /// `f(-x) = -f(x)`.
    Odd,
    /// Neither.
    Neither,
}

/// The value of a function.
#[derive(Debug, Clone, Copy)]
pub enum Value {
    /// Of one argument.
    Unary(fn(f64) -> f64),
    /// Of two arguments.
    Binary(fn(f64, f64) -> f64),
}

/// The partial derivative of a function with respect to one of its arguments, as an expression in the
/// arguments; `None` where the function has none.
type Partial = fn(&mut Graph, &[ExprId], usize) -> Option<ExprId>;

/// One row of the operator table.
pub struct Row {
    /// The name in specs and in text output.
    pub name: &'static str,
    /// The LaTeX command or operator.
    pub latex: &'static str,
    /// How the value is computed.
    pub value: Value,
    /// Symmetry under a sign change of the argument.
    pub parity: Parity,
    partial: Partial,
}

macro_rules! functions {
    ($($variant:ident $name:literal $latex:literal $parity:ident $kind:ident($value:expr) $partial:expr;)*) => {
        /// A named function of one or two arguments.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Function { $(#[doc = concat!("`", $name, "`")] $variant,)* }

        impl Function {
            /// Every function, in table order.
            pub const ALL: &[Function] = &[$(Function::$variant,)*];

            /// The table row.
            #[must_use]
            pub fn row(self) -> &'static Row {
                match self {
                    $(Function::$variant => {
                        static ROW: Row = Row {
                            name: $name, latex: $latex, value: Value::$kind($value),
                            parity: Parity::$parity, partial: $partial,
                        };
                        &ROW
                    })*
                }
            }
        }
    };
}

functions! {
    Sin   "sin"   r"\sin"   Odd     Unary(elementary::sin)   |g, a, _| Some(g.call(Function::Cos, a));
    Cos   "cos"   r"\cos"   Even    Unary(elementary::cos)   |g, a, _| { let s = g.call(Function::Sin, a); Some(g.neg(s)) };
    Tan   "tan"   r"\tan"   Odd     Unary(elementary::tan)   |g, a, _| Some(one_plus_square(g, Function::Tan, a));
    Cot   "cot"   r"\cot"   Odd     Unary(cot)         |g, a, _| { let s = one_plus_square(g, Function::Cot, a); Some(g.neg(s)) };
    Sec   "sec"   r"\sec"   Even    Unary(sec)         |g, a, _| Some(product_of_calls(g, Function::Sec, Function::Tan, a));
    Csc   "csc"   r"\csc"   Odd     Unary(csc)         |g, a, _| { let p = product_of_calls(g, Function::Csc, Function::Cot, a); Some(g.neg(p)) };
    Asin  "asin"  r"\arcsin" Odd    Unary(libm::asin)  |g, a, _| { let d = quadratic(g, 1, -1, a); Some(inverse_root(g, d)) };
    Acos  "acos"  r"\arccos" Neither Unary(libm::acos) |g, a, _| { let d = quadratic(g, 1, -1, a); let r = inverse_root(g, d); Some(g.neg(r)) };
    Atan  "atan"  r"\arctan" Odd    Unary(libm::atan)  |g, a, _| { let d = quadratic(g, 1, 1, a); Some(g.inverse(d)) };
    Atan2 "atan2" r"\operatorname{atan2}" Neither Binary(libm::atan2) atan2_partial;
    Sinh  "sinh"  r"\sinh"  Odd     Unary(elementary::sinh)  |g, a, _| Some(g.call(Function::Cosh, a));
    Cosh  "cosh"  r"\cosh"  Even    Unary(elementary::cosh)  |g, a, _| Some(g.call(Function::Sinh, a));
    Tanh  "tanh"  r"\tanh"  Odd     Unary(elementary::tanh)  |g, a, _| { let f = g.call(Function::Tanh, a); Some(quadratic(g, 1, -1, &[f])) };
    Asinh "asinh" r"\operatorname{arsinh}" Odd Unary(libm::asinh) |g, a, _| { let d = quadratic(g, 1, 1, a); Some(inverse_root(g, d)) };
    Acosh "acosh" r"\operatorname{arcosh}" Neither Unary(libm::acosh) acosh_partial;
    Atanh "atanh" r"\operatorname{artanh}" Odd Unary(libm::atanh) |g, a, _| { let d = quadratic(g, 1, -1, a); Some(g.inverse(d)) };
    Exp   "exp"   r"\exp"   Neither Unary(elementary::exp)   |g, a, _| Some(g.call(Function::Exp, a));
    Ln    "ln"    r"\ln"    Neither Unary(elementary::ln)  |g, a, _| first(a).map(|x| g.inverse(x));
    Log10 "log10" r"\log_{10}" Neither Unary(libm::log10) log10_partial;
    Cbrt  "cbrt"  r"\operatorname{cbrt}" Odd Unary(libm::cbrt) cbrt_partial;
    Abs   "abs"   r"\operatorname{abs}" Even Unary(f64::abs) |_, _, _| None;
    Sign  "sign"  r"\operatorname{sgn}" Odd Unary(sign) |_, _, _| None;
    Floor "floor" r"\operatorname{floor}" Neither Unary(libm::floor) |_, _, _| None;
    Min   "min"   r"\min"   Neither Binary(min)        |_, _, _| None;
    Max   "max"   r"\max"   Neither Binary(max)        |_, _, _| None;
    Pow   "pow"   r"\operatorname{pow}" Neither Binary(libm::pow) |_, _, _| None;
}

impl Function {
    /// The function a spec calls `name`, aliases included.
    #[must_use]
    pub fn named(name: &str) -> Option<Function> {
        match name {
            "log" => Some(Function::Ln),
            "arcsin" => Some(Function::Asin),
            "arccos" => Some(Function::Acos),
            "arctan" => Some(Function::Atan),
            // `pow` exists for evaluators only: specs write `a^b`.
            "pow" => None,
            _ => Function::ALL.iter().copied().find(|function| function.row().name == name),
        }
    }

    /// The number of arguments.
    #[must_use]
    pub fn arity(self) -> usize {
        match self.row().value {
            Value::Unary(_) => 1,
            Value::Binary(_) => 2,
        }
    }

    /// The partial derivative with respect to argument `index`, or `None` where the function has none.
    pub(super) fn partial(self, graph: &mut Graph, arguments: &[ExprId], index: usize) -> Option<ExprId> {
        (self.row().partial)(graph, arguments, index)
    }
}

fn cot(x: f64) -> f64 {
    1.0 / elementary::tan(x)
}

fn sec(x: f64) -> f64 {
    1.0 / elementary::cos(x)
}

fn csc(x: f64) -> f64 {
    1.0 / elementary::sin(x)
}

/// -1, 0 or 1; zero keeps its sign, NaN stays NaN.
fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// The smaller argument; NaN if either is, unlike `f64::min`, so that a fault is never hidden.
fn min(x: f64, y: f64) -> f64 {
    if x.is_nan() || x < y || (x == y && x.is_sign_negative()) { x } else { y }
}

/// The larger argument; NaN if either is.
fn max(x: f64, y: f64) -> f64 {
    if x.is_nan() || x > y || (x == y && x.is_sign_positive()) { x } else { y }
}

fn first(arguments: &[ExprId]) -> Option<ExprId> {
    arguments.first().copied()
}

/// `1 + f(x)^2`
fn one_plus_square(graph: &mut Graph, function: Function, arguments: &[ExprId]) -> ExprId {
    let value = graph.call(function, arguments);
    quadratic(graph, 1, 1, &[value])
}

/// `constant + factor x^2`
fn quadratic(graph: &mut Graph, constant: i64, factor: i64, arguments: &[ExprId]) -> ExprId {
    let terms: Vec<ExprId> = arguments
        .iter()
        .map(|&x| {
            let square = graph.power_integer(x, 2);
            graph.scale(Number::integer(factor), square)
        })
        .collect();
    let constant = graph.integer(constant);
    graph.sum(std::iter::once(constant).chain(terms))
}

/// `x^(-1/2)`
fn inverse_root(graph: &mut Graph, x: ExprId) -> ExprId {
    let root = graph.sqrt(x);
    graph.inverse(root)
}

fn product_of_calls(graph: &mut Graph, left: Function, right: Function, arguments: &[ExprId]) -> ExprId {
    let factors = [graph.call(left, arguments), graph.call(right, arguments)];
    graph.product(factors)
}

/// With `atan2(y, x)`: d/dy = x / (x^2 + y^2), d/dx = -y / (x^2 + y^2).
fn atan2_partial(graph: &mut Graph, arguments: &[ExprId], index: usize) -> Option<ExprId> {
    let &[y, x] = arguments else { return None };
    let squares = [graph.power_integer(x, 2), graph.power_integer(y, 2)];
    let denominator = graph.sum(squares);
    let inverse = graph.inverse(denominator);
    let numerator = if index == 0 { x } else { graph.neg(y) };
    Some(graph.product([numerator, inverse]))
}

/// `1 / (sqrt(x - 1) sqrt(x + 1))`, which keeps the domain of acosh.
fn acosh_partial(graph: &mut Graph, arguments: &[ExprId], _index: usize) -> Option<ExprId> {
    let x = first(arguments)?;
    let (one, minus_one) = (graph.integer(1), graph.integer(-1));
    let (above, below) = (graph.sum([x, one]), graph.sum([x, minus_one]));
    let factors = [inverse_root(graph, above), inverse_root(graph, below)];
    Some(graph.product(factors))
}

/// `1 / (x ln 10)`
fn log10_partial(graph: &mut Graph, arguments: &[ExprId], _index: usize) -> Option<ExprId> {
    let x = first(arguments)?;
    let ten = graph.integer(10);
    let factors = [x, graph.call(Function::Ln, &[ten])];
    let denominator = graph.product(factors);
    Some(graph.inverse(denominator))
}

/// `1 / (3 cbrt(x)^2)`
fn cbrt_partial(graph: &mut Graph, arguments: &[ExprId], _index: usize) -> Option<ExprId> {
    let root = graph.call(Function::Cbrt, arguments);
    let square = graph.power_integer(root, 2);
    let denominator = graph.scale(Number::integer(3), square);
    Some(graph.inverse(denominator))
}
