//! What a static problem leaves open: solutions `G(u) e^(λv)` whose position and tangent vanish at both ends of u.
//!
//! Nothing is stated at the ends of v, so any of them may be added. Their exponents satisfy
//! `a G'''' + b λ² G'' + c λ⁴ G = 0` with G clamped at both ends (docs/methods.md, B6).

use nalgebra::{DMatrix, Schur};

use super::modes::{BlendModes, CARDINAL};
use crate::numeric::{LeastSquares, NodeKind, nodes};
use crate::trial::Modes;

/// Enough for the smallest exponents to six digits.
const HIGHEST: usize = 14;
const ITERATIONS: usize = 1000;

/// The smallest |λ| for the equation `a S_uuuu + b S_uuvv + c S_vvvv = 0` over a range of u of the given length.
///
/// `None` when there is no such exponent, or `a` is zero.
pub fn smallest_exponent([a, b, c]: [f64; 3], length: f64) -> Option<f64> {
    let modes = BlendModes::new(HIGHEST, [0.0, 1.0]);
    let size = HIGHEST + 1;
    let u = nodes(NodeKind::Chebyshev, size, [0.0, 1.0]);
    let table = |order: usize| {
        let rows: Vec<f64> = u.iter().flat_map(|u| modes.derivatives(order, *u).split_off(CARDINAL)).collect();
        DMatrix::from_row_slice(size, size, &rows)
    };
    let bending = LeastSquares::new(&table(4)).ok()?;
    // With μ = 1/λ²: μ² G = -(b/a) μ K₂ G - (c/a) K₀ G, where K_i = D₄⁻¹ D_i. Linear in (μG, G).
    let mut companion = DMatrix::zeros(2 * size, 2 * size);
    companion.view_mut((0, 0), (size, size)).copy_from(&(bending.solve(&table(2)) * (-b / a)));
    companion.view_mut((0, size), (size, size)).copy_from(&(bending.solve(&table(0)) * (-c / a)));
    companion.view_mut((size, 0), (size, size)).fill_with_identity();
    if companion.iter().any(|value| !value.is_finite()) {
        return None;
    }
    let values = Schur::try_new(companion, f64::EPSILON, ITERATIONS)?.complex_eigenvalues();
    let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.re.hypot(value.im)));
    (largest > 0.0).then(|| 1.0 / (largest.sqrt() * length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smallest_exponents_are_those_of_the_clamped_strip() {
        // Computed apart from this program, to three digits; (1, 2, 1) is the first root of sin z = -z, 4.2124 + 2.2507i.
        for (b, expected) in [(1.0, 4.74), (2.0, 4.776), (3.0, 4.91), (4.0, 3.61), (10.0, 2.02)] {
            let found = smallest_exponent([1.0, b, 1.0], 1.0).expect("there are exponents");
            assert!((found - expected).abs() < 0.006, "{b}: {found}");
        }
    }

    #[test]
    fn a_wider_strip_has_smaller_exponents() {
        let narrow = smallest_exponent([1.0, 2.0, 1.0], 1.0).expect("there are exponents");
        let wide = smallest_exponent([1.0, 2.0, 1.0], 2.5).expect("there are exponents");
        assert!((wide * 2.5 - narrow).abs() < 1e-12, "{narrow} {wide}");
    }

    #[test]
    fn an_equation_without_derivatives_in_v_leaves_nothing_open() {
        assert_eq!(smallest_exponent([1.0, 0.0, 0.0], 1.0), None);
    }
}
