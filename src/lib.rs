//! trimline
pub mod decompose;
pub mod diagnostic;
pub mod eval;
pub mod export;
pub mod expr;
pub mod limits;
pub mod method;
pub mod numeric;
pub mod problem;
pub mod resolve;
pub mod surface;
pub mod syntax;
pub mod tessellate;
pub mod trial;
pub mod verify;
