//! The sine family φ_k(u) = sin(kπ (u - a)/(b - a)) of You, Ugail and Zhang 2012, Eq. 9.

use std::f64::consts::PI;

use super::TrialFamily;
use crate::kernels::elementary::{cos, sin, sin_cos_block};
use crate::kernels::{InstructionSet, multiversion};

/// `sin kπx` with x from 0 to 1 over the range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sine;

/// Of the derivative of order `order` of `sin ωu`: whether it is a sine, and its factor.
fn derivative(order: usize, omega: f64) -> (bool, f64) {
    let size = omega.powi(i32::try_from(order).unwrap_or(i32::MAX));
    (order.is_multiple_of(2), if order % 4 < 2 { size } else { -size })
}

impl TrialFamily for Sine {
    fn name(&self) -> &'static str {
        "sine"
    }

    fn derivatives(&self, count: usize, order: usize, u: f64, [low, high]: [f64; 2]) -> Vec<f64> {
        let length = high - low;
        let x = (u - low) / length;
        let value = |k: usize| {
            let wave = PI * k as f64;
            let (is_sine, factor) = derivative(order, wave / length);
            factor * if is_sine { sin(wave * x) } else { cos(wave * x) }
        };
        (1..=count).map(value).collect()
    }

    fn tabulate(&self, orders: &[usize], u: &[f64], [low, high]: [f64; 2], tables: &mut [Vec<&mut [f64]>]) {
        let (set, length) = (InstructionSet::best(), high - low);
        let x: Vec<f64> = u.iter().map(|u| (u - low) / length).collect();
        let [mut angles, mut sines, mut cosines] = [(); 3].map(|()| vec![0.0; x.len()]);
        for k in 0..tables.iter().map(Vec::len).max().unwrap_or(0) {
            let wave = PI * (k + 1) as f64;
            scale(set, &mut angles, &x, wave);
            sin_cos_block(set, &mut sines, &mut cosines, &angles);
            for (order, rows) in orders.iter().zip(&mut *tables) {
                let (is_sine, factor) = derivative(*order, wave / length);
                let Some(row) = rows.get_mut(k) else { continue };
                scale(set, row, if is_sine { &sines } else { &cosines }, factor);
            }
        }
    }
}

multiversion! {
    /// `target = factor * numbers`
    fn scale(target: &mut [f64], numbers: &[f64], factor: f64) {
        target.iter_mut().zip(numbers).for_each(|(slot, number)| *slot = factor * number);
    }
}
