//! What the language accepts, and what it means.

use trimline::diagnostic::Source;
use trimline::expr::{Derivative, ExprId, Notation};
use trimline::limits::Limits;
use trimline::numeric::NodeKind;
use trimline::problem::{Bindings, ParameterKind, Problem};
use trimline::resolve::set_parameter;

use crate::spec::{BOUNDARY, Prepared, at, decomposition, patch, problem, with_data};

const NAMES: &str = "param a1 = 1, a2 = 2, b1 = 3, b2 = 0.5, h0 = 2, k = 4, alpha = 0.3, r_max = 2\n";

/// `expression` as boundary data in a document with [`NAMES`] and `lets`.
fn read_with(lets: &str, expression: &str) -> (Problem, ExprId) {
    let problem = problem(&format!("{NAMES}{lets}\n{}", with_data(expression)));
    let value = patch(&problem).conditions[0].value[0];
    (problem, value)
}

/// The ASCII text of an expression as the graph holds it.
fn read(expression: &str) -> String {
    let (problem, value) = read_with("", expression);
    problem.graph.text(value, Notation::Ascii, 1 << 16).expect("short")
}

/// Both are one expression.
fn same(left: &str, right: &str) {
    let text = format!("{NAMES}at u = 0: S = [{left}, {right}, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let problem = problem(&text);
    let value = patch(&problem).conditions[0].value;
    let text = |id| problem.graph.text(id, Notation::Ascii, 1 << 16).expect("short");
    assert_eq!(value[0], value[1], "{left} is {}, {right} is {}", text(value[0]), text(value[1]));
}

#[test]
fn line_of_the_users_request_is_accepted_as_it_stands() {
    let text = "param a1 = 1, a2 = 2, b1 = 3
at u = 0:
    S_x = (1-t)*b1*sinh(a1*v+a2)
    S_y = 0, S_z = 0, dS/du = 0
at u = 1: S = 0, dS/du = 0";
    let decomposition = decomposition(text);
    assert_eq!(decomposition.basis.len(), 2);
    let problem = problem(text);
    let found = problem.graph.value(
        patch(&problem).conditions[0].value[0],
        Bindings::evaluate(&problem).expect("finite").as_slice(),
        [f64::NAN, 0.5, 0.25],
    );
    assert!((found - 0.75 * 3.0 * 2.5_f64.sinh()).abs() < 1e-13, "{found}");
}

#[test]
fn ascii_and_unicode_spellings_give_equal_bytes() {
    let unicode = "param α = 0.5, b₁ = 2
domain v in [0, 2π], t in [0, 1]
pde β ∂⁴S/∂u⁴ + γ ∂⁴S/∂u²∂v² + λ ∂⁴S/∂v⁴ + ρ ∂²S/∂t² + η ∂S/∂t = 0
    with β = 1, γ = 12.1, λ = 1, ρ = 1, η = 1
at u = 0:
    S_x = √(1 + v²)·b₁ − 3×t÷2
    S_y = α³ cos(−v)
    S_z = 0
    ∂S/∂u = [0, 0, 1]
at u = 1: S = 0, ∂S/∂u = 0";
    let ascii = "param alpha = 0.5, b_1 = 2
domain v in [0, 2*pi], t in [0, 1]
pde beta*d4S/du4 + gamma*d4S/du2dv2 + lambda*d4S/dv4 + rho*d2S/dt2 + eta*dS/dt = 0
    with beta = 1, gamma = 12.1, lambda = 1, rho = 1, eta = 1
at u = 0:
    S_x = sqrt(1 + v^2)*b_{1} - 3*t/2
    S_y = alpha**3*cos(-v)
    S_z = 0
    dS/du = [0, 0, 1]
at u = 1: S = 0, dS/du = 0";
    let text = |text: &str| decomposition(text).to_text(Notation::Unicode, &Limits::default()).expect("short");
    assert_eq!(text(unicode), text(ascii));
    assert_eq!(problem(unicode).patches[0].operator.terms, problem(ascii).patches[0].operator.terms);
}

#[test]
fn every_listed_function_is_accepted_with_its_value() {
    type Value = fn(f64) -> f64;
    let listed: [(&str, Value); 24] = [
        ("sin", f64::sin),
        ("cos", f64::cos),
        ("tan", f64::tan),
        ("cot", |x| 1.0 / x.tan()),
        ("sec", |x| 1.0 / x.cos()),
        ("csc", |x| 1.0 / x.sin()),
        ("asin", f64::asin),
        ("acos", f64::acos),
        ("atan", f64::atan),
        ("sinh", f64::sinh),
        ("cosh", f64::cosh),
        ("tanh", f64::tanh),
        ("asinh", f64::asinh),
        ("atanh", f64::atanh),
        ("exp", f64::exp),
        ("ln", f64::ln),
        ("log", f64::ln),
        ("log10", f64::log10),
        ("sqrt", f64::sqrt),
        ("cbrt", f64::cbrt),
        ("abs", f64::abs),
        ("sign", f64::signum),
        ("floor", f64::floor),
        ("arctan", f64::atan),
    ];
    for (name, expected) in listed {
        let (problem, value) = read_with("", &format!("{name}(v)"));
        let found = problem.graph.value(value, &[], [f64::NAN, 0.4, 0.0]);
        // Two libraries of functions, each within a rounding or two.
        assert!((found - expected(0.4)).abs() < 1e-14, "{name}: {found}");
    }
    for (call, expected) in [
        ("acosh(v + 1)", 1.4_f64.acosh()),
        ("atan2(v, -1)", 0.4_f64.atan2(-1.0)),
        ("min(v, t)", 0.2),
        ("max(v, t)", 0.4),
    ] {
        let (problem, value) = read_with("", call);
        assert!((problem.graph.value(value, &[], [f64::NAN, 0.4, 0.2]) - expected).abs() < 1e-14, "{call}");
    }
}

#[test]
fn factors_side_by_side_are_multiplied() {
    same("2t", "2*t");
    same("0.8(1-t)b2 sin(a1 v)", "0.8*(1-t)*b2*sin(a1*v)");
    same("h0(1 - t)", "h0*(1 - t)");
    same("(1 − t)[b_1 sinh(a_1 v + a_2) + b_2 sin(k v)]", "(1-t)*(b1*sinh(a1*v+a2)+b2*sin(k*v))");
    same("2π v", "2*pi*v");
    same("πt", "pi*t");
    same("v t", "t*v");
    same("a1 b1/b2", "a1*b1/b2");
}

#[test]
fn bare_argument_extends_to_the_next_operator_or_function() {
    same("sin 5v", "sin(5*v)");
    same("sin v cos v", "sin(v)*cos(v)");
    same("2 sin a1 v + 1", "2*sin(a1*v) + 1");
    same("sin v^2", "sin(v^2)");
    same("sin^2 v", "sin(v)^2");
    same("sin² v", "sin(v)^2");
    same("sin^{2} v", "sin(v)^2");
    same("2sin^{2}(v) + e^{-t}", "2*sin(v)^2 + e^(-t)");
    same("sin^2(v) cos v", "sin(v)*sin(v)*cos(v)");
    same("√2 v", "sqrt(2)*v");
}

#[test]
fn bars_are_absolute_values_where_only_one_reading_is_possible() {
    same("|v|", "abs(v)");
    same("2|v - 1|t", "2*abs(v - 1)*t");
    same("|v||t|", "abs(v)*abs(t)");
    same("||v| - 1|", "abs(abs(v) - 1)");
    same("|v - |t||", "abs(v - abs(t))");
    same("sin |v| + |t|^2", "sin(abs(v)) + abs(t)^2");
    same("(|v| + 1)(|t| + 2)", "(abs(v) + 1)*(abs(t) + 2)");
}

#[test]
fn braces_are_brackets_in_exponents() {
    same("e^{-t}", "e^(-t)");
    same("v^{2}", "v^2");
    same("v**{2 k}", "v^(2*k)");
    same("b_{1}^{k + 1}", "b1^(k + 1)");
}

#[test]
fn vulgar_fractions_are_numbers() {
    same("½ v", "0.5*v");
    same("¼(v + ¾)", "0.25*(v + 0.75)");
    same("v^½", "sqrt(v)");
}

#[test]
fn domain_and_range_may_be_written_with_the_sign_of_an_element() {
    let spec = |word: &str| format!("param a = 1 {word} [0, 2]\ndomain v {word} [0, 3]\n{BOUNDARY}");
    let ends = |text: &str| {
        let problem = problem(text);
        let texts = |[low, high]: [ExprId; 2]| [low, high].map(|id| problem.graph.text(id, Notation::Ascii, 99));
        (texts(problem.parameters[0].interval.expect("a range")), texts(patch(&problem).domain.ends[1]))
    };
    assert_eq!(ends(&spec("∈")), ends(&spec("in")));
}

#[test]
fn powers_bind_tighter_than_a_minus_and_from_the_right() {
    same("-v^2", "-(v^2)");
    same("e^-t", "exp(-t)");
    same("e^−t", "exp(-t)");
    same("2^v^t", "2^(v^t)");
    same("v**2", "v*v");
    same("2 v^2", "2*(v^2)");
    same("v^-2", "1/v^2");
    same("-v^-t", "-(v^(-t))");
    same("v⁻²", "1/v^2");
    same("v^2^3", "v^8");
    same("1 - 2 - 3 v", "-1 - 3*v");
    same("v/t/k", "v/(t*k)");
    same("v/t*k", "v*k/t");
    same("1 - -v", "1 + v");
}

#[test]
fn parameter_before_a_bracket_is_a_factor_of_its_power() {
    same("h0(1-t)^2", "h0*(1-t)^2");
    same("v(1-t)²", "v*(1-t)^2");
}

#[test]
fn names_are_one_in_every_spelling() {
    same("b_1 + b₁ + b_{1}", "3 b1");
    same("α", "alpha");
    same("r_max", "r_{max}");
}

#[test]
fn definitions_are_expanded_where_they_are_used() {
    let lets = "let s = sin(πt/2), f(x) = x^2 + k\nlet g(x, y) = x*f(y) - s";
    let (problem, value) = read_with(lets, "g(v, 2t) + s");
    let found = problem.graph.text(value, Notation::Ascii, 1 << 12).expect("short");
    let (expected, value) = read_with("", "v*((2t)^2 + k)");
    assert_eq!(found, expected.graph.text(value, Notation::Ascii, 1 << 12).expect("short"));
}

#[test]
fn argument_of_a_definition_is_its_own_name() {
    let (problem, value) = read_with("let f(x) = x + 1, g(x) = f(2 x)", "g(v)");
    assert_eq!(problem.graph.text(value, Notation::Ascii, 99).expect("short"), "1 + 2*v");
}

#[test]
fn definition_may_be_a_vector() {
    let text = "let ring = [cos v, sin v, 0]\nat u = 0: S = 2 ring, dS/du = 0\nat u = 1: S = -ring, dS/du = 0";
    let problem = problem(text);
    let value = patch(&problem).conditions[0].value;
    let texts = value.map(|id| problem.graph.text(id, Notation::Ascii, 99).expect("short"));
    assert_eq!(texts, ["2*cos(v)", "2*sin(v)", "0"]);
}

#[test]
fn lines_continue_at_operators_commas_and_brackets() {
    let one_line = format!("{NAMES}at u = 0: S = [a1 v + b1, a2, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let many = format!(
        "# a comment\n{NAMES}\n\nat u = 0:   # first\n  S = [  # a vector\n a1 v   # of\n  + b1,\n a2,\n\n 0 # three\n ],\n\
         \n  dS/du\n   = 0\nat u = 1:\r\n S = 0,\r\n dS/du = 0\r\n# the end"
    );
    let text = |text: &str| decomposition(text).to_text(Notation::Ascii, &Limits::default()).expect("short");
    assert_eq!(text(&one_line), text(&many));
    let trailing = format!("{NAMES}at u = 0: S = [a1 v +\n b1, a2, 0]; dS/du =\n 0;\nat u = 1: S = 0, dS/du = 0,");
    assert_eq!(text(&one_line), text(&trailing));
}

#[test]
fn several_blocks_for_one_edge_add_up() {
    let split =
        "at u = 0: S_x = v\nat u = 1: S = 0\nat u = 0: S_y = t, S_z = 1\nat u = 1: dS/du = 0\nat u = 0: dS/du = 0";
    let conditions = patch(&problem(split)).conditions.clone();
    let orders: Vec<usize> = conditions.iter().map(|condition| condition.order).collect();
    assert_eq!(orders, [0, 1, 0, 1]);
}

#[test]
fn components_have_several_spellings() {
    let spellings = [
        "S_x = v, S_y = t, S_z = 1, dS_x/du = 0, dS_y/du = 0, dS_z/du = 0",
        "x = v, y = t, z = 1, dx/du = 0, dy/du = 0, dz/du = 0",
        "x_1 = v, x_2 = t, x_3 = 1, ∂x_1/∂u = 0, ∂x_2/∂u = 0, ∂x_3/∂u = 0",
        "S_x(u, v, t) = v, S_y(u,v,t) = t, S_z(u, v) = 1, ∂S_x(u, v, t)/∂u = 0, ∂S_y/∂u = 0, ∂S_z(u,v,t)/∂u = 0",
        "S = [v, t, 1], ∂S/∂u = [0, 0, 0]",
        "S(u, v, t) = [v, t, 1], ∂S(u, v, t)/∂u = 0",
        "S_{x} = v, S_{y} = t, x₃ = 1, ∂S/∂u = 0",
    ];
    let text = |constraints: &str| {
        let spec = format!("at u = 0: {constraints}\nat u = 1: S = 0, dS/du = 0");
        decomposition(&spec).to_text(Notation::Ascii, &Limits::default()).expect("short")
    };
    for spelling in spellings {
        assert_eq!(text(spelling), text(spellings[0]), "{spelling}");
    }
}

#[test]
fn order_in_u_fixes_the_number_of_constraints() {
    let second = "pde d2S/du2 + d2S/dv2 = 0\nat u = 0: S = [cos v, sin v, 0]\nat u = 1: S = [cos v, sin v, 1]";
    assert_eq!(patch(&problem(second)).conditions.len(), 2);
    let sixth = "pde ∂⁶S/∂u⁶ + ∂⁶S/∂v⁶ = 0
at u = 0: S = [cos v, sin v, 0], ∂S/∂u = [0, 0, 1], ∂²S/∂u² = 0
at u = 1: S = [cos v, sin v, 1], ∂S/∂u = [0, 0, 1], d2S/du2 = 0";
    assert_eq!(patch(&problem(sixth)).conditions.len(), 6);
    let four_positions =
        "at u = 0: S = [v, 0, 0]\nat u = 1/3: S = [v, 0, 1]\nat u = 2/3: S = [v, 1, 1]\nat u = 1: S = 0";
    assert_eq!(patch(&problem(four_positions)).conditions.len(), 4);
    for text in [second, sixth, four_positions] {
        let surface = Prepared::new(text, &[]).solve(0.3).surface;
        let start = at(&*surface, "", [0.0, 1.0, 0.3]);
        let expected = if text == four_positions { 1.0 } else { 1.0_f64.cos() };
        assert!((start[0] - expected).abs() < 1e-12, "{start:?}");
    }
}

fn terms_of(text: &str) -> Vec<(Derivative, [String; 3])> {
    let problem = problem(text);
    let text = |id| problem.graph.text(id, Notation::Ascii, 999).expect("short");
    patch(&problem).operator.terms.iter().map(|term| (term.derivative, term.coefficient.map(text))).collect()
}

fn term(u: usize, v: usize, t: usize, each: [&str; 3]) -> (Derivative, [String; 3]) {
    (Derivative::new(u, v, t), each.map(str::to_owned))
}

#[test]
fn equation_may_have_odd_mixed_and_plain_terms_with_vector_coefficients() {
    let text = format!(
        "param a = 2\npde [1, 2, a] ∂⁴S/∂u⁴ + a ∂³S/∂u∂v∂t - 3 S = 2 dS/dv + (1 + v) ∂⁴S/∂u⁴ + [0, 0, t]\n{BOUNDARY}"
    );
    let expected = [
        term(4, 0, 0, ["-v", "1 - v", "-1 + a - v"]),
        term(1, 1, 1, ["a", "a", "a"]),
        term(0, 1, 0, ["-2", "-2", "-2"]),
        term(0, 0, 0, ["-3", "-3", "-3"]),
    ];
    let found = terms_of(&text);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for ((derivative, found), (expected_derivative, expected)) in found.iter().zip(&expected) {
        assert_eq!(derivative, expected_derivative);
        for (found, expected) in found.iter().zip(expected) {
            let spec = format!("param a = 2\n{}", with_data(&format!("({found}) - ({expected})")));
            assert!(decomposition(&spec).basis.is_empty(), "{derivative}: {found}, not {expected}");
        }
    }
    let problem = problem(&text);
    let force = patch(&problem).operator.force.map(|id| problem.graph.text(id, Notation::Ascii, 99).expect("short"));
    assert_eq!(force, ["0", "0", "t"]);
}

#[test]
fn terms_of_one_derivative_add_up_and_may_cancel() {
    let text = format!("pde d4S/du4 + 2 d4S/dv4 + d4S/du4 = 2 d4S/dv4\n{BOUNDARY}");
    assert_eq!(terms_of(&text), [term(4, 0, 0, ["2", "2", "2"])]);
}

#[test]
fn default_equation_is_biharmonic_with_coefficients_that_can_be_set() {
    let values = |text: &str| {
        let problem = problem(text);
        let bindings = Bindings::evaluate(&problem).expect("finite");
        ["beta", "gamma", "lambda", "rho", "eta"].map(|name| {
            let parameter = problem.parameters.iter().find(|parameter| parameter.name == name).expect("a coefficient");
            assert_eq!(parameter.kind, ParameterKind::Coefficient);
            bindings.as_slice()[parameter.symbol.index()]
        })
    };
    assert_eq!(values(BOUNDARY), [1.0, 2.0, 1.0, 0.0, 0.0]);
    assert_eq!(values(&format!("pde with γ = 14\n{BOUNDARY}")), [1.0, 14.0, 1.0, 0.0, 0.0]);
    assert_eq!(
        values(&format!("param k = 3\npde with gamma = k^2, eta = gamma/2\n{BOUNDARY}")),
        [1.0, 9.0, 1.0, 0.0, 4.5]
    );
}

#[test]
fn coefficient_of_the_equation_may_depend_on_v_and_t() {
    let text = format!("pde with γ = 2 + cos v, ρ = t\n{BOUNDARY}");
    let solution = Prepared::new(&text, &[]).solve(0.5);
    assert!((at(&*solution.surface, "", [1.0, 0.0, 0.5])[2] - 1.0).abs() < 1e-12);
}

#[test]
fn coefficient_of_the_default_equation_may_be_a_vector() {
    let text = format!("param a = 3\npde with γ = [1, 2, a]\n{BOUNDARY}");
    let terms = terms_of(&text);
    let mixed = terms.iter().find(|(derivative, _)| *derivative == Derivative::new(2, 2, 0)).expect("a term");
    assert_eq!(*mixed, term(2, 2, 0, ["1", "2", "a"]));
}

#[test]
fn numbers_at_the_edge_of_128_bits_are_read_and_solved() {
    for number in ["(-2^126 - 2^126)", "(-2*2^126)", "1/(-2^126 - 2^126)", "(2^126 + 2^126)"] {
        let surface = Prepared::new(&with_data(&format!("v*{number} + t")), &[]).solve(0.5).surface;
        assert!(at(&*surface, "", [0.0, 1.0, 0.5])[0].is_finite(), "{number}");
    }
}

#[test]
fn domains_are_constant_expressions_with_defaults() {
    let evaluate = |text: &str| {
        let problem = problem(text);
        let bindings = Bindings::evaluate(&problem).expect("finite");
        patch(&problem).domain.evaluate(&problem, &bindings).expect("not empty")
    };
    let default = evaluate(BOUNDARY);
    assert_eq!((default.u, default.v, default.t), ([0.0, 1.0], [0.0, std::f64::consts::TAU], [0.0, 1.0]));
    let stated =
        evaluate(&format!("param k = 3\ndomain u in [-1, k], v in [0, k π]\ndomain t in [-k, 2^k]\n{BOUNDARY}"));
    assert_eq!((stated.u, stated.v, stated.t), ([-1.0, 3.0], [0.0, 3.0 * std::f64::consts::PI], [-3.0, 8.0]));
}

#[test]
fn parameters_have_ranges_and_use_earlier_ones() {
    let problem = problem(&format!("param h0 = 2, h1 = -3 in [-2 h0, h0']\n{BOUNDARY}").replace("h0'", "h0"));
    let parameter = problem.parameters.iter().find(|parameter| parameter.name == "h1").expect("a param");
    let bindings = Bindings::evaluate(&problem).expect("finite");
    let ends = parameter.interval.expect("a range").map(|end| problem.graph.value(end, bindings.as_slice(), [0.0; 3]));
    assert_eq!(ends, [-4.0, 2.0]);
}

#[test]
fn set_parameter_changes_values_that_follow_from_it() {
    let mut problem = problem(&format!("param a = 1 in [0, 2], b = 2 a\npde with γ = b\n{BOUNDARY}"));
    let value = |problem: &Problem, name: &str| {
        let parameter = problem.parameters.iter().find(|parameter| parameter.name == name).expect("a param");
        Bindings::evaluate(problem).expect("finite").as_slice()[parameter.symbol.index()]
    };
    let limits = Limits::default();
    // Outside the range, which is for sliders only.
    set_parameter(&mut problem, "a", &Source::new("--set", "3 + 1"), &limits).expect("an expression");
    assert_eq!((value(&problem, "a"), value(&problem, "b"), value(&problem, "gamma")), (4.0, 8.0, 8.0));
    set_parameter(&mut problem, "γ", &Source::new("--set", "a*10"), &limits).expect("an expression");
    assert_eq!((value(&problem, "b"), value(&problem, "gamma")), (8.0, 40.0));
    let found = set_parameter(&mut problem, "a", &Source::new("--set", "b"), &limits).expect_err("a later param");
    assert_eq!(found[0].code.as_str(), "E0201");
}

#[test]
fn settings_of_the_method_are_read_with_their_kinds_of_nodes() {
    for (text, expected) in [
        ("solve sine, terms = 5, points = 11 x 12", (11, 12, NodeKind::Midpoints)),
        ("solve sine, points = 11×12:ends, terms = 5", (11, 12, NodeKind::Ends)),
        ("solve auto, terms = 5,\n points = 11 x 12 : gauss", (11, 12, NodeKind::Gauss)),
    ] {
        let problem = problem(&format!("{BOUNDARY}{text}"));
        let settings = trimline::method::Settings::read(&patch(&problem).solve.settings).expect("settings");
        let size = settings.points.expect("points").0;
        assert_eq!((size.u, size.v, size.kind), expected, "{text}");
        assert_eq!(settings.terms.map(|(terms, _)| terms.first), Some(5), "{text}");
    }
}

#[test]
fn numbers_are_exact_until_they_leave_128_bits() {
    assert_eq!(read("0.1 + 0.2"), "0.3");
    assert_eq!(read("1/3 + 1/6"), "0.5");
    same("1e3", "1000");
    same(".5", "1/2");
    same("1.", "1");
}

/// The terms of `pde equation`.
fn equation_terms(equation: &str) -> Vec<(Derivative, [String; 3])> {
    terms_of(&format!("pde {equation}\n{BOUNDARY}"))
}

#[test]
fn unknown_with_its_plain_coordinates_is_the_unknown() {
    let expected = equation_terms("(∂²/∂u² + ∂²/∂v²)² S = 0");
    for written in ["S(u, v)", "S(u, v, t)", "S (u, v)"] {
        assert_eq!(equation_terms(&format!("(∂²/∂u² + ∂²/∂v²)² {written} = 0")), expected, "{written}");
    }
    assert_eq!(equation_terms("∂⁴S/∂u⁴ + 3 S(u, v) = 0"), equation_terms("∂⁴S/∂u⁴ + 3 S = 0"));
}

#[test]
fn bold_zero_is_zero() {
    assert_eq!(equation_terms("∂⁴S/∂u⁴ + S = 𝟎"), equation_terms("∂⁴S/∂u⁴ + S = 0"));
}
