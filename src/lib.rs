//! trimline
pub mod diagnostic;
pub mod eval;
pub mod expr;
pub mod limits;
pub mod surface;
