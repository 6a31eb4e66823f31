//! Trial families φ_k(u), corrected to be invisible to the boundary.
//!
//! With cardinal functions ξ_i of the boundary functionals ℓ_i (position, tangent, … at fixed u), the corrected
//! trial function is `ζ_k = φ_k - Σ_i ξ_i ℓ_i[φ_k]` (docs/methods.md, T1; the corrected Eq. 12 of You, Ugail
//! and Zhang 2012). A surface `Σ_i ξ_i c_i + Σ_k ζ_k P_k` then meets its boundary for any P.
//!
//! A new family is one file here and one line in [`families`].

mod exponential;
mod legendre;
mod powers;
mod sine;

pub use exponential::{CardinalExponentials, JoinedModes};
pub use legendre::IntegratedLegendre;
pub use powers::Powers;
pub use sine::Sine;

use std::fmt::Debug;
use std::sync::Arc;

use crate::kernels::{InstructionSet, Rows, multiversion};
use crate::numeric::CardinalPolynomials;

/// Functions φ_1, φ_2, … of u with all their derivatives.
pub trait TrialFamily: Debug + Send + Sync {
    /// The name users give it.
    fn name(&self) -> &'static str;

    /// The derivatives of order `order` of φ_1 … φ_count at `u` in `range`.
    fn derivatives(&self, count: usize, order: usize, u: f64, range: [f64; 2]) -> Vec<f64>;

    /// The derivatives of every order up to `order`, one list for each: what several orders need is computed once.
    fn derivatives_up_to(&self, count: usize, order: usize, u: f64, range: [f64; 2]) -> Vec<Vec<f64>> {
        (0..=order).map(|order| self.derivatives(count, order, u, range)).collect()
    }

    /// The derivatives of each of `orders` at many `u`: for each order a row for each function, as long as `u`. The same
    /// bits as those of [`TrialFamily::derivatives`].
    fn tabulate(&self, orders: &[usize], u: &[f64], range: [f64; 2], tables: &mut [Vec<&mut [f64]>]) {
        for (order, rows) in orders.iter().zip(tables) {
            for (index, u) in u.iter().enumerate() {
                let values = self.derivatives(rows.len(), *order, *u, range);
                write_column(rows, index, values);
            }
        }
    }
}

/// Writes number `index` of each row.
fn write_column(rows: &mut [&mut [f64]], index: usize, values: Vec<f64>) {
    for (row, value) in rows.iter_mut().zip(values) {
        if let Some(slot) = row.get_mut(index) {
            *slot = value;
        }
    }
}

/// Every family, with room for `count` functions in an equation of order `order`.
#[must_use]
pub fn families(order: usize, count: usize) -> Vec<Arc<dyn TrialFamily>> {
    vec![Arc::new(Sine), Arc::new(IntegratedLegendre::new(order, count)), Arc::new(Powers::new(order))]
}

/// The functions of u that a separable surface is made of.
pub trait Modes: Debug + Send + Sync {
    /// The number of functions.
    fn count(&self) -> usize;

    /// The derivatives of order `order` of every function at `u`.
    fn derivatives(&self, order: usize, u: f64) -> Vec<f64>;

    /// The derivatives of each of `orders` at many `u`, a table for each order, in it a row for each function: the same bits.
    fn tabulate(&self, orders: &[usize], u: &[f64], tables: &mut Vec<Rows>) {
        for (order, rows) in orders.iter().zip(shaped(tables, orders.len(), (self.count(), u.len()))) {
            let mut rows: Vec<&mut [f64]> = rows.iter_mut().collect();
            for (index, u) in u.iter().enumerate() {
                write_column(&mut rows, index, self.derivatives(*order, *u));
            }
        }
    }
}

/// As many tables as are asked for, each of so many rows of such a length.
fn shaped(tables: &mut Vec<Rows>, count: usize, (rows, length): (usize, usize)) -> &mut [Rows] {
    tables.resize_with(count, Rows::default);
    tables.iter_mut().for_each(|table| table.reshape(rows, length));
    tables
}

/// The usual modes: ξ_1 … ξ_n, then ζ_1 … ζ_K.
#[derive(Debug, Clone)]
pub struct CorrectedTrial {
    family: Arc<dyn TrialFamily>,
    count: usize,
    range: [f64; 2],
    cardinal: CardinalPolynomials,
    /// Row k holds `ℓ_i[φ_k]` for every functional i.
    boundary_values: Vec<Vec<f64>>,
}

impl CorrectedTrial {
    /// `count` functions of `family` over `range`, corrected for `functionals`, pairs of a position and an order.
    ///
    /// `None` if the functionals are dependent.
    #[must_use]
    pub fn new(
        family: Arc<dyn TrialFamily>,
        count: usize,
        range: [f64; 2],
        functionals: &[(f64, usize)],
    ) -> Option<Self> {
        let cardinal = CardinalPolynomials::new(functionals)?;
        let at_boundary: Vec<Vec<f64>> =
            functionals.iter().map(|&(u, order)| family.derivatives(count, order, u, range)).collect();
        let row = |k: usize| at_boundary.iter().filter_map(|values| values.get(k).copied()).collect();
        let boundary_values = (0..count).map(row).collect();
        Some(CorrectedTrial { family, count, range, cardinal, boundary_values })
    }

    /// The derivatives of every order up to `order` of every function at `u`, one list for each.
    #[must_use]
    pub fn derivatives_up_to(&self, order: usize, u: f64) -> Vec<Vec<f64>> {
        let all = self.family.derivatives_up_to(self.count, order, u, self.range);
        all.iter().enumerate().map(|(order, raw)| self.corrected(self.cardinal.derivatives(order, u), raw)).collect()
    }

    /// Derivatives of the ξ_i, and behind them those of the ζ_k, given those of the φ_k.
    fn corrected(&self, mut values: Vec<f64>, raw: &[f64]) -> Vec<f64> {
        let cardinal = values.len();
        values.reserve(raw.len());
        for (value, at_boundary) in raw.iter().zip(&self.boundary_values) {
            let correction: f64 =
                at_boundary.iter().zip(values.iter().take(cardinal)).map(|(factor, cardinal)| factor * cardinal).sum();
            values.push(value - correction);
        }
        values
    }

    /// The number of boundary functionals: the first so many functions are the ξ_i.
    #[must_use]
    pub fn cardinal_count(&self) -> usize {
        self.cardinal.len()
    }
}

impl Modes for CorrectedTrial {
    fn count(&self) -> usize {
        self.cardinal.len() + self.count
    }

    fn derivatives(&self, order: usize, u: f64) -> Vec<f64> {
        let raw = self.family.derivatives(self.count, order, u, self.range);
        self.corrected(self.cardinal.derivatives(order, u), &raw)
    }

    fn tabulate(&self, orders: &[usize], u: &[f64], tables: &mut Vec<Rows>) {
        let tables = shaped(tables, orders.len(), (self.count(), u.len()));
        let rows = |table| Rows::iter_mut(table).collect::<Vec<&mut [f64]>>();
        let mut cardinal: Vec<Vec<&mut [f64]>> = tables.iter_mut().map(rows).collect();
        let mut trial: Vec<_> = cardinal.iter_mut().map(|rows| rows.split_off(self.cardinal.len())).collect();
        self.family.tabulate(orders, u, self.range, &mut trial);
        let set = InstructionSet::best();
        for ((order, cardinal), trial) in orders.iter().zip(&mut cardinal).zip(&mut trial) {
            self.cardinal.tabulate(*order, u, cardinal);
            for (row, at_boundary) in trial.iter_mut().zip(&self.boundary_values) {
                correct(set, row, cardinal, at_boundary);
            }
        }
    }
}

/// Numbers that are treated together, in registers.
const LANES: usize = 32;

multiversion! {
    /// Subtracts from a function what the boundary sees of it: its values there times the cardinal functions.
    fn correct(row: &mut [f64], cardinal: &[&mut [f64]], at_boundary: &[f64]) {
        let (whole, rest) = row.as_chunks_mut::<LANES>();
        let begin = whole.len() * LANES;
        for (number, values) in whole.iter_mut().enumerate() {
            let mut corrections = [0.0; LANES];
            for (factor, cardinal) in at_boundary.iter().zip(cardinal) {
                let Some(cardinal) = cardinal.as_chunks::<LANES>().0.get(number) else { continue };
                corrections.iter_mut().zip(cardinal).for_each(|(sum, cardinal)| *sum += factor * cardinal);
            }
            values.iter_mut().zip(&corrections).for_each(|(value, correction)| *value -= correction);
        }
        for (index, value) in rest.iter_mut().enumerate() {
            let at = |cardinal: &&mut [f64]| cardinal.get(begin + index).copied().unwrap_or(0.0);
            let products = at_boundary.iter().zip(cardinal).map(|(factor, cardinal)| factor * at(cardinal));
            *value -= products.sum::<f64>();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn corrected_sines_match_the_corrected_equation_12() {
        let functionals = [(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)];
        let trial = CorrectedTrial::new(Arc::new(Sine), 5, [0.0, 1.0], &functionals).expect("independent");
        let u: f64 = 0.37;
        for (k, value) in (1..=5).zip(trial.derivatives(0, u).into_iter().skip(4)) {
            let (k_pi, sign) = (f64::from(k) * PI, if k % 2 == 0 { 1.0 } else { -1.0 });
            let expected = (k_pi * u).sin() - k_pi * u + k_pi * (2.0 + sign) * u * u - k_pi * (1.0 + sign) * u * u * u;
            // A dozen operations on numbers below 3 k pi < 48.
            assert!((value - expected).abs() < 12.0 * 48.0 * f64::EPSILON, "{k}: {value} {expected}");
        }
    }

    #[test]
    fn corrected_powers_are_the_trial_functions_of_equation_5() {
        let functionals = [(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)];
        let trial = CorrectedTrial::new(Arc::new(Powers::new(4)), 7, [0.0, 1.0], &functionals).expect("independent");
        for u in [0.0_f64, 0.2, 0.73, 1.0] {
            for (n, value) in (4..=10).zip(trial.derivatives(0, u).into_iter().skip(4)) {
                let expected = f64::from(n - 3) * u * u - f64::from(n - 2) * u * u * u + u.powi(n);
                // A handful of operations on numbers up to 8.
                assert!((value - expected).abs() < 6.0 * 8.0 * f64::EPSILON, "{n}: {value} {expected}");
            }
        }
    }

    #[test]
    fn corrected_functions_vanish_at_the_boundary_on_any_interval() {
        let functionals = [(-1.0, 0), (-1.0, 1), (-1.0, 2), (2.5, 0), (2.5, 1), (2.5, 2)];
        for family in families(6, 6) {
            let trial = CorrectedTrial::new(Arc::clone(&family), 6, [-1.0, 2.5], &functionals).expect("independent");
            for (u, order) in functionals {
                for value in trial.derivatives(order, u).into_iter().skip(6) {
                    // Second derivatives of φ_6 reach (6π/3.5)² < 30, cancelled to rounding.
                    assert!(value.abs() < 1e-12, "{} {u} {order} {value}", family.name());
                }
            }
        }
    }

    #[test]
    fn derivatives_of_several_orders_are_those_of_each_order() {
        let functionals = [(0.0, 0), (0.0, 1), (2.0, 0), (2.0, 1)];
        for family in families(4, 5) {
            let trial = CorrectedTrial::new(family, 5, [0.0, 2.0], &functionals).expect("independent");
            for u in [0.0, 0.7, 2.0] {
                let each: Vec<Vec<f64>> = (0..=6).map(|order| trial.derivatives(order, u)).collect();
                assert_eq!(trial.derivatives_up_to(6, u), each);
            }
        }
    }

    #[test]
    fn tables_have_the_bits_of_single_values() {
        let functionals = [(-0.5, 0), (-0.5, 1), (2.0, 0), (2.0, 1)];
        let u: Vec<f64> = (0..23).map(|i| -0.5 + 2.5 * f64::from(i) / 22.0).collect();
        let mut modes: Vec<Arc<dyn Modes>> = Vec::new();
        for family in families(4, 5) {
            modes.push(Arc::new(CorrectedTrial::new(family, 5, [-0.5, 2.0], &functionals).expect("independent")));
        }
        modes.push(Arc::new(CardinalExponentials::new(3.0, [-0.5, 2.0], &functionals).expect("independent")));
        for modes in modes {
            let (orders, mut tables) = ([0, 1, 4, 2], Vec::new());
            modes.tabulate(&orders, &u, &mut tables);
            for (order, table) in orders.iter().zip(&tables) {
                for (index, u) in u.iter().enumerate() {
                    let found: Vec<f64> = table.iter().map(|row| row[index]).collect();
                    let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<u64>>();
                    assert_eq!(bits(&found), bits(&modes.derivatives(*order, *u)), "{modes:?} {order} {u}");
                }
            }
        }
    }

    #[test]
    fn derivatives_agree_with_difference_quotients() {
        let functionals = [(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)];
        for family in families(4, 4) {
            let trial = CorrectedTrial::new(family, 4, [0.0, 1.0], &functionals).expect("independent");
            let (u, h) = (0.4, 1e-5);
            for order in 0..6_usize {
                let (after, before) = (trial.derivatives(order, u + h), trial.derivatives(order, u - h));
                for ((a, b), slope) in after.iter().zip(before).zip(trial.derivatives(order + 1, u)) {
                    let quotient = (a - b) / (2.0 * h);
                    // Truncation h²/6 times the third derivative, rounding ε/h: both below 1e-8 of (4π)^order.
                    let size = (4.0 * PI).powi(i32::try_from(order).expect("small") + 3).max(1.0);
                    assert!((quotient - slope).abs() < 1e-10 * size, "{order}: {quotient} {slope}");
                }
            }
        }
    }
}
