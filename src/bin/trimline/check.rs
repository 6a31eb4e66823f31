//! `trimline check`: reads, resolves, solves and measures.

mod text;

pub use text::instants_text;

use clap::Args;
use serde::Serialize;

use trimline::diagnostic::Shortest;
use trimline::expr::{Notation, Variable};
use trimline::morph::{ends, interpolate};
use trimline::problem::{Explanation, Patch, describe};
use trimline::threads;
use trimline::verify::{ApexDeviation, JoinDeviation, Verification, verify_apexes, verify_joins};

use crate::Outcome;
use crate::bounds::{Bounds, Exceeded, Measured, Quantity};
use crate::failure::{Failure, Said};
use crate::finding::{Finding, Findings};
use crate::joins::{self, JoinReport};
use crate::nets::{self, NetReport};
use crate::options::{Collocation, Format, Solving, Terminal};
use crate::output;
use crate::parts::{Located, Part};
use crate::seams::{self, SeamReport};
use crate::workflow::{Patched, Solved, Spec, common_times};
use text::text;

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

    #[command(flatten)]
    bounds: Bounds,

    /// How to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Instants inside the time domain at which a patch is measured unless the user names one.
const INNER_INSTANTS: usize = 7;

/// A residual that deserves a word.
const LARGE_RESIDUAL: f64 = 0.1;

/// What was measured of all specs.
#[derive(Serialize)]
struct Report<'a> {
    patches: Vec<Of<'a, PatchReport>>,
    nets: Vec<Of<'a, NetReport>>,
    copies: Vec<Of<'a, CopyReport>>,
    seams: Vec<Of<'a, SeamReport>>,
    findings: Vec<Of<'a, Finding>>,
    exceeded: Vec<Of<'a, Exceeded>>,
    passed: bool,
}

/// Something of one spec.
#[derive(Serialize)]
struct Of<'a, T> {
    spec: &'a str,
    #[serde(flatten)]
    what: &'a T,
}

/// What was measured of one spec, and what there is to say about it.
#[derive(Default)]
struct Checked {
    spec: String,
    patches: Vec<PatchReport>,
    nets: Vec<NetReport>,
    copies: Vec<CopyReport>,
    seams: Vec<SeamReport>,
    findings: Vec<Finding>,
    exceeded: Vec<Exceeded>,
    /// Whether it could be measured.
    is_sound: bool,
    passed: bool,
}

#[derive(Serialize)]
struct PatchReport {
    name: String,
    method: &'static str,
    boundaries: Vec<Boundary>,
    joins: Vec<JoinReport>,
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

impl Boundary {
    /// `S at u = 0`
    fn describe(&self) -> String {
        let across = if self.u.is_some() { Variable::U } else { Variable::V };
        describe(None, self.order, across, self.u.or(self.v).unwrap_or(f64::NAN))
    }
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

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    arguments.bounds.check()?;
    let mut all: Vec<Checked> = Vec::new();
    let mut failures: Vec<Failure> = Vec::new();
    for path in &arguments.spec {
        let mut findings = Findings { terminal, all: Vec::new() };
        let checked = check(path, arguments, &mut findings);
        let mut checked = checked.unwrap_or_else(|failure| {
            findings.all.extend(Finding::of_failure(&failure));
            failures.push(failure);
            Checked::default()
        });
        checked.spec.clone_from(path);
        checked.findings = findings.all;
        let warnings = checked.findings.iter().filter_map(Finding::warning);
        checked.exceeded = arguments.bounds.exceeded(&measured(&checked), warnings);
        checked.passed &= checked.exceeded.is_empty();
        all.push(checked);
    }
    // Of several faults each is reported; the last one decides the status.
    let last = failures.pop();
    failures.iter().for_each(|failure| failure.print(terminal));
    match arguments.format {
        Format::Text if all.iter().any(|checked| checked.is_sound) => output::print(&text(&all))?,
        Format::Text => {}
        Format::Json => output::print_json(&report(&all))?,
    }
    match last {
        Some(failure) => Err(failure),
        None if all.iter().all(|checked| checked.passed) => Ok(()),
        None => Err(Failure::NotPassed),
    }
}

fn report(all: &[Checked]) -> Report<'_> {
    fn of<'a, T>(all: &'a [Checked], list: impl Fn(&'a Checked) -> &'a [T]) -> Vec<Of<'a, T>> {
        all.iter().flat_map(|checked| list(checked).iter().map(|what| Of { spec: &checked.spec, what })).collect()
    }
    Report {
        patches: of(all, |checked| &checked.patches),
        nets: of(all, |checked| &checked.nets),
        copies: of(all, |checked| &checked.copies),
        seams: of(all, |checked| &checked.seams),
        findings: of(all, |checked| &checked.findings),
        exceeded: of(all, |checked| &checked.exceeded),
        passed: all.iter().all(|checked| checked.passed),
    }
}

/// Every number on which there can be a bound.
fn measured(checked: &Checked) -> Vec<Measured> {
    let mut measured = Vec::new();
    let mut add = |quantity, place: &str, value| measured.push(Measured { quantity, place: place.to_owned(), value });
    for patch in &checked.patches {
        for boundary in patch.boundaries.iter().filter(|boundary| boundary.order == 0) {
            let place = format!("{} of {}", boundary.describe(), patch.name);
            add(Quantity::Gap, &place, Some(boundary.max_error));
        }
        for join in &patch.joins {
            let place = format!("{} at u = {} of {}", join.surface, Shortest(join.u), patch.name);
            add(Quantity::Gap, &place, Some(join.gap));
            add(Quantity::Angle, &place, join.angle_degrees);
        }
        add(Quantity::Residual, &format!("PDE residual of {}", patch.name), Some(patch.pde_residual));
    }
    for seam in &checked.seams {
        let place = seam.describe();
        add(Quantity::Gap, &place, Some(seam.gap));
        add(Quantity::Angle, &place, seam.angle_degrees);
    }
    measured
}

fn check(path: &str, arguments: &Arguments, findings: &mut Findings<'_>) -> Result<Checked, Failure> {
    let spec = Spec::read(path, &arguments.solving.reading)?;
    findings.warn(&spec.warnings, &spec.source);
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
    let solved = parts.iter().zip(&times).filter_map(|(part, times)| match measured_part(part) {
        Part::Patch(patched) => Some(times.iter().map(move |time| (&**patched, *time))),
        _ => None,
    });
    let mut solutions =
        threads::map(solved.flatten().collect(), |(patched, time)| measure(&spec, patched, time)).into_iter();
    for (part, times) in parts.iter().zip(times) {
        if let Part::Copy(copied) = part {
            let original = copied.original.name().to_owned();
            copies.push(CopyReport { name: part.name().to_owned(), original });
            if copied.stands_in {
                // No seam needs it where it is, perhaps too far away.
                times.iter().try_for_each(|time| spec.shape(part, *time).map(drop))?;
            }
        }
        let part = measured_part(part);
        let patched = match part {
            Part::Patch(patched) => patched,
            Part::Net(_) => {
                net_reports.push(nets::report(&spec, part, times, findings)?);
                continue;
            }
            // Its original is among the parts.
            Part::Copy(_) => continue,
        };
        let mut worst: Option<Verification> = None;
        let mut joins: Option<Vec<JoinDeviation>> = None;
        let mut apexes: Option<Vec<ApexDeviation>> = None;
        let mut method = "";
        let mut amplification: Option<f64> = None;
        let mut largest_residual = (0.0, times.first().copied().unwrap_or_default());
        let mut said = Said::default();
        for &time in &times {
            let Some(here) = solutions.next() else { break };
            let AtInstant { solved, joins: met, apexes: found } = here?;
            method = solved.solution.report.method;
            let here = solved.solution.report.amplification;
            amplification = here.into_iter().chain(amplification).reduce(f64::max);
            findings.warn(&said.news(solved.solution.report.warnings), &spec.source);
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
    let surfaces_at = |time| {
        let surface = |part: &Part| {
            let exists = holds(part.domain().t, time);
            exists.then(|| spec.shape(part, time).map(|shape| shape.surface)).transpose()
        };
        threads::try_map(parts.iter().collect(), surface)
    };
    let times = seam_times(arguments, &spec, &parts);
    let (seams, open) = seams::measure(&spec, &parts.iter().collect::<Vec<_>>(), &times, surfaces_at)?;
    let passed = open.is_empty();
    if !passed {
        let open = Failure::found(&spec.source, open);
        open.print(findings.terminal);
        findings.all.extend(Finding::of_failure(&open));
    }
    Ok(Checked { patches: reports, nets: net_reports, copies, seams, passed, is_sound: true, ..Checked::default() })
}

/// What is measured in place of `part`: of a copy that stands in for its original, the original.
fn measured_part(part: &Part) -> &Part {
    match part {
        Part::Copy(copied) if copied.stands_in => &copied.original,
        part => part,
    }
}

/// A patch at one instant.
struct AtInstant {
    solved: Solved,
    joins: Vec<JoinDeviation>,
    apexes: Vec<ApexDeviation>,
}

fn measure(spec: &Spec, patched: &Patched, time: f64) -> Result<AtInstant, Failure> {
    let solved = spec.solve(patched, time)?;
    let (patch, surface) = (patched.prepared.patch(), &*solved.solution.surface);
    let at = (&spec.bindings, &patched.prepared.domain, time);
    let fault = |finding| spec.fault(finding);
    let joins = verify_joins(&spec.problem, patch, surface, at, &spec.limits).map_err(fault)?;
    let apexes = verify_apexes(&spec.problem, patch, surface, at).map_err(fault)?;
    Ok(AtInstant { solved, joins, apexes })
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

/// The instants at which seams are measured: those of whatever time two parts have in common. None where no seam can be.
fn seam_times(arguments: &Arguments, spec: &Spec, parts: &[Part]) -> Vec<f64> {
    if parts.len() < 2 && spec.problem.seams.is_empty() {
        return Vec::new();
    }
    if let Some(time) = arguments.solving.time {
        return vec![time];
    }
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        for other in parts.iter().skip(index) {
            ranges.extend(common_times(&[part, other]).filter(|range| !ranges.contains(range)));
        }
    }
    let mut times: Vec<f64> = ranges.into_iter().flat_map(measured_instants).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

fn holds([start, end]: [f64; 2], time: f64) -> bool {
    (start..=end).contains(&time)
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
