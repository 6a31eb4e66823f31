//! Where the viewer stands, and the way from space to the picture.

use crate::diagnostic::{Code, Diagnostic, Shortest};
use crate::tessellate::{Mesh, Scene};

use super::canvas::{Point, SAMPLES};

/// A viewer far away who looks at the middle of the scene; z points up in the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Degrees around z, counter-clockwise; at 0 the viewer stands on the side of positive x.
    pub azimuth: f64,
    /// Degrees above the plane of x and y, from -90 to 90.
    pub elevation: f64,
    /// 1 fits the scene to the picture, 2 shows it twice as large.
    pub zoom: f64,
}

impl Default for Camera {
    /// From the right in front and above.
    fn default() -> Self {
        Camera { azimuth: -60.0, elevation: 25.0, zoom: 1.0 }
    }
}

impl Camera {
    /// Whether the numbers are in range.
    pub(super) fn check(self) -> Result<(), Diagnostic> {
        let is_sound = self.azimuth.is_finite()
            && (-90.0..=90.0).contains(&self.elevation)
            && (SMALLEST_ZOOM..=LARGEST_ZOOM).contains(&self.zoom);
        if is_sound {
            return Ok(());
        }
        let [azimuth, elevation, zoom] = [self.azimuth, self.elevation, self.zoom].map(Shortest);
        let message = format!("the camera at {azimuth}, {elevation}, zoom {zoom} is out of range");
        let hint =
            "azimuth in degrees, elevation from -90 to 90 degrees, zoom from 0.001 to 1000, for example -60,25,1.5";
        Err(Diagnostic::new(Code::SettingOutOfRange, message).hint(hint))
    }
}

const SMALLEST_ZOOM: f64 = 1e-3;
const LARGEST_ZOOM: f64 = 1e3;

/// The part of each side of the picture that the scene fills at zoom 1.
const FILLED: f64 = 0.86;

/// From space to samples: x to the right, y down, depth towards the viewer.
pub(super) struct View {
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
    /// The middle of the scene, and half its longest side: coordinates are taken relative to both, so that 1e300 is no
    /// larger than 1.
    middle: [f64; 3],
    half_side: f64,
    scale: f64,
    /// Middle of the projected scene, and of the picture in samples.
    center: [f64; 2],
    origin: [f64; 2],
}

impl View {
    /// The view that shows all vertices of all frames.
    pub fn fit(frames: &[Scene], camera: Camera, (width, height): (usize, usize)) -> View {
        let (azimuth, elevation) = (camera.azimuth.to_radians(), camera.elevation.to_radians());
        let ((sin_a, cos_a), (sin_e, cos_e)) = (libm::sincos(azimuth), libm::sincos(elevation));
        let vertices = || frames.iter().flat_map(|scene| &scene.meshes).flat_map(|mesh| &mesh.positions);
        let (low, high) = bounds(vertices().copied());
        let size = [(width * SAMPLES) as f64, (height * SAMPLES) as f64];
        let mut view = View {
            right: [-sin_a, cos_a, 0.0],
            up: [-sin_e * cos_a, -sin_e * sin_a, cos_e],
            towards: [cos_e * cos_a, cos_e * sin_a, sin_e],
            middle: std::array::from_fn(|axis| 0.5 * part(&low, axis) + 0.5 * part(&high, axis)),
            half_side: low.iter().zip(&high).fold(0.0, |most, (low, high)| f64::max(most, 0.5 * high - 0.5 * low)),
            scale: 1.0,
            center: [0.0; 2],
            origin: size.map(|samples| 0.5 * samples),
        };
        let (low, high) = bounds(vertices().map(|position| view.turned(position)));
        let spans: [f64; 2] = std::array::from_fn(|axis| part(&high, axis) - part(&low, axis));
        view.center = std::array::from_fn(|axis| 0.5 * (part(&low, axis) + part(&high, axis)));
        let fits = spans.iter().zip(size).filter(|(span, _)| **span > 0.0).map(|(span, samples)| samples / span);
        view.scale = fits.reduce(f64::min).unwrap_or(1.0) * FILLED * camera.zoom;
        view
    }

    /// A position in the camera's directions, in units of half the longest side: right, up, towards the viewer.
    fn turned(&self, position: &[f64; 3]) -> [f64; 3] {
        if self.half_side == 0.0 {
            return [0.0; 3];
        }
        let relative: [f64; 3] =
            std::array::from_fn(|axis| (0.5 * part(position, axis) - 0.5 * part(&self.middle, axis)) / self.half_side);
        [self.right, self.up, self.towards].map(|direction| 2.0 * dot(direction, relative))
    }

    /// The place of a position in samples, and its depth in units of half the longest side.
    pub fn place(&self, position: &[f64; 3]) -> [f64; 3] {
        let ([x, y, depth], [cx, cy], [ox, oy]) = (self.turned(position), self.center, self.origin);
        [ox + self.scale * (x - cx), oy - self.scale * (y - cy), depth]
    }

    fn direction(&self, normal: &[f64; 3]) -> [f64; 3] {
        [self.right, self.up, self.towards].map(|direction| dot(direction, *normal))
    }

    /// The triangles of a mesh, as they are to be drawn: each quad is four around its middle, which keeps a symmetric
    /// quad symmetric.
    pub fn triangles(&self, mesh: &Mesh) -> Vec<[Point; 3]> {
        let points: Vec<Point> = (0..mesh.positions.len()).filter_map(|vertex| self.point(mesh, vertex)).collect();
        let step = step_in_v(mesh);
        let mut triangles = Vec::with_capacity(4 * mesh.quads.len());
        for quad in &mesh.quads {
            let [Some(a), Some(b), Some(c), Some(d)] = quad.map(|index| points.get(index as usize).copied()) else {
                continue;
            };
            let [c, d] = [c, d].map(|point| unwound(point, a, step));
            let middle = Point::mean([a, b, c, d]);
            triangles.extend([[a, b, middle], [b, c, middle], [c, d, middle], [d, a, middle]]);
        }
        triangles
    }

    fn point(&self, mesh: &Mesh, vertex: usize) -> Option<Point> {
        let field = mesh.fields.first().and_then(|field| field.values.get(vertex));
        Some(Point {
            place: self.place(mesh.positions.get(vertex)?),
            normal: self.direction(mesh.normals.get(vertex)?),
            uv: *mesh.uv.get(vertex)?,
            value: field.copied().unwrap_or(f64::NAN),
        })
    }
}

/// In the last strip of a closed mesh v returns to its start; here it goes on by `step`.
fn unwound(point: Point, before: Point, step: f64) -> Point {
    let ([u, v], [_, v_before]) = (point.uv, before.uv);
    if v < v_before { Point { uv: [u, v_before + step], ..point } } else { point }
}

/// How far apart the columns of a mesh are in v.
pub(super) fn step_in_v(mesh: &Mesh) -> f64 {
    match mesh.uv.get(..mesh.columns.min(2)) {
        Some([[_, first], [_, second]]) => second - first,
        _ => 0.0,
    }
}

fn bounds(positions: impl Iterator<Item = [f64; 3]>) -> ([f64; 3], [f64; 3]) {
    let fold = |(low, high): ([f64; 3], [f64; 3]), position: [f64; 3]| {
        let bound = |bound: [f64; 3], pick: fn(f64, f64) -> f64| {
            std::array::from_fn(|axis| pick(part(&bound, axis), part(&position, axis)))
        };
        (bound(low, f64::min), bound(high, f64::max))
    };
    let (low, high) = positions.fold(([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]), fold);
    if part(&low, 0) <= part(&high, 0) { (low, high) } else { ([0.0; 3], [0.0; 3]) }
}

fn part(vector: &[f64; 3], axis: usize) -> f64 {
    vector.get(axis).copied().unwrap_or_default()
}

fn dot([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    ax * bx + ay * by + az * bz
}
