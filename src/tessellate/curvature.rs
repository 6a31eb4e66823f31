//! Gaussian and mean curvature at the vertices of a mesh, from the surface's own derivatives.

use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::surface::Surface;

use super::mesh::{Field, MEAN_CURVATURE, Mesh};
use super::samples::EVALUATION_ERROR;

/// Gaussian curvature K and mean curvature H of `surface` at instant `t` at every vertex of its `mesh`.
///
/// With the first fundamental form E, F, G and the second L, M, N along the unit normal `S_u x S_v`,
/// `K = (L N - M²) / (E G - F²)` and `H = (E N - 2 F M + G L) / 2 (E G - F²)`. H is positive where the surface bends
/// towards its normal: a sphere of radius r with outward normals has H = -1/r. Where the tangents do not span a
/// plane both are NaN.
///
/// # Errors
/// What the surface reports, for example a second derivative that does not exist.
pub fn curvatures(surface: &dyn Surface, mesh: &Mesh, t: f64) -> Result<[Field; 2], Diagnostic> {
    let (u, v) = mesh.axes();
    let field = |order_u, order_v| {
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        surface.evaluate_grid(Derivative::new(order_u, order_v, 0), (&u, &v, t), &mut values)?;
        Ok(values)
    };
    // At a pole S_v is rounding, in proportion to S_v elsewhere, and has any direction.
    let rounding = [&mesh.tangents_u, &mesh.tangents_v]
        .map(|tangents| EVALUATION_ERROR * tangents.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs())));
    let (uu, uv, vv) = (field(2, 0)?, field(1, 1)?, field(0, 2)?);
    let mut gaussian = Vec::with_capacity(uu.len());
    let mut mean = Vec::with_capacity(uu.len());
    for (tangents, bends) in mesh.tangents_u.iter().zip(&mesh.tangents_v).zip(uu.iter().zip(&uv).zip(&vv)) {
        let ((bend_uu, bend_uv), bend_vv) = bends;
        let [k, h] = at_point([tangents.0, tangents.1], [bend_uu, bend_uv, bend_vv], rounding);
        gaussian.push(k);
        mean.push(h);
    }
    Ok([Field { name: "gaussian_curvature", values: gaussian }, Field { name: MEAN_CURVATURE, values: mean }])
}

/// K and H from S_u, S_v and the second derivatives; a tangent no longer than its `rounding` has no direction.
fn at_point(
    [tangent_u, tangent_v]: [&[f64; 3]; 2],
    bends: [&[f64; 3]; 3],
    [rounding_u, rounding_v]: [f64; 2],
) -> [f64; 2] {
    let (e, f, g) = (dot(tangent_u, tangent_u), dot(tangent_u, tangent_v), dot(tangent_v, tangent_v));
    if e <= rounding_u * rounding_u || g <= rounding_v * rounding_v {
        return [f64::NAN; 2];
    }
    let normal = cross(tangent_u, tangent_v);
    let area_squared = dot(&normal, &normal);
    // The sine of the angle between the tangents is rounding: there is no tangent plane.
    if area_squared <= EVALUATION_ERROR * EVALUATION_ERROR * e * g {
        return [f64::NAN; 2];
    }
    let area = area_squared.sqrt();
    let [l, m, n] = bends.map(|bend| dot(bend, &normal) / area);
    let (gaussian, mean) = ((l * n - m * m) / area_squared, (e * n - 2.0 * f * m + g * l) / (2.0 * area_squared));
    // Tangents of 1e200 have products out of range; a curvature that is not finite is none.
    if gaussian.is_finite() && mean.is_finite() { [gaussian, mean] } else { [f64::NAN; 2] }
}

fn dot([ax, ay, az]: &[f64; 3], [bx, by, bz]: &[f64; 3]) -> f64 {
    ax * bx + ay * by + az * bz
}

fn cross([ax, ay, az]: &[f64; 3], [bx, by, bz]: &[f64; 3]) -> [f64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// K and H from the derivatives of a sphere of radius r at latitude u, longitude v.
    fn sphere(r: f64, u: f64, v: f64) -> [f64; 2] {
        let (su, cu, sv, cv) = (u.sin(), u.cos(), v.sin(), v.cos());
        let scaled = |x: [f64; 3]| x.map(|x| r * x);
        // S = r (cos u cos v, cos u sin v, sin u), and S_u x S_v points inwards.
        let (s_u, s_v) = (scaled([-su * cv, -su * sv, cu]), scaled([-cu * sv, cu * cv, 0.0]));
        let uu = scaled([-cu * cv, -cu * sv, -su]);
        let (uv, vv) = (scaled([su * sv, -su * cv, 0.0]), scaled([-cu * cv, -cu * sv, 0.0]));
        at_point([&s_u, &s_v], [&uu, &uv, &vv], [EVALUATION_ERROR * r; 2])
    }

    #[test]
    fn sphere_with_inward_normals_has_the_curvatures_of_its_radius() {
        for (r, u, v) in [(2.0, 0.3, 1.1), (0.5, -1.2, 4.0), (1e6, 0.7, 0.0)] {
            let [gaussian, mean] = sphere(r, u, v);
            // A dozen roundings of numbers of size 1.
            assert!((gaussian * r * r - 1.0).abs() < 1e-14, "{gaussian}");
            assert!((mean * r - 1.0).abs() < 1e-14, "{mean}");
        }
    }

    #[test]
    fn pole_has_no_curvature() {
        assert!(sphere(1.0, std::f64::consts::FRAC_PI_2, 0.0).iter().all(|value| value.is_nan()));
    }
}
