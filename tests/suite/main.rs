//! The tests that see the library as its users do: one binary, so that it is linked once.

// An index out of range fails the test, as it should.
#![allow(clippy::indexing_slicing)]

mod accuracy;
mod analytic;
mod architecture;
mod bspline;
mod cad;
#[cfg(feature = "cli")]
mod cli;
#[cfg(feature = "cli")]
mod cli_fit;
mod decompositions;
mod derivatives;
mod diagnostics;
mod display;
mod documents;
mod evaluators;
mod exact;
mod exports;
mod fitting;
mod language;
mod meshes;
mod net;
mod polynomial;
mod reference;
mod robustness;
mod spec;
mod static_blend;
