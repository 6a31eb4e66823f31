//! The equations at the collocation points: `L[sin²(πx) T_m T_n] a_mn = q - L[blend]`, row after row (docs/methods.md,
//! B4 and B5).

use nalgebra::DMatrix;

use super::modes::{BlendModes, CARDINAL};
use crate::trial::Modes;

/// Everything the equations are made of, as numbers at the points.
pub struct Collocation {
    /// The order of each term in u.
    pub orders: Vec<usize>,
    /// For each order in u, a row per node: the cardinal functions, then the hidden ones.
    pub along_u: Vec<DMatrix<f64>>,
    /// Values in v by term and order in t: a row per function, the data's first, and a column per node.
    pub along_v: Vec<Vec<DMatrix<f64>>>,
    /// Coefficients by term and component, at every point.
    pub coefficients: Vec<[Vec<f64>; 3]>,
    /// The force by order in t and component, at every point.
    pub force: Vec<[Vec<f64>; 3]>,
    /// The stated data: by condition, then function, then component.
    pub stated: Vec<f64>,
    /// The number of functions that carry data.
    pub data: usize,
}

/// The modes at the nodes `u`, for every order up to `highest`: a row per node.
pub fn along_u(modes: &BlendModes, u: &[f64], highest: usize) -> Vec<DMatrix<f64>> {
    let table = |order: usize| {
        let rows: Vec<f64> = u.iter().flat_map(|u| modes.derivatives(order, *u)).collect();
        DMatrix::from_row_slice(u.len(), modes.count(), &rows)
    };
    (0..=highest).map(table).collect()
}

impl Collocation {
    /// The matrix of one component: rows are points, u-major; columns are (m, n), n running faster.
    pub fn matrix(&self, component: usize) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(0, 0);
        for (term, (&order, coefficients)) in self.along_v.iter().zip(self.orders.iter().zip(&self.coefficients)) {
            let (Some(in_u), Some(in_v)) = (self.along_u.get(order), term.first()) else { continue };
            let Some(coefficient) = coefficients.get(component) else { continue };
            let (hidden, powers) = (in_u.ncols() - CARDINAL, in_v.nrows() - self.data);
            let mut part = in_u.columns(CARDINAL, hidden).kronecker(&in_v.rows(self.data, powers).transpose());
            for (mut row, factor) in part.row_iter_mut().zip(coefficient) {
                row *= *factor;
            }
            matrix = if matrix.is_empty() { part } else { matrix + part };
        }
        matrix
    }

    /// The right-hand sides of one component, a column per order in t.
    pub fn right(&self, component: usize) -> DMatrix<f64> {
        let stated = DMatrix::from_fn(CARDINAL, self.data, |condition, j| {
            self.stated.get((condition * self.data + j) * 3 + component).copied().unwrap_or(f64::NAN)
        });
        let force = self.force.iter().filter_map(|vectors| vectors.get(component));
        let rows = force.clone().next().map_or(0, Vec::len);
        let mut right = DMatrix::from_iterator(rows, self.force.len(), force.flatten().copied());
        for (term, (&order, coefficients)) in self.along_v.iter().zip(self.orders.iter().zip(&self.coefficients)) {
            let (Some(in_u), Some(coefficient)) = (self.along_u.get(order), coefficients.get(component)) else {
                continue;
            };
            for (in_v, mut column) in term.iter().zip(right.column_iter_mut()) {
                // B_i^(p)(u_k) c_ij F_j^(q)(v_l), summed over i and j; transposed, so that l runs faster.
                let blend = (in_u.columns(0, CARDINAL) * &stated * in_v.rows(0, self.data)).transpose();
                for ((value, factor), blend) in column.iter_mut().zip(coefficient).zip(blend.iter()) {
                    *value -= factor * blend;
                }
            }
        }
        right
    }
}
