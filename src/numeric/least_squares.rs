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
    /// An orthonormal basis of what A sends to zero, when there is any.
    null_space: Option<DMatrix<f64>>,
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
        // By a power of two, so that nothing is rounded: squares of entries near 1e300 would overflow.
        let exponent = libm::frexp(matrix.amax()).1;
        let matrix = &matrix.map(|entry| libm::ldexp(entry, -exponent));
        let unit = libm::ldexp(1.0, exponent);
        let lengths = DVector::from_iterator(columns, matrix.column_iter().map(|c| c.norm()));
        // A column this far below the longest is rounding errors: a function that is zero at every node. Scaled to
        // length one it would pass for a full column and get a huge coefficient.
        let noise = 64.0 * f64::EPSILON * lengths.max();
        let mut scaled = matrix.clone();
        for (mut column, length) in scaled.column_iter_mut().zip(lengths.iter()) {
            if *length > noise {
                column /= *length;
            } else {
                column.fill(0.0);
            }
        }
        let lengths = lengths.map(|length| if length > noise { length } else { 1.0 });
        // Of the matrix as given; one that leaves the doubles leaves nothing to solve with.
        if let Some(column) = lengths.iter().position(|length| !(length * unit).is_finite()) {
            return Err(LeastSquaresError::NotFinite { row: 0, column });
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
        let lengths = lengths * unit;
        let mut solver = LeastSquares { qr, triangle, lengths, deficient, null_space: None, cutoff, rank, condition };
        solver.null_space = solver.find_null_space();
        Ok(solver)
    }

    fn find_null_space(&self) -> Option<DMatrix<f64>> {
        let svd = self.deficient.as_ref()?;
        let directions = svd.v_t.as_ref()?.row_iter().zip(svd.singular_values.iter());
        let null: Vec<_> =
            directions.filter(|(_, value)| **value <= self.cutoff).map(|(row, _)| row.transpose()).collect();
        // Orthonormal for the scaled columns, not for A; scaling back keeps the space and not the angles.
        (!null.is_empty()).then(|| self.unscaled(DMatrix::from_columns(&null)).qr().q())
    }

    /// An orthonormal basis, in columns, of the x with `A x = 0`; `None` if columns are independent.
    #[must_use]
    pub fn null_space(&self) -> Option<&DMatrix<f64>> {
        self.null_space.as_ref()
    }

    /// `vectors` without their part in the null space.
    fn without_null_part(&self, vectors: DMatrix<f64>) -> DMatrix<f64> {
        match &self.null_space {
            Some(null) => &vectors - null * (null.transpose() * &vectors),
            None => vectors,
        }
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
        self.without_null_part(self.unscaled(solution))
    }

    /// `(AᵀA)⁻¹ right`, from the triangular factor; the pseudo-inverse when columns depend on each other.
    #[must_use]
    pub fn solve_gram(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let mut scaled = self.without_null_part(right.clone());
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
        self.without_null_part(self.unscaled(solution))
    }

    /// The x that minimises `|A x + b|`, and its derivatives in a parameter on which A and b depend.
    ///
    /// `systems` holds A, which is the matrix of this solver, and its derivatives; `rights` the same for b. Result n
    /// is the derivative of order n, a column for each column of b. They follow from `Aᵀ r = 0`, `r = A x + b`,
    /// differentiated n times (docs/methods.md, S3). When columns depend on each other, x is the shortest solution,
    /// `x = Aᵀ y`, which decides its part in the null space (S4); that holds while the rank stays as it is.
    #[must_use]
    pub fn derivatives(&self, systems: &[DMatrix<f64>], rights: &[DMatrix<f64>]) -> Vec<DMatrix<f64>> {
        let (mut solutions, mut residuals, mut duals) = (Vec::new(), Vec::new(), Vec::new());
        for (n, right) in rights.iter().enumerate() {
            let mut known = right.clone();
            let mut gradient = DMatrix::zeros(self.unknowns(), right.ncols());
            let mut transverse = DMatrix::zeros(self.unknowns(), right.ncols());
            let mut binomial = 1.0;
            let earlier = solutions.iter().zip(&residuals).zip(&duals).zip(systems.iter().take(n + 1).rev());
            for (i, (((solution, residual), dual), system)) in earlier.enumerate() {
                known += system * solution * binomial;
                gradient += system.transpose() * residual * binomial;
                transverse += system.transpose() * dual * binomial;
                binomial = binomial * (n - i) as f64 / (i + 1) as f64;
            }
            let mut solution = -self.solve(&known);
            if n > 0 {
                solution -= self.solve_gram(&gradient);
            }
            let apply = |vectors: &DMatrix<f64>| systems.first().map_or_else(|| right * 0.0, |first| first * vectors);
            let mut dual = DMatrix::zeros(right.nrows(), right.ncols());
            if let Some(null) = &self.null_space {
                solution += null * (null.transpose() * &transverse);
                dual = apply(&self.solve_gram(&(&solution - &transverse)));
            }
            residuals.push(apply(&solution) + known);
            solutions.push(solution);
            duals.push(dual);
        }
        solutions
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
    fn entries_near_the_largest_double_are_solved_or_refused() {
        let big = DMatrix::from_row_slice(2, 1, &[1e300, 1e300]);
        let solution = LeastSquares::new(&big).expect("finite").solve(&DMatrix::from_row_slice(2, 1, &[2e300, 2e300]));
        assert!((solution[0] - 2.0).abs() < 1e-14, "{solution}");
        assert!(LeastSquares::new(&DMatrix::from_element(40, 2, 1.7e308)).is_err());
    }

    #[test]
    fn a_column_of_rounding_errors_is_no_column() {
        let matrix = DMatrix::from_row_slice(3, 2, &[1.0, 1e-17, 2.0, -3e-17, 2.0, 2e-17]);
        let solver = LeastSquares::new(&matrix).expect("finite");
        assert_eq!(solver.rank(), 1);
        let solution = solver.solve(&DMatrix::from_row_slice(3, 1, &[1.0, 2.0, 2.5]));
        // Without the column there is nothing to divide by 1e-17.
        assert!(solution[1].abs() < 1e-14, "{solution}");
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
    fn shortest_solution_does_not_depend_on_the_lengths_of_columns() {
        // x + 1000 y = 1001: the shortest solution is 1001 (1, 1000) / 1000001.
        let matrix = DMatrix::from_row_slice(2, 2, &[1.0, 1000.0, 2.0, 2000.0]);
        let solver = LeastSquares::new(&matrix).expect("finite");
        let solution = solver.solve(&DMatrix::from_row_slice(2, 1, &[1001.0, 2002.0]));
        let expected = DMatrix::from_row_slice(2, 1, &[1001.0 / 1_000_001.0, 1_001_000.0 / 1_000_001.0]);
        // The solution with columns of one length, about 500, is cancelled down to the shortest one.
        assert!((solution - expected).amax() < 500.0 * 8.0 * f64::EPSILON);
        assert_eq!(solver.null_space().map(DMatrix::shape), Some((2, 1)));
    }

    /// A(s), b(s) and their derivatives: polynomials in s; the last column is s times the one before it.
    fn moving_system(s: f64) -> (Vec<DMatrix<f64>>, Vec<DMatrix<f64>>) {
        let matrix = |f: fn(f64) -> [f64; 2], s: f64, slope: f64, bend: f64| {
            let rows = [1.0, 2.0, -1.0, 0.5].map(|w| {
                let [a, b] = f(w);
                // Columns c1 = a + b s, c2 = b + a s², c3 = s c2, as value, slope or second derivative.
                let c2 = [b + a * s * s, 2.0 * a * s, 2.0 * a];
                let value = [a + b * s, c2[0], s * c2[0]];
                let first = [b, c2[1], c2[0] + s * c2[1]];
                let second = [0.0, c2[2], 2.0 * c2[1] + s * c2[2]];
                [0, 1, 2].map(|k| value[k] * (1.0 - slope - bend) + slope * first[k] + bend * second[k])
            });
            DMatrix::from_row_iterator(4, 3, rows.into_iter().flatten())
        };
        let f = |w: f64| [w, 1.0 + w * w];
        let systems = vec![matrix(f, s, 0.0, 0.0), matrix(f, s, 1.0, 0.0), matrix(f, s, 0.0, 1.0)];
        let right = |c: f64, d: f64| DMatrix::from_row_slice(4, 1, &[c, d, 2.0 * c, -d]);
        (systems, vec![right(1.0 + s, s * s), right(1.0, 2.0 * s), right(0.0, 2.0)])
    }

    #[test]
    fn derivatives_of_the_shortest_solution_agree_with_difference_quotients() {
        let at = |s: f64| {
            let (systems, rights) = moving_system(s);
            let solver = LeastSquares::new(&systems[0]).expect("finite");
            assert_eq!(solver.rank(), 2);
            solver.derivatives(&systems, &rights)
        };
        let (s, h) = (0.7, 1e-5);
        let (before, now, after) = (at(s - h), at(s), at(s + h));
        for n in 0..2 {
            let quotient = (&after[n] - &before[n]) / (2.0 * h);
            // Truncation: h²/6 = 2e-11 times a third or fourth derivative, here below 5e4.
            assert!((quotient - &now[n + 1]).amax() < 1e-6, "{n}");
        }
    }

    #[test]
    fn empty_wide_and_non_finite_matrices_are_refused() {
        assert!(LeastSquares::new(&DMatrix::zeros(0, 0)).is_err());
        assert!(LeastSquares::new(&DMatrix::zeros(1, 2)).is_err());
        let with_nan = DMatrix::from_row_slice(2, 1, &[1.0, f64::NAN]);
        assert_eq!(LeastSquares::new(&with_nan).err(), Some(LeastSquaresError::NotFinite { row: 1, column: 0 }));
    }
}
