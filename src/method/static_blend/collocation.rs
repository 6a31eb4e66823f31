//! The equations at the collocation points: `L[sin²(πx) T_m T_n] a_mn = q - L[blend]`, row after row (docs/methods.md,
//! B4 and B5).

use nalgebra::DMatrix;

use super::modes::{BlendModes, CARDINAL};
use crate::trial::Modes;

/// Everything the equations are made of, as numbers at the points.
pub struct Collocation {
    /// Orders of the terms in u and v.
    pub orders: Vec<[usize; 2]>,
    /// For each order in u up to 4, a row per node: the cardinal functions, then the hidden ones.
    along_u: Vec<DMatrix<f64>>,
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

impl Collocation {
    /// Nothing but the functions of u at the nodes.
    pub fn new(modes: &BlendModes, u: &[f64], highest_order: usize) -> Collocation {
        let table = |order: usize| {
            let rows: Vec<f64> = u.iter().flat_map(|u| modes.derivatives(order, *u)).collect();
            DMatrix::from_row_slice(u.len(), modes.count(), &rows)
        };
        Collocation {
            orders: Vec::new(),
            along_u: (0..=highest_order).map(table).collect(),
            along_v: Vec::new(),
            coefficients: Vec::new(),
            force: Vec::new(),
            stated: Vec::new(),
            data: 0,
        }
    }

    /// The matrix of one component: rows are points, u-major; columns are (m, n), n running faster.
    pub fn matrix(&self, component: usize) -> DMatrix<f64> {
        let (nodes_v, functions) = self.along_v.iter().flatten().next().map_or((0, 0), |v| (v.ncols(), v.nrows()));
        let (nodes_u, modes) = self.along_u.first().map_or((0, 0), DMatrix::shape);
        let powers = functions - self.data;
        let mut matrix = DMatrix::zeros(nodes_u * nodes_v, (modes - CARDINAL) * powers);
        for ((&[order, _], in_v), coefficients) in self.orders.iter().zip(&self.along_v).zip(&self.coefficients) {
            let (Some(in_u), Some(in_v)) = (self.along_u.get(order), in_v.first()) else { continue };
            let Some(coefficient) = coefficients.get(component) else { continue };
            for (row, coefficient) in coefficient.iter().enumerate() {
                let (k, l) = (row / nodes_v, row % nodes_v);
                for column in 0..matrix.ncols() {
                    let (m, n) = (column / powers, column % powers);
                    matrix[(row, column)] += coefficient * in_u[(k, CARDINAL + m)] * in_v[(self.data + n, l)];
                }
            }
        }
        matrix
    }

    /// The right-hand sides of one component, a column per order in t.
    pub fn right(&self, component: usize) -> DMatrix<f64> {
        let nodes_v = self.along_v.iter().flatten().next().map_or(0, DMatrix::ncols);
        let rows = self.along_u.first().map_or(0, DMatrix::nrows) * nodes_v;
        let stated = DMatrix::from_fn(CARDINAL, self.data, |condition, j| {
            self.stated.get((condition * self.data + j) * 3 + component).copied().unwrap_or(f64::NAN)
        });
        let mut right = DMatrix::from_fn(rows, self.force.len(), |row, order| {
            let force = self.force.get(order).and_then(|force| force.get(component));
            force.and_then(|force| force.get(row)).copied().unwrap_or(f64::NAN)
        });
        for ((&[order, _], in_v), coefficients) in self.orders.iter().zip(&self.along_v).zip(&self.coefficients) {
            let (Some(in_u), Some(coefficient)) = (self.along_u.get(order), coefficients.get(component)) else {
                continue;
            };
            for (in_time, in_v) in in_v.iter().enumerate() {
                // B_i^(p)(u_k) c_ij F_j^(q)(v_l), summed over i and j.
                let blend = in_u.columns(0, CARDINAL) * &stated * in_v.rows(0, self.data);
                for (row, coefficient) in coefficient.iter().enumerate() {
                    right[(row, in_time)] -= coefficient * blend[(row / nodes_v, row % nodes_v)];
                }
            }
        }
        right
    }
}
