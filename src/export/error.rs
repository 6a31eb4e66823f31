//! Why a scene could not be written.

use std::io;

use crate::diagnostic::{Code, Diagnostic, Shortest};

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
    /// A patch has no area, and the format holds areas.
    #[error("`{name}` has no area: it has shrunk to a curve or a point")]
    NoArea {
        /// The patch.
        name: String,
    },
    /// A patch is narrower than places of the whole model are told apart.
    #[error(
        "`{name}` is narrower than {tolerance:.1e}, and places so close to each other are one in a model of that size"
    )]
    TooNarrow {
        /// The patch.
        name: String,
        /// The distance below which places are one.
        tolerance: f64,
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
    /// The format holds one instant, or there is none.
    #[error("{format} holds one instant, and there are {count}")]
    NotOneInstant {
        /// The format.
        format: &'static str,
        /// How many there are.
        count: usize,
    },
    /// The frames of an animation are not the same meshes.
    #[error("mesh `{mesh}` has other faces or fields at t = {} than before", Shortest(*time))]
    TopologyChanges {
        /// The mesh.
        mesh: String,
        /// The first instant at which it differs.
        time: f64,
    },
    /// The instants of an animation do not ascend in the numbers of the format.
    #[error("{format} cannot hold the instants t = {} and t = {} one after the other", Shortest(*time), Shortest(*next))]
    UnfitInstants {
        /// The format.
        format: &'static str,
        /// An instant.
        time: f64,
        /// The one that follows.
        next: f64,
    },
}

impl ExportError {
    /// The error as a finding: [`Code::OutputFailed`] if the writer failed, [`Code::FormatCannotHold`] if what is to be
    /// written does not fit the format, and [`Code::NoArea`] for a patch without area, which is a fault of its data.
    #[must_use]
    pub fn to_diagnostic(&self) -> Diagnostic {
        let code = match self {
            ExportError::Io(_) | ExportError::Malformed { .. } | ExportError::NotOneInstant { .. } => {
                Code::OutputFailed
            }
            ExportError::NoArea { .. } => Code::NoArea,
            _ => Code::FormatCannotHold,
        };
        let diagnostic = Diagnostic::new(code, self.to_string());
        match self {
            ExportError::Io(_) | ExportError::Malformed { .. } | ExportError::NotOneInstant { .. } => diagnostic,
            ExportError::NoArea { .. } => {
                diagnostic.hint("leave this patch out with `--patch`, or change its boundary")
            }
            ExportError::TooNarrow { .. } => diagnostic.hint("write it to a file of its own with `--patch`"),
            ExportError::CoordinateTooLarge { .. } => diagnostic.hint("OBJ and PLY hold every coordinate"),
            ExportError::TopologyChanges { .. } => diagnostic.hint("leave the seams of closed surfaces open"),
            ExportError::UnfitInstants { .. } => diagnostic.hint("ask for fewer frames, or write NPZ or VTP"),
            ExportError::TooMany { .. } => diagnostic.hint("choose a coarser grid, or write fewer patches to a file"),
        }
    }
}

/// `count` as the 32-bit number a format stores.
pub(super) fn count_of(format: &'static str, items: &'static str, count: usize) -> Result<u32, ExportError> {
    u32::try_from(count).map_err(|_| ExportError::TooMany { format, items, largest: u32::MAX, count })
}
