//! Plain numerics: cardinal polynomials, Chebyshev series, collocation nodes, least squares, trigonometric series. Knows
//! nothing of the project.

mod cardinal;
mod chebyshev;
mod fourier;
mod least_squares;
mod nodes;

pub use cardinal::CardinalPolynomials;
pub use fourier::trigonometric_coefficients;
pub use chebyshev::ChebyshevSeries;
pub use least_squares::{LeastSquares, LeastSquaresError};
pub use nodes::{NodeKind, nodes};
