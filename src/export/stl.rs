//! Binary STL: triangles of 32-bit floats without shared vertices, written by `stl_io`.
//!
//! Corners of one vertex come out bit for bit equal, so a reader that merges equal corners gets the mesh back.

use std::io::Write;

use stl_io::{Normal, Triangle, Vertex};

use crate::diagnostic::{Code, Diagnostic};
use crate::tessellate::{Mesh, Scene};

use super::error::count_of;
use super::single::in_single_precision;
use super::triangles::triangles;
use super::{Content, ExportError, Row};

pub(super) const ROW: Row = Row {
    name: "STL",
    extension: "stl",
    description: "binary; triangles in single precision, all patches in one mesh; for printing",
    content: Content::Still(write),
    holds_fields: false,
    is_single: true,
};

fn write(scene: &Scene, mut out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    let mut facets = Vec::new();
    let mut lost = 0;
    for mesh in &scene.meshes {
        let rounded = rounded(mesh)?;
        let corner = |index: u32| mesh.positions.get(index as usize).zip(rounded.get(index as usize));
        for triangle in triangles(mesh) {
            let [Some(a), Some(b), Some(c)] = triangle.map(corner) else { continue };
            match facet([a, b, c].map(|(_, rounded)| *rounded)) {
                Some(facet) => facets.push(facet),
                // A pole has triangles without area from the start: leaving them out loses nothing.
                None if has_coinciding_corners([a, b, c].map(|(exact, _)| exact)) => {}
                None => lost += 1,
            }
        }
    }
    if let (true, 0, Some(mesh)) = (facets.is_empty(), lost, scene.meshes.iter().find(|mesh| !mesh.quads.is_empty())) {
        return Err(ExportError::NoArea { name: mesh.name.clone() });
    }
    // stl_io would store the count modulo 2^32.
    count_of(ROW.name, "triangles", facets.len())?;
    stl_io::write_stl(&mut out, facets.iter())?;
    Ok(if lost == 0 { Vec::new() } else { vec![precision_lost(lost)] })
}

fn precision_lost(triangles: usize) -> Diagnostic {
    let subject = if triangles == 1 { "1 triangle is" } else { &format!("{triangles} triangles are") };
    Diagnostic::new(
        Code::PrecisionLost,
        format!("{subject} left out of the STL file: in single precision nothing remains of the area"),
    )
    .hint("choose a coarser grid, move the surface nearer to the origin, or write OBJ or PLY")
}

/// The positions as STL holds them.
fn rounded(mesh: &Mesh) -> Result<Vec<[f32; 3]>, ExportError> {
    // Adding zero turns -0 into 0, which readers that compare bits would keep apart.
    Ok(in_single_precision(ROW.name, mesh)?.into_iter().map(|position| position.map(|x| x + 0.0)).collect())
}

/// The triangle with its own unit normal, or `None` without area.
fn facet(corners: [[f32; 3]; 3]) -> Option<Triangle> {
    let [a, b, c] = corners.map(|corner| corner.map(f64::from));
    let ([ux, uy, uz], [vx, vy, vz]) = (minus(b, a), minus(c, a));
    let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    // Neither overflows nor vanishes early: f32 spans 1e-45 to 3e38, and the fourth power of that fits a double.
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0).then(|| Triangle {
        normal: Normal::new(normal.map(|x| (x / length) as f32)),
        vertices: corners.map(Vertex::new),
    })
}

fn has_coinciding_corners([a, b, c]: [&[f64; 3]; 3]) -> bool {
    a == b || b == c || c == a
}

fn minus([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ax - bx, ay - by, az - bz]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(positions: Vec<[f64; 3]>) -> Result<(stl_io::IndexedMesh, Vec<Diagnostic>), ExportError> {
        let mesh = Mesh { name: "quad".to_owned(), positions, quads: vec![[0, 1, 2, 3]], ..Mesh::default() };
        let mut bytes = Vec::new();
        let warnings = write(&Scene { meshes: vec![mesh], time: 0.0 }, &mut bytes)?;
        Ok((stl_io::read_stl(&mut std::io::Cursor::new(bytes)).unwrap(), warnings))
    }

    fn flat_quad(corners: [[f64; 2]; 4]) -> Vec<[f64; 3]> {
        corners.iter().map(|&[x, y]| [x, y, 0.0]).collect()
    }

    #[test]
    fn both_halves_keep_the_orientation_of_the_quad() {
        for quad in
            [[[-2.0, 0.0], [0.0, -1.0], [2.0, 0.0], [0.0, 1.0]], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]]
        {
            let (mesh, warnings) = written(flat_quad(quad)).unwrap();
            assert!(mesh.faces.iter().all(|face| face.normal.0 == [0.0, 0.0, 1.0]));
            assert_eq!((mesh.faces.len(), warnings.len()), (2, 0));
        }
    }

    #[test]
    fn coordinate_beyond_single_precision_is_an_error() {
        let quad = |size: f64| flat_quad([[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]]);
        assert!(written(quad(3.4e38)).is_ok());
        let refused = written(quad(1e39)).unwrap_err();
        assert_eq!(refused.to_string(), "STL holds coordinates up to 3.4028234663852886e38, and mesh `quad` has 1e39");
        assert_eq!(refused.to_diagnostic().code, Code::FormatCannotHold);
    }

    #[test]
    fn triangles_lost_to_single_precision_are_counted() {
        // f32 resolves 6e-5 at 1000, so the quad becomes a line.
        let (mesh, warnings) =
            written(flat_quad([[0.0, 1000.0], [1.0, 1000.0], [1.0, 1000.0 + 1e-9], [0.0, 1000.0 + 1e-9]])).unwrap();
        assert!(mesh.faces.is_empty());
        assert_eq!(warnings.len(), 1);
        assert_eq!(warnings[0].code, Code::PrecisionLost);
        assert!(warnings[0].message.starts_with("2 triangles are left out"), "{}", warnings[0].message);
    }

    #[test]
    fn pole_triangle_is_left_out_without_a_warning() {
        let (mesh, warnings) = written(flat_quad([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]])).unwrap();
        assert_eq!((mesh.faces.len(), warnings.len()), (1, 0));
    }

    #[test]
    fn scene_without_any_area_is_refused() {
        let refused = written(flat_quad([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 0.0]])).unwrap_err();
        assert_eq!(refused.to_string(), "`quad` has no area: it has shrunk to a curve or a point");
        assert_eq!(refused.to_diagnostic().code, Code::NoArea);
    }

    #[test]
    fn negative_zero_is_written_as_zero() {
        let (mesh, _) = written(flat_quad([[-0.0, -0.0], [1.0, 0.0], [1.0, 1.0], [-0.0, 1.0]])).unwrap();
        assert_eq!(mesh.vertices.len(), 4);
        assert!(mesh.vertices.iter().flat_map(|vertex| vertex.0).all(|x| x.to_bits() != (-0.0f32).to_bits()));
    }
}
