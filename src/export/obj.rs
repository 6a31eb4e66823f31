//! Wavefront OBJ: text, quads, every number with as many digits as bring back the same double.

use std::fmt;
use std::io::Write;

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

use super::name::on_one_line;
use super::{ExportError, Row};

pub(super) const ROW: Row = Row {
    name: "OBJ",
    extension: "obj",
    description: "text; quads, normals, (u, v) and patch names; coordinates exact to the last digit",
    write,
};

fn write(scene: &Scene, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    writeln!(out, "# trimline {}, t = {}", env!("CARGO_PKG_VERSION"), Exact(scene.time))?;
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
        writeln!(out, "v {} {} {}", Exact(*x), Exact(*y), Exact(*z))?;
    }
    for [u, v] in &mesh.uv {
        writeln!(out, "vt {} {}", Exact(*u), Exact(*v))?;
    }
    for [x, y, z] in &mesh.normals {
        writeln!(out, "vn {} {} {}", Exact(*x), Exact(*y), Exact(*z))?;
    }
    for quad in &mesh.quads {
        let [a, b, c, d] = quad.map(|index| first + index as usize);
        writeln!(out, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c} {d}/{d}/{d}")?;
    }
    Ok(())
}

/// The shortest decimal that reads back to the same double, in whichever notation stays short.
struct Exact(f64);

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        // Rust's plain notation never uses an exponent: 1e300 would take 301 digits.
        if size == 0.0 || (1e-5..1e17).contains(&size) { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_short_as_they_read_back() {
        let written = |x: f64| Exact(x).to_string();
        assert_eq!(written(0.1), "0.1");
        assert_eq!(written(1.0), "1");
        assert_eq!(written(-0.0), "-0");
        assert_eq!(written(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(written(1e300), "1e300");
        assert_eq!(written(-2.5e-9), "-2.5e-9");
    }

    #[test]
    fn awkward_numbers_read_back_bit_for_bit() {
        let awkward = [f64::MIN_POSITIVE, 5e-324, f64::MAX, 1.0 / 3.0, 1e-5, 9.999999999999999e-6, 1e17, 2f64.powi(60)];
        for x in awkward.into_iter().flat_map(|x| [x, -x]) {
            let read: f64 = Exact(x).to_string().parse().unwrap();
            assert_eq!(read.to_bits(), x.to_bits(), "{x:e}");
        }
    }
}
