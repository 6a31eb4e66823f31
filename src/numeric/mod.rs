//! Plain numerics: cardinal polynomials, collocation nodes, least squares, banded systems. Knows nothing of the project.

mod banded;
mod cardinal;
mod least_squares;
mod nodes;

pub use banded::{Banded, CyclicBanded};
pub use cardinal::CardinalPolynomials;
pub use least_squares::{LeastSquares, LeastSquaresError};
pub use nodes::{NodeKind, nodes};
