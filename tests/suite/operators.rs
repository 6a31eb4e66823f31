//! Operators in brackets against the equation written out, and against derivatives taken one after the other.

use std::collections::BTreeMap;

use proptest::prelude::*;

use trimline::expr::{Derivative, ExprId, Graph, Notation, Variable};
use trimline::limits::Limits;
use trimline::problem::Problem;

use crate::spec::{BOUNDARY, problem, problem_within};

/// The terms of the equation, each with its coefficients as text, and the force.
fn terms(equation: &str) -> Vec<String> {
    let problem = problem_within(&format!("param a = 2\npde {equation}\n"), &Limits::default());
    // Most of these have no boundary to go with them; only the equation matters.
    let problem = match problem {
        Ok(problem) => problem,
        Err(_) => problem_with_boundary(equation),
    };
    let operator = &problem.patches[0].operator;
    let text = |expr| problem.graph.text(expr, Notation::Ascii, 10_000).expect("short");
    let coefficients =
        operator.terms.iter().map(|term| format!("{} {:?}", term.derivative, term.coefficient.map(text)));
    coefficients.chain([format!("{:?}", operator.force.map(text))]).collect()
}

/// As many positions as the order in u asks for.
fn problem_with_boundary(equation: &str) -> Problem {
    let tried = (1..=8).find_map(|count| {
        let at = |index: usize| format!("at u = {}: S = 0\n", index as f64 / 8.0);
        let boundary: String = (0..count).map(at).collect();
        problem_within(&format!("param a = 2\npde {equation}\n{boundary}"), &Limits::default()).ok()
    });
    tried.unwrap_or_else(|| problem(&format!("param a = 2\npde {equation}\n{BOUNDARY}")))
}

#[test]
fn square_of_an_operator_is_the_equation_written_out() {
    let written = terms("d4S/du4 + 2*a^2*d4S/du2dv2 + a^4*d4S/dv4 = 0");
    assert_eq!(terms("(∂²/∂u² + a² ∂²/∂v²)² S = 0"), written);
    assert_eq!(terms("(d2/du2 + a^2*d2/dv2)^2 S = 0"), written);
    assert_eq!(terms("(d2/du2 + a^2 d2/dv2)(d2/du2 + a^2 d2/dv2) S = 0"), written);
    assert_eq!(terms("0 = -(∂²/∂u² + a² ∂²/∂v²)² S"), terms("0 = -d4S/du4 - 2*a^2*d4S/du2dv2 - a^4*d4S/dv4"));
}

#[test]
fn product_of_different_operators_is_the_equation_written_out() {
    let written = terms("d4S/du4 + d4S/du2dv2 - d3S/du2dt - d3S/dv2dt = 0");
    assert_eq!(terms("(∂²/∂u² + ∂²/∂v²)(∂²/∂u² - ∂/∂t) S = 0"), written);
    assert_eq!(terms("(∂²/∂u² - ∂/∂t)*(∂²/∂u² + ∂²/∂v²) S = 0"), written);
}

#[test]
fn constant_in_a_bracket_multiplies_what_follows() {
    assert_eq!(terms("(∂²/∂u² - 3) S = 0"), terms("d2S/du2 - 3 S = 0"));
    assert_eq!(terms("(∂²/∂u² - 3)^2 S = 0"), terms("d4S/du4 - 6 d2S/du2 + 9 S = 0"));
    assert_eq!(terms("(d2/du2 - [1, 2, 3]) S = 0"), terms("d2S/du2 - [1, 2, 3] S = 0"));
    assert_eq!(terms("(d2/du2 - [1, 2, 3])^2 S = 0"), terms("d4S/du4 - [2, 4, 6] d2S/du2 + [1, 4, 9] S = 0"));
}

#[test]
fn operator_stands_in_front_of_terms_and_of_brackets_with_s() {
    assert_eq!(terms("2 a(∂²/∂u² + ∂²/∂v²) S = 0"), terms("2 a d2S/du2 + 2 a d2S/dv2 = 0"));
    assert_eq!(terms("a(∂²/∂u²)^2 S = 0"), terms("a d4S/du4 = 0"));
    assert_eq!(terms("∂²/∂u² ∂²S/∂v² + (∂/∂u)(S) = 0"), terms("d4S/du2dv2 + dS/du = 0"));
    assert_eq!(terms("((∂²/∂u²)/a) S = 0"), terms("(1/a) d2S/du2 = 0"));
    assert_eq!(terms("d2/du2 (S - [u^2, v, 0]) = 0"), terms("d2S/du2 = [2, 0, 0]"));
}

#[test]
fn coefficient_behind_an_operator_is_differentiated() {
    assert_eq!(terms("∂/∂u u ∂S/∂u = 0"), terms("u d2S/du2 + dS/du = 0"));
    assert_eq!(terms("∂/∂u (u ∂S/∂u) = 0"), terms("u d2S/du2 + dS/du = 0"));
    assert_eq!(terms("u ∂/∂u ∂S/∂u = 0"), terms("u d2S/du2 = 0"));
    assert_eq!(terms("(u ∂/∂u)^2 S = 0"), terms("u^2 d2S/du2 + u dS/du = 0"));
    assert_eq!(terms("(∂/∂u + v)(∂/∂u - v) S = 0"), terms("d2S/du2 - v^2 S = 0"));
    assert_eq!(terms("(∂/∂u + u)(∂/∂u - u) S = 0"), terms("d2S/du2 - (1 + u^2) S = 0"));
}

/// An operator with whole numbers in front of derivatives, at most of order 2 in each of two coordinates.
type Polynomial = BTreeMap<(usize, usize), i64>;

fn text(operator: &Polynomial) -> String {
    let term = |((u, v), factor): (&(usize, usize), &i64)| match (u, v) {
        (0, 0) => format!("({factor})"),
        (u, 0) => format!("({factor}) d{u}/du{u}"),
        (0, v) => format!("({factor}) d{v}/dv{v}"),
        (u, v) => format!("({factor}) d{}/du{u}dv{v}", u + v),
    };
    format!("({})", operator.iter().map(term).collect::<Vec<_>>().join(" + "))
}

fn written_out(operator: &Polynomial) -> String {
    let term = |((u, v), factor): (&(usize, usize), &i64)| match (u, v) {
        (0, 0) => format!("({factor}) S"),
        (u, 0) => format!("({factor}) d{u}S/du{u}"),
        (0, v) => format!("({factor}) d{v}S/dv{v}"),
        (u, v) => format!("({factor}) d{}S/du{u}dv{v}", u + v),
    };
    operator.iter().map(term).collect::<Vec<_>>().join(" + ")
}

fn product(left: &Polynomial, right: &Polynomial) -> Polynomial {
    let mut result = Polynomial::new();
    for ((u, v), a) in left {
        for ((p, q), b) in right {
            *result.entry((u + p, v + q)).or_default() += a * b;
        }
    }
    result.retain(|_, factor| *factor != 0);
    result
}

/// With a derivative in u, so that a boundary can go with it.
fn operators() -> impl Strategy<Value = Polynomial> {
    let rest = prop::collection::btree_map((0..=2_usize, 0..=2_usize), -3..=3_i64, 1..4);
    rest.prop_map(|mut terms| {
        terms.insert((2, 0), 1);
        terms.retain(|_, factor| *factor != 0);
        terms
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn product_of_constant_operators_equals_the_polynomial_product(a in operators(), b in operators(), power in 1..=2_u32) {
        let raised = (1..power).fold(b.clone(), |product_so_far, _| product(&product_so_far, &b));
        let equation = format!("{}{}^{power} S = 0", text(&a), text(&b));
        prop_assert_eq!(terms(&equation), terms(&format!("{} = 0", written_out(&product(&a, &raised)))));
    }

    #[test]
    fn product_of_varying_operators_acts_as_they_do_one_after_the_other(
        factors in prop::collection::vec((0..3_usize, 0..4_usize, 0..3_usize), 1..4),
        point in (0.1..0.9_f64, 0.1..3.0_f64, 0.1..0.9_f64),
    ) {
        // Each factor is `coefficient ∂/∂x + other`; the first acts last.
        let coefficients = ["1 + u^2", "sin(v)", "u*v + t", "2"];
        let letters = ["u", "v", "t"];
        let bracket = |(letter, a, b): &(usize, usize, usize)| {
            format!("(({}) d/d{} + {})", coefficients[*a], letters[*letter], coefficients[*b])
        };
        let brackets: String = factors.iter().map(bracket).collect();
        let problem = problem_with_boundary(&format!("d/du {brackets} S + d/du S = 0"));
        let mut graph = problem.graph.clone();
        let [u, v, t] = Variable::ALL.map(|variable| graph.variable(variable));
        // S = exp(u) sin(2 v) (1 + t)^3 + u^4 v^2 t
        let function = sample(&mut graph, [u, v, t]);
        let one = |graph: &mut Graph| graph.integer(1);
        let mut image = function;
        for (letter, a, b) in factors.iter().rev() {
            let orders = Derivative::new(usize::from(*letter == 0), usize::from(*letter == 1), usize::from(*letter == 2));
            let derivative = graph.derivative(image, orders).expect("smooth");
            let [a, b] = [a, b].map(|index| {
                let (one, two) = (one(&mut graph), graph.integer(2));
                match index {
                    0 => { let square = graph.power(u, two); graph.sum([one, square]) }
                    1 => graph.call(trimline::expr::Function::Sin, &[v]),
                    2 => { let product = graph.product([u, v]); graph.sum([product, t]) }
                    _ => two,
                }
            });
            let terms = [graph.product([a, derivative]), graph.product([b, image])];
            image = graph.sum(terms);
        }
        let in_u = Derivative::new(1, 0, 0);
        let expected = [image, function].map(|expr| graph.derivative(expr, in_u).expect("smooth"));
        let at = [point.0, point.1, point.2];
        let value = |graph: &Graph, expr: ExprId| graph.value(expr, &[], at);
        let expected: f64 = expected.into_iter().map(|expr| value(&graph, expr)).sum();
        let (mut found, mut size) = (0.0, 1.0_f64);
        for term in &problem.patches[0].operator.terms {
            let derivative = graph.derivative(function, term.derivative).expect("smooth");
            let part = value(&graph, term.coefficient[0]) * value(&graph, derivative);
            found += part;
            size = size.max(part.abs());
        }
        // A few dozen operations on numbers of that size.
        prop_assert!((found - expected).abs() <= 1e-12 * size, "{brackets}: {found} {expected}");
    }
}

/// A function that no derivative of low order makes zero.
fn sample(graph: &mut Graph, [u, v, t]: [ExprId; 3]) -> ExprId {
    use trimline::expr::Function;
    let [one, two, three] = [1, 2, 3].map(|number| graph.integer(number));
    let growth = graph.call(Function::Exp, &[u]);
    let twice = graph.product([two, v]);
    let wave = graph.call(Function::Sin, &[twice]);
    let later = graph.sum([one, t]);
    let cube = graph.power(later, three);
    let first = graph.product([growth, wave, cube]);
    let squares = [u, v].map(|x| graph.power(x, two));
    let fourth = graph.power(squares[0], two);
    let second = graph.product([fourth, squares[1], t]);
    graph.sum([first, second])
}
