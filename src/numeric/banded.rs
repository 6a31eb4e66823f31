//! Banded linear systems, also ones whose band goes around, without pivoting.
//!
//! For collocation matrices of B-splines, which are totally positive: elimination without pivoting is stable there
//! (C. de Boor, A. Pinkus, 1977), and keeps the band.

use nalgebra::DMatrix;

/// A factorised matrix whose row i has entries in columns i - width to i + width only.
#[derive(Debug, Clone)]
pub struct Banded {
    width: usize,
    /// What each row takes of the up to `width` rows before it.
    multipliers: Vec<Vec<f64>>,
    /// The eliminated rows from the diagonal on, `width + 1` entries.
    upper: Vec<Vec<f64>>,
}

impl Banded {
    /// Factorises; row i holds the `2 width + 1` entries of columns i - width to i + width, of which those outside the
    /// matrix are not read.
    ///
    /// `None` for a row of another length, or a pivot that is zero or not finite.
    #[must_use]
    pub fn new(width: usize, rows: &[Vec<f64>]) -> Option<Banded> {
        let mut multipliers = Vec::with_capacity(rows.len());
        let mut upper: Vec<Vec<f64>> = Vec::with_capacity(rows.len());
        for row in rows {
            if row.len() != 2 * width + 1 {
                return None;
            }
            let mut row = row.clone();
            let before = upper.get(upper.len().saturating_sub(width)..)?;
            let outside = width - before.len();
            let mut taken = Vec::with_capacity(width);
            for (index, pivot_row) in before.iter().enumerate() {
                let share = row.get(outside + index)? / pivot_row.first()?;
                for (entry, other) in row.iter_mut().skip(outside + index).zip(pivot_row) {
                    *entry -= share * other;
                }
                taken.push(share);
            }
            let rest = row.split_off(width);
            if !rest.first().is_some_and(|pivot| *pivot != 0.0 && pivot.is_finite()) {
                return None;
            }
            multipliers.push(taken);
            upper.push(rest);
        }
        Some(Banded { width, multipliers, upper })
    }

    /// The x with `A x = right`, of N right-hand sides at once.
    #[must_use]
    pub fn solve<const N: usize>(&self, right: &[[f64; N]]) -> Vec<[f64; N]> {
        let mut solution: Vec<[f64; N]> = Vec::with_capacity(right.len());
        for (value, multipliers) in right.iter().zip(&self.multipliers) {
            let known = solution.len() - multipliers.len().min(solution.len());
            let value = reduced(*value, multipliers, solution.iter().skip(known));
            solution.push(value);
        }
        // From the last one up; collected in that order.
        let mut backwards: Vec<[f64; N]> = Vec::with_capacity(right.len());
        for (value, row) in solution.iter().zip(&self.upper).rev() {
            let later = backwards.iter().rev().take(self.width);
            let (pivot, others) = row.split_first().unwrap_or((&f64::NAN, &[]));
            let value = reduced(*value, others, later).map(|x| x / pivot);
            backwards.push(value);
        }
        backwards.reverse();
        backwards
    }
}

/// `value - Σ factors others`
fn reduced<'a, const N: usize>(
    mut value: [f64; N],
    factors: &[f64],
    others: impl Iterator<Item = &'a [f64; N]>,
) -> [f64; N] {
    for (factor, other) in factors.iter().zip(others) {
        for (x, y) in value.iter_mut().zip(other) {
            *x -= factor * y;
        }
    }
    value
}

/// A factorised matrix whose row i has entries in columns i - width to i + width, counted around.
///
/// The last `width` unknowns are eliminated last, by the Schur complement of the rest, which is banded.
#[derive(Debug, Clone)]
pub struct CyclicBanded {
    inner: Banded,
    /// What the last unknowns do to the inner equations, solved: a row for each inner unknown.
    response: Vec<[f64; MOST_WIDTH]>,
    /// The last equations, of all inner unknowns.
    bottom: DMatrix<f64>,
    complement: nalgebra::LU<f64, nalgebra::Dyn, nalgebra::Dyn>,
}

/// The widest band of a [`CyclicBanded`].
pub const MOST_WIDTH: usize = 2;

impl CyclicBanded {
    /// Factorises; row i holds the `2 width + 1` entries of columns i - width to i + width, counted around.
    ///
    /// `None` for fewer than `2 width + 1` rows, a width above 2, and a singular matrix.
    #[must_use]
    pub fn new(width: usize, rows: &[Vec<f64>]) -> Option<CyclicBanded> {
        let count = rows.len();
        if count < 2 * width + 1 || width > MOST_WIDTH {
            return None;
        }
        let inside = count - width;
        // Column of an entry, counted around.
        let column = |row: usize, offset: usize| (row + offset + count - width) % count;
        let mut inner_rows = Vec::with_capacity(inside);
        let mut border = vec![[0.0; MOST_WIDTH]; inside];
        let mut bottom = DMatrix::<f64>::zeros(width, inside);
        let mut corner = DMatrix::<f64>::zeros(width, width);
        for (index, row) in rows.iter().enumerate() {
            let mut kept = row.clone();
            for (offset, entry) in row.iter().enumerate() {
                let column = column(index, offset);
                // An entry that goes around is no part of the inner band, even where its column is an inner one.
                let is_in_band = (index + offset).checked_sub(width) == Some(column);
                if index >= inside {
                    let place = if column < inside {
                        bottom.get_mut((index - inside, column))
                    } else {
                        corner.get_mut((index - inside, column - inside))
                    };
                    *place? += entry;
                } else if column >= inside {
                    *border.get_mut(index)?.get_mut(column - inside)? += entry;
                    *kept.get_mut(offset)? = 0.0;
                } else if !is_in_band {
                    return None;
                }
            }
            if index < inside {
                inner_rows.push(kept);
            }
        }
        let inner = Banded::new(width, &inner_rows)?;
        let response = inner.solve(&border);
        let response_matrix = DMatrix::from_fn(inside, width, |row, column| {
            response.get(row).and_then(|values| values.get(column)).copied().unwrap_or(f64::NAN)
        });
        let complement = (corner - &bottom * response_matrix).lu();
        (width == 0 || complement.is_invertible()).then_some(CyclicBanded { inner, response, bottom, complement })
    }

    /// The x with `A x = right`; `None` when it is not finite.
    #[must_use]
    pub fn solve(&self, right: &[[f64; 3]]) -> Option<Vec<[f64; 3]>> {
        let (inside, last) = right.split_at_checked(self.response.len())?;
        let mut solution = self.inner.solve(inside);
        let width = last.len();
        let free = DMatrix::from_fn(solution.len(), 3, |row, axis| {
            solution.get(row).and_then(|value| value.get(axis)).copied().unwrap_or(f64::NAN)
        });
        let given = DMatrix::from_fn(width, 3, |row, axis| {
            last.get(row).and_then(|value| value.get(axis)).copied().unwrap_or(f64::NAN)
        });
        let rest = self.complement.solve(&(given - &self.bottom * free))?;
        let rest: Vec<[f64; 3]> =
            (0..width).map(|row| [0, 1, 2].map(|axis| rest.get((row, axis)).copied().unwrap_or(f64::NAN))).collect();
        for (value, response) in solution.iter_mut().zip(&self.response) {
            for (share, other) in response.iter().zip(&rest) {
                for (x, y) in value.iter_mut().zip(other) {
                    *x -= share * y;
                }
            }
        }
        solution.extend(rest);
        Some(solution)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Diagonally dominant rows with a seed; the entries outside a plain band stay as they are, to be ignored.
    fn rows(width: usize, count: usize) -> Vec<Vec<f64>> {
        let entry = |row: usize, offset: usize| libm::sin((17 * row + 5 * offset) as f64);
        let row = |row| (0..=2 * width).map(|offset| if offset == width { 6.0 } else { entry(row, offset) }).collect();
        (0..count).map(row).collect()
    }

    fn dense(width: usize, rows: &[Vec<f64>], is_cyclic: bool) -> DMatrix<f64> {
        let count = rows.len();
        let mut matrix = DMatrix::zeros(count, count);
        for (index, row) in rows.iter().enumerate() {
            for (offset, entry) in row.iter().enumerate() {
                let column = (index + offset + count - width) % count;
                if is_cyclic || (index + offset).checked_sub(width) == Some(column) {
                    matrix[(index, column)] += entry;
                }
            }
        }
        matrix
    }

    fn right(count: usize) -> Vec<[f64; 3]> {
        (0..count).map(|row| [0.0, 1.0, 2.0].map(|axis| libm::cos(3.0 * row as f64 + axis))).collect()
    }

    fn largest_error(matrix: &DMatrix<f64>, solution: &[[f64; 3]], right: &[[f64; 3]]) -> f64 {
        let column = |values: &[[f64; 3]], axis: usize| {
            nalgebra::DVector::from_iterator(values.len(), values.iter().map(|v| v[axis]))
        };
        (0..3).map(|axis| (matrix * column(solution, axis) - column(right, axis)).amax()).fold(0.0, f64::max)
    }

    #[test]
    fn banded_solution_satisfies_the_dense_system() {
        for (width, count) in [(0, 1), (1, 1), (1, 2), (1, 9), (2, 2), (2, 12)] {
            let rows = rows(width, count);
            let solution = Banded::new(width, &rows).expect("dominant").solve(&right(count));
            // Well conditioned, entries of size one.
            assert!(
                largest_error(&dense(width, &rows, false), &solution, &right(count)) < 1e-15 * 16.0,
                "{width} {count}"
            );
        }
    }

    #[test]
    fn cyclic_solution_satisfies_the_dense_system() {
        for (width, count) in [(1, 3), (1, 4), (1, 9), (2, 5), (2, 6), (2, 12)] {
            let rows = rows(width, count);
            let solver = CyclicBanded::new(width, &rows).unwrap_or_else(|| panic!("{width} {count}"));
            let solution = solver.solve(&right(count)).expect("finite");
            assert!(
                largest_error(&dense(width, &rows, true), &solution, &right(count)) < 1e-15 * 16.0,
                "{width} {count}"
            );
        }
    }

    #[test]
    fn singular_and_too_small_systems_are_refused() {
        assert!(Banded::new(1, &vec![vec![0.0; 3]; 4]).is_none());
        assert!(Banded::new(1, &vec![vec![1.0; 2]; 4]).is_none());
        assert!(CyclicBanded::new(1, &vec![vec![-1.0, 2.0, -1.0]; 6]).is_none(), "constants are its null space");
        assert!(CyclicBanded::new(1, &rows(1, 2)).is_none());
    }
}
