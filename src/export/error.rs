//! Why a scene could not be written.

use std::io;

use crate::diagnostic::{Code, Diagnostic};

/// Why a scene could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The writer failed.
    #[error("writing failed: {0}")]
    Io(#[from] io::Error),
    /// A mesh is not one: `fault` and `at` say where.
    #[error("mesh `{mesh}` has {fault} {at}")]
    Malformed {
        /// The mesh.
        mesh: String,
        /// What it has.
        fault: &'static str,
        /// The vertex, the quad, or how many there are.
        at: usize,
    },
    /// A face has shrunk to a point.
    #[error("the face `{face}` has shrunk to a point")]
    Collapsed {
        /// The face.
        face: String,
    },
    /// A coordinate is too large for the numbers of the format.
    #[error("{format} holds coordinates up to {largest:e}, and mesh `{mesh}` has {value:e}")]
    CoordinateTooLarge {
        /// The format.
        format: &'static str,
        /// The mesh.
        mesh: String,
        /// The largest number the format holds.
        largest: f64,
        /// The coordinate.
        value: f64,
    },
    /// There are more vertices or faces than the format can number.
    #[error("{format} holds up to {largest} {items}, and the scene has {count}")]
    TooMany {
        /// The format.
        format: &'static str,
        /// What there are too many of.
        items: &'static str,
        /// How many the format can number.
        largest: u32,
        /// How many there are.
        count: usize,
    },
}

impl ExportError {
    /// The error as a finding, of class [`Output`](crate::diagnostic::Class::Output).
    #[must_use]
    pub fn to_diagnostic(&self) -> Diagnostic {
        let diagnostic = Diagnostic::new(Code::OutputFailed, self.to_string());
        match self {
            ExportError::Io(_) | ExportError::Malformed { .. } => diagnostic,
            ExportError::Collapsed { .. } => {
                diagnostic.hint("leave this patch out with `--patch`, or change its boundary")
            }
            ExportError::CoordinateTooLarge { .. } => diagnostic.hint("OBJ and PLY hold every coordinate"),
            ExportError::TooMany { .. } => diagnostic.hint("choose a coarser grid, or write fewer patches to a file"),
        }
    }
}

/// `count` as the 32-bit number a format stores.
pub(super) fn count_of(format: &'static str, items: &'static str, count: usize) -> Result<u32, ExportError> {
    u32::try_from(count).map_err(|_| ExportError::TooMany { format, items, largest: u32::MAX, count })
}
