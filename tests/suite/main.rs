//! The tests that see the library as its users do: one binary, so that it is linked once.

// An index out of range fails the test, as it should.
#![allow(clippy::indexing_slicing)]

mod accuracy;
mod analytic;
mod architecture;
#[cfg(feature = "cli")]
mod cli;
mod decompositions;
mod deformations;
mod derivatives;
mod diagnostics;
mod display;
mod documents;
mod evaluators;
mod exact;
mod exports;
mod four_sided;
mod language;
mod meshes;
mod multisided;
mod polynomial;
mod reference;
mod robustness;
mod sides;
mod spec;
mod static_blend;
