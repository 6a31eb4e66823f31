//! Filled nets against references, exact arithmetic and a solver; the smoothness of joined patches.

use nalgebra::DMatrix;
use serde_json::Value;

use trimline::diagnostic::Code;
use trimline::net::{Filled, Outline, Ring, Strip, fill, quarter, ring};
use trimline::surface::{BsplineCurve, BsplineSurface, KnotVector};

use crate::bspline::{distance, places, random, random_knots, random_points};
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

fn clamped_curve(breakpoints: &[f64], points: Vec<[f64; 3]>) -> BsplineCurve {
    BsplineCurve::new(KnotVector::clamped(3, breakpoints).expect("knots"), points).expect("a curve")
}

/// Four wavy curves around a square, with unequal knots.
fn outline() -> Outline {
    let knots = [vec![0.0, 0.5, 1.0, 1.6, 2.0, 3.0], vec![0.0, 1.0, 1.5, 2.0]];
    let along = |axis: usize, seed: u64, place: &dyn Fn(f64) -> [f64; 3]| {
        let curve = KnotVector::clamped(3, &knots[axis]).expect("knots");
        let mut next = random(seed);
        let count = curve.points();
        let inner = |index: usize| index > 0 && index + 1 < count;
        let points = curve.greville().into_iter().enumerate().map(|(index, x)| {
            let [a, b, c] = place(x);
            if inner(index) { [a + 0.2 * next(), b + 0.2 * next(), c + 0.5 * next()] } else { [a, b, c] }
        });
        clamped_curve(&knots[axis], points.collect())
    };
    Outline {
        along_u: [along(0, 1, &|u| [u, 0.0, 0.0]), along(0, 2, &|u| [u, 2.0, 0.3 * u])],
        along_v: [along(1, 3, &|v| [0.0, v, 0.0]), along(1, 4, &|v| [3.0, v, 0.45 * v])],
    }
}

fn as_it_is(_: usize, _: usize, coons: [f64; 3]) -> [f64; 3] {
    coons
}

fn lifted(i: usize, j: usize, [x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, y, z + 0.3 * (i % 3) as f64 - 0.4 * (j % 2) as f64]
}

#[test]
fn four_patches_with_nothing_moved_are_the_coons_surface() {
    let outline = outline();
    let patches = quarter(&outline, [1.6, 0.8], &as_it_is).expect("four patches");
    let curve = |curves: &[BsplineCurve; 2], end: usize, x: f64| curves[end].derivative(0, x);
    for surface in patches.iter().map(|part| &part.surface) {
        for u in places(surface.knots()[0]) {
            for v in places(surface.knots()[1]) {
                let (s, t) = (u / 3.0, v / 2.0);
                let expected = [0, 1, 2].map(|axis| {
                    let along_v = |end: usize, v: f64| curve(&outline.along_v, end, v)[axis];
                    let along_u = |end: usize| curve(&outline.along_u, end, u)[axis];
                    let corners = (1.0 - t) * ((1.0 - s) * along_v(0, 0.0) + s * along_v(1, 0.0))
                        + t * ((1.0 - s) * along_v(0, 2.0) + s * along_v(1, 2.0));
                    (1.0 - s) * along_v(0, v) + s * along_v(1, v) + (1.0 - t) * along_u(0) + t * along_u(1) - corners
                });
                // Amplification of about 5 in both directions, times some roundings of 3.
                assert!(distance(at(surface, "", [u, v, 0.0]), expected) <= 1e-13, "{u} {v}");
            }
        }
    }
}

#[test]
fn four_patches_meet_the_outline_and_each_other_with_equal_tangents() {
    let outline = outline();
    // On a knot in u, between knots in v.
    let split = [1.6, 0.8];
    let [low_low, low_high, high_low, high_high] =
        quarter(&outline, split, &lifted).expect("four patches").map(|part| part.surface);
    for (patch, curve, fixed) in [
        (&low_low, &outline.along_u[0], [None, Some(0.0)]),
        (&high_high, &outline.along_u[1], [None, Some(2.0)]),
        (&low_high, &outline.along_v[0], [Some(0.0), None]),
        (&high_low, &outline.along_v[1], [Some(3.0), None]),
    ] {
        let along = patch.knots()[usize::from(fixed[0].is_some())];
        for x in places(along) {
            let point = [fixed[0].unwrap_or(x), fixed[1].unwrap_or(x), 0.0];
            // Rounding of inserted knots; coordinates reach 3.
            assert!(distance(at(patch, "", point), curve.derivative(0, x)) <= 1e-14, "{x}");
        }
    }
    let mut largest_jump = 0.0_f64;
    for (one, other, axis) in
        [(&low_low, &high_low, 0), (&low_high, &high_high, 0), (&low_low, &low_high, 1), (&high_low, &high_high, 1)]
    {
        for x in places(one.knots()[1 - axis]) {
            let point = if axis == 0 { [split[0], x, 0.0] } else { [x, split[1], 0.0] };
            assert!(distance(at(one, "", point), at(other, "", point)) <= 1e-14, "gap at {point:?}");
            let across = ["u", "v"][axis];
            // Net points of size 5, over steps of 0.3.
            let crease = distance(at(one, across, point), at(other, across, point));
            assert!(crease <= 1e-12, "{crease:.1e} at {point:?}");
            let second = ["uu", "vv"][axis];
            largest_jump = largest_jump.max(distance(at(one, second, point), at(other, second, point)));
        }
    }
    assert!(largest_jump > 0.1, "C1 and no more: {largest_jump}");
}

#[test]
fn four_patches_of_a_plane_outline_are_the_plane() {
    let square = |knots: &[f64], place: &dyn Fn(f64) -> [f64; 3]| {
        let greville = KnotVector::clamped(3, knots).expect("knots").greville();
        clamped_curve(knots, greville.into_iter().map(place).collect())
    };
    let (u, v) = ([0.0, 1.0, 4.0], [0.0, 1.0, 2.0]);
    let outline = Outline {
        along_u: [0.0, 2.0].map(|v| square(&u, &move |u| [u, v, u - v])),
        along_v: [0.0, 4.0].map(|u| square(&v, &move |v| [u, v, u - v])),
    };
    for patch in quarter(&outline, [1.5, 0.5], &as_it_is).expect("four patches") {
        for x in places(patch.surface.knots()[0]) {
            for y in places(patch.surface.knots()[1]) {
                assert!(distance(at(&patch.surface, "", [x, y, 0.0]), [x, y, x - y]) <= 1e-14, "{x} {y}");
            }
        }
    }
}

#[test]
fn outlines_that_do_not_meet_are_refused_with_the_corner() {
    let mut open = outline();
    let mut points = open.along_v[1].points().to_vec();
    points.last_mut().expect("points")[0] += 0.1;
    open.along_v[1] = BsplineCurve::new(open.along_v[1].knots().clone(), points).expect("a curve");
    let found = quarter(&open, [1.6, 0.8], &as_it_is).expect_err("a corner is open");
    assert_eq!(found.code, Code::CurvesDoNotMeet);
    assert_eq!(found.message, "at the end of u and the end of v the boundary curves are 1.0e-1 apart");
    let mut unlike = outline();
    unlike.along_u[1] = unlike.along_u[1].reversed();
    assert_eq!(quarter(&unlike, [1.6, 0.8], &as_it_is).expect_err("other knots").code, Code::CurvesDoNotMeet);
    assert_eq!(quarter(&outline(), [3.0, 0.8], &as_it_is).expect_err("no inner place").code, Code::PointOutsideDomain);
}

/// A closed curve: random points, of which the last two continue in the first two.
fn closed_curve(seed: u64, radius: f64, height: f64) -> BsplineCurve {
    let breakpoints = [0.0, 1.0, 2.0, 3.5, 5.0, 6.0];
    let knots = KnotVector::clamped(3, &breakpoints).expect("knots");
    let mut next = random(seed);
    let turn = |x: f64| (x / 6.0 * std::f64::consts::TAU).sin_cos();
    let mut points: Vec<[f64; 3]> = knots
        .greville()
        .into_iter()
        .map(|x| [radius * turn(x).1 + 0.1 * next(), radius * turn(x).0 + 0.1 * next(), height + 0.1 * next()])
        .collect();
    let count = points.len();
    // Equal first and last spans: the closing point is the mean of its neighbours.
    let closing = [0, 1, 2].map(|axis| 0.5 * (points[1][axis] + points[count - 2][axis]));
    (points[0], points[count - 1]) = (closing, closing);
    clamped_curve(&breakpoints, points)
}

fn strip() -> Strip {
    Strip {
        across: KnotVector::clamped(3, &[0.0, 0.4, 1.0, 2.0]).expect("knots"),
        layers: [closed_curve(1, 1.0, 0.0), closed_curve(2, 1.3, 0.2), closed_curve(3, 2.0, 2.0)],
        split: 2.5,
        beside_first_seam: Some([random_points(4, 6), random_points(5, 6)]),
        second_seam: None,
    }
}

/// The largest differences of position and of the tangent around, at the first and at the second seam.
fn seams(ring: &Ring, split: f64) -> [[f64; 2]; 2] {
    let [first, second] = ring.patches.each_ref().map(|part| &part.surface);
    [(0.0, 6.0), (split, split)].map(|(v, w)| {
        ["", "v"].map(|derivative| {
            let gap = |u: f64| distance(at(first, derivative, [u, v, 0.0]), at(second, derivative, [u, w, 0.0]));
            places(first.knots()[0]).into_iter().map(gap).fold(0.0, f64::max)
        })
    })
}

#[test]
fn ring_with_its_second_seam_left_open_is_smooth_at_both() {
    let ring = ring(&strip()).expect("a ring");
    for [gap, crease] in seams(&ring, 2.5) {
        assert!(gap <= 1e-14 && crease <= 1e-13, "{gap:.1e} {crease:.1e}");
    }
    assert!(ring.crease <= 1e-13, "{}", ring.crease);
    assert_eq!(ring.warnings, []);
}

#[test]
fn ring_meets_its_outer_layers() {
    let strip = strip();
    let ring = ring(&strip).expect("a ring");
    for part in &ring.patches {
        for v in places(part.surface.knots()[1]) {
            for (layer, u) in [(0, 0.0), (2, 2.0)] {
                let expected = strip.layers[layer].derivative(0, v);
                assert!(distance(at(&part.surface, "", [u, v, 0.0]), expected) <= 1e-14, "{v}");
            }
        }
    }
}

#[test]
fn ring_whose_seams_differ_by_no_quadratic_is_creased_and_says_by_how_much() {
    let smooth = ring(&strip()).expect("a ring");
    let columns = smooth.patches[0].surface.knots()[1].points();
    let mut seam: Vec<[f64; 3]> =
        smooth.patches[0].surface.net().iter().skip(columns - 1).step_by(columns).copied().collect();
    let given = Strip { second_seam: Some(seam.clone()), ..strip() };
    assert_eq!(ring(&given).expect("a ring").warnings, [], "the smooth seam, given");
    seam[3][2] += 0.1;
    let creased = ring(&Strip { second_seam: Some(seam), ..strip() }).expect("a ring");
    assert_eq!(creased.warnings.iter().map(|finding| finding.code).collect::<Vec<_>>(), [Code::SeamCreased]);
    let [[first_gap, first_crease], [gap, crease]] = seams(&creased, 2.5);
    assert!(
        first_gap <= 1e-14 && first_crease <= 1e-13 && gap <= 1e-14,
        "{first_gap:.1e} {first_crease:.1e} {gap:.1e}"
    );
    assert!(crease > 0.01, "the tangents differ: {crease}");
    assert!(creased.crease > 0.01 && creased.crease < 0.1, "{}", creased.crease);
}

#[test]
fn ring_with_default_seams_is_smooth() {
    let ring = ring(&Strip { beside_first_seam: None, ..strip() }).expect("a ring");
    assert!(seams(&ring, 2.5).iter().all(|[gap, crease]| *gap <= 1e-14 && *crease <= 1e-13));
    assert_eq!(ring.warnings, []);
}

#[test]
fn strips_that_are_none_are_refused_with_the_reason() {
    let mut open = strip();
    let mut points = open.layers[1].points().to_vec();
    points[0][0] += 0.01;
    open.layers[1] = BsplineCurve::new(open.layers[1].knots().clone(), points).expect("a curve");
    let found = ring(&open).expect_err("layer 1 is open");
    assert_eq!(found.code, Code::CurvesDoNotMeet);
    assert!(found.message.starts_with("layer 1 does not close: the position"), "{found}");
    let mut kinked = strip();
    let mut points = kinked.layers[2].points().to_vec();
    points[1][0] += 0.01;
    kinked.layers[2] = BsplineCurve::new(kinked.layers[2].knots().clone(), points).expect("a curve");
    let found = ring(&kinked).expect_err("layer n has a corner");
    assert!(found.message.starts_with("layer n does not close: the tangent"), "{found}");
    let short = Strip { second_seam: Some(random_points(1, 5)), ..strip() };
    assert_eq!(ring(&short).expect_err("5 points").code, Code::NetSize);
    let line = |seed| {
        BsplineCurve::new(KnotVector::clamped(1, &[0.0, 1.0]).expect("knots"), vec![random_points(seed, 1)[0]; 2])
    };
    let straight = Strip { layers: [1, 2, 3].map(|seed| line(seed).expect("a curve")), split: 0.5, ..strip() };
    assert_eq!(ring(&straight).expect_err("degree 1").code, Code::SettingOutOfRange);
}
