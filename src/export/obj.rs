//! Wavefront OBJ: text, quads, every number with as many digits as bring back the same double.

use std::io::Write;

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

use super::name::on_one_line;
use super::{Content, ExportError, Row};
use crate::diagnostic::Shortest;

pub(super) const ROW: Row = Row {
    name: "OBJ",
    extension: "obj",
    description: "text; quads, normals, (u, v) and patch names; coordinates exact to the last digit",
    content: Content::Still(write),
    holds_fields: false,
    is_single: false,
};

fn write(scene: &Scene, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    writeln!(out, "# trimline {}, t = {}", env!("CARGO_PKG_VERSION"), Shortest(scene.time))?;
    // OBJ numbers vertices from 1, through the whole file.
    let mut first = 1;
    for mesh in &scene.meshes {
        write_mesh(mesh, first, out)?;
        first += mesh.positions.len();
    }
    Ok(Vec::new())
}

fn write_mesh(mesh: &Mesh, first: usize, out: &mut dyn Write) -> Result<(), ExportError> {
    writeln!(out, "o {}", on_one_line(&mesh.name))?;
    for [x, y, z] in &mesh.positions {
        writeln!(out, "v {} {} {}", Shortest(*x), Shortest(*y), Shortest(*z))?;
    }
    for [u, v] in &mesh.uv {
        writeln!(out, "vt {} {}", Shortest(*u), Shortest(*v))?;
    }
    for [x, y, z] in &mesh.normals {
        writeln!(out, "vn {} {} {}", Shortest(*x), Shortest(*y), Shortest(*z))?;
    }
    for quad in &mesh.quads {
        let [a, b, c, d] = quad.map(|index| first + index as usize);
        writeln!(out, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c} {d}/{d}/{d}")?;
    }
    Ok(())
}
