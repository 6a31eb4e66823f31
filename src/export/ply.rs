//! Stanford PLY: a header of ASCII lines, then little-endian doubles and quads.

use std::io::Write;

use crate::diagnostic::Diagnostic;
use crate::tessellate::Scene;

use super::error::count_of;
use super::name::in_ascii;
use super::{Content, ExportError, Row};

pub(super) const ROW: Row = Row {
    name: "PLY",
    extension: "ply",
    description: "binary; quads, normals, (u, v) and fields in double precision, all patches in one mesh",
    content: Content::Still(write),
    holds_fields: true,
    is_single: false,
};

/// The properties of a vertex, in the order they are written.
const VERTEX_PROPERTIES: [&str; 8] = ["x", "y", "z", "nx", "ny", "nz", "u", "v"];

fn write(scene: &Scene, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    let vertices = count_of(ROW.name, "vertices", scene.meshes.iter().map(|mesh| mesh.positions.len()).sum())?;
    let quads = count_of(ROW.name, "faces", scene.meshes.iter().map(|mesh| mesh.quads.len()).sum())?;
    writeln!(out, "ply\nformat binary_little_endian 1.0")?;
    writeln!(out, "comment trimline {}, t = {:e}", env!("CARGO_PKG_VERSION"), scene.time)?;
    for mesh in &scene.meshes {
        writeln!(out, "comment patch {}: {} vertices", in_ascii(&mesh.name), mesh.positions.len())?;
    }
    writeln!(out, "element vertex {vertices}")?;
    let fields = scene.meshes.first().into_iter().flat_map(|mesh| &mesh.fields).map(|field| field.name);
    for property in VERTEX_PROPERTIES.into_iter().chain(fields) {
        writeln!(out, "property double {property}")?;
    }
    writeln!(out, "element face {quads}\nproperty list uchar uint vertex_indices\nend_header")?;
    for mesh in &scene.meshes {
        for (vertex, ((position, normal), uv)) in mesh.positions.iter().zip(&mesh.normals).zip(&mesh.uv).enumerate() {
            let fields = mesh.fields.iter().filter_map(|field| field.values.get(vertex));
            for number in position.iter().chain(normal).chain(uv).chain(fields) {
                out.write_all(&number.to_le_bytes())?;
            }
        }
    }
    let mut first = 0;
    for mesh in &scene.meshes {
        for quad in &mesh.quads {
            out.write_all(&[4])?;
            for index in quad {
                out.write_all(&(first + index).to_le_bytes())?;
            }
        }
        // No overflow: the sum over all meshes was counted above.
        first += count_of(ROW.name, "vertices", mesh.positions.len())?;
    }
    Ok(Vec::new())
}
