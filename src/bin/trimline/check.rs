//! `trimline check`: reads, resolves, solves and measures.

use std::fmt::Write;

use clap::Args;
use serde::Serialize;

use trimline::expr::Notation;
use trimline::problem::{Explanation, Patch, describe_condition};
use trimline::verify::Verification;

use crate::Outcome;
use crate::failure::{Failure, print_warnings};
use crate::options::{Collocation, Format, Solving, Terminal};
use crate::output;
use crate::workflow::{Patched, Spec};

#[derive(Args)]
pub struct Arguments {
    /// The spec files, or `-`.
    #[arg(required = true)]
    spec: Vec<String>,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// Also what was understood: params, equation, domain and constraints, in Unicode and in LaTeX.
    #[arg(long)]
    explain: bool,

    /// Fail if the surface misses a prescribed position by more than this.
    #[arg(long, value_name = "LENGTH")]
    max_gap: Option<f64>,

    /// How to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Instants at which a patch is measured unless the user names one.
const INSTANTS: usize = 5;

#[derive(Serialize)]
struct Report {
    patches: Vec<PatchReport>,
    seams: Vec<()>,
    passed: bool,
}

#[derive(Serialize)]
struct PatchReport {
    name: String,
    method: &'static str,
    boundaries: Vec<Boundary>,
    joins: Vec<()>,
    pde_residual: f64,
    amplification: Option<f64>,
    times: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    explanation: Option<Explanations>,
}

/// What was understood, in both notations.
#[derive(Serialize)]
struct Explanations {
    unicode: Explained,
    latex: Explained,
}

#[derive(Serialize)]
struct Explained {
    params: String,
    equation: String,
    domain: String,
    constraints: String,
    #[serde(skip)]
    whole: String,
}

#[derive(Serialize)]
struct Boundary {
    u: f64,
    order: usize,
    max_error: f64,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    if arguments.max_gap.is_some_and(|most| most.is_nan() || most < 0.0) {
        return Err(Failure::Usage("--max-gap takes a length, 0 or more".to_owned()));
    }
    let mut report = Report { patches: Vec::new(), seams: Vec::new(), passed: true };
    let mut failures: Vec<Failure> = Vec::new();
    for path in &arguments.spec {
        match check(path, arguments, terminal) {
            Ok(patches) => report.patches.extend(patches),
            Err(failure) => failures.push(failure),
        }
    }
    // With several specs each fault is reported; the last one decides the status.
    if let Some(last) = failures.pop() {
        failures.iter().for_each(|failure| failure.print(terminal));
        return Err(last);
    }
    if let Some(most) = arguments.max_gap {
        let gaps = report.patches.iter().flat_map(|patch| &patch.boundaries).filter(|boundary| boundary.order == 0);
        report.passed = gaps.map(|boundary| boundary.max_error).all(|gap| gap <= most);
    }
    match arguments.format {
        Format::Text => output::print(&text(&report))?,
        Format::Json => output::print_json(&report)?,
    }
    if report.passed { Ok(()) } else { Err(Failure::NotPassed) }
}

fn check(path: &str, arguments: &Arguments, terminal: &Terminal) -> Result<Vec<PatchReport>, Failure> {
    let spec = Spec::read(path, &arguments.solving.reading)?;
    let mut reports = Vec::new();
    for patch in &spec.patches {
        let patched = spec.prepare(patch, &arguments.solving, arguments.collocation.points.as_deref())?;
        let times = match arguments.solving.time {
            Some(_) => vec![patched.instant(arguments.solving.time)?],
            None => trimline::tessellate::instants(patched.prepared.domain.t, INSTANTS, &spec.limits)
                .map_err(|finding| spec.fault(finding))?,
        };
        let mut worst: Option<Verification> = None;
        let mut method = "";
        let mut amplification: Option<f64> = None;
        for (index, &time) in times.iter().enumerate() {
            let solved = spec.solve(&patched, time)?;
            method = solved.solution.report.method;
            let here = solved.solution.report.amplification;
            amplification = here.into_iter().chain(amplification).reduce(f64::max);
            if index == 0 {
                print_warnings(&solved.solution.report.warnings, &spec.source, terminal);
            }
            worst = Some(match worst {
                Some(before) => before.worst(&solved.measured),
                None => solved.measured,
            });
        }
        if let Some(worst) = worst {
            let report = patch_report(&spec, &patched, method, &worst, times)?;
            let explanation = if arguments.explain { Some(explanations(&spec, patch)?) } else { None };
            reports.push(PatchReport { amplification, explanation, ..report });
        }
    }
    Ok(reports)
}

fn patch_report(
    spec: &Spec,
    patched: &Patched,
    method: &'static str,
    worst: &Verification,
    times: Vec<f64>,
) -> Result<PatchReport, Failure> {
    let mut boundaries = Vec::new();
    for (condition, max_error) in patched.prepared.patch().conditions.iter().zip(&worst.boundary_errors) {
        let u = spec.bindings.constant(&spec.problem, condition.u, None, "the position of a boundary");
        let u = u.map_err(|finding| spec.fault(finding))?;
        boundaries.push(Boundary { u, order: condition.order, max_error: *max_error });
    }
    Ok(PatchReport {
        name: patched.prepared.patch().name.clone(),
        method,
        boundaries,
        joins: Vec::new(),
        pde_residual: worst.relative_residual(),
        amplification: None,
        times,
        explanation: None,
    })
}

fn explanations(spec: &Spec, patch: &Patch) -> Result<Explanations, Failure> {
    let explained = |notation: Notation| {
        let explanation = spec.problem.explain(patch, notation, &spec.limits).map_err(|finding| spec.fault(finding))?;
        let whole = explanation.to_text();
        let Explanation { parameters: params, equation, domain, constraints } = explanation;
        Ok::<_, Failure>(Explained { params, equation, domain, constraints, whole })
    };
    Ok(Explanations { unicode: explained(Notation::Unicode)?, latex: explained(Notation::Latex)? })
}

/// Writing to a string does not fail.
fn text(report: &Report) -> String {
    let mut text = String::new();
    for patch in &report.patches {
        let when = match patch.times.as_slice() {
            [first, .., last] => format!("{} instants from t = {first} to {last}", patch.times.len()),
            times => times.iter().map(|time| format!("t = {time}")).collect(),
        };
        if let Some(explanation) = &patch.explanation {
            let (unicode, latex) = (&explanation.unicode.whole, &explanation.latex.whole);
            let _ = writeln!(text, "patch {} as it was understood\n\n{unicode}\nin LaTeX\n\n{latex}", patch.name);
        }
        let _ = writeln!(text, "patch {}: method {}, {when}", patch.name, patch.method);
        for boundary in &patch.boundaries {
            let what = describe_condition(None, boundary.order, boundary.u);
            let _ = writeln!(text, "  {what:20} largest error {:.1e}", boundary.max_error);
        }
        let _ = writeln!(text, "  {:20} {:.1e} of the largest term", "PDE residual", patch.pde_residual);
    }
    let _ = writeln!(
        text,
        "{}",
        if report.passed { "passed" } else { "not passed: a position is missed by more than --max-gap" }
    );
    text
}
