//! `trimline bench`: how fast a spec compiles, solves and is evaluated here, beside what the machine can do at most.
//!
//! Every figure is the fastest of many repetitions on one thread. Compilation and solution include everything that a
//! user waits for, the measurement of the solution too where it says so.

mod clock;
mod machine;
mod stages;
mod surface;

use std::fmt::Write;
use std::time::Duration;

use clap::Args;
use serde_json::{Map, Value};
use trimline::diagnostic::Shortest;
use trimline::expr::Derivative;
use trimline::threads;

use crate::Outcome;
use crate::failure::Failure;
use crate::options::{Collocation, Format, Solving, Terminal, read_grid};
use crate::output::{self, rounded};
use crate::parts::Located;
use crate::workflow::{Patched, Solved, Spec, read_source};

use clock::Clock;
use machine::Machine;

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// Vertices along u and v of the grid that is evaluated.
    #[arg(long, value_name = "NUxNV", default_value = "1000x1000", allow_hyphen_values = true)]
    grid: String,

    /// How long each figure is measured.
    #[arg(long, value_name = "SECONDS", default_value_t = 0.3)]
    seconds: f64,

    /// How to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// What is measured: one patch of a spec, solved at one instant.
struct Subject<'a> {
    arguments: &'a Arguments,
    spec: &'a Spec,
    patched: &'a Patched,
    solved: &'a Solved,
    /// Vertices along u and v.
    grid: [usize; 2],
}

impl Subject<'_> {
    /// The derivatives of the basis that the equation takes, values first.
    fn derivatives(&self) -> Vec<Derivative> {
        let mut all = vec![Derivative::NONE];
        for term in &self.patched.prepared.patch().operator.terms {
            let along = Derivative { u: 0, ..term.derivative };
            if !all.contains(&along) {
                all.push(along);
            }
        }
        all
    }

    /// The grid's u and v, evenly spaced over the domain.
    fn axes(&self) -> [Vec<f64>; 2] {
        let domain = self.patched.prepared.domain;
        let axis = |[from, to]: [f64; 2], count: usize| {
            (0..count).map(|i| from + (to - from) * i as f64 / (count - 1) as f64).collect()
        };
        [axis(domain.u, self.grid[0]), axis(domain.v, self.grid[1])]
    }

    /// Points `(u, v, t)` all over the domain, the same in every run.
    fn scattered(&self, count: usize) -> Vec<[f64; 3]> {
        let domain = self.patched.prepared.domain;
        // Multiples of three irrational numbers, less their integers: no two points share a coordinate.
        let u = (domain.u, 0.618_033_988_749_894_9);
        let v = (domain.v, 0.414_213_562_373_095_1);
        let t = (domain.t, 0.732_050_807_568_877_2);
        let at = |i: usize| [u, v, t].map(|([from, to], step)| from + (to - from) * (i as f64 * step).fract());
        (1..=count).map(at).collect()
    }
}

/// One figure.
struct Row {
    /// Its key in JSON, with the unit.
    key: &'static str,
    /// What it is, for people.
    about: &'static str,
    unit: &'static str,
    /// `None` where the surface has no such thing.
    value: Option<f64>,
    /// What it is of the machine's limit: a share, and of which limit.
    share: Option<(f64, &'static str)>,
}

impl Row {
    fn new(key: &'static str, about: &'static str, unit: &'static str, value: f64) -> Row {
        Row { key, about, unit, value: Some(value), share: None }
    }

    /// The figure of something that this surface does not have.
    fn none(key: &'static str, about: &'static str, unit: &'static str) -> Row {
        Row { key, about, unit, value: None, share: None }
    }

    fn of_limit(self, share: f64, limit: &'static str) -> Row {
        Row { share: Some((share, limit)), ..self }
    }
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    // The limits are those of one core.
    let measured = threads::with(1, || measure(arguments, terminal));
    measured.unwrap_or_else(|error| Err(Failure::Machine(error.to_string())))
}

fn measure(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let clock = Clock { budget: budget(arguments.seconds)? };
    let (u, v) = read_grid(&arguments.grid)?;
    if u < 2 || v < 2 {
        return Err(Failure::Usage(format!("`{}` has no surface: give at least 2x2 vertices", arguments.grid)));
    }
    let reading = &arguments.solving.reading;
    let limits = reading.limits()?;
    if u.saturating_mul(v) > limits.samples {
        let message = format!("{u} x {v} vertices are above the limit `samples` of {}", limits.samples);
        return Err(Failure::Usage(format!("{message}: choose a smaller --grid, or raise the limit")));
    }
    let spec = Spec::of(read_source(&arguments.spec, &limits)?, reading)?;
    spec.without_nets("bench")?;
    let Some(patch) = spec.patches.first() else {
        return Err(Failure::Usage("the spec has no patch to be measured".to_owned()));
    };
    if let [_, _, ..] = spec.patches.as_slice() {
        let names: Vec<&str> = spec.patches.iter().map(|patch| patch.name.as_str()).collect();
        let message = "one patch is measured: name it with --patch";
        return Err(Failure::Usage(format!("{message}; patches: {}", names.join(", "))));
    }
    let patched = spec.prepare(patch, &arguments.solving, arguments.collocation.points.as_deref())?;
    let solved = spec.solve(&patched, patched.instant(arguments.solving.time)?)?;
    crate::failure::print_warnings(&solved.solution.report.warnings, &spec.source, terminal);
    let subject = Subject { arguments, spec: &spec, patched: &patched, solved: &solved, grid: [u, v] };
    let machine = Machine::measure(&clock);
    let mut rows = machine.rows();
    rows.extend(stages::measure(&subject, &clock)?);
    rows.extend(surface::measure(&subject, &clock, &machine)?);
    match arguments.format {
        Format::Text => output::print(&text(&subject, &machine, &rows)),
        Format::Json => output::print_json(&json(&subject, &machine, &rows)),
    }
}

fn budget(seconds: f64) -> Result<Duration, Failure> {
    Some(seconds)
        .filter(|seconds| (0.0..=3600.0).contains(seconds))
        .map(Duration::from_secs_f64)
        .ok_or_else(|| Failure::Usage(format!("--seconds {seconds}: give a number from 0 to 3600")))
}

fn text(subject: &Subject<'_>, machine: &Machine, rows: &[Row]) -> String {
    let report = &subject.solved.solution.report;
    let name = &subject.patched.prepared.patch().name;
    let (method, functions) = (report.method, report.basis_size);
    let mut text = format!(
        "patch {name}: method {method}, {functions} basis functions, t = {}\none thread, {}\n\n",
        Shortest(subject.solved.time),
        machine.instructions
    );
    for row in rows {
        let value = row.value.map_or_else(|| "none".to_owned(), |value| format!("{} {}", rounded(value), row.unit));
        let share = row.share.map(|(share, limit)| format!("   {:.0} % of {limit}", 100.0 * share)).unwrap_or_default();
        // Writing to a string does not fail.
        let _ = writeln!(text, "{:44} {value:>18}{share}", row.about);
    }
    text
}

fn json(subject: &Subject<'_>, machine: &Machine, rows: &[Row]) -> Value {
    let report = &subject.solved.solution.report;
    let mut all = Map::new();
    all.insert("patch".to_owned(), subject.patched.prepared.patch().name.clone().into());
    all.insert("method".to_owned(), report.method.into());
    all.insert("basis_size".to_owned(), report.basis_size.into());
    all.insert("time".to_owned(), subject.solved.time.into());
    all.insert("grid".to_owned(), subject.grid.to_vec().into());
    all.insert("threads".to_owned(), 1.into());
    all.insert("instructions".to_owned(), machine.instructions.into());
    let mut shares = Map::new();
    for row in rows {
        all.insert(row.key.to_owned(), row.value.into());
        if let Some((share, _)) = row.share {
            shares.insert(row.key.to_owned(), share.into());
        }
    }
    all.insert("shares".to_owned(), shares.into());
    all.into()
}
