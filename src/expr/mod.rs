//! Expressions as a graph of shared, canonical nodes: construction, derivatives, substitution, values, text.
//!
//! Input: calls of the constructors on [`Graph`]; output: [`ExprId`]s that are equal exactly when the
//! expressions are equal under the rules of [`simplify`]. Everything is a loop over ascending ids; nothing
//! recurses on the shape of an expression.

mod derivative;
mod display;
mod function;
mod graph;
mod name;
mod number;
pub mod simplify;
mod spline;
mod substitute;

pub use derivative::{Derivative, DerivativeFault, NotDifferentiable};
pub use display::{Notation, TextTooLong};
pub use function::{Function, Parity, Value};
pub use graph::{Constant, Dependence, ExprId, Graph, Node, SymbolId, Variable};
pub use name::{canonical_name, greek_letter, greek_named, unicode_name};
pub use number::Number;
pub use spline::{HIGHEST_DEGREE, Knots, Spline, SplineCall};
