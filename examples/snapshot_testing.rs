//! Snapshot-testing a derived basis: the text form of a decomposition is stable and symbolic, so a test can hold it.
//!
//! In a project's own tests write `insta::assert_snapshot!(derived_basis(SPEC))`; in its CI,
//! `trimline basis spec.trim | diff - spec.basis`.
//!
//! `cargo run --example snapshot_testing --no-default-features`

use trimline::decompose::decompose;
use trimline::diagnostic::{Code, Diagnostic, Diagnostics, Source};
use trimline::expr::Notation;
use trimline::limits::Limits;
use trimline::{resolve, syntax};

const SPEC: &str = "
param b = 1, k = 3
at u = 0: S = [(1 - t) b sin(k v), (1 - t) b cos(k v), 1], ∂S/∂u = 0
at u = 1: S = [cos v, sin v, 0], ∂S/∂u = 0
";

fn derived_basis(spec: &str) -> Result<String, Diagnostics> {
    let limits = Limits::default();
    let document = syntax::parse(&Source::new("spec", spec), &limits)?;
    let problem = resolve::resolve(&document, "spec", &limits)?;
    let patch = problem.patches.first().ok_or_else(|| vec![Diagnostic::new(Code::EmptyDocument, "no patch")])?;
    let decomposition = decompose(&problem, patch, &limits).map_err(|finding| vec![finding])?;
    decomposition.to_text(Notation::Unicode, &limits).map_err(|finding| vec![finding])
}

fn main() -> Result<(), String> {
    let text = derived_basis(SPEC).map_err(|found| format!("{found:?}"))?;
    println!("{text}");
    // What a snapshot would hold: the functions, in the order of the spec.
    let functions: Vec<&str> =
        text.lines().filter(|line| line.trim_start().starts_with('F') && line.contains(" = ")).collect();
    if functions.first().map(|line| line.trim()) == Some("F1 = sin(k v)") {
        Ok(())
    } else {
        Err(format!("the basis changed: {functions:?}"))
    }
}
