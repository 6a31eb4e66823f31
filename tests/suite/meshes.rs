//! What a mesh promises: topology, normals, orientation, seams, limits.
#![allow(clippy::indexing_slicing)]

use std::collections::BTreeMap;
use std::f64::consts::PI;

use trimline::diagnostic::{Code, Diagnostic};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::surface::Surface;
use trimline::tessellate::{Grid, Mesh, tessellate};

use crate::analytic::*;

/// A closed form costs a handful of roundings, and normalising another: each at most EPSILON / 2.
const CLOSED_FORM_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// How often each directed edge occurs.
fn directed_edges(mesh: &Mesh) -> BTreeMap<(u32, u32), usize> {
    let mut edges = BTreeMap::new();
    for [a, b, c, d] in mesh.quads.iter().copied() {
        for edge in [(a, b), (b, c), (c, d), (d, a)] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    edges
}

fn euler_characteristic(mesh: &Mesh) -> i64 {
    let edges = directed_edges(mesh);
    let undirected = edges.keys().filter(|&&(a, b)| a < b || !edges.contains_key(&(b, a))).count();
    mesh.positions.len() as i64 - undirected as i64 + mesh.quads.len() as i64
}

fn boundary_edges(mesh: &Mesh) -> usize {
    let edges = directed_edges(mesh);
    edges.keys().filter(|&&(a, b)| !edges.contains_key(&(b, a))).count()
}

fn corner_area_vectors(mesh: &Mesh, quad: [u32; 4]) -> [[f64; 3]; 4] {
    let p = quad.map(|index| mesh.positions[index as usize]);
    [0, 1, 2, 3].map(|k| cross(minus(p[(k + 1) % 4], p[k]), minus(p[(k + 3) % 4], p[k])))
}

fn area(mesh: &Mesh) -> f64 {
    let halves = mesh.quads.iter().map(|&quad| {
        let corners = corner_area_vectors(mesh, quad);
        0.5 * (length(corners[0]) + length(corners[2]))
    });
    halves.sum()
}

fn all_surfaces() -> [(&'static Analytic, bool); 8] {
    [
        (&CYLINDER, true),
        (&HALF_CYLINDER, false),
        (&TORUS_PATCH, true),
        (&PLANE, false),
        (&CONE, true),
        (&MOEBIUS, false),
        (&CREASED_TUBE, false),
        (&SEGMENT, false),
    ]
}

fn assert_normals(surface: &Analytic, expected: impl Fn(f64, f64) -> [f64; 3]) {
    let mesh = surface.mesh((5, 12));
    for (normal, &[u, v]) in mesh.normals.iter().zip(&mesh.uv) {
        let error = length(minus(*normal, expected(u, v)));
        assert!(error <= CLOSED_FORM_ROUNDING, "{}: {error:e} at ({u}, {v})", surface.name);
    }
}

#[test]
fn closed_mesh_counts_one_column_less() {
    let mesh = CYLINDER.mesh((3, 8));
    assert!(mesh.is_closed_in_v);
    assert_eq!((mesh.positions.len(), mesh.quads.len()), (4 * 8, 3 * 8));
    assert_eq!((mesh.normals.len(), mesh.uv.len()), (32, 32));
}

#[test]
fn open_mesh_counts_all_columns() {
    let mesh = PLANE.mesh((3, 8));
    assert!(!mesh.is_closed_in_v);
    assert_eq!((mesh.positions.len(), mesh.quads.len()), (4 * 9, 3 * 8));
}

#[test]
fn meshes_close_exactly_where_the_surface_is_smooth_across_the_seam() {
    for (surface, is_closed) in all_surfaces() {
        assert_eq!(surface.mesh_at((4, 9), 0.0).0.is_closed_in_v, is_closed, "{}", surface.name);
    }
}

#[test]
fn euler_characteristic_of_a_ring_is_zero_and_of_a_sheet_one() {
    for (surface, is_closed) in all_surfaces() {
        let (mesh, _) = surface.mesh_at((4, 9), 0.0);
        assert_eq!(euler_characteristic(&mesh), if is_closed { 0 } else { 1 }, "{}", surface.name);
        assert_eq!(boundary_edges(&mesh), if is_closed { 2 * 9 } else { 2 * (4 + 9) }, "{}", surface.name);
    }
}

#[test]
fn every_edge_belongs_to_one_quad_in_each_direction_and_every_index_is_in_range() {
    for (surface, _) in all_surfaces() {
        for cells in [(1, 1), (1, 2), (1, 3), (2, 4), (5, 7)] {
            let (mesh, _) = surface.mesh_at(cells, 0.0);
            assert!(mesh.quads.iter().flatten().all(|&index| (index as usize) < mesh.positions.len()));
            assert!(directed_edges(&mesh).values().all(|&count| count == 1), "{} {cells:?}", surface.name);
        }
    }
}

#[test]
fn ring_of_two_quads_stays_open() {
    // Welded, the two quads would share both their sides, and their rims would be edges of one direction each.
    assert!(!CYLINDER.mesh((3, 2)).is_closed_in_v);
    assert!(CYLINDER.mesh((3, 3)).is_closed_in_v);
}

#[test]
fn cylinder_normals_equal_the_closed_form() {
    assert_normals(&CYLINDER, |_, v| [v.cos(), -v.sin(), 0.0]);
}

#[test]
fn torus_normals_equal_the_closed_form() {
    assert_normals(&TORUS_PATCH, |u, v| [-u.cos() * v.cos(), -u.cos() * v.sin(), -u.sin()]);
}

#[test]
fn plane_normals_are_exact() {
    assert!(PLANE.mesh((5, 4)).normals.iter().all(|&normal| normal == [0.0, 0.0, 1.0]));
}

#[test]
fn every_normal_has_unit_length() {
    for (surface, _) in all_surfaces() {
        for normal in surface.mesh_at((6, 11), 0.0).0.normals {
            // Three squares, two sums, a root and three quotients: under 4 EPSILON.
            assert!((length(normal) - 1.0).abs() <= 4.0 * f64::EPSILON, "{}", surface.name);
        }
    }
}

#[test]
fn quads_turn_counter_clockwise_about_their_normals() {
    for surface in [&CYLINDER, &HALF_CYLINDER, &TORUS_PATCH, &PLANE, &CONE, &MOEBIUS] {
        let mesh = surface.mesh((6, 24));
        for &quad in &mesh.quads {
            for (corner, index) in corner_area_vectors(&mesh, quad).into_iter().zip(quad) {
                // Zero only at the two corners of a quad that share a pole.
                let agreement = dot(corner, mesh.normals[index as usize]);
                assert!(agreement > 0.0 || length(corner) < 1e-15, "{} {quad:?}", surface.name);
            }
        }
    }
}

#[test]
fn welded_seam_uses_the_vertices_of_the_first_column() {
    let mesh = CYLINDER.mesh((2, 5));
    for (row, strip) in mesh.quads.chunks(5).enumerate() {
        let (first, last) = (strip[0], strip[4]);
        assert_eq!((last[3], last[2]), (first[0], first[1]), "row {row}");
    }
    assert!(mesh.uv.iter().all(|&[_, v]| v < CYLINDER.v[1]), "the last column is not stored");
}

#[test]
fn closed_surface_far_from_the_origin_is_welded_over_a_rounding_of_its_coordinates() {
    let far = Analytic {
        name: "far cylinder",
        jet: |u, v, t| {
            let [[x, y, z], tangent_u, tangent_v] = (CYLINDER.jet)(u, v, t);
            // At 1e9 neighbouring doubles lie 1.2e-7 apart: 1e4 times what is tolerated near the origin.
            let x = if v < 6.0 { x + 1e9 } else { (x + 1e9).next_up() };
            [[x, y, z], tangent_u, tangent_v]
        },
        ..CYLINDER
    };
    assert!(far.mesh((2, 6)).is_closed_in_v);
}

#[test]
fn sides_that_meet_only_at_the_grid_nodes_are_not_welded() {
    let rippled = Analytic {
        name: "rippled cylinder",
        jet: |u, v, t| {
            let [[x, y, z], [a, b, c], [d, e, f]] = (CYLINDER.jet)(u, v, t);
            // Grows with v, and vanishes at u = 0, 1/4, 1/2, 3/4 and 1.
            let (sin, cos) = (4.0 * PI * u).sin_cos();
            [[x, y, z + 0.1 * v * sin], [a, b, c + 0.4 * PI * v * cos], [d, e, f + 0.1 * sin]]
        },
        ..CYLINDER
    };
    assert!(!rippled.mesh((4, 6)).is_closed_in_v);
}

#[test]
fn gap_of_a_millionth_of_the_patch_is_not_welded() {
    let spiral = Analytic {
        name: "spiral",
        jet: |u, v, t| {
            let [[x, y, z], tangent_u, [a, b, c]] = (CYLINDER.jet)(u, v, t);
            [[x, y, z + 1e-6 * v], tangent_u, [a, b, c + 1e-6]]
        },
        ..CYLINDER
    };
    assert!(!spiral.mesh((2, 6)).is_closed_in_v);
}

#[test]
fn moebius_sides_agree_only_when_flipped() {
    let mesh = MOEBIUS.mesh((4, 9));
    for i in 0..5 {
        let (first, last) = (mesh.positions[i * 10], mesh.positions[(4 - i) * 10 + 9]);
        // The test is about a strip that does close, though not as a ring.
        assert!(length(minus(first, last)) <= 2.0 * CLOSED_FORM_ROUNDING);
    }
}

#[test]
fn pole_takes_its_normals_from_the_faces_around_it() {
    let mesh = CONE.mesh((16, 64));
    for (normal, &[_, v]) in mesh.normals.iter().zip(&mesh.uv).take(64) {
        let exact = [-v.cos(), -v.sin(), 1.0].map(|x| x / 2f64.sqrt());
        // The faces beside v lie half a cell away on either side: their mean is off by about (half cell)^2 / 2 = 0.0012.
        assert!(length(minus(*normal, exact)) < 0.002, "at v = {v}");
    }
}

#[test]
fn pole_smeared_by_rounding_counts_as_a_pole() {
    let smeared = Analytic {
        name: "smeared cone",
        jet: |u, v, t| {
            let [position, tangent_u, [a, b, c]] = (CONE.jet)(u, v, t);
            [position, tangent_u, [a + 1e-17, b, c - 3e-17]]
        },
        ..CONE
    };
    let (exact, smeared) = (CONE.mesh((8, 16)), smeared.mesh((8, 16)));
    assert_eq!(smeared.normals[..16], exact.normals[..16]);
}

#[test]
fn segment_warns_once_with_the_count_of_arbitrary_normals() {
    let (mesh, warnings) = SEGMENT.mesh_at((2, 3), 0.0);
    assert!(mesh.normals.iter().all(|&normal| normal == [0.0, 0.0, 1.0]));
    assert_eq!(warnings.len(), 1);
    assert_eq!(warnings[0].code, Code::DegenerateNormals);
    assert_eq!(warnings[0].message, "`segment` has no normal at 12 of 12 vertices; they are given (0, 0, 1)");
}

#[test]
fn cylinder_of_any_size_has_the_same_normals() {
    for (name, jet) in [
        ("huge", (|u, v, t| (CYLINDER.jet)(u, v, t).map(|x| x.map(|x| x * 1e300))) as fn(f64, f64, f64) -> _),
        ("tiny", |u, v, t| (CYLINDER.jet)(u, v, t).map(|x| x.map(|x| x * 1e-300))),
    ] {
        let scaled = Analytic { name, jet, ..CYLINDER }.mesh((2, 8));
        assert!(scaled.is_closed_in_v, "{name}");
        for (normal, exact) in scaled.normals.iter().zip(CYLINDER.mesh((2, 8)).normals) {
            assert!(length(minus(*normal, exact)) <= CLOSED_FORM_ROUNDING, "{name}");
        }
    }
}

#[test]
fn cylinder_area_converges_at_second_order() {
    let exact = 2.0 * std::f64::consts::TAU;
    let errors = [16, 32, 64, 128].map(|cells| (exact - area(&CYLINDER.mesh((2, cells)))).abs());
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        // The next term of the error is (pi / 16)^2 / 20 = 0.002 of the first at the coarsest grid: 0.003 in the order.
        assert!((order - 2.0).abs() < 0.01, "order {order}, errors {errors:?}");
    }
}

#[test]
fn vertices_lie_on_the_surface_at_the_instant_asked_for() {
    let (mesh, _) = CYLINDER.mesh_at((2, 7), 0.5);
    for (position, &[u, v]) in mesh.positions.iter().zip(&mesh.uv) {
        assert_eq!(*position, (CYLINDER.jet)(u, v, 0.5)[0]);
    }
}

#[test]
fn rims_lie_exactly_at_the_ends_of_the_ranges() {
    let mesh = Analytic { u: [0.1, 0.7], v: [0.3, 1.9], ..PLANE }.mesh((7, 13));
    assert_eq!((mesh.uv[0], mesh.uv[7 * 14 + 13]), ([0.1, 0.3], [0.7, 1.9]));
}

#[test]
fn equal_surfaces_give_equal_meshes() {
    for (surface, _) in all_surfaces() {
        assert_eq!(surface.mesh_at((5, 9), 0.25), surface.mesh_at((5, 9), 0.25), "{}", surface.name);
    }
}

fn refusal(surface: &dyn Surface, ranges: ([f64; 2], [f64; 2]), t: f64) -> Diagnostic {
    let grid = Grid::new(2, 2, &Limits::default()).expect("a small grid");
    tessellate("cup", surface, ranges, t, grid).expect_err("must be refused")
}

#[test]
fn range_without_extent_is_refused() {
    for empty in [[1.0, 1.0], [1.0, 0.0], [0.0, f64::NAN], [f64::NEG_INFINITY, 0.0]] {
        assert_eq!(refusal(&PLANE, (empty, [0.0, 1.0]), 0.0).code, Code::EmptyDomain);
        assert_eq!(refusal(&PLANE, ([0.0, 1.0], empty), 0.0).code, Code::EmptyDomain);
    }
}

#[test]
fn instant_that_is_not_finite_is_refused() {
    assert_eq!(refusal(&PLANE, ([0.0, 1.0], [0.0, 1.0]), f64::NAN).code, Code::SettingOutOfRange);
}

#[test]
fn value_not_finite_that_the_surface_keeps_silent_about_is_an_error() {
    let surface = Analytic { jet: |u, v, _| [[1.0 / u, v, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], ..PLANE };
    let refused = refusal(&surface, ([-1.0, 1.0], [0.0, 1.0]), 0.0);
    assert_eq!(refused.code, Code::SolutionNotFinite);
    assert_eq!(refused.message, "the position of `cup` is not finite at u = 0, v = 0, t = 0");
}

#[test]
fn error_of_the_surface_is_passed_on() {
    struct Undefined;
    impl Surface for Undefined {
        fn evaluate(&self, _: Derivative, _: &[[f64; 3]], _: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
            Err(Diagnostic::new(Code::NotDifferentiable, "no derivative of |u|"))
        }
    }
    assert_eq!(refusal(&Undefined, ([0.0, 1.0], [0.0, 1.0]), 0.0).message, "no derivative of |u|");
}
