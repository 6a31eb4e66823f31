//! A hole with five curved edges, filled in Rust: five four-sided patches that meet smoothly, written as one OBJ file.
//!
//! `cargo run --example fill_a_hole --no-default-features > hole.obj`

use std::error::Error;
use std::f64::consts::TAU;

use trimline::blend::Blend;
use trimline::export::{self, Format};
use trimline::expr::{ExprId, Graph, Number, Variable};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::multisided::{Edge, EdgeLoop};
use trimline::problem::{Parameter, ParameterKind, PdeOperator, Problem, STANDARD_COEFFICIENTS, SolveRequest};
use trimline::tessellate::{Grid, Scene, tessellate};

const EDGES: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    let limits = Limits::default();
    let mut graph = Graph::new();
    let mut parameters: Vec<Parameter> = Vec::new();
    for (name, _, value) in STANDARD_COEFFICIENTS {
        parameters.push(coefficient(&mut graph, name, value));
    }

    // Edges from corner to corner, sagging by turns up and down. Tangents across them are left to the program.
    let corner = |index: usize| {
        let angle = TAU * index as f64 / EDGES as f64;
        [angle.cos(), angle.sin(), 0.0]
    };
    let mut edges = Vec::new();
    for index in 0..EDGES {
        let sag = if index % 2 == 0 { 0.5 } else { -0.5 };
        let curve = arc(&mut graph, corner(index), corner((index + 1) % EDGES), sag);
        edges.push(Edge { curve, across: None, origin: None });
    }
    let hole = EdgeLoop {
        name: "hole".to_owned(),
        edges,
        centre: None,
        operator: PdeOperator::standard(&mut graph),
        time: [graph.integer(0), graph.integer(1)],
        solve: SolveRequest::default(),
    };
    let patches = hole.split(&mut graph, &limits)?;
    let problem = Problem { graph, parameters, patches, ..Problem::default() };

    let blend = Blend::new(problem, &Options::default())?;
    hole.check(&blend.problem, &blend.bindings, 0.0, &limits)?;
    let mut scene = Scene::default();
    for (index, prepared) in blend.patches.iter().enumerate() {
        let solution = blend.solve(index, 0.0)?;
        let measured = blend.verify(index, &solution, 0.0)?;
        let name = &prepared.patch().name;
        eprintln!(
            "{name}: boundary met to {:.0e}, equation to {:.0e}",
            measured.boundary_error(),
            measured.relative_residual()
        );
        let ranges = (prepared.domain.u, prepared.domain.v);
        let (mesh, _) = tessellate(name, &*solution.surface, ranges, 0.0, Grid::new(24, 24, &limits)?)?;
        scene.meshes.push(mesh);
    }
    export::write(&scene, Format::Obj, &mut std::io::stdout().lock())?;
    Ok(())
}

/// A parabola over the line between two points, `sag` above it in its middle.
fn arc(graph: &mut Graph, from: [f64; 3], to: [f64; 3], sag: f64) -> [ExprId; 3] {
    let (u, one) = (graph.variable(Variable::U), graph.integer(1));
    let rest = graph.difference(one, u);
    let mut component = |start: f64, end: f64, bow: f64| {
        let number = |value: f64| Number::from_f64(value).unwrap_or(Number::integer(0));
        let middle = graph.product([u, rest]);
        let terms =
            [(start, rest), (end, u), (4.0 * bow, middle)].map(|(factor, shape)| graph.scale(number(factor), shape));
        graph.sum(terms)
    };
    let ([x0, y0, z0], [x1, y1, z1]) = (from, to);
    [component(x0, x1, 0.0), component(y0, y1, 0.0), component(z0, z1, sag)]
}

fn coefficient(graph: &mut Graph, name: &str, value: i64) -> Parameter {
    Parameter {
        symbol: graph.symbol_id(name),
        name: name.to_owned(),
        value: graph.integer(value),
        interval: None,
        kind: ParameterKind::Coefficient,
        origin: None,
        is_overridden: false,
    }
}
