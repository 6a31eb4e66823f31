//! Surfaces in closed form, with closed-form normals, to measure meshes against.
#![allow(clippy::indexing_slicing)]

use std::f64::consts::{PI, TAU};

use trimline::diagnostic::{Code, Diagnostic};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::surface::Surface;
use trimline::tessellate::{Grid, Mesh, Scene, tessellate};

/// `[S, S_u, S_v]` at (u, v, t).
type Jet = fn(f64, f64, f64) -> [[f64; 3]; 3];

/// A surface given by its position and tangents.
pub struct Analytic {
    pub name: &'static str,
    pub u: [f64; 2],
    pub v: [f64; 2],
    pub jet: Jet,
}

impl Surface for Analytic {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let which = match (derivative.u, derivative.v, derivative.t) {
            (0, 0, 0) => 0,
            (1, 0, 0) => 1,
            (0, 1, 0) => 2,
            _ => return Err(Diagnostic::new(Code::NotDifferentiable, "only first derivatives")),
        };
        for (value, &[u, v, t]) in values.iter_mut().zip(points) {
            *value = (self.jet)(u, v, t)[which];
        }
        Ok(())
    }
}

impl Analytic {
    pub fn mesh_at(&self, (u_cells, v_cells): (usize, usize), t: f64) -> (Mesh, Vec<Diagnostic>) {
        let grid = Grid::new(u_cells, v_cells, &Limits::default()).expect("a small grid");
        tessellate(self.name, self, (self.u, self.v), t, grid).expect("a finite surface")
    }

    /// The mesh at t = 0 of a surface that gives no cause for warnings.
    pub fn mesh(&self, cells: (usize, usize)) -> Mesh {
        let (mesh, warnings) = self.mesh_at(cells, 0.0);
        assert_eq!(warnings, []);
        mesh
    }

    pub fn scene(&self, cells: (usize, usize)) -> Scene {
        Scene { meshes: vec![self.mesh(cells)], time: 0.0 }
    }
}

/// Radius 1 + t, height 2; normals point outwards.
pub const CYLINDER: Analytic = Analytic {
    name: "cylinder",
    u: [0.0, 1.0],
    v: [0.0, TAU],
    jet: |u, v, t| {
        let (sin, cos) = v.sin_cos();
        let r = 1.0 + t;
        // v runs clockwise seen from above, so that S_u x S_v points outwards.
        [[r * cos, -r * sin, 2.0 * u], [0.0, 0.0, 2.0], [-r * sin, -r * cos, 0.0]]
    },
};

/// Half of [`CYLINDER`]: open, and not to be welded.
pub const HALF_CYLINDER: Analytic = Analytic { name: "half cylinder", v: [0.0, PI], ..CYLINDER };

/// Part of a torus of radii 3 and 1, closed in v only.
pub const TORUS_PATCH: Analytic = Analytic {
    name: "torus patch",
    u: [0.0, 2.0],
    v: [0.0, TAU],
    jet: |u, v, _| {
        let ((su, cu), (sv, cv)) = (u.sin_cos(), v.sin_cos());
        let r = 3.0 + cu;
        [[r * cv, r * sv, su], [-su * cv, -su * sv, cu], [-r * sv, r * cv, 0.0]]
    },
};

/// The rectangle 2 x 3 in z = 0.
pub const PLANE: Analytic = Analytic {
    name: "plane",
    u: [-1.0, 1.0],
    v: [0.0, 3.0],
    jet: |u, v, _| [[u, v, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
};

/// Apex at the origin for u = 0, opening upwards; normals point inwards, S_v vanishes at the apex.
pub const CONE: Analytic = Analytic {
    name: "cone",
    u: [0.0, 1.0],
    v: [0.0, TAU],
    jet: |u, v, _| {
        let (sin, cos) = v.sin_cos();
        [[u * cos, u * sin, u], [cos, sin, 1.0], [-u * sin, u * cos, 0.0]]
    },
};

/// A strip with a half turn: its sides meet with u reversed.
pub const MOEBIUS: Analytic = Analytic {
    name: "strip",
    u: [-0.5, 0.5],
    v: [0.0, TAU],
    jet: |u, v, _| {
        let ((sin, cos), (sh, ch)) = (v.sin_cos(), (0.5 * v).sin_cos());
        let r = 2.0 + u * ch;
        let (r_u, r_v) = (ch, -0.5 * u * sh);
        [
            [r * cos, r * sin, u * sh],
            [r_u * cos, r_u * sin, sh],
            [r_v * cos - r * sin, r_v * sin + r * cos, 0.5 * u * ch],
        ]
    },
};

/// A drop-shaped tube: its sides meet in position, at a crease.
pub const CREASED_TUBE: Analytic = Analytic {
    name: "creased tube",
    u: [0.0, 1.0],
    v: [0.0, TAU],
    jet: |u, v, _| {
        let (sin, cos) = v.sin_cos();
        let (sh, ch) = (0.5 * v).sin_cos();
        // The width sin(v) sin(v/2) vanishes at v = 0 and v = TAU with slopes 0, the height sin(v/2) with slopes +-1/2.
        [[u, sin * sh, sh], [1.0, 0.0, 0.0], [0.0, cos * sh + 0.5 * sin * ch, 0.5 * ch]]
    },
};

/// Collapsed to a segment: no normal anywhere.
pub const SEGMENT: Analytic = Analytic {
    name: "segment",
    u: [0.0, 1.0],
    v: [0.0, 1.0],
    jet: |u, _, _| [[u, 0.25 * u, 0.5], [1.0, 0.25, 0.0], [0.0; 3]],
};

pub fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
