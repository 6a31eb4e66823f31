//! Writes a [`Scene`] of meshes, or B-spline surfaces, in the formats other programs read.
//!
//! Input: a scene, or the scenes of an animation; output: the bytes of one file, in any [`Write`]. [`Format`] is the
//! registry: a new format is one file with a `ROW`, and one variant here. B-splines go through [`write_cad`].
//!
//! Invariant: the scene is checked before the first byte, so what is written is finite and its indices are in
//! range, and equal scenes give equal bytes.
//!
//! Absent on purpose: paths and files (the caller makes a file complete or absent), the time of day, and
//! anything that a format cannot say and would need a second file for.

mod cad;
mod error;
#[cfg(feature = "formats")]
mod glb;
mod name;
#[cfg(feature = "formats")]
mod npz;
mod obj;
mod ply;
mod single;
mod stl;
#[cfg(feature = "formats")]
mod threemf;
mod triangles;
mod usda;
#[cfg(feature = "formats")]
mod vtp;
#[cfg(feature = "formats")]
mod zipped;

pub use cad::{CadFormat, Face, Schema, write_cad};
pub use error::ExportError;
#[cfg(feature = "formats")]
pub use vtp::write_pvd;

use std::io::{BufWriter, Write};

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

/// A file format. Those behind the feature `formats` take a library to write.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY, binary.
    Ply,
    /// STL, binary.
    Stl,
    /// glTF 2.0 in its binary container.
    #[cfg(feature = "formats")]
    Glb,
    /// Universal Scene Description as text.
    Usda,
    /// 3D Manufacturing Format.
    #[cfg(feature = "formats")]
    ThreeMf,
    /// VTK polygonal data.
    #[cfg(feature = "formats")]
    Vtp,
    /// NumPy arrays.
    #[cfg(feature = "formats")]
    Npz,
}

/// What one format file declares about itself.
struct Row {
    name: &'static str,
    extension: &'static str,
    description: &'static str,
    content: Content,
    /// Whether it keeps [`Mesh::fields`].
    holds_fields: bool,
    /// Whether positions end up in 32-bit floats, in the file or in every reader of it.
    is_single: bool,
}

/// What one file of a format holds, and the function that writes it.
enum Content {
    Still(fn(&Scene, &mut dyn Write) -> Written),
    Animation(fn(&[Scene], &mut dyn Write) -> Written),
}

/// What there is to say about a file that was written.
type Written = Result<Vec<Diagnostic>, ExportError>;

impl Format {
    /// Every format, in the order help texts list them.
    pub const ALL: &[Format] = &[
        Format::Obj,
        Format::Ply,
        Format::Stl,
        #[cfg(feature = "formats")]
        Format::Glb,
        Format::Usda,
        #[cfg(feature = "formats")]
        Format::ThreeMf,
        #[cfg(feature = "formats")]
        Format::Vtp,
        #[cfg(feature = "formats")]
        Format::Npz,
    ];

    fn row(self) -> &'static Row {
        match self {
            Format::Obj => &obj::ROW,
            Format::Ply => &ply::ROW,
            Format::Stl => &stl::ROW,
            #[cfg(feature = "formats")]
            Format::Glb => &glb::ROW,
            Format::Usda => &usda::ROW,
            #[cfg(feature = "formats")]
            Format::ThreeMf => &threemf::ROW,
            #[cfg(feature = "formats")]
            Format::Vtp => &vtp::ROW,
            #[cfg(feature = "formats")]
            Format::Npz => &npz::ROW,
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

    /// Whether one file holds all instants of an animation; otherwise each instant is a file.
    #[must_use]
    pub fn is_animated(self) -> bool {
        matches!(self.row().content, Content::Animation(_))
    }

    /// Whether it keeps [`Mesh::fields`].
    #[must_use]
    pub fn holds_fields(self) -> bool {
        self.row().holds_fields
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
/// As [`write_frames`].
pub fn write(scene: &Scene, format: Format, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    write_frames(std::slice::from_ref(scene), format, out)
}

/// Writes the instants of an animation, in ascending order, into one file; otherwise as [`write()`].
///
/// # Errors
/// [`ExportError::Io`] when `out` fails, after any number of bytes; every other error before the first byte:
/// scenes that are not meshes, several for a format that holds one, frames that are not the same meshes.
pub fn write_frames(frames: &[Scene], format: Format, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    frames.iter().flat_map(|scene| &scene.meshes).try_for_each(check)?;
    let not_one = ExportError::NotOneInstant { format: format.name(), count: frames.len() };
    let Some(first) = frames.first() else { return Err(not_one) };
    let mut out = BufWriter::new(out);
    let mut warnings = match format.row().content {
        Content::Still(write) if frames.len() == 1 => write(first, &mut out)?,
        Content::Still(_) => return Err(not_one),
        Content::Animation(write) => {
            frames.iter().try_for_each(|frame| check_continues(first, frame))?;
            write(frames, &mut out)?
        }
    };
    if format.row().is_single {
        warnings.extend(single::precision_warning(format.name(), frames));
    }
    out.flush()?;
    Ok(warnings)
}

/// Whether `frame` shows the meshes of `first`, moved.
fn check_continues(first: &Scene, frame: &Scene) -> Result<(), ExportError> {
    let field_names = |mesh: &Mesh| mesh.fields.iter().map(|field| field.name).collect::<Vec<_>>();
    let differs = |mesh: &String| ExportError::TopologyChanges { mesh: mesh.clone(), time: frame.time };
    for (before, now) in first.meshes.iter().zip(&frame.meshes) {
        let is_same = before.quads == now.quads
            && before.positions.len() == now.positions.len()
            && before.columns == now.columns
            && field_names(before) == field_names(now);
        if !is_same {
            return Err(differs(&now.name));
        }
    }
    let one_of_them = || first.meshes.first().or(frame.meshes.first()).map(|mesh| &mesh.name);
    match one_of_them() {
        Some(name) if first.meshes.len() != frame.meshes.len() => Err(differs(name)),
        _ => Ok(()),
    }
}

/// Meshes are plain data and may come from anywhere; a file that breaks its readers must not come of one.
fn check(mesh: &Mesh) -> Result<(), ExportError> {
    let vertices = mesh.positions.len();
    let malformed = |fault: &'static str, at: usize| ExportError::Malformed { mesh: mesh.name.clone(), fault, at };
    let lengths = [
        ("not one normal per vertex: as many as", mesh.normals.len()),
        ("not one S_u per vertex: as many as", mesh.tangents_u.len()),
        ("not one S_v per vertex: as many as", mesh.tangents_v.len()),
        ("not one (u, v) per vertex: as many as", mesh.uv.len()),
    ];
    let fields =
        mesh.fields.iter().map(|field| ("not one value per vertex in a field: as many as", field.values.len()));
    if let Some((fault, count)) = lengths.into_iter().chain(fields).find(|(_, count)| *count != vertices) {
        return Err(malformed(fault, count));
    }
    if mesh.columns == 0 || !vertices.is_multiple_of(mesh.columns) {
        return Err(malformed("vertices that are no grid of columns", mesh.columns));
    }
    let is_finite = |at: &usize| {
        let vectors = [&mesh.positions, &mesh.normals, &mesh.tangents_u, &mesh.tangents_v];
        let numbers = vectors.into_iter().filter_map(|values| values.get(*at)).flatten();
        numbers.chain(mesh.uv.get(*at).into_iter().flatten()).all(|x| x.is_finite())
    };
    if let Some(at) = (0..vertices).find(|at| !is_finite(at)) {
        return Err(malformed("a number that is not finite at vertex", at));
    }
    let is_infinite =
        |at: &usize| mesh.fields.iter().any(|field| field.values.get(*at).is_some_and(|x| x.is_infinite()));
    if let Some(at) = (0..vertices).find(is_infinite) {
        return Err(malformed("an infinite field at vertex", at));
    }
    match mesh.quads.iter().position(|quad| quad.iter().any(|&index| index as usize >= vertices)) {
        Some(at) => Err(malformed("an index without a vertex in quad", at)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tessellate::Field;

    fn unit_square() -> Mesh {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        Mesh {
            name: "square".to_owned(),
            positions: corners.iter().map(|&[x, y]| [x, y, 0.0]).collect(),
            normals: vec![[0.0, 0.0, 1.0]; 4],
            tangents_u: vec![[1.0, 0.0, 0.0]; 4],
            tangents_v: vec![[0.0, 1.0, 0.0]; 4],
            uv: corners.to_vec(),
            columns: 2,
            quads: vec![[0, 1, 2, 3]],
            ..Mesh::default()
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
    fn mesh_that_is_no_grid_or_has_a_broken_field_is_refused() {
        assert!(refusal(|mesh| mesh.columns = 3).contains("no grid"));
        let field = |values| Field { name: "residual", values };
        assert!(refusal(|mesh| mesh.fields = vec![field(vec![1.0; 3])]).contains("in a field"));
        assert!(refusal(|mesh| mesh.fields = vec![field(vec![f64::INFINITY; 4])]).contains("infinite field"));
    }

    #[test]
    fn frames_of_another_topology_are_refused_before_the_first_byte() {
        let still = |time| Scene { meshes: vec![unit_square()], time };
        let mut turned = still(1.0);
        turned.meshes[0].quads = vec![[1, 2, 3, 0]];
        let mut fewer = still(1.0);
        fewer.meshes.clear();
        for &format in Format::ALL.iter().filter(|format| format.is_animated()) {
            for second in [&turned, &fewer] {
                let mut bytes = Vec::new();
                let error = write_frames(&[still(0.0), second.clone()], format, &mut bytes).unwrap_err();
                assert_eq!(error.to_string(), "mesh `square` has other faces or fields at t = 1 than before");
                assert!(bytes.is_empty());
            }
        }
    }

    #[test]
    fn several_instants_for_one_file_of_a_still_format_are_refused() {
        let still = |time| Scene { meshes: vec![unit_square()], time };
        let error = write_frames(&[still(0.0), still(1.0)], Format::Obj, &mut Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "OBJ holds one instant, and there are 2");
        assert!(write_frames(&[], Format::Usda, &mut Vec::new()).is_err());
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
