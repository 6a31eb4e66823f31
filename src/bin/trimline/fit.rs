//! `trimline fit`: surfaces as B-splines, for CAD programs.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic};
use trimline::export::{CadFormat, Face, Schema, write_cad};
use trimline::fit::{Fitted, Settings, Target, fit};
use trimline::surface::KnotVector;

use crate::Outcome;
use crate::failure::{Failure, print_warnings, say};
use crate::options::{Collocation, Format, Solving, Terminal, option_finding};
use crate::output;
use crate::workflow::{Patched, Solved, Spec};

#[derive(Args)]
#[command(mut_arg("tolerance", |tolerance| tolerance.value_name("LENGTH").help(
    "The largest distance between B-spline and surface [default: 1e-6 of the surface's extent]"
)))]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// The file; its extension is the format (step, stp, igs, iges, json).
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,

    /// The degree of the B-splines, 3 to 5.
    #[arg(long, value_name = "P", default_value_t = 3)]
    degree: usize,

    /// The application protocol of a STEP file.
    #[arg(long, value_enum, default_value_t = Protocol::Ap214, value_name = "NAME")]
    schema: Protocol,

    /// How to print the report.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Protocol {
    /// Automotive design: what every reader knows.
    Ap214,
    /// Managed model-based 3D engineering: its successor.
    Ap242,
}

#[derive(Serialize)]
struct Report {
    patches: Vec<PatchReport>,
}

#[derive(Serialize)]
struct PatchReport {
    name: String,
    time: f64,
    degree: usize,
    control_points: [usize; 2],
    tolerance: f64,
    deviation: f64,
    edge_deviation: f64,
    tangent_deviation: f64,
    closed_in_v: bool,
}

pub fn run(mut arguments: Arguments, terminal: &Terminal) -> Outcome {
    let schema = match arguments.schema {
        Protocol::Ap214 => Schema::Ap214,
        Protocol::Ap242 => Schema::Ap242,
    };
    let format = format_of(&arguments.output, schema)?;
    // The option is this command's own; a method takes its tolerance from the spec.
    let settings = settings(arguments.degree, arguments.solving.tolerance.take().as_deref())?;
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    let points = arguments.collocation.points.as_deref();
    let patched: Vec<Patched> =
        spec.patches.iter().map(|patch| spec.prepare(patch, &arguments.solving, points)).collect::<Result<_, _>>()?;
    let Some(first) = patched.first() else {
        return Err(spec.fault(Diagnostic::new(Code::EmptyDocument, "there is no patch to fit")));
    };
    let time = first.instant(arguments.solving.time)?;
    let solved: Vec<Solved> = patched.iter().map(|patch| spec.solve(patch, time)).collect::<Result<_, _>>()?;
    for one in &solved {
        print_warnings(&one.solution.report.warnings, &spec.source, terminal);
    }
    let name = |patch: &Patched| patch.prepared.patch().name.clone();
    let names: Vec<String> = patched.iter().map(name).collect();
    let targets = names.iter().zip(&patched).zip(&solved).map(|((name, patch), solved)| {
        let domain = &patch.prepared.domain;
        Target { name, surface: &*solved.solution.surface, u: domain.u, v: domain.v }
    });
    let fits = fit(&targets.collect::<Vec<_>>(), time, &settings, &spec.limits)
        .map_err(|finding| Failure::Found { source: None, findings: vec![finding] })?;
    let faces: Vec<Face> =
        names.iter().zip(&fits).map(|(name, fit)| Face { name: name.clone(), surface: fit.surface.clone() }).collect();
    let mut files = output::Files::default();
    let title = names.join(", ");
    let file: &mut dyn Write = files.create(&arguments.output)?;
    write_cad(&title, &faces, format, file)
        .map_err(|error| Failure::Found { source: None, findings: vec![error.to_diagnostic()] })?;
    files.keep()?;
    let report = report(&names, &fits, time, settings.degree);
    match arguments.format {
        Format::Json => output::print_json(&report),
        Format::Text => {
            if !terminal.quiet {
                say(&text(&report, &arguments.output));
            }
            Ok(())
        }
    }
}

fn format_of(path: &Path, schema: Schema) -> Result<CadFormat, Failure> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().into_owned()).unwrap_or_default();
    CadFormat::from_extension(&extension, schema).ok_or_else(|| {
        let known: Vec<String> = CadFormat::EXTENSIONS.iter().map(|extension| format!(".{extension}")).collect();
        let what =
            if extension.is_empty() { "no extension".to_owned() } else { format!("the extension `.{extension}`") };
        Failure::Usage(format!("`{}` has {what}; write {}", path.display(), known.join(", ")))
    })
}

fn settings(degree: usize, tolerance: Option<&str>) -> Result<Settings, Failure> {
    let Some(text) = tolerance else { return Ok(Settings { degree, tolerance: None }) };
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    let tolerance = number.ok_or_else(|| {
        let finding = Diagnostic::new(Code::SettingOutOfRange, format!("the tolerance `{text}` is no positive length"));
        option_finding("tolerance", text, finding.hint("write a number, for example 1e-6"))
    })?;
    Ok(Settings { degree, tolerance: Some(tolerance) })
}

fn report(names: &[String], fits: &[Fitted], time: f64, degree: usize) -> Report {
    let patch = |(name, fit): (&String, &Fitted)| PatchReport {
        name: name.clone(),
        time,
        degree,
        control_points: fit.surface.knots().map(KnotVector::points),
        tolerance: fit.tolerance,
        deviation: fit.deviation,
        edge_deviation: fit.edge_deviation,
        tangent_deviation: fit.tangent_deviation,
        closed_in_v: fit.is_closed_in_v,
    };
    Report { patches: names.iter().zip(fits).map(patch).collect() }
}

fn text(report: &Report, path: &Path) -> String {
    let line = |patch: &PatchReport| {
        let [rows, columns] = patch.control_points;
        let closed = if patch.closed_in_v { ", closed in v" } else { "" };
        format!(
            "wrote {}: {} at t = {}, degree {}, {rows} x {columns} points{closed}; largest deviation {:.1e} of {:.1e} allowed",
            path.display(),
            patch.name,
            patch.time,
            patch.degree,
            patch.deviation,
            patch.tolerance
        )
    };
    report.patches.iter().map(line).collect::<Vec<_>>().join("\n")
}
