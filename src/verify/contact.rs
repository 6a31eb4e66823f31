//! How two surfaces meet along a curve: the gap between them and the angle between their tangent planes.

/// x, y and z.
pub type Vector = [f64; 3];

/// Numbers below this fraction of those they are computed from are rounding errors.
const NEGLIGIBLE: f64 = 1e-12;

/// Distance of two points.
pub fn distance(a: Vector, b: Vector) -> f64 {
    length(difference(a, b))
}

/// `a - b`
pub fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Scalar product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Euclidean length.
pub fn length(a: Vector) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// The direction of a vector; `None` for one without length.
pub fn direction(a: Vector) -> Option<Vector> {
    let length = length(a);
    (length > 0.0 && length.is_finite()).then(|| a.map(|x| x / length))
}

/// The unit normals along a curve on a surface, from its positions and its tangents in u and in v; `None` where the
/// tangents do not span a plane.
pub fn normals(positions: &[Vector], tangents: impl Iterator<Item = (Vector, Vector)> + Clone) -> Vec<Option<Vector>> {
    let lengths = tangents.clone().flat_map(|(u, v)| [length(u), length(v)]);
    let size = positions.iter().map(|at| length(*at)).chain(lengths).fold(0.0, f64::max);
    // At a pole the tangent along the curve is not zero but rounding errors of numbers of this size.
    tangents.map(|(u, v)| normal(u, v).filter(|_| length(u).min(length(v)) > NEGLIGIBLE * size)).collect()
}

fn normal(u: Vector, v: Vector) -> Option<Vector> {
    // Of unit vectors, so that the test does not depend on how fast the parameters run.
    let product = cross(direction(u)?, direction(v)?);
    if length(product) > NEGLIGIBLE { direction(product) } else { None }
}

/// The angle between two planes in degrees, from 0 to 90: the side a normal points to is a choice of parameters.
pub fn angle_degrees(a: Vector, b: Vector) -> f64 {
    // Not the arc cosine, which loses half the digits near 0.
    length(cross(a, b)).atan2(dot(a, b).abs()).to_degrees()
}

/// The angle in degrees, from 0 to 180, by which a surface turns where it goes on as another along a common curve with
/// tangent `along`: 0 where both run on smoothly, 180 where the second folds back over the first. `a` and `b` point out of
/// the two surfaces across the curve. `None` if a direction has no length across the curve.
pub fn turn_degrees(a: Vector, b: Vector, along: Vector) -> Option<f64> {
    let along = direction(along)?;
    let across = |outward: Vector| {
        let share = dot(outward, along);
        let rest = [0, 1, 2].map(|i| {
            let component = |vector: Vector| vector.get(i).copied().unwrap_or(0.0);
            component(outward) - share * component(along)
        });
        direction(rest).filter(|_| length(rest) > NEGLIGIBLE * length(outward))
    };
    let (a, b) = (across(a)?, across(b)?.map(|x| -x));
    Some(length(cross(a, b)).atan2(dot(a, b)).to_degrees())
}

/// The larger of two measurements, of which one may not exist.
pub fn worse(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_angles_keep_their_digits() {
        let tilted = [0.0, 1e-9_f64.sin(), 1e-9_f64.cos()];
        let angle = angle_degrees([0.0, 0.0, 1.0], tilted);
        assert!((angle.to_radians() - 1e-9).abs() < 1e-20, "{angle:e}");
    }

    #[test]
    fn planes_with_opposite_normals_are_one() {
        assert_eq!(angle_degrees([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), 0.0);
    }

    #[test]
    fn surfaces_that_fold_back_turn_by_a_half_turn() {
        let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(turn_degrees(x, [-2.0, 0.0, 0.0], y), Some(0.0));
        assert_eq!(turn_degrees(x, [3.0, 5.0, 0.0], y), Some(180.0));
        let right = turn_degrees(x, [0.0, 0.0, 1.0], y).unwrap();
        assert!((right - 90.0).abs() < 1e-12, "{right}");
        assert_eq!(turn_degrees(x, y, y), None);
    }

    #[test]
    fn tangents_without_length_or_in_one_line_have_no_normal() {
        assert_eq!(normal([0.0; 3], [1.0, 0.0, 0.0]), None);
        assert_eq!(normal([1e-9, 0.0, 0.0], [3.0, 0.0, 0.0]), None);
        assert_eq!(normal([1e-200, 0.0, 0.0], [0.0, 1e200, 0.0]), Some([0.0, 0.0, 1.0]));
        let pole = [([1.0, 0.0, 0.0], [0.0, 6e-17, 0.0])];
        assert_eq!(normals(&[[0.0, 0.0, 0.0]], pole.into_iter()), [None]);
    }
}
