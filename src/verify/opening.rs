//! Judges whether a surface whose trimlines close in v closes too.
//!
//! Constraints at fixed u say nothing of the sides between the trimlines: a force that is not periodic, or a method that
//! is not, tears a tube open along them.

use super::contact::length;
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::problem::DomainValues;
use crate::surface::Surface;

/// Places along the sides, both trimlines among them.
const PLACES: usize = 33;

/// Of the surface's size: ends of a trimline that are closer are one point. Data are periodic to rounding.
const CLOSED: f64 = 1e-9;

/// Of the surface's size: what a solution leaves open by rounding, or by what a truncated series leaves out.
const OPEN: f64 = 1e-6;

/// How far apart the sides v = const of `surface` are at instant `t` where everything that is prescribed at its trimlines
/// closes, derivatives in u of the given `orders`; `None` where it does not, or the sides are one.
///
/// # Errors
/// What the surface says when it cannot be evaluated.
pub fn find_opening(
    surface: &dyn Surface,
    domain: &DomainValues,
    orders: &[usize],
    t: f64,
) -> Result<Option<f64>, Diagnostic> {
    for order in orders {
        let (gaps, size) = gaps(surface, Derivative::new(*order, 0, 0), (&domain.u, &domain.v, t))?;
        if gaps.iter().any(|gap| *gap > CLOSED * size) {
            return Ok(None);
        }
    }
    let [low, high] = domain.u;
    let share = |index: usize| index as f64 / (PLACES - 1) as f64;
    let u: Vec<f64> = (0..PLACES).map(|index| low * (1.0 - share(index)) + high * share(index)).collect();
    let (gaps, size) = gaps(surface, Derivative::NONE, (&u, &domain.v, t))?;
    let widest = gaps.into_iter().fold(0.0, f64::max);
    Ok((widest > OPEN * size).then_some(widest))
}

/// How far a derivative is apart at both ends of v for each u, and its largest size there.
fn gaps(
    surface: &dyn Surface,
    derivative: Derivative,
    (u, v, t): (&[f64], &[f64; 2], f64),
) -> Result<(Vec<f64>, f64), Diagnostic> {
    let mut sides = vec![[0.0; 3]; 2 * u.len()];
    surface.evaluate_grid(derivative, (u, v, t), &mut sides)?;
    let size = sides.iter().copied().map(length).fold(0.0, f64::max);
    let gap = |[[ax, ay, az], [bx, by, bz]]: &[[f64; 3]; 2]| length([ax - bx, ay - by, az - bz]);
    Ok((sides.as_chunks().0.iter().map(gap).collect(), size))
}
