//! The equation tested with functions that vanish with their first derivatives on all four sides.
//!
//! For such a φ every term may hand derivatives on, without boundary terms: `∫ c ∂S φ = ± ∫ ∂'S ∂''(c φ)`, up to two in
//! u and two in v (docs/methods.md, H3). So an equation of order four asks only for second derivatives of S, which exist
//! where the twists of a corner disagree, while fourth ones are not even square integrable there.

use nalgebra::DMatrix;

use crate::decompose::bounded_derivative;
use crate::diagnostic::Diagnostic;
use crate::expr::{Derivative, ExprId, Graph, Number};
use crate::limits::Limits;
use crate::problem::PdeOperator;

/// One summand `∫ c ∂S ∂φ`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// The derivative of S.
    pub of_surface: Derivative,
    /// The orders in u and v of the derivative of φ.
    pub of_test: [usize; 2],
    /// The coefficient c for x, y and z.
    pub coefficient: [ExprId; 3],
}

impl Part {
    /// The order in u and v together, of surface and test function.
    pub fn order(&self) -> usize {
        self.of_surface.u + self.of_surface.v + self.of_test.iter().sum::<usize>()
    }
}

/// The summands of all terms of `operator`, none of order above four.
///
/// # Errors
/// [`Code::NotDifferentiable`](crate::diagnostic::Code) when a coefficient has no derivative that is needed.
pub fn weak_form(graph: &mut Graph, operator: &PdeOperator, limits: &Limits) -> Result<Vec<Part>, Diagnostic> {
    let mut parts = Vec::new();
    for term in &operator.terms {
        let [moved_u, moved_v] = moved(term.derivative);
        let left = Derivative { u: term.derivative.u - moved_u, v: term.derivative.v - moved_v, ..term.derivative };
        let sign = if (moved_u + moved_v) % 2 == 0 { 1 } else { -1 };
        for k in 0..=moved_u {
            for l in 0..=moved_v {
                let factor = sign * choose(moved_u, k) * choose(moved_v, l);
                let mut coefficient = term.coefficient;
                for component in &mut coefficient {
                    let slope =
                        bounded_derivative(graph, *component, Derivative::new(k, l, 0), limits, operator.origin)?;
                    *component = graph.scale(Number::integer(factor), slope);
                }
                if coefficient.iter().any(|component| !graph.is_zero(*component)) {
                    parts.push(Part { of_surface: left, of_test: [moved_u - k, moved_v - l], coefficient });
                }
            }
        }
    }
    Ok(parts)
}

/// How many derivatives in u and v go over to the test function: as many as leave two on S.
fn moved(derivative: Derivative) -> [usize; 2] {
    let mut moved = [0, 0];
    let mut left = [derivative.u, derivative.v];
    while left.iter().sum::<usize>() > 2 {
        // From the coordinate with more: u²v² becomes uv against uv, and no more than two are taken from either.
        let axis = usize::from(left[1] > left[0]);
        for (index, (moved, left)) in moved.iter_mut().zip(&mut left).enumerate() {
            if index == axis {
                *moved += 1;
                *left = left.saturating_sub(1);
            }
        }
    }
    moved
}

/// Binomial coefficients with n up to 2.
fn choose(n: usize, k: usize) -> i64 {
    if n == 2 && k == 1 { 2 } else { 1 }
}

/// Functions of one coordinate at the nodes of a quadrature rule: a matrix for each order, row per node.
#[derive(Debug, Clone)]
pub struct Table {
    /// By order, from 0 to 2.
    pub values: Vec<DMatrix<f64>>,
    pub weights: Vec<f64>,
}

impl Table {
    fn order(&self, order: usize) -> Option<&DMatrix<f64>> {
        self.values.get(order)
    }
}

/// Adds `∫ c ∂(f_m f_n) ∂(f_k f_l)` to the matrix with rows (k, l) and columns (m, n); `coefficient` is c at a node.
pub fn add_matrix(
    total: &mut DMatrix<f64>,
    part: &Part,
    [in_u, in_v]: [&Table; 2],
    coefficient: impl Fn(usize) -> f64,
) {
    let orders = [part.of_surface.u, part.of_surface.v, part.of_test[0], part.of_test[1]];
    let tables = [in_u.order(orders[0]), in_v.order(orders[1]), in_u.order(orders[2]), in_v.order(orders[3])];
    let [Some(trial_u), Some(trial_v), Some(test_u), Some(test_v)] = tables else { return };
    for (i, weight) in in_u.weights.iter().enumerate() {
        let mut weighted = trial_v.clone();
        for (j, (mut row, in_v)) in weighted.row_iter_mut().zip(&in_v.weights).enumerate() {
            row *= weight * coefficient(i * trial_v.nrows() + j) * in_v;
        }
        let along = test_v.transpose() * weighted;
        let across = test_u.row(i).transpose() * trial_u.row(i);
        *total += across.kronecker(&along);
    }
}

/// Adds `∫ c g ∂(f_k f_l)` to the vector over (k, l), l running faster; `product` is c g at a node, u-major.
pub fn add_vector(
    total: &mut DMatrix<f64>,
    of_test: [usize; 2],
    [in_u, in_v]: [&Table; 2],
    product: impl Fn(usize) -> f64,
) {
    let [Some(test_u), Some(test_v)] = [in_u.order(of_test[0]), in_v.order(of_test[1])] else { return };
    let (rows, columns) = (in_u.weights.len(), in_v.weights.len());
    let column = |(j, in_v): (usize, &f64)| {
        let in_v = *in_v;
        let product = &product;
        in_u.weights.iter().enumerate().map(move |(i, in_u)| product(i * columns + j) * in_u * in_v)
    };
    let weighted = DMatrix::from_iterator(rows, columns, in_v.weights.iter().enumerate().flat_map(column));
    // Transposed, so that l runs faster in memory.
    let sums = (test_u.transpose() * weighted * test_v).transpose();
    for (total, value) in total.iter_mut().zip(sums.iter()) {
        *total += value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_derivatives_at_most_stay_on_the_surface_and_two_go_over() {
        for u in 0..=4 {
            for v in 0..=4 - u {
                let [moved_u, moved_v] = moved(Derivative::new(u, v, 0));
                assert!(moved_u <= 2 && moved_v <= 2 && moved_u <= u && moved_v <= v, "{u} {v}");
                assert!(u + v - moved_u - moved_v <= 2, "{u} {v}");
            }
        }
        assert_eq!(moved(Derivative::new(2, 2, 0)), [1, 1]);
    }
}
