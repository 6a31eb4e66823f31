//! Cardinal polynomials of Hermite and Birkhoff interpolation.
//!
//! For functionals `ℓ_i[f] = f^(k_i)(x_i)`, i = 1..n, the cardinal polynomials ξ_i of degree n - 1 satisfy
//! `ℓ_i[ξ_k] = δ_ik`. With position and tangent at 0 and 1 they are the cubic Hermite basis
//! `1 - 3u² + 2u³, u - 2u² + u³, 3u² - 2u³, -u² + u³`.

use nalgebra::DMatrix;

use crate::kernels::{InstructionSet, multiversion};

/// The polynomials ξ_i, as coefficients of powers of a variable y that runs from -1 to 1 between the outermost
/// positions: powers of one from 0 to 1 need larger coefficients, which lose a digit or two.
#[derive(Debug, Clone)]
pub struct CardinalPolynomials {
    /// Row i holds the coefficients of ξ_i in powers of y.
    coefficients: Vec<Vec<f64>>,
    low: f64,
    high: f64,
}

/// Below this ratio of smallest to largest singular value the functionals count as dependent: with positions
/// scaled to [-1, 1] and at most a handful of them, independent ones stay many orders above it.
const DEPENDENT: f64 = 1e-12;

impl CardinalPolynomials {
    /// The cardinal polynomials of `functionals`, pairs of a position and a derivative order.
    ///
    /// `None` if there are none or they are dependent, so that some polynomial of degree n - 1 is invisible to all.
    #[must_use]
    pub fn new(functionals: &[(f64, usize)]) -> Option<Self> {
        let count = functionals.len();
        let low = functionals.iter().map(|(x, _)| *x).fold(f64::INFINITY, f64::min);
        let high = functionals.iter().map(|(x, _)| *x).fold(f64::NEG_INFINITY, f64::max);
        // A single position is in the middle of an interval of length 2.
        let (low, high) = if high > low { (low, high) } else { (low - 1.0, low + 1.0) };
        if count == 0 || !low.is_finite() || !(high - low).is_finite() {
            return None;
        }
        let mut polynomials = CardinalPolynomials { coefficients: Vec::new(), low, high };
        // Row i: the functional i of each power of y.
        let matrix = DMatrix::from_fn(count, count, |row, power| {
            let (x, order) = functionals.get(row).copied().unwrap_or_default();
            derivative_of_power(power, order, polynomials.scaled(x))
        });
        let singular = matrix.clone().try_svd(false, false, f64::EPSILON, 500)?.singular_values;
        if singular.min() <= DEPENDENT * singular.max() {
            return None;
        }
        let identity = DMatrix::identity(count, count);
        let factorised = matrix.clone().full_piv_lu();
        let mut inverse = factorised.solve(&identity)?;
        inverse += factorised.solve(&(identity - &matrix * &inverse))?;
        let coefficients = functionals.iter().enumerate().map(|(index, (_, order))| {
            let factor = 1.0 / polynomials.chain(*order);
            inverse.column(index).iter().map(|coefficient| factor * rounded(*coefficient)).collect()
        });
        polynomials.coefficients = coefficients.collect();
        Some(polynomials)
    }

    /// y, exactly -1 and 1 at the outermost positions.
    fn scaled(&self, x: f64) -> f64 {
        ((x - self.low) - (self.high - x)) / (self.high - self.low)
    }

    /// What a derivative of order `order` in y is multiplied by to be one in x.
    fn chain(&self, order: usize) -> f64 {
        (2.0 / (self.high - self.low)).powi(i32::try_from(order).unwrap_or(i32::MAX))
    }

    /// The number of polynomials.
    #[must_use]
    pub fn len(&self) -> usize {
        self.coefficients.len()
    }

    /// Whether there are none; never true for the result of [`CardinalPolynomials::new`].
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The derivative of order `order` of every ξ_i at `x`.
    #[must_use]
    pub fn derivatives(&self, order: usize, x: f64) -> Vec<f64> {
        let y = self.scaled(x);
        let factor = self.chain(order);
        let value = |coefficients: &Vec<f64>| {
            let terms = coefficients.iter().enumerate().skip(order).rev();
            factor * terms.fold(0.0, |sum, (power, coefficient)| sum * y + coefficient * falling(power, order))
        };
        self.coefficients.iter().map(value).collect()
    }

    /// The same at many `x`, a row for each ξ_i: the same bits.
    pub fn tabulate(&self, order: usize, x: &[f64], rows: &mut [&mut [f64]]) {
        let y: Vec<f64> = x.iter().map(|x| self.scaled(*x)).collect();
        let factor = self.chain(order);
        for (row, coefficients) in rows.iter_mut().zip(&self.coefficients) {
            let terms = coefficients.iter().enumerate().skip(order);
            let series: Vec<f64> =
                terms.map(|(power, coefficient)| coefficient * falling(power, order)).rev().collect();
            horner(InstructionSet::best(), row, &y, (factor, &series));
        }
    }
}

/// Numbers that are treated together, in registers.
const LANES: usize = 32;

multiversion! {
    /// `factor` times the polynomial with the coefficients `series`, those of the highest powers first.
    fn horner(target: &mut [f64], y: &[f64], polynomial: (f64, &[f64])) {
        let (factor, series) = polynomial;
        let (whole, rest) = target.as_chunks_mut::<LANES>();
        let (ys, last) = y.as_chunks::<LANES>();
        for (target, y) in whole.iter_mut().zip(ys) {
            let mut sums = [0.0; LANES];
            for coefficient in series {
                sums.iter_mut().zip(y).for_each(|(sum, y)| *sum = *sum * y + coefficient);
            }
            target.iter_mut().zip(&sums).for_each(|(slot, sum)| *slot = factor * sum);
        }
        for (slot, y) in rest.iter_mut().zip(last) {
            *slot = factor * series.iter().fold(0.0, |sum, coefficient| sum * y + coefficient);
        }
    }
}

/// Positions and derivatives at both ends, the usual case, have coefficients that are multiples of a power of 1/2 up
/// to rounding: of 1/4 for two conditions at each end, of 1/16 for three, of 1/32 for four.
fn rounded(coefficient: f64) -> f64 {
    let nearest = (coefficient * 64.0).round() / 64.0;
    // 64 rounding errors: far more than a 6 x 6 inverse makes, far less than any other fraction differs.
    if (coefficient - nearest).abs() <= 64.0 * f64::EPSILON * nearest.abs().max(1.0) { nearest } else { coefficient }
}

/// `power (power - 1) … (power - order + 1)`
fn falling(power: usize, order: usize) -> f64 {
    (0..order).map(|step| power.saturating_sub(step) as f64).product()
}

/// The derivative of order `order` of `x^power`.
fn derivative_of_power(power: usize, order: usize, x: f64) -> f64 {
    if order > power {
        return 0.0;
    }
    falling(power, order) * x.powi(i32::try_from(power - order).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn position_and_tangent_at_both_ends_give_the_cubic_hermite_basis() {
        let cardinal = CardinalPolynomials::new(&[(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)]).expect("independent");
        let u = 0.3;
        let expected = [
            1.0 - 3.0 * u * u + 2.0 * u * u * u,
            u - 2.0 * u * u + u * u * u,
            3.0 * u * u - 2.0 * u * u * u,
            -u * u + u * u * u,
        ];
        for (value, expected) in cardinal.derivatives(0, u).iter().zip(expected) {
            // Four products and three sums of numbers below 1.
            assert!((value - expected).abs() < 4.0 * f64::EPSILON, "{value} {expected}");
        }
    }

    #[test]
    fn every_functional_sees_only_its_own_polynomial() {
        let functionals = [(2.0, 0), (2.0, 1), (2.5, 0), (5.0, 0), (5.0, 1), (5.0, 2)];
        let cardinal = CardinalPolynomials::new(&functionals).expect("independent");
        for (row, (x, order)) in functionals.iter().enumerate() {
            for (column, value) in cardinal.derivatives(*order, *x).into_iter().enumerate() {
                let expected = f64::from(u8::from(row == column));
                // Degree 5 on an interval of length 3: conditioned to about 1e3.
                assert!((value - expected).abs() < 1e-11, "{row} {column} {value}");
            }
        }
    }

    #[test]
    fn tangents_alone_are_dependent() {
        assert!(CardinalPolynomials::new(&[(0.0, 1), (1.0, 1)]).is_none());
    }
}
