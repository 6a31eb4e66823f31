//! Patches with three sides, and with any number from three to twelve, as patches with four.
//!
//! Input: curves and tangents around a hole, symbolically; output: [`Patch`](crate::problem::Patch)es with position and
//! tangent on all four sides, which any method for such patches solves (docs/methods.md, M1 to M6; You and Zhang 2003,
//! Section VI, completed). Params and t stay symbols, so that a loop may move.
//!
//! Invariant: neighbouring patches state the same curve, and tangents in one plane, along the seam between them; so
//! they meet smoothly whatever the equation puts inside. Absent on purpose: numbers, but for the checks of a loop.

mod apex;
mod crossing;
mod loops;
mod split;
mod vector;

pub use apex::close_at_apex;
pub use loops::{Edge, EdgeLoop, MOST_EDGES, Seam};
