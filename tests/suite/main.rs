//! The tests that see the library as its users do: one binary, so that it is linked once.

// An index out of range fails the test, as it should.
#![allow(clippy::indexing_slicing)]

mod analytic;
#[cfg(feature = "cli")]
mod cli;
mod documents;
mod evaluators;
mod exports;
mod meshes;
mod static_blend;
