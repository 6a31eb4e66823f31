//! From a spec's path to solved patches: the pipeline as commands use it, with its times.

use std::io::{ErrorKind, Read};
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use trimline::blend::Prepared;
use trimline::decompose::{Decomposition, decompose};
use trimline::diagnostic::{Code, Diagnostic, Diagnostics, Shortest, Source, Span};
use trimline::eval::Backend;
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::method::{Known, Options, Settings, Solution};
use trimline::problem::{Bindings, Net, Patch, PatchCopy, PrimarySurface, Problem};
use trimline::resolve::{resolve, review, set_parameter};
use trimline::syntax;
use trimline::verify::Verification;

use crate::failure::Failure;
use crate::files;
use crate::options::{Reading, Solving, option_finding};
use crate::parts::Located;

/// A spec that was read, with the user's parameter values.
#[derive(Clone)]
pub struct Spec {
    pub source: Source,
    pub limits: Limits,
    pub problem: Problem,
    pub bindings: Bindings,
    /// The patches the user asked for.
    pub patches: Vec<Patch>,
    /// The nets the user asked for.
    pub nets: Vec<Net>,
    /// The copies the user asked for.
    pub copies: Vec<PatchCopy>,
    /// What is worth a second look in the text.
    pub warnings: Diagnostics,
    /// Seconds from bytes to problem.
    pub parse_seconds: f64,
    /// What patches have in common.
    pub known: Known,
}

/// A patch that is ready to be solved at any instant, with its times.
pub struct Patched {
    pub prepared: Prepared,
    /// Whether nothing that is stated of it changes with time.
    is_still: bool,
    /// What was solved last: seams, copies and measurements ask for the same instants.
    memory: Mutex<Vec<(Vec<f64>, Solved)>>,
    pub decompose_seconds: f64,
    pub compile_seconds: f64,
}

/// Instants that are remembered: as many as `check` looks at, and a few.
const REMEMBERED: usize = 12;

/// A patch solved at one instant.
#[derive(Clone)]
pub struct Solved {
    pub solution: Solution,
    pub measured: Verification,
    pub time: f64,
    /// Seconds to solve and to measure.
    pub solve_seconds: f64,
}

impl Spec {
    /// Reads `path`, or standard input for `-`.
    pub fn read(path: &str, reading: &Reading) -> Result<Spec, Failure> {
        let start = Instant::now();
        let spec = Spec::of(read_source(path, &reading.limits()?)?, reading)?;
        Ok(Spec { parse_seconds: start.elapsed().as_secs_f64(), ..spec })
    }

    /// As [`Spec::read`], with all patches, nets and copies whichever the user asked for.
    pub fn read_whole(path: &str, reading: &Reading) -> Result<Spec, Failure> {
        Spec::whole(read_source(path, &reading.limits()?)?, reading)
    }

    /// Reads a text; its data files lie beside the path that is its name.
    pub fn of(source: Source, reading: &Reading) -> Result<Spec, Failure> {
        let spec = Spec::whole(source, reading)?;
        let (patches, nets, copies) = select(&spec.problem, reading.patch.as_deref())?;
        Ok(Spec { patches, nets, copies, ..spec })
    }

    fn whole(source: Source, reading: &Reading) -> Result<Spec, Failure> {
        let limits = reading.limits()?;
        let start = Instant::now();
        let mut document = syntax::parse(&source, &limits).map_err(|findings| Failure::found(&source, findings))?;
        let attached = document.attach_files(&limits, |file| files::read(&source.name, file, limits.file_bytes));
        attached.map_err(|findings| Failure::found(&source, findings))?;
        let stem = Path::new(&source.name).file_stem();
        let stem = stem.map_or_else(|| source.name.clone(), |stem| stem.to_string_lossy().into_owned());
        let problem = resolve(&document, &stem, &limits).map_err(|findings| Failure::found(&source, findings))?;
        let warnings = review(&document, &problem);
        let (problem, bindings) = with_values(problem, &source, &reading.set, &limits)?;
        let (patches, nets, copies) = (problem.patches.clone(), problem.nets.clone(), problem.copies.clone());
        let parse_seconds = start.elapsed().as_secs_f64();
        let known = Known::default();
        Ok(Spec { source, limits, problem, bindings, patches, nets, copies, warnings, parse_seconds, known })
    }

    /// This spec with other values of params or coefficients, each `NAME=EXPR`.
    pub fn with(&self, changes: &[String]) -> Result<Spec, Failure> {
        let (problem, bindings) = with_values(self.problem.clone(), &self.source, changes, &self.limits)?;
        Ok(Spec { problem, bindings, ..self.clone() })
    }

    /// A failure that points into this spec.
    pub fn fault(&self, finding: Diagnostic) -> Failure {
        Failure::one(&self.source, finding)
    }

    /// The instants that lie in the time domain of every part; without one it is a fault that names two of the parts.
    pub fn times<P: Located>(&self, parts: &[P]) -> Result<[f64; 2], Failure> {
        common_times(parts).ok_or_else(|| {
            let range = |part: &P| {
                let [start, end] = part.domain().t.map(Shortest);
                format!("`{}` has t in [{start}, {end}]", part.name())
            };
            let [latest, earliest] = [
                parts.iter().max_by(|a, b| a.domain().t[0].total_cmp(&b.domain().t[0])),
                parts.iter().min_by(|a, b| a.domain().t[1].total_cmp(&b.domain().t[1])),
            ];
            let ranges: Vec<String> = [earliest, latest].into_iter().flatten().map(range).collect();
            let message = format!("no instant lies in the time domain of every patch: {}", ranges.join(", "));
            let finding = Diagnostic::new(Code::EmptyDomain, message);
            self.fault(finding.hint("choose patches with --patch, or state one `domain t in [..]` for all"))
        })
    }

    /// The instant that the user asked for, which must lie in the time domain of every part, or the first that does.
    pub fn instant<P: Located>(&self, parts: &[P], time: Option<f64>) -> Result<f64, Failure> {
        let [start, _] = self.times(parts)?;
        parts.iter().try_for_each(|part| part.instant(time).map(|_| ()))?;
        Ok(time.unwrap_or(start))
    }

    /// The ranges of a primary surface's parameters: those stated, otherwise those given.
    pub fn ranges_of(&self, primary: &PrimarySurface, otherwise: [[f64; 2]; 2]) -> Result<[[f64; 2]; 2], Failure> {
        let stated = primary.evaluate_ranges(&self.problem.graph, &self.bindings);
        let [u, v] = stated.map_err(|finding| self.fault(finding))?;
        let [otherwise_u, otherwise_v] = otherwise;
        Ok([u.unwrap_or(otherwise_u), v.unwrap_or(otherwise_v)])
    }

    /// Decomposes a patch.
    pub fn decompose(&self, patch: &Patch) -> Result<Decomposition, Failure> {
        decompose(&self.problem, patch, &self.limits).map_err(|finding| self.fault(finding))
    }

    /// Decomposes and compiles a patch with the method and settings that spec and options give.
    pub fn prepare(&self, patch: &Patch, solving: &Solving, points: Option<&str>) -> Result<Patched, Failure> {
        let settings = solving.settings(points)?;
        self.prepare_with(patch, solving.method.clone(), settings, |finding| solving.fault(points, finding))
    }

    /// As [`Spec::prepare`], with these settings; `about_settings` takes findings that have no place in the spec.
    pub fn prepare_with(
        &self,
        patch: &Patch,
        method: Option<String>,
        settings: Settings,
        about_settings: impl FnOnce(Diagnostic) -> Failure,
    ) -> Result<Patched, Failure> {
        let start = Instant::now();
        let decomposition = self.decompose(patch)?;
        let decompose_seconds = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let options = Options {
            method,
            settings,
            backend: Backend::Auto,
            limits: self.limits.clone(),
            known: self.known.clone(),
        };
        let prepared = Prepared::new(&self.problem, &self.bindings, decomposition, &options);
        let prepared = prepared.map_err(|finding| match finding.span {
            None => about_settings(finding),
            Some(_) => self.fault(finding),
        })?;
        let compile_seconds = start.elapsed().as_secs_f64();
        let (is_still, memory) = (!patch.moves(&self.problem.graph), Mutex::default());
        Ok(Patched { prepared, is_still, memory, decompose_seconds, compile_seconds })
    }

    /// Solves a patch at `time` and measures the solution.
    pub fn solve(&self, patched: &Patched, time: f64) -> Result<Solved, Failure> {
        if let Some(known) = patched.remembered(self.bindings.as_slice(), time) {
            return Ok(known);
        }
        let start = Instant::now();
        let solved = patched.prepared.solve_judged(&self.problem, &self.bindings, time);
        let (solution, measured) = solved.map_err(|finding| self.fault(finding))?;
        let solved = Solved { solution, measured, time, solve_seconds: start.elapsed().as_secs_f64() };
        patched.remember(self.bindings.as_slice(), &solved);
        Ok(solved)
    }
}

impl Patched {
    /// What was solved with these params at this instant; of a patch that does not move, at any.
    fn remembered(&self, params: &[f64], time: f64) -> Option<Solved> {
        let memory = self.memory.lock().unwrap_or_else(PoisonError::into_inner);
        let here = |(known, solved): &&(Vec<f64>, Solved)| {
            known == params && (solved.time == time || (self.is_still && self.holds_at(solved, time)))
        };
        memory.iter().find(here).map(|(_, solved)| Solved { time, ..solved.clone() })
    }

    /// Whether the surface is known at another instant than its own: a fitted one may not be.
    fn holds_at(&self, solved: &Solved, time: f64) -> bool {
        let domain = &self.prepared.domain;
        let point = [0.5 * (domain.u[0] + domain.u[1]), 0.5 * (domain.v[0] + domain.v[1]), time];
        solved.solution.surface.evaluate(Derivative::NONE, &[point], &mut [[0.0; 3]]).is_ok()
    }

    fn remember(&self, params: &[f64], solved: &Solved) {
        let mut memory = self.memory.lock().unwrap_or_else(PoisonError::into_inner);
        if memory.len() >= REMEMBERED {
            memory.remove(0);
        }
        memory.push((params.to_vec(), solved.clone()));
    }
}

/// The instants that lie in the time domain of every part.
pub fn common_times<P: Located>(parts: &[P]) -> Option<[f64; 2]> {
    let ranges = parts.iter().map(|part| part.domain().t);
    ranges.reduce(|[a, b], [c, d]| [a.max(c), b.min(d)]).filter(|[start, end]| start <= end)
}

/// The text of `path`, or of standard input for `-`.
pub fn read_source(path: &str, limits: &Limits) -> Result<Source, Failure> {
    let (name, bytes) = read_bytes(path, limits)?;
    let empty = || Source::new(name.clone(), String::from_utf8_lossy(&bytes));
    syntax::decode(&name, &bytes, limits).map_err(|finding| Failure::one(&empty(), finding))
}

fn read_bytes(path: &str, limits: &Limits) -> Result<(String, Vec<u8>), Failure> {
    // One byte more than allowed is enough to see that there is too much.
    let allowed = u64::try_from(limits.source_bytes).unwrap_or(u64::MAX).saturating_add(1);
    let mut bytes = Vec::new();
    if path == "-" {
        let read = std::io::stdin().lock().take(allowed).read_to_end(&mut bytes);
        read.map_err(|error| Failure::Machine(format!("cannot read standard input: {error}")))?;
        return Ok(("standard input".to_owned(), bytes));
    }
    let unreadable = |error: std::io::Error| {
        let message = format!("cannot read `{path}`: {error}");
        match error.kind() {
            ErrorKind::NotFound | ErrorKind::InvalidInput => Failure::Usage(message),
            _ => Failure::Machine(message),
        }
    };
    let file = files::open(Path::new(path)).map_err(unreadable)?;
    file.take(allowed).read_to_end(&mut bytes).map_err(unreadable)?;
    Ok((path.to_owned(), bytes))
}

/// A problem with some values changed, and the number behind every symbol.
fn with_values(
    mut problem: Problem,
    source: &Source,
    changes: &[String],
    limits: &Limits,
) -> Result<(Problem, Bindings), Failure> {
    for change in changes {
        set(&mut problem, change, limits)?;
    }
    let bindings = Bindings::evaluate(&problem).map_err(|finding| overridden(source, changes, finding))?;
    Ok((problem, bindings))
}

fn set(problem: &mut Problem, change: &str, limits: &Limits) -> Result<(), Failure> {
    let Some((name, value)) = change.split_once('=') else {
        return Err(Failure::Usage(format!("`--set {change}`: write NAME=EXPR, for example --set h1=-2")));
    };
    let source = Source::new(format!("--set {name}"), value);
    set_parameter(problem, name.trim(), &source, limits).map_err(|mut findings| {
        for finding in &mut findings {
            finding.span = finding.span.or(Some(Span::new(0, value.len())));
        }
        Failure::Option { source: source.clone(), findings }
    })
}

/// A finding about a parameter's value that came from an option points at the option.
fn overridden(source: &Source, changes: &[String], finding: Diagnostic) -> Failure {
    let named = changes.iter().find(|change| {
        let name = change.split_once('=').map_or("", |(name, _)| name.trim());
        finding.span.is_none() && finding.message.contains(&format!("`{}`", trimline::expr::canonical_name(name)))
    });
    match named.and_then(|change| change.split_once('=')) {
        Some((name, value)) => option_finding(&format!("set {name}"), value, finding),
        None => Failure::one(source, finding),
    }
}

/// What a document consists of.
type Chosen = (Vec<Patch>, Vec<Net>, Vec<PatchCopy>);

/// The patches, nets and copies, or those that are called `name`: the patches of a loop have its name, a dot and a number.
pub fn select(problem: &Problem, name: Option<&str>) -> Result<Chosen, Failure> {
    let Some(name) = name else {
        return Ok((problem.patches.clone(), problem.nets.clone(), problem.copies.clone()));
    };
    let is_meant = |full: &str| full == name || full.split('.').next() == Some(name);
    let patches: Vec<Patch> = problem.patches.iter().filter(|patch| is_meant(&patch.name)).cloned().collect();
    let nets: Vec<Net> = problem.nets.iter().filter(|net| net.name == name).cloned().collect();
    let copies: Vec<PatchCopy> = problem.copies.iter().filter(|copy| is_meant(&copy.name)).cloned().collect();
    if patches.is_empty() && nets.is_empty() && copies.is_empty() {
        let known: Vec<&str> = (0..).map_while(|index| problem.part_name(index)).collect();
        return Err(Failure::Usage(format!("there is no patch `{name}`; patches: {}", known.join(", "))));
    }
    Ok((patches, nets, copies))
}
