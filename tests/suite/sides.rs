//! Patches with data on four sides, made by restricting a surface that is known everywhere.

use rustc_hash::FxHashMap;
use trimline::blend::Blend;
use trimline::diagnostic::Diagnostic;
use trimline::expr::{Derivative, ExprId, Graph, Variable};
use trimline::method::{Options, Settings, Solution};
use trimline::problem::{BoundaryCondition, PdeOperator, Problem, SideCondition};
use trimline::surface::Surface;

use crate::spec::problem;

/// A vector of expressions in u, v, t and params.
pub type Vector = [ExprId; 3];

/// `expression` as a document reads it in a force, with the rest of the document: params, domain and equation.
///
/// `equation` is a left side; the problem has it without force, and no conditions that count.
pub fn with_vector(before: &str, equation: &str, expression: &str) -> (Problem, Vector) {
    let boundary = "at u = a0: S = 0, dS/du = 0\nat u = a1: S = 0, dS/du = 0\n";
    let (low, high) = if before.contains("u in [-1, 2]") { ("-1", "2") } else { ("0", "1") };
    let boundary = boundary.replace("a0", low).replace("a1", high);
    let mut problem = problem(&format!("{before}\npde {equation} = {expression}\n{boundary}"));
    let zero = problem.graph.integer(0);
    let patch = problem.patches.first_mut().expect("a patch");
    let vector = std::mem::replace(&mut patch.operator.force, [zero; 3]);
    (problem, vector)
}

pub fn substituted(graph: &mut Graph, vector: Vector, replacements: &[(Variable, ExprId)]) -> Vector {
    let replacements: FxHashMap<ExprId, ExprId> =
        replacements.iter().map(|(variable, value)| (graph.variable(*variable), *value)).collect();
    vector.map(|expr| graph.substitute(expr, &replacements))
}

pub fn differentiated(graph: &mut Graph, vector: Vector, orders: Derivative) -> Vector {
    vector.map(|expr| graph.derivative(expr, orders).expect("smooth"))
}

/// The left side of the equation applied to `surface`.
pub fn applied(graph: &mut Graph, operator: &PdeOperator, surface: Vector) -> Vector {
    let mut sums: [Vec<ExprId>; 3] = Default::default();
    for term in &operator.terms {
        let values = differentiated(graph, surface, term.derivative);
        for ((sum, coefficient), value) in sums.iter_mut().zip(term.coefficient).zip(values) {
            sum.push(graph.product([coefficient, value]));
        }
    }
    sums.map(|terms| graph.sum(terms))
}

/// States position and tangent of `surface` on all four sides of the first patch.
pub fn restrict(problem: &mut Problem, surface: Vector) {
    let [range_u, range_v, _] = problem.patches.first().expect("a patch").domain.ends;
    let graph = &mut problem.graph;
    let mut conditions = Vec::new();
    let mut side_conditions = Vec::new();
    for end in 0..2 {
        for order in 0..2 {
            let tangent = differentiated(graph, surface, Derivative::new(order, 0, 0));
            let value = substituted(graph, tangent, &[(Variable::U, range_u[end])]);
            conditions.push(BoundaryCondition { u: range_u[end], order, value, origins: [None; 3] });
            let tangent = differentiated(graph, surface, Derivative::new(0, order, 0));
            let value = substituted(graph, tangent, &[(Variable::V, range_v[end])]);
            side_conditions.push(SideCondition { v: range_v[end], order, value, origins: [None; 3] });
        }
    }
    let patch = problem.patches.first_mut().expect("a patch");
    (patch.conditions, patch.side_conditions) = (conditions, side_conditions);
}

/// A surface that solves `equation` with the force that makes it do so, and the problem of its four sides.
pub fn manufactured(before: &str, equation: &str, surface: &str) -> (Problem, Vector) {
    let (mut problem, surface) = with_vector(before, equation, surface);
    restrict(&mut problem, surface);
    let operator = problem.patches[0].operator.clone();
    problem.patches[0].operator.force = applied(&mut problem.graph, &operator, surface);
    (problem, surface)
}

pub fn terms(count: &str) -> Options {
    let mut settings = Settings::default();
    settings.set("terms", count, None).expect("a known setting");
    Options { settings, ..Options::default() }
}

pub fn solve(problem: &Problem, options: &Options, t: f64) -> Result<(Blend, Solution), Diagnostic> {
    let blend = Blend::new(problem.clone(), options)?;
    let solution = blend.solve(0, t)?;
    Ok((blend, solution))
}

/// The largest component of the difference between a derivative of `found` and that of `expected`, inside and on the sides.
pub fn distance(blend: &Blend, found: &dyn Surface, expected: Vector, derivative: Derivative, t: f64) -> f64 {
    let domain = blend.patches[0].domain;
    let mut graph = blend.problem.graph.clone();
    let expected = differentiated(&mut graph, expected, derivative);
    let mut worst = 0.0_f64;
    for i in 0..=9 {
        for j in 0..=7 {
            let u = domain.u[0] + (domain.u[1] - domain.u[0]) * f64::from(i) / 9.0;
            let v = domain.v[0] + (domain.v[1] - domain.v[0]) * f64::from(j) / 7.0;
            let mut value = [[0.0; 3]];
            found.evaluate(derivative, &[[u, v, t]], &mut value).expect("a point of the domain");
            for (value, expected) in value[0].iter().zip(expected) {
                let expected = graph.value(expected, blend.bindings.as_slice(), [u, v, t]);
                worst = worst.max((value - expected).abs());
                assert!(value.is_finite() && expected.is_finite());
            }
        }
    }
    worst
}

/// A surface given by expressions, evaluated in the plainest way.
pub struct ClosedForm {
    pub graph: Graph,
    pub vector: Vector,
    pub params: Vec<f64>,
}

impl Surface for ClosedForm {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let mut graph = self.graph.clone();
        let vector = differentiated(&mut graph, self.vector, derivative);
        for (point, value) in points.iter().zip(values) {
            *value = vector.map(|expr| graph.value(expr, &self.params, *point));
        }
        Ok(())
    }
}
