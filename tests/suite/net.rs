//! Filled nets against references, exact arithmetic and a solver.

mod joined;

use nalgebra::DMatrix;
use serde_json::Value;

use trimline::diagnostic::Code;
use trimline::net::{Filled, fill};
use trimline::surface::{BsplineCurve, BsplineSurface, KnotVector};

use crate::bspline::{distance, random, random_knots, random_points};
use crate::spec::at;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

fn largest(net: &[[f64; 3]]) -> f64 {
    net.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()))
}

fn largest_distance(one: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).fold(0.0_f64, |most, (p, q)| most.max(distance(*p, *q)))
}

/// A net from a file, filled from nothing but its boundary layers, and the file's own.
fn reference(name: &str) -> (Value, Filled, Vec<[f64; 3]>) {
    let path = format!("{}/tests/reference/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a reference file")).expect("JSON");
    let knots = ["knots_u", "knots_v"].map(|key| KnotVector::new(3, numbers(&file[key])).expect("knots"));
    let columns = knots[1].points();
    let mut layers = vec![[f64::NAN; 3]; knots[0].points() * columns];
    for entry in file["input_boundary"].as_array().expect("points").iter().map(numbers) {
        layers[entry[0] as usize * columns + entry[1] as usize] = [entry[2], entry[3], entry[4]];
    }
    let stated = file["control_net"].as_array().expect("rows").iter().flat_map(|row| row.as_array().expect("a row"));
    let stated = stated.map(|point| numbers(point).try_into().expect("x, y, z")).collect();
    let filled = fill(&knots[0], &knots[1], &layers).expect("a net");
    (file, filled, stated)
}

#[test]
fn published_constructions_give_the_reference_nets_and_surfaces() {
    for (name, amplification) in [("p2_n5_uniform", 2.6), ("p2_n7_catenoid_uniform", 3.5714285714285716)] {
        let (file, filled, stated) = reference(name);
        let size = largest(&stated);
        // The reference is exact; a point is a sum of 15 products.
        assert!(largest_distance(filled.surface.net(), &stated) <= 1e-14 * size, "{name}");
        for sample in file["samples_u_v_x_y_z"].as_array().expect("samples").iter().map(numbers) {
            let found = at(&filled.surface, "", [sample[0], sample[1], 0.0]);
            assert!(distance(found, [sample[2], sample[3], sample[4]]) <= 1e-14 * size, "{name} {sample:?}");
        }
        assert!((filled.amplification[0] - amplification).abs() <= 1e-14 * amplification);
        assert_eq!(filled.warnings, []);
    }
}

/// docs/bspline.md, N1: 6 λ³ (a, b, c, d) of each span, doubled; whole numbers for clamped knots with equal spans.
fn clamped_mask(points: usize) -> Vec<[i128; 4]> {
    let (first, second, middle) = ([2, 3, 6, 12], [2, 2, 2, 3], [2, 2, 2, 2]);
    let turned = |mut row: [i128; 4]| {
        row.reverse();
        row
    };
    let rows: Vec<[i128; 4]> = match points {
        4 => vec![[12, 12, 12, 12]],
        5 => vec![[3, 3, 6, 12], [12, 6, 3, 3]],
        6 => vec![first, [3, 2, 2, 3], turned(first)],
        _ => {
            let spans = points - 3;
            (0..spans)
                .map(|span| match span {
                    0 => first,
                    1 => second,
                    _ if span + 2 == spans => turned(second),
                    _ if span + 1 == spans => turned(first),
                    _ => middle,
                })
                .collect()
        }
    };
    rows.into_iter().map(|[a, b, c, d]| [-d, b + c + d, -(a + b + c), a]).collect()
}

#[test]
fn third_derivatives_of_clamped_basis_functions_are_the_tabled_masks() {
    for points in 4..=9 {
        let knots = KnotVector::clamped_uniform(3, points).expect("knots");
        for (index, row) in clamped_mask(points).into_iter().enumerate() {
            for (offset, expected) in row.into_iter().enumerate() {
                let mut net = vec![[0.0; 3]; points];
                net[index + offset] = [1.0, 0.0, 0.0];
                let curve = BsplineCurve::new(knots.clone(), net).expect("a curve");
                // Halves and small whole numbers: exact.
                assert_eq!(
                    curve.derivative(3, index as f64 + 0.5)[0],
                    expected as f64 / 2.0,
                    "{points} {index} {offset}"
                );
            }
        }
    }
}

/// N3 for clamped equal spans in whole numbers: numerators of L_0, L_1, L_n over one denominator.
fn exact_cardinal(points: usize) -> (Vec<[i128; 3]>, i128) {
    let end = points as i128 - 3;
    let knot = |index: usize| (index as i128 - 3).clamp(0, end);
    let linear = |i: usize| knot(i + 1) + knot(i + 2) + knot(i + 3);
    let quadratic = |i: usize| {
        let (x, y, z) = (knot(i + 1), knot(i + 2), knot(i + 3));
        x * y + x * z + y * z
    };
    let (first, last, quadratic_last) = (linear(1), linear(points - 1), quadratic(points - 1));
    let denominator = first * quadratic_last;
    let row = |i: usize| {
        let at_last = first * quadratic(i);
        let at_first = linear(i) * quadratic_last - last * quadratic(i);
        [denominator - at_first - at_last, at_first, at_last]
    };
    ((0..points).map(row).collect(), denominator)
}

/// A net of 501 x 501 points whose layers are whole numbers up to 1000, in exact arithmetic: the numerators and their
/// denominator. What is returned is proved to be the solution: it satisfies every equation of N2 exactly.
fn exact_net(points: usize) -> (Vec<i128>, i128) {
    let (shares, denominator) = exact_cardinal(points);
    let mut next = random(2021);
    let layers: Vec<i128> = (0..points * points).map(|_| (1000.0 * next()).round() as i128).collect();
    let given = |i: usize, j: usize| layers[i * points + j];
    let picks = [0, 1, points - 1];
    let mut net = Vec::with_capacity(points * points);
    for i in 0..points {
        for j in 0..points {
            let mut sum = 0;
            for (a, row) in picks.into_iter().enumerate() {
                sum += denominator * (shares[i][a] * given(row, j) + shares[j][a] * given(i, row));
                for (b, column) in picks.into_iter().enumerate() {
                    sum -= shares[i][a] * shares[j][b] * given(row, column);
                }
            }
            net.push(sum);
        }
    }
    let scale = denominator * denominator;
    for i in 0..points {
        for j in 0..points {
            if picks.contains(&i) || picks.contains(&j) {
                assert_eq!(net[i * points + j], scale * given(i, j), "a layer is as given");
            }
        }
    }
    let mask = clamped_mask(points);
    for (i, in_u) in mask.iter().enumerate() {
        for (j, in_v) in mask.iter().enumerate() {
            let entry = |a: usize, b: usize| in_u[a] * in_v[b] * net[(i + a) * points + j + b];
            let residual: i128 = (0..4).flat_map(|a| (0..4).map(move |b| (a, b))).map(|(a, b)| entry(a, b)).sum();
            assert_eq!(residual, 0, "span {i}, {j}");
        }
    }
    (net, scale)
}

#[test]
fn net_of_501_by_501_points_is_the_exact_one_to_13_digits() {
    let points = 501;
    let (exact, scale) = exact_net(points);
    let exact: Vec<f64> = exact.iter().map(|numerator| *numerator as f64 / scale as f64).collect();
    let knots = KnotVector::clamped_uniform(3, points).expect("knots");
    let is_layer = |index: usize| index < 2 || index + 1 == points;
    let layers: Vec<[f64; 3]> = exact
        .iter()
        .enumerate()
        .map(|(at, x)| if is_layer(at / points) || is_layer(at % points) { [*x, -x, 2.0 * x] } else { [f64::NAN; 3] })
        .collect();
    let filled = fill(&knots, &knots, &layers).expect("a net");
    let size = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let error = filled.surface.net().iter().zip(&exact).fold(0.0_f64, |most, ([x, y, z], exact)| {
        most.max((x - exact).abs()).max((y + exact).abs()).max((z - 2.0 * exact).abs())
    });
    assert!(error <= 1e-13 * size, "{error:.1e} of {size:.1e}");
    // 3 (n - 2) / 4 for the largest L_1 alone.
    assert!(filled.amplification[0] > 373.0 && filled.amplification[0] < 750.0, "{:?}", filled.amplification);
    assert_eq!(filled.warnings[0].code, Code::NetAmplifies);
}

/// D of N2: the third derivatives of the basis functions on each span.
fn derivative_matrix(knots: &KnotVector) -> DMatrix<f64> {
    let points = knots.points();
    let middles: Vec<f64> = knots.breakpoints().windows(2).map(|span| 0.5 * (span[0] + span[1])).collect();
    DMatrix::from_fn(middles.len(), points, |span, point| {
        let mut net = vec![[0.0; 3]; points];
        net[point][0] = 1.0;
        BsplineCurve::new(knots.clone(), net).expect("a curve").derivative(3, middles[span])[0]
    })
}

/// The paper's way: two factorised systems instead of the closed form.
fn solved(u: &KnotVector, v: &KnotVector, layers: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let [in_u, in_v] = [u, v].map(derivative_matrix);
    let (rows, columns) = (u.points(), v.points());
    let is_layer = |index: usize, count: usize| index < 2 || index + 1 == count;
    let mut net = layers.to_vec();
    for axis in 0..3 {
        let known = DMatrix::from_fn(rows, columns, |i, j| {
            if is_layer(i, rows) || is_layer(j, columns) { layers[i * columns + j][axis] } else { 0.0 }
        });
        let right = -(&in_u * known * in_v.transpose());
        let [left, other] =
            [(&in_u, rows), (&in_v, columns)].map(|(matrix, count)| matrix.columns(2, count - 3).into_owned());
        let half = left.lu().solve(&right).expect("not singular");
        let inside = other.lu().solve(&half.transpose()).expect("not singular").transpose();
        for (i, row) in inside.row_iter().enumerate() {
            for (j, x) in row.iter().enumerate() {
                net[(i + 2) * columns + j + 2][axis] = *x;
            }
        }
    }
    net
}

fn knots_of_every_kind(points: usize) -> Vec<KnotVector> {
    vec![
        KnotVector::uniform(3, points).expect("knots"),
        KnotVector::clamped_uniform(3, points).expect("knots"),
        random_knots(points as u64, 3, points),
        KnotVector::clamped(3, &random_knots(points as u64 + 9, 3, points).breakpoints()).expect("knots"),
    ]
}

#[test]
fn closed_form_agrees_with_factorised_systems_for_all_knots() {
    for (rows, columns) in [(4, 4), (4, 9), (5, 6), (9, 12), (12, 5)] {
        for u in knots_of_every_kind(rows) {
            for v in knots_of_every_kind(columns) {
                let layers = random_points(rows as u64, rows * columns);
                let filled = fill(&u, &v, &layers).expect("a net");
                let reference = solved(&u, &v, &layers);
                let size = largest(&reference);
                // Conditions up to 4e2 in each direction, and random steps of 1 : 6.
                assert!(largest_distance(filled.surface.net(), &reference) <= 1e-10 * size, "{rows} x {columns}");
            }
        }
    }
}

#[test]
fn sixth_derivative_vanishes_on_every_span() {
    let (u, v) = (random_knots(40, 3, 8), random_knots(41, 3, 11));
    let surface = fill(&u, &v, &random_points(42, 88)).expect("a net").surface;
    let random = BsplineSurface::new(u.clone(), v.clone(), random_points(42, 88)).expect("a surface");
    let sixth = |surface: &BsplineSurface, x: f64, y: f64| at(surface, "uuuvvv", [x, y, 0.0]);
    let mut least = f64::INFINITY;
    for x in u.breakpoints().windows(2).map(|span| 0.5 * (span[0] + span[1])) {
        for y in v.breakpoints().windows(2).map(|span| 0.5 * (span[0] + span[1])) {
            let size = distance(sixth(&random, x, y), [0.0; 3]);
            least = least.min(size);
            // Rounding of points of size 20 against terms of 6²/0.3⁶ at most.
            assert!(distance(sixth(&surface, x, y), [0.0; 3]) <= 1e-9, "{x} {y}");
        }
    }
    assert!(least > 1e-3, "a net that is not filled does not satisfy the equation: {least:.1e}");
}

#[test]
fn net_of_a_quadratic_sweep_is_filled_with_itself() {
    // u² f(v) + u g(v) + h(v) + v² k(u) …: all that the equation leaves free is reproduced.
    let (u, v) = (random_knots(50, 3, 9), random_knots(51, 3, 8));
    let filled = fill(&u, &v, &random_points(52, 72)).expect("a net");
    let again = fill(&u, &v, filled.surface.net()).expect("a net");
    assert!(largest_distance(filled.surface.net(), again.surface.net()) <= 1e-13 * largest(filled.surface.net()));
}

#[test]
fn amplification_is_the_tabled_one() {
    for (knots, expected) in [
        (KnotVector::uniform(3, 11), 5.0),
        (KnotVector::uniform(3, 51), 25.0),
        (KnotVector::clamped_uniform(3, 11), 11.7),
        (KnotVector::clamped_uniform(3, 51), 71.5),
    ] {
        let knots = knots.expect("knots");
        let square = random_points(1, knots.points() * knots.points());
        let filled = fill(&knots, &knots, &square).expect("a net");
        // Three digits were tabled.
        assert!((filled.amplification[0] / expected - 1.0).abs() < 5e-3, "{:?} {expected}", filled.amplification);
        assert_eq!(filled.warnings.len(), usize::from(expected > 50.0));
    }
}

#[test]
fn moved_layer_bulges_the_net_by_the_amplification_and_no_more() {
    let knots = KnotVector::clamped_uniform(3, 11).expect("knots");
    let layers = random_points(1, 121);
    let before = fill(&knots, &knots, &layers).expect("a net");
    let mut moved = layers;
    // Layer 1 of u, away from the layers of v.
    moved[11 + 5][2] += 1e-3;
    let after = fill(&knots, &knots, &moved).expect("a net");
    let bulge = largest_distance(before.surface.net(), after.surface.net()) / 1e-3;
    assert!(bulge > 0.4 * before.amplification[0] && bulge <= before.amplification[0], "{bulge}");
}

#[test]
fn nets_that_cannot_be_filled_are_refused_with_the_reason() {
    let good = || KnotVector::clamped_uniform(3, 6).expect("knots");
    let points = random_points(1, 36);
    let refused = |u: &KnotVector, v: &KnotVector, points: &[[f64; 3]]| fill(u, v, points).expect_err("refused");
    let found = refused(&good(), &good(), &points[..35]);
    assert_eq!(
        (found.code, found.message.as_str()),
        (Code::NetSize, "the knots belong to a net of 6 x 6 points, and 35 are given")
    );
    let repeated = KnotVector::new(3, vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0]).expect("knots");
    let found = refused(&good(), &repeated, &points);
    assert_eq!(
        (found.code, found.message.as_str()),
        (Code::KnotRepeated, "the knot 1 of v stands 2 times inside the net")
    );
    let quadratic = KnotVector::clamped_uniform(2, 6).expect("knots");
    assert_eq!(refused(&quadratic, &good(), &points).code, Code::SettingOutOfRange);
    let mut holed = points.clone();
    holed[6 + 3][2] = f64::NAN;
    let found = refused(&good(), &good(), &holed);
    assert_eq!(found.code, Code::PointNotFinite);
    assert!(found.message.contains("P(1, 3)"), "{found}");
    // Three points do not make a cubic.
    assert_eq!(KnotVector::clamped_uniform(3, 3).expect_err("n = 2").code, Code::KnotsNotAscending);
    let huge: Vec<[f64; 3]> = points.iter().map(|point| point.map(|x| x * 1e308)).collect();
    assert_eq!(refused(&good(), &good(), &huge).code, Code::SolutionNotFinite);
}
