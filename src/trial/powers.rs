//! The powers of You and Zhang 2003, Eq. 5: φ_k = x^(k + n - 1) for n boundary conditions.
//!
//! Lower powers are cubics (in general, polynomials of degree n - 1), which the boundary decides alone. The correction
//! makes `w_m(u) = (m - 3) u² - (m - 2) u³ + u^m` of u^m, for position and tangent at 0 and 1.

use super::TrialFamily;

/// `x^(k + n - 1)` with x from 0 to 1 over the range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Powers {
    lowest: usize,
}

impl Powers {
    /// The powers from `lowest` upwards: the number of boundary conditions.
    #[must_use]
    pub fn new(lowest: usize) -> Self {
        Powers { lowest }
    }
}

impl TrialFamily for Powers {
    fn name(&self) -> &'static str {
        "powers"
    }

    fn derivatives(&self, count: usize, order: usize, u: f64, [low, high]: [f64; 2]) -> Vec<f64> {
        let length = high - low;
        let x = (u - low) / length;
        let scale = length.powi(i32::try_from(order).unwrap_or(i32::MAX));
        let derivative = |power: usize| match power.checked_sub(order) {
            None => 0.0,
            Some(left) => {
                let factors: f64 = (left + 1..=power).map(|factor| factor as f64).product();
                factors * x.powi(i32::try_from(left).unwrap_or(i32::MAX)) / scale
            }
        };
        (self.lowest..self.lowest + count).map(derivative).collect()
    }
}
