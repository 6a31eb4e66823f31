//! Faces that are curves or points: no face of a CAD model.

use super::Face;
use super::topology::{extent, tolerance};
use crate::diagnostic::Diagnostic;
use crate::export::ExportError;
use crate::expr::Derivative;
use crate::numeric::gauss_rule;
use crate::surface::{BsplineSurface, Surface};

/// Refuses clamped faces that are narrower throughout than places are told apart.
///
/// # Errors
/// [`ExportError::NoArea`] names the first that has no area of its own, [`ExportError::TooNarrow`] the first that has none
/// beside the others.
pub(super) fn check(faces: &[Face]) -> Result<(), ExportError> {
    let is_narrow = |face: &Face, tolerance: f64| {
        let length = extent(std::slice::from_ref(face));
        tolerance.is_finite() && (length <= tolerance || width(&face.surface, length) <= tolerance)
    };
    // A huge face must not make one without area of a sound one.
    if let Some(face) = faces.iter().find(|face| is_narrow(face, tolerance(std::slice::from_ref(*face)))) {
        return Err(ExportError::NoArea { name: face.name.clone() });
    }
    let tolerance = tolerance(faces);
    match faces.iter().find(|face| is_narrow(face, tolerance)) {
        Some(face) => Err(ExportError::TooNarrow { name: face.name.clone(), tolerance }),
        None => Ok(()),
    }
}

/// The area of a surface over its `length`: by Gauss' rule of 2 x 2 points in every cell. Infinite where tangents overflow.
fn width(surface: &BsplineSurface, length: f64) -> f64 {
    let [(u, weights_u), (v, weights_v)] = surface.knots().map(|knots| {
        let rules = knots.breakpoints();
        let rules = rules.windows(2).filter_map(|span| Some(gauss_rule(2, span.try_into().ok()?)));
        rules.fold((Vec::new(), Vec::new()), |(mut at, mut weights), (nodes, shares)| {
            at.extend(nodes);
            weights.extend(shares);
            (at, weights)
        })
    });
    let tangents = |derivative: Derivative| {
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        surface.evaluate_grid(derivative, (&u, &v, 0.0), &mut values)?;
        // Products of coordinates may be too large for a double, those of shares of the length are not.
        values.iter_mut().flatten().for_each(|x| *x /= length);
        Ok::<_, Diagnostic>(values)
    };
    let (Ok(in_u), Ok(in_v)) = (tangents(Derivative::new(1, 0, 0)), tangents(Derivative::new(0, 1, 0))) else {
        return f64::INFINITY;
    };
    let weights = weights_u.iter().flat_map(|a| weights_v.iter().map(move |b| a * b));
    let parts = in_u.iter().zip(&in_v).zip(weights).map(|(([a, b, c], [x, y, z]), weight)| {
        weight * libm::hypot(libm::hypot(b * z - c * y, c * x - a * z), a * y - b * x)
    });
    parts.sum::<f64>() * length
}
