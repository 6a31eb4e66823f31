//! Embedding the compiler: a spec from a string, parameters changed, points evaluated into a buffer of our own,
//! and every class of error told apart.
//!
//! `cargo run --example embed --no-default-features`

use trimline::blend::Blend;
use trimline::diagnostic::{Class, Diagnostic, Diagnostics, Source};
use trimline::expr::Derivative;
use trimline::method::Options;

const SPEC: &str = "
param r = 1, lift = 0.5
domain v in [0, 2π], t in [0, 1]
pde with γ = 4, ρ = 1
at u = 0: S = [r cos v, r sin v, 1 + lift sin(π t)], ∂S/∂u = [0, 0, -1]
at u = 1: S = [2 cos v, 2 sin v, 0], ∂S/∂u = [cos v, sin v, 0]
";

fn main() {
    if let Err(found) = run() {
        found.iter().for_each(explain);
        std::process::exit(1);
    }
}

fn run() -> Result<(), Diagnostics> {
    let source = Source::new("skirt", SPEC);
    let mut blend = Blend::compile(&source, &Options::default())?;

    // Nothing is parsed, decomposed or compiled again for another radius.
    for r in ["1", "0.8", "0.6"] {
        blend.set("r", r)?;
        let t = 0.25;
        let solution = blend.solve(0, t).map_err(|finding| vec![finding])?;
        let points: Vec<[f64; 3]> = (0..=4).map(|i| [0.25 * f64::from(i), 0.0, t]).collect();
        let mut profile = vec![[0.0; 3]; points.len()];
        solution.surface.evaluate(Derivative::NONE, &points, &mut profile).map_err(|finding| vec![finding])?;
        let measured = blend.verify(0, &solution, t).map_err(|finding| vec![finding])?;
        let radii: Vec<String> = profile.iter().map(|[x, ..]| format!("{x:.3}")).collect();
        println!("r = {r}: radii {}, residual {:.0e}", radii.join(" "), measured.relative_residual());
    }

    // A fault comes with its code, its place and advice; the blend stays as it was.
    if let Err(found) = blend.set("r", "1/0") {
        found.iter().for_each(explain);
    }
    Ok(())
}

/// What a program may want to do about each class.
fn explain(finding: &Diagnostic) {
    let what = match finding.class() {
        Class::Source => "show it to whoever wrote the spec",
        Class::Unsupported => "choose another method",
        Class::Numerical => "change parameters: the problem is ill-posed as stated",
        Class::Limit => "raise the limit, or refuse the document",
        Class::Host => "nothing: results are the same",
        Class::Output => "look at the disk",
    };
    println!("{finding} ({what})");
}
