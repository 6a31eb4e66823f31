//! Plain numerics: cardinal polynomials, Chebyshev series, collocation nodes, least squares, square and banded systems,
//! trigonometric series. Knows nothing of the project.

mod banded;
mod cardinal;
mod chebyshev;
mod fourier;
mod least_squares;
mod linear_system;
mod nodes;

pub use banded::{Banded, CyclicBanded};
pub use cardinal::CardinalPolynomials;
pub use chebyshev::ChebyshevSeries;
pub use fourier::trigonometric_coefficients;
pub use least_squares::{LeastSquares, LeastSquaresError};
pub use linear_system::LinearSystem;
pub use nodes::{NodeKind, gauss_rule, nodes};
