//! Triangles, for formats that have no quads.

use crate::tessellate::Mesh;

/// By how much the second diagonal must be shorter to be preferred.
///
/// The diagonals of a symmetric quad differ by rounding only; without a margin neighbouring quads of a cylinder
/// would be split this way and that at random.
const SHORTER: f64 = 1.0 - 1e-9;

/// Two triangles per quad, split along the shorter diagonal and turned as the quad is.
pub(super) fn triangles(mesh: &Mesh) -> Vec<[u32; 3]> {
    let corner = |index: u32| mesh.positions.get(index as usize).copied().unwrap_or_default();
    let halves = |[a, b, c, d]: &[u32; 4]| {
        if distance(corner(*b), corner(*d)) < SHORTER * distance(corner(*a), corner(*c)) {
            [[*a, *b, *d], [*b, *c, *d]]
        } else {
            [[*a, *b, *c], [*a, *c, *d]]
        }
    };
    mesh.quads.iter().flat_map(halves).collect()
}

/// Not a sum of squares: the square of 1e200 is out of range.
fn distance([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(ax - bx, ay - by), az - bz)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split(corners: [[f64; 2]; 4]) -> Vec<[u32; 3]> {
        let positions = corners.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        triangles(&Mesh { positions, quads: vec![[0, 1, 2, 3]], ..Mesh::default() })
    }

    #[test]
    fn quad_is_split_along_its_shorter_diagonal() {
        let long_ac = [[-2.0, 0.0], [0.0, -1.0], [2.0, 0.0], [0.0, 1.0]];
        assert_eq!(split(long_ac), [[0, 1, 3], [1, 2, 3]]);
        let long_bd = [[-1.0, 0.0], [0.0, -2.0], [1.0, 0.0], [0.0, 2.0]];
        assert_eq!(split(long_bd), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn square_of_rounded_corners_is_split_at_its_first_corner() {
        assert_eq!(split([[0.0, 0.0], [1.0 + 1e-15, 0.0], [1.0, 1.0], [0.0, 1.0]]), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn quad_of_any_size_is_split_alike() {
        for size in [1e-200, 1.0, 1e200] {
            let quad = [[-2.0, 0.0], [0.0, -1.0], [2.0, 0.0], [0.0, 1.0]].map(|corner| corner.map(|x| size * x));
            assert_eq!(split(quad), [[0, 1, 3], [1, 2, 3]], "{size:e}");
        }
    }
}
