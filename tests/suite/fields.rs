//! The numbers at the vertices of a mesh, against closed forms.

use trimline::blend::Blend;
use trimline::diagnostic::{Diagnostic, Source};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::surface::Surface;
use trimline::tessellate::{Field, Grid, curvatures, tessellate};
use trimline::verify::residuals;

fn blend(text: &str) -> Blend {
    Blend::compile(&Source::new("spec", text), &Options::default()).expect("a sound spec")
}

/// Curvatures of the only patch on 3 x 8 quads.
fn curvatures_of(text: &str) -> [Field; 2] {
    let surface = blend(text).solve(0, 0.0).expect("a solution").surface;
    let grid = Grid::new(3, 8, &Limits::default()).expect("a small grid");
    let ranges = ([0.0, 1.0], [0.0, std::f64::consts::TAU]);
    let (mesh, _) = tessellate("patch", &*surface, ranges, 0.0, grid).expect("a mesh");
    curvatures(&*surface, &mesh, 0.0).expect("two derivatives")
}

#[test]
fn cylinder_of_radius_2_has_half_the_inverse_radius_as_mean_curvature() {
    // S_u x S_v of a surface that rises with u and turns with v points inwards, where the cylinder bends to.
    let [gaussian, mean] = curvatures_of(
        "pde ∂⁴S/∂u⁴ = 0
         at u = 0: S = [2 cos v, 2 sin v, 0], ∂S/∂u = [0, 0, 3]
         at u = 1: S = [2 cos v, 2 sin v, 3], ∂S/∂u = [0, 0, 3]",
    );
    assert_eq!((gaussian.name, mean.name), ("gaussian_curvature", "mean_curvature"));
    assert_eq!((gaussian.values.len(), mean.values.len()), (32, 32));
    // The second derivative in u of a linear function is a sum of some terms that cancel to rounding.
    assert!(gaussian.values.iter().all(|value| value.abs() < 1e-12), "{gaussian:?}");
    assert!(mean.values.iter().all(|value| (value - 0.25).abs() < 1e-12), "{mean:?}");
}

#[test]
fn cone_has_no_curvature_at_its_tip() {
    let [gaussian, mean] = curvatures_of(
        "pde ∂⁴S/∂u⁴ = 0
         at u = 0: S = 0, ∂S/∂u = [cos v, sin v, 1]
         at u = 1: S = [cos v, sin v, 1], ∂S/∂u = [cos v, sin v, 1]",
    );
    for field in [gaussian, mean] {
        let (tip, others) = field.values.split_at(8);
        assert!(tip.iter().all(|value| value.is_nan()) && others.iter().all(|value| value.is_finite()), "{field:?}");
    }
}

/// u⁵ in x, which solves no equation of fourth order.
struct FifthPower;

impl Surface for FifthPower {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        assert_eq!((derivative.v, derivative.t), (0, 0));
        for ([u, ..], value) in points.iter().zip(values) {
            let factor: f64 = (0..derivative.u).map(|order| (5 - order) as f64).product();
            *value = [factor * u.powi(5 - derivative.u as i32), 0.0, 0.0];
        }
        Ok(())
    }
}

#[test]
fn residual_is_that_of_the_equation_over_its_largest_term() {
    // ∂⁴/∂u⁴ of u⁵ is 120 u, 120 at most, so u remains.
    let blend = blend(
        "pde ∂⁴S/∂u⁴ = 0
         at u = 0: S = 0, ∂S/∂u = 0
         at u = 1: S = [cos v, 0, 0], ∂S/∂u = 0",
    );
    let (u, v) = ([0.0, 0.25, 0.5, 1.0], [0.0, 1.0]);
    let patch = blend.patches[0].patch();
    let found = residuals(&blend.problem, patch, &FifthPower, &blend.bindings, (&u, &v, 0.0)).expect("finite");
    assert_eq!(found, [0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 1.0, 1.0]);
}
