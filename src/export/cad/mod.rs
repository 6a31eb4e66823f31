//! Writes B-spline surfaces in the formats CAD programs read.
//!
//! Input: named surfaces; output: the bytes of one file. All numbers keep full precision. Lengths are in millimetres: the
//! documents of this project have no units, and these formats must have one.
//!
//! Invariant: equal models give equal bytes; no date is written, since there is none here.
//!
//! Absent on purpose: trimming, and curves on surfaces in parameters (pcurves), which readers compute.

mod area;
mod iges;
mod part21;
mod step;
mod topology;

use std::io::{BufWriter, Write};

use crate::surface::BsplineSurface;
use crate::surface::bspline::to_json;

use super::ExportError;

/// A surface with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// What readers call it.
    pub name: String,
    /// Its geometry; the whole of it is the face.
    pub surface: BsplineSurface,
}

/// The application protocol that a STEP file names in its header.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Schema {
    /// ISO 10303-214, automotive design: what every reader knows.
    #[default]
    Ap214,
    /// ISO 10303-242, managed model-based 3D engineering: its successor.
    Ap242,
}

impl Schema {
    /// Both, with the names users give them.
    pub const NAMED: [(&str, Schema); 2] = [("ap214", Schema::Ap214), ("ap242", Schema::Ap242)];
}

/// A format for B-spline surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CadFormat {
    /// STEP, ISO 10303-21: faces with edges and vertices, sewn into shells.
    Step(Schema),
    /// IGES 5.3: one surface (entity 128) per face.
    Iges,
    /// JSON: degrees, knots and nets; [`from_json`](crate::surface::bspline::from_json) reads it back.
    Json,
}

impl CadFormat {
    /// The extensions of all formats.
    pub const EXTENSIONS: [&str; 5] = ["step", "stp", "igs", "iges", "json"];

    /// The format whose files end in `extension`, in any case and without the dot; STEP files are for `schema`.
    #[must_use]
    pub fn from_extension(extension: &str, schema: Schema) -> Option<CadFormat> {
        match extension.to_ascii_lowercase().as_str() {
            "step" | "stp" => Some(CadFormat::Step(schema)),
            "igs" | "iges" => Some(CadFormat::Iges),
            "json" => Some(CadFormat::Json),
            _ => None,
        }
    }
}

/// Writes `faces` as the model `name`.
///
/// Knots that are not clamped are, by knot insertion, which leaves the surface where it is. In STEP, edges of equal
/// curves are one edge, of two faces or of one that closes; an edge that has shrunk to a point is left out; faces that
/// are connected make a shell, whose faces are turned alike.
///
/// # Errors
/// [`ExportError::Io`] when `out` fails; [`ExportError::NoArea`], before the first byte, for a face that is a curve or a
/// point; [`ExportError::TooNarrow`] for one that is so beside the others.
pub fn write_cad(name: &str, faces: &[Face], format: CadFormat, out: &mut dyn Write) -> Result<(), ExportError> {
    let clamped = |face: &Face| Face { name: face.name.clone(), surface: face.surface.clamped() };
    let clamped: Vec<Face> = faces.iter().map(clamped).collect();
    area::check(&clamped)?;
    let text = match format {
        CadFormat::Step(schema) => step::text(name, &clamped, schema),
        CadFormat::Iges => iges::text(name, &clamped),
        CadFormat::Json => {
            let named: Vec<_> = faces.iter().map(|face| (face.name.as_str(), &face.surface)).collect();
            let text = to_json(&named).map_err(|finding| std::io::Error::other(finding.message))?;
            text + "\n"
        }
    };
    let mut out = BufWriter::new(out);
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(())
}
