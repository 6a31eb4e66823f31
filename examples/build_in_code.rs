//! A problem built in Rust, without any text: a tube between two circles, with the standard equation.
//!
//! `cargo run --example build_in_code --no-default-features`

use trimline::blend::Blend;
use trimline::diagnostic::Diagnostic;
use trimline::expr::{Derivative, Function, Graph, Number, Variable};
use trimline::method::Options;
use trimline::problem::{
    BoundaryCondition, Domain, Parameter, ParameterKind, Patch, PdeOperator, Problem, STANDARD_COEFFICIENTS,
    SolveRequest,
};

fn main() -> Result<(), Diagnostic> {
    let mut graph = Graph::new();
    let operator = PdeOperator::standard(&mut graph);
    let domain = Domain::standard(&mut graph);

    let mut parameters: Vec<Parameter> = Vec::new();
    for (name, _, value) in STANDARD_COEFFICIENTS {
        parameters.push(parameter(&mut graph, name, Number::integer(value), ParameterKind::Coefficient));
    }
    parameters.push(parameter(&mut graph, "r", Number::integer(2), ParameterKind::Parameter));

    // Position and tangent at u = 0 and u = 1.
    let (zero, one, minus_one) = (graph.integer(0), graph.integer(1), graph.integer(-1));
    let v = graph.variable(Variable::V);
    let (cos, sin) = (graph.call(Function::Cos, &[v]), graph.call(Function::Sin, &[v]));
    let r = graph.symbol("r");
    let wide = [graph.product([r, cos]), graph.product([r, sin])];
    let condition = |u, order, value| BoundaryCondition { u, order, value, origins: [None; 3] };
    let conditions = vec![
        condition(zero, 0, [cos, sin, one]),
        condition(zero, 1, [zero, zero, minus_one]),
        condition(one, 0, [wide[0], wide[1], zero]),
        condition(one, 1, [cos, sin, zero]),
    ];

    let patch = Patch {
        name: "tube".to_owned(),
        domain,
        operator,
        conditions,
        joins: Vec::new(),
        side_conditions: Vec::new(),
        is_of_loop: false,
        deformations: Vec::new(),
        solve: SolveRequest::default(),
    };
    let problem = Problem { graph, parameters, patches: vec![patch], ..Problem::default() };
    let blend = Blend::new(problem, &Options::default())?;
    let solution = blend.solve(0, 0.0)?;
    let mut point = [[0.0; 3]];
    solution.surface.evaluate(Derivative::NONE, &[[0.5, 0.0, 0.0]], &mut point)?;
    let measured = blend.verify(0, &solution, 0.0)?;
    println!("S(1/2, 0) = {:?} by method {}", point[0], solution.report.method);
    println!("boundary met to {:.0e}, equation to {:.0e}", measured.boundary_error(), measured.relative_residual());
    Ok(())
}

fn parameter(graph: &mut Graph, name: &str, value: Number, kind: ParameterKind) -> Parameter {
    Parameter {
        symbol: graph.symbol_id(name),
        name: name.to_owned(),
        value: graph.number(value),
        interval: None,
        kind,
        origin: None,
        is_overridden: false,
    }
}
