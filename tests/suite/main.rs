//! The tests that see the library as its users do: one binary, so that it is linked once.

// An index out of range fails the test, as it should.
#![allow(clippy::indexing_slicing)]

mod accuracy;
mod analytic;
mod architecture;
mod bspline;
mod cad;
mod choice;
#[cfg(feature = "cli")]
mod cli;
#[cfg(feature = "cli")]
mod cli_files;
#[cfg(feature = "cli")]
mod cli_fit;
#[cfg(feature = "cli")]
mod cli_morph;
mod curves;
mod decompositions;
mod deformations;
mod derivatives;
mod diagnostics;
mod display;
mod documents;
mod emitted;
mod evaluators;
mod exact;
mod explanation;
mod exports;
mod features;
mod fields;
#[cfg(feature = "cli")]
mod figures;
mod fitting;
mod folds;
mod forces;
mod formatting;
mod four_sided;
#[cfg(feature = "cli")]
mod four_sided_specs;
mod fourier;
mod grids;
mod imported;
mod kernels;
mod language;
mod latex;
mod meshes;
#[cfg(feature = "cli")]
mod models;
mod morphs;
mod multisided;
mod net;
mod net_specs;
mod operators;
mod patches;
#[cfg(feature = "render")]
mod pictures;
mod polynomial;
mod polynomials;
mod readings;
mod reference;
mod robustness;
#[cfg(feature = "cli")]
mod seams;
mod sides;
mod spec;
mod static_blend;
mod step_reading;
mod surfaces;
mod threads;
#[cfg(feature = "view")]
mod view;
