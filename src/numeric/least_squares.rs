//! Linear least squares by QR with column pivoting: solutions with their rank and condition.
//!
//! Never normal equations, which square the condition. Columns are scaled to length one first, so that the
//! rank does not depend on units; the reported condition is that of the matrix as given. This is the only
//! place that factorises rectangular matrices, and it refuses what nalgebra would loop or panic on: empty and
//! non-finite matrices.

use nalgebra::{DMatrix, DVector, SVD};

/// A factorised matrix A, ready for any number of right-hand sides.
#[derive(Debug, Clone)]
pub struct LeastSquares {
    qr: nalgebra::ColPivQR<f64, nalgebra::Dyn, nalgebra::Dyn>,
    /// The triangular factor of the scaled matrix, columns in pivot order.
    triangle: DMatrix<f64>,
    /// Lengths of the columns, in the order of the unknowns.
    lengths: DVector<f64>,
    /// Singular value decomposition of the triangle, kept when columns depend on each other.
    deficient: Option<SVD<f64, nalgebra::Dyn, nalgebra::Dyn>>,
    cutoff: f64,
    rank: usize,
    condition: f64,
}

/// Why a matrix was not factorised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum LeastSquaresError {
    /// There are fewer rows than unknowns.
    #[error("{rows} equations do not determine {columns} unknowns")]
    TooFewRows {
        /// Equations.
        rows: usize,
        /// Unknowns.
        columns: usize,
    },
    /// An entry is infinite or NaN.
    #[error("the entry in row {row}, column {column} is not finite")]
    NotFinite {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
    },
    /// The singular values were not found.
    #[error("the singular values did not converge in {0} iterations")]
    NoConvergence(usize),
}

const ITERATIONS: usize = 500;

impl LeastSquares {
    /// Factorises `matrix`.
    ///
    /// # Errors
    /// [`LeastSquaresError`] for fewer rows than columns (an empty matrix included) and entries that are not finite.
    pub fn new(matrix: &DMatrix<f64>) -> Result<Self, LeastSquaresError> {
        let (rows, columns) = matrix.shape();
        if rows < columns || columns == 0 {
            return Err(LeastSquaresError::TooFewRows { rows, columns });
        }
        if let Some(index) = matrix.iter().position(|entry| !entry.is_finite()) {
            return Err(LeastSquaresError::NotFinite { row: index % rows, column: index / rows });
        }
        let lengths = DVector::from_iterator(columns, matrix.column_iter().map(|c| c.norm()));
        let lengths = lengths.map(|length| if length > 0.0 { length } else { 1.0 });
        let mut scaled = matrix.clone();
        for (mut column, length) in scaled.column_iter_mut().zip(lengths.iter()) {
            column /= *length;
        }
        let qr = scaled.col_piv_qr();
        let triangle = qr.r();
        let singular = |matrix: DMatrix<f64>, vectors: bool| {
            SVD::try_new(matrix, vectors, vectors, f64::EPSILON, ITERATIONS)
                .ok_or(LeastSquaresError::NoConvergence(ITERATIONS))
        };
        let values = singular(triangle.clone(), false)?.singular_values;
        // The size of rounding errors in the factorisation, relative to the largest singular value.
        let cutoff = 8.0 * rows as f64 * f64::EPSILON * values.max();
        let rank = values.iter().filter(|value| **value > cutoff).count();
        let deficient = if rank < columns { Some(singular(triangle.clone(), true)?) } else { None };
        let unscaled = {
            let mut permuted = DMatrix::from_row_iterator(1, columns, lengths.iter().copied());
            qr.p().permute_columns(&mut permuted);
            let mut unscaled = triangle.clone();
            for (mut column, length) in unscaled.column_iter_mut().zip(permuted.iter()) {
                column *= *length;
            }
            singular(unscaled, false)?.singular_values
        };
        let condition = if rank < columns { f64::INFINITY } else { unscaled.max() / unscaled.min() };
        Ok(LeastSquares { qr, triangle, lengths, deficient, cutoff, rank, condition })
    }

    /// The number of columns that are independent within rounding.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// The number of unknowns.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.lengths.len()
    }

    /// The ratio of largest to smallest singular value of A; infinite when columns depend on each other.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// The x that minimises `|A x - b|` for every column b of `right`; the shortest one when there are many.
    #[must_use]
    pub fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let mut rotated = right.clone();
        self.qr.q_tr_mul(&mut rotated);
        let rotated = rotated.rows(0, self.unknowns()).into_owned();
        let solution = match &self.deficient {
            Some(svd) => svd.solve(&rotated, self.cutoff).unwrap_or_else(|_| rotated.map(|_| f64::NAN)),
            None => self.triangle.solve_upper_triangular(&rotated).unwrap_or_else(|| rotated.map(|_| f64::NAN)),
        };
        self.unscaled(solution)
    }

    /// `(AᵀA)⁻¹ right`, from the triangular factor; the pseudo-inverse when columns depend on each other.
    #[must_use]
    pub fn solve_gram(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let mut scaled = right.clone();
        for (mut row, length) in scaled.row_iter_mut().zip(self.lengths.iter()) {
            row /= *length;
        }
        self.qr.p().permute_rows(&mut scaled);
        let solution = match &self.deficient {
            Some(svd) => {
                let transposed = SVD {
                    u: svd.v_t.as_ref().map(|v| v.transpose()),
                    v_t: svd.u.as_ref().map(|u| u.transpose()),
                    singular_values: svd.singular_values.clone(),
                };
                let lower = transposed.solve(&scaled, self.cutoff);
                lower.and_then(|lower| svd.solve(&lower, self.cutoff)).unwrap_or_else(|_| scaled.map(|_| f64::NAN))
            }
            None => self
                .triangle
                .tr_solve_upper_triangular(&scaled)
                .and_then(|lower| self.triangle.solve_upper_triangular(&lower))
                .unwrap_or_else(|| scaled.map(|_| f64::NAN)),
        };
        self.unscaled(solution)
    }

    /// Undoes pivoting and scaling.
    fn unscaled(&self, mut solution: DMatrix<f64>) -> DMatrix<f64> {
        self.qr.p().inv_permute_rows(&mut solution);
        for (mut row, length) in solution.row_iter_mut().zip(self.lengths.iter()) {
            row /= *length;
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> DMatrix<f64> {
        DMatrix::from_row_slice(4, 2, &[1.0, 1e8, 2.0, -1e8, 0.5, 3e8, -1.0, 2e8])
    }

    #[test]
    fn badly_scaled_columns_keep_full_rank_and_solve_exactly() {
        let matrix = example();
        let expected = DMatrix::from_row_slice(2, 1, &[3.0, -2e-8]);
        let solver = LeastSquares::new(&matrix).expect("finite");
        assert_eq!(solver.rank(), 2);
        let error = solver.solve(&(&matrix * &expected)) - &expected;
        // Scaled condition is about 1; a few rounding errors of numbers near 3 and 2e-8.
        assert!(error[0].abs() < 1e-14 && error[1].abs() < 1e-22, "{error}");
    }

    #[test]
    fn gram_solution_inverts_the_gram_matrix() {
        let matrix = example();
        let right = DMatrix::from_row_slice(2, 1, &[1.0, 2.0]);
        let solution = LeastSquares::new(&matrix).expect("finite").solve_gram(&right);
        let error = matrix.transpose() * &matrix * solution - &right;
        // The unscaled condition 1e8 enters once, as products of size 1e17 cancel to 2.
        assert!(error.amax() < 1e-7, "{error}");
    }

    #[test]
    fn dependent_columns_are_counted_and_give_the_shortest_solution() {
        let matrix = DMatrix::from_row_slice(3, 2, &[1.0, 2.0, 2.0, 4.0, 3.0, 6.0]);
        let solver = LeastSquares::new(&matrix).expect("finite");
        assert_eq!(solver.rank(), 1);
        assert!(solver.condition().is_infinite());
        let solution = solver.solve(&DMatrix::from_row_slice(3, 1, &[1.0, 2.0, 3.0]));
        let residual = &matrix * &solution - DMatrix::from_row_slice(3, 1, &[1.0, 2.0, 3.0]);
        assert!(residual.amax() < 1e-14, "{solution}");
        assert!(solution.iter().all(|value| value.abs() <= 1.0), "{solution}");
    }

    #[test]
    fn empty_wide_and_non_finite_matrices_are_refused() {
        assert!(LeastSquares::new(&DMatrix::zeros(0, 0)).is_err());
        assert!(LeastSquares::new(&DMatrix::zeros(1, 2)).is_err());
        let with_nan = DMatrix::from_row_slice(2, 1, &[1.0, f64::NAN]);
        assert_eq!(LeastSquares::new(&with_nan).err(), Some(LeastSquaresError::NotFinite { row: 1, column: 0 }));
    }
}
