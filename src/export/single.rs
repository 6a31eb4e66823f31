//! Positions in 32-bit floats, and what they lose.

use super::ExportError;
use crate::diagnostic::{Code, Diagnostic};
use crate::tessellate::{Mesh, Scene};

/// The share of a mesh's size by which rounding may move its points without a word: far more than the 1e-7 of a mesh near
/// the origin, and still nothing that an eye would see.
const UNSEEN: f64 = 1e-5;

/// The positions of a mesh for a format of 32-bit floats.
pub(super) fn in_single_precision(format: &'static str, mesh: &Mesh) -> Result<Vec<[f32; 3]>, ExportError> {
    let round = |position: &[f64; 3]| {
        let rounded = position.map(|x| x as f32);
        match position.iter().zip(rounded).find(|(_, rounded)| !rounded.is_finite()) {
            None => Ok(rounded),
            Some((&value, _)) => Err(ExportError::CoordinateTooLarge {
                format,
                mesh: mesh.name.clone(),
                largest: f64::from(f32::MAX),
                value,
            }),
        }
    };
    mesh.positions.iter().map(round).collect()
}

/// A warning for the mesh that suffers most from single precision, if any does: far from the origin the numbers are few, and
/// a mesh that is small there becomes steps, or flat.
pub(super) fn precision_warning(format: &'static str, frames: &[Scene]) -> Option<Diagnostic> {
    let meshes = frames.iter().flat_map(|scene| &scene.meshes);
    let losses = meshes
        .map(|mesh| (mesh, rounding(mesh) / size(mesh)))
        .filter(|(_, share)| share.is_finite() && *share > UNSEEN);
    let (mesh, share) = losses.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    let message = format!(
        "{format} holds single precision, in which the points of `{}` move by up to {:.1e}, {share:.0e} of its size",
        mesh.name,
        rounding(mesh),
    );
    Some(
        Diagnostic::new(Code::PrecisionLost, message)
            .hint("move the surface nearer to the origin, or write OBJ, PLY, VTP or NPZ, which hold doubles"),
    )
}

/// The largest distance along an axis by which rounding moves a point.
fn rounding(mesh: &Mesh) -> f64 {
    mesh.positions.iter().flatten().map(|&x| (x - f64::from(x as f32)).abs()).fold(0.0, f64::max)
}

/// The longest side of the box around a mesh.
fn size(mesh: &Mesh) -> f64 {
    let side = |axis: usize| {
        let along = mesh.positions.iter().filter_map(|position| position.get(axis));
        along.clone().copied().fold(f64::MIN, f64::max) - along.copied().fold(f64::MAX, f64::min)
    };
    (0..3).map(side).fold(0.0, f64::max)
}
