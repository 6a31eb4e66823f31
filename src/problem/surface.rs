//! Primary surfaces, the trimlines where patches join them, and the seams where patches meet.

use crate::diagnostic::Span;
use crate::expr::{ExprId, Variable};

/// A surface that patches may join, in its own two parameters and time.
#[derive(Debug, Clone)]
pub struct PrimarySurface {
    /// What the user calls it.
    pub name: String,
    /// What the user calls its parameters.
    pub parameters: Vec<String>,
    /// x, y and z, where `u` and `v` stand for its first and second parameter and `t` for time.
    pub position: [ExprId; 3],
    /// The ranges of its two parameters, as far as they are stated; the ends are constants.
    pub ranges: [Option<[ExprId; 2]>; 2],
    /// Where it is named.
    pub origin: Option<Span>,
}

/// A trimline of a patch that is a curve on a primary surface.
#[derive(Debug, Clone)]
pub struct Join {
    /// The surface, as its place among the problem's.
    pub surface: usize,
    /// Where the patch has its trimline.
    pub u: ExprId,
    /// The surface's parameters along the trimline and its time, functions of v and t of the patch.
    pub arguments: [ExprId; 3],
    /// The surface's parameter that runs across the trimline.
    pub across: Variable,
    /// Whether the patch leaves against that parameter; `None` if the document does not say.
    pub is_flipped: Option<bool>,
    /// Where it is stated.
    pub origin: Option<Span>,
}

/// Two edges of patches that are meant to meet.
#[derive(Debug, Clone)]
pub struct Seam {
    /// Each edge: the part, as its place among the problem's patches and, behind them, nets, and the value of its u.
    pub edges: [(usize, ExprId); 2],
    /// Where it is stated.
    pub origin: Option<Span>,
}
