//! A patch's position and tangents on the grid, with the sizes that errors are measured against.

use crate::diagnostic::{Code, Diagnostic};
use crate::surface::{GridShape, Surface, UnitNormals};

/// Relative error that an evaluated position or derivative may carry.
///
/// 2^16 roundings, 1.5e-11: the argument of sin(k v) has an absolute rounding error of k v * 1.1e-16, so 1e-13 for the
/// hundredth harmonic over a full turn, and the terms of a solved surface are up to some hundred times larger
/// than their sum. It stays far below what any output shows (f32: 6e-8).
pub(super) const EVALUATION_ERROR: f64 = 65536.0 * f64::EPSILON;

/// S, S_u and S_v on a grid, u-major, rows of `columns` values; all finite.
pub(super) struct Samples {
    pub position: Vec<[f64; 3]>,
    pub tangent_u: Vec<[f64; 3]>,
    pub tangent_v: Vec<[f64; 3]>,
    /// The unit normals, if every one of them is more than rounding.
    pub normals: Option<Vec<[f64; 3]>>,
    pub columns: usize,
    /// Half the longest side of the bounding box. Half, because the whole one may overflow.
    pub half_extent: f64,
    /// Half the error a coordinate may carry.
    pub half_error: f64,
    /// Largest component of S_u and of S_v.
    pub largest_tangents: [f64; 2],
}

impl Samples {
    pub fn evaluate(
        name: &str,
        surface: &dyn Surface,
        (u, v, t): (&[f64], &[f64], f64),
    ) -> Result<Samples, Diagnostic> {
        let shape = surface.shape((u, v, t))?;
        let GridShape { positions: position, tangents_u: tangent_u, tangents_v: tangent_v, normals } = shape;
        let largest_tangents = [largest(&tangent_u), largest(&tangent_v)];
        let fields = [
            (&position, largest(&position), "the position"),
            (&tangent_u, largest_tangents[0], "the derivative in u"),
            (&tangent_v, largest_tangents[1], "the derivative in v"),
        ];
        for (values, largest, quantity) in fields {
            if largest.is_finite() {
                continue;
            }
            // A surface reports this itself; a foreign implementation that forgets must not reach a file.
            let points = u.iter().flat_map(|&u| v.iter().map(move |&v| (u, v)));
            let found = values.iter().zip(points).find(|(value, _)| !value.iter().all(|x| x.is_finite()));
            if let Some((_, (u, v))) = found {
                let message = format!("{quantity} of `{name}` is not finite at u = {u}, v = {v}, t = {t}");
                return Err(Diagnostic::new(Code::SolutionNotFinite, message));
            }
        }
        let half_extent = half_extent(&position);
        // Far from the origin the coordinates' own resolution is coarser than the patch's.
        let half_error = EVALUATION_ERROR * half_extent + 2.0 * f64::EPSILON * largest(&position);
        let normals = normals.filter(|normals| are_certain(normals, largest_tangents)).map(|normals| normals.unit);
        let columns = v.len();
        Ok(Samples { position, tangent_u, tangent_v, normals, columns, half_extent, half_error, largest_tangents })
    }

    /// Whether the last column continues in the first: same positions and same tangents, all along the column.
    ///
    /// Equal positions are not enough: across a crease the two sides need normals of their own. And a patch
    /// collapsed to a curve along u comes back to where it never left; that is not a ring.
    pub fn closes_in_v(&self) -> bool {
        let [error_u, error_v] = self.largest_tangents.map(|largest| 0.5 * EVALUATION_ERROR * largest);
        let returns = |values: &[[f64; 3]], half_error: f64| {
            values.chunks(self.columns).all(|row| match (row.first(), row.last()) {
                (Some(first), Some(last)) => agree(first, last, half_error),
                _ => false,
            })
        };
        let leaves = || {
            self.position.chunks(self.columns).any(|row| match row.split_first() {
                Some((first, others)) => others.iter().any(|other| !agree(first, other, self.half_error)),
                None => false,
            })
        };
        returns(&self.position, self.half_error)
            && returns(&self.tangent_u, error_u)
            && returns(&self.tangent_v, error_v)
            && leaves()
    }

    /// The samples without the last column.
    pub fn without_last_column(self) -> Samples {
        let columns = self.columns;
        let cut = |values: Vec<[f64; 3]>| {
            values.chunks(columns).filter_map(<[_]>::split_last).flat_map(|(_, kept)| kept).copied().collect()
        };
        Samples {
            position: cut(self.position),
            tangent_u: cut(self.tangent_u),
            tangent_v: cut(self.tangent_v),
            normals: self.normals.map(cut),
            columns: columns.saturating_sub(1),
            ..self
        }
    }
}

/// Whether every normal is far longer than rounding makes it, before it is made a unit: then both tangents and the sine
/// of the angle between them are too, whatever the vertex, since neither tangent exceeds √3 times its largest component.
fn are_certain(normals: &UnitNormals, [largest_u, largest_v]: [f64; 2]) -> bool {
    const CERTAIN: f64 = 16.0 * EVALUATION_ERROR;
    let scale = CERTAIN * largest_u * largest_v;
    // Below this the square of a length has lost digits.
    const SMALLEST: f64 = 1e-280;
    normals.least_square > SMALLEST && normals.least_square > scale * scale && scale.is_finite()
}

/// Halved like the error, since the difference of two finite numbers may overflow.
fn agree(a: &[f64; 3], b: &[f64; 3], half_error: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (0.5 * a - 0.5 * b).abs() <= half_error)
}

/// The largest size of a component; NaN or infinite if one is.
fn largest(values: &[[f64; 3]]) -> f64 {
    let sizes = values.iter().flatten().map(|x| x.to_bits() & (u64::MAX >> 1));
    // Sizes are ordered as their bits are, and NaN comes last.
    f64::from_bits(sizes.fold(0, u64::max))
}

fn half_extent(positions: &[[f64; 3]]) -> f64 {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for position in positions {
        for ((low, high), &x) in low.iter_mut().zip(&mut high).zip(position) {
            *low = low.min(x);
            *high = high.max(x);
        }
    }
    low.iter().zip(high).fold(0.0, |extent, (low, high)| extent.max(0.5 * high - 0.5 * low))
}
