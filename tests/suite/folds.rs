//! Patches that fold back over themselves are warned of, and nothing else is.

use std::f64::consts::TAU;

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Source};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::problem::{Bindings, DomainValues};
use trimline::surface::SymbolicSurface;
use trimline::verify::find_fold;

use crate::spec::{NAME, all_examples, at, data_file, problem, told};

fn blend(text: &str) -> Blend {
    let compiled = Blend::compile_with(&Source::new(NAME, text), data_file, &Options::default());
    compiled.unwrap_or_else(|found| panic!("{text}\n{}", told(text, &found)))
}

/// A loop of lines between `corners`, which rise by `rise` in their middles, with more statements.
fn polygon(corners: &[[f64; 3]], rise: f64, more: &str) -> String {
    let following = corners.iter().cycle().skip(1);
    let line = |(from, to): (&[f64; 3], &[f64; 3])| {
        let [x, y, z] = [0, 1, 2].map(|axis| format!("{:?} + ({:?}) u", from[axis], to[axis] - from[axis]));
        format!("    edge [{x}, {y}, {z} + {:?} u (1 - u)]\n", 4.0 * rise)
    };
    format!("nsided hole {{\n{}{more}}}\n", corners.iter().zip(following).map(line).collect::<String>())
}

/// Corners at equal angles, every second one `share` as far from the middle as the others.
fn star(count: usize, share: f64) -> Vec<[f64; 3]> {
    let corner = |index: usize| {
        let (angle, radius) = (TAU * index as f64 / count as f64, if index.is_multiple_of(2) { 1.0 } else { share });
        [radius * angle.cos(), radius * angle.sin(), 0.0]
    };
    (0..count).map(corner).collect()
}

/// Numbers, from 1, of the patches that are warned of.
fn folded(text: &str) -> Vec<usize> {
    let blend = blend(text);
    let is_warned = |index: &usize| {
        let solution = blend.solve(*index, 0.0).unwrap_or_else(|finding| panic!("{text}\n{finding}"));
        solution.report.warnings.iter().any(|warning| warning.code == Code::PatchFolded)
    };
    (0..blend.patches.len()).filter(is_warned).map(|index| index + 1).collect()
}

/// Whether the polygon turns right in a corner, where the sides of a patch cannot but cross over.
fn is_reflex(corners: &[[f64; 3]], index: usize) -> bool {
    let count = corners.len();
    let [before, here, behind] = [index + count - 1, index, index + 1].map(|index| corners[index % count]);
    (here[0] - before[0]) * (behind[1] - here[1]) - (here[1] - before[1]) * (behind[0] - here[0]) < 0.0
}

const BRACKET: [[f64; 3]; 6] =
    [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 2.0, 0.0]];

#[test]
fn patch_at_a_corner_wider_than_half_a_turn_is_warned_of() {
    let dart = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    let mut shapes = vec![BRACKET.to_vec(), dart.to_vec()];
    shapes.extend([(6, 0.4), (8, 0.6), (10, 0.7), (12, 0.75)].map(|(count, share)| star(count, share)));
    // A hexagon with a corner pushed in, until it is that many degrees too wide.
    shapes.extend([1.0_f64, 3.0, 30.0].map(|degrees| {
        let mut corners = star(6, 1.0);
        corners[0][0] = 0.5 - 0.75_f64.sqrt() * (degrees.to_radians() / 2.0).tan();
        corners
    }));
    for corners in shapes {
        let reflex: Vec<usize> =
            (0..corners.len()).filter(|index| is_reflex(&corners, *index)).map(|i| i + 1).collect();
        assert!(!reflex.is_empty(), "{corners:?}");
        assert_eq!(folded(&polygon(&corners, 0.0, "")), reflex, "{corners:?}");
    }
    // So narrow that the patches beside the corners fold too.
    assert_eq!(folded(&polygon(&star(8, 0.2), 0.0, "")).len(), 8);
}

#[test]
fn fold_of_a_loop_in_space_is_warned_of_with_its_place() {
    let lifted = BRACKET.map(|[x, y, _]| [x, y, 0.15 * x * y + 0.1 * x]);
    let text = polygon(&lifted, 0.025, "");
    assert_eq!(folded(&text), [4]);
    let solution = blend(&text).solve(3, 0.0).expect("a surface");
    let [warning] = solution.report.warnings.as_slice() else { panic!("{:?}", solution.report.warnings) };
    let message = &warning.message;
    assert!(message.starts_with("`hole.4` folds back over itself near u = "), "{message}");
    // Seen from above, the patch runs clockwise at its corner and anticlockwise in the centre.
    let area = |u: f64, v: f64| {
        let [a, b] = ["u", "v"].map(|order| at(&*solution.surface, order, [u, v, 0.0]));
        a[0] * b[1] - a[1] * b[0]
    };
    assert!(area(0.0, 0.0) < 0.0 && area(1.0, 1.0) > 0.0);
    let number = |name: &str| -> f64 {
        let (_, rest) = message.split_once(&format!("{name} = ")).expect(message);
        rest.split([',', ' ']).next().and_then(|number| number.parse().ok()).expect(message)
    };
    assert!(area(number("u"), number("v")).abs() < 0.1 * area(1.0, 1.0), "{message}");
}

#[test]
fn loops_without_wide_corners_are_not_warned_of() {
    for count in 3..=12 {
        let even = star(count, 1.0);
        let long: Vec<_> = even.iter().map(|[x, y, z]| [2.0 * x, *y, *z]).collect();
        let waving: Vec<_> =
            even.iter().zip(0..).map(|([x, y, _], k)| [*x, *y, if k % 2 == 0 { 0.4 } else { -0.4 }]).collect();
        for text in [
            polygon(&even, 0.0, ""),
            polygon(&even, 0.125, ""),
            polygon(&even, 0.0, "    centre = [0, 0, 1]\n"),
            polygon(&long, 0.0, ""),
            polygon(&waving, 0.0, ""),
        ] {
            assert_eq!(folded(&text), [0; 0], "{text}");
        }
        // Arcs of one circle: in every corner the sides run on into each other.
        let arc =
            |index: usize| format!("    edge [cos(2π (u + {index})/{count}), sin(2π (u + {index})/{count}), 0]\n");
        let round = format!("nsided hole {{\n{}}}\n", (0..count).map(arc).collect::<String>());
        assert_eq!(folded(&round), [0; 0], "{round}");
    }
}

#[test]
fn no_example_is_warned_of() {
    let mut judged = 0;
    for (name, text) in all_examples() {
        let blend = blend(&text);
        for (index, prepared) in blend.patches.iter().enumerate() {
            if prepared.patch().side_conditions.is_empty() {
                continue;
            }
            for t in prepared.domain.t {
                let solution = blend.solve(index, t).unwrap_or_else(|finding| panic!("{name}: {finding}"));
                let is_fold = |warning: &trimline::diagnostic::Diagnostic| warning.code == Code::PatchFolded;
                assert!(!solution.report.warnings.iter().any(is_fold), "{name}, {index}");
                judged += 1;
            }
        }
    }
    assert!(judged > 10, "{judged}");
}

#[test]
fn tangents_that_lead_out_of_a_patch_fold_it() {
    let square = |slope: &str| {
        format!(
            "domain v in [0, 1]
at u = 0: S = [0, v, 0], ∂S/∂u = [{slope}, 0, 0]
at u = 1: S = [1, v, 0], ∂S/∂u = [{slope}, 0, 0]
at v = 0: S = [3 u^2 - 2 u^3 + ({slope}) (u - 3 u^2 + 2 u^3), 0, 0], ∂S/∂v = [0, 1, 0]
at v = 1: S = [3 u^2 - 2 u^3 + ({slope}) (u - 3 u^2 + 2 u^3), 1, 0], ∂S/∂v = [0, 1, 0]\n"
        )
    };
    assert_eq!(folded(&square("1")), [0; 0]);
    assert_eq!(folded(&square("-0.5")), [1]);
}

/// Where `[x, y, z]`, a function of u and v over the square from -1 to 1, folds.
fn fold_of(position: &str, is_of_loop: bool) -> Option<[f64; 2]> {
    let problem = problem(&format!(
        "surface X(u, v) = {position}\ndomain v in [-1, 1]\nat u = 0: S = X(0, v), ∂S/∂u = 0\nat u = 1: S = X(1, v), ∂S/∂u = 0\n"
    ));
    let (bindings, limits) = (Bindings::evaluate(&problem).expect("numbers"), Limits::default());
    let surface = SymbolicSurface::new(&problem, &problem.surfaces[0], &bindings, &limits);
    let domain = DomainValues { u: [-1.0, 1.0], v: [-1.0, 1.0], t: [0.0, 1.0] };
    find_fold(&surface, (&domain, 0.0), is_of_loop).expect("values")
}

#[test]
fn folds_are_found_where_they_are() {
    // u = 0.3, a parabola, and a fold as round as a hair.
    for (text, is_of_loop) in [
        ("[(u - 0.3)^2, v, 0]", false),
        ("[(u - 0.3)^2, v, 0.0001 (u - 0.3)]", false),
        ("[(u - 0.3)^2, v, 0.01 (u - 0.3)]", true),
        ("[(u - 0.3)^2, v + u, 0]", false),
    ] {
        let [u, _] = fold_of(text, is_of_loop).expect(text);
        // Where the length, |u - 0.3|, is a tenth of the usual.
        assert!((u - 0.3).abs() < 0.1, "{text}: {u}");
    }
}

#[test]
fn bends_points_and_creases_are_no_folds() {
    for text in [
        // A ridge that turns by 157 degrees, as sharp as a thousandth.
        "[u, v, 5 sqrt(u^2 + 0.000001)]",
        // A sheet that turns round smoothly, and one that is rolled up.
        "[sin(3u), v, cos(3u)]",
        "[sin(30u), v, cos(30u)]",
        // A pole, and a side that is a point.
        "[sin((u + 1)/2) cos(2v), sin((u + 1)/2) sin(2v), cos((u + 1)/2)]",
        "[(u + 1)^2 cos(v), (u + 1)^2 sin(v), u + 1]",
        // Nothing but a curve, and a point.
        "[u, 2u, 0 v]",
        "[0 u, 1, 0 v]",
    ] {
        assert_eq!(fold_of(text, false), None, "{text}");
        assert_eq!(fold_of(text, true), None, "{text}");
    }
}

#[test]
fn slender_crests_of_stated_sides_are_no_folds() {
    for text in [
        // Parabolas and waves of slopes from 4 to 500, an ellipse and a hair as thin as a hundredth.
        "[u, v, 2u^2]",
        "[u, v, 10 u^2]",
        "[u, v, 250 u^2]",
        "[u, v, 5 sin(2π u)]",
        "[12 sin(π u/2), v, cos(π u/2)]",
        "[(u - 0.3)^2, v, 0.01 (u - 0.3)]",
        // Lines of constant u shrink to a point and open again: a double cone.
        "[(u - 0.1) cos(v), (u - 0.1) sin(v), u]",
    ] {
        assert_eq!(fold_of(text, false), None, "{text}");
    }
    // The leading edge of a blade, 12 % as thick as it is long, and an arch with slopes up to 20.
    for (curve, start, end) in [
        ("1 - sin(π v), 0.06 cos(π v)", "[1, 0.06, 2u], ∂S/∂v = [-π, 0, 0]", "[1, -0.06, 2u], ∂S/∂v = [π, 0, 0]"),
        ("20 v (1 - v), 0.5 - v", "[0, 0.5, 2u], ∂S/∂v = [20, -1, 0]", "[0, -0.5, 2u], ∂S/∂v = [-20, -1, 0]"),
    ] {
        let text = format!(
            "domain v in [0, 1]
at u = 0: S = [{curve}, 0], ∂S/∂u = [0, 0, 2]
at u = 1: S = [{curve}, 2], ∂S/∂u = [0, 0, 2]
at v = 0: S = {start}
at v = 1: S = {end}\n"
        );
        assert_eq!(folded(&text), [0; 0], "{text}");
    }
}

#[test]
fn loop_whose_edges_cross_is_refused() {
    let refused = |text: &str| {
        let options = Options::default();
        let found = Blend::compile_with(&Source::new(NAME, text), data_file, &options).err().expect(text);
        (found[0].code, found[0].message.clone())
    };
    let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let crossed = (Code::LoopFolded, "edge 3 of the loop `hole` crosses edge 1".to_owned());
    assert_eq!(refused(&polygon(&bow, 0.0, "")), crossed);
    // Edges 2 and 4 bulge over each other.
    let lens = |bulge: f64| {
        format!(
            "nsided hole {{\n    edge [u, 0, 0]\n    edge [1 - {bulge} u (1 - u), u, 0]\n    edge [1 - u, 1, 0]\n    \
             edge [{bulge} u^2 (1 - u)/(1 + u), 1 - u, 0]\n}}\n"
        )
    };
    assert_eq!(refused(&lens(4.0)), (Code::LoopFolded, "edge 4 of the loop `hole` crosses edge 2".to_owned()));
}

#[test]
fn edges_that_run_close_or_pass_in_space_do_not_cross() {
    // Arcs a hundred-thousandth apart, which chains of a few pieces would tangle.
    let (inner, outer) = ("cos(3u), sin(3u)", "1.00001 cos(3 (1 - u^2)), 1.00001 sin(3 (1 - u^2))");
    let crescent = format!(
        "nsided hole {{\n    edge [1.00001 - 0.00001 u, 0, 0]\n    edge [{inner}, 0]\n    \
         edge [(1 + 0.00001 u) cos(3), (1 + 0.00001 u) sin(3), 0]\n    edge [{outer}, 0]\n}}\n"
    );
    let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];
    for text in [crescent, polygon(&bow, 0.0, "")] {
        assert_eq!(blend(&text).patches.len(), 4);
    }
}
