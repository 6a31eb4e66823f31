//! Closed curves through measured points: a table of coordinates to points, and points to splines.
//!
//! [`read_points`] takes the bytes of a table to points, [`ClosedCurve::through`] those to a curve that an expression
//! can call (docs/methods.md, P1 to P3). Nothing here reads a file: bytes come from the caller.

mod closed;
mod table;

pub use closed::{ClosedCurve, LEAST_POINTS};
pub use table::{TableFault, read_points};
