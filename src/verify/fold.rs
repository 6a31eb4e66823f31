//! Finds where a surface folds over itself.

use super::contact::{Vector, dot, normals};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::numeric::{NodeKind, nodes};
use crate::problem::DomainValues;
use crate::surface::Surface;

/// Places in u and in v.
const PLACES: usize = 25;

/// So many places on, a surface that only bends has turned little: an eighth of its range lies between.
const STEPS: usize = 3;

/// The cosine of 135 degrees.
const TURNED_BACK: f64 = -std::f64::consts::FRAC_1_SQRT_2;

/// The first place, u and v, at which `surface` folds back over itself at instant `t`: its normal turns by more than 135
/// degrees within an eighth of a range. In a plane that is where `S_u x S_v` changes its sign. 25 x 25 places are looked at.
///
/// # Errors
/// What the surface says when it cannot be evaluated.
pub fn find_fold(surface: &dyn Surface, domain: &DomainValues, t: f64) -> Result<Option<[f64; 2]>, Diagnostic> {
    let [u, v] = [domain.u, domain.v].map(|range| nodes(NodeKind::Ends, PLACES, range));
    let values = |derivative: Derivative| {
        let mut values = vec![[0.0; 3]; PLACES * PLACES];
        surface.evaluate_grid(derivative, (&u, &v, t), &mut values).map(|()| values)
    };
    let tangents = values(Derivative::new(1, 0, 0))?.into_iter().zip(values(Derivative::new(0, 1, 0))?);
    let normals = normals(&values(Derivative::NONE)?, tangents);
    let normal = |i: usize, j: usize| normals.get(i * PLACES + j).copied().flatten();
    let is_turned = |here: Option<Vector>, there: Option<Vector>| {
        here.zip(there).is_some_and(|(here, there)| dot(here, there) < TURNED_BACK)
    };
    let between = |nodes: &[f64], i: usize, step: usize| {
        nodes.get(i).zip(nodes.get(i + step)).map(|(a, b)| 0.5 * (a + b)).unwrap_or(f64::NAN)
    };
    for i in 0..PLACES {
        for j in 0..PLACES {
            for step in 1..=STEPS {
                if i + step < PLACES && is_turned(normal(i, j), normal(i + step, j)) {
                    return Ok(Some([between(&u, i, step), between(&v, j, 0)]));
                }
                if j + step < PLACES && is_turned(normal(i, j), normal(i, j + step)) {
                    return Ok(Some([between(&u, i, 0), between(&v, j, step)]));
                }
            }
        }
    }
    Ok(None)
}
