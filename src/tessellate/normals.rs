//! Unit normals from the tangents, or from the faces where the tangents do not span a plane.

use super::samples::{EVALUATION_ERROR, Samples};

/// What a vertex gets whose normal no rule determines.
const ARBITRARY_NORMAL: [f64; 3] = [0.0, 0.0, 1.0];

/// The unit normal of every vertex, and how many of them are arbitrary.
pub(super) fn normals(samples: &Samples, quads: &[[u32; 4]]) -> (Vec<[f64; 3]>, usize) {
    let exact: Vec<Option<[f64; 3]>> = samples
        .tangent_u
        .iter()
        .zip(&samples.tangent_v)
        .map(|(tangent_u, tangent_v)| from_tangents([tangent_u, tangent_v], samples.largest_tangents))
        .collect();
    if exact.iter().all(Option::is_some) {
        return (exact.into_iter().flatten().collect(), 0);
    }
    let mut arbitrary = 0;
    let normals = exact
        .into_iter()
        .zip(area_sums(samples, quads))
        .map(|(exact, area)| {
            exact.or_else(|| area.direction()).unwrap_or_else(|| {
                arbitrary += 1;
                ARBITRARY_NORMAL
            })
        })
        .collect();
    (normals, arbitrary)
}

/// `S_u x S_v` at unit length, or `None` where it is no more than rounding.
fn from_tangents([tangent_u, tangent_v]: [&[f64; 3]; 2], [largest_u, largest_v]: [f64; 2]) -> Option<[f64; 3]> {
    let (size_u, size_v) = (largest_component(tangent_u), largest_component(tangent_v));
    // At a pole S_v is zero but for rounding, which is in proportion to S_v elsewhere, and so has any direction.
    if size_u <= EVALUATION_ERROR * largest_u || size_v <= EVALUATION_ERROR * largest_v {
        return None;
    }
    // Scaled first: the product of two tangents of 1e200, or of 1e-200, is out of range; that of two of size 1 is not.
    let normal = cross(tangent_u.map(|x| x / size_u), tangent_v.map(|x| x / size_v));
    let length = norm(normal);
    (length > EVALUATION_ERROR).then(|| normal.map(|x| x / length))
}

/// The area vectors around one vertex, in units of the patch.
#[derive(Clone, Copy, Default)]
struct AreaSum {
    total: [f64; 3],
    largest: f64,
}

impl AreaSum {
    fn add(&mut self, area: [f64; 3]) {
        self.total = add(self.total, area);
        self.largest = self.largest.max(norm(area));
    }

    /// `None` without area, or where faces turned against each other cancel.
    fn direction(self) -> Option<[f64; 3]> {
        let length = norm(self.total);
        (length > EVALUATION_ERROR * self.largest).then(|| self.total.map(|x| x / length))
    }
}

fn area_sums(samples: &Samples, quads: &[[u32; 4]]) -> Vec<AreaSum> {
    let mut sums = vec![AreaSum::default(); samples.position.len()];
    for quad in quads {
        let corner = |index: u32| samples.position.get(index as usize);
        let [Some(a), Some(b), Some(c), Some(d)] = quad.map(corner) else { continue };
        if let Some(area) = area_vector([a, b, c, d], samples.half_extent, samples.half_error) {
            for index in quad {
                if let Some(sum) = sums.get_mut(*index as usize) {
                    sum.add(area);
                }
            }
        }
    }
    sums
}

/// The area of a quad along its mean normal, which is half the product of its diagonals; the constant is left out.
///
/// `None` when the positions' rounding alone could make such an area.
fn area_vector([a, b, c, d]: [&[f64; 3]; 4], half_extent: f64, half_error: f64) -> Option<[f64; 3]> {
    if half_extent == 0.0 {
        return None;
    }
    let diagonals = [difference(c, a, half_extent), difference(d, b, half_extent)];
    let [ac, bd] = diagonals;
    let area = cross(ac, bd);
    // Each end of a diagonal may be off by the error, which then acts over the length of the other diagonal.
    let noise = 2.0 * (half_error / half_extent) * (norm(ac) + norm(bd));
    (norm(area) > noise).then_some(area)
}

/// `to - from` in units of the patch; halved first, since the difference of two finite numbers may overflow.
fn difference(to: &[f64; 3], from: &[f64; 3], half_extent: f64) -> [f64; 3] {
    let [[x1, y1, z1], [x0, y0, z0]] = [to, from].map(|p| p.map(|x| 0.5 * x));
    [x1 - x0, y1 - y0, z1 - z0].map(|x| x / half_extent)
}

fn add([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ax + bx, ay + by, az + bz]
}

fn cross([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// Length of a vector whose components are of moderate size.
fn norm([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

fn largest_component(vector: &[f64; 3]) -> f64 {
    vector.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normal(tangent_u: [f64; 3], tangent_v: [f64; 3]) -> Option<[f64; 3]> {
        let largest = [largest_component(&tangent_u), largest_component(&tangent_v)];
        from_tangents([&tangent_u, &tangent_v], largest)
    }

    #[test]
    fn normal_of_huge_and_of_tiny_tangents_is_unit() {
        for size in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            assert_eq!(normal([0.0, size, 0.0], [0.0, 0.0, size]), Some([1.0, 0.0, 0.0]));
        }
    }

    #[test]
    fn normal_of_tangents_with_unlike_units_is_unit() {
        assert_eq!(normal([1e250, 0.0, 0.0], [0.0, 1e-250, 0.0]), Some([0.0, 0.0, 1.0]));
    }

    #[test]
    fn parallel_tangents_have_no_normal() {
        assert_eq!(normal([0.1, 0.2, 0.3], [0.3, 0.6, 0.9]), None);
        assert_eq!(normal([0.0; 3], [1.0, 0.0, 0.0]), None);
    }

    #[test]
    fn tangent_of_rounding_size_beside_the_patch_has_no_normal() {
        assert_eq!(from_tangents([&[1.0, 0.0, 0.0], &[0.0, 6e-17, 0.0]], [1.0, 1.0]), None);
    }

    #[test]
    fn quad_area_of_extreme_coordinates_is_finite() {
        let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
        for size in [1e-300, 1.0, f64::MAX] {
            let [a, b, c, d] = corners.map(|corner: [f64; 3]| corner.map(|x| x * size));
            assert_eq!(area_vector([&a, &b, &c, &d], size, 1e-11 * size), Some([0.0, 0.0, 2.0]));
        }
    }

    #[test]
    fn quad_flat_to_rounding_has_no_area() {
        let [a, b, c, d] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1e-16, 0.0], [0.0, 1e-16, 0.0]];
        assert_eq!(area_vector([&a, &b, &c, &d], 0.5, 0.5 * EVALUATION_ERROR), None);
    }

    #[test]
    fn faces_turned_against_each_other_have_no_direction() {
        let mut sum = AreaSum::default();
        sum.add([0.0, 0.3, 0.1]);
        sum.add([0.0, -0.3, -0.1]);
        assert_eq!(sum.direction(), None);
    }
}
