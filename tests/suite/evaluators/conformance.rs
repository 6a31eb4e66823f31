//! What every evaluator has to do, as a function of how one is made.
//!
//! Expected values come from the operator table and plain arithmetic, or from [`Graph::value`], which walks the
//! expression; both are independent of programs. Everything is compared bit for bit except powers.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use trimline::eval::{EvalError, Evaluator, Program, Samples};
use trimline::expr::{Constant, ExprId, Function, Graph, Number, Variable};

/// Makes the evaluator under test.
pub type Make<'a> = &'a dyn Fn(Program) -> Arc<dyn Evaluator>;

type Verdict = Result<(), String>;

/// Numbers at which implementations tend to differ.
pub const AWKWARD: [f64; 30] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    -3.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e-310,
    f64::MAX,
    f64::MIN,
    1e300,
    -1e-300,
    f64::EPSILON,
    1.0 + f64::EPSILON,
    FRAC_PI_2,
    -FRAC_PI_2,
    PI,
    -2.0 * PI,
    1e6 * PI,
    9_007_199_254_740_993.0,
    710.0,
    -746.0,
];

/// Runs every check; the first fault, as text.
pub fn conform(make: Make) -> Verdict {
    functions_match_the_table(make)?;
    arithmetic_is_ieee(make)?;
    powers_are_close(make)?;
    every_length_is_filled(make)?;
    slices_may_start_anywhere(make)?;
    many_values_may_be_live(make)?;
    nothing_but_constants_works(make)?;
    lengths_are_checked(make)
}

fn same(what: &str, found: f64, expected: f64) -> Verdict {
    let (found, expected) = (found.to_bits(), canonical_bits(expected));
    if found == expected {
        Ok(())
    } else {
        let [is, should] = [found, expected].map(f64::from_bits);
        Err(format!("{what}: {is:?} ({found:#x}), expected {should:?} ({expected:#x})"))
    }
}

/// The bits that an evaluator stores for `value`: every NaN is stored as the same one.
pub fn canonical_bits(value: f64) -> u64 {
    if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }
}

/// All pairs of awkward numbers, as two columns.
fn awkward_pairs() -> (Vec<f64>, Vec<f64>) {
    AWKWARD.iter().flat_map(|&a| AWKWARD.iter().map(move |&b| (a, b))).unzip()
}

/// Coordinates without a pattern that an off-by-one error would hide in.
pub fn sample_coordinates(count: usize) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let column = |step: f64| (1..=count).map(|i| (i as f64 * step).fract() * 4.0 - 1.5).collect();
    (column(0.618_033_988), column(0.414_213_562), column(0.732_050_807))
}

fn run(evaluator: &dyn Evaluator, params: &[f64], [u, v, t]: [&[f64]; 3]) -> Result<Vec<f64>, String> {
    // A value no check expects stands for entries that are not written.
    let mut values = vec![-123.456; evaluator.program().outputs() * u.len()];
    evaluator.evaluate(params, Samples { u, v, t }, &mut values).map_err(|error| error.to_string())?;
    Ok(values)
}

/// `expr(a, b)` against `plain(a, b)` at all awkward pairs, with a and b as coordinates, as parameters and mixed.
fn check_binary(
    make: Make,
    what: &str,
    expr: impl Fn(&mut Graph, ExprId, ExprId) -> ExprId,
    plain: impl Fn(f64, f64) -> f64,
) -> Verdict {
    let mut graph = Graph::new();
    let (u, v) = (graph.variable(Variable::U), graph.variable(Variable::V));
    let (a, b) = (graph.symbol("a"), graph.symbol("b"));
    let outputs = [(u, v), (a, b), (u, b), (a, v)].map(|(x, y)| expr(&mut graph, x, y));
    let evaluator = make(Program::compile(&graph, &outputs));
    let (left, right) = awkward_pairs();
    let all = run(&*evaluator, &[0.0, 0.0], [&left, &right, &left])?;
    for ((&a, &b), &found) in left.iter().zip(&right).zip(&all) {
        same(&format!("{what} of coordinates {a:?}, {b:?}"), found, plain(a, b))?;
        let single = run(&*evaluator, &[a, b], [&[a], &[b], &[0.0]])?;
        for (how, &found) in ["coordinates", "parameters", "left coordinate", "right coordinate"].iter().zip(&single) {
            same(&format!("{what} of {how} {a:?}, {b:?}"), found, plain(a, b))?;
        }
    }
    Ok(())
}

fn functions_match_the_table(make: Make) -> Verdict {
    for &function in Function::ALL {
        let name = function.row().name;
        match function {
            Function::Pow => check_binary(make, name, |g, a, b| g.power(a, b), |a, b| function.value(&[a, b]))?,
            _ if function.arity() == 2 => {
                check_binary(make, name, |g, a, b| g.call(function, &[a, b]), |a, b| function.value(&[a, b]))?;
            }
            _ => check_binary(make, name, |g, a, _| g.call(function, &[a]), |a, _| function.value(&[a]))?,
        }
    }
    Ok(())
}

fn arithmetic_is_ieee(make: Make) -> Verdict {
    check_binary(make, "a + b", |g, a, b| g.sum([a, b]), |a, b| a + b)?;
    check_binary(make, "a - b", |g, a, b| g.difference(a, b), |a, b| a - b)?;
    check_binary(make, "-a", |g, a, _| g.neg(a), |a, _| -a)?;
    check_binary(make, "a * b", |g, a, b| g.product([a, b]), |a, b| a * b)?;
    check_binary(make, "1 / a", |g, a, _| g.inverse(a), |a, _| 1.0 / a)?;
    check_binary(make, "a / b", |g, a, b| g.quotient(a, b), |a, b| a * (1.0 / b))?;
    check_binary(make, "sqrt a", |g, a, _| g.sqrt(a), |a, _| a.sqrt())?;
    check_binary(make, "a^2", |g, a, _| g.power_integer(a, 2), |a, _| a * a)?;
    check_binary(make, "0.1 a - 0.7 b", tenths, |a, b| 0.1 * a - 0.7 * b)
}

fn tenths(graph: &mut Graph, a: ExprId, b: ExprId) -> ExprId {
    let number = |text| Number::parse(text).expect("a literal");
    let terms = [graph.scale(number("0.1"), a), graph.scale(number("-0.7"), b)];
    graph.sum(terms)
}

/// Integer powers against `pow`, which is correctly rounded but for an ulp.
fn powers_are_close(make: Make) -> Verdict {
    // x^16 by squaring is off by at most 15 half ulps, its inverse by one more, pow by two: less than 10 ulps.
    let tolerance = 10.0 * f64::EPSILON;
    let exponents: Vec<i64> = (-18..=18).collect();
    let mut graph = Graph::new();
    let u = graph.variable(Variable::U);
    let outputs: Vec<ExprId> = exponents.iter().map(|&n| graph.power_integer(u, n)).collect();
    let evaluator = make(Program::compile(&graph, &outputs));
    let (ordinary, _, _) = sample_coordinates(50);
    let bases: Vec<f64> = AWKWARD.into_iter().chain(ordinary).collect();
    let values = run(&*evaluator, &[], [&bases, &bases, &bases])?;
    for (&exponent, row) in exponents.iter().zip(values.chunks(bases.len())) {
        for (&base, &found) in bases.iter().zip(row) {
            let expected = Function::Pow.value(&[base, exponent as f64]);
            // Below the normal range an inverse power loses digits, or its denominator overflows.
            let is_close = (found - expected).abs() <= tolerance * expected.abs() + f64::MIN_POSITIVE;
            if !(is_close || found == expected || (found.is_nan() && expected.is_nan())) {
                return Err(format!("{base:?}^{exponent}: {found:?}, expected {expected:?}"));
            }
        }
    }
    Ok(())
}

/// A computed, a copied, a repeated, a uniform and a constant output.
fn mixed_outputs() -> (Graph, Vec<ExprId>) {
    let mut graph = Graph::new();
    let [u, v, t] = Variable::ALL.map(|variable| graph.variable(variable));
    let (a, b) = (graph.symbol("a"), graph.symbol("b"));
    let sum = graph.sum([u, a]);
    let sine = graph.call(Function::Sin, &[sum]);
    let product = graph.product([sine, v, t]);
    let uniform = graph.product([a, b]);
    let pi = graph.constant(Constant::Pi);
    (graph, vec![product, t, sine, uniform, sine, pi, v])
}

fn check_against_graph(
    make: Make,
    (graph, outputs): (&Graph, &[ExprId]),
    params: &[f64],
    [u, v, t]: [&[f64]; 3],
) -> Verdict {
    let evaluator = make(Program::compile(graph, outputs));
    let values = run(&*evaluator, params, [u, v, t])?;
    let mut values = values.iter();
    for (index, &output) in outputs.iter().enumerate() {
        for (sample, ((&u, &v), &t)) in u.iter().zip(v).zip(t).enumerate() {
            let found = *values.next().expect("there is a value for every output and sample");
            let what = format!("output {index} at sample {sample} of {}", outputs.len());
            same(&what, found, graph.value(output, params, [u, v, t]))?;
        }
    }
    Ok(())
}

fn every_length_is_filled(make: Make) -> Verdict {
    let (graph, outputs) = mixed_outputs();
    for count in [0, 1, 2, 255, 256, 257, 511, 512, 513, 1000] {
        let (u, v, t) = sample_coordinates(count);
        for first in 0..outputs.len() - 1 {
            let chosen = &outputs[first..first + 2];
            check_against_graph(make, (&graph, chosen), &[0.25, -3.0], [&u, &v, &t])?;
        }
        check_against_graph(make, (&graph, &outputs), &[0.25, -3.0], [&u, &v, &t])?;
        check_against_graph(make, (&graph, &[]), &[], [&u, &v, &t])?;
    }
    Ok(())
}

/// A `Vec` is aligned to 16 bytes by most allocators; its tail from an odd index is aligned to 8 only.
fn slices_may_start_anywhere(make: Make) -> Verdict {
    let (graph, outputs) = mixed_outputs();
    let evaluator = make(Program::compile(&graph, &outputs));
    let (u, v, t) = sample_coordinates(300);
    let params = [9.0, 0.25, -3.0];
    let whole = run(&*evaluator, &params[1..], [&u, &v, &t])?;
    for start in 0..4 {
        let count = 290;
        let mut values = vec![-123.456; outputs.len() * count + start + 1];
        let used = start..start + outputs.len() * count;
        let part = start..start + count;
        let samples = Samples { u: &u[part.clone()], v: &v[part.clone()], t: &t[part] };
        evaluator.evaluate(&params[1..], samples, &mut values[used.clone()]).map_err(|error| error.to_string())?;
        for (row, found) in whole.chunks(300).zip(values[used.clone()].chunks(count)) {
            for (&expected, &found) in row[start..].iter().zip(found) {
                same(&format!("slices from index {start}"), found, expected)?;
            }
        }
        for (index, &outside) in values.iter().enumerate().filter(|(index, _)| !used.contains(index)) {
            same(&format!("entry {index} outside the slice"), outside, -123.456)?;
        }
    }
    Ok(())
}

/// `width` sines, cosines and products that are all live before the first is used again, last one first.
pub fn wide_program(width: i64) -> (Program, Graph, Vec<ExprId>) {
    let mut graph = Graph::new();
    let [u, v, t] = Variable::ALL.map(|variable| graph.variable(variable));
    let (a, b) = (graph.symbol("a"), graph.symbol("b"));
    let mut values = Vec::new();
    for index in 0..width {
        let number = graph.integer(index + 2);
        let shifted = graph.sum([if index % 2 == 0 { u } else { v }, number]);
        values.push(match index % 4 {
            0 => graph.call(Function::Sin, &[shifted]),
            1 => graph.product([a, shifted]),
            2 => graph.call(Function::Atan2, &[shifted, t]),
            _ => {
                let uniform = graph.sum([b, number]);
                graph.product([uniform, shifted])
            }
        });
    }
    let pairs: Vec<ExprId> = values.iter().zip(values.iter().rev()).map(|(&x, &y)| graph.product([x, y])).collect();
    let outputs = vec![graph.sum(pairs), graph.sum(values.iter().copied()), values[0]];
    (Program::compile(&graph, &outputs), graph, outputs)
}

fn many_values_may_be_live(make: Make) -> Verdict {
    let (_, graph, outputs) = wide_program(120);
    let (u, v, t) = sample_coordinates(260);
    check_against_graph(make, (&graph, &outputs), &[0.75, -1.5], [&u, &v, &t])
}

fn nothing_but_constants_works(make: Make) -> Verdict {
    let mut graph = Graph::new();
    let numbers = ["0", "-1", "0.1", "-2.5e-300"].map(|text| Number::parse(text).expect("a literal"));
    let mut outputs: Vec<ExprId> = numbers.into_iter().map(|number| graph.number(number)).collect();
    let zero = graph.integer(0);
    // Division by zero is kept by the graph, so that it is reported where it is evaluated.
    let pole = graph.inverse(zero);
    outputs.extend([pole, graph.product([zero, pole])]);
    check_against_graph(make, (&graph, &outputs), &[], [&[1.0, 2.0], &[1.0, 2.0], &[1.0, 2.0]])
}

fn lengths_are_checked(make: Make) -> Verdict {
    let (graph, outputs) = mixed_outputs();
    let evaluator = make(Program::compile(&graph, &outputs));
    let (two, three) = ([0.5; 2], [0.5; 3]);
    let check = |params: &[f64], [u, v, t]: [&[f64]; 3], length: usize, expected: EvalError| {
        let mut values = vec![-123.456; length];
        let found = evaluator.evaluate(params, Samples { u, v, t }, &mut values);
        if found != Err(expected) {
            return Err(format!("wrong lengths give {found:?}, expected {expected:?}"));
        }
        values.iter().try_for_each(|&value| same("an entry after an error", value, -123.456))
    };
    let params = [1.0, 2.0];
    check(&params, [&three, &two, &two], 14, EvalError::SampleLengths { u: 3, v: 2, t: 2 })?;
    check(&params, [&two, &three, &two], 14, EvalError::SampleLengths { u: 2, v: 3, t: 2 })?;
    check(&params, [&two, &two, &three], 14, EvalError::SampleLengths { u: 2, v: 2, t: 3 })?;
    check(&params, [&two, &two, &two], 13, EvalError::ValueLength { expected: 14, found: 13 })?;
    check(&params, [&two, &two, &two], 15, EvalError::ValueLength { expected: 14, found: 15 })?;
    check(&params[1..], [&two, &two, &two], 14, EvalError::MissingParameters { expected: 2, found: 1 })
}
