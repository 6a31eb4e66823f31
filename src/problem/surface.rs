//! Primary surfaces, the trimlines where patches join them, and the seams where patches meet.

use super::Bindings;
use super::domain::interval;
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::expr::{ExprId, Graph, Variable};

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
    /// Where each range is written.
    pub range_origins: [Option<Span>; 2],
    /// Where it is named.
    pub origin: Option<Span>,
    /// What there is to say of the file that it comes from.
    pub remarks: Diagnostics,
}

impl PrimarySurface {
    /// The ranges of its two parameters as numbers, as far as they are stated.
    ///
    /// # Errors
    /// [`Code::EmptyDomain`](crate::diagnostic::Code::EmptyDomain) when a range has no extent or its ends are swapped,
    /// [`Code::ParameterNotFinite`](crate::diagnostic::Code::ParameterNotFinite) when an end is not finite.
    pub fn evaluate_ranges(&self, graph: &Graph, bindings: &Bindings) -> Result<[Option<[f64; 2]>; 2], Diagnostic> {
        let mut values = [None; 2];
        let stated = self.ranges.iter().zip(self.range_origins).zip(&self.parameters);
        for (((ends, origin), name), value) in stated.zip(&mut values) {
            let Some(ends) = *ends else { continue };
            let what = format!("the range of {name} of `{}`", self.name);
            *value = Some(interval(graph, bindings, ends, (&what, name), origin)?);
        }
        Ok(values)
    }
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
    /// Both edges.
    pub edges: [SeamEdge; 2],
    /// Whether one patch is meant to go on smoothly as the other.
    pub is_smooth: bool,
    /// Where it is stated.
    pub origin: Option<Span>,
}

/// A side of a patch, or a part of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamEdge {
    /// The part, as its place among the problem's patches, nets and copies.
    pub patch: usize,
    /// The coordinate that is fixed.
    pub across: Variable,
    /// Its value, constant.
    pub position: ExprId,
    /// How much of it.
    pub part: SidePart,
}

/// Which part of a side, by the coordinate that runs along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SidePart {
    /// From one share of the coordinate's range to another; `[0, 1]` is the whole side.
    Shares([f64; 2]),
    /// From one value to another, both constant.
    Values([ExprId; 2]),
}
