//! The scene as JSON: what is wrong, what can be changed, and each patch in the form the page evaluates.
//!
//! A patch that is `S(u, v, t) = Σ_j F_j(v, t) G_j(u)` travels as that: the F_j as a straight-line program with their
//! derivatives in v, the G_j as Chebyshev series. So the page draws it at any resolution and any t without asking again.
//! B-spline nets travel as knots and control points. Any other patch is [`Form::Sampled`]: the page asks for its vertices
//! (see `vertices`). A copy is its original and a placement. Boundary data and placements are programs.

use std::sync::Arc;
use std::time::Instant;

use serde::Serialize;
use serde_json::{Value, json};

use trimline::diagnostic::Diagnostic;
use trimline::eval::Program;
use trimline::export::Format;
use trimline::expr::{ExprId, Graph, Notation, unicode_name};
use trimline::limits::Limits;
use trimline::net::METHOD;
use trimline::problem::{Explanation, ParameterKind, Patch as StatedPatch};
use trimline::surface::KnotVector;
use trimline::verify::verify_joins;

use super::form::{Form, program};
use super::live::{Answerable, Live};
use super::pieces::{Of, Piece};
use super::server::Question;
use crate::failure::Failure;
use crate::finding::Finding;
use crate::joins::{self, JoinReport};
use crate::parts::Located;
use crate::seams::{self, SeamReport};
use crate::workflow::{Patched, Solved, Spec};

/// Everything the page shows.
#[derive(Serialize)]
pub struct Scene {
    /// How often the spec was read.
    revision: u64,
    /// The spec's path.
    name: String,
    /// Whether the surface belongs to the newest text; otherwise `findings` says what is wrong with that.
    is_current: bool,
    findings: Vec<Finding>,
    /// The surface; `None` while there is none.
    solved: Option<SolvedScene>,
    formats: Vec<&'static str>,
    /// From the question to the answer.
    milliseconds: f64,
    /// From the first sign of the last save until its text was read and compiled.
    reading_milliseconds: f64,
}

#[derive(Serialize)]
struct SolvedScene {
    parameters: Vec<Parameter>,
    /// The instants that all patches have.
    times: [f64; 2],
    /// The instant at which everything was solved and measured.
    time: f64,
    patches: Vec<Patch>,
    surfaces: Vec<Primary>,
    seams: Vec<SeamReport>,
}

/// A primary surface; the page evaluates it at any t.
#[derive(Serialize)]
struct Primary {
    name: String,
    /// Of its two parameters.
    ranges: [[f64; 2]; 2],
    symbols: Vec<f64>,
    /// x, y and z in u, v and t.
    position: Value,
}

/// Something with a slider.
#[derive(Serialize)]
struct Parameter {
    name: String,
    label: String,
    value: f64,
    range: Option<[f64; 2]>,
    is_coefficient: bool,
}

#[derive(Serialize)]
struct Patch {
    name: String,
    domain: [[f64; 2]; 3],
    /// The instant it was solved at.
    time: f64,
    /// The value of every symbol of the programs.
    symbols: Vec<f64>,
    form: Form,
    /// Of a copy: the rows of the matrix that turns what `form` gives, then the vector that moves it, in t.
    placement: Option<Value>,
    /// Constraints at fixed u, then those at fixed v; of a copy, those of its original, which `placement` moves as well.
    boundary: Vec<Boundary>,
    /// Ranges of u and v of its deformations.
    regions: Vec<[[f64; 2]; 2]>,
    /// The problem as understood, in LaTeX; of a copy only if its original is not shown.
    mathematics: Vec<String>,
    functions: Vec<String>,
    report: Value,
    joins: Vec<JoinReport>,
}

/// The constraints at fixed values of one parameter.
#[derive(Serialize)]
struct Boundary {
    /// `u` or `v`.
    across: &'static str,
    conditions: Vec<Condition>,
    /// x, y and z of each condition.
    program: Value,
}

#[derive(Serialize)]
struct Condition {
    at: f64,
    order: usize,
}

impl Scene {
    /// The scene at the page's instant and values.
    pub fn of(live: &Live, question: &Question) -> Scene {
        let start = Instant::now();
        let reading_milliseconds = 1e3 * live.reading().as_secs_f64();
        live.answer(&question.changes, question.time, |answerable, failure| {
            let mut findings = failure.map(Finding::of_failure).unwrap_or_default();
            let solved = match answerable.map(|answerable| answerable.and_then(|it| SolvedScene::of(&it))) {
                Some(Ok((solved, warnings))) => {
                    findings.extend(warnings);
                    Some(solved)
                }
                Some(Err(fault)) => {
                    findings.extend(Finding::of_failure(&fault));
                    None
                }
                None => None,
            };
            Scene {
                revision: *live.revision.borrow(),
                name: live.path.clone(),
                is_current: failure.is_none(),
                findings,
                solved,
                formats: Format::ALL.iter().map(|format| format.extension()).collect(),
                milliseconds: 1e3 * start.elapsed().as_secs_f64(),
                reading_milliseconds,
            }
        })
    }
}

impl SolvedScene {
    fn of(answerable: &Answerable<'_>) -> Result<(SolvedScene, Vec<Finding>), Failure> {
        let spec = answerable.spec;
        let mut warnings = Vec::new();
        let mut patches = Vec::new();
        let mut last = None;
        for piece in &answerable.pieces {
            // What is to be said of a copy is said of its original, which stands before it if it is shown.
            let is_first = last.is_none_or(|last| last < piece.original);
            if is_first {
                last = Some(piece.original);
                let found = match piece.of {
                    Of::Patch(_, solved) => &solved.solution.report.warnings,
                    Of::Net(_, solved) => &solved.filled.warnings,
                };
                warnings.extend(found.iter().map(|warning| Finding::new(warning, Some(&spec.source))));
            }
            patches.push(patch(answerable, piece, is_first)?);
        }
        let parameters = parameters(spec).map_err(|finding| spec.fault(finding))?;
        let (surfaces, seams) = (primaries(answerable)?, seams(answerable)?);
        let Answerable { times, time, .. } = *answerable;
        Ok((SolvedScene { parameters, times, time, patches, surfaces, seams }, warnings))
    }
}

/// The primary surfaces over their stated ranges; over those of the first patch where none is stated.
fn primaries(answerable: &Answerable<'_>) -> Result<Vec<Primary>, Failure> {
    let (spec, Some(first)) = (answerable.spec, answerable.pieces.first()) else { return Ok(Vec::new()) };
    let mut all = Vec::with_capacity(spec.problem.surfaces.len());
    for primary in &spec.problem.surfaces {
        all.push(Primary {
            name: primary.name.clone(),
            ranges: spec.ranges_of(primary, [first.domain().u, first.domain().v])?,
            symbols: spec.bindings.as_slice().to_vec(),
            position: program(&Program::compile(&spec.problem.graph, &primary.position)),
        });
    }
    Ok(all)
}

/// Where patches meet at the page's instant; none are looked for between the ends of a single patch.
pub fn seams(answerable: &Answerable<'_>) -> Result<Vec<SeamReport>, Failure> {
    let (spec, pieces) = (answerable.spec, &answerable.pieces);
    if pieces.len() < 2 && spec.problem.seams.is_empty() {
        return Ok(Vec::new());
    }
    let located: Vec<&Piece<'_>> = pieces.iter().collect();
    let surfaces = |_| Ok(pieces.iter().map(|piece| Some(Arc::clone(&piece.surface))).collect());
    seams::measure(spec, &located, &[answerable.time], surfaces).map(|(seams, _)| seams)
}

fn joins(spec: &Spec, patched: &Patched, solved: &Solved) -> Result<Vec<JoinReport>, Failure> {
    let at = (&spec.bindings, &patched.prepared.domain, solved.time);
    let met = verify_joins(&spec.problem, patched.prepared.patch(), &*solved.solution.surface, at, &spec.limits);
    joins::reports(spec, patched, met.map_err(|finding| spec.fault(finding))?)
}

fn parameters(spec: &Spec) -> Result<Vec<Parameter>, Diagnostic> {
    let (problem, bindings) = (&spec.problem, &spec.bindings);
    let mut all = Vec::with_capacity(problem.parameters.len());
    for parameter in &problem.parameters {
        let constant = |expr| bindings.constant(problem, expr, parameter.origin, "the end of a range");
        let range = match parameter.interval {
            Some([low, high]) => Some([constant(low)?, constant(high)?]),
            None => None,
        };
        all.push(Parameter {
            name: parameter.name.clone(),
            label: unicode_name(&parameter.name),
            value: bindings.as_slice().get(parameter.symbol.index()).copied().unwrap_or(f64::NAN),
            range,
            is_coefficient: parameter.kind == ParameterKind::Coefficient,
        });
    }
    Ok(all)
}

/// A part; `is_first` says that its original was not described before.
fn patch(answerable: &Answerable<'_>, piece: &Piece<'_>, is_first: bool) -> Result<Patch, Failure> {
    let (spec, domain) = (answerable.spec, piece.domain());
    let placement = piece.copy.map(|copy| program(&Program::compile(&spec.problem.graph, &copy.placement.entries())));
    let mut patch = Patch {
        name: piece.name().to_owned(),
        domain: [domain.u, domain.v, domain.t],
        time: answerable.time,
        symbols: spec.bindings.as_slice().to_vec(),
        form: Form::of(piece),
        placement,
        boundary: Vec::new(),
        regions: Vec::new(),
        mathematics: Vec::new(),
        functions: Vec::new(),
        report: report(piece),
        joins: Vec::new(),
    };
    let (patched, solved) = match piece.of {
        Of::Patch(patched, solved) => (patched, solved),
        Of::Net(..) => {
            patch.mathematics.extend(is_first.then(|| NET.to_owned()));
            return Ok(patch);
        }
    };
    let stated = patched.prepared.patch();
    let at_u = stated.conditions.iter().map(|condition| (condition.u, condition.order, condition.value));
    let at_v = stated.side_conditions.iter().map(|condition| (condition.v, condition.order, condition.value));
    for (across, conditions) in [("u", at_u.collect()), ("v", at_v.collect())] {
        patch.boundary.push(boundary(spec, across, conditions).map_err(|finding| spec.fault(finding))?);
    }
    patch.regions = solved.solution.surface.regions();
    if is_first {
        let decomposition = &patched.prepared.decomposition;
        let functions = decomposition.basis.iter();
        patch.mathematics = mathematics(spec, stated);
        patch.functions = functions.map(|function| latex(&decomposition.graph, function.expr)).collect();
    }
    if piece.copy.is_none() {
        patch.joins = joins(spec, patched, solved)?;
    }
    Ok(patch)
}

/// What a net is filled by.
const NET: &str =
    r"\frac{\partial^6 S}{\partial u^3\,\partial v^3} = 0,\quad S(u, v) = \sum_{i,j} N_i(u)\,M_j(v)\,P_{ij}";

fn boundary(
    spec: &Spec,
    across: &'static str,
    stated: Vec<(ExprId, usize, [ExprId; 3])>,
) -> Result<Boundary, Diagnostic> {
    let mut conditions = Vec::with_capacity(stated.len());
    for &(at, order, _) in &stated {
        let at = spec.bindings.constant(&spec.problem, at, None, "the position of a boundary")?;
        conditions.push(Condition { at, order });
    }
    let data: Vec<ExprId> = stated.into_iter().flat_map(|(_, _, value)| value).collect();
    Ok(Boundary { across, conditions, program: program(&Program::compile(&spec.problem.graph, &data)) })
}

/// Longer expressions are not readable, whatever their notation.
const LONGEST: usize = 2000;

fn mathematics(spec: &Spec, patch: &StatedPatch) -> Vec<String> {
    let limits = Limits { text_bytes: LONGEST, ..spec.limits.clone() };
    match spec.problem.explain(patch, Notation::Latex, &limits) {
        Ok(Explanation { equation, domain, constraints, deformations, .. }) => {
            [equation, domain, constraints, deformations].into_iter().filter(|part| !part.is_empty()).collect()
        }
        Err(_) => vec![r"\text{(the problem is too long to be shown)}".to_owned()],
    }
}

fn latex(graph: &Graph, expr: ExprId) -> String {
    graph.text(expr, Notation::Latex, LONGEST).unwrap_or_else(|_| r"\text{(a long expression)}".to_owned())
}

fn report(piece: &Piece<'_>) -> Value {
    if piece.copy.is_some() {
        return json!({ "kind": "copy", "original": piece.of.name() });
    }
    match piece.of {
        Of::Net(_, solved) => json!({
            "kind": "net",
            "method": METHOD,
            "control_points": solved.filled.surface.knots().map(KnotVector::points),
            "amplification": solved.filled.amplification,
        }),
        Of::Patch(_, solved) => {
            let (report, measured) = (&solved.solution.report, &solved.measured);
            json!({
                "kind": "patch",
                "method": report.method,
                "exact": report.is_exact,
                "basis_size": report.basis_size,
                "closure_size": report.closure_size,
                "modes": report.modes,
                "boundary_error": measured.boundary_error(),
                "pde_residual": measured.relative_residual(),
                "amplification": report.amplification,
                "condition": report.condition,
                "rank": report.rank,
                "unknowns": report.unknowns,
                "milliseconds": 1e3 * solved.solve_seconds,
            })
        }
    }
}
