//! The scene as JSON: what is wrong, what can be changed, and each patch in the form the page evaluates.
//!
//! A patch that is `S(u, v, t) = Σ_j F_j(v, t) G_j(u)` travels as that: the F_j as a straight-line program with their
//! derivatives in v, the G_j as Chebyshev series. So the page draws it at any resolution and any t without asking again.
//! Any other patch is [`Form::Sampled`]: the page asks for its vertices (see `vertices`). Boundary data are programs.

use std::sync::Arc;
use std::time::Instant;

use serde::Serialize;
use serde_json::{Value, json};

use trimline::diagnostic::Diagnostic;
use trimline::emit::amplitude_series;
use trimline::eval::{Op, OpId, Program};
use trimline::export::Format;
use trimline::expr::{Derivative, ExprId, Graph, Notation, SplineCall, unicode_name};
use trimline::limits::Limits;
use trimline::method::Solution;
use trimline::numeric::ChebyshevSeries;
use trimline::problem::{DomainValues, Explanation, ParameterKind, Patch as StatedPatch};
use trimline::verify::verify_joins;

use super::finding::Finding;
use super::live::{Answerable, Live};
use super::server::Question;
use crate::failure::Failure;
use crate::joins::{self, JoinReport};
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
    /// Constraints at fixed u, then those at fixed v.
    boundary: [Boundary; 2],
    /// Ranges of u and v of its deformations.
    regions: Vec<[[f64; 2]; 2]>,
    /// The problem as understood, in LaTeX.
    mathematics: Vec<String>,
    functions: Vec<String>,
    report: Value,
    joins: Vec<JoinReport>,
}

/// How the page comes to a patch's vertices.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Form {
    /// It evaluates a sum of products.
    Separable {
        /// Whether that holds at the patch's instant only.
        is_instant: bool,
        /// F_1 …, then their first derivatives in v, then the second where they exist.
        basis: Value,
        count: usize,
        amplitudes: Series,
    },
    /// It asks for them.
    Sampled,
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

/// A Chebyshev series: a row for each degree.
#[derive(Serialize)]
struct Series {
    range: [f64; 2],
    coefficients: Vec<Vec<f64>>,
}

impl Scene {
    /// The scene at the page's instant and values.
    pub fn of(live: &Live, question: &Question) -> Scene {
        let start = Instant::now();
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
            }
        })
    }
}

impl SolvedScene {
    fn of(answerable: &Answerable<'_>) -> Result<(SolvedScene, Vec<Finding>), Failure> {
        let spec = answerable.spec;
        let mut warnings = Vec::new();
        let mut patches = Vec::new();
        for (patched, solved) in &answerable.patches {
            let found = &solved.solution.report.warnings;
            warnings.extend(found.iter().map(|warning| Finding::new(warning, Some(&spec.source))));
            let joins = joins(spec, patched, solved)?;
            patches.push(patch(spec, patched, solved, joins).map_err(|finding| spec.fault(finding))?);
        }
        let parameters = parameters(spec).map_err(|finding| spec.fault(finding))?;
        let (surfaces, seams) = (primaries(answerable)?, seams(answerable)?);
        let Answerable { times, time, .. } = *answerable;
        Ok((SolvedScene { parameters, times, time, patches, surfaces, seams }, warnings))
    }
}

/// The primary surfaces over their stated ranges; over those of the first patch where none is stated.
fn primaries(answerable: &Answerable<'_>) -> Result<Vec<Primary>, Failure> {
    let (spec, Some((first, _))) = (answerable.spec, answerable.patches.first()) else { return Ok(Vec::new()) };
    let mut all = Vec::with_capacity(spec.problem.surfaces.len());
    for primary in &spec.problem.surfaces {
        all.push(Primary {
            name: primary.name.clone(),
            ranges: spec.ranges_of(primary, [first.prepared.domain.u, first.prepared.domain.v])?,
            symbols: spec.bindings.as_slice().to_vec(),
            position: program(&Program::compile(&spec.problem.graph, &primary.position)),
        });
    }
    Ok(all)
}

/// Where patches meet at the page's instant; none are looked for between the ends of a single patch.
pub fn seams(answerable: &Answerable<'_>) -> Result<Vec<SeamReport>, Failure> {
    let (spec, patches) = (answerable.spec, &answerable.patches);
    if patches.len() < 2 && spec.problem.seams.is_empty() {
        return Ok(Vec::new());
    }
    let patched: Vec<&Patched> = patches.iter().map(|(patched, _)| *patched).collect();
    let surfaces = |_| Ok(patches.iter().map(|(_, solved)| Arc::clone(&solved.solution.surface)).collect());
    seams::measure(spec, &patched, &[answerable.time], surfaces).map(|(seams, _)| seams)
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

fn patch(spec: &Spec, patched: &Patched, solved: &Solved, joins: Vec<JoinReport>) -> Result<Patch, Diagnostic> {
    let prepared = &patched.prepared;
    let (stated, domain) = (prepared.patch(), prepared.domain);
    let decomposition = &prepared.decomposition;
    let functions = decomposition.basis.iter();
    let at_u = stated.conditions.iter().map(|condition| (condition.u, condition.order, condition.value));
    let at_v = stated.side_conditions.iter().map(|condition| (condition.v, condition.order, condition.value));
    Ok(Patch {
        name: stated.name.clone(),
        domain: [domain.u, domain.v, domain.t],
        time: solved.time,
        symbols: spec.bindings.as_slice().to_vec(),
        form: form(solved, domain),
        boundary: [boundary(spec, "u", at_u.collect())?, boundary(spec, "v", at_v.collect())?],
        regions: solved.solution.surface.regions(),
        mathematics: mathematics(spec, stated),
        functions: functions.map(|function| latex(&decomposition.graph, function.expr)).collect(),
        report: report(&solved.solution, solved),
        joins,
    })
}

/// A sum of products, if the surface is one that the page can evaluate as well as the library.
fn form(solved: &Solved, domain: DomainValues) -> Form {
    // Without functions there is nothing to add up: the surface is zero.
    let separable = solved.solution.surface.as_separable().filter(|surface| !surface.basis.is_empty());
    let Some(surface) = separable else { return Form::Sampled };
    let slopes = [Derivative::NONE, Derivative::new(0, 1, 0), Derivative::new(0, 2, 0)];
    // A basis with a kink has no second derivative, so no curvature; without the first there is no normal either.
    let basis = surface.basis.program(&slopes).or_else(|_| surface.basis.program(&slopes[..2]));
    let (Ok(basis), Ok(amplitudes)) = (basis, amplitude_series(surface, domain)) else { return Form::Sampled };
    Form::Separable {
        is_instant: surface.instant.is_some(),
        basis: program(&basis),
        count: surface.basis.len(),
        amplitudes: series(amplitudes),
    }
}

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

fn report(solution: &Solution, solved: &Solved) -> Value {
    let (report, measured) = (&solution.report, &solved.measured);
    json!({
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

fn series(series: ChebyshevSeries) -> Series {
    Series { range: series.range, coefficients: series.coefficients }
}

/// `{"ops": [["const", 0.8], ["v"], ["sin", 1], ["mul", 0, 2]], "outputs": [3]}`: operands are positions in the
/// list. `["spline", a, b, i]` is spline i at one or two of them, `b` being null for one.
fn program(program: &Program) -> Value {
    let op = |op: &Op| match op.map(OpId::index) {
        Op::Constant(value) => json!(["const", value]),
        Op::Parameter(index) => json!(["symbol", index]),
        Op::Variable(variable) => json!([variable.name()]),
        Op::Neg(a) => json!(["neg", a]),
        Op::Add(a, b) => json!(["add", a, b]),
        Op::Sub(a, b) => json!(["sub", a, b]),
        Op::Mul(a, b) => json!(["mul", a, b]),
        Op::Div(a, b) => json!(["div", a, b]),
        Op::Sqrt(a) => json!(["sqrt", a]),
        Op::Call1(function, a) => json!([function.row().name, a]),
        Op::Call2(function, a, b) => json!([function.row().name, a, b]),
        Op::Spline1(index, a) => json!(["spline", a, null, index]),
        Op::Spline2(index, a, b) => json!(["spline", a, b, index]),
    };
    let outputs = program.output_ops().iter().map(|id| id.index());
    json!({
        "ops": program.ops().iter().map(op).collect::<Vec<_>>(),
        "outputs": outputs.collect::<Vec<_>>(),
        "splines": program.splines().iter().map(spline).collect::<Vec<_>>(),
    })
}

/// The data of a spline and the orders of its derivative.
fn spline(call: &SplineCall) -> Value {
    let axis = |index: usize| {
        json!({
            "degree": call.spline.degree(index),
            "breaks": call.spline.breaks(index),
            "periodic": call.spline.is_periodic(index),
        })
    };
    json!({ "orders": call.orders, "axes": [axis(0), axis(1)], "coefficients": call.spline.coefficients() })
}
