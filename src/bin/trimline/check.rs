//! `trimline check`: reads, resolves, solves and measures.

use std::fmt::Write;

use clap::Args;
use serde::Serialize;

use trimline::diagnostic::Shortest;
use trimline::expr::{Notation, Variable};
use trimline::morph::{ends, interpolate};
use trimline::problem::{Explanation, Patch, describe};
use trimline::threads;
use trimline::verify::{ApexDeviation, JoinDeviation, Verification, verify_apexes, verify_joins};

use crate::Outcome;
use crate::failure::{Failure, Said, print_warnings};
use crate::joins::{self, JoinReport};
use crate::nets::{self, NetReport};
use crate::options::{Collocation, Format, Solving, Terminal};
use crate::output::{self, rounded};
use crate::parts::{Located, Part};
use crate::seams::{self, SeamReport};
use crate::workflow::{Patched, Solved, Spec, common_times};

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

    /// Fail if the surface misses a prescribed position, a joined surface or a seam by more than this.
    #[arg(long, value_name = "LENGTH")]
    max_gap: Option<f64>,

    /// Fail if the surface meets a joined surface, or another patch at a seam, at a larger angle than this.
    #[arg(long, value_name = "DEGREES")]
    max_angle: Option<f64>,

    /// How to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Instants inside the time domain at which a patch is measured unless the user names one.
const INNER_INSTANTS: usize = 7;

/// A residual that deserves a word.
const LARGE_RESIDUAL: f64 = 0.1;

#[derive(Serialize)]
struct Report {
    patches: Vec<PatchReport>,
    nets: Vec<NetReport>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    copies: Vec<CopyReport>,
    seams: Vec<SeamReport>,
    passed: bool,
}

#[derive(Serialize)]
struct PatchReport {
    name: String,
    method: &'static str,
    boundaries: Vec<Boundary>,
    joins: Vec<JoinReport>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    apexes: Vec<ApexReport>,
    pde_residual: f64,
    /// The instant at which the residual is that large.
    pde_residual_time: f64,
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
    #[serde(skip_serializing_if = "String::is_empty")]
    data: String,
    equation: String,
    domain: String,
    constraints: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    deformations: String,
    #[serde(skip)]
    whole: String,
}

#[derive(Serialize)]
struct Boundary {
    #[serde(skip_serializing_if = "Option::is_none")]
    u: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    v: Option<f64>,
    order: usize,
    max_error: f64,
}

/// A side that is a point.
#[derive(Serialize)]
struct ApexReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    u: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    v: Option<f64>,
    /// By how much tangents leave one plane; null if they span none.
    angle_degrees: Option<f64>,
}

/// A copy, of which holds what holds of its original.
#[derive(Serialize)]
struct CopyReport {
    name: String,
    original: String,
}

/// What one spec adds to the report, and the stated seams that are open.
type Checked = (Vec<PatchReport>, Vec<NetReport>, Vec<CopyReport>, Vec<SeamReport>, Option<Failure>);

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    for (option, most) in [("--max-gap", arguments.max_gap), ("--max-angle", arguments.max_angle)] {
        if most.is_some_and(|most| most.is_nan() || most < 0.0) {
            return Err(Failure::Usage(format!("{option} takes a number, 0 or more")));
        }
    }
    let mut report =
        Report { patches: Vec::new(), nets: Vec::new(), copies: Vec::new(), seams: Vec::new(), passed: true };
    let mut failures: Vec<Failure> = Vec::new();
    for path in &arguments.spec {
        match check(path, arguments, terminal) {
            Ok((patches, nets, copies, seams, open)) => {
                report.patches.extend(patches);
                report.nets.extend(nets);
                report.copies.extend(copies);
                report.seams.extend(seams);
                report.passed &= open.is_none();
                if let Some(open) = open {
                    open.print(terminal);
                }
            }
            Err(failure) => failures.push(failure),
        }
    }
    // With several specs each fault is reported; the last one decides the status.
    if let Some(last) = failures.pop() {
        failures.iter().for_each(|failure| failure.print(terminal));
        return Err(last);
    }
    report.passed &= is_within(arguments.max_gap, gaps(&report).map(Some));
    report.passed &= is_within(arguments.max_angle, angles(&report));
    match arguments.format {
        Format::Text => output::print(&text(&report))?,
        Format::Json => output::print_json(&report)?,
    }
    if report.passed { Ok(()) } else { Err(Failure::NotPassed) }
}

/// Whether all values are at most `most`; what has none, such as an angle without normals, is not shown to be small.
fn is_within(most: Option<f64>, mut found: impl Iterator<Item = Option<f64>>) -> bool {
    most.is_none_or(|most| found.all(|found| found.is_some_and(|found| found <= most)))
}

/// Every measured distance.
fn gaps(report: &Report) -> impl Iterator<Item = f64> {
    let boundaries = report.patches.iter().flat_map(|patch| &patch.boundaries).filter(|boundary| boundary.order == 0);
    let joins = report.patches.iter().flat_map(|patch| &patch.joins).map(|join| join.gap);
    boundaries.map(|boundary| boundary.max_error).chain(joins).chain(report.seams.iter().map(|seam| seam.gap))
}

/// Every measured angle.
fn angles(report: &Report) -> impl Iterator<Item = Option<f64>> {
    let joins = report.patches.iter().flat_map(|patch| &patch.joins).map(|join| join.angle_degrees);
    joins.chain(report.seams.iter().map(|seam| seam.angle_degrees))
}

fn check(path: &str, arguments: &Arguments, terminal: &Terminal) -> Result<Checked, Failure> {
    let spec = Spec::read(path, &arguments.solving.reading)?;
    print_warnings(&spec.warnings, &spec.source, terminal);
    // A stated morph that cannot be made is a fault of the spec, though its patches are sound.
    if let Some([source, target]) = ends(&spec.problem) {
        interpolate(&source, &target, &spec.limits).map_err(|finding| spec.fault(finding))?;
    }
    let mut reports = Vec::new();
    let parts = spec.parts(&arguments.solving, arguments.collocation.points.as_deref())?;
    let (mut net_reports, mut copies) = (Vec::new(), Vec::new());
    let times_of = |part: &Part| match arguments.solving.time {
        Some(_) => part.instant(arguments.solving.time).map(|time| vec![time]),
        None => Ok(measured_instants(part.domain().t)),
    };
    let times = parts.iter().map(times_of).collect::<Result<Vec<_>, _>>()?;
    // What takes time, in any order; what there is to say follows in the order of parts and instants.
    let solved = parts.iter().zip(&times).filter_map(|(part, times)| match part {
        Part::Patch(patched) => Some(times.iter().map(move |time| (&**patched, *time))),
        _ => None,
    });
    let mut measured =
        threads::map(solved.flatten().collect(), |(patched, time)| measure(&spec, patched, time)).into_iter();
    for (part, times) in parts.iter().zip(times) {
        let patched = match part {
            Part::Patch(patched) => patched,
            Part::Net(_) => {
                net_reports.push(nets::report(&spec, part, times, terminal)?);
                continue;
            }
            Part::Copy(copied) => {
                let original = copied.original.name().to_owned();
                copies.push(CopyReport { name: part.name().to_owned(), original });
                continue;
            }
        };
        let mut worst: Option<Verification> = None;
        let mut joins: Option<Vec<JoinDeviation>> = None;
        let mut apexes: Option<Vec<ApexDeviation>> = None;
        let mut method = "";
        let mut amplification: Option<f64> = None;
        let mut largest_residual = (0.0, times.first().copied().unwrap_or_default());
        let mut said = Said::default();
        for &time in &times {
            let Some(here) = measured.next() else { break };
            let Measured { solved, joins: met, apexes: found } = here?;
            method = solved.solution.report.method;
            let here = solved.solution.report.amplification;
            amplification = here.into_iter().chain(amplification).reduce(f64::max);
            print_warnings(&said.news(solved.solution.report.warnings), &spec.source, terminal);
            if solved.measured.relative_residual() > largest_residual.0 {
                largest_residual = (solved.measured.relative_residual(), time);
            }
            joins = Some(match joins {
                Some(before) => before.into_iter().zip(&met).map(|(before, met)| before.worst(met)).collect(),
                None => met,
            });
            apexes = Some(worse_apexes(apexes, found));
            worst = Some(match worst {
                Some(before) => before.worst(&solved.measured),
                None => solved.measured,
            });
        }
        if let Some(worst) = worst {
            let report = patch_report(&spec, patched, method, &worst, times)?;
            let joins = joins::reports(&spec, patched, joins.unwrap_or_default())?;
            let explanation =
                if arguments.explain { Some(explanations(&spec, patched.prepared.patch())?) } else { None };
            reports.push(PatchReport {
                amplification,
                joins,
                apexes: apexes.unwrap_or_default().into_iter().map(apex_report).collect(),
                explanation,
                pde_residual_time: largest_residual.1,
                ..report
            });
        }
    }
    let (seams, open) = match seam_times(arguments, &spec, &parts) {
        Some(times) => {
            let surfaces_at =
                |time| threads::try_map(parts.iter().collect(), |part| Ok(spec.shape(part, time)?.surface));
            seams::measure(&spec, &parts.iter().collect::<Vec<_>>(), &times, surfaces_at)?
        }
        None => Default::default(),
    };
    let open = if open.is_empty() { None } else { Some(Failure::found(&spec.source, open)) };
    Ok((reports, net_reports, copies, seams, open))
}

/// A patch at one instant.
struct Measured {
    solved: Solved,
    joins: Vec<JoinDeviation>,
    apexes: Vec<ApexDeviation>,
}

fn measure(spec: &Spec, patched: &Patched, time: f64) -> Result<Measured, Failure> {
    let solved = spec.solve(patched, time)?;
    let (patch, surface) = (patched.prepared.patch(), &*solved.solution.surface);
    let at = (&spec.bindings, &patched.prepared.domain, time);
    let fault = |finding| spec.fault(finding);
    let joins = verify_joins(&spec.problem, patch, surface, at, &spec.limits).map_err(fault)?;
    let apexes = verify_apexes(&spec.problem, patch, surface, at).map_err(fault)?;
    Ok(Measured { solved, joins, apexes })
}

/// Those sides that are points at all instants so far, each at its worst.
fn worse_apexes(before: Option<Vec<ApexDeviation>>, here: Vec<ApexDeviation>) -> Vec<ApexDeviation> {
    let Some(before) = before else { return here };
    let both = |known: ApexDeviation| {
        let same = |other: &&ApexDeviation| other.across == known.across && other.position == known.position;
        let other = here.iter().find(same)?;
        Some(ApexDeviation { apex: known.apex.worst(other.apex), ..known })
    };
    before.into_iter().filter_map(both).collect()
}

fn apex_report(ApexDeviation { across, position, apex }: ApexDeviation) -> ApexReport {
    let is_at_u = across == Variable::U;
    let (u, v) = (is_at_u.then_some(position), (!is_at_u).then_some(position));
    ApexReport { u, v, angle_degrees: apex.angle_degrees }
}

/// The instants at which seams are measured; `None` if there can be none.
fn seam_times(arguments: &Arguments, spec: &Spec, parts: &[Part]) -> Option<Vec<f64>> {
    let range = common_times(parts).filter(|_| parts.len() > 1 || !spec.problem.seams.is_empty());
    match (range, arguments.solving.time) {
        (None, _) => None,
        (Some(_), Some(time)) => Some(vec![time]),
        (Some(range), None) => Some(measured_instants(range)),
    }
}

/// Both ends of the time, and instants between them at multiples of the golden section: evenly spaced ones would all be
/// zeros of some motion that repeats within the time.
fn measured_instants([start, end]: [f64; 2]) -> Vec<f64> {
    if start == end {
        return vec![start];
    }
    let shares = (1..=INNER_INSTANTS).map(|k| (k as f64 * 0.618_033_988_749_894_8).fract());
    let mut times: Vec<f64> = shares.map(|share| start + share * (end - start)).chain([start, end]).collect();
    times.sort_by(f64::total_cmp);
    times
}

fn patch_report(
    spec: &Spec,
    patched: &Patched,
    method: &'static str,
    worst: &Verification,
    times: Vec<f64>,
) -> Result<PatchReport, Failure> {
    let mut boundaries = Vec::new();
    let patch = patched.prepared.patch();
    let at_u = patch.conditions.iter().map(|condition| (Variable::U, condition.u, condition.order));
    let at_v = patch.side_conditions.iter().map(|condition| (Variable::V, condition.v, condition.order));
    for ((across, position, order), max_error) in at_u.chain(at_v).zip(&worst.boundary_errors) {
        let position = spec.bindings.constant(&spec.problem, position, None, "the position of a boundary");
        let position = position.map_err(|finding| spec.fault(finding))?;
        let (u, v) = if across == Variable::U { (Some(position), None) } else { (None, Some(position)) };
        boundaries.push(Boundary { u, v, order, max_error: *max_error });
    }
    Ok(PatchReport {
        name: patched.prepared.patch().name.clone(),
        method,
        boundaries,
        joins: Vec::new(),
        apexes: Vec::new(),
        pde_residual: worst.relative_residual(),
        pde_residual_time: 0.0,
        amplification: None,
        times,
        explanation: None,
    })
}

fn explanations(spec: &Spec, patch: &Patch) -> Result<Explanations, Failure> {
    let explained = |notation: Notation| {
        let explanation = spec.problem.explain(patch, notation, &spec.limits).map_err(|finding| spec.fault(finding))?;
        let whole = explanation.to_text();
        let Explanation { parameters: params, data, equation, domain, constraints, deformations } = explanation;
        Ok::<_, Failure>(Explained { params, data, equation, domain, constraints, deformations, whole })
    };
    Ok(Explanations { unicode: explained(Notation::Unicode)?, latex: explained(Notation::Latex)? })
}

/// Writing to a string does not fail.
fn text(report: &Report) -> String {
    let mut text = String::new();
    for patch in &report.patches {
        let when = instants_text(&patch.times);
        if let Some(explanation) = &patch.explanation {
            let (unicode, latex) = (&explanation.unicode.whole, &explanation.latex.whole);
            let _ = writeln!(text, "patch {} as it was understood\n\n{unicode}\nin LaTeX\n\n{latex}", patch.name);
        }
        let _ = writeln!(text, "patch {}: method {}, {when}", patch.name, patch.method);
        for boundary in &patch.boundaries {
            let across = if boundary.u.is_some() { Variable::U } else { Variable::V };
            let position = boundary.u.or(boundary.v).unwrap_or(f64::NAN);
            let what = describe(None, boundary.order, across, position);
            let _ = writeln!(text, "  {what:20} largest error {}", rounded(boundary.max_error));
        }
        for join in &patch.joins {
            let _ =
                writeln!(text, "  {:20} {}", format!("{} at u = {}", join.surface, Shortest(join.u)), join_text(join));
        }
        for apex in &patch.apexes {
            let (name, position) = apex.u.map_or(("v", apex.v.unwrap_or(f64::NAN)), |u| ("u", u));
            let angle = match apex.angle_degrees {
                Some(angle) => format!("tangents leave one plane by up to {}°", rounded(angle)),
                None => "tangents span no plane".to_owned(),
            };
            let _ = writeln!(text, "  {:20} {angle}", format!("apex at {name} = {position}"));
        }
        let _ = writeln!(text, "  {:20} {}", "PDE residual", residual_text(patch));
    }
    for net in &report.nets {
        nets::write_report(&mut text, net);
    }
    for CopyReport { name, original } in &report.copies {
        let _ = writeln!(text, "patch {name}: a copy of {original}");
    }
    for SeamReport { between: [a, b], gap, angle_degrees, .. } in &report.seams {
        let places = format!("{} with {}", a.describe(), b.describe());
        let _ = writeln!(text, "seam {places}: gap {}, {}", rounded(*gap), angle_text(*angle_degrees));
    }
    let _ = writeln!(text, "{}", if report.passed { "passed" } else { "not passed" });
    text
}

/// The instants at which something was measured.
pub fn instants_text(times: &[f64]) -> String {
    match times {
        [first, .., last] => format!("{} instants from t = {first} to {last}", times.len()),
        times => times.iter().map(|time| format!("t = {time}")).collect(),
    }
}

fn residual_text(patch: &PatchReport) -> String {
    let mut text = format!("{} of the largest term", rounded(patch.pde_residual));
    if patch.pde_residual > LARGE_RESIDUAL {
        let _ = write!(
            text,
            " at t = {}: the boundary is met, the equation is not solved there",
            Shortest(patch.pde_residual_time)
        );
    }
    text
}

fn join_text(join: &JoinReport) -> String {
    let mut text = format!("gap {}, {}", rounded(join.gap), angle_text(join.angle_degrees));
    if let Some(tangent) = join.tangent {
        let _ = write!(text, ", unit tangents {} apart", rounded(tangent));
    }
    if let Some(curvature) = join.curvature {
        let _ = write!(text, ", curvatures {} apart", rounded(curvature));
    }
    if join.without_normal > 0 {
        let _ = write!(text, "; {} points without a normal", join.without_normal);
    }
    text
}

fn angle_text(angle: Option<f64>) -> String {
    angle.map_or_else(|| "no normals to compare".to_owned(), |angle| format!("angle {}°", rounded(angle)))
}
