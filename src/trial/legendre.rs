//! Integrals of Legendre polynomials: φ_k is an n-fold integral of L_(k-1), so φ_k^(n) is the polynomial itself.
//!
//! With x from -1 to 1 over the range, ∫ L_k = (L_(k+1) - L_(k-1)) / (2k + 1); constants of integration do not
//! matter, since trial functions are corrected at the boundary. Expanding the highest derivative, not the function,
//! keeps the systems of an equation of order n well conditioned for any number of functions.

use super::TrialFamily;

/// n-fold integrals of L_0, L_1, …
#[derive(Debug, Clone)]
pub struct IntegratedLegendre {
    /// For m = 0 … n the m-fold integrals of L_0, L_1, …, as pairs of degree and Legendre coefficient.
    integrals: Vec<Vec<Vec<(usize, f64)>>>,
}

impl IntegratedLegendre {
    /// `count` functions for an equation of order `order`.
    #[must_use]
    pub fn new(order: usize, count: usize) -> Self {
        let mut integrals: Vec<Vec<Vec<(usize, f64)>>> = vec![(0..count).map(|k| vec![(k, 1.0)]).collect()];
        for _ in 0..order {
            let next = integrals.last().into_iter().flatten().map(|series| integral(series)).collect();
            integrals.push(next);
        }
        IntegratedLegendre { integrals }
    }

    fn order(&self) -> usize {
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

/// The derivatives of order `order` of L_0 … L_(count-1) at `x`.
fn legendre(count: usize, order: usize, x: f64) -> Vec<f64> {
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
    for _ in 0..order {
        // L_(k+1)' = L_(k-1)' + (2k + 1) L_k, and the same for higher derivatives.
        let mut slopes: Vec<f64> = Vec::with_capacity(count);
        for k in 0..count {
            let below = k.checked_sub(2).and_then(|two| slopes.get(two)).copied().unwrap_or(0.0);
            let value = k.checked_sub(1).and_then(|one| values.get(one).map(|value| (2 * one + 1) as f64 * value));
            slopes.push(below + value.unwrap_or(0.0));
        }
        values = slopes;
    }
    values
}

impl TrialFamily for IntegratedLegendre {
    fn name(&self) -> &'static str {
        "legendre"
    }

    fn derivatives(&self, count: usize, order: usize, u: f64, [low, high]: [f64; 2]) -> Vec<f64> {
        // dx/du; φ_k is scaled so that its derivative of order n in u is L_(k-1) itself.
        let slope = 2.0 / (high - low);
        let x = (u - low) * slope - 1.0;
        let (integrations, differentiations) = (self.order().saturating_sub(order), order.saturating_sub(self.order()));
        let values = legendre(count + integrations + 1, differentiations, x);
        let exponent = i32::try_from(differentiations).unwrap_or(i32::MAX) - i32::try_from(integrations).unwrap_or(0);
        let factor = slope.powi(exponent);
        let series = self.integrals.get(integrations).into_iter().flatten().take(count);
        let sum = |terms: &Vec<(usize, f64)>| -> f64 {
            terms.iter().map(|(degree, share)| share * values.get(*degree).copied().unwrap_or(0.0)).sum()
        };
        series.map(|terms| factor * sum(terms)).collect()
    }
}
