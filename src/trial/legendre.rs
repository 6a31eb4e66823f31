//! Integrals of Legendre polynomials: for an equation of order n, φ_k is an n/2-fold integral of L_(k-1+n/2).
//!
//! With x from -1 to 1 over the range, ∫ L_k = (L_(k+1) - L_(k-1)) / (2k + 1); constants of integration do not
//! matter, since trial functions are corrected at the boundary. Expanding the derivative of half the order, the one
//! that the equation's energy contains, keeps both ends in balance: expanding S itself loses digits in the highest
//! derivative, expanding the highest derivative loses them in S where layers are thin.

use super::TrialFamily;
use crate::kernels::{InstructionSet, Rows, multiversion};

/// Integrals of Legendre polynomials of degree n/2 and up.
#[derive(Debug, Clone)]
pub struct IntegratedLegendre {
    /// For m = 0 … n/2 the m-fold integrals of the polynomials, as pairs of degree and Legendre coefficient.
    integrals: Vec<Vec<Vec<(usize, f64)>>>,
}

impl IntegratedLegendre {
    /// `count` functions for an equation of order `order`.
    #[must_use]
    pub fn new(order: usize, count: usize) -> Self {
        let integrations = order / 2;
        // Polynomials of lower degree than the order are the cardinal functions' own.
        let lowest = order - integrations;
        let mut integrals: Vec<Vec<Vec<(usize, f64)>>> = vec![(0..count).map(|k| vec![(k + lowest, 1.0)]).collect()];
        for _ in 0..integrations {
            let next = integrals.last().into_iter().flatten().map(|series| integral(series)).collect();
            integrals.push(next);
        }
        IntegratedLegendre { integrals }
    }

    fn integrations(&self) -> usize {
        self.integrals.len() - 1
    }
}

/// An antiderivative of a Legendre series, in x.
fn integral(series: &[(usize, f64)]) -> Vec<(usize, f64)> {
    let mut result: Vec<(usize, f64)> = Vec::with_capacity(series.len() + 1);
    let mut add = |degree: usize, value: f64| match result.iter_mut().find(|(found, _)| *found == degree) {
        Some((_, sum)) => *sum += value,
        None => result.push((degree, value)),
    };
    for &(degree, value) in series {
        let share = value / (2 * degree + 1) as f64;
        add(degree + 1, share);
        if degree > 0 {
            add(degree - 1, -share);
        }
    }
    result
}

/// L_0 … L_(count-1) at `x`.
fn legendre(count: usize, x: f64) -> Vec<f64> {
    let mut values = Vec::with_capacity(count);
    for k in 0..count {
        let value = match (k, values.get(k.wrapping_sub(1)), values.get(k.wrapping_sub(2))) {
            (0, ..) => 1.0,
            (1, ..) => x,
            (_, Some(one), Some(two)) => ((2 * k - 1) as f64 * x * one - (k - 1) as f64 * two) / k as f64,
            _ => 0.0,
        };
        values.push(value);
    }
    values
}

/// The derivatives of L_0, L_1, … given their values, or of one order more given those of any order.
fn slopes(values: &[f64]) -> Vec<f64> {
    // L_(k+1)' = L_(k-1)' + (2k + 1) L_k, and the same for higher derivatives.
    let mut slopes: Vec<f64> = Vec::with_capacity(values.len());
    for k in 0..values.len() {
        let below = k.checked_sub(2).and_then(|two| slopes.get(two)).copied().unwrap_or(0.0);
        let value = k.checked_sub(1).and_then(|one| values.get(one).map(|value| (2 * one + 1) as f64 * value));
        slopes.push(below + value.unwrap_or(0.0));
    }
    slopes
}

impl TrialFamily for IntegratedLegendre {
    fn name(&self) -> &'static str {
        "legendre"
    }

    fn derivatives(&self, count: usize, order: usize, u: f64, range: [f64; 2]) -> Vec<f64> {
        let (x, slope) = scaled(u, range);
        let differentiations = order.saturating_sub(self.integrations());
        let mut values = legendre(self.degrees(count), x);
        for _ in 0..differentiations {
            values = slopes(&values);
        }
        self.of_order(count, order, &values, slope)
    }

    fn derivatives_up_to(&self, count: usize, order: usize, u: f64, range: [f64; 2]) -> Vec<Vec<f64>> {
        let (x, slope) = scaled(u, range);
        let mut values = legendre(self.degrees(count), x);
        let mut all = Vec::with_capacity(order + 1);
        for order in 0..=order {
            if order > self.integrations() {
                values = slopes(&values);
            }
            all.push(self.of_order(count, order, &values, slope));
        }
        all
    }

    fn tabulate(&self, orders: &[usize], u: &[f64], range: [f64; 2], tables: &mut [Vec<&mut [f64]>]) {
        let set = InstructionSet::best();
        let x: Vec<f64> = u.iter().map(|u| scaled(*u, range).0).collect();
        let (_, slope) = scaled(range[0], range);
        let count = tables.iter().map(Vec::len).max().unwrap_or(0);
        let mut values = Rows::zeros(self.degrees(count), x.len());
        recur(set, &mut values.iter_mut().collect::<Vec<_>>(), &x);
        let mut differentiated = 0;
        let mut ascending: Vec<(usize, &mut Vec<&mut [f64]>)> = orders.iter().copied().zip(tables).collect();
        ascending.sort_by_key(|(order, _)| *order);
        for (order, rows) in ascending {
            while differentiated < order.saturating_sub(self.integrations()) {
                let mut slopes = Rows::zeros(values.count(), values.length());
                differentiate(set, &mut slopes.iter_mut().collect::<Vec<_>>(), &values);
                values = slopes;
                differentiated += 1;
            }
            let (factor, series) = self.series(order, slope);
            for (row, terms) in rows.iter_mut().zip(series) {
                sum(set, row, &values, (factor, terms));
            }
        }
    }
}

multiversion! {
    /// The Legendre polynomials L_0, L_1, … at every x, a row for each.
    fn recur(rows: &mut [&mut [f64]], x: &[f64]) {
        for k in 0..rows.len() {
            let (known, rest) = rows.split_at_mut(k);
            let Some(row) = rest.first_mut() else { continue };
            match (known.last(), k.checked_sub(2).and_then(|two| known.get(two))) {
                (Some(one), Some(two)) => {
                    let lanes = row.iter_mut().zip(x).zip(one.iter().zip(two.iter()));
                    for ((slot, x), (one, two)) in lanes {
                        *slot = ((2 * k - 1) as f64 * x * one - (k - 1) as f64 * two) / k as f64;
                    }
                }
                (Some(_), None) => row.copy_from_slice(x),
                _ => row.fill(1.0),
            }
        }
    }
}

multiversion! {
    /// The derivatives of L_0, L_1, … given their values, as [`slopes`] has them.
    fn differentiate(slopes: &mut [&mut [f64]], values: &Rows) {
        for k in 0..slopes.len() {
            let (known, rest) = slopes.split_at_mut(k);
            let Some(row) = rest.first_mut() else { continue };
            match k.checked_sub(2).and_then(|two| known.get(two)) {
                Some(below) => row.copy_from_slice(below),
                None => row.fill(0.0),
            }
            let Some(one) = k.checked_sub(1) else { continue };
            let factor = (2 * one + 1) as f64;
            row.iter_mut().zip(values.row(one)).for_each(|(slot, value)| *slot += factor * value);
        }
    }
}

multiversion! {
    /// `factor` times the sum of shares of the rows.
    fn sum(target: &mut [f64], rows: &Rows, scaled: (f64, &[(usize, f64)])) {
        let (factor, terms) = scaled;
        target.fill(0.0);
        for (degree, share) in terms {
            target.iter_mut().zip(rows.row(*degree)).for_each(|(slot, value)| *slot += share * value);
        }
        target.iter_mut().for_each(|slot| *slot *= factor);
    }
}

/// x from -1 to 1, and dx/du.
fn scaled(u: f64, [low, high]: [f64; 2]) -> (f64, f64) {
    let slope = 2.0 / (high - low);
    ((u - low) * slope - 1.0, slope)
}

impl IntegratedLegendre {
    /// How many Legendre polynomials `count` functions are made of: degrees from n - n/2, at most n/2 + 1, upwards, and
    /// up to n/2 higher by integration.
    fn degrees(&self, count: usize) -> usize {
        count + 2 * self.integrations() + 2
    }

    /// The derivatives of order `order` of φ_1 … φ_count, given as many derivatives of the Legendre polynomials as no
    /// integration undoes.
    fn of_order(&self, count: usize, order: usize, values: &[f64], slope: f64) -> Vec<f64> {
        let (factor, series) = self.series(order, slope);
        let sum = |terms: &Vec<(usize, f64)>| -> f64 {
            // From +0, as tables are summed: the sum of an iterator begins at -0.
            let term = |(degree, share): &(usize, f64)| share * values.get(*degree).copied().unwrap_or(0.0);
            terms.iter().map(term).fold(0.0, |sum, term| sum + term)
        };
        series.iter().take(count).map(|terms| factor * sum(terms)).collect()
    }

    /// The derivative of order `order` of each φ_k as a factor and shares of the derivatives of the Legendre polynomials
    /// that no integration undoes. φ_k is scaled so that its derivative of order n/2 in u is the polynomial itself.
    fn series(&self, order: usize, slope: f64) -> (f64, &[Vec<(usize, f64)>]) {
        let most = self.integrations();
        let (integrations, differentiations) = (most.saturating_sub(order), order.saturating_sub(most));
        let exponent = i32::try_from(differentiations).unwrap_or(i32::MAX) - i32::try_from(integrations).unwrap_or(0);
        (slope.powi(exponent), self.integrals.get(integrations).map_or(&[], Vec::as_slice))
    }
}
