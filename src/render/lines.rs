//! Lines on surfaces: trimlines, open edges, borders of deformations, lines of constant parameters.

use crate::tessellate::{Mesh, Role, Scene};

use super::camera::View;
use super::canvas::{Point, SAMPLES};
use super::color::{GRID_LINE, Rgb, TRIMLINE};

/// Half the widths of lines in samples.
const HALF_TRIMLINE: f64 = 0.85 * SAMPLES as f64;
const HALF_LINE: f64 = 0.4 * SAMPLES as f64;

/// How much nearer than its surface a line is drawn, in units of half the scene's longest side: enough to be seen on
/// it, too little to be seen through it.
const LIFT: f64 = 0.006;

/// The lines of a scene as flat triangles, with the colour of each.
pub(super) fn strokes(scene: &Scene, view: &View, parts: Option<(usize, usize)>) -> Vec<(Vec<[Point; 3]>, Rgb)> {
    let mut strokes = Vec::new();
    for mesh in &scene.meshes {
        let places: Vec<[f64; 3]> = mesh.positions.iter().map(|position| view.place(position)).collect();
        let rows: Vec<&[[f64; 3]]> = places.chunks(mesh.columns.max(1)).collect();
        if let Some((across, along)) = parts {
            let lines = inner_lines(mesh, &rows, across, along);
            strokes.push((lines.iter().flat_map(|line| stroke(line, HALF_LINE)).collect(), GRID_LINE));
        }
        if mesh.role == Role::Primary {
            continue;
        }
        if !mesh.is_closed_in_v {
            let sides = [0, mesh.columns.saturating_sub(1)].map(|column| column_of(&rows, column));
            strokes.push((sides.iter().flat_map(|line| stroke(line, HALF_LINE)).collect(), GRID_LINE));
        }
        let outlines = mesh.outlines.iter().map(|line| line.iter().map(|point| view.place(point)).collect::<Vec<_>>());
        strokes.push((outlines.flat_map(|line| stroke(&line, HALF_LINE)).collect(), GRID_LINE));
        let ends = [rows.first(), rows.last()].map(|row| row_of(mesh, row.copied().unwrap_or_default()));
        strokes.push((ends.iter().flat_map(|line| stroke(line, HALF_TRIMLINE)).collect(), TRIMLINE));
    }
    strokes
}

/// Lines of constant u between the trimlines, and of constant v: the nearest to equal parts that the mesh has.
fn inner_lines(mesh: &Mesh, rows: &[&[[f64; 3]]], across: usize, along: usize) -> Vec<Vec<[f64; 3]>> {
    let nearest =
        |part: usize, parts: usize, cells: usize| libm::round(part as f64 * cells as f64 / parts as f64) as usize;
    let cells = rows.len().saturating_sub(1);
    // More lines than the mesh has would only repeat.
    let of_u = (1..across.min(cells)).map(|part| nearest(part, across.min(cells), cells));
    let columns = if mesh.is_closed_in_v { mesh.columns } else { mesh.columns.saturating_sub(1) };
    let of_v =
        (usize::from(!mesh.is_closed_in_v)..along.min(columns)).map(|part| nearest(part, along.min(columns), columns));
    let lines_of_u = of_u.filter_map(|row| rows.get(row)).map(|row| row_of(mesh, row));
    lines_of_u.chain(of_v.map(|column| column_of(rows, column))).collect()
}

fn row_of(mesh: &Mesh, row: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let back_to_start = row.first().filter(|_| mesh.is_closed_in_v);
    row.iter().chain(back_to_start).copied().collect()
}

fn column_of(rows: &[&[[f64; 3]]], column: usize) -> Vec<[f64; 3]> {
    rows.iter().filter_map(|row| row.get(column)).copied().collect()
}

/// A line of points as triangles, two for each piece and two to fill the corner at its end.
fn stroke(line: &[[f64; 3]], half_width: f64) -> Vec<[Point; 3]> {
    let mut triangles = Vec::new();
    for pair in line.windows(2) {
        let [[ax, ay, a_depth], [bx, by, b_depth]] = pair else { continue };
        let (dx, dy) = (bx - ax, by - ay);
        let length = libm::hypot(dx, dy);
        // A piece seen from its end, or one of no length, is covered by its neighbours.
        if length == 0.0 || !length.is_finite() {
            continue;
        }
        let (along_x, along_y) = (dx / length * half_width, dy / length * half_width);
        let corner = |x: f64, y: f64, depth: f64, along: f64, aside: f64| Point {
            place: [x + along * along_x - aside * along_y, y + along * along_y + aside * along_x, depth + LIFT],
            ..Point::default()
        };
        let (start, end) = ([*ax, *ay, *a_depth], [*bx, *by, *b_depth]);
        let at = |[x, y, depth]: [f64; 3], along, aside| corner(x, y, depth, along, aside);
        let (a, b, c, d) = (at(start, 0.0, 1.0), at(start, 0.0, -1.0), at(end, 0.0, 1.0), at(end, 0.0, -1.0));
        triangles.extend([[a, b, c], [b, c, d]]);
        // Half a hexagon beyond each end, so that the pieces of a bent line join.
        for (end, sense) in [(start, -1.0), (end, 1.0)] {
            let (p, q) = (at(end, 0.87 * sense, 0.5), at(end, 0.87 * sense, -0.5));
            let (r, s) = (at(end, 0.0, 1.0), at(end, 0.0, -1.0));
            triangles.extend([[r, p, q], [r, q, s]]);
        }
    }
    triangles
}
