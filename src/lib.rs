//! trimline
pub mod diagnostic;
pub mod export;
pub mod expr;
pub mod limits;
pub mod surface;
pub mod tessellate;
