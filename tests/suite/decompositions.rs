//! Boundary data to basis functions and coefficients: texts, check values of the paper, and the sums they stand for.

use std::collections::BTreeSet;

use proptest::prelude::*;
use trimline::decompose::{Decomposition, decompose};
use trimline::expr::{ExprId, Notation};
use trimline::limits::Limits;
use trimline::problem::Bindings;

use crate::spec::{decomposition, example, examples, patch, problem, with_data};

fn unicode(decomposition: &Decomposition) -> String {
    decomposition.to_text(Notation::Unicode, &Limits::default()).expect("short")
}

fn ascii(decomposition: &Decomposition, expr: ExprId) -> String {
    decomposition.text_of(expr, Notation::Ascii, &Limits::default()).expect("short")
}

/// The basis functions of data `value`, as text.
fn basis_of(value: &str) -> Vec<String> {
    let text = format!("param a = 1.5, b = 0.5, c = 2\n{}", with_data(value));
    let decomposition = decomposition(&text);
    decomposition.basis.iter().map(|function| ascii(&decomposition, function.expr)).collect()
}

/// Basis functions with the x coefficient at u = 0, as text, in the order of their texts.
fn terms_of(value: &str) -> BTreeSet<(String, String)> {
    let text = format!("param a = 1.5, b = 0.5, c = 2\n{}", with_data(value));
    let decomposition = decomposition(&text);
    let terms = decomposition.basis.iter().zip(&decomposition.coefficients[0]);
    terms.map(|(f, c)| (ascii(&decomposition, f.expr), ascii(&decomposition, c[0]))).collect()
}

fn pairs(terms: &[(&str, &str)]) -> BTreeSet<(String, String)> {
    terms.iter().map(|(f, c)| ((*f).to_owned(), (*c).to_owned())).collect()
}

/// Largest difference of `Σ c_ij F_j` and the data, relative to the largest term.
fn resummation_error(text: &str, factors: &[f64], point: [f64; 2]) -> f64 {
    let problem = problem(text);
    let decomposition = decomposition(text);
    let stated = Bindings::evaluate(&problem).expect("finite parameters");
    // Every parameter gets a value of its own, not only the stated one.
    let mut params: Vec<f64> =
        stated.as_slice().iter().zip(factors.iter().cycle()).map(|(value, factor)| value * factor + 0.01).collect();
    params.resize(decomposition.graph.symbols().len(), f64::NAN);
    let at = [f64::NAN, point[0], point[1]];
    let mut worst = 0.0_f64;
    for (condition, coefficients) in patch(&problem).conditions.iter().zip(&decomposition.coefficients) {
        for axis in 0..3 {
            let expected = problem.graph.value(condition.value[axis], &params, at);
            let terms = decomposition.basis.iter().zip(coefficients).map(|(function, vector)| {
                decomposition.graph.value(vector[axis], &params, [f64::NAN; 3])
                    * decomposition.graph.value(function.expr, &params, at)
            });
            let (mut sum, mut size) = (0.0, expected.abs());
            for term in terms {
                sum += term;
                size = size.max(term.abs());
            }
            let error = (sum - expected).abs();
            worst = worst.max(if size > 0.0 { error / size } else { error });
        }
    }
    worst
}

#[test]
fn text_of_every_example_is_as_recorded() {
    for (name, text) in examples() {
        let problem = problem(&text);
        for patch in &problem.patches {
            let name = if problem.patches.len() == 1 { name.clone() } else { format!("{name}.{}", patch.name) };
            let decomposition = decompose(&problem, patch, &Limits::default()).expect("an example");
            insta::assert_snapshot!(name, unicode(&decomposition));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The twin of the recorded texts: what they say sums up to what the example states.
    #[test]
    fn sums_of_basis_functions_are_the_stated_data(
        factors in prop::collection::vec(0.2..1.8_f64, 1..7),
        v in 0.0..7.0_f64,
        t in -1.0..2.0_f64,
    ) {
        // Data on four sides are not factored.
        for (name, text) in examples().into_iter().filter(|(_, text)| !patch(&problem(text)).is_four_sided()) {
            let error = resummation_error(&text, &factors, [v, t]);
            // Some tens of roundings, of functions with arguments up to about 15.
            prop_assert!(error < 1e-13, "{name}: {error:.1e}");
        }
    }
}

#[test]
fn example_of_eq6_has_the_8_functions_and_12_constants_of_the_paper() {
    let decomposition = decomposition(&example("eq6"));
    let functions: BTreeSet<String> = decomposition.basis.iter().map(|f| ascii(&decomposition, f.expr)).collect();
    let expected = ["1", "t", "v", "v^2", "exp(v)", "t*sin(v)", "t*cos(v)", "v*t"].map(str::to_owned);
    assert_eq!(functions, expected.into_iter().collect());
    let expected = [
        "bx t*sin(v) a11",
        "by t*cos(v) a12",
        "bz t a13",
        "b'x 1 a21",
        "b'y v a22",
        "b'z t a23",
        "dx v a31",
        "dy v^2 a32",
        "dz 1 a33",
        "d'x v*t a41",
        "d'y exp(v) a42",
        "d'z 1 a43",
    ];
    assert_eq!(constants(&decomposition), expected.map(str::to_owned).into_iter().collect());
}

#[test]
fn example_of_eq19_has_the_5_functions_of_the_paper() {
    let decomposition = decomposition(&example("eq19"));
    let functions: BTreeSet<String> = decomposition.basis.iter().map(|f| ascii(&decomposition, f.expr)).collect();
    let expected = ["exp(t)*sin(v)", "exp(-t)*sin(v)", "exp(t)*cos(v)", "exp(-t)*cos(v)", "1"].map(str::to_owned);
    assert_eq!(functions, expected.into_iter().collect());
}

/// The list after Eq. (30). The paper's t sin(-v) is -t sin(v) here, so `b_y9 = b5` and `d_y9 = b8` change sign.
#[test]
fn example_of_eq29_30_has_the_16_functions_and_the_constants_of_the_paper() {
    let decomposition = decomposition(&example("eq29_30"));
    assert_eq!(decomposition.basis.len(), 16);
    let expected = [
        "bx sinh(a2 + a1*v) b1",
        "bx t*sinh(a2 + a1*v) -b1",
        "bx sin(a3*v) b2",
        "bx t*sin(a3*v) -b2",
        "bx t*cos(v) b3",
        "by cosh(a4*v) b4",
        "by t*cosh(a4*v) -b4",
        "by cos(a3*v) b2",
        "by t*cos(a3*v) -b2",
        "by t*sin(v) -b5",
        "bz 1 h0 + b5",
        "bz t h1 - h0 - b5",
        "b'z 1 -b5",
        "b'z t b5",
        "dx sin(a5*v) 0.8*b6",
        "dx t*sin(a5*v) -0.8*b6",
        "dx t*cos(v) b7",
        "dy cos(a5*v) 0.8*b6",
        "dy t*cos(a5*v) -0.8*b6",
        "dy t*sin(v) -b8",
        "dz 1 h3",
        "dz t h4 - h3",
        "d'x sin(a5*v) b6",
        "d'x t*sin(a5*v) -b6",
        "d'y cos(a5*v) b6",
        "d'y t*cos(a5*v) -b6",
        "d'z t -h5",
    ];
    let sorted = |list: &BTreeSet<String>| list.iter().map(|line| terms_in_order(line)).collect::<BTreeSet<_>>();
    assert_eq!(sorted(&constants(&decomposition)), sorted(&expected.map(str::to_owned).into_iter().collect()));
}

/// The order of terms in a sum is canonical, not the paper's: compare them as sets.
fn terms_in_order(line: &str) -> String {
    let mut terms: Vec<String> = line.replace("- ", "+ -").split('+').map(|term| term.trim().to_owned()).collect();
    if let Some((head, first)) = terms[0].clone().rsplit_once(' ') {
        terms[0] = first.to_owned();
        terms.sort();
        return format!("{head} {}", terms.join(" + "));
    }
    line.to_owned()
}

/// Nonzero constants as `condition component, function, value`.
fn constants(decomposition: &Decomposition) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (symbol, vectors) in ["b", "b'", "d", "d'"].iter().zip(&decomposition.coefficients) {
        for (function, vector) in decomposition.basis.iter().zip(vectors) {
            for (axis, value) in ["x", "y", "z"].iter().zip(vector) {
                if !decomposition.graph.is_zero(*value) {
                    let function = ascii(decomposition, function.expr);
                    found.insert(format!("{symbol}{axis} {function} {}", ascii(decomposition, *value)));
                }
            }
        }
    }
    found
}

#[test]
fn equal_documents_give_equal_bytes_in_every_thread() {
    for (name, text) in examples() {
        let here = unicode(&decomposition(&text));
        let there = std::thread::spawn(move || unicode(&decomposition(&text))).join().expect("no panic");
        assert_eq!(here, there, "{name}");
    }
}

/// Within one constraint the order is that of the expression's canonical form.
#[test]
fn basis_order_is_that_of_the_constraints_in_the_source() {
    let data = "at u = 1: S = [v, 0, 0], dS/du = 0\nat u = 0: S = [t, v, 1], dS/du = 0";
    let decomposition = decomposition(data);
    let basis: Vec<String> = decomposition.basis.iter().map(|f| ascii(&decomposition, f.expr)).collect();
    assert_eq!(basis, ["v", "t", "1"]);
}

#[test]
fn order_of_terms_in_a_sum_does_not_change_the_basis() {
    let text = |value| unicode(&decomposition(&format!("param a = 1\n{}", with_data(value))));
    assert_eq!(text("a + v + sin(v)"), text("v + a + sin(v)"));
}

#[test]
fn sine_of_minus_v_is_minus_sine_of_v() {
    assert_eq!(terms_of("a sin(-v) + b cos(-v)"), pairs(&[("sin(v)", "-a"), ("cos(v)", "b")]));
}

#[test]
fn exponential_of_a_sum_is_one_function() {
    assert_eq!(terms_of("e^(a + v)"), pairs(&[("exp(v + a)", "1")]));
    assert_eq!(terms_of("e^(2 a + b v - t)"), pairs(&[("exp(-t + 2*a + b*v)", "1")]));
    assert_eq!(terms_of("e^(2(v + 1)) + e^(2v + 2)"), pairs(&[("exp(2 + 2*v)", "2")]));
}

#[test]
fn exponents_that_cancel_go_to_the_coefficient() {
    assert_eq!(terms_of("b e^(a + v) e^-v"), pairs(&[("1", "b*exp(a)")]));
    assert_eq!(terms_of("(e^(a + v) + t) e^-v"), pairs(&[("1", "exp(a)"), ("t*exp(-v)", "1")]));
    assert_eq!(
        terms_of("(e^(a + v) + 1) (e^-v sin t + 2)"),
        pairs(&[("sin(t)", "exp(a)"), ("exp(v + a)", "2"), ("exp(-v)*sin(t)", "1"), ("1", "2")])
    );
    assert_eq!(terms_of("e^((v + 1)^2 - v^2 - 2v)"), pairs(&[("1", "e")]));
}

/// The parts of the exponent, e^-900 and e^(600 v), leave the doubles; the data do not.
#[test]
fn narrow_bell_is_finite_where_its_data_are() {
    for value in ["5 e^(-100(v - 3)^2)", "a e^(-100(v - 2 a)^2) cos t"] {
        let text = format!("param a = 1.5, b = 0.5, c = 2\n{}", with_data(value));
        for v in [0.0, 1.5, 2.9, 3.0, 3.1, 6.2] {
            let problem = problem(&text);
            let decomposition = decomposition(&text);
            let params = Bindings::evaluate(&problem).expect("finite").as_slice().to_vec();
            let at = [f64::NAN, v, 0.4];
            let expected = problem.graph.value(patch(&problem).conditions[0].value[0], &params, at);
            let functions = decomposition.basis.iter().zip(&decomposition.coefficients[0]);
            let found: f64 = functions
                .map(|(function, vector)| {
                    decomposition.graph.value(vector[0], &params, [f64::NAN; 3])
                        * decomposition.graph.value(function.expr, &params, at)
                })
                .sum();
            // The expanded exponent has terms up to 4000, each rounded to 5e-13.
            assert!((found - expected).abs() <= 4e-12 * expected.abs(), "{value} at {v}: {found} {expected}");
        }
    }
}

#[test]
fn like_terms_merge_and_cancel() {
    assert_eq!(terms_of("a sin v + b sin v"), pairs(&[("sin(v)", "a + b")]));
    assert_eq!(terms_of("a v - a v + t"), pairs(&[("t", "1")]));
    assert_eq!(terms_of("v*(1 + a) - v - a*v"), pairs(&[]));
}

#[test]
fn products_of_sums_expand() {
    assert_eq!(terms_of("(a + v)*(b - t)"), pairs(&[("1", "a*b"), ("t", "-a"), ("v", "b"), ("v*t", "-1")]),);
    assert_eq!(basis_of("(1 + sin v)^3").len(), 4);
    assert_eq!(basis_of("(1 + v + sin t)^3").len(), 10);
}

#[test]
fn powers_of_first_degree_polynomials_stay_whole() {
    assert_eq!(terms_of("a (v - 10)^6"), pairs(&[("(-10 + v)^6", "a")]));
    assert_eq!(terms_of("(2(v - b))^3 (v - b)"), pairs(&[("v*(v - b)^3", "8"), ("(v - b)^3", "-8*b")]));
    assert_eq!(terms_of("(v + t)^2 + v"), pairs(&[("(v + t)^2", "1"), ("v", "1")]));
    // A first power alone loses as much as v itself was rounded by.
    assert_eq!(basis_of("v - 10"), ["1", "v"]);
}

#[test]
fn powers_of_sums_that_are_multiples_of_each_other_are_one_function() {
    assert_eq!(basis_of("(v - 1)^2 - (1 - v)^2").len(), 0);
    assert_eq!(terms_of("(v - 1)^3 + (1 - v)^3 + (3 - 3v)^3"), pairs(&[("(-1 + v)^3", "-27")]));
    assert_eq!(terms_of("(2(v - b))^4 + a (v - b)^4"), pairs(&[("(v - b)^4", "16 + a")]));
    assert_eq!(basis_of("(v + t)^2 + (-v - t)^2").len(), 1);
    // 1e600 is no double, though the power is one.
    assert_eq!(basis_of("(1000v + 1)^200"), ["(1 + 1000*v)^200"]);
}

#[test]
fn arguments_are_compared_multiplied_out_and_evaluated_as_written() {
    assert_eq!(basis_of("sin((v + 1)^2) - sin(v^2 + 2v + 1)").len(), 0);
    assert_eq!(basis_of("sin((v - 9)^2) + sin(v^2 - 18v + 81)"), ["sin((-9 + v)^2)"]);
    assert_eq!(terms_of("e^(a (v - 9)^2) + 2e^(a v^2 - 18a v + 81a)"), pairs(&[("exp(a*(-9 + v)^2)", "3")]));
}

#[test]
fn equal_arguments_written_differently_are_one_function() {
    assert_eq!(basis_of("sin(2(v + 1)) + sin(2v + 2) + sin(2 + v + v)").len(), 1);
    assert_eq!(basis_of("cos(a(v + t)) - cos(a v + a t)").len(), 0);
}

#[test]
fn division_by_a_parameter_goes_to_the_coefficient() {
    assert_eq!(terms_of("v/a"), pairs(&[("v", "1/a")]));
    assert_eq!(terms_of("v/(a t)"), pairs(&[("v/t", "1/a")]));
}

#[test]
fn parameter_in_a_power_of_the_coordinate_stays_in_the_function() {
    assert_eq!(basis_of("v^a"), ["v^a"]);
    assert_eq!(terms_of("(a v)^2"), pairs(&[("v^2", "a^2")]));
    assert_eq!(terms_of("b^a*v"), pairs(&[("v", "b^a")]));
}

#[test]
fn data_that_are_zero_have_no_basis() {
    assert_eq!(basis_of("0"), Vec::<String>::new());
    assert!(unicode(&decomposition(&with_data("0"))).contains("0 functions"));
}

#[test]
fn random_sums_of_products_sum_up_again() {
    let parts = ["a", "v", "t", "sin(v)", "e^(b v)", "cos(a t)", "(1 + v)", "(c - t)", "e^(v - t)", "sqrt(2 + t)"];
    // A fixed linear congruence: every run sees the same 60 expressions.
    let mut state = 12345_u64;
    let mut next = |bound: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % bound
    };
    for _ in 0..60 {
        let mut terms = Vec::new();
        for _ in 0..=next(3) {
            let factors: Vec<String> =
                (0..=next(3)).map(|_| format!("{}^{}", parts[next(parts.len())], 1 + next(3))).collect();
            terms.push(factors.join("*"));
        }
        let value = terms.join(" - ");
        let text = format!("param a = 1.5, b = 0.5, c = 2\n{}", with_data(&value));
        let error = resummation_error(&text, &[0.7, 1.3], [0.6, 0.4]);
        // Cancellation between a handful of expanded terms costs a digit or two.
        assert!(error < 1e-12, "{value}: {error:.1e}");
    }
}
