//! What the colours of a surface mean.

use crate::tessellate::{Mesh, Role, Scene};

use super::camera::step_in_v;
use super::canvas::Point;
use super::color::{NO_VALUE, PATCH, PRIMARY, Rgb, diverging, rgb, sequential};

/// What the colours of a surface mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Shade {
    /// Nothing but light; the inside of a surface has another colour than its outside.
    #[default]
    Plain,
    /// Reflected stripes: they break where the surface has a crease, and bend where its curvature jumps.
    Zebra,
    /// The first of the meshes' [fields](crate::tessellate::Mesh::fields), from its least to its largest value.
    Field,
    /// The first of the meshes' fields, on a scale that is symmetric about zero and spans 98 of 100 values.
    SignedField,
    /// The parameter u.
    U,
    /// The parameter v.
    V,
}

/// Stripes between straight down and straight up.
const STRIPES: f64 = 16.0;

/// The part of the values that a scale symmetric about zero spans: curvature is unbounded near a cusp, and a scale
/// that reaches it shows nothing else.
const SPANNED: f64 = 0.98;

/// Gives each point of a surface its colour.
pub(super) struct Painter {
    shade: Shade,
    /// Where the scale begins and ends.
    ends: [f64; 2],
    /// Whether there are values beyond the ends.
    is_exceeded: bool,
}

impl Painter {
    /// A painter with one scale for all frames.
    pub fn new(shade: Shade, frames: &[Scene]) -> Painter {
        let meshes = || frames.iter().flat_map(|scene| &scene.meshes).filter(|mesh| mesh.role == Role::Blend);
        let values: Vec<f64> = match shade {
            Shade::Plain | Shade::Zebra => Vec::new(),
            Shade::U => meshes().flat_map(|mesh| &mesh.uv).map(|[u, _]| *u).collect(),
            Shade::V => meshes().flat_map(values_of_v).collect(),
            Shade::Field | Shade::SignedField => {
                let fields = meshes().filter_map(|mesh| mesh.fields.first());
                fields.flat_map(|field| &field.values).copied().filter(|value| !value.is_nan()).collect()
            }
        };
        let largest_size = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let ends = match shade {
            _ if values.is_empty() => [0.0, 0.0],
            Shade::SignedField => {
                let end = spanned_size(&values);
                [-end, end]
            }
            _ => {
                [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| values.iter().copied().reduce(pick).unwrap_or(0.0))
            }
        };
        let [_, high] = ends;
        Painter { shade, ends, is_exceeded: shade == Shade::SignedField && largest_size > high }
    }

    /// The scale, if there is one: its ends, and whether there are values beyond them.
    pub fn scale(&self) -> Option<([f64; 2], bool)> {
        (!matches!(self.shade, Shade::Plain | Shade::Zebra)).then_some((self.ends, self.is_exceeded))
    }

    /// The colour at `share` of the way along the scale.
    pub fn map(&self, share: f64) -> Rgb {
        rgb(self.parts(share))
    }

    fn parts(&self, share: f64) -> [f64; 3] {
        if self.shade == Shade::SignedField { diverging(share) } else { sequential(share) }
    }

    /// The colour of a point.
    pub fn color(&self, role: Role, point: &Point) -> Rgb {
        let [x, y, z] = point.normal;
        let length = (x * x + y * y + z * z).sqrt();
        // Of a crease the two sides may cancel: the light then comes from the viewer.
        let normal = if length > 0.0 { [x / length, y / length, z / length] } else { [0.0, 0.0, 1.0] };
        let [_, _, z] = normal;
        let is_inside = z < 0.0;
        let normal = if is_inside { normal.map(|x| -x) } else { normal };
        if role == Role::Primary {
            return lit(side(PRIMARY, is_inside), normal);
        }
        let [u, v] = point.uv;
        match self.shade {
            Shade::Plain => lit(side(PATCH, is_inside), normal),
            Shade::Zebra => lit(stripe(normal), normal),
            Shade::U => self.scaled(u, normal),
            Shade::V => self.scaled(v, normal),
            Shade::Field | Shade::SignedField => self.scaled(point.value, normal),
        }
    }

    fn scaled(&self, value: f64, normal: [f64; 3]) -> Rgb {
        if value.is_nan() {
            return NO_VALUE;
        }
        let [low, high] = self.ends;
        // Halved: the range may be wider than the widest double.
        let share = if high > low { (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low) } else { 0.5 };
        lit(self.parts(share), normal)
    }
}

/// The size that all but the largest few values do not exceed; if that is zero, the largest.
fn spanned_size(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let last = sizes.last().copied().unwrap_or(0.0);
    let spanned = sizes.get((sizes.len() as f64 * SPANNED) as usize).copied().unwrap_or(last);
    if spanned > 0.0 { spanned } else { last }
}

/// The values of v at the vertices; where a mesh closes on itself, also that at which it does.
fn values_of_v(mesh: &Mesh) -> impl Iterator<Item = f64> + '_ {
    let end = if mesh.is_closed_in_v { step_in_v(mesh) } else { 0.0 };
    mesh.uv.iter().flat_map(move |[_, v]| [*v, *v + end])
}

fn side([outside, inside]: [[f64; 3]; 2], is_inside: bool) -> [f64; 3] {
    if is_inside { inside } else { outside }
}

/// A light above the viewer, so that what is symmetric looks symmetric, and some from everywhere.
fn lit(color: [f64; 3], [_, y, z]: [f64; 3]) -> Rgb {
    // (0, 0.6, 0.8) has unit length.
    let towards_light = (0.6 * y + 0.8 * z).max(0.0);
    let light = 0.45 + 0.6 * towards_light;
    let gleam = 0.12 * towards_light * towards_light * towards_light * towards_light;
    rgb(color.map(|part| light * part + gleam))
}

/// Of the ray from the viewer that the surface reflects, the height decides: dark and light in turn.
fn stripe([_, y, z]: [f64; 3]) -> [f64; 3] {
    // The viewer is at (0, 0, 1): the reflected ray is 2 (n·e) n - e.
    let height = 2.0 * z * y;
    let place = libm::floor(0.5 * (height + 1.0) * STRIPES);
    if place % 2.0 == 0.0 { [0.14, 0.14, 0.16] } else { [0.95, 0.95, 0.95] }
}
