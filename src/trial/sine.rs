//! The sine family φ_k(u) = sin(kπ (u - a)/(b - a)) of You, Ugail and Zhang 2012, Eq. 9.

use super::TrialFamily;

/// `sin kπx` with x from 0 to 1 over the range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sine;

impl TrialFamily for Sine {
    fn name(&self) -> &'static str {
        "sine"
    }

    fn derivatives(&self, count: usize, order: usize, u: f64, [low, high]: [f64; 2]) -> Vec<f64> {
        let length = high - low;
        let x = (u - low) / length;
        (1..=count)
            .map(|k| {
                let wave = std::f64::consts::PI * k as f64;
                let (sine, cosine) = (libm::sin(wave * x), libm::cos(wave * x));
                let value = match order % 4 {
                    0 => sine,
                    1 => cosine,
                    2 => -sine,
                    _ => -cosine,
                };
                value * (wave / length).powi(i32::try_from(order).unwrap_or(i32::MAX))
            })
            .collect()
    }
}
