//! `trimline fit`: surfaces as B-splines, for CAD programs.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic, Shortest};
use trimline::export::{CadFormat, Face, Schema, write_cad};
use trimline::fit::{Fitted, Settings, Target, fit};
use trimline::surface::{BsplineSurface, KnotVector};

use crate::Outcome;
use crate::failure::{Failure, print_warnings, say};
use crate::options::{Collocation, Format, Solving, Terminal, option_finding, read_count};
use crate::output;
use crate::parts::{Located, Shape};
use crate::workflow::Spec;

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
    #[arg(long, value_name = "P", value_parser = read_count, default_value_t = 3)]
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
    /// Whether it is an approximation; a net is written exactly.
    is_fit: bool,
}

pub fn run(mut arguments: Arguments, terminal: &Terminal) -> Outcome {
    let schema = match arguments.schema {
        Protocol::Ap214 => Schema::Ap214,
        Protocol::Ap242 => Schema::Ap242,
    };
    let format = output::by_extension(&arguments.output, &CadFormat::EXTENSIONS, |extension| {
        CadFormat::from_extension(extension, schema)
    })?;
    // The option is this command's own; a method takes its tolerance from the spec.
    let tolerance = arguments.solving.tolerance.take();
    let settings = settings(arguments.degree, tolerance.as_deref())?;
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    let points = arguments.collocation.points.as_deref();
    let parts = spec.parts(&arguments.solving, points)?;
    if parts.is_empty() {
        return Err(spec.fault(Diagnostic::new(Code::EmptyDocument, "there is no patch to fit")));
    }
    let time = spec.instant(&parts, arguments.solving.time)?;
    let shapes: Vec<Shape> = parts.iter().map(|part| spec.shape(part, time)).collect::<Result<_, _>>()?;
    for shape in &shapes {
        print_warnings(&shape.warnings, &spec.source, terminal);
    }
    let names: Vec<String> = parts.iter().map(|part| part.name().to_owned()).collect();
    // A net, and a copy of one, is a B-spline already, and is written as it is.
    let fitted = parts.iter().zip(&shapes).filter(|(_, shape)| shape.bspline.is_none()).map(|(part, shape)| {
        let domain = part.domain();
        Target { name: part.name(), surface: &*shape.surface, u: domain.u, v: domain.v }
    });
    let fitted: Vec<Target<'_>> = fitted.collect();
    let mut fits = match fitted.as_slice() {
        [] => Vec::new(),
        targets => fit(targets, time, &settings, &spec.limits)
            .map_err(|finding| about_settings(finding, settings.degree, tolerance.as_deref()))?,
    }
    .into_iter();
    let (mut faces, mut reports) = (Vec::new(), Vec::new());
    for (name, shape) in names.iter().zip(shapes) {
        let (surface, report) = match shape.bspline {
            Some(bspline) => {
                let report = written(name, &bspline, time);
                (bspline, report)
            }
            None => {
                let fit = fits.next().ok_or_else(|| Failure::Machine("a patch was not fitted".to_owned()))?;
                let report = report(name, &fit, time, settings.degree);
                (fit.surface, report)
            }
        };
        faces.push(Face { name: name.clone(), surface });
        reports.push(report);
    }
    let mut files = output::Files::default();
    let title = names.join(", ");
    let file: &mut dyn Write = files.create(&arguments.output)?;
    write_cad(&title, &faces, format, file)
        .map_err(|error| Failure::Found { source: None, findings: vec![error.to_diagnostic()] })?;
    files.keep()?;
    let report = Report { patches: reports };
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

/// A finding about a setting that is out of range is shown in the option that it is about.
fn about_settings(finding: Diagnostic, degree: usize, tolerance: Option<&str>) -> Failure {
    match tolerance {
        _ if finding.code != Code::SettingOutOfRange => Failure::Found { source: None, findings: vec![finding] },
        Some(tolerance) if finding.message.contains("tolerance") => option_finding("tolerance", tolerance, finding),
        _ => option_finding("degree", &degree.to_string(), finding),
    }
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

fn report(name: &str, fit: &Fitted, time: f64, degree: usize) -> PatchReport {
    PatchReport {
        name: name.to_owned(),
        time,
        degree,
        control_points: fit.surface.knots().map(KnotVector::points),
        tolerance: fit.tolerance,
        deviation: fit.deviation,
        edge_deviation: fit.edge_deviation,
        tangent_deviation: fit.tangent_deviation,
        closed_in_v: fit.is_closed_in_v,
        is_fit: true,
    }
}

/// The report on a net, which is written exactly.
fn written(name: &str, surface: &BsplineSurface, time: f64) -> PatchReport {
    let [u, v] = surface.knots();
    PatchReport {
        name: name.to_owned(),
        time,
        degree: u.degree(),
        control_points: [u.points(), v.points()],
        tolerance: 0.0,
        deviation: 0.0,
        edge_deviation: 0.0,
        tangent_deviation: 0.0,
        closed_in_v: false,
        is_fit: false,
    }
}

fn text(report: &Report, path: &Path) -> String {
    let line = |patch: &PatchReport| {
        let [rows, columns] = patch.control_points;
        let closed = if patch.closed_in_v { ", closed in v" } else { "" };
        let deviation = match patch.is_fit {
            true => format!("largest deviation {:.1e} of {:.1e} allowed", patch.deviation, patch.tolerance),
            false => "its own net".to_owned(),
        };
        format!(
            "wrote {}: {} at t = {}, degree {}, {rows} x {columns} points{closed}; {deviation}",
            path.display(),
            patch.name,
            Shortest(patch.time),
            patch.degree,
        )
    };
    report.patches.iter().map(line).collect::<Vec<_>>().join("\n")
}
