//! Surfaces whose edges at both ends of a parameter are one curve but for the digits of a file.
//!
//! Input: a surface and the distance below which two points are one; output: the surface, periodic to rounding where its
//! edges are one, and by how much its control points moved. Whether derivatives across agree is judged by the same
//! distance: by how little control points move until they do, which does not depend on the lengths of spans.

use nalgebra::DMatrix;

use super::{BsplineSurface, add_scaled};
use crate::numeric::LinearSystem;

/// Of the largest coordinate: what rounding leaves of one curve, some forty times the spacing of doubles.
const ROUNDING: f64 = 1e-14;

/// Of the largest derivative of its order: what differs by more is a corner, however short the spans beside it are.
const CORNER: f64 = 1e-3;

/// What became of the edges at both ends of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Closing {
    /// The surface: itself, or clamped and with control points that moved.
    pub surface: BsplineSurface,
    /// The highest derivative across that agrees at both ends; `None` if the edges are two curves.
    pub seam: Option<usize>,
    /// The largest distance of control points of one edge from those of the other, as they were.
    pub gap: f64,
    /// How far the farthest control point moved.
    pub moved: f64,
}

impl BsplineSurface {
    /// The surface with its edges at both ends of u made one, and with as many derivatives across as can be had while no
    /// control point moves by more than half of `tolerance`: edges that are nearer than `tolerance` meet halfway.
    #[must_use]
    pub fn closed_in_u(&self, tolerance: f64) -> Closing {
        let clamped = self.clamped_in_u();
        let gap = largest(&clamped.difference(0));
        let mut closing = Closing { surface: self.clone(), seam: None, gap, moved: 0.0 };
        for order in 0..self.u.degree() {
            let Some(corrections) = clamped.corrections(order) else { break };
            let moved = largest(&corrections);
            let is_rounding = moved <= ROUNDING * self.size();
            let is_allowed = moved.is_finite() && moved <= 0.5 * tolerance;
            if !(is_rounding || is_allowed && !clamped.has_corner(order)) {
                break;
            }
            closing.seam = Some(order);
            if !is_rounding {
                (closing.surface, closing.moved) = (clamped.moved(&corrections), moved);
            }
        }
        closing
    }

    /// How far a line of constant v goes at most from where it begins: what the gap between the ends of u compares with.
    #[must_use]
    pub fn breadth_in_u(&self) -> f64 {
        let first = self.rows().next().unwrap_or_default();
        let from_first = self.rows().flat_map(|row| row.iter().zip(first));
        largest(&from_first.map(|(p, q)| less(p, q)).collect::<Vec<_>>())
    }

    /// The derivative across of order `order` at the end of u, less that at its start, along the edges.
    fn difference(&self, order: usize) -> Vec<[f64; 3]> {
        let [start, end] = self.u.domain().map(|u| self.row_at(order, u));
        end.iter().zip(&start).map(|(end, start)| less(end, start)).collect()
    }

    /// Whether derivatives of order `order` differ by more than a share of their size; positions have none.
    fn has_corner(&self, order: usize) -> bool {
        let sizes = self.u.domain().map(|u| largest(&self.row_at(order, u)));
        order > 0 && largest(&self.difference(order)) > CORNER * sizes.into_iter().fold(0.0, f64::max)
    }

    /// The least, by squares, that is to be added to the control points so that derivatives across up to `order` agree.
    ///
    /// With the rows `a_ki = N_i^(k)(end) - N_i^(k)(start)`, k up to `order`, and the differences D of derivatives, `-Aᵀ (A
    /// Aᵀ)⁻¹ D`. Some closed surface is as near as the digits of a file, so this one is no farther than a few of them.
    fn corrections(&self, order: usize) -> Option<Vec<[f64; 3]>> {
        let [start, end] = self.u.domain();
        let (points, columns) = (self.u.points(), self.v.points());
        let rows = DMatrix::from_fn(order + 1, points, |order, point| {
            self.u.basis_function(point, order, end) - self.u.basis_function(point, order, start)
        });
        let differences: Vec<_> = (0..=order).map(|order| self.difference(order)).collect();
        let differences = DMatrix::from_fn(order + 1, 3 * columns, |order, at| {
            let point = differences.get(order).and_then(|row| row.get(at / 3));
            point.and_then(|point| point.get(at % 3)).copied().unwrap_or(f64::NAN)
        });
        // Derivatives grow with their order: rows of one size keep the system well conditioned.
        let sizes: Vec<f64> = rows.row_iter().map(|row| row.amax()).collect();
        let scaled = |matrix: DMatrix<f64>| {
            let size = |order: usize| sizes.get(order).copied().unwrap_or(f64::NAN);
            DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |order, at| {
                matrix.get((order, at)).map_or(f64::NAN, |x| x / size(order))
            })
        };
        let (rows, differences) = (scaled(rows), scaled(differences));
        let multipliers = LinearSystem::new(&rows * rows.transpose())?.solve(&differences);
        let corrections = rows.tr_mul(&multipliers);
        let row = |line| {
            let values: Vec<f64> = corrections.row(line).iter().map(|x| -x).collect();
            values.as_chunks().0.to_vec()
        };
        Some((0..points).flat_map(row).collect())
    }

    /// The surface with `corrections` added; its last row is the first, bit for bit.
    fn moved(&self, corrections: &[[f64; 3]]) -> BsplineSurface {
        let mut net = self.net.clone();
        net.iter_mut().zip(corrections).for_each(|(point, correction)| add_scaled(point, 1.0, correction));
        let columns = self.v.points();
        let first = net.get(..columns).unwrap_or_default().to_vec();
        net.truncate(net.len() - columns);
        net.extend(first);
        BsplineSurface { u: self.u.clone(), v: self.v.clone(), net }
    }
}

fn less([x, y, z]: &[f64; 3], [a, b, c]: &[f64; 3]) -> [f64; 3] {
    [x - a, y - b, z - c]
}

/// The length of the longest vector; infinite if one is no number.
fn largest(vectors: &[[f64; 3]]) -> f64 {
    // Squares would lose surfaces that are very large or very small.
    let lengths = vectors.iter().map(|[x, y, z]| libm::hypot(libm::hypot(*x, *y), *z));
    lengths.fold(0.0, |most, length| if length.is_nan() { f64::INFINITY } else { most.max(length) })
}
