//! Sides that have shrunk to a point, and how smooth a surface is there (docs/methods.md, "Patches with an apex").

/// A side whose positions differ by less than this share of the size is a point.
const POINT: f64 = 1e-12;
/// Tangents shorter than this share of the longest have no direction.
const VANISHES: f64 = 1e-12;

/// A point that is a side of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apex {
    /// The largest angle between a tangent that leaves the point and the plane of the first and the last, in degrees from
    /// 0, smooth, to 90; `None` if they span no plane.
    pub angle_degrees: Option<f64>,
}

impl Apex {
    /// The apex that a side with these `positions`, and `tangents` across it, is on a surface of the given `size`; `None` if
    /// it is no point.
    #[must_use]
    pub fn of(positions: &[[f64; 3]], tangents: &[[f64; 3]], size: f64) -> Option<Apex> {
        let start = positions.first()?;
        let is_point = positions.iter().all(|position| norm(difference(*position, *start)) <= POINT * size);
        if !is_point {
            return None;
        }
        let longest = tangents.iter().fold(0.0_f64, |most, tangent| most.max(norm(*tangent)));
        // Written so that NaN vanishes, as below.
        let stay = tangents.iter().all(|tangent| norm(*tangent) > VANISHES * longest);
        let (first, last) = (tangents.first()?, tangents.last()?);
        let normal = cross(*first, *last);
        let spans = norm(normal) > VANISHES * norm(*first) * norm(*last);
        let rise = |tangent: &[f64; 3]| {
            let sine = dot(*tangent, normal).abs() / (norm(*tangent) * norm(normal));
            libm::asin(sine.min(1.0)).to_degrees()
        };
        let angle = || tangents.iter().map(rise).fold(0.0, f64::max);
        Some(Apex { angle_degrees: (stay && spans).then(angle) })
    }

    /// The worse of two: without a plane nothing is worse.
    #[must_use]
    pub fn worst(self, other: Apex) -> Apex {
        let both = self.angle_degrees.zip(other.angle_degrees);
        Apex { angle_degrees: both.map(|(a, b)| a.max(b)) }
    }
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let ([a, b, c], [x, y, z]) = (a, b);
    [a - x, b - y, c - z]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    // Squares would make a point of a very small side.
    libm::hypot(libm::hypot(x, y), z)
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
