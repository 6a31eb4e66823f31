//! Plain numerics: cardinal polynomials, collocation nodes, least squares, trigonometric series. Knows nothing of the project.

mod cardinal;
mod fourier;
mod least_squares;
mod nodes;

pub use cardinal::CardinalPolynomials;
pub use fourier::trigonometric_coefficients;
pub use least_squares::{LeastSquares, LeastSquaresError};
pub use nodes::{NodeKind, nodes};
