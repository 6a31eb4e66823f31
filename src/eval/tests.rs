//! Lowering, and the contract of evaluators that does not depend on which one it is.

use super::*;
use crate::expr::{ExprId, Function, Graph, Number, Variable};

fn program(build: impl FnOnce(&mut Graph) -> Vec<ExprId>) -> Program {
    let mut graph = Graph::new();
    let outputs = build(&mut graph);
    Program::compile(&graph, &outputs)
}

fn text(build: impl FnOnce(&mut Graph) -> ExprId) -> String {
    program(|g| vec![build(g)]).to_string()
}

fn u(graph: &mut Graph) -> ExprId {
    graph.variable(Variable::U)
}

#[test]
fn ops_of_parameters_alone_are_uniform() {
    let text = text(|g| {
        let (a, b, u) = (g.symbol("a"), g.symbol("b"), u(g));
        let ab = g.sum([a, b]);
        let sine = g.call(Function::Sin, &[ab]);
        g.product([sine, u])
    });
    assert_eq!(
        text,
        "uniform:\n  r0 = parameter 0\n  r1 = parameter 1\n  r2 = r0 + r1\n  r3 = sin(r2)\n\
         varying:\n  r4 = u\n  r5 = r4 * r3\noutputs: r5\n"
    );
}

#[test]
fn terms_with_a_minus_are_subtracted() {
    let text = text(|g| {
        let (u, v) = (u(g), g.variable(Variable::V));
        let term = g.scale(Number::integer(-3), v);
        g.sum([u, term])
    });
    assert_eq!(
        text,
        "uniform:\n  r0 = 3.0\nvarying:\n  r1 = u\n  r2 = v\n  r3 = r0 * r2\n  r4 = r1 - r3\noutputs: r4\n"
    );
}

#[test]
fn product_with_minus_one_is_a_negation() {
    let text = text(|g| {
        let u = u(g);
        g.neg(u)
    });
    assert_eq!(text, "varying:\n  r0 = u\n  r1 = -r0\noutputs: r1\n");
}

#[test]
fn integer_powers_are_squared_repeatedly() {
    let text = text(|g| {
        let u = u(g);
        g.power_integer(u, 5)
    });
    assert_eq!(text, "varying:\n  r0 = u\n  r1 = r0 * r0\n  r2 = r1 * r1\n  r3 = r0 * r2\noutputs: r3\n");
}

#[test]
fn negative_powers_are_divisions() {
    let text = text(|g| {
        let u = u(g);
        g.power_integer(u, -2)
    });
    assert_eq!(text, "uniform:\n  r0 = 1.0\nvarying:\n  r1 = u\n  r2 = r1 * r1\n  r3 = r0 / r2\noutputs: r3\n");
}

#[test]
fn powers_past_the_bound_call_pow() {
    let text = text(|g| {
        let u = u(g);
        g.power_integer(u, 17)
    });
    assert_eq!(text, "uniform:\n  r0 = 17.0\nvarying:\n  r1 = u\n  r2 = pow(r1, r0)\noutputs: r2\n");
}

#[test]
fn half_powers_are_square_roots() {
    let text = text(|g| {
        let u = u(g);
        let root = g.sqrt(u);
        g.inverse(root)
    });
    assert_eq!(text, "uniform:\n  r0 = 1.0\nvarying:\n  r1 = u\n  r2 = sqrt(r1)\n  r3 = r0 / r2\noutputs: r3\n");
}

#[test]
fn powers_of_one_base_share_their_squares() {
    let program = program(|g| {
        let u = u(g);
        vec![g.power_integer(u, 2), g.power_integer(u, 4), g.power_integer(u, 6)]
    });
    assert_eq!(program.ops().len(), 4, "u, u^2, u^4, u^6:\n{program}");
}

#[test]
fn call_with_a_missing_argument_is_nan() {
    let text = text(|g| {
        let u = u(g);
        g.call(Function::Atan2, &[u])
    });
    assert_eq!(text, "uniform:\n  r0 = NaN\noutputs: r0\n");
}

#[test]
fn unused_parameters_are_not_asked_for() {
    let program = program(|g| {
        let (first, _, third) = (g.symbol("a"), g.symbol("b"), g.symbol("c"));
        vec![first, third, g.symbol("b")].into_iter().take(1).collect()
    });
    assert_eq!(program.symbols(), 1);
}

#[test]
fn program_of_a_long_sum_is_linear() {
    let program = program(|g| {
        let u = u(g);
        let terms: Vec<ExprId> = (1..=5000).map(|n| g.scale(Number::integer(n % 7 + 1), u)).collect();
        let sines: Vec<ExprId> = terms.iter().map(|&x| g.call(Function::Sin, &[x])).collect();
        let powers: Vec<ExprId> = (2..2000).map(|n| g.power_integer(u, n)).collect();
        vec![g.sum(powers.into_iter().chain(sines))]
    });
    assert!(program.ops().len() < 3 * 2000 + 50, "{}", program.ops().len());
}

#[test]
fn non_finite_value_is_found_by_output_and_sample() {
    let values = [0.0, 1.0, 2.0, 3.0, f64::NEG_INFINITY, f64::NAN];
    assert_eq!(first_non_finite(&values, 3), Some((1, 1, f64::NEG_INFINITY)));
    assert_eq!(first_non_finite(&values[..4], 2), None);
    assert_eq!(first_non_finite(&[], 0), None);
}

#[test]
fn interpreter_is_given_without_a_note_when_asked_for() {
    let (_, note) = compile(program(|g| vec![u(g)]), Backend::Interpreter);
    assert_eq!(note, None);
}

#[cfg(not(feature = "jit"))]
#[test]
fn build_without_machine_code_says_so_only_when_asked_for_it() {
    let (_, note) = compile(program(|g| vec![u(g)]), Backend::Auto);
    assert_eq!(note, None);
    let (_, note) = compile(program(|g| vec![u(g)]), Backend::Jit);
    assert_eq!(note.map(|note| note.code), Some(Code::HostUnsupported));
}

#[cfg(all(feature = "jit", any(target_arch = "x86_64", target_arch = "aarch64")))]
#[test]
fn machine_code_is_made_on_supported_hosts() {
    let (_, note) = compile(program(|g| vec![u(g)]), Backend::Jit);
    assert_eq!(note, None);
}
