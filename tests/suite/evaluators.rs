//! Both evaluators against one conformance suite, against each other, and under the conditions of use: many
//! threads, many modules, large programs.

mod conformance;
mod random;

use std::sync::Arc;

use trimline::diagnostic::Code;
use trimline::eval::{
    Backend, EvalError, Evaluator, Jet, JetValues, Op, Program, Samples, Workspace, compile, first_non_finite,
};
use trimline::expr::{Derivative, ExprId, Function, Graph, Number, Variable};
use trimline::kernels::Rows;

use conformance::{conform, sample_coordinates, wide_program};

/// The interpreter.
fn interpreter(program: Program) -> Arc<dyn Evaluator> {
    compile(program, Backend::Interpreter).0
}

/// Machine code, where this build and host have it.
fn machine_code(program: Program) -> Arc<dyn Evaluator> {
    let (evaluator, note) = compile(program, Backend::Jit);
    assert_eq!(note.is_some(), !has_machine_code(), "{note:?}");
    evaluator
}

fn has_machine_code() -> bool {
    cfg!(all(feature = "jit", any(target_arch = "x86_64", target_arch = "aarch64")))
}

#[test]
fn interpreter_conforms() {
    assert_eq!(conform(&interpreter), Ok(()));
}

#[test]
fn machine_code_conforms() {
    assert_eq!(conform(&machine_code), Ok(()));
}

/// An evaluator with one fault, on top of a faultless one.
struct Planted {
    inner: Arc<dyn Evaluator>,
    fault: Fault,
}

type Fault = fn(samples: usize, values: &mut [f64]);

impl Evaluator for Planted {
    fn program(&self) -> &Program {
        self.inner.program()
    }

    fn evaluate(&self, params: &[f64], samples: Samples<'_>, values: &mut [f64]) -> Result<(), EvalError> {
        let result = self.inner.evaluate(params, samples, values);
        (self.fault)(samples.u.len(), values);
        result
    }
}

fn check_fault_is_found(fault: Fault) {
    let make = |program| -> Arc<dyn Evaluator> { Arc::new(Planted { inner: interpreter(program), fault }) };
    assert!(conform(&make).is_err(), "the suite passes a faulty evaluator");
}

#[test]
fn suite_finds_a_wrong_sign_of_zero() {
    check_fault_is_found(|_, values| values.iter_mut().filter(|x| **x == 0.0).for_each(|x| *x = -*x));
}

#[test]
fn suite_finds_another_nan() {
    check_fault_is_found(|_, values| values.iter_mut().filter(|x| x.is_nan()).for_each(|x| *x = -*x));
}

#[test]
fn suite_finds_flushed_subnormals() {
    check_fault_is_found(|_, values| values.iter_mut().filter(|x| x.is_subnormal()).for_each(|x| *x *= 0.0));
}

#[test]
fn suite_finds_an_error_of_one_ulp() {
    check_fault_is_found(|_, values| values.iter_mut().filter(|x| x.is_normal()).for_each(|x| *x = x.next_up()));
}

#[test]
fn suite_finds_a_forgotten_last_sample() {
    check_fault_is_found(|samples, values| {
        let rows = values.chunks_mut(samples.max(1));
        rows.filter_map(|row| row.last_mut()).for_each(|x| *x = 0.5);
    });
}

#[test]
fn suite_finds_a_fault_past_the_first_block() {
    check_fault_is_found(|samples, values| {
        values.chunks_mut(samples.max(1)).filter_map(|row| row.get_mut(256)).for_each(|x| *x = 0.5);
    });
}

#[test]
fn suite_finds_swapped_rows() {
    check_fault_is_found(|samples, values| {
        if samples > 0 && values.len() == 2 * samples {
            values.rotate_left(samples);
        }
    });
}

#[test]
fn suite_finds_unchecked_lengths() {
    check_fault_is_found(|samples, values| {
        if !values.len().is_multiple_of(samples.max(1)) {
            values.fill(0.5);
        }
    });
}

#[test]
fn evaluators_agree_on_many_live_values() {
    let (u, v, t) = sample_coordinates(300);
    let samples = Samples { u: &u, v: &v, t: &t };
    let (program, _, _) = wide_program(400);
    let mut values = [vec![0.0; 300 * program.outputs()], vec![0.0; 300 * program.outputs()]];
    let params = [0.75, -1.5];
    interpreter(program.clone()).evaluate(&params, samples, &mut values[0]).expect("lengths fit");
    machine_code(program).evaluate(&params, samples, &mut values[1]).expect("lengths fit");
    assert_eq!(bits(&values[0]), bits(&values[1]));
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|x| x.to_bits()).collect()
}

/// `u` plus as many sines and products as it takes to have more than `ops` ops.
fn program_of(ops: usize) -> Program {
    let mut graph = Graph::new();
    let (u, v) = (graph.variable(Variable::U), graph.variable(Variable::V));
    let mut value = u;
    for index in 0..ops / 4 + 1 {
        let number = graph.number(Number::integer(index as i64 + 2));
        let sum = graph.sum([value, number]);
        let sine = graph.call(Function::Sin, &[sum]);
        value = graph.product([sine, v]);
    }
    Program::compile(&graph, &[value])
}

/// Runs on a stack of 1 MiB, the smallest main stack among the systems we support.
fn on_a_small_stack<R: Send + 'static>(work: impl FnOnce() -> R + Send + 'static) -> R {
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(work).expect("a thread can be started");
    thread.join().expect("the work does not panic")
}

#[test]
fn large_program_is_lowered_and_run_on_a_small_stack() {
    on_a_small_stack(|| {
        let program = program_of(100_000);
        let (evaluator, note) = compile(program.clone(), Backend::Jit);
        assert_eq!(note.map(|note| note.code), Some(Code::HostUnsupported));
        let (u, v, t) = sample_coordinates(3);
        let samples = Samples { u: &u, v: &v, t: &t };
        let mut values = [vec![0.0; 3], vec![0.0; 3]];
        evaluator.evaluate(&[], samples, &mut values[0]).expect("lengths fit");
        interpreter(program).evaluate(&[], samples, &mut values[1]).expect("lengths fit");
        assert_eq!(bits(&values[0]), bits(&values[1]));
    });
}

#[test]
fn calls_short_and_long_give_the_same_bits_before_and_after_machine_code_is_made() {
    let (program, _, _) = wide_program(20);
    let (adaptive, note) = compile(program.clone(), Backend::Auto);
    assert!(note.is_none());
    let reference = interpreter(program.clone());
    let params = [0.5, 2.0];
    // More short calls than it takes until they are compiled, long ones between them.
    for call in 0..1200 {
        let count = if call % 50 == 0 { 300 } else { 1 + call % 7 };
        let (u, v, t) = sample_coordinates(count);
        let samples = Samples { u: &u, v: &v, t: &t };
        let mut values = [vec![0.0; count * program.outputs()], vec![0.0; count * program.outputs()]];
        adaptive.evaluate(&params, samples, &mut values[0]).expect("lengths fit");
        reference.evaluate(&params, samples, &mut values[1]).expect("lengths fit");
        assert_eq!(bits(&values[0]), bits(&values[1]), "call {call}");
    }
}

#[test]
fn rows_have_the_bits_of_values_for_every_evaluator_and_a_workspace_may_be_shared() {
    let (first, _, _) = wide_program(7);
    let (second, _, _) = wide_program(12);
    let (mut rows, mut workspace) = (Rows::default(), Workspace::default());
    for backend in [Backend::Interpreter, Backend::Jit, Backend::Auto] {
        // -0 and 0 are equal, and 1 over them are not.
        for params in [[0.5, 2.0], [0.0, 1.0], [-0.0, 1.0], [0.5, 2.0]] {
            for (program, count) in [(&first, 1), (&second, 1500), (&first, 40), (&second, 0)] {
                let (evaluator, _) = compile(program.clone(), backend);
                let (u, v, t) = sample_coordinates(count);
                let samples = Samples { u: &u, v: &v, t: &t };
                let mut values = vec![0.0; count * program.outputs()];
                evaluator.evaluate(&params, samples, &mut values).expect("lengths fit");
                evaluator.evaluate_rows(&params, samples, &mut rows, &mut workspace).expect("lengths fit");
                let found: Vec<f64> = rows.iter().flatten().copied().collect();
                assert_eq!(bits(&found), bits(&values), "{backend:?} {count}");
            }
            let short = Samples { u: &[0.0], v: &[], t: &[0.0] };
            let (evaluator, _) = compile(first.clone(), backend);
            assert!(evaluator.evaluate_rows(&params, short, &mut rows, &mut workspace).is_err());
        }
    }
}

#[test]
fn jet_has_the_values_of_its_functions_and_stores_equal_ones_once() {
    let mut graph = Graph::new();
    let (a, v, t) = (graph.symbol("a"), graph.variable(Variable::V), graph.variable(Variable::T));
    let av = graph.product([a, v]);
    let sine = graph.call(Function::Sin, &[av]);
    let moving = graph.product([t, sine]);
    let functions = [a, t, sine, moving];
    let orders = [Derivative::NONE, Derivative::new(0, 0, 1), Derivative::new(0, 2, 0), Derivative::new(0, 0, 2)];
    let outputs: Vec<ExprId> = orders
        .iter()
        .flat_map(|orders| functions.map(|function| graph.derivative(function, *orders).expect("smooth")))
        .collect();
    let jet = Arc::new(Jet::new(&graph, &outputs, Backend::Auto));
    // t, sin av, t sin av, and the second derivatives of the last two; all else is a, 0 or 1.
    assert_eq!((jet.len(), jet.distinct()), (16, 5));
    let plain = interpreter(Program::compile(&graph, &outputs));
    let mut values = JetValues::new(jet);
    for (a, count) in [(0.5, 3), (0.5, 700), (-2.0, 700), (0.0, 1), (f64::INFINITY, 3)] {
        let (u, v, t) = sample_coordinates(count);
        let samples = Samples { u: &u, v: &v, t: &t };
        let mut expected = vec![0.0; 16 * count];
        plain.evaluate(&[a], samples, &mut expected).expect("lengths fit");
        values.evaluate(&[a], samples).expect("lengths fit");
        for (output, expected) in expected.chunks(count).enumerate() {
            assert_eq!(bits(values.row(output)), bits(expected), "output {output}, a = {a}");
        }
        let found = values.first_non_finite().map(|(output, sample, value)| (output, sample, value.to_bits()));
        let first = first_non_finite(&expected, count);
        assert_eq!(found, first.map(|(output, sample, value)| (output, sample, value.to_bits())));
    }
    assert!(values.row(16).is_empty());
    assert!(values.evaluate(&[], Samples { u: &[0.0], v: &[0.0], t: &[0.0] }).is_err());
}

#[test]
fn long_sums_of_like_terms_are_those_of_the_single_terms() {
    let mut graph = Graph::new();
    let (a, b, v, t) = (graph.symbol("a"), graph.symbol("b"), graph.variable(Variable::V), graph.variable(Variable::T));
    let mut terms = Vec::new();
    for k in 1..6 {
        let argument = graph.scale(Number::integer(k), v);
        let sine = graph.call(Function::Sin, &[argument]);
        for factors in [vec![a, sine], vec![b, sine], vec![a, t, sine], vec![b, b, t, sine], vec![a], vec![b, t]] {
            terms.push(graph.product(factors));
        }
    }
    let sum = graph.sum(terms.clone());
    let program = Program::compile(&graph, &[sum]);
    let multiplications = program.varying().iter().filter(|op| matches!(op, Op::Mul(..))).count();
    // For each sine its argument, and with and without t a factor; one product with t.
    assert!(multiplications <= 5 + 2 * 5 + 2, "{program}");
    let (u, v, t) = sample_coordinates(50);
    let samples = Samples { u: &u, v: &v, t: &t };
    let mut found = vec![0.0; 50];
    interpreter(program).evaluate(&[1.5, -0.75], samples, &mut found).expect("lengths fit");
    let mut parts = vec![0.0; 50 * terms.len()];
    interpreter(Program::compile(&graph, &terms)).evaluate(&[1.5, -0.75], samples, &mut parts).expect("lengths fit");
    for (point, found) in found.iter().enumerate() {
        let parts: Vec<f64> = parts.iter().skip(point).step_by(50).copied().collect();
        let (expected, size): (f64, f64) = (parts.iter().sum(), parts.iter().map(|part| part.abs()).sum());
        // A rounding or two for each of 30 terms.
        assert!((found - expected).abs() <= 60.0 * f64::EPSILON * size, "{point}: {found} {expected}");
    }
}

#[test]
fn largest_compiled_program_fits_a_small_stack() {
    on_a_small_stack(|| {
        let (program, _, _) = wide_program(680);
        assert!((3500..4096).contains(&program.ops().len()), "near the bound: {}", program.ops().len());
        let evaluator = machine_code(program.clone());
        let (u, v, t) = sample_coordinates(5);
        let mut values = vec![0.0; 5 * program.outputs()];
        assert_eq!(evaluator.evaluate(&[0.5, 2.0], Samples { u: &u, v: &v, t: &t }, &mut values), Ok(()));
    });
}

#[test]
fn evaluator_outlives_everything_it_was_made_from() {
    let evaluator = {
        let mut graph = Graph::new();
        let u = graph.variable(Variable::U);
        let sine = graph.call(Function::Sin, &[u]);
        machine_code(Program::compile(&graph, &[sine]))
    };
    // Other modules come and go, so that freed pages would be used again.
    for size in 0..20 {
        drop(machine_code(program_of(size)));
    }
    let mut value = [0.0];
    assert_eq!(evaluator.evaluate(&[], Samples { u: &[0.5], v: &[0.0], t: &[0.0] }, &mut value), Ok(()));
    assert_eq!(value, [Function::Sin.value(&[0.5])]);
}

#[test]
fn evaluator_is_shared_by_eight_threads() {
    let (program, _, _) = wide_program(40);
    let evaluators = [interpreter(program.clone()), machine_code(program.clone())];
    let reference = interpreter(program.clone());
    std::thread::scope(|scope| {
        for seed in 0..8 {
            let (evaluators, reference, outputs) = (&evaluators, &reference, program.outputs());
            scope.spawn(move || {
                let count = 300 + seed;
                let (u, v, t) = sample_coordinates(count);
                let samples = Samples { u: &u, v: &v, t: &t };
                let params = [seed as f64 * 0.25, 1.5];
                let mut expected = vec![0.0; count * outputs];
                reference.evaluate(&params, samples, &mut expected).expect("lengths fit");
                for evaluator in evaluators.iter().cycle().take(20) {
                    let mut values = vec![0.0; count * outputs];
                    evaluator.evaluate(&params, samples, &mut values).expect("lengths fit");
                    assert_eq!(bits(&values), bits(&expected));
                }
            });
        }
    });
}

/// Bytes of executable pages that belong to no file: the code of every living module.
#[cfg(target_os = "linux")]
fn executable_bytes() -> u64 {
    let maps = std::fs::read_to_string("/proc/self/maps").expect("linux shows a process its own pages");
    let mut total = 0;
    for line in maps.lines() {
        let mut fields = line.split_whitespace();
        let (Some(range), Some(access)) = (fields.next(), fields.next()) else { continue };
        assert!(!(access.contains('w') && access.contains('x')), "pages both writable and executable: {line}");
        if access.contains('x') && fields.nth(3).is_none() {
            let (start, end) = range.split_once('-').expect("a range of addresses");
            let address = |text| u64::from_str_radix(text, 16).expect("a hexadecimal address");
            total += address(end) - address(start);
        }
    }
    total
}

#[cfg(target_os = "linux")]
#[test]
fn modules_free_their_pages() {
    let program = program_of(8);
    let held = machine_code(program.clone());
    assert_eq!(executable_bytes() > 0, has_machine_code());
    let before = executable_bytes();
    for _ in 0..2000 {
        drop(machine_code(program.clone()));
    }
    drop(held);
    // A leak is a page of 4 KiB a module, 8 MB in all. Tests that run beside this one hold a few modules of at
    // most 100 KiB each; a quarter of the leak leaves room for twenty of them. Counting only executable pages,
    // not all memory as /proc/self/statm does, keeps what other tests allocate out of the balance.
    let grown = executable_bytes().saturating_sub(before);
    assert!(grown < 2_000_000, "{grown} bytes of code are still mapped");
}
