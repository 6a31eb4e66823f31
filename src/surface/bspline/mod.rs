//! B-spline curves and surfaces: knot vectors, evaluation, knot insertion, and their text form.
//!
//! A surface is `S(u, v) = Σ_ij N_i(u) M_j(v) P_ij` over two knot vectors; it does not depend on t. Weights are absent:
//! nothing here is rational.
//!
//! Own code and not a library of NURBS: a text decides the knots here, so each refusal is a finding with a code; and what
//! is needed is this folder (docs/bspline.md, Decisions).

mod closing;
mod curve;
mod insertion;
mod json;
mod knots;
mod moving;
mod splines;
mod step;

pub use closing::Closing;
pub use curve::BsplineCurve;
pub use json::{from_json, to_json};
pub use knots::{KnotVector, LARGEST_DEGREE};
pub use moving::MovingBspline;
pub use step::{from_step, uncertainty};

use super::Surface;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;
use insertion::restrict;

/// A B-spline surface.
#[derive(Debug, Clone, PartialEq)]
pub struct BsplineSurface {
    u: KnotVector,
    v: KnotVector,
    /// P_ij at `i * v.points() + j`; finite.
    net: Vec<[f64; 3]>,
}

impl BsplineSurface {
    /// The surface over `u` and `v` with the control points `net`, those of equal i together:
    /// P_ij at `i * v.points() + j`.
    ///
    /// # Errors
    /// [`Code::NetSize`] unless there are `u.points() * v.points()`; [`Code::PointNotFinite`].
    pub fn new(u: KnotVector, v: KnotVector, net: Vec<[f64; 3]>) -> Result<BsplineSurface, Diagnostic> {
        check_size([&u, &v], net.len())?;
        let columns = v.points();
        match net.iter().position(|point| !is_finite(point)) {
            Some(at) => Err(point_not_finite(&format!("P({}, {})", at / columns, at % columns), net.get(at))),
            None => Ok(BsplineSurface { u, v, net }),
        }
    }

    /// The knots of u and of v.
    #[must_use]
    pub fn knots(&self) -> [&KnotVector; 2] {
        [&self.u, &self.v]
    }

    /// The control points, P_ij at `i * knots()[1].points() + j`.
    #[must_use]
    pub fn net(&self) -> &[[f64; 3]] {
        &self.net
    }

    /// The control points, row after row of equal i.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = &[[f64; 3]]> {
        self.net.chunks(self.v.points())
    }

    /// Ranges of u and v.
    #[must_use]
    pub fn domain(&self) -> [[f64; 2]; 2] {
        [self.u.domain(), self.v.domain()]
    }

    /// The largest coordinate of a control point.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.net.iter().flatten().fold(0.0, |most, x| most.max(x.abs()))
    }

    /// The same surface with its last column of control points equal to the first, bit for bit.
    ///
    /// For a clamped surface that closes in v but for rounding.
    #[must_use]
    pub fn closed_in_v(&self) -> BsplineSurface {
        let close = |row: &[[f64; 3]]| row.iter().take(row.len() - 1).chain(row.first()).copied().collect::<Vec<_>>();
        BsplineSurface { u: self.u.clone(), v: self.v.clone(), net: self.rows().flat_map(close).collect() }
    }

    /// The same surface with u and v exchanged: `(u, v)` of one is `(v, u)` of the other.
    #[must_use]
    pub fn transposed(&self) -> BsplineSurface {
        let columns = self.v.points();
        let net = (0..columns).flat_map(|j| self.net.iter().skip(j).step_by(columns)).copied().collect();
        BsplineSurface { u: self.v.clone(), v: self.u.clone(), net }
    }

    /// The same surface with u running backwards: u of one is -u of the other.
    #[must_use]
    pub fn reversed_u(&self) -> BsplineSurface {
        let net = self.rows().rev().flatten().copied().collect();
        BsplineSurface { u: self.u.reversed(), v: self.v.clone(), net }
    }

    /// The same surface with v running backwards: v of one is -v of the other.
    #[must_use]
    pub fn reversed_v(&self) -> BsplineSurface {
        let net = self.rows().flat_map(|row| row.iter().rev()).copied().collect();
        BsplineSurface { u: self.u.clone(), v: self.v.reversed(), net }
    }

    /// The same surface over clamped knots, so that the outer control points are its edges.
    #[must_use]
    pub fn clamped(&self) -> BsplineSurface {
        if self.u.is_clamped() && self.v.is_clamped() {
            return self.clone();
        }
        self.clamped_in_u().transposed().clamped_in_u().transposed()
    }

    fn clamped_in_u(&self) -> BsplineSurface {
        let (u, net) = restrict(&self.u, &self.net, self.v.points(), self.u.domain());
        BsplineSurface { u, v: self.v.clone(), net }
    }

    fn check_domain(&self, u: f64, v: f64) -> Result<(), Diagnostic> {
        for (name, x, [start, end]) in [("u", u, self.u.domain()), ("v", v, self.v.domain())] {
            if !(start..=end).contains(&x) {
                let message = format!("{name} = {x} lies outside the domain [{start}, {end}] of the B-spline");
                return Err(Diagnostic::new(Code::PointOutsideDomain, message).hint("choose a point inside"));
            }
        }
        Ok(())
    }

    /// `Σ_i N_i(u) P_ij` for every j.
    fn row_at(&self, order: usize, u: f64) -> Vec<[f64; 3]> {
        let (first, values) = self.u.basis(order, u);
        let mut row = vec![[0.0; 3]; self.v.points()];
        for (value, points) in values.iter().zip(self.rows().skip(first).take(self.u.degree() + 1)) {
            for (sum, point) in row.iter_mut().zip(points) {
                add_scaled(sum, *value, point);
            }
        }
        row
    }
}

impl Surface for BsplineSurface {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let degree = self.v.degree();
        for ([u, v, _], value) in points.iter().zip(values.iter_mut()) {
            self.check_domain(*u, *v)?;
            *value = [0.0; 3];
            if derivative.t > 0 {
                continue;
            }
            let (first_row, in_u) = self.u.basis(derivative.u, *u);
            let (first, in_v) = self.v.basis(derivative.v, *v);
            for (factor, row) in in_u.iter().zip(self.rows().skip(first_row).take(self.u.degree() + 1)) {
                for (share, point) in in_v.iter().zip(row.iter().skip(first).take(degree + 1)) {
                    add_scaled(value, factor * share, point);
                }
            }
        }
        finite(values)
    }

    fn breaks(&self, domain: [[f64; 2]; 2], _t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        let inside = |knots: &KnotVector, [low, high]: [f64; 2]| -> Vec<f64> {
            knots.breakpoints().into_iter().filter(|knot| low < *knot && *knot < high).collect()
        };
        let [range_u, range_v] = domain;
        Ok([inside(&self.u, range_u), inside(&self.v, range_v)])
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, _): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        values.fill([0.0; 3]);
        for (u, v) in u.iter().zip(v.first().into_iter().cycle()).chain(u.first().into_iter().cycle().zip(v)) {
            self.check_domain(*u, *v)?;
        }
        if derivative.t > 0 {
            return Ok(());
        }
        let columns: Vec<_> = v.iter().map(|v| self.v.basis(derivative.v, *v)).collect();
        for (u, values) in u.iter().zip(values.chunks_mut(v.len().max(1))) {
            let row = self.row_at(derivative.u, *u);
            for (value, (first, shares)) in values.iter_mut().zip(&columns) {
                for (share, point) in shares.iter().zip(row.iter().skip(*first).take(self.v.degree() + 1)) {
                    add_scaled(value, *share, point);
                }
            }
        }
        finite(values)
    }
}

/// That a net over `u` and `v` has its number of points.
///
/// # Errors
/// [`Code::NetSize`].
pub fn check_size([u, v]: [&KnotVector; 2], points: usize) -> Result<(), Diagnostic> {
    let (rows, columns) = (u.points(), v.points());
    if rows.checked_mul(columns) == Some(points) {
        return Ok(());
    }
    let message = format!("the knots belong to a net of {rows} x {columns} points, and {points} are given");
    Err(Diagnostic::new(Code::NetSize, message).hint("there are degree + 1 knots more than points, in each direction"))
}

/// The finding about a control point called `name`.
#[must_use]
pub fn point_not_finite(name: &str, point: Option<&[f64; 3]>) -> Diagnostic {
    let [x, y, z] = point.copied().unwrap_or([f64::NAN; 3]);
    Diagnostic::new(Code::PointNotFinite, format!("the control point {name} is [{x}, {y}, {z}]"))
        .hint("coordinates are finite numbers")
}

fn add_scaled(total: &mut [f64; 3], factor: f64, vector: &[f64; 3]) {
    for (sum, component) in total.iter_mut().zip(vector) {
        *sum += factor * component;
    }
}

fn is_finite(point: &[f64; 3]) -> bool {
    point.iter().all(|x| x.is_finite())
}

fn finite(values: &[[f64; 3]]) -> Result<(), Diagnostic> {
    if values.iter().all(is_finite) {
        return Ok(());
    }
    Err(Diagnostic::new(Code::SolutionNotFinite, "the B-spline is not finite: its values overflow")
        .hint("knots very close together make large derivatives"))
}
