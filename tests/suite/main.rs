//! The tests that see the library as its users do: one binary, so that it is linked once.

// An index out of range fails the test, as it should.
#![allow(clippy::indexing_slicing)]

mod analytic;
mod architecture;
mod decompositions;
mod derivatives;
mod diagnostics;
mod display;
mod evaluators;
mod exports;
mod language;
mod meshes;
mod reference;
mod robustness;
mod spec;
