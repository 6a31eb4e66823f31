//! Primary surfaces from files of B-splines: blends measured against the recursive definition, and what is said of bad files.

use serde_json::{Value, json};

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostics, Source};
use trimline::export::{CadFormat, Face, Schema, write_cad};
use trimline::limits::Limits;
use trimline::method::{Options, Solution};
use trimline::surface::bspline::{from_json, from_step, to_json};
use trimline::surface::{BsplineSurface, KnotVector};
use trimline::verify::verify_joins;

use crate::bspline::{cox_de_boor, distance, random, random_knots, random_points};
use crate::spec::{at, data_file, example};

fn compiled(text: &str, files: &[(&str, &str)]) -> Result<Blend, Diagnostics> {
    let read = |path: &str| {
        let given = files.iter().find(|(name, _)| *name == path);
        given.map(|(_, contents)| contents.as_bytes().to_vec()).ok_or_else(|| "there is none".to_owned())
    };
    Blend::compile_with(&Source::new("spec", text), read, &Options::default())
}

fn blend(text: &str, files: &[(&str, &str)]) -> Blend {
    compiled(text, files).unwrap_or_else(|found| panic!("{text}\n{found:?}"))
}

fn solved(blend: &Blend, t: f64) -> Solution {
    blend.solve(0, t).unwrap_or_else(|found| panic!("{found}"))
}

/// A derivative of a B-spline by the recursive definition of its basis.
fn definition(surface: &BsplineSurface, [order_u, order_v]: [usize; 2], [u, v]: [f64; 2]) -> [f64; 3] {
    let [in_u, in_v] = surface.knots();
    let mut sum = [0.0; 3];
    for (i, row) in surface.rows().enumerate() {
        let share = cox_de_boor(in_u.as_slice(), i, in_u.degree(), order_u, u);
        for (j, point) in row.iter().enumerate() {
            let share = share * cox_de_boor(in_v.as_slice(), j, in_v.degree(), order_v, v);
            (0..3).for_each(|axis| sum[axis] += share * point[axis]);
        }
    }
    sum
}

fn read_json(text: &str, index: usize) -> BsplineSurface {
    from_json(text, &Limits::default()).expect("surfaces").swap_remove(index).1
}

/// An open surface with edges that do not meet, of degrees 3 and `degree`.
fn open(degree: usize) -> BsplineSurface {
    let (u, v) = (random_knots(5, 3, 6), random_knots(6, degree, 9));
    BsplineSurface::new(u, v, random_points(7, 54)).expect("a surface").clamped()
}

const FAR: &str = "at u = 1: S = [v, 3 + sin(t), v^2], ∂S/∂u = [0, 1, 0]\n";

/// Where the trimline is looked at: not at the points of any method.
fn along([low, high]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..=40).map(move |step| low + (high - low) * f64::from(step) / 40.0)
}

/// A blend that takes position and tangent from the far edge of `part`.
fn from_far_edge(part: &BsplineSurface, method: &str) -> Result<Blend, Diagnostics> {
    let file = to_json(&[("part", part)]).expect("JSON");
    let [[_, end], [low, high]] = part.domain();
    let text = format!(
        "surface S1 = bspline(\"part.json\")\ndomain v in [{low:?}, {high:?}]\nat u = 0: S = S1({end:?}, v), ∂S/∂u = ∂S1({end:?}, v)/∂u\n{FAR}{method}"
    );
    compiled(&text, &[("part.json", &file)])
}

#[test]
fn blends_with_open_cubics_and_quintics_meet_position_and_tangent_of_their_definition() {
    for degree in [3, 5] {
        let part = open(degree);
        let [[_, end], range] = part.domain();
        let solution = solved(&from_far_edge(&part, "").expect("a problem"), 0.5);
        assert!(solution.report.truncation.is_none_or(|truncation| truncation.has_remainder));
        for v in along(range) {
            // The recursive definition is of half-open spans: the end is taken just before.
            let v = v.min(range[1] - 1e-13).max(range[0]);
            let inside = [end - 1e-13, v];
            for (letters, orders) in [("", [0, 0]), ("u", [1, 0]), ("v", [0, 1]), ("uv", [1, 1]), ("vv", [0, 2])] {
                let found = at(&*solution.surface, letters, [0.0, v, 0.5]);
                let (stated, steps) = (definition(&part, orders, inside), 10_f64.powi(orders[1] as i32));
                // That far from the end, by derivatives that grow tenfold with each order.
                assert!(distance(found, stated) <= 1e-11 * steps, "{degree}, {letters} at {v}: {found:?} {stated:?}");
            }
        }
    }
}

#[test]
fn derivatives_of_a_blend_beyond_those_of_its_import_are_those_between_the_knots() {
    let part = open(3);
    let solution = solved(&from_far_edge(&part, "").expect("a problem"), 0.5);
    let [_, knots] = part.knots();
    let inner: Vec<f64> = knots
        .as_slice()
        .iter()
        .copied()
        .filter(|knot| (knots.domain()[0] < *knot) && (*knot < knots.domain()[1]))
        .collect();
    let knot = inner.first().copied().expect("an inner knot");
    let third = |v: f64| at(&*solution.surface, "vvv", [0.0, v, 0.5]);
    // A cubic's third derivative is constant from knot to knot, and jumps.
    let of = |v: f64| definition(&part, [0, 3], [part.domain()[0][1] - 1e-13, v]);
    let jump = distance(of(knot - 1e-9), of(knot + 1e-9));
    for v in [knot - 1e-9, knot, knot + 1e-9] {
        assert!(distance(third(v), of(v)) <= 1e-4 * jump, "{v}: {:?} {:?}", third(v), of(v));
    }
}

#[test]
fn import_with_a_kink_has_no_remainder() {
    let (u, v) = (random_knots(5, 3, 6), random_knots(6, 1, 5));
    let kinked = BsplineSurface::new(u, v, random_points(7, 30)).expect("a surface").clamped();
    let series = from_far_edge(&kinked, "solve fourier, modes = 64").expect("a series");
    assert!(!solved(&series, 0.5).report.truncation.expect("a series").has_remainder);
    let refused = from_far_edge(&kinked, "solve fourier, remainder = on").err().expect("refused");
    assert_eq!(refused[0].code, Code::NotDifferentiable);
}

#[test]
fn blend_with_an_open_cubic_and_no_remainder_misses_it_by_no_more_than_it_says() {
    let part = open(3);
    let mut bytes = Vec::new();
    let face = Face { name: "part".to_owned(), surface: part.clone() };
    write_cad("model", &[face], CadFormat::Step(Schema::Ap242), &mut bytes).expect("a file");
    let file = String::from_utf8(bytes).expect("a text");
    let [[start, _], range] = part.domain();
    let text = format!(
        "surface S1 = bspline(\"part.STP\", face = 1)\ndomain v in [{:?}, {:?}]\nat u = 0: join S1 at u = {start:?}, flip\n{FAR}solve fourier, remainder = off",
        range[0], range[1]
    );
    let blend = blend(&text, &[("part.STP", &file)]);
    let solution = solved(&blend, 0.5);
    let truncation = solution.report.truncation.expect("a series");
    assert_eq!((solution.report.method, truncation.has_remainder), ("fourier", false));
    assert!(truncation.left_out < 1e-5, "{truncation:?}");
    let mut worst = 0.0_f64;
    for v in along(range) {
        let v = v.min(range[1] - 1e-13).max(range[0]);
        let found = at(&*solution.surface, "", [0.0, v, 0.5]);
        worst = worst.max(distance(found, definition(&part, [0, 0], [start, v])));
        let turned = definition(&part, [1, 0], [start, v]).map(|x| -x);
        let tangent = at(&*solution.surface, "u", [0.0, v, 0.5]);
        assert!(distance(tangent, turned) <= 4.0 * truncation.left_out, "{v}: {tangent:?} {turned:?}");
    }
    assert!(worst <= 2.0 * truncation.left_out, "{worst:e} {truncation:?}");
}

#[test]
fn imported_surface_that_closes_keeps_its_period() {
    let glass = String::from_utf8(data_file("glass.json").expect("an example's file")).expect("a text");
    let part = read_json(&glass, 1);
    let text = "surface S1 = bspline(\"glass.json\", face = 2)\n\
                at u = 0: S = S1(0, v + 1 + 2t), ∂S/∂u = -∂S1(0, v + 1 + 2t)/∂u\n\
                at u = 1: S = [cos v, sin v, 5], ∂S/∂u = [0, 0, 1]\n";
    let blend = blend(text, &[("glass.json", &glass)]);
    for t in [0.0, 0.7] {
        let solution = solved(&blend, t);
        for v in along([0.0, std::f64::consts::TAU]) {
            let there = (v + 1.0 + 2.0 * t).rem_euclid(std::f64::consts::TAU);
            let stated = definition(&part, [0, 0], [0.0, there]);
            let found = at(&*solution.surface, "", [0.0, v, t]);
            assert!(distance(found, stated) <= 1e-11, "{v}, {t}: {found:?} {stated:?}");
        }
    }
}

#[test]
fn moving_frame_carries_an_imported_face() {
    // As the example has it: turned about z and lifted in time.
    let text = example("import_step");
    let blend = Blend::compile_with(&Source::new("spec", &text), data_file, &Options::default()).expect("an example");
    let file = String::from_utf8(data_file("catenoid.step").expect("a file")).expect("a text");
    let part = from_step(&file, &Limits::default()).expect("a face").swap_remove(0).1;
    let [range_u, range_v] = part.domain();
    for t in [0.0, 0.4, 1.0] {
        let solution = solved(&blend, t);
        let (sine, cosine) = (0.3 * t).sin_cos();
        for v in along(range_v) {
            let v = v.min(range_v[1] - 1e-13);
            let [x, y, z] = definition(&part, [0, 0], [range_u[0], v]);
            let stated = [cosine * x - sine * y, sine * x + cosine * y, z + 0.2 * t];
            let found = at(&*solution.surface, "", [0.0, v, t]);
            assert!(distance(found, stated) <= 1e-12, "{v}, {t}: {found:?} {stated:?}");
        }
    }
}

#[test]
fn joins_are_measured_against_the_imported_surface() {
    for name in ["import_json", "import_step"] {
        let text = example(name);
        let blend = Blend::compile_with(&Source::new("spec", &text), data_file, &Options::default()).expect(name);
        assert!(!blend.problem.patches[0].joins.is_empty(), "{name}");
        for t in [0.0, 0.5] {
            let solution = solved(&blend, t);
            let prepared = &blend.patches[0];
            let measured = verify_joins(
                &blend.problem,
                prepared.patch(),
                &*solution.surface,
                (&blend.bindings, &prepared.domain, t),
                &Limits::default(),
            );
            for join in measured.expect("measured") {
                assert!(join.gap < 1e-12 && join.angle_degrees.expect("planes") < 1e-9, "{name}: {join:?}");
            }
        }
    }
}

#[test]
fn join_with_an_imported_crease_has_a_gap_and_no_tangents_to_compare() {
    let (u, v) = (vec![0.0, 0.0, 0.5, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]);
    let [u, v] = [u, v].map(|knots| KnotVector::new(1, knots).expect("knots"));
    let net = (0..6).map(|at| [f64::from(at / 2), f64::from(at % 2), f64::from(at / 2 % 2)]).collect();
    let creased = BsplineSurface::new(u, v, net).expect("a surface");
    let text = "surface A = bspline(\"part.json\")\ndomain v in [0, 1]\n\
        at u = 0: S = A(0.25, v), ∂S/∂u = [0, 0, 1]\nat u = 1: S = [3, v, 0], ∂S/∂u = [0, 0, 1]\n";
    let blend = blend(text, &[("part.json", &to_json(&[("part", &creased)]).expect("JSON"))]);
    let (solution, prepared) = (solved(&blend, 0.0), &blend.patches[0]);
    let place = (&blend.bindings, &prepared.domain, 0.0);
    let measured = verify_joins(&blend.problem, prepared.patch(), &*solution.surface, place, &Limits::default());
    let measured = measured.expect("measured");
    let [join] = measured.as_slice() else { panic!("{measured:?}") };
    assert!(join.gap < 1e-12 && join.angle_degrees.is_none() && join.tangent.is_none(), "{join:?}");
}

/// The text of `part.json`: a bilinear face over [0, 1] and [0, 2], with one entry replaced.
fn file(key: &str, value: Value) -> String {
    let mut patch = json!({
        "name": "p", "degree": [1, 1], "knots_u": [0, 0, 1, 1], "knots_v": [0, 0, 2, 2],
        "control_net": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]
    });
    patch[key] = value;
    json!({ "patches": [patch] }).to_string()
}

fn refusal(declared: &str, boundary: &str, contents: &str) -> String {
    let text = format!("surface A = bspline({declared})\ndomain v in [0, 2]\nat u = 0: {boundary}, ∂S/∂u = 0\n{FAR}");
    let found = compiled(&text, &[("part.json", contents), ("part.step", contents)]).err().expect("a bad file");
    assert_eq!(found.len(), 1, "{found:?}");
    let span = found[0].span.expect("a place");
    format!("{} `{}` {}", found[0].code, &text[span.start..span.end], found[0].message)
}

#[test]
fn faults_of_a_file_are_one_error_at_its_name() {
    let refused = |declared: &str, contents: &str| refusal(declared, "S = A(1, v)", contents);
    let good = || file("name", json!("p"));
    let patch = serde_json::from_str::<Value>(&good()).expect("JSON")["patches"][0].clone();
    let two = json!({ "patches": [patch, patch] }).to_string();
    for (declared, contents, words) in [
        (
            "\"part.json\"",
            "{}".to_owned(),
            "E0609 `\"part.json\"` part.json: this is no file of B-splines: missing field `patches`",
        ),
        (
            "\"part.json\"",
            "{\"patches\":[]}".to_owned(),
            "E0609 `\"part.json\"` part.json: it holds no B-spline surface",
        ),
        (
            "\"part.json\"",
            two,
            "E0609 `\"part.json\"` part.json: it holds 2 B-spline surfaces, and which of them is meant is missing",
        ),
        (
            "\"part.json\", face = 2",
            good(),
            "E0609 `\"part.json\"` part.json: there is no face 2: it holds 1 B-spline surface",
        ),
        ("\"part.json\", face = 0", good(), "E0609 `\"part.json\"` part.json: there is no face 0"),
        (
            "\"part.json\"",
            file("knots_u", json!([0, 0, 1])),
            "E0601 `\"part.json\"` part.json: patch `p`: 3 knots are too few",
        ),
        (
            "\"part.json\"",
            file("knots_u", json!([0, 1, 0, 1])),
            "E0601 `\"part.json\"` part.json: patch `p`: the knots descend",
        ),
        (
            "\"part.json\"",
            file("knots_v", json!([0, 0, 1, 2, 2])),
            "E0603 `\"part.json\"` part.json: patch `p`: row 0 of the net has 2 points",
        ),
        (
            "\"part.json\"",
            file("degree", json!([1, 9])),
            "E0601 `\"part.json\"` part.json: patch `p`: the degree of a B-spline is 9",
        ),
        (
            "\"part.json\"",
            good().replace("[1,1,0]", "[1,1,1e999]"),
            "E0609 `\"part.json\"` part.json: this is no file of B-splines: number out of range",
        ),
        ("\"part.step\"", good(), "E0609 `\"part.step\"` part.step: this is no STEP file"),
        (
            "\"part.step\"",
            "ISO-10303-21;\nDATA;\n#1=PLANE('',#2);\nENDSEC;\nEND-ISO-10303-21;\n".to_owned(),
            "E0609 `\"part.step\"` part.step: the STEP file has no face on a B-spline surface",
        ),
        ("\"other.json\"", good(), "E0221 `\"other.json\"` the data file `other.json` cannot be read: there is none"),
    ] {
        let found = refused(declared, &contents);
        assert!(found.starts_with(words), "{words}\n{found}");
    }
}

#[test]
fn data_beyond_the_knots_are_refused_with_the_range() {
    let good = file("name", json!("p"));
    for (boundary, words) in [
        ("S = A(1.5, v)", "E0303 `A(1.5, v)` `A` is asked for at u = 1.5, outside the range [0, 1] of its knots"),
        ("S = A(1, v + t)", "E0303 `A(1, v + t)` `A` is asked for at v = 3, outside the range [0, 2] of its knots"),
        ("S = A(v/4 - 0.25, v)", "E0303 `A(v/4 - 0.25, v)` `A` is asked for at u = -0.25, outside the range [0, 1]"),
    ] {
        let found = refusal("\"part.json\"", boundary, &good);
        assert!(found.starts_with(words), "{words}\n{found}");
    }
    // A param that moves it there is refused, and the blend is as it was.
    let text = format!(
        "param a = 1\nsurface A = bspline(\"part.json\")\ndomain v in [0, 2]\nat u = 0: S = A(a, v), ∂S/∂u = 0\n{FAR}"
    );
    let mut blend = blend(&text, &[("part.json", &good)]);
    let found = blend.set("a", "2").expect_err("beyond");
    assert!(found[0].message.starts_with("`A` is asked for at u = 2, outside"), "{found:?}");
    solved(&blend, 0.0);
}

/// The body of the glass, which closes in v, with noise of that size on its last columns, and the finding about it.
fn almost_closed(noise: f64, columns: usize) -> (BsplineSurface, BsplineSurface) {
    let glass = String::from_utf8(data_file("glass.json").expect("an example's file")).expect("a text");
    let whole = read_json(&glass, 1);
    let [u, v] = whole.knots();
    let mut next = random(3);
    let mut net = whole.net().to_vec();
    for row in net.chunks_mut(v.points()) {
        let last = row.iter_mut().rev().take(columns);
        last.for_each(|point| point.iter_mut().for_each(|x| *x += noise * next()));
    }
    let torn = BsplineSurface::new(u.clone(), v.clone(), net).expect("a surface");
    (whole, torn)
}

fn remarks(blend: &Blend) -> Vec<String> {
    blend.problem.surfaces.iter().flat_map(|surface| &surface.remarks).map(ToString::to_string).collect()
}

const ROUND: &str = "surface S1 = bspline(\"part.json\")\n\
    at u = 0: S = S1(0, v + 1), ∂S/∂u = -∂S1(0, v + 1)/∂u\n\
    at u = 1: S = [cos v, sin v, 5], ∂S/∂u = [0, 0, 1]\n";

#[test]
fn surface_that_closes_but_for_digits_is_made_periodic_and_says_how_far_it_moved() {
    for (noise, columns) in [(1e-10, 1), (1e-10, 5), (3e-11, 2)] {
        let (_, torn) = almost_closed(noise, columns);
        let closed = torn.transposed().closed_in_u(1e-9);
        assert_eq!(closed.seam, Some(4), "{noise}, {columns}");
        // Each side takes half of the way; derivatives of order k ask for 2^k of it.
        assert!(closed.moved >= 0.2 * noise && closed.moved <= 4.0 * noise, "{:e}", closed.moved);
        let surface = closed.surface.transposed();
        for (point, before) in surface.net().iter().zip(torn.net()) {
            assert!(distance(*point, *before) <= closed.moved, "{point:?} {before:?}");
        }
        let [_, [low, high]] = surface.domain();
        for u in along(surface.domain()[0]).map(|u| u.min(1.0 - 1e-13)) {
            for order in 0..=4 {
                // The recursive definition is of half-open spans, so the end is the start of what is reversed.
                let back = definition(&surface.reversed_v(), [0, order], [u, -high])
                    .map(|x| if order % 2 == 0 { x } else { -x });
                let there = definition(&surface, [0, order], [u, low]);
                let size = there.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
                assert!(distance(there, back) <= 1e-11 * size, "{order} at {u}: {there:?} {back:?}");
            }
        }
        let file = to_json(&[("part", &torn)]).expect("JSON");
        let blend = blend(ROUND, &[("part.json", &file)]);
        let told = remarks(&blend);
        let [told] = told.as_slice() else { panic!("{told:?}") };
        assert!(told.contains("N0612") && told.contains(&format!("moved by up to {:.1e}", closed.moved)), "{told}");
        let solution = solved(&blend, 0.0);
        for v in along([0.0, std::f64::consts::TAU]) {
            let there = (v + 1.0).rem_euclid(std::f64::consts::TAU);
            let found = at(&*solution.surface, "", [0.0, v, 0.0]);
            let gap = distance(found, definition(&torn, [0, 0], [0.0, there]));
            assert!(gap <= closed.moved + 1e-11, "{v}: {gap:e}");
        }
    }
}

#[test]
fn surface_that_is_open_by_more_stays_as_it_is_and_says_why() {
    let (_, torn) = almost_closed(1e-6, 1);
    let file = to_json(&[("part", &torn)]).expect("JSON");
    let found = compiled(ROUND, &[("part.json", &file)]).err().expect("beyond the knots");
    assert_eq!(found[0].code, Code::PointOutsideDomain);
    let inside = ROUND.replace("v + 1", "v");
    let blend = blend(&inside, &[("part.json", &file)]);
    let told = remarks(&blend);
    let [told] = told.as_slice() else { panic!("{told:?}") };
    assert!(told.contains("at both ends of v") && told.contains("open there"), "{told}");
    let [_, [_, high]] = torn.domain();
    let v = high - 1e-13;
    let found = at(&*solved(&blend, 0.0).surface, "", [0.0, v, 0.0]);
    assert!(distance(found, definition(&torn, [0, 0], [0.0, v])) <= 1e-11);
}

#[test]
fn closing_does_not_depend_on_the_unit_of_length() {
    let (_, torn) = almost_closed(1e-10, 2);
    let [u, v] = torn.knots();
    let plain = torn.transposed().closed_in_u(1e-9);
    for power in [-600, 600] {
        let unit = 2.0_f64.powi(power);
        let net = torn.net().iter().map(|point| point.map(|x| x * unit)).collect();
        let scaled = BsplineSurface::new(u.clone(), v.clone(), net).expect("a surface").transposed();
        let closed = scaled.closed_in_u(1e-9 * unit);
        assert_eq!((closed.seam, closed.moved), (plain.seam, plain.moved * unit));
        assert_eq!(scaled.closed_in_u(1e-12 * unit).seam, None);
    }
}

#[test]
fn step_file_closes_within_the_distance_that_it_calls_one_place() {
    let (whole, torn) = almost_closed(2e-8, 1);
    let mut bytes = Vec::new();
    write_cad("model", &[Face { name: "part".to_owned(), surface: torn }], CadFormat::Step(Schema::Ap214), &mut bytes)
        .expect("a file");
    let file = String::from_utf8(bytes).expect("a text");
    let text = ROUND.replace("part.json", "part.step");
    assert!(file.contains("LENGTH_MEASURE(1.E-7)"), "{file}");
    let told = |file: &str| compiled(&text, &[("part.step", file)]).map(|blend| remarks(&blend).concat());
    assert!(told(&file).expect("closed").contains("were made one"));
    // A file that means more than there is of it, and ones that say less or nothing.
    let size = whole.transposed().breadth_in_u();
    assert!(told(&file.replace("1.E-7", "1.E3")).expect("closed").contains("were made one"));
    assert!(told(&file.replace("1.E-7", "1.E-9")).is_err() && told(&file.replace("UNCERTAINTY", "X")).is_err());
    let (_, wide) = almost_closed(4e-6 * size, 1);
    assert_eq!(wide.transposed().closed_in_u(1e-6 * size).seam, None);
}

#[test]
fn corner_at_the_seam_stays_a_corner_however_short_the_spans_beside_it() {
    // A drop: it closes at [0, 0], where it has a corner of 90 degrees, between spans of 1e-10.
    let short = 1e-10;
    let u = KnotVector::clamped(2, &[0.0, short, 1.0 - short, 1.0]).expect("knots");
    let v = KnotVector::clamped(1, &[0.0, 1.0]).expect("knots");
    let line = [[0.0, 0.0], [short, short], [1.0, 1.0], [short, -short], [0.0, 0.0]];
    let net = line.iter().flat_map(|[x, y]| [[*x, *y, 0.0], [*x, *y, 1.0]]).collect();
    let drop = BsplineSurface::new(u, v, net).expect("a surface");
    let closed = drop.closed_in_u(1e-9);
    assert_eq!((closed.seam, closed.moved), (Some(0), 0.0));
    assert_eq!(closed.surface, drop);
}

#[test]
fn surface_whose_edges_meet_and_whose_derivatives_nearly_agree_says_so() {
    let (whole, _) = almost_closed(0.0, 1);
    let [u, v] = whole.knots();
    let mut net = whole.net().to_vec();
    for row in net.chunks_mut(v.points()) {
        if let Some(point) = row.get_mut(1) {
            point[0] += 1e-10;
        }
        let first = row[0];
        *row.last_mut().expect("a point") = first;
    }
    let rounded = BsplineSurface::new(u.clone(), v.clone(), net).expect("a surface");
    let told = remarks(&blend(ROUND, &[("part.json", &to_json(&[("part", &rounded)]).expect("JSON"))]));
    let [told] = told.as_slice() else { panic!("{told:?}") };
    assert!(told.contains("at both ends of v meet: control points moved by up to"), "{told}");
}
