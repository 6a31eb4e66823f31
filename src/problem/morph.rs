//! `morph from A to B`: patches that are the ends of a morph.

use crate::diagnostic::Span;

/// What changes from frame to frame of a morph.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MorphKind {
    /// The boundary data.
    Boundary,
    /// The number of Fourier modes: fewer and fewer of the source, then more and more of the target.
    Modes,
    /// Both at once.
    Both,
}

impl MorphKind {
    /// All of them, by the words that name them.
    pub const ALL: [(&'static str, MorphKind); 3] =
        [("boundary", MorphKind::Boundary), ("modes", MorphKind::Modes), ("both", MorphKind::Both)];
}

/// Which patches of a problem become which others.
#[derive(Debug, Clone, PartialEq)]
pub struct MorphRequest {
    /// Places among the problem's patches: from and to. Patches in no pair stay as they are.
    pub pairs: Vec<[usize; 2]>,
    /// What changes; `None` if the document leaves it open.
    pub kind: Option<MorphKind>,
    /// The number of frames between the ends, if it is stated.
    pub steps: Option<usize>,
    /// The statement.
    pub origin: Option<Span>,
}
