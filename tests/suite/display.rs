//! Expressions as text: what is written reads back as the same expression, in every notation.

use proptest::prelude::*;
use trimline::expr::Notation;
use trimline::limits::Limits;
use trimline::problem::Bindings;

use crate::spec::{patch, problem_within, told, with_data};

/// What `problem`'s expression reads as after it was written as text.
fn reread(text: &str, notation: Notation) -> Result<(), TestCaseError> {
    let declared = "param a = 1, b1 = 2, alpha = 3, r_max = 4\n";
    let document = format!("{declared}{}", with_data(text));
    let Ok(first) = problem_within(&document, &Limits::default()) else { return Ok(()) };
    let value = patch(&first).conditions[0].value[0];
    let written = first.graph.text(value, notation, 1 << 16).expect("short");
    let written = if notation == Notation::Latex { format!("$${written}$$") } else { written };
    let document = format!("{declared}at u = 0: S = [{text}, {written}, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let both = problem_within(&document, &Limits::default())
        .map_err(|found| TestCaseError::fail(format!("{text} is written {written}: {}", told(&document, &found))))?;
    let value = patch(&both).conditions[0].value;
    let text_of = |id| both.graph.text(id, notation, 1 << 16).expect("short");
    // `\frac{2 (v + t)}{v}` brackets its numerator, where the number is multiplied out: another form of the same.
    if notation == Notation::Latex && value[0] != value[1] {
        let params = Bindings::evaluate(&both).expect("finite params");
        for point in [[0.0, 0.7, 0.4], [0.0, 2.3, 1.9], [0.0, -1.1, 0.3]] {
            let [expected, found] = [value[0], value[1]].map(|id| both.graph.value(id, params.as_slice(), point));
            let agree = (expected - found).abs() <= 1e-9 * expected.abs() || (expected.is_nan() && found.is_nan());
            prop_assert!(agree || expected == found, "{} is written {}: {} and {}", text, written, expected, found);
        }
        return Ok(());
    }
    prop_assert_eq!(value[0], value[1], "{} is written {} but reads {}", text, text_of(value[0]), text_of(value[1]));
    Ok(())
}

/// Expressions as people type them.
fn expression() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        4 => prop::sample::select(vec!["v", "t", "a", "b_1", "α", "r_max", "e", "π"]).prop_map(str::to_owned),
        2 => prop::sample::select(vec!["2", "0.8", "1e-3", "0.5", "10", "1", "0", "1e20", ".5"]).prop_map(str::to_owned),
    ];
    let functions =
        vec!["sin", "cos", "tan", "sinh", "exp", "ln", "sqrt", "atan", "cbrt", "abs", "log10", "sec", "acosh"];
    leaf.prop_recursive(5, 24, 3, move |inner| {
        let call = prop::sample::select(functions.clone());
        prop_oneof![
            3 => (inner.clone(), prop::sample::select(vec!["+", "-", "*", "/"]), inner.clone())
                .prop_map(|(a, op, b)| format!("({a}) {op} ({b})")),
            2 => (inner.clone(), prop::sample::select(vec!["2", "3", "-1", "-2", "0.5", "(1/3)", "-0.5", "12"]))
                .prop_map(|(base, exponent)| format!("({base})^{exponent}")),
            1 => (inner.clone(), inner.clone()).prop_map(|(base, exponent)| format!("({base})^({exponent})")),
            1 => inner.clone().prop_map(|a| format!("-({a})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(y, x)| format!("atan2({y}, {x})")),
            3 => (call, inner).prop_map(|(function, argument)| format!("{function}({argument})")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn text_in_every_notation_reads_back_as_the_same_expression(text in expression()) {
        reread(&text, Notation::Ascii)?;
        reread(&text, Notation::Unicode)?;
        reread(&text, Notation::Latex)?;
    }
}

#[test]
fn text_of_awkward_expressions_reads_back_as_the_same_expression() {
    for text in [
        "((0)^-2)^(v)",
        "1/(v t)",
        "-1/v",
        "v^(-t)",
        "(v^t)^2",
        "(v^a)^b_1",
        "e^(v^2)",
        "e^(-v)^2",
        "2^(1/3)",
        "(1/3)^v",
        "(-2)^v",
        "(2/3 v)^t",
        "1/3 v",
        "-(1/3) v/t^2",
        "sqrt(v)/t",
        "1/sqrt(v)",
        "v^1.5",
        "v^(2/3)",
        "(v + t)^-2",
        "a(v + t)/2",
        "sin(v)^2",
        "sin(v)^-1",
        "1e300 v",
        "1e-300 v",
        "0.1 v + 1/7 t",
        "e v",
        "e^2 v",
        "π^2 v",
        "π^v",
        "(v/t)^a",
        "-(v + t)",
        "1 - (v - t)",
        "(v - t)*(t - v)",
        "a - (-v)",
        "2(v + t)",
        "v*(2*t)^a",
        "exp(exp(v))",
        "e^e^v",
        "1e20 v",
        "10^(1e20) v",
        "10^-999 v",
        "123456789012345678901234567890 v",
        "1e-30 v + 1",
        "abs(-v)",
        "r_max v",
        "r_max^v",
        "α v",
        "(α v)^t",
        "3^-2 v",
        "2^0.5 v",
        "sqrt(2) v",
        "sqrt(sqrt(v))",
        "(v^2)^0.5",
        "cbrt(v)^2",
        "log10(v)^2",
        "0/v",
        "v/0",
    ] {
        for notation in [Notation::Ascii, Notation::Unicode, Notation::Latex] {
            reread(text, notation).unwrap_or_else(|failure| panic!("{failure}"));
        }
    }
}
