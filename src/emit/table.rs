//! Derivatives of data, as polynomials on pieces, for programs that call them.

use crate::expr::SplineCall;

/// A piecewise polynomial of one or two arguments, or with none a number.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SplineTable {
    /// Those that vary.
    pub arguments: Vec<Argument>,
    /// By piece and power of the first argument, then by piece and power of the second, around where pieces begin.
    pub coefficients: Vec<f64>,
}

/// One argument of a table.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Argument {
    /// Where pieces begin, and the end of the last.
    pub breaks: Vec<f64>,
    /// Coefficients of a piece: one more than the degree.
    pub powers: usize,
    /// Whether the pieces repeat beyond the ends.
    pub is_periodic: bool,
}

impl Argument {
    /// The number of pieces.
    pub fn pieces(&self) -> usize {
        self.breaks.len().saturating_sub(1)
    }

    /// The piece at `x`, and how far into it.
    fn locate(&self, x: f64) -> (usize, f64) {
        let (low, high) = match self.breaks.as_slice() {
            [low, .., high] => (*low, *high),
            _ => return (0, f64::NAN),
        };
        let x = if self.is_periodic { x - ((x - low) / (high - low)).floor() * (high - low) } else { x };
        let piece = self.breaks.partition_point(|start| *start <= x).saturating_sub(1).min(self.pieces() - 1);
        (piece, x - self.breaks.get(piece).copied().unwrap_or(low))
    }
}

impl SplineTable {
    /// The table of `call` with some of its arguments held; `held` has an entry for each.
    pub fn new(call: &SplineCall, held: &[Option<f64>]) -> SplineTable {
        let spline = &call.spline;
        let mut coefficients = spline.coefficients().to_vec();
        let mut arguments = Vec::new();
        // The last argument first: its entries lie beside each other.
        for (index, held) in held.iter().enumerate().rev() {
            let order = call.orders.get(index).copied().unwrap_or(0);
            let (powers, breaks) = (spline.degree(index) + 1, spline.breaks(index).to_vec());
            // Entries of one power of this argument are this far apart.
            let stride: usize = arguments.iter().map(|other: &Argument| other.pieces() * other.powers).product();
            coefficients = differentiated(&coefficients, powers, order, stride);
            let argument = Argument {
                breaks,
                powers: powers.saturating_sub(order).max(1),
                is_periodic: spline.is_periodic(index),
            };
            match held {
                Some(value) => coefficients = at(&coefficients, &argument, *value, stride),
                None => arguments.insert(0, argument),
            }
        }
        SplineTable { arguments, coefficients }
    }
}

/// Every polynomial of `powers` coefficients, `stride` apart, differentiated `order` times.
fn differentiated(coefficients: &[f64], powers: usize, order: usize, stride: usize) -> Vec<f64> {
    let falling = |power: usize| (0..order).map(|taken| (power - taken) as f64).product::<f64>();
    let pieces = coefficients.chunks(powers * stride);
    let piece = |piece: &[f64]| -> Vec<f64> {
        let rows = piece.chunks(stride).enumerate().skip(order);
        let kept: Vec<f64> = rows.flat_map(|(power, row)| row.iter().map(move |c| c * falling(power))).collect();
        if kept.is_empty() { vec![0.0; stride] } else { kept }
    };
    pieces.flat_map(piece).collect()
}

/// The polynomials at a value of the argument whose entries are `stride` apart.
fn at(coefficients: &[f64], argument: &Argument, value: f64, stride: usize) -> Vec<f64> {
    let (piece, x) = argument.locate(value);
    let width = argument.powers * stride;
    let groups = coefficients.chunks(argument.pieces() * width);
    let sum = |group: &[f64]| -> Vec<f64> {
        let polynomial = group.get(piece * width..(piece + 1) * width).unwrap_or_default();
        let mut sum = vec![0.0; stride];
        for row in polynomial.chunks(stride).rev() {
            sum.iter_mut().zip(row).for_each(|(sum, c)| *sum = *sum * x + c);
        }
        sum
    };
    groups.flat_map(sum).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::expr::{Knots, Spline};

    fn value(table: &SplineTable, at_point: &[f64]) -> f64 {
        let mut coefficients = table.coefficients.clone();
        let mut stride: usize = table.arguments.iter().map(|argument| argument.pieces() * argument.powers).product();
        for (argument, x) in table.arguments.iter().zip(at_point) {
            stride /= argument.pieces() * argument.powers;
            coefficients = at(&coefficients, argument, *x, stride);
        }
        coefficients[0]
    }

    #[test]
    fn tables_give_the_values_of_the_spline_in_every_derivative() {
        let knots = |degree, knots: &[f64]| Knots { degree, knots: knots.to_vec(), seam: None };
        let first = knots(3, &[0.0, 0.0, 0.0, 0.0, 0.4, 1.0, 1.0, 1.0, 1.0]);
        let second = knots(2, &[0.0, 0.0, 0.0, 0.5, 0.8, 2.0, 2.0, 2.0]);
        let controls: Vec<f64> = (0..25).map(|k| f64::from(k * k % 17) - 5.0).collect();
        let spline = Arc::new(Spline::new("P", &[("a", first), ("b", second)], &controls).expect("a spline"));
        for orders in [[0, 0], [1, 0], [0, 1], [2, 1], [3, 2]] {
            let call = SplineCall { spline: Arc::clone(&spline), orders, is_piecewise: false };
            for (x, y) in [(0.0, 0.0), (0.3, 0.7), (0.4, 1.9), (1.0, 2.0)] {
                let expected = call.value(x, y);
                let near = |found: f64| (found - expected).abs() <= 1e-12 * expected.abs().max(1.0);
                assert!(near(value(&SplineTable::new(&call, &[None, None]), &[x, y])), "{orders:?} at {x}, {y}");
                assert!(near(value(&SplineTable::new(&call, &[Some(x), None]), &[y])), "{orders:?} at held {x}, {y}");
                assert!(near(value(&SplineTable::new(&call, &[None, Some(y)]), &[x])), "{orders:?} at {x}, held {y}");
                assert!(near(value(&SplineTable::new(&call, &[Some(x), Some(y)]), &[])), "{orders:?} held");
            }
        }
    }
}
