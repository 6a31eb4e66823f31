//! Outlines filled with four patches, strips with rings of two: the smoothness where patches meet.

use trimline::diagnostic::Code;
use trimline::net::{Outline, Ring, Strip, quarter, ring};
use trimline::surface::{BsplineCurve, KnotVector};

use crate::bspline::{distance, places, random, random_points};
use crate::spec::at;

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
