//! trimline
pub mod diagnostic;
pub mod expr;
pub mod limits;
pub mod problem;
pub mod surface;
pub mod syntax;
