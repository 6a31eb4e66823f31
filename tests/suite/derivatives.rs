//! Symbolic derivatives against Taylor series that were never symbolic.
//!
//! Along `p + s d` the n-th Taylor coefficient of f is `Σ_{i+j+k=n} d_u^i d_v^j d_t^k ∂^{ijk}f / (i! j! k!)`, so one
//! series judges all mixed derivatives of one order at once.

mod jet;

use proptest::prelude::*;
use trimline::expr::{Derivative, ExprId, Function, Graph, NotDifferentiable, Number, Variable};

use jet::jet;

const DIRECTIONS: [[f64; 3]; 4] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.7, -0.4, 0.9]];

fn factorial(n: usize) -> f64 {
    (1..=n).map(|k| k as f64).product()
}

/// The n-th Taylor coefficient along `direction` from symbolic derivatives, and the sum of the sizes of its parts.
fn coefficient(
    graph: &mut Graph,
    expr: ExprId,
    symbols: &[f64],
    point: [f64; 3],
    direction: [f64; 3],
    n: usize,
) -> Result<(f64, f64), NotDifferentiable> {
    let (mut sum, mut size) = (0.0, 0.0);
    for i in 0..=n {
        for j in 0..=n - i {
            let k = n - i - j;
            let factor = direction[0].powi(i as i32) * direction[1].powi(j as i32) * direction[2].powi(k as i32)
                / (factorial(i) * factorial(j) * factorial(k));
            if factor != 0.0 {
                let derivative = graph.derivative(expr, Derivative::new(i, j, k))?;
                let term = factor * graph.value(derivative, symbols, point);
                sum += term;
                size += term.abs();
            }
        }
    }
    Ok((sum, size))
}

/// Compares all derivatives up to `order`; `tolerance` is relative to the largest part of the series.
fn compare(graph: &mut Graph, expr: ExprId, symbols: &[f64], point: [f64; 3], order: usize, tolerance: f64) {
    for direction in DIRECTIONS {
        let expected = jet(graph, expr, symbols, point, direction).expect("only smooth functions");
        for n in 0..=order {
            let (found, size) = coefficient(graph, expr, symbols, point, direction, n).expect("only smooth functions");
            let most = expected[..=n].iter().fold(size, |most, value| most.max(value.abs()));
            let error = (found - expected[n]).abs();
            assert!(error <= tolerance * most, "order {n} along {direction:?}: {found} {} ({error:.1e})", expected[n]);
        }
    }
}

fn is_smooth(function: Function) -> bool {
    use Function::{Abs, Floor, Max, Min, Pow, Sign};
    !matches!(function, Abs | Sign | Floor | Min | Max | Pow)
}

/// `0.4 + 0.1 sin(u + 2 v) + 0.1 t v`: between 0 and 1, inside the domain of every function but acosh.
fn inner(graph: &mut Graph) -> ExprId {
    let [u, v, t] = Variable::ALL.map(|variable| graph.variable(variable));
    let tenth = Number::parse("0.1").expect("a number");
    let twice = graph.scale(Number::integer(2), v);
    let phase = graph.sum([u, twice]);
    let wave = graph.call(Function::Sin, &[phase]);
    let wave = graph.scale(tenth, wave);
    let product = graph.product([t, v]);
    let product = graph.scale(tenth, product);
    let constant = graph.number(Number::parse("0.4").expect("a number"));
    graph.sum([constant, wave, product])
}

fn arguments(graph: &mut Graph, function: Function) -> Vec<ExprId> {
    let first = inner(graph);
    let shifted = {
        let one = graph.integer(1);
        graph.sum([first, one])
    };
    match (function, function.arity()) {
        (Function::Acosh, _) => vec![shifted],
        (_, 1) => vec![first],
        // Behind the axis of the branch cut, where atan is off by a half turn.
        _ => {
            let behind = graph.neg(shifted);
            vec![first, behind]
        }
    }
}

#[test]
fn every_smooth_function_has_the_derivatives_of_its_series_up_to_order_4() {
    for &function in Function::ALL.iter().filter(|function| is_smooth(**function)) {
        let mut graph = Graph::new();
        let arguments = arguments(&mut graph, function);
        let expr = graph.call(function, &arguments);
        for point in [[0.3, 0.5, 0.2], [0.9, 1.4, 0.7], [-0.5, -0.2, 1.3]] {
            // Four orders of quotients near argument 0.4 lose up to four digits of sixteen.
            compare(&mut graph, expr, &[], point, 4, 1e-12);
        }
    }
}

#[test]
fn every_smooth_function_of_one_coordinate_has_its_derivatives_up_to_order_8() {
    for &function in Function::ALL.iter().filter(|function| is_smooth(**function) && function.arity() == 1) {
        let mut graph = Graph::new();
        let v = graph.variable(Variable::V);
        let half = graph.scale(Number::parse("0.5").expect("a number"), v);
        let shift =
            graph.number(Number::parse(if function == Function::Acosh { "1.2" } else { "0.2" }).expect("a number"));
        let argument = graph.sum([half, shift]);
        let expr = graph.call(function, &[argument]);
        let point = [0.0, 0.9, 0.0];
        let expected = jet(&graph, expr, &[], point, [0.0, 1.0, 0.0]).expect("smooth");
        for n in 0..=8 {
            let derivative = graph.derivative(expr, Derivative::new(0, n, 0)).expect("smooth");
            let found = graph.value(derivative, &[], point) / factorial(n);
            let most = expected[..=n].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            // Terms of the eighth derivative of a quotient are some 1e4 times larger than their sum.
            assert!((found - expected[n]).abs() <= 1e-10 * most, "{function:?} order {n}: {found} {}", expected[n]);
        }
    }
}

#[test]
fn functions_with_corners_are_refused_by_name_where_they_depend_on_the_coordinate() {
    for &function in Function::ALL.iter().filter(|function| !is_smooth(**function)) {
        let mut graph = Graph::new();
        let [u, v] = [Variable::U, Variable::V].map(|variable| graph.variable(variable));
        let square = graph.power_integer(v, 2);
        let arguments = if function.arity() == 1 { vec![v] } else { vec![v, square] };
        let call = graph.call(function, &arguments);
        let inside = graph.product([u, call]);
        let expr = graph.call(Function::Sin, &[inside]);
        let found = graph.derivative(expr, Derivative::new(0, 1, 0));
        assert_eq!(found, Err(NotDifferentiable::Function(function)));
        assert!(graph.derivative(expr, Derivative::new(3, 0, 2)).is_ok(), "{function:?} does not depend on u or t");
    }
}

#[test]
fn general_powers_have_the_derivatives_of_their_series() {
    let mut graph = Graph::new();
    let base = inner(&mut graph);
    let [u, v, _] = Variable::ALL.map(|variable| graph.variable(variable));
    let symbol = graph.symbol("a");
    let exponents = [
        graph.integer(-3),
        graph.number(Number::fraction(5, 2).expect("a number")),
        symbol,
        v,
        graph.product([u, symbol]),
    ];
    for exponent in exponents {
        let expr = graph.power(base, exponent);
        compare(&mut graph, expr, &[1.7], [0.3, 0.5, 0.2], 4, 1e-12);
        let expr = graph.power(symbol, exponent);
        compare(&mut graph, expr, &[1.7], [0.3, 0.5, 0.2], 4, 1e-12);
    }
}

#[derive(Debug, Clone)]
enum Tree {
    Variable(usize),
    Parameter,
    Number(i64, i64),
    Sum(Vec<Tree>),
    Product(Vec<Tree>),
    Power(Box<Tree>, i64),
    Call(Function, Box<Tree>),
}

impl Tree {
    /// Recursive: the strategy bounds the depth.
    fn build(&self, graph: &mut Graph) -> ExprId {
        let all = |trees: &[Tree], graph: &mut Graph| trees.iter().map(|tree| tree.build(graph)).collect::<Vec<_>>();
        match self {
            Tree::Variable(index) => graph.variable(Variable::ALL[*index]),
            Tree::Parameter => graph.symbol("a"),
            Tree::Number(above, below) => graph.number(Number::fraction(*above, *below).expect("not over zero")),
            Tree::Sum(terms) => {
                let terms = all(terms, graph);
                graph.sum(terms)
            }
            Tree::Product(factors) => {
                let factors = all(factors, graph);
                graph.product(factors)
            }
            Tree::Power(base, exponent) => {
                let base = base.build(graph);
                graph.power_integer(base, *exponent)
            }
            Tree::Call(function, argument) => {
                let argument = argument.build(graph);
                graph.call(*function, &[argument])
            }
        }
    }
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        3 => (0..3_usize).prop_map(Tree::Variable),
        1 => Just(Tree::Parameter),
        1 => (-5_i64..6, 1_i64..4).prop_map(|(above, below)| Tree::Number(above, below)),
    ];
    // Entire functions, and those whose poles are far: others leave their domain in a random tree.
    let functions = vec![Function::Sin, Function::Cos, Function::Exp, Function::Atan, Function::Tanh, Function::Asinh];
    leaf.prop_recursive(4, 16, 3, move |inner| {
        prop_oneof![
            2 => prop::collection::vec(inner.clone(), 2..4).prop_map(Tree::Sum),
            2 => prop::collection::vec(inner.clone(), 2..4).prop_map(Tree::Product),
            1 => (inner.clone(), -2_i64..4).prop_map(|(base, exponent)| Tree::Power(Box::new(base), exponent)),
            2 => (prop::sample::select(functions.clone()), inner)
                .prop_map(|(function, argument)| Tree::Call(function, Box::new(argument))),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn random_expressions_have_the_derivatives_of_their_series(
        tree in tree(),
        point in prop::array::uniform3(0.2..1.2_f64),
    ) {
        let mut graph = Graph::new();
        graph.symbol("a");
        let expr = tree.build(&mut graph);
        // Near a pole, or where e^e^x overflows, nothing can be compared.
        let series = DIRECTIONS.map(|direction| jet(&graph, expr, &[0.8], point, direction).expect("smooth"));
        prop_assume!(series.iter().flatten().all(|value| value.abs() < 1e6));
        // Fourth derivatives of four nested levels; their parts can be 1e4 times the series compared with.
        compare(&mut graph, expr, &[0.8], point, 4, 1e-8);
    }
}
