//! Texts that can be read in two ways are refused, and both ways are shown; texts that cannot are read.

use trimline::diagnostic::{Code, Diagnostics};
use trimline::expr::Notation;
use trimline::limits::Limits;

use crate::spec::{patch, problem_within, told, with_data};

const NAMES: &str = "param a = 2, b = 3, k = 4, n = 2\nlet f(x) = x^2, g = 3 v\nsurface A(u, v) = [u, v, 0]\n";

fn document(expression: &str) -> String {
    format!("{NAMES}{}", with_data(expression))
}

/// What an expression is to the graph, as text.
fn reading(expression: &str) -> Result<String, Diagnostics> {
    let problem = problem_within(&document(expression), &Limits::default())?;
    let value = patch(&problem).conditions[0].value[0];
    Ok(problem.graph.text(value, Notation::Ascii, 1 << 16).expect("short"))
}

fn read(expression: &str) -> String {
    reading(expression).unwrap_or_else(|found| panic!("{}", told(&document(expression), &found)))
}

fn refused(expression: &str) -> Diagnostics {
    match reading(expression) {
        Err(found) => found,
        Ok(text) => panic!("{expression} is read as {text}"),
    }
}

/// A text, what its finding says, and both readings.
const AMBIGUOUS: &[(&str, &str, [&str; 2])] = &[
    ("a/b(1+v)", "write `/(b*(…))` if it is, `/b*(…)` if it is not", ["a/(b*(1+v))", "a/b*(1+v)"]),
    ("a/v(1+t)^2", "part of the divisor", ["a/(v*(1+t)^2)", "a/v*(1+t)^2"]),
    ("a/n b(1+v)", "write `a/(n b(1+v))` or `(a/n)*b(1+v)`", ["a/(n b(1+v))", "(a/n)*b(1+v)"]),
    ("√a(1+v)", "write `√(a*(…))` if it is, `√a*(…)` if it is not", ["√(a*(1+v))", "√a*(1+v)"]),
    ("√v (1+t)", "below the root", ["√(v*(1+t))", "√v*(1+t)"]),
    ("√v²", "write `√(v²)` if it is, `(√v)²` if it is not", ["√(v²)", "(√v)²"]),
    ("√v^3", "write `√(v^3)`", ["√(v^3)", "(√v)^3"]),
    ("√(1+v)²", "write `√((1+v)²)` if it is, `(√(1+v))²`", ["√((1+v)²)", "(√(1+v))²"]),
    ("2^√v^3", "write `√(v^3)` if it is, `(√v)^3`", ["2^√(v^3)", "2^(√v)^3"]),
    ("√2v", "write `√(2*v)` or `√2*v`", ["√(2*v)", "√2*v"]),
    ("√2π v", "write `√(2*π)` or `√2*π`", ["√(2*π) v", "√2*π v"]),
    ("√2(1+v)", "write `√(2*(1+v))` or `√2*(1+v)`", ["√(2*(1+v))", "√2*(1+v)"]),
    ("sin 2*v", "write `sin(2*v)` if it does, `sin(2)*v` if it does not", ["sin(2*v)", "sin(2)*v"]),
    ("sin a·t", "does `t` belong to the argument?", ["sin(a·t)", "sin(a)·t"]),
    ("cos v * -t", "write `cos(v * -t)` if it does, `cos(v) * -t` if it does not", ["cos(v * -t)", "cos(v) * -t"]),
    ("sin^2 v × 3t", "write `sin^2(v × 3)`", ["sin^2(v × 3t)", "sin^2(v) × 3t"]),
    ("e^½v", "write `e^(½*v)` or `e^½*v`", ["e^(½*v)", "e^½*v"]),
    ("e^πv", "write `e^(π*v)` or `e^π*v`", ["e^(π*v)", "e^π*v"]),
    ("e^pi(v)", "write `e^(pi*(v))` or `e^pi*(v)`", ["e^(pi*(v))", "e^pi*(v)"]),
    ("e^2t", "write `e^(2*t)` or `e^2*t`", ["e^(2*t)", "e^2*t"]),
    ("e^-2(1-t)", "write `e^(-2*(1-t))` or `e^-2*(1-t)`", ["e^(-2*(1-t))", "e^-2*(1-t)"]),
    ("2^3t", "write `2^(3*t)` or `2^3*t`", ["2^(3*t)", "2^3*t"]),
    ("10^3v", "write `10^(3*v)` or `10^3*v`", ["10^(3*v)", "10^3*v"]),
    ("10^-3[1+v]", "or `10^-3*[1+v]`", ["10^(-3*[1+v])", "10^-3*[1+v]"]),
    ("2^k|v|", "write `2^(k*|v|)` or `2^k*|v|`", ["2^(k*|v|)", "2^k*|v|"]),
    ("2^k(v)", "write `^(k*(…))` if it is, `^k*(…)` if it is not", ["2^(k*(v))", "2^k*(v)"]),
    ("e^t(1+v)", "part of the exponent", ["e^(t*(1+v))", "e^t*(1+v)"]),
    ("e^-t(1+v)", "part of the exponent", ["e^(-t*(1+v))", "e^-t*(1+v)"]),
    ("v^n(1+t)²", "part of the exponent", ["v^(n*(1+t)²)", "v^n*(1+t)²"]),
    ("a(1-t)^k(1+t)", "part of the exponent", ["a(1-t)^(k*(1+t))", "a(1-t)^k*(1+t)"]),
    ("e^-k v", "write `e^(-k*v)` or `e^-k*v`", ["e^(-k*v)", "e^-k*v"]),
    ("2^n 3v", "write `2^(n*3)` or `2^n*3`", ["2^(n*3) v", "2^n*3v"]),
    ("e^-t/2", "write `e^(-t/2)` if it does, `(e^-t)/2` if it does not", ["e^(-t/2)", "(e^-t)/2"]),
    ("v^1/2", "write `v^(1/2)` if it does, `(v^1)/2`", ["v^(1/2)", "(v^1)/2"]),
    ("(1+v)^-1/2", "write `(1+v)^(-1/2)` if it does", ["(1+v)^(-1/2)", "((1+v)^-1)/2"]),
    ("sin e^2t", "write `e^(2*t)`", ["sin(e^(2t))", "sin(e^2*t)"]),
    ("sin a[1-t]", "write `sin(a[1-t])` if it does, `sin(a)*[1-t]`", ["sin(a[1-t])", "sin(a)*[1-t]"]),
    ("sin a² (1-t)", "write `sin(a² (1-t))` if it does, `sin(a²)*(1-t)`", ["sin(a² (1-t))", "sin(a²)*(1-t)"]),
    (r"$$\sin\frac{v}{2}\cdot t$$", "belong to the argument", [r"$$\sin(\frac{v}{2}\cdot t)$$", "sin(v/2)*t"]),
    (r"$$\sin{v}\cdot t$$", "belong to the argument", [r"$$\sin(v\cdot t)$$", "sin(v)*t"]),
    (r"$$\sin v \cdot t$$", "belong to the argument", [r"$$\sin(v \cdot t)$$", r"$$\sin(v) \cdot t$$"]),
    (r"$$e^2t$$", "write `e^(2*t)` or `e^2*t`", [r"$$e^{2t}$$", r"$$e^{2}t$$"]),
    (r"$$2^3v$$", "write `2^(3*v)` or `2^3*v`", [r"$$2^{3v}$$", r"$$2^{3}v$$"]),
    (r"$$10^3v$$", "write `10^(3*v)` or `10^3*v`", [r"$$10^{3v}$$", r"$$10^{3}v$$"]),
    (r"$$e^kv$$", "write `e^(k*v)` or `e^k*v`", [r"$$e^{kv}$$", r"$$e^k\,v$$"]),
    (r"$$a/b(1+v)$$", "part of the divisor", [r"$$a/(b(1+v))$$", r"$$\frac{a}{b}(1+v)$$"]),
];

#[test]
fn text_with_two_readings_is_refused_with_both() {
    let mut wrong = Vec::new();
    for (written, said, readings) in AMBIGUOUS {
        let found = match reading(written) {
            Err(found) => found,
            Ok(text) => {
                wrong.push(format!("{written} is read as {text}"));
                continue;
            }
        };
        let words = format!("{} {} {}", found[0].message, found[0].marker, found[0].hints.join(" "));
        if found[0].code != Code::AmbiguousExpression || !words.contains(said) {
            wrong.push(told(&document(written), &found));
        }
        match readings.map(reading) {
            [Ok(first), Ok(second)] if first != second => {}
            both => wrong.push(format!("{written}: {both:?}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// Texts that nobody misreads, and what they are.
const PLAIN: &[(&str, &str)] = &[
    ("2π v", "2*π*v"),
    ("2πv", "2*π*v"),
    ("a b v", "a*b*v"),
    ("sin 2v", "sin(2*v)"),
    ("e^{2t}", "e^(2*t)"),
    ("e^-t", "e^(-t)"),
    ("v²/2", "(v^2)/2"),
    ("v^2t", "v^2*t"),
    ("10³v", "1000*v"),
    ("e²t", "e^(2)*t"),
    ("e^2 t", "e^(2)*t"),
    ("e^{2}t", "e^(2)*t"),
    ("e^t (1 + v)", "e^(t)*(1 + v)"),
    ("e^-t sin v", "e^(-t)*sin(v)"),
    ("e^-t*v", "e^(-t)*v"),
    ("v^n t", "v^(n)*t"),
    ("2∗v ∙ t", "2*v*t"),
    ("e^-t f(v)", "e^(-t)*v^2"),
    ("v^2/2", "(v^2)/2"),
    ("v⁻²/2", "1/(2*v^2)"),
    ("e^-t (1 + v)", "e^(-t)*(1 + v)"),
    ("e^k (1 + v)²", "e^(k)*(1 + v)^2"),
    ("e^f(v)", "e^(v^2)"),
    ("e^-f(v)²", "e^(-(v^4))"),
    ("e^sin(v) t", "e^(sin(v))*t"),
    ("√2 v", "√(2)*v"),
    ("√f(v)", "√(v^2)"),
    ("√sin(v)", "sqrt(sin(v))"),
    ("√|v|t", "sqrt(abs(v))*t"),
    ("√√v", "sqrt(sqrt(v))"),
    ("√(v²)", "sqrt(v^2)"),
    ("sqrt(a(1+v))", "sqrt(a*(1+v))"),
    ("sqrt(v)²", "(sqrt(v))^2"),
    ("a/f(v)", "a/(v^2)"),
    ("a/A_x(v, t)", "a/v"),
    ("a/(b(1+v))", "a/(b*(1+v))"),
    ("b(1+v)/a", "(b*(1+v))/a"),
    ("sin v * cos t", "sin(v)*cos(t)"),
    ("sin 2v · cos(t)", "sin(2*v)*cos(t)"),
    ("2*sin v", "2*sin(v)"),
    ("sin 2π(v + 1)", "sin(2*π*(v + 1))"),
    ("sin ½(v + 1)", "sin((v + 1)/2)"),
    ("π(v)", "π*v"),
    ("pi(v)", "π*v"),
    ("pi (v)²", "π*v^2"),
    ("2pi(v + 1)", "2*π*(v + 1)"),
    ("sin pi(v)", "sin(π*v)"),
    ("sin π(v)", "sin(π*v)"),
    ("√pi v", "√(π)*v"),
    (r"$$\sin\frac{v}{2} \cdot \cos t$$", "sin(v/2)*cos(t)"),
    (r"$$\sin\frac{v}{2} \times \operatorname{arsinh} t$$", "sin(v/2)*asinh(t)"),
    (r"$$e^{-k} v + e^k\, v + e^t/2$$", "e^(-k)*v + e^(k)*v + 0.5*e^t"),
    (r"$$e^t(1 + v)$$", "e^(t)*(1 + v)"),
    (r"$$e^k\left(1 + v\right)^2$$", "e^(k)*(1 + v)^2"),
    (r"$$\sqrt{v}^2 + \sqrt{1 + v}^{2}$$", "(sqrt(v))^2 + (sqrt(1 + v))^2"),
    (r"$$\sqrt{a}(1 + v)$$", "sqrt(a)*(1 + v)"),
    (r"$$\sqrt{2}v$$", "sqrt(2)*v"),
    (r"$$v^2t$$", "v^2*t"),
];

#[test]
fn text_with_one_reading_is_read() {
    let mut wrong = Vec::new();
    for (written, meaning) in PLAIN {
        match reading(written) {
            Ok(found) if found == read(meaning) => {}
            Ok(found) => wrong.push(format!("{written} is {found}, not {}", read(meaning))),
            Err(found) => wrong.push(told(&document(written), &found)),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn functions_that_stand_as_none_may_are_answered_with_what_to_write() {
    for (written, said) in [
        ("sin^a v", "the power behind `sin` is not a whole number"),
        ("sin^a v", "`sin(…)^(…)`"),
        ("sin^{2v} v", "the power behind `sin` is not a whole number"),
        ("sin^2.5 v", "`sin(…)^(…)`"),
        (r"$$\sin^n v$$", "the power behind `sin` is not a whole number"),
        (r"$$\sin^{2v} v$$", "the power behind `sin` is not a whole number"),
        ("√sin v", "write `√sin(…)`"),
        ("e^sin v", "write `^sin(…)`"),
        ("e^-cos v", "write `^cos(…)`"),
        ("log_2 v", "write `ln(…)/ln(2)`"),
        ("sech v", "write `1/cosh(…)`"),
        ("sgn(v)", "write `sign(…)`"),
        ("sin[v]", "write `sin(…)`"),
        ("exp{-v}", "write `exp(…)`"),
        ("∛v", "write `cbrt(…)`"),
        ("e⁻ᵗ", "write `^`"),
        ("⅓v", "write `1/3`"),
        ("log_a(v)", "`ln(…)/ln(a)`"),
        ("log_10(v)", "`log10(…)`"),
        ("f'(v)", "takes no derivative of `f`: write the derivative out"),
        ("g' + 1", "takes no derivative of `g`"),
    ] {
        let found = refused(written);
        let words = format!("{} {}", found[0].message, found[0].hints.join(" "));
        assert!(words.contains(said), "{}", told(&document(written), &found));
    }
}
