//! B-spline nets stated in a text: against references, closed forms and nets filled in Rust.

use serde_json::Value;

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Source};
use trimline::method::Options;
use trimline::net::{SolvedNet, fill};
use trimline::surface::KnotVector;

use crate::bspline::distance;
use crate::spec::{NAME, all_examples, at, data_file, example, told};

fn blend(text: &str) -> Blend {
    let compiled = Blend::compile_with(&Source::new(NAME, text), data_file, &Options::default());
    compiled.unwrap_or_else(|found| panic!("{text}\n{}", told(text, &found)))
}

fn filled(text: &str, t: f64) -> SolvedNet {
    blend(text).fill(0, t).unwrap_or_else(|finding| panic!("{finding}"))
}

/// The largest distance of two nets, over the largest coordinate.
fn relative_distance(one: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    assert_eq!(one.len(), other.len());
    let size = other.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    one.iter().zip(other).fold(0.0_f64, |most, (p, q)| most.max(distance(*p, *q))) / size
}

fn net_of(reference: &str) -> Vec<[f64; 3]> {
    let path = format!("{}/tests/reference/{reference}.json", env!("CARGO_MANIFEST_DIR"));
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a reference file")).expect("JSON");
    serde_json::from_value::<Vec<Vec<[f64; 3]>>>(file["control_net"].clone()).expect("rows").concat()
}

#[test]
fn net_over_equal_knots_from_a_catenoid_is_the_reference() {
    let net = filled(&example("p2_ex2"), 0.0);
    // The reference is exact in the layers' doubles, which are a few roundings from ours.
    assert!(relative_distance(net.filled.surface.net(), &net_of("p2_n7_catenoid_uniform")) <= 1e-14);
}

#[test]
fn net_over_equal_knots_from_a_table_is_the_reference() {
    let net = filled(&example("p2_ex1"), 0.0);
    assert!(relative_distance(net.filled.surface.net(), &net_of("p2_n5_uniform")) <= 1e-14);
    assert_eq!(net.filled.surface.domain(), [[3.0, 6.0]; 2]);
}

#[test]
fn net_over_clamped_knots_is_the_one_filled_from_its_greville_points() {
    let net = filled(&example("p2_ex3"), 0.0).filled;
    let range = [std::f64::consts::PI, std::f64::consts::TAU];
    let knots = range.map(|end| {
        let breakpoints: Vec<f64> = (0..=8).map(|span| end * f64::from(span) / 8.0).collect();
        KnotVector::clamped(3, &breakpoints).expect("knots")
    });
    let [u, v] = knots.each_ref().map(KnotVector::greville);
    let place = |u: f64, v: f64| [u * u.sin() * v.cos(), u * u.cos() * v.cos(), u * v.sin()];
    let points: Vec<[f64; 3]> = u.iter().flat_map(|u| v.iter().map(|v| place(*u, *v))).collect();
    let expected = fill(&knots[0], &knots[1], &points).expect("a net");
    assert!(relative_distance(net.surface.net(), expected.surface.net()) <= 1e-14);
    assert_eq!(net.amplification, expected.amplification);
}

#[test]
fn derivatives_in_time_are_those_of_a_net_that_is_linear_and_quadratic_in_time() {
    let text = "domain t in [0, 2]\nbspline b {\nknots clamped in u, uniform in v\nnet 6 x 5 from [u + t sin(j), v + t^2 i^3, t^3]\n}\n";
    let solver = blend(text);
    let surface = |t: f64| solver.fill(0, t).expect("a net").surface;
    let (early, late, here) = (surface(0.0), surface(2.0), surface(1.0));
    for [u, v] in [[0.1, 0.2], [0.55, 3.0], [0.93, 5.9]] {
        let point = |t: f64| [u, v, t];
        let (before, behind, now) =
            (at(&*early, "", point(0.0)), at(&*late, "", point(2.0)), at(&*here, "", point(1.0)));
        let (rate, second) = (at(&*here, "t", point(1.0)), at(&*here, "tt", point(1.0)));
        // Central differences with step 1 are exact for polynomials of degree 2.
        for axis in [0, 1] {
            assert!((rate[axis] - (behind[axis] - before[axis]) / 2.0).abs() <= 1e-12, "{rate:?}");
            assert!((second[axis] - (behind[axis] - 2.0 * now[axis] + before[axis])).abs() <= 1e-11, "{second:?}");
        }
        assert!(distance([0.0, 0.0, rate[2]], [0.0, 0.0, 3.0]) <= 1e-13 && (second[2] - 6.0).abs() <= 1e-13);
    }
    let mut values = [[0.0; 3]];
    let third = trimline::expr::Derivative::parse("ttt").expect("a derivative");
    let refused = trimline::surface::Surface::evaluate(&*here, third, &[[0.5, 0.5, 1.0]], &mut values);
    assert_eq!(refused.expect_err("order 3").code, Code::UnsupportedByMethod);
    let elsewhere = trimline::surface::Surface::evaluate(&*here, Default::default(), &[[0.5, 0.5, 0.5]], &mut values);
    assert_eq!(elsewhere.expect_err("another instant").code, Code::UnsupportedByMethod);
}

#[test]
fn layers_stated_one_by_one_are_the_formula_they_share() {
    let whole = "bspline b {\ndomain v in [0, 1]\nnet 4 x 6 from [i/n, j/m, sin(u + 2 v) + 0.1 i j]\n}\n";
    let point = "[i/n, j/m, sin(u + 2 v) + 0.1 i j]";
    let layers = ["i = 0", "i = 1", "i = n", "j = 0", "j = 1", "j = 6"].map(|at| format!("layer {at}: {point}\n"));
    let each = format!("bspline b {{\ndomain v in [0, 1]\nnet 4 x 6\n{}}}\n", layers.concat());
    assert_eq!(filled(whole, 0.0).filled.surface, filled(&each, 0.0).filled.surface);
}

/// A net whose points come from `rows`.
fn tabled(rows: &str) -> Result<Blend, trimline::diagnostic::Diagnostics> {
    let text = "bspline b {\ndomain v in [0, 1]\nnet 3 x 4 from points(\"net.csv\")\n}\n";
    let read = |path: &str| if path == "net.csv" { Ok(rows.as_bytes().to_vec()) } else { Err("none".to_owned()) };
    Blend::compile_with(&Source::new(NAME, text), read, &Options::default())
}

/// Point [i², j + 0.1 i j, i - j] of 4 x 5, and another one where neither is on a layer.
fn rows(inside: &str) -> String {
    let point = |i: i32, j: i32| match (i, j) {
        (2, 2 | 3) => inside.to_owned(),
        _ => format!("{},{},{}\n", i * i, f64::from(j) + 0.1 * f64::from(i * j), i - j),
    };
    (0..4).flat_map(|i| (0..5).map(move |j| point(i, j))).collect()
}

#[test]
fn points_of_a_file_are_taken_with_j_running_first_and_only_those_of_layers() {
    let formula = filled("bspline b {\ndomain v in [0, 1]\nnet 3 x 4 from [i^2, j + 0.1 i j, i - j]\n}\n", 0.0);
    for inside in ["4,2.4,0\n", "100,100,100\n"] {
        let net = tabled(&rows(inside)).unwrap_or_else(|found| panic!("{found:?}")).fill(0, 0.0).expect("a net");
        assert!(relative_distance(net.filled.surface.net(), formula.filled.surface.net()) <= 1e-15);
        assert_eq!(net.filled.surface.knots(), formula.filled.surface.knots());
    }
}

#[test]
fn files_that_are_no_table_of_the_net_are_refused_with_what_is_wrong() {
    let whole = rows("4,2.4,0\n");
    let told = |rows: &str| {
        let found = tabled(rows).err().expect("no net");
        assert_eq!((found.len(), found[0].code), (1, Code::BadDataFile), "{found:?}");
        assert_eq!(found[0].span.map(|span| (span.start, span.end)), Some((53, 62)), "{found:?}");
        found[0].message.clone()
    };
    assert_eq!(told(&format!("{whole}0,0,0\n")), "net.csv: a net 3 x 4 has 20 points, and it holds more");
    assert_eq!(told("0,0,0\n"), "net.csv: a net 3 x 4 has 20 points, and it holds 1");
    assert_eq!(told("0,0,0\n0,0\n"), "net.csv: row 2 has no column z: it has 2 columns where 3 are expected");
    assert_eq!(told("0,0,0\n0,inf,0\n"), "net.csv: row 2, column y: `inf` is not a finite number");
    let text = "bspline b {\nnet 3 x 4 from points(\"net.csv\")\n}\n";
    let found = Blend::compile(&Source::new(NAME, text), &Options::default()).err().expect("no file");
    assert_eq!(found[0].code, Code::DataFileMissing);
}

#[test]
fn knots_and_layers_follow_params_and_a_value_without_knots_changes_nothing() {
    let text =
        "param a = 2, h = 1\nbspline b {\nknots [0, 0, 0, 0, 0.5, a, 3, 3, 3, 3] in u\nnet 5 x 4 from [h i, j, 0]\n}\n";
    let mut solver = blend(text);
    let inner = |solver: &Blend| {
        let surface = solver.fill(0, 0.0).expect("a net").filled.surface;
        (surface.knots()[0].as_slice()[5], surface.net()[5 * 5][0])
    };
    assert_eq!(inner(&solver), (2.0, 5.0));
    solver.set("a", "1.5").expect("ascending");
    solver.set("h", "a").expect("a height");
    assert_eq!(inner(&solver), (1.5, 7.5));
    assert_eq!(solver.set("a", "0.5").expect_err("repeated")[0].code, Code::KnotRepeated);
    assert_eq!(solver.set("a", "0.2").expect_err("descending")[0].code, Code::KnotsNotAscending);
    assert_eq!(inner(&solver), (1.5, 7.5));
}

#[test]
fn formula_of_a_point_outside_the_layers_is_not_read() {
    // Infinite at i = j = 2 and nowhere else.
    let net = filled("bspline b {\nnet 5 x 5 from [i, j, 1/((i - 2)^2 + (j - 2)^2)]\n}\n", 0.0);
    assert!(net.filled.surface.net().iter().flatten().all(|x| x.is_finite()));
}

#[test]
fn layers_that_cross_at_different_places_are_refused_at_the_instant_at_which_they_do() {
    let rows = ["i = 0", "i = 1", "i = n"].map(|at| format!("layer {at}: [i, j, t j]\n")).concat();
    let columns = ["j = 0", "j = 1", "j = m"].map(|at| format!("layer {at}: [i, j, t j^2]\n")).concat();
    let solver = blend(&format!("bspline b {{\nnet 4 x 5\n{rows}{columns}}}\n"));
    assert!(solver.fill(0, 0.0).is_ok());
    let found = solver.fill(0, 1.0).map(|_| ()).expect_err("5 against 25");
    assert_eq!(found.code, Code::LayersDisagree, "{found}");
}

#[test]
fn documents_may_hold_patches_and_nets_with_a_seam_between_them() {
    let text = "domain v in [0, 1]
patch base {
    at u = 0: S = [0, v, 0], ∂S/∂u = [1, 0, 0]
    at u = 1: S = [1, v, 0], ∂S/∂u = [1, 0, 0]
}
bspline top {
    domain u in [1, 2]
    net 4 x 4 from [u, v, (u - 1)^2]
}
seam base at u = 1 with top at u = 1
";
    let blend = blend(text);
    assert_eq!((blend.patches.len(), blend.nets.len()), (1, 1));
    assert_eq!(blend.problem.seams[0].edges.map(|edge| edge.patch), [0, 1]);
    assert_eq!(blend.problem.part_name(1), Some("top"));
    assert_eq!(blend.nets[0].domain.u, [1.0, 2.0]);
    assert_eq!(blend.fill(1, 0.0).map(|_| ()).expect_err("one net").code, Code::SettingOutOfRange);
}

#[test]
fn examples_of_nets_are_filled_at_both_ends_of_their_time() {
    let nets: Vec<(String, String)> =
        all_examples().into_iter().filter(|(_, text)| text.contains("bspline ")).collect();
    assert!(nets.len() >= 2);
    for (name, text) in nets {
        let blend = blend(&text);
        for (index, net) in blend.nets.iter().enumerate() {
            for t in net.domain.t {
                blend.fill(index, t).unwrap_or_else(|finding| panic!("{name}: {finding}"));
            }
        }
    }
}
