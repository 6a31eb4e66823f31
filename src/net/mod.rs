//! Bicubic B-spline nets filled from their boundary layers, so that the surface satisfies `∂⁶S/∂u³∂v³ = 0`.
//!
//! Input: two cubic knot vectors and the outer control points: layers 0, 1 and n of each direction. Output: the whole
//! net, in closed form (docs/bspline.md, N4): a discrete Boolean sum of quadratic interpolation in both directions.
//! It exists and is unique for every knot vector without repeated inner knots.
//!
//! [`NetSolver`] evaluates the layers of a document's net and fills it. [`quarter`] and [`ring`] join several such patches smoothly inside four boundary curves, and around a closed strip.
//!
//! Absent on purpose: a linear system. Its residual is rounding for any answer and says nothing about the error.

mod cardinal;
mod quarter;
mod ring;
mod solver;

pub use quarter::{Handle, Outline, quarter};
pub use ring::{Ring, Strip, ring};
pub use solver::{METHOD, NetSolver, SolvedNet};

use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::surface::bspline::{check_size, point_not_finite};
use crate::surface::{BsplineSurface, KnotVector};

use cardinal::Cardinal;

/// A filled net.
#[derive(Debug, Clone)]
pub struct Filled {
    /// The surface.
    pub surface: BsplineSurface,
    /// The largest Σ_a |L_a(i)| in u and in v: what a change of a boundary layer may grow to inside, at most, in each
    /// direction; a change at a corner, where layers of both directions meet, up to the product.
    pub amplification: [f64; 2],
    /// [`Code::NetAmplifies`], if it is large.
    pub warnings: Diagnostics,
}

/// Above this, a digit and a half of the layers' accuracy is lost inside, and small steps of a layer show as bulges.
const LARGE_AMPLIFICATION: f64 = 50.0;

/// Fills the net over `u` and `v`, P_ij at `i * v.points() + j`, from its layers i or j in 0, 1, n; what `net` holds at
/// the other places is not read.
///
/// # Errors
/// [`Code::SettingOutOfRange`] for a degree other than 3, [`Code::KnotRepeated`] for a repeated inner knot,
/// [`Code::NetSize`], [`Code::PointNotFinite`] for a point of a layer, [`Code::SolutionNotFinite`] when values overflow.
///
/// Implements N4 of docs/bspline.md. Cost: linear in the number of points.
pub fn fill(u: &KnotVector, v: &KnotVector, net: &[[f64; 3]]) -> Result<Filled, Diagnostic> {
    check_size([u, v], net.len())?;
    let (in_u, in_v) = (Cardinal::new(u, "u")?, Cardinal::new(v, "v")?);
    let columns = v.points();
    let is_layer = |index: usize, count: usize| index < 2 || index + 1 == count;
    let row_is_layer = |at: usize| is_layer(at / columns, u.points());
    let is_known = |at: usize| row_is_layer(at) || is_layer(at % columns, columns);
    let unusable = |(at, point): &(usize, &[f64; 3])| is_known(*at) && !point.iter().all(|x| x.is_finite());
    if let Some((at, point)) = net.iter().enumerate().find(unusable) {
        return Err(point_not_finite(&format!("P({}, {})", at / columns, at % columns), Some(point)));
    }
    let rows: Vec<&[[f64; 3]]> = net.chunks(columns).collect();
    let layers = layers_of(&rows);
    let mut filled = Vec::with_capacity(net.len());
    for ((index, row), shares) in rows.iter().enumerate().zip(in_u.values()) {
        if is_layer(index, rows.len()) {
            filled.extend_from_slice(row);
            continue;
        }
        // Q_u P, then Q_v of what it misses in the outer columns: together P = Q_u P + Q_v (P - Q_u P).
        let across: Vec<[f64; 3]> = (0..columns).map(|j| combine(shares, layers.map(|layer| at(layer, j)))).collect();
        let outer = layers_of(row);
        let missed: Vec<[f64; 3]> =
            outer.iter().zip(layers_of(&across)).map(|(given, across)| difference(given, across)).collect();
        let missed = [0, 1, 2].map(|layer| at(&missed, layer));
        for (j, (across, shares)) in across.iter().zip(in_v.values()).enumerate() {
            let inside = sum(across, &combine(shares, missed));
            filled.push(if is_layer(j, columns) { at(row, j) } else { inside });
        }
    }
    let surface = BsplineSurface::new(u.clone(), v.clone(), filled).map_err(|_| {
        Diagnostic::new(Code::SolutionNotFinite, "the net is not finite inside: its values overflow")
            .hint("use coordinates of moderate size")
    })?;
    let amplification = [in_u.amplification(), in_v.amplification()];
    Ok(Filled { surface, amplification, warnings: warnings(amplification) })
}

fn warnings(amplification: [f64; 2]) -> Diagnostics {
    let [in_u, in_v] = amplification;
    if in_u.max(in_v) <= LARGE_AMPLIFICATION {
        return Vec::new();
    }
    let message =
        format!("the net magnifies changes of its boundary layers by up to {in_u:.0} in u and {in_v:.0} in v");
    vec![Diagnostic::new(Code::NetAmplifies, message).hint(
        "the second layer sets a derivative; use fewer points, or place it by the derivative that is meant, P_1 = P_0 + S_u (t_4 - t_1)/3",
    )]
}

/// Elements 0, 1 and the last of at least four.
fn layers_of<T>(all: &[T]) -> [&T; 3] {
    match all {
        [first, second, .., last] => [first, second, last],
        _ => unreachable!("a cubic knot vector has four points or more"),
    }
}

fn at(points: &[[f64; 3]], index: usize) -> [f64; 3] {
    points.get(index).copied().unwrap_or([f64::NAN; 3])
}

/// `Σ_a shares_a points_a`
fn combine([a, b, c]: [f64; 3], [[px, py, pz], [qx, qy, qz], [rx, ry, rz]]: [[f64; 3]; 3]) -> [f64; 3] {
    [(px, qx, rx), (py, qy, ry), (pz, qz, rz)].map(|(p, q, r)| a * p + b * q + c * r)
}

fn sum([px, py, pz]: &[f64; 3], [qx, qy, qz]: &[f64; 3]) -> [f64; 3] {
    [px + qx, py + qy, pz + qz]
}

fn difference([px, py, pz]: &[f64; 3], [qx, qy, qz]: &[f64; 3]) -> [f64; 3] {
    [px - qx, py - qy, pz - qz]
}
