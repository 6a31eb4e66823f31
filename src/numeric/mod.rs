//! Plain numerics: cardinal polynomials, collocation nodes, least squares. Knows nothing of the project.

mod cardinal;
mod least_squares;
mod nodes;

pub use cardinal::CardinalPolynomials;
pub use least_squares::{LeastSquares, LeastSquaresError};
pub use nodes::{NodeKind, nodes};
