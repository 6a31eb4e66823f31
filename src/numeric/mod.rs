//! Plain numerics: cardinal polynomials, nodes, least squares and square systems. Knows nothing of the project.

mod cardinal;
mod least_squares;
mod linear_system;
mod nodes;

pub use cardinal::CardinalPolynomials;
pub use least_squares::{LeastSquares, LeastSquaresError};
pub use linear_system::LinearSystem;
pub use nodes::{NodeKind, gauss_rule, nodes};
