//! Curves through measured points in boundary data: their values, their derivatives, and what is said of bad files.

use std::f64::consts::TAU;
use std::sync::Arc;

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostics, Source};
use trimline::eval::{Backend, Evaluator, Program, Samples, compile};
use trimline::expr::{Derivative, Graph, Knots, Notation, Spline, SplineCall, Variable};
use trimline::method::{Options, Solution};

use crate::spec::at;

/// A ring at unevenly spaced points, as a file.
fn ring(count: usize) -> String {
    circle(count, 2.0, 0.4)
}

/// A circle at points whose distances differ by a factor of (1 + s)/(1 - s).
fn circle(count: usize, radius: f64, s: f64) -> String {
    let row = |index: usize| {
        let v = TAU * index as f64 / count as f64;
        let v = v + s * libm::sin(v);
        format!("{:?},{:?},{:?}\n", radius * libm::cos(v), radius * libm::sin(v), 0.5)
    };
    (0..count).map(row).collect()
}

const ENDS: &str = "at u = 1: S = [cos v, sin v, 2], ∂S/∂u = [0, 0, 1]\n";

fn compiled(text: &str, data: &str, method: &str) -> Result<Blend, Diagnostics> {
    let options = Options { method: Some(method.to_owned()), ..Options::default() };
    let read = |path: &str| match path {
        "ring.csv" => Ok(data.as_bytes().to_vec()),
        _ => Err("there is none".to_owned()),
    };
    Blend::compile_with(&Source::new("spec", text), read, &options)
}

fn solved(text: &str, data: &str, method: &str) -> Solution {
    let blend = compiled(text, data, method).unwrap_or_else(|found| panic!("{text}\n{found:?}"));
    blend.solve(0, 0.0).unwrap_or_else(|found| panic!("{text}\n{found}"))
}

fn measured(data: &str) -> String {
    format!("curve C = points(\"ring.csv\")\nat u = 0: S = {data}, ∂S/∂u = [0, 0, 1]\n{ENDS}")
}

fn refusal(data: &str) -> String {
    let found = compiled(&measured("C(v)"), data, "fourier").err().expect("no curve");
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].span.map(|span| (span.start, span.end)), Some((17, 27)), "{found:?}");
    format!("{} {}", found[0].code, found[0].message)
}

#[test]
fn surface_on_measured_points_is_that_on_the_curve_they_lie_on() {
    let closed_form = format!("at u = 0: S = [2 cos v, 2 sin v, 0.5], ∂S/∂u = [0, 0, 1]\n{ENDS}");
    // The spline is within 1e-9 of the circle, its slope within 1e-7, which a series in v passes on; a fit of the
    // equation takes its fourth derivative, within 1e-3, into a surface within a thousandth of that.
    for (method, tolerance) in [("fourier", 2e-7), ("legendre", 1e-6)] {
        let exact = solved(&closed_form, "", "exact");
        let found = solved(&measured("C(v)"), &ring(128), method);
        for (u, v) in [(0.0, 0.3), (0.25, 1.0), (0.5, 2.5), (0.75, 4.0), (1.0, 6.2)] {
            for letters in ["", "u", "v"] {
                let pair = [&exact, &found].map(|solution| at(&*solution.surface, letters, [u, v, 0.0]));
                for (a, b) in pair[0].iter().zip(pair[1]) {
                    assert!((a - b).abs() < tolerance, "{method} {letters} at {u}, {v}: {pair:?}");
                }
            }
        }
    }
}

/// The figures of docs/methods.md, rounded up.
#[test]
fn points_of_a_circle_give_the_circle_to_sixth_order() {
    for (count, bound) in [(32, 4.5e-8), (64, 6.8e-10), (128, 1.1e-11)] {
        let surface = solved(&measured("C(v)"), &circle(count, 1.0, 0.5), "fourier").surface;
        let miss = |index: u32| {
            let v = f64::from(index) * TAU / 1000.0;
            let [x, y, _] = at(&*surface, "", [0.0, v, 0.0]);
            libm::hypot(x - libm::cos(v), y - libm::sin(v))
        };
        let most = (0..1000).map(miss).fold(0.0, f64::max);
        assert!(most <= bound && most > bound / 2.0, "{count} points: {most:e}");
    }
}

#[test]
fn curve_stands_in_expressions_with_components_derivatives_and_any_argument() {
    let data = ring(128);
    let text = measured("C(v + 0.5) + [0, C_x(2v), ∂C_y(v)/∂v - ∂²C_x(-v)/∂v²]");
    let found = at(&*solved(&text, &data, "fourier").surface, "", [0.0, 0.7, 0.0]);
    let (sin, cos) = (libm::sin, libm::cos);
    let expected = [2.0 * cos(1.2), 2.0 * sin(1.2) + 2.0 * cos(1.4), 0.5 + 2.0 * cos(0.7) + 2.0 * cos(-0.7)];
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-5, "{found} {expected}");
    }
}

#[test]
fn exact_says_that_a_measured_curve_has_no_finite_closure() {
    let found = compiled(&measured("C(v)"), &ring(12), "exact").err().expect("refused");
    assert_eq!(found[0].code, Code::UnsupportedByMethod);
    assert!(found[0].message.contains("`C_x(v)` has no finite closure"), "{found:?}");
    let auto = compiled(&measured("C(v)"), &ring(12), "auto").expect("another method");
    assert_eq!(auto.solve(0, 0.0).expect("solved").report.method, "fourier");
}

#[test]
fn derivative_above_the_fourth_is_refused_and_the_series_needs_none() {
    let sixth = "pde d6S/du6 + d6S/dv6 = 0\ncurve C = points(\"ring.csv\")\n\
        at u = 0: S = C(v), dS/du = 0, d2S/du2 = 0\nat u = 1: S = [cos v, sin v, 1], dS/du = 0, d2S/du2 = 0\n";
    let blend = compiled(sixth, &ring(12), "legendre").map(|blend| blend.solve(0, 0.0).err());
    let found = match blend {
        Err(found) => found[0].clone(),
        Ok(found) => found.expect("refused"),
    };
    assert_eq!(found.code, Code::NotDifferentiable);
    assert!(found.message.contains("`C_x` is made of polynomials that fit together up to derivative 4"), "{found}");
}

#[test]
fn text_of_a_curve_and_its_derivatives_reads_back_as_the_same_expression() {
    let data = ring(12);
    for notation in [Notation::Ascii, Notation::Unicode, Notation::Latex] {
        let text = measured("[C_x(v), 2 t ∂²C_y(2v + 1)/∂v² + (∂C_x(v)/∂v)², 3/C_z(v)²]");
        let first = compiled(&text, &data, "fourier").expect("a problem").problem;
        let written = first.patches[0].conditions[0].value.map(|value| {
            let text = first.graph.text(value, notation, 1 << 12).expect("short");
            if notation == Notation::Latex { format!("$${text}$$") } else { text }
        });
        let again = measured(&format!("[{}]", written.join(", ")));
        let second = compiled(&again, &data, "fourier").unwrap_or_else(|found| panic!("{again}\n{found:?}")).problem;
        let texts = [&first, &second].map(|problem| {
            problem.patches[0].conditions[0].value.map(|id| problem.graph.text(id, Notation::Ascii, 1 << 12))
        });
        assert_eq!(texts[0], texts[1], "{again}");
    }
}

#[test]
fn faults_of_a_data_file_name_its_row_and_column() {
    assert_eq!(refusal("1,2,3\n1,2\n"), "E0222 ring.csv: row 2 has no column z: it has 2 columns where 3 are expected");
    assert_eq!(refusal("x,y,z\n1,inf,3\n"), "E0222 ring.csv: row 2, column y: `inf` is not a finite number");
    assert_eq!(refusal("1,2,3\n"), "E0222 ring.csv: a closed curve needs 6 points or more, found 1");
    assert_eq!(refusal("0,0,0\n1,0,0\n1,0,0\n"), "E0222 ring.csv: rows 2 and 3 hold the same point");
    assert_eq!(refusal(""), "E0222 ring.csv: it holds no points");
    let found = compiled("curve C = points(\"other.csv\")\n", "", "auto").err().expect("no file");
    assert_eq!(found[0].to_string(), "error[E0221]: the data file `other.csv` cannot be read: there is none");
}

#[test]
fn last_point_that_repeats_the_first_closes_the_curve() {
    let open = ring(24);
    let first = open.lines().next().expect("a row").to_owned();
    let text = measured("C(v)");
    let [a, b] = [open.clone(), format!("{open}{first}\n")]
        .map(|data| at(&*solved(&text, &data, "fourier").surface, "", [0.3, 1.0, 0.0]));
    assert_eq!(a, b);
}

/// A surface of two arguments with kinks in neither, periodic in the second.
fn tensor() -> SplineCall {
    let u = Knots { degree: 3, knots: vec![0.0, 0.0, 0.0, 0.0, 0.4, 1.0, 1.0, 1.0, 1.0], seam: None };
    let v = Knots { degree: 2, knots: (-2..=7).map(f64::from).collect(), seam: Some(1) };
    let controls: Vec<f64> = (0..5 * 7).map(|k| libm::sin(f64::from(k / 7) + f64::from(k % 7 % 5))).collect();
    SplineCall::new(Arc::new(Spline::new("P", &[("u", u), ("v", v)], &controls).expect("well formed")))
}

#[test]
fn both_evaluators_give_the_same_bits_for_splines_and_their_derivatives() {
    let mut graph = Graph::new();
    let [u, v, t] = Variable::ALL.map(|variable| graph.variable(variable));
    let surface = graph.spline(tensor(), &[u, v]);
    let product = graph.product([surface, t]);
    let slope = graph.derivative(product, Derivative::new(1, 1, 0)).expect("smooth");
    let outputs = [surface, product, slope];
    let mut evaluators = Vec::new();
    for backend in [Backend::Interpreter, Backend::Auto] {
        evaluators.push(compile(Program::compile(&graph, &outputs), backend).0);
    }
    let count = 700_u32;
    let column = |from: f64, step: f64| (0..count).map(|k| from + step * f64::from(k)).collect::<Vec<f64>>();
    // Beyond both ends of u, several turns of v.
    let (us, vs, ts) = (column(-0.1, 1.2 / 700.0), column(-9.0, 0.04), column(0.0, 0.1));
    let samples = Samples { u: &us, v: &vs, t: &ts };
    let run = |evaluator: &Arc<dyn Evaluator>| {
        let mut values = vec![0.0; 3 * us.len()];
        evaluator.evaluate(&[], samples, &mut values).expect("lengths fit");
        values
    };
    let values = run(&evaluators[0]);
    let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<u64>>();
    assert_eq!(bits(&values), bits(&run(&evaluators[1])));
    for (k, value) in values.iter().take(us.len()).enumerate() {
        let plain = graph.value(surface, &[], [us[k], vs[k], ts[k]]);
        assert_eq!(value.to_bits(), plain.to_bits(), "{k}");
        assert_eq!(value.is_nan(), !(-1e-9..=1.0 + 1e-9).contains(&us[k]), "u = {}", us[k]);
    }
    // The mixed derivative against a central difference of the value, away from knots.
    let step = 1e-5;
    let at = |u: f64, v: f64| tensor().value(u, v);
    let (u, v) = (0.7, 2.4);
    let difference = (at(u + step, v + step) - at(u + step, v - step) - at(u - step, v + step)
        + at(u - step, v - step))
        / (4.0 * step * step);
    let mixed = tensor().differentiated(0).and_then(|call| call.differentiated(1)).expect("smooth").value(u, v);
    // Rounding of 1e-16 over 4e-10.
    assert!((difference - mixed).abs() < 1e-5, "{difference} {mixed}");
}
