//! The functions of u: four trigonometric ones that carry the boundary, and `sin²(πx) T_m(2x - 1)`, which it
//! cannot see, for x from 0 to 1 over the range of u (docs/methods.md, B1 and B2).
//!
//! T_0 … T_M span the same functions as the powers u^0 … u^M of the paper, so the surface is the same, and the
//! systems are better conditioned by orders of magnitude.

use std::f64::consts::PI;

use crate::trial::Modes;

/// B_1 … B_4 for position and tangent at both ends, then the hidden functions for m = 0 … M.
#[derive(Debug, Clone)]
pub struct BlendModes {
    hidden: usize,
    range: [f64; 2],
}

/// The number of functions that carry the boundary.
pub const CARDINAL: usize = 4;

impl BlendModes {
    /// The modes up to the power `highest` over `range`.
    pub fn new(highest: usize, range: [f64; 2]) -> BlendModes {
        BlendModes { hidden: highest + 1, range }
    }
}

impl Modes for BlendModes {
    fn count(&self) -> usize {
        CARDINAL + self.hidden
    }

    fn derivatives(&self, order: usize, u: f64) -> Vec<f64> {
        let [low, high] = self.range;
        let length = high - low;
        let x = (u - low) / length;
        let [value, slope, value_end, slope_end] = cardinal(order, x);
        // Tangents are prescribed per unit of u, not of x.
        let mut all = vec![value, length * slope, value_end, length * slope_end];
        all.extend(hidden(self.hidden, order, x));
        let scale = length.powi(-exponent(order));
        all.iter_mut().for_each(|value| *value *= scale);
        all
    }
}

/// `sin πx` and `cos πx`, exact at 0, 1/2 and 1: the boundary is met to rounding because these are.
fn half_turn(x: f64) -> (f64, f64) {
    match x {
        _ if x < 0.25 => (libm::sin(PI * x), libm::cos(PI * x)),
        _ if x <= 0.75 => (libm::cos(PI * (0.5 - x)), libm::sin(PI * (0.5 - x))),
        _ => (libm::sin(PI * (1.0 - x)), -libm::cos(PI * (1.0 - x))),
    }
}

/// `sin 2πx` and `cos 2πx`, exact at multiples of 1/4: a column of zeros must not become one of rounding errors,
/// which no rank test tells from data.
fn full_turn(x: f64) -> (f64, f64) {
    let y = 2.0 * x;
    if y <= 1.0 {
        return half_turn(y);
    }
    let (sine, cosine) = half_turn(y - 1.0);
    (-sine, -cosine)
}

/// The derivative of order `order` of a sine over its frequency to that order, from sine and cosine.
fn turned(order: usize, (sine, cosine): (f64, f64)) -> f64 {
    match order % 4 {
        0 => sine,
        1 => cosine,
        2 => -sine,
        _ => -cosine,
    }
}

/// The derivatives of order `order` in x of B_1 … B_4.
fn cardinal(order: usize, x: f64) -> [f64; CARDINAL] {
    let wave = half_turn(x);
    let power = |order: usize| PI.powi(exponent(order));
    // With s = sin πx and k = cos πx = s'/π.
    let s = |order: usize| power(order) * turned(order, wave);
    let k = |order: usize| power(order) * turned(order + 1, wave);
    let p = order as f64;
    let (s_before, k_before) = order.checked_sub(1).map_or((0.0, 0.0), |before| (p * s(before), p * k(before)));
    let (s, k) = (s(order), k(order));
    [
        s / PI + ((1.0 - x) * k - k_before),
        ((1.0 - x) * s - s_before) / PI,
        s / PI - (x * k + k_before),
        -(x * s + s_before) / PI,
    ]
}

/// The derivatives of order `order` in x of `sin²(πx) T_m(2x - 1)` for m below `count`, by Leibniz' rule.
fn hidden(count: usize, order: usize, x: f64) -> Vec<f64> {
    let (s, _) = half_turn(x);
    let double = full_turn(x);
    let mut values = vec![0.0; count];
    let mut binomial = 1.0;
    let mut before: Vec<f64> = Vec::new();
    for part in 0..=order {
        let series = chebyshev(count, part, 2.0 * x - 1.0, &before);
        // sin² πx = (1 - cos 2πx)/2, and as a square where it is not differentiated.
        let rest = order - part;
        let square = match rest {
            0 => s * s,
            _ => -0.5 * (2.0 * PI).powi(exponent(rest)) * turned(rest + 1, double),
        };
        let factor = binomial * square * 2_f64.powi(exponent(part));
        values.iter_mut().zip(&series).for_each(|(value, polynomial)| *value += factor * polynomial);
        binomial = binomial * (order - part) as f64 / (part + 1) as f64;
        before = series;
    }
    values
}

/// The derivatives of order `order` of T_0 … at `x`, from those of the order before.
fn chebyshev(count: usize, order: usize, x: f64, before: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(count);
    for m in 0..count {
        let at = |back: usize| m.checked_sub(back).and_then(|index| values.get(index)).copied();
        let slope = m.checked_sub(1).and_then(|one| before.get(one)).map_or(0.0, |slope| order as f64 * slope);
        let value = match (m, order) {
            (0, 0) => 1.0,
            (0, _) => 0.0,
            // T_1 = x T_0; T_m = 2x T_(m-1) - T_(m-2) after that.
            (1, _) => x * at(1).unwrap_or(0.0) + slope,
            _ => 2.0 * (x * at(1).unwrap_or(0.0) + slope) - at(2).unwrap_or(0.0),
        };
        values.push(value);
    }
    values
}

fn exponent(order: usize) -> i32 {
    i32::try_from(order).unwrap_or(i32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_boundary_sees_each_cardinal_function_once_and_no_hidden_one() {
        let (low, high) = (-0.3, 2.9);
        let modes = BlendModes::new(9, [low, high]);
        for (index, (u, order)) in [(low, 0), (low, 1), (high, 0), (high, 1)].into_iter().enumerate() {
            for (mode, value) in modes.derivatives(order, u).into_iter().enumerate() {
                let expected = if mode == index { 1.0 } else { 0.0 };
                // A scale factor and its inverse: two roundings.
                assert!((value - expected).abs() <= 2.0 * f64::EPSILON, "{index} {mode}: {value}");
            }
        }
    }

    #[test]
    fn cardinal_functions_are_those_of_equation_7() {
        let u: f64 = 0.37;
        let (s, k) = (PI * u).sin_cos();
        let expected = [s / PI + (1.0 - u) * k, (1.0 - u) * s / PI, s / PI - u * k, -u * s / PI];
        for (value, expected) in cardinal(0, u).into_iter().zip(expected) {
            // A few roundings of numbers below 1.
            assert!((value - expected).abs() < 8.0 * f64::EPSILON, "{value} {expected}");
        }
    }

    #[test]
    fn fourth_derivatives_are_those_of_equation_9() {
        let u: f64 = 0.37;
        let (s2, c2) = (2.0 * PI * u).sin_cos();
        let square = (PI * u).sin().powi(2);
        // T_2(2u - 1) = 8u² - 8u + 1, from the corrected Eq. 9 for m = 0, 1, 2.
        let power = |m: i32| {
            let (f, u_to) = (f64::from(m), |less: i32| if m < less { 0.0 } else { u.powi(m - less) });
            -8.0 * PI.powi(4) * u.powi(m) * c2 - 16.0 * f * PI.powi(3) * u_to(1) * s2
                + 12.0 * f * (f - 1.0) * PI.powi(2) * u_to(2) * c2
                + 4.0 * f * (f - 1.0) * (f - 2.0) * PI * u_to(3) * s2
                + f * (f - 1.0) * (f - 2.0) * (f - 3.0) * u_to(4) * square
        };
        let expected = [power(0), 2.0 * power(1) - power(0), 8.0 * power(2) - 8.0 * power(1) + power(0)];
        for (value, expected) in hidden(3, 4, u).into_iter().zip(expected) {
            // A dozen operations on numbers below 8 (2π)^4.
            assert!((value - expected).abs() < 12.0 * 8.0 * 1600.0 * f64::EPSILON, "{value} {expected}");
        }
    }

    #[test]
    fn derivatives_agree_with_difference_quotients() {
        let modes = BlendModes::new(6, [0.5, 1.75]);
        let (u, h) = (0.9, 1e-5);
        for order in 0..6_usize {
            let (after, before) = (modes.derivatives(order, u + h), modes.derivatives(order, u - h));
            for ((a, b), slope) in after.iter().zip(before).zip(modes.derivatives(order + 1, u)) {
                // Truncation h²/6 times a third derivative below 20^(order + 3), rounding ε/h times 20^order.
                let bound = 20_f64.powi(exponent(order)) * (h * h / 6.0 * 8000.0 + 4.0 * f64::EPSILON / h);
                let quotient = (a - b) / (2.0 * h);
                assert!((quotient - slope).abs() < bound, "{order}: {quotient} {slope}");
            }
        }
    }
}
