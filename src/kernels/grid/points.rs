//! Sums of products at scattered points, and the sums that make the tables of grids.

use crate::kernels::multiversion;

/// For each row of an outer sum, rows of the inner one and their vector coefficients: those that are not zero.
pub type Combination = Vec<Vec<(usize, [f64; 3])>>;

/// Points of which the sums are held in registers.
const LANES: usize = 16;

multiversion! {
    /// Adds `Σ c functions_j` to `sums`, x, y and z; `functions` are rows as long as each of them.
    pub fn combine(row: &[(usize, [f64; 3])], functions: &[f64], sums: &mut [Vec<f64>; 3]) {
        let length = sums.first().map_or(0, Vec::len);
        for (j, coefficient) in row {
            let function = functions.get(j * length..).and_then(|rest| rest.get(..length)).unwrap_or_default();
            for (sum, factor) in sums.iter_mut().zip(coefficient) {
                for (sum, value) in sum.iter_mut().zip(function) {
                    *sum = factor.mul_add(*value, *sum);
                }
            }
        }
    }
}

multiversion! {
    /// Writes `Σ_m outer_m Σ_j c_mj inner_j` to x, y and z, as far as these reach. All rows are as long.
    pub fn contract(combination: &Combination, inner: &[&[f64]], outer: &[&[f64]], target: [&mut [f64]; 3]) {
        let [x, y, z] = target;
        let length = x.len().min(y.len()).min(z.len());
        let mut begin = 0;
        while begin < length {
            let count = LANES.min(length - begin);
            let mut total = [[0.0; LANES]; 3];
            for (row, factor) in combination.iter().zip(outer) {
                let mut sum = [[0.0; LANES]; 3];
                for (j, coefficient) in row {
                    let values = lanes(inner.get(*j).copied().unwrap_or_default(), begin, count);
                    for (sum, factor) in sum.iter_mut().zip(coefficient) {
                        for (sum, value) in sum.iter_mut().zip(&values) {
                            *sum = factor.mul_add(*value, *sum);
                        }
                    }
                }
                let factor = lanes(factor, begin, count);
                for (total, sum) in total.iter_mut().zip(&sum) {
                    for ((total, sum), factor) in total.iter_mut().zip(sum).zip(&factor) {
                        *total = factor.mul_add(*sum, *total);
                    }
                }
            }
            for (target, total) in [&mut *x, &mut *y, &mut *z].into_iter().zip(&total) {
                target.iter_mut().skip(begin).zip(total).for_each(|(slot, value)| *slot = *value);
            }
            begin += LANES;
        }
    }
}

/// Some numbers of a row, and zeros after them.
#[inline(always)]
fn lanes(row: &[f64], begin: usize, count: usize) -> [f64; LANES] {
    let part = row.get(begin..).unwrap_or_default();
    if let Some(whole) = part.first_chunk::<LANES>() {
        return *whole;
    }
    let mut some = [0.0; LANES];
    some.iter_mut().zip(part).take(count).for_each(|(slot, value)| *slot = *value);
    some
}
