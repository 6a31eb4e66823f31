//! Chebyshev series `Σ_k c_k T_k(x)` of smooth functions, x from -1 to 1 over a range.
//!
//! The coefficients come from interpolation at the zeros of a Chebyshev polynomial, with twice as many nodes until
//! the last quarter of the coefficients is rounding. A polynomial is its series, to rounding.

use std::f64::consts::PI;

/// Series of several functions at once, cut at one degree.
#[derive(Debug, Clone, PartialEq)]
pub struct ChebyshevSeries {
    /// Where the functions live.
    pub range: [f64; 2],
    /// For each degree, from 0, the coefficient of every function.
    pub coefficients: Vec<Vec<f64>>,
}

/// The fewest nodes tried, and the most.
const NODES: [usize; 2] = [8, 2048];

impl ChebyshevSeries {
    /// The series of `function`, which gives `width` values at any point of `range`.
    ///
    /// The coefficients left out, or set to zero, are at most `tolerance` times the largest of any function,
    /// or times `least` if that is larger. `None` if that takes more
    /// than 2048 nodes, or a value is not finite.
    pub fn fit(
        range: [f64; 2],
        width: usize,
        (tolerance, least): (f64, f64),
        function: impl Fn(f64) -> Vec<f64>,
    ) -> Option<ChebyshevSeries> {
        let [low, high] = range;
        let mut count = NODES[0];
        while count <= NODES[1] {
            let mut samples = Vec::with_capacity(count);
            for node in 0..count {
                let x = libm::cos(PI * (node as f64 + 0.5) / count as f64);
                samples.push(function(0.5 * (low * (1.0 - x) + high * (1.0 + x))));
            }
            let mut coefficients = interpolation(&samples, width);
            let sizes: Vec<f64> = coefficients.iter().map(|row| largest(row)).collect();
            let bound = tolerance * largest(&sizes);
            // Before the larger of both is taken, which would swallow NaN.
            if !bound.is_finite() {
                return None;
            }
            let bound = bound.max(tolerance * least);
            let needed = sizes.iter().rposition(|size| *size > bound).map_or(1, |last| last + 1);
            if needed <= count * 3 / 4 {
                coefficients.truncate(needed);
                // Zeros come out as rounding errors; a table is easier to read with zeros.
                let noise = bound / 16.0;
                coefficients.iter_mut().flatten().filter(|c| c.abs() <= noise).for_each(|c| *c = 0.0);
                return Some(ChebyshevSeries { range, coefficients });
            }
            count *= 2;
        }
        None
    }

    /// The value of every function at `at`, by Clenshaw's recurrence.
    #[must_use]
    pub fn values(&self, at: f64) -> Vec<f64> {
        let [low, high] = self.range;
        let x = (2.0 * at - low - high) / (high - low);
        let width = self.coefficients.first().map_or(0, Vec::len);
        let (mut next, mut after) = (vec![0.0; width], vec![0.0; width]);
        for row in self.coefficients.iter().skip(1).rev() {
            for ((next, after), coefficient) in next.iter_mut().zip(&mut after).zip(row) {
                (*next, *after) = (2.0 * x * *next - *after + coefficient, *next);
            }
        }
        let constant = self.coefficients.first().into_iter().flatten();
        constant.zip(next.iter().zip(&after)).map(|(constant, (next, after))| x * next - after + constant).collect()
    }
}

fn largest(values: &[f64]) -> f64 {
    // Not `f64::max`, which would forget a NaN.
    values.iter().fold(0.0, |most: f64, value| if value.abs() <= most { most } else { value.abs() + 0.0 * most })
}

/// Coefficients of the polynomial through samples at the zeros of T_n, by degree: `c_k = 2/n Σ f(x_i) T_k(x_i)`.
fn interpolation(samples: &[Vec<f64>], width: usize) -> Vec<Vec<f64>> {
    let count = samples.len();
    // T_k(x_i) = cos(π k (2i + 1)/2n), which repeats after 4n quarter steps.
    let cosines: Vec<f64> = (0..4 * count).map(|step| libm::cos(PI * step as f64 / (2 * count) as f64)).collect();
    let mut coefficients = vec![vec![0.0; width]; count];
    for (degree, row) in coefficients.iter_mut().enumerate() {
        let share = if degree == 0 { 1.0 } else { 2.0 } / count as f64;
        for (node, sample) in samples.iter().enumerate() {
            let polynomial = cosines.get(degree * (2 * node + 1) % (4 * count)).copied().unwrap_or(f64::NAN);
            for (sum, value) in row.iter_mut().zip(sample) {
                *sum += share * polynomial * value;
            }
        }
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit(range: [f64; 2], function: impl Fn(f64) -> Vec<f64>) -> Option<ChebyshevSeries> {
        let width = function(range[0]).len();
        ChebyshevSeries::fit(range, width, (4e-15, 0.0), function)
    }

    #[test]
    fn series_of_a_cubic_has_four_coefficients() {
        let series = fit([0.0, 1.0], |u| vec![1.0 - 3.0 * u * u + 2.0 * u * u * u]).expect("smooth");
        assert_eq!(series.coefficients.len(), 4);
        // T_0, T_1 and T_3 over [0, 1], by hand: with x = 2u - 1 it is 1/2 - 3/4 x + 1/4 x³.
        for (row, expected) in series.coefficients.iter().zip([0.5, -9.0 / 16.0, 0.0, 1.0 / 16.0]) {
            assert!((row[0] - expected).abs() < 8.0 * f64::EPSILON, "{row:?} {expected}");
        }
    }

    #[test]
    fn series_of_a_wave_agrees_with_it_between_the_nodes() {
        let series = fit([-1.0, 3.0], |u| vec![(40.0 * u).sin(), u.exp()]).expect("smooth");
        for step in 0..=100 {
            let u = -1.0 + 0.04 * f64::from(step);
            let values = series.values(u);
            // The cut of 4e-15 of the largest coefficient (about 8), and as many roundings as terms.
            assert!((values[0] - (40.0 * u).sin()).abs() < 2e-12, "{u}");
            assert!((values[1] - u.exp()).abs() < 2e-12, "{u}");
        }
    }

    #[test]
    fn functions_with_a_kink_or_a_pole_have_no_series() {
        assert!(fit([-1.0, 1.0], |u| vec![(u - 0.3).abs()]).is_none());
        assert!(fit([-1.0, 1.0], |u| vec![1.0 / (u - u)]).is_none());
    }

    #[test]
    fn zero_has_the_series_zero() {
        let series = fit([0.0, 1.0], |_| vec![0.0, 0.0]).expect("smooth");
        assert_eq!((series.coefficients.len(), series.values(0.7)), (1, vec![0.0, 0.0]));
    }
}
