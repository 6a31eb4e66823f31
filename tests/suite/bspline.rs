//! B-spline curves and surfaces: values, derivatives, and the operations that leave them as they are.

use trimline::diagnostic::Code;
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::surface::bspline::{LARGEST_DEGREE, from_json, to_json};
use trimline::surface::{BsplineCurve, BsplineSurface, KnotVector, Surface};

use crate::spec::at;

/// Numbers in [-1, 1] that are the same in every run: a linear congruence, from `seed`.
pub fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

pub fn random_points(seed: u64, count: usize) -> Vec<[f64; 3]> {
    let mut next = random(seed);
    (0..count).map(|_| [next(), next(), next()]).collect()
}

/// Knots with random steps from 0.3 to 1.7, not clamped.
pub fn random_knots(seed: u64, degree: usize, points: usize) -> KnotVector {
    let mut next = random(seed);
    let mut knot = -1.0;
    let step = |_| {
        knot += 1.0 + 0.7 * next();
        knot
    };
    KnotVector::new(degree, (0..points + degree + 1).map(step).collect()).expect("knots")
}

pub fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    p.iter().zip(q).fold(0.0_f64, |most, (p, q)| most.max((p - q).abs()))
}

pub fn surface(seed: u64, degrees: [usize; 2], points: [usize; 2]) -> BsplineSurface {
    let [u, v] = [0, 1].map(|axis| random_knots(seed + axis as u64, degrees[axis], points[axis]));
    BsplineSurface::new(u, v, random_points(seed + 2, points[0] * points[1])).expect("a surface")
}

/// Points inside, on knots, and at the ends of a domain.
pub fn places(knots: &KnotVector) -> Vec<f64> {
    let breakpoints = knots.breakpoints();
    let inside = breakpoints.windows(2).flat_map(|span| [0.21, 0.5, 0.83].map(|x| span[0] + x * (span[1] - span[0])));
    inside.chain(breakpoints.iter().copied()).collect()
}

/// The definition, by recursion on the degree, with 0/0 = 0: slow, and independent of the evaluation under test.
pub fn cox_de_boor(knots: &[f64], index: usize, degree: usize, order: usize, x: f64) -> f64 {
    let ratio = |a: f64, b: f64| if b == 0.0 { 0.0 } else { a / b };
    let (low, high) = (knots[index + degree] - knots[index], knots[index + degree + 1] - knots[index + 1]);
    if order > 0 {
        let before = cox_de_boor(knots, index, degree - 1, order - 1, x);
        let behind = cox_de_boor(knots, index + 1, degree - 1, order - 1, x);
        return degree as f64 * (ratio(before, low) - ratio(behind, high));
    }
    if degree == 0 {
        return if knots[index] <= x && x < knots[index + 1] { 1.0 } else { 0.0 };
    }
    let rising = ratio(x - knots[index], low) * cox_de_boor(knots, index, degree - 1, 0, x);
    let falling = ratio(knots[index + degree + 1] - x, high) * cox_de_boor(knots, index + 1, degree - 1, 0, x);
    rising + falling
}

#[test]
fn curve_and_its_derivatives_are_the_sum_of_the_recursive_definition() {
    for degree in 1..=LARGEST_DEGREE {
        let knots = random_knots(7, degree, 9);
        let points = random_points(8, 9);
        let curve = BsplineCurve::new(knots.clone(), points.clone()).expect("a curve");
        let end = knots.domain()[1];
        for x in places(&knots).into_iter().filter(|x| *x < end) {
            for order in 0..=degree {
                let mut expected = [0.0; 3];
                for (index, point) in points.iter().enumerate() {
                    let value = cox_de_boor(knots.as_slice(), index, degree, order, x);
                    (0..3).for_each(|axis| expected[axis] += value * point[axis]);
                }
                let found = curve.derivative(order, x);
                // Steps of 0.3 or more: derivatives of order 5 have terms up to 5!/0.3^5 = 5e4 times the points.
                let size = [1.0, 20.0, 3e2, 4e3, 3e4, 6e4][order];
                assert!(distance(found, expected) <= 64.0 * f64::EPSILON * size, "{degree} {order} {x}");
            }
        }
    }
}

#[test]
fn grid_and_points_of_a_surface_agree() {
    let surface = surface(11, [3, 2], [6, 7]);
    let [u, v] = surface.knots().map(places);
    for derivative in ["", "u", "v", "uv", "uuuvv", "t", "uuuu"].map(|text| Derivative::parse(text).expect("orders")) {
        let mut grid = vec![[f64::NAN; 3]; u.len() * v.len()];
        surface.evaluate_grid(derivative, (&u, &v, 0.4), &mut grid).expect("finite");
        for (i, u) in u.iter().enumerate() {
            for (j, v) in v.iter().enumerate() {
                let mut value = [[f64::NAN; 3]];
                surface.evaluate(derivative, &[[*u, *v, 0.4]], &mut value).expect("finite");
                // Third derivatives reach about 5e2; the sums are taken in another order.
                assert!(distance(grid[i * v_len(&surface) + j], value[0]) <= 1e-12, "{derivative} {u} {v}");
            }
        }
        if derivative.t > 0 || derivative.u > 3 {
            assert!(grid.iter().all(|value| *value == [0.0; 3]), "{derivative}");
        }
    }
}

fn v_len(surface: &BsplineSurface) -> usize {
    places(surface.knots()[1]).len()
}

/// The largest distance between two surfaces, of which the second takes other parameters.
fn largest_gap(one: &BsplineSurface, other: &BsplineSurface, map: impl Fn(f64, f64) -> [f64; 2]) -> f64 {
    let [u, v] = one.knots().map(places);
    let mut most = 0.0_f64;
    for &u in &u {
        for &v in &v {
            let [p, q] = map(u, v);
            most = most.max(distance(at(one, "", [u, v, 0.0]), at(other, "", [p, q, 0.0])));
        }
    }
    most
}

#[test]
fn clamping_turning_and_exchanging_leave_the_surface_where_it_is() {
    for degree in 1..=LARGEST_DEGREE {
        let one = surface(3, [degree, 6 - degree], [8, 7]);
        let clamped = one.clamped();
        assert!(clamped.knots().iter().all(|knots| knots.is_clamped()));
        assert_eq!(clamped.net().len(), one.net().len(), "clamping moves points, and adds none");
        assert_eq!(clamped.domain(), one.domain());
        // Convex combinations: a few roundings of coordinates up to 1 for each inserted knot.
        assert!(largest_gap(&one, &clamped, |u, v| [u, v]) <= 64.0 * f64::EPSILON);
        assert!(largest_gap(&one, &one.reversed_u(), |u, v| [-u, v]) <= 16.0 * f64::EPSILON);
        assert!(largest_gap(&one, &one.reversed_v(), |u, v| [u, -v]) <= 16.0 * f64::EPSILON);
        assert!(largest_gap(&one, &one.transposed(), |u, v| [v, u]) <= 16.0 * f64::EPSILON);
        assert_eq!(one.transposed().transposed(), one);
        assert_eq!(one.reversed_u().reversed_u(), one);
    }
}

#[test]
fn corner_points_of_a_clamped_net_are_the_corners() {
    let surface = surface(5, [3, 4], [6, 8]).clamped();
    let [[u0, u1], [v0, v1]] = surface.domain();
    let columns = surface.knots()[1].points();
    for (corner, index) in [([u0, v0], 0), ([u0, v1], columns - 1), ([u1, v1], surface.net().len() - 1)] {
        assert_eq!(at(&surface, "", [corner[0], corner[1], 0.0]), surface.net()[index]);
    }
}

#[test]
fn halves_of_a_split_curve_are_the_curve() {
    for degree in 1..=LARGEST_DEGREE {
        let knots = random_knots(20, degree, 9);
        let curve = BsplineCurve::new(knots.clone(), random_points(21, 9)).expect("a curve");
        let inner = knots.breakpoints();
        // Between two knots, and on one.
        for place in [0.5 * (inner[1] + inner[2]), inner[2]] {
            let [before, behind] = curve.split(place).expect("inside");
            assert_eq!(before.knots().domain(), [knots.domain()[0], place]);
            assert_eq!(behind.knots().domain(), [place, knots.domain()[1]]);
            assert_eq!(before.points().last(), behind.points().first());
            for half in [&before, &behind] {
                assert!(half.knots().is_clamped());
                for x in places(half.knots()) {
                    assert!(distance(half.derivative(0, x), curve.derivative(0, x)) <= 64.0 * f64::EPSILON, "{x}");
                }
            }
        }
    }
}

#[test]
fn curve_is_not_split_at_its_end() {
    let curve =
        BsplineCurve::new(KnotVector::clamped_uniform(3, 5).expect("knots"), random_points(1, 5)).expect("a curve");
    for place in [0.0, 2.0, -1.0, f64::NAN] {
        assert_eq!(curve.split(place).expect_err("no inner place").code, Code::PointOutsideDomain);
    }
}

#[test]
fn point_outside_the_domain_is_refused() {
    let surface = surface(3, [3, 3], [5, 5]);
    let [[u0, _], [_, v1]] = surface.domain();
    for point in [[u0 - 1e-9, v1, 0.0], [u0, v1 + 1e-9, 0.0], [f64::NAN, v1, 0.0]] {
        let found = surface.evaluate(Derivative::NONE, &[point], &mut [[0.0; 3]]).expect_err("outside");
        assert_eq!(found.code, Code::PointOutsideDomain);
        let grid = (&[point[0]][..], &[point[1]][..], 0.0);
        let found = surface.evaluate_grid(Derivative::NONE, grid, &mut [[0.0; 3]]).expect_err("outside");
        assert_eq!(found.code, Code::PointOutsideDomain);
    }
}

#[test]
fn net_of_the_wrong_size_and_with_infinity_is_refused() {
    let knots = || KnotVector::clamped_uniform(3, 4).expect("knots");
    let found = BsplineSurface::new(knots(), knots(), vec![[0.0; 3]; 15]).expect_err("15 points");
    assert_eq!(
        (found.code, found.message.as_str()),
        (Code::NetSize, "the knots belong to a net of 4 x 4 points, and 15 are given")
    );
    let mut net = vec![[0.0; 3]; 16];
    net[6][1] = f64::INFINITY;
    let found = BsplineSurface::new(knots(), knots(), net).expect_err("not finite");
    assert_eq!(
        (found.code, found.message.as_str()),
        (Code::PointNotFinite, "the control point P(1, 2) is [0, inf, 0]")
    );
    let found = BsplineCurve::new(knots(), vec![[0.0; 3]; 5]).expect_err("5 points");
    assert_eq!(found.code, Code::NetSize);
}

#[test]
fn json_reads_back_bit_for_bit() {
    let (one, other) = (surface(31, [3, 5], [5, 9]), surface(32, [1, 2], [2, 3]));
    let text = to_json(&[("left \"wing\"\n", &one), ("α", &other)]).expect("finite");
    let read = from_json(&text, &Limits::default()).expect("what was written");
    assert_eq!(read, [("left \"wing\"\n".to_owned(), one), ("α".to_owned(), other)]);
}

#[test]
fn json_that_is_no_surface_is_refused_with_its_reason() {
    let text = to_json(&[("part", &surface(31, [3, 3], [4, 4]))]).expect("finite");
    let refused = |text: &str| from_json(text, &Limits::default()).expect_err(text);
    for (broken, code, words) in [
        (text[..text.len() / 2].to_owned(), Code::BadSplineFile, "line 1 column"),
        (text.replace("knots_u", "knotsu"), Code::BadSplineFile, "missing field `knots_u`"),
        (format!("{{\"x\":{}", "[".repeat(100_000)), Code::BadSplineFile, "line 1 column 100005"),
        (text.replace("\"degree\":[3,3]", "\"degree\":[3,2]"), Code::NetSize, "patch `part`: row 0 of the net has 4"),
        (text.replace("\"degree\":[3,3]", "\"degree\":[9,3]"), Code::KnotsNotAscending, "patch `part`: the degree"),
        (text.replacen("\"knots_u\":[", "\"knots_u\":[1e9,", 1), Code::KnotsNotAscending, "descend"),
    ] {
        let found = refused(&broken);
        assert_eq!(found.code, code, "{found}");
        assert!(found.message.contains(words), "{found}");
    }
    let limits = Limits { control_points: 15, ..Limits::default() };
    let found = from_json(&text, &limits).expect_err("16 points");
    assert_eq!(found.code, Code::LimitReached);
    assert!(found.message.contains("control-points"), "{found}");
}
