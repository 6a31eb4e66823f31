//! Blend surfaces from their boundary-value problem.
//!
//! A text states what a surface `S(u, v, t)` must be at its trimlines and the linear partial differential equation
//! between them. trimline factors the boundary data into basis functions `F_j(v, t)` and vector coefficients,
//! differentiates them symbolically, compiles them, and solves for a surface that meets its boundary exactly.
//!
//! ```
//! use trimline::{blend::Blend, diagnostic::Source, expr::Derivative, method::Options};
//!
//! let text = "param r = 1
//!     at u = 0: S = [r cos v, r sin v, 1],  ∂S/∂u = [0, 0, -1]
//!     at u = 1: S = [2 cos v, 2 sin v, 0],  ∂S/∂u = [cos v, sin v, 0]";
//! let mut blend = Blend::compile(&Source::new("vase", text), &Options::default()).map_err(|found| found[0].clone())?;
//! blend.set("r", "0.8").map_err(|found| found[0].clone())?;
//! let solution = blend.solve(0, 0.0)?;
//! let mut point = [[0.0; 3]];
//! solution.surface.evaluate(Derivative::NONE, &[[0.0, 0.0, 0.0]], &mut point)?;
//! assert_eq!(point[0], [0.8, 0.0, 1.0]);
//! # Ok::<(), trimline::diagnostic::Diagnostic>(())
//! ```
//!
//! # The pipeline
//!
//! ```text
//! text ─syntax→ Document ─resolve→ Problem ─decompose→ Decomposition ─method→ Solution ─tessellate→ Scene ─export, render→ bytes
//!                                     expr (graph, derivatives) → eval (program → interpreter | machine code)
//!                                                                      verify (judges any Surface)
//! ```
//!
//! Every arrow is a function from values to a value: [`syntax::parse`], [`resolve::resolve`],
//! [`decompose::decompose`], [`method::Method::prepare`] and [`method::Solver::solve`],
//! [`tessellate::tessellate`], [`export::write`], and behind a feature `render::Renderer::draw`. [`blend::Blend`] runs the first five. A module imports only
//! modules of lower rank; docs/ARCHITECTURE.md has the ranks.
//!
//! Faults are [`diagnostic::Diagnostic`]s with a stable code and a place. The library never panics on any input.

pub mod blend;
pub mod curves;
pub mod decompose;
pub mod diagnostic;
pub mod emit;
pub mod eval;
pub mod export;
pub mod expr;
pub mod features;
pub mod fit;
pub mod kernels;
pub mod limits;
pub mod method;
pub mod morph;
pub mod multisided;
pub mod net;
pub mod numeric;
pub mod problem;
#[cfg(feature = "render")]
pub mod render;
pub mod resolve;
pub mod surface;
pub mod syntax;
pub mod tessellate;
pub mod threads;
pub mod trial;
pub mod verify;

/// The README's example runs as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
