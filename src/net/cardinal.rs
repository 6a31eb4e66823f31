//! Sequences of B-spline coefficients of quadratics, cardinal at 0, 1 and n.

use crate::diagnostic::{Code, Diagnostic};
use crate::surface::KnotVector;

/// The sequences L_0, L_1, L_n: coefficients of three quadratic polynomials in cubic B-splines, with L_a(b) = 1 for
/// a = b and 0 otherwise, for a and b in 0, 1, n (docs/bspline.md, N3).
pub(super) struct Cardinal {
    /// `[L_0(i), L_1(i), L_n(i)]`
    values: Vec<[f64; 3]>,
}

impl Cardinal {
    /// # Errors
    /// [`Code::SettingOutOfRange`] for a degree other than 3, [`Code::KnotRepeated`] for a repeated inner knot of the
    /// direction `name`.
    pub fn new(knots: &KnotVector, name: &str) -> Result<Cardinal, Diagnostic> {
        if knots.degree() != 3 {
            let message =
                format!("the net has degree {} in {name}, and the equation fills bicubic nets", knots.degree());
            return Err(Diagnostic::new(Code::SettingOutOfRange, message).hint("use degree 3"));
        }
        let [start, end] = knots.domain();
        let repeated = |&(knot, count): &(f64, usize)| start < knot && knot < end && count > 1;
        if let Some((knot, count)) = knots.multiplicities().into_iter().find(repeated) {
            let message = format!("the knot {knot} of {name} stands {count} times inside the net");
            return Err(Diagnostic::new(Code::KnotRepeated, message).hint(
                "a repeated knot leaves the net one equation short; split the net there and fill both parts, or move the knots apart",
            ));
        }
        Ok(Cardinal { values: cardinal_values(knots) })
    }

    /// `[L_0(i), L_1(i), L_n(i)]` for every i.
    pub fn values(&self) -> impl Iterator<Item = [f64; 3]> {
        self.values.iter().copied()
    }

    /// `max_i Σ_a |L_a(i)|`
    pub fn amplification(&self) -> f64 {
        self.values.iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max)
    }
}

/// N3 of docs/bspline.md.
fn cardinal_values(knots: &KnotVector) -> Vec<[f64; 3]> {
    let line = scaled(knots);
    let [t1, t2, t3] = match line.as_slice() {
        [_, t1, t2, t3, ..] => [*t1, *t2, *t3],
        _ => return Vec::new(),
    };
    let h = t3 - t2;
    // The coefficients of x, but for a constant factor, and those of the quadratic that is zero at i = 0 and 1. Every
    // term is positive from i = 2 on, so that no digits cancel.
    let linear = |[a, b, c]: [f64; 3]| (a - t1) + (b - t2) + (c - t3);
    let quadratic = |triple: [f64; 3]| {
        let [x, y, z] = triple.map(|knot| knot - t3);
        h * h + h * (x + y + z) + x * y + x * z + y * z
    };
    let triples = line.windows(3).skip(1).take(knots.points()).map(|window| match window {
        [a, b, c] => [*a, *b, *c],
        _ => [f64::NAN; 3],
    });
    let pairs: Vec<(f64, f64)> = triples.map(|triple| (linear(triple), quadratic(triple))).collect();
    let [first, (linear_last, quadratic_last)] = match pairs.as_slice() {
        [_, first, .., last] => [*first, *last],
        _ => return Vec::new(),
    };
    let last_index = pairs.len() - 1;
    let row = |(index, (linear, quadratic)): (usize, &(f64, f64))| match index {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, 1.0, 0.0],
        _ if index == last_index => [0.0, 0.0, 1.0],
        _ => {
            let at_last = quadratic / quadratic_last;
            let at_first = linear / first.0 - linear_last / first.0 * at_last;
            [1.0 - at_first - at_last, at_first, at_last]
        }
    };
    pairs.iter().enumerate().map(row).collect()
}

/// The knots, times a power of two, which rounds nothing: squares of knots near 1e200 would overflow.
fn scaled(knots: &KnotVector) -> Vec<f64> {
    let [start, end] = knots.domain();
    let exponent = libm::frexp(end - start).1;
    knots.as_slice().iter().map(|knot| libm::ldexp(*knot, -exponent)).collect()
}
