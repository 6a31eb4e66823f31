//! The functions of u along one wave number: cardinal functions of `(∂²/∂u² - w²)^m G = 0`.
//!
//! With `S = Σ_n G_n(u) cos nv` the equation `(∂²/∂u² + a² ∂²/∂v²)^m S = 0` asks this of G_n, for w = a n
//! (docs/methods.md, F2). With x from 0 to 1 over the range and W = w times its length, the solutions are spanned by
//!
//! ```text
//! s^k e^(-s) / k!,   s = W x   and   s = W (1 - x),   k < m
//! ```
//!
//! which never exceed 1, whatever W; rows of derivatives are divided by W. For small W these become dependent, and
//! the solutions with one Taylor coefficient at the middle are taken instead; W = 0 makes of them the powers of x.

use nalgebra::{DMatrix, DVector};

use super::Modes;

/// Functions ξ_i of the null space of `(D² - w²)^m` with `ℓ_i[ξ_k] = δ_ik`, for 2m functionals ℓ_i.
#[derive(Debug, Clone)]
pub struct CardinalExponentials {
    low: f64,
    length: f64,
    /// W.
    rate: f64,
    /// m.
    multiplicity: usize,
    /// For small W the Taylor coefficients of each solution at the middle; else nothing.
    taylor: Vec<Vec<f64>>,
    /// Column i holds the coefficients of ξ_i.
    weights: DMatrix<f64>,
}

/// Taylor coefficients of the solutions for small W: those of order 64 are below 1e-30 of the first.
const TAYLOR_TERMS: usize = 80;

impl CardinalExponentials {
    /// The cardinal functions of `functionals`, an even number of pairs of a position in `range` and an order below
    /// that number, for `w >= 0`.
    ///
    /// `None` if the functionals are dependent or an odd number, or if a function exceeds the doubles: a position
    /// inside the range lets ξ_i grow as `e^(w d)` with d its distance from the nearer end.
    #[must_use]
    pub fn new(w: f64, range: [f64; 2], functionals: &[(f64, usize)]) -> Option<Self> {
        let count = functionals.len();
        let [low, high] = range;
        let length = high - low;
        let rate = w * length;
        if count == 0 || !count.is_multiple_of(2) || !rate.is_finite() || rate < 0.0 || length <= 0.0 {
            return None;
        }
        let multiplicity = count / 2;
        let taylor = if rate <= count as f64 { taylor(multiplicity, rate) } else { Vec::new() };
        let mut functions =
            CardinalExponentials { low, length, rate, multiplicity, taylor, weights: DMatrix::identity(count, count) };
        let mut matrix = DMatrix::zeros(count, count);
        let mut scales = Vec::with_capacity(count);
        for (row, &(u, order)) in functionals.iter().enumerate() {
            let values = functions.raw(order, u);
            // Far from both ends all values are small; what counts is their ratios.
            let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            if largest == 0.0 || !largest.is_finite() {
                return None;
            }
            for (slot, value) in matrix.row_mut(row).iter_mut().zip(&values) {
                *slot = value / largest;
            }
            scales.push(largest * functions.chain(order));
        }
        let lu = matrix.clone().full_piv_lu();
        let identity = DMatrix::identity(count, count);
        let mut weights = lu.solve(&identity)?;
        weights += lu.solve(&(identity - &matrix * &weights))?;
        for (mut column, scale) in weights.column_iter_mut().zip(scales) {
            column /= scale;
        }
        functions.weights = weights;
        functions.weights.iter().all(|weight| weight.is_finite()).then_some(functions)
    }

    /// What a derivative of the raw functions of order `order` is multiplied by to be one in u.
    fn chain(&self, order: usize) -> f64 {
        let slope = if self.taylor.is_empty() { self.rate / self.length } else { 1.0 / self.length };
        slope.powi(i32::try_from(order).unwrap_or(i32::MAX))
    }

    /// The derivatives of the 2m functions that span the null space, in s or in x.
    fn raw(&self, order: usize, u: f64) -> Vec<f64> {
        let x = (u - self.low) / self.length;
        if !self.taylor.is_empty() {
            let y = x - 0.5;
            let horner = |coefficients: &Vec<f64>| {
                let shifted = coefficients.iter().enumerate().skip(order).rev();
                shifted.fold(0.0, |sum, (k, value)| value + sum * y / (k + 1 - order) as f64)
            };
            return self.taylor.iter().map(horner).collect();
        }
        let mut values = decaying(self.multiplicity, order, self.rate * x);
        let sign = if order.is_multiple_of(2) { 1.0 } else { -1.0 };
        // 1 - x from the other end itself: x is rounded, and its error would count W times.
        let from_high = (self.low + self.length - u) / self.length;
        values.extend(decaying(self.multiplicity, order, self.rate * from_high).into_iter().map(|value| sign * value));
        values
    }
}

/// The derivatives of order `order` of `s^k e^(-s) / k!` for k < count: each is `f_(k-1) - f_k` of the ones before.
fn decaying(count: usize, order: usize, s: f64) -> Vec<f64> {
    let mut values = Vec::with_capacity(count);
    let mut value = libm::exp(-s);
    for k in 0..count {
        values.push(value);
        value *= s / (k + 1) as f64;
    }
    for _ in 0..order {
        let mut before = 0.0;
        for value in &mut values {
            (before, *value) = (*value, before - *value);
        }
    }
    values
}

/// For j < 2m the derivatives at the middle, in x, of the solution whose first 2m are zero but for the j-th.
fn taylor(multiplicity: usize, rate: f64) -> Vec<Vec<f64>> {
    let order = 2 * multiplicity;
    // (D² - W²)^m = Σ_l C(m, l) (-W²)^l D^(2m - 2l)
    let mut factors = Vec::with_capacity(multiplicity);
    let mut factor = 1.0;
    for l in 1..=multiplicity {
        factor *= -rate * rate * (multiplicity + 1 - l) as f64 / l as f64;
        factors.push(factor);
    }
    let solution = |j: usize| {
        let mut derivatives: Vec<f64> = (0..order).map(|k| f64::from(u8::from(k == j))).collect();
        for k in order..TAYLOR_TERMS {
            let earlier = |l: usize| derivatives.get(k - 2 * l).copied().unwrap_or(0.0);
            let next: f64 = factors.iter().zip(1..).map(|(factor, l)| -factor * earlier(l)).sum();
            derivatives.push(next);
        }
        derivatives
    };
    (0..order).map(solution).collect()
}

impl Modes for CardinalExponentials {
    fn count(&self) -> usize {
        self.weights.ncols()
    }

    fn derivatives(&self, order: usize, u: f64) -> Vec<f64> {
        let raw = DVector::from_vec(self.raw(order, u));
        let chain = self.chain(order);
        self.weights.column_iter().map(|weights| chain * weights.dot(&raw)).collect()
    }
}

/// Several sets of functions, one after the other.
#[derive(Debug, Clone)]
pub struct JoinedModes {
    parts: Vec<std::sync::Arc<dyn Modes>>,
}

impl JoinedModes {
    /// The functions of all `parts`, in order.
    #[must_use]
    pub fn new(parts: Vec<std::sync::Arc<dyn Modes>>) -> Self {
        JoinedModes { parts }
    }
}

impl Modes for JoinedModes {
    fn count(&self) -> usize {
        self.parts.iter().map(|part| part.count()).sum()
    }

    fn derivatives(&self, order: usize, u: f64) -> Vec<f64> {
        self.parts.iter().flat_map(|part| part.derivatives(order, u)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERMITE: [(f64, usize); 4] = [(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)];

    #[test]
    fn without_a_wave_number_they_are_the_cubic_hermite_basis() {
        let cardinal = CardinalExponentials::new(0.0, [0.0, 1.0], &HERMITE).expect("independent");
        let u: f64 = 0.3;
        let expected = [
            1.0 - 3.0 * u.powi(2) + 2.0 * u.powi(3),
            u - 2.0 * u.powi(2) + u.powi(3),
            3.0 * u.powi(2) - 2.0 * u.powi(3),
            -u.powi(2) + u.powi(3),
        ];
        for (value, expected) in cardinal.derivatives(0, u).iter().zip(expected) {
            // A 4 x 4 system with a condition of about 100.
            assert!((value - expected).abs() < 1e-14, "{value} {expected}");
        }
    }

    #[test]
    fn both_bases_agree_where_one_takes_over_from_the_other() {
        for functionals in [HERMITE, [(0.0, 0), (1.0 / 3.0, 0), (2.0 / 3.0, 0), (1.0, 0)]] {
            let [below, above] = [4.0, 4.0_f64.next_up()]
                .map(|w| CardinalExponentials::new(w, [0.0, 1.0], &functionals).expect("independent"));
            assert!(!below.taylor.is_empty() && above.taylor.is_empty());
            for u in [0.1, 0.4, 0.77] {
                for order in 0..5 {
                    for (a, b) in below.derivatives(order, u).iter().zip(above.derivatives(order, u)) {
                        // Conditions of a few hundred; derivatives grow as 4^order.
                        assert!((a - b).abs() < 1e-12 * 4_f64.powi(order as i32), "{order} {u}: {a} {b}");
                    }
                }
            }
        }
    }

    #[test]
    fn functions_satisfy_their_equation_and_conditions_on_any_interval() {
        let functionals = [(-1.0, 0), (-1.0, 1), (-1.0, 2), (2.5, 0), (2.5, 1), (2.5, 2)];
        for w in [0.0, 0.4, 1.3, 2.0, 9.0, 300.0] {
            let cardinal = CardinalExponentials::new(w, [-1.0, 2.5], &functionals).expect("independent");
            for (row, (u, order)) in functionals.iter().enumerate() {
                for (column, value) in cardinal.derivatives(*order, *u).into_iter().enumerate() {
                    // A cardinal function of a derivative of order k has derivatives of order r of size w^(r - k).
                    let size = f64::max(w, 1.0).powi(*order as i32 - functionals[column].1 as i32).max(1.0);
                    assert!((value - f64::from(u8::from(row == column))).abs() < 1e-11 * size, "{w} {row} {column}");
                }
            }
            for u in [-0.7, 0.8, 2.2] {
                let [sixth, fourth, second, value] = [6, 4, 2, 0].map(|order| cardinal.derivatives(order, u));
                for i in 0..6 {
                    let parts =
                        [sixth[i], -3.0 * w.powi(2) * fourth[i], 3.0 * w.powi(4) * second[i], -w.powi(6) * value[i]];
                    let largest = parts.iter().fold(1e-3, |most: f64, part| most.max(part.abs()));
                    assert!(parts.iter().sum::<f64>().abs() < 1e-10 * largest, "{w} {u} {i}: {parts:?}");
                }
            }
        }
    }

    #[test]
    fn dependent_or_odd_functionals_have_no_cardinal_functions() {
        assert!(CardinalExponentials::new(3.0, [0.0, 1.0], &[(0.0, 0), (0.0, 0)]).is_none());
        assert!(CardinalExponentials::new(0.0, [0.0, 1.0], &[(0.0, 1), (1.0, 1)]).is_none());
        assert!(CardinalExponentials::new(3.0, [0.0, 1.0], &[(0.0, 0)]).is_none());
    }
}
