//! Square systems of linear equations by LU with row pivoting, with an estimate of their condition.
//!
//! For systems that are too large for the singular values that [`LeastSquares`](super::LeastSquares) takes.

use nalgebra::{DMatrix, Dyn, LU};

/// A factorised square matrix, ready for any number of right-hand sides.
#[derive(Debug, Clone)]
pub struct LinearSystem {
    lu: LU<f64, Dyn, Dyn>,
    condition: f64,
}

/// Steps of the condition estimate; it rarely changes after the second.
const STEPS: usize = 5;

impl LinearSystem {
    /// Factorises `matrix`; `None` unless it is square, not empty, finite and regular.
    #[must_use]
    pub fn new(matrix: DMatrix<f64>) -> Option<LinearSystem> {
        if !matrix.is_square() || matrix.is_empty() || matrix.iter().any(|entry| !entry.is_finite()) {
            return None;
        }
        let norm = column_norm(&matrix);
        let transposed = matrix.transpose().lu();
        let lu = matrix.lu();
        let condition = norm * inverse_norm(&lu, &transposed)?;
        Some(LinearSystem { lu, condition })
    }

    /// The condition in the norm of column sums: a lower bound that is rarely off by more than a factor of three.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// The x with `A x = b` for every column b of `right`; NaN if the lengths do not fit.
    #[must_use]
    pub fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let fits = right.nrows() == self.lu.lu_internal().nrows();
        let solution = if fits { self.lu.solve(right) } else { None };
        solution.unwrap_or_else(|| right.map(|_| f64::NAN))
    }
}

/// The largest column sum of absolute values.
fn column_norm(matrix: &DMatrix<f64>) -> f64 {
    matrix.column_iter().fold(0.0, |most, column| most.max(column.iter().map(|entry| entry.abs()).sum()))
}

/// Estimates the norm of the inverse (Hager 1984): climbs along the gradient of the convex function |A⁻¹x|.
fn inverse_norm(lu: &LU<f64, Dyn, Dyn>, transposed: &LU<f64, Dyn, Dyn>) -> Option<f64> {
    let count = lu.lu_internal().nrows();
    let mut x = DMatrix::from_element(count, 1, 1.0 / count as f64);
    let mut estimate = 0.0_f64;
    for _ in 0..STEPS {
        let y = lu.solve(&x)?;
        let norm = column_norm(&y);
        // NaN is no solution; otherwise the climb ends where it no longer rises.
        if norm.is_nan() {
            return None;
        }
        if norm <= estimate {
            break;
        }
        estimate = norm;
        let gradient = transposed.solve(&y.map(|value| if value < 0.0 { -1.0 } else { 1.0 }))?;
        let steepest = gradient.iter().enumerate().max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))?.0;
        x = DMatrix::zeros(count, 1);
        *x.get_mut((steepest, 0))? = 1.0;
    }
    estimate.is_finite().then_some(estimate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solution_of_a_system_that_needs_pivots_is_found() {
        let matrix = DMatrix::from_row_slice(3, 3, &[0.0, 2.0, 1.0, 1.0, 0.0, -1.0, 3.0, 1.0, 0.0]);
        let expected = DMatrix::from_row_slice(3, 2, &[1.0, -2.0, 0.5, 4.0, 2.0, 0.0]);
        let system = LinearSystem::new(matrix.clone()).expect("regular");
        // A condition below 10 and entries below 8.
        assert!((system.solve(&(&matrix * &expected)) - expected).amax() < 1e-14);
    }

    #[test]
    fn condition_of_the_hilbert_matrix_is_that_of_the_tables() {
        let hilbert = DMatrix::from_fn(6, 6, |i, j| 1.0 / (i + j + 1) as f64);
        let system = LinearSystem::new(hilbert).expect("regular");
        // 2.907e7 in this norm; the estimate is a lower bound, here an equality but for rounding 1e7 times larger.
        assert!((system.condition() / 2.907_027_9e7 - 1.0).abs() < 1e-6, "{:e}", system.condition());
    }

    #[test]
    fn singular_empty_wide_and_non_finite_matrices_are_refused() {
        assert!(LinearSystem::new(DMatrix::from_element(2, 2, 1.0)).is_none());
        assert!(LinearSystem::new(DMatrix::zeros(0, 0)).is_none());
        assert!(LinearSystem::new(DMatrix::zeros(1, 2)).is_none());
        assert!(LinearSystem::new(DMatrix::from_element(1, 1, f64::NAN)).is_none());
    }
}
