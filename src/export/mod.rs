//! Writes a [`Scene`] of meshes, or B-spline surfaces, in the formats other programs read.
//!
//! Input: a scene; output: the bytes of one file, in any [`Write`]. [`Format`] is the registry: a new format is
//! one file with a `ROW`, and one line here. B-splines go through [`write_cad`].
//!
//! Invariant: the scene is checked before the first byte, so what is written is finite and its indices are in
//! range, and equal scenes give equal bytes.
//!
//! Absent on purpose: paths and files (the caller makes a file complete or absent), the time of day, and
//! anything that a format cannot say and would need a second file for.

mod cad;
mod error;
mod name;
mod obj;
mod ply;
mod stl;

pub use cad::{CadFormat, Face, Schema, write_cad};
pub use error::ExportError;

use std::io::{BufWriter, Write};

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

/// A mesh file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY, binary.
    Ply,
    /// STL, binary.
    Stl,
}

/// What one format file declares about itself.
struct Row {
    name: &'static str,
    extension: &'static str,
    description: &'static str,
    write: fn(&Scene, &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError>,
}

impl Format {
    /// Every format, in the order help texts list them.
    pub const ALL: &[Format] = &[Format::Obj, Format::Ply, Format::Stl];

    fn row(self) -> &'static Row {
        match self {
            Format::Obj => &obj::ROW,
            Format::Ply => &ply::ROW,
            Format::Stl => &stl::ROW,
        }
    }

    /// The format whose files end in `extension`, in any case and without the dot.
    #[must_use]
    pub fn from_extension(extension: &str) -> Option<Format> {
        Format::ALL.iter().copied().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }

    /// What people call it, for example `OBJ`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The end of its files' names, in lower case and without the dot.
    #[must_use]
    pub fn extension(self) -> &'static str {
        self.row().extension
    }

    /// What it keeps of a scene, in one line.
    #[must_use]
    pub fn description(self) -> &'static str {
        self.row().description
    }
}

/// Writes `scene` to `out`; writes are buffered here, and flushed.
///
/// Returns a warning, [`Code::PrecisionLost`](crate::diagnostic::Code::PrecisionLost), when the format could not
/// hold all of it.
///
/// # Errors
/// [`ExportError::Io`] when `out` fails, after any number of bytes; every other error before the first byte.
pub fn write(scene: &Scene, format: Format, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    scene.meshes.iter().try_for_each(check)?;
    let mut out = BufWriter::new(out);
    let warnings = (format.row().write)(scene, &mut out)?;
    out.flush()?;
    Ok(warnings)
}

/// Meshes are plain data and may come from anywhere; a file that breaks its readers must not come of one.
fn check(mesh: &Mesh) -> Result<(), ExportError> {
    let vertices = mesh.positions.len();
    let malformed = |fault: &'static str, at: usize| ExportError::Malformed { mesh: mesh.name.clone(), fault, at };
    if mesh.normals.len() != vertices {
        return Err(malformed("not one normal per vertex: as many as", mesh.normals.len()));
    }
    if mesh.uv.len() != vertices {
        return Err(malformed("not one (u, v) per vertex: as many as", mesh.uv.len()));
    }
    let is_finite = |at: &usize| {
        let numbers = [mesh.positions.get(*at), mesh.normals.get(*at)].into_iter().flatten().flatten();
        numbers.chain(mesh.uv.get(*at).into_iter().flatten()).all(|x| x.is_finite())
    };
    if let Some(at) = (0..vertices).find(|at| !is_finite(at)) {
        return Err(malformed("a number that is not finite at vertex", at));
    }
    match mesh.quads.iter().position(|quad| quad.iter().any(|&index| index as usize >= vertices)) {
        Some(at) => Err(malformed("an index without a vertex in quad", at)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit_square() -> Mesh {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        Mesh {
            name: "square".to_owned(),
            positions: corners.iter().map(|&[x, y]| [x, y, 0.0]).collect(),
            normals: vec![[0.0, 0.0, 1.0]; 4],
            uv: corners.to_vec(),
            quads: vec![[0, 1, 2, 3]],
            is_closed_in_v: false,
        }
    }

    fn refusal(change: impl Fn(&mut Mesh)) -> String {
        let mut mesh = unit_square();
        change(&mut mesh);
        let scene = Scene { meshes: vec![mesh], time: 0.0 };
        for &format in Format::ALL {
            let mut bytes = Vec::new();
            assert!(write(&scene, format, &mut bytes).is_err());
            assert!(bytes.is_empty(), "{} was begun", format.name());
        }
        write(&scene, Format::Obj, &mut Vec::new()).unwrap_err().to_string()
    }

    #[test]
    fn every_extension_leads_back_to_its_format() {
        for &format in Format::ALL {
            assert_eq!(Format::from_extension(format.extension()), Some(format));
            assert_eq!(Format::from_extension(&format.extension().to_uppercase()), Some(format));
        }
        assert_eq!(Format::from_extension("dwg"), None);
    }

    #[test]
    fn mesh_with_index_out_of_range_is_refused() {
        assert_eq!(refusal(|mesh| mesh.quads[0][2] = 4), "mesh `square` has an index without a vertex in quad 0");
    }

    #[test]
    fn mesh_with_a_number_not_finite_is_refused() {
        let message = "mesh `square` has a number that is not finite at vertex 3";
        assert_eq!(refusal(|mesh| mesh.positions[3][1] = f64::NAN), message);
        assert_eq!(refusal(|mesh| mesh.normals[3][0] = f64::INFINITY), message);
        assert_eq!(refusal(|mesh| mesh.uv[3][0] = f64::NEG_INFINITY), message);
    }

    #[test]
    fn mesh_with_missing_normals_or_parameters_is_refused() {
        assert_eq!(
            refusal(|mesh| mesh.normals.truncate(3)),
            "mesh `square` has not one normal per vertex: as many as 3"
        );
        assert_eq!(refusal(|mesh| mesh.uv.clear()), "mesh `square` has not one (u, v) per vertex: as many as 0");
    }
}
