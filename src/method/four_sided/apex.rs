//! Sides that have shrunk to a point, and whether the surface is smooth there.

use crate::diagnostic::{Code, Diagnostic, Span};

/// A side whose positions differ by less than this share of the data is a point.
const POINT: f64 = 1e-12;
/// Tangents shorter than this share of the longest have no direction.
const VANISHES: f64 = 1e-12;
/// Angles, in degrees, that rounding alone makes stay far below.
const SMOOTH: f64 = 1e-6;

/// A warning if the side `place`, with `positions` and the `tangents` that leave it, is a point without a tangent plane.
///
/// The plane is that of the first and last tangent; those in between must lie in it.
pub fn apex(
    place: &str,
    positions: &[[f64; 3]],
    tangents: &[[f64; 3]],
    size: f64,
    origin: Option<Span>,
) -> Option<Diagnostic> {
    let start = positions.first()?;
    let is_point = positions.iter().all(|position| norm(difference(*position, *start)) <= POINT * size);
    if !is_point {
        return None;
    }
    let warning =
        |message: String, advice: &str| Some(Diagnostic::new(Code::ApexNotSmooth, message).at(origin).hint(advice));
    let longest = tangents.iter().fold(0.0_f64, |most, tangent| most.max(norm(*tangent)));
    // Written so that NaN vanishes, as below.
    let stay = tangents.iter().all(|tangent| norm(*tangent) > VANISHES * longest);
    let (first, last) = (tangents.first()?, tangents.last()?);
    let normal = cross(*first, *last);
    let spans = norm(normal) > VANISHES * norm(*first) * norm(*last);
    if !(stay && spans) {
        return warning(
            format!("the side {place} is a point, and the tangents that leave it span no plane"),
            "let the neighbouring sides leave the point in two directions",
        );
    }
    let rise = |tangent: &[f64; 3]| {
        let sine = dot(*tangent, normal).abs() / (norm(*tangent) * norm(normal));
        libm::asin(sine.min(1.0)).to_degrees()
    };
    let angle = tangents.iter().map(rise).fold(0.0, f64::max);
    if angle <= SMOOTH {
        return None;
    }
    warning(
        format!("the side {place} is a point, and the tangents that leave it rise {angle:.2} degrees out of one plane"),
        "let the tangents across the neighbouring sides turn in the plane in which those sides leave the point",
    )
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let ([a, b, c], [x, y, z]) = (a, b);
    [a - x, b - y, c - z]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: [f64; 3]) -> f64 {
    libm::sqrt(dot(a, a))
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
