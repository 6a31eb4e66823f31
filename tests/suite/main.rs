//! The integration tests, one binary.

mod analytic;
mod exports;
mod meshes;
