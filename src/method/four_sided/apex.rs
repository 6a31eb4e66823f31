//! What is said of sides that have shrunk to a point.

use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::surface::Apex;

/// Angles, in degrees, that rounding alone makes stay far below.
const SMOOTH: f64 = 1e-6;

/// A warning if the side `place`, with `positions` and the `tangents` that leave it at instant `t`, is a point without a
/// tangent plane.
pub fn apex(
    (place, t): (&str, f64),
    positions: &[[f64; 3]],
    tangents: &[[f64; 3]],
    size: f64,
    origin: Option<Span>,
) -> Option<Diagnostic> {
    let warning =
        |message: String| Diagnostic::new(Code::ApexNotSmooth, message).at(origin).marked(format!("at {place}"));
    match Apex::of(positions, tangents, size)?.angle_degrees {
        None => Some(
            warning(format!("the side {place} is a point, and the tangents that leave it span no plane"))
                .hint("let the neighbouring sides leave the point in two directions"),
        ),
        Some(angle) if angle <= SMOOTH => None,
        Some(angle) => Some(
            warning(format!(
                "the side {place} is a point, and the tangents that leave it rise {angle:.2} degrees out of one plane at t = {}",
                Shortest(t)
            ))
            .hint(
                "let the tangents across the neighbouring sides turn in the plane in which those sides leave the point",
            ),
        ),
    }
}
