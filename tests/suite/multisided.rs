//! Loops of three to eight edges filled by four-sided patches, and patches with an apex: what meets, and how smoothly.

use std::f64::consts::TAU;

use trimline::blend::Blend;
use trimline::diagnostic::Code;
use trimline::expr::{Derivative, ExprId, Function, Graph, Number, Variable};
use trimline::limits::Limits;
use trimline::method::{Options, Solution};
use trimline::multisided::{Edge, EdgeLoop, close_at_apex};
use trimline::problem::{Bindings, Problem, SolveRequest};
use trimline::surface::Surface;

use crate::sides::{Vector, applied, restrict, solve, terms, with_vector};

const BIHARMONIC: &str = "d4S/du4 + 2*d4S/du2dv2 + d4S/dv4";
const BEFORE: &str = "param k = 1\ndomain u in [0, 1], v in [0, 1], t in [0, 1]";

/// The corners of an irregular polygon in space.
fn corners(count: usize) -> Vec<[f64; 3]> {
    (0..count)
        .map(|index| {
            let turn = TAU * index as f64 / count as f64;
            let angle = turn + 0.2 * (3.0 * turn + 1.0).sin() / count as f64;
            let radius = 1.0 + 0.25 * (2.0 * turn).cos();
            [radius * angle.cos(), radius * angle.sin(), 0.3 * (2.0 * turn + 0.5).sin()]
        })
        .collect()
}

fn number(graph: &mut Graph, value: f64) -> ExprId {
    graph.number(Number::from_f64(value).expect("finite"))
}

/// A line from one corner to the next that sags by `sag` in z, times `k`, and moves with t.
fn edge(graph: &mut Graph, from: [f64; 3], to: [f64; 3], sag: f64) -> Vector {
    let (u, t, one) = (graph.variable(Variable::U), graph.variable(Variable::T), graph.integer(1));
    let rest = graph.difference(one, u);
    let mut curve = [0, 1, 2].map(|axis| {
        let ends = [number(graph, from[axis]), number(graph, to[axis])];
        let parts = [graph.product([rest, ends[0]]), graph.product([u, ends[1]])];
        graph.sum(parts)
    });
    let (k, sag) = (graph.symbol("k"), number(graph, sag));
    let later = graph.sum([one, t]);
    let depth = graph.product([k, sag, u, rest, later]);
    curve[2] = graph.sum([curve[2], depth]);
    curve
}

/// A loop over an irregular polygon, its problem without patches, ready to be split.
fn polygon(count: usize) -> (Problem, EdgeLoop) {
    let (mut problem, _) = with_vector(BEFORE, BIHARMONIC, "[0, 0, k]");
    let corners = corners(count);
    let edges = (0..count)
        .map(|index| {
            let sag = 0.4 * (1.0 + 2.0 * index as f64).sin();
            let curve = edge(&mut problem.graph, corners[index], corners[(index + 1) % count], sag);
            Edge { curve, across: None, origin: None }
        })
        .collect();
    let patch = problem.patches.remove(0);
    let edges = EdgeLoop {
        name: "hole".to_owned(),
        edges,
        centre: None,
        operator: patch.operator,
        time: patch.domain.ends[2],
        solve: SolveRequest::default(),
    };
    (problem, edges)
}

fn split(problem: &mut Problem, edges: &EdgeLoop) {
    problem.patches = edges.split(&mut problem.graph, &Limits::default()).expect("a loop");
}

fn solved(problem: &Problem, t: f64) -> (Blend, Vec<Solution>) {
    let blend = Blend::new(problem.clone(), &terms("6")).expect("a problem");
    let solutions = (0..blend.patches.len()).map(|index| blend.solve(index, t).expect("solvable")).collect();
    (blend, solutions)
}

fn at(surface: &dyn Surface, derivative: Derivative, u: f64, v: f64, t: f64) -> [f64; 3] {
    let mut value = [[0.0; 3]];
    surface.evaluate(derivative, &[[u, v, t]], &mut value).expect("a point of the patch");
    value[0]
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm([a[0] - b[0], a[1] - b[1], a[2] - b[2]])
}

/// Unit normals on a grid.
fn normals(surface: &dyn Surface, u: &[f64], v: &[f64], t: f64) -> Vec<[f64; 3]> {
    let tangents = [Derivative::new(1, 0, 0), Derivative::new(0, 1, 0)].map(|derivative| {
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        surface.evaluate_grid(derivative, (u, v, t), &mut values).expect("points of the patch");
        values
    });
    let unit = |(a, b): (&[f64; 3], &[f64; 3])| {
        let n = cross(*a, *b);
        assert!(norm(n) > 1e-3, "a normal");
        n.map(|x| x / norm(n))
    };
    tangents[0].iter().zip(&tangents[1]).map(unit).collect()
}

/// The angle of two unit vectors in degrees, to rounding where it is small.
fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    norm(cross(a, b)).atan2(dot).to_degrees()
}

#[test]
fn seams_of_loops_with_three_to_eight_edges_are_closed_and_smooth() {
    for count in 3..=8 {
        let (mut problem, edges) = polygon(count);
        split(&mut problem, &edges);
        assert_eq!(problem.patches.len(), count);
        let (_, solutions) = solved(&problem, 0.5);
        let (mut gap, mut bend) = (0.0_f64, 0.0_f64);
        assert_eq!(edges.seams().len(), count);
        for seam in edges.seams() {
            let (left, right) = (&*solutions[seam.left].surface, &*solutions[seam.right].surface);
            let lines: Vec<f64> = (0..=20).map(|step| f64::from(step) / 20.0).collect();
            let positions = |surface: &dyn Surface, u: &[f64], v: &[f64]| {
                let mut values = vec![[0.0; 3]; lines.len()];
                surface.evaluate_grid(Derivative::NONE, (u, v, 0.5), &mut values).expect("points of the patch");
                values
            };
            for (a, b) in positions(left, &[1.0], &lines).into_iter().zip(positions(right, &lines, &[1.0])) {
                gap = gap.max(distance(a, b));
            }
            for (a, b) in normals(left, &[1.0], &lines, 0.5).into_iter().zip(normals(right, &lines, &[1.0], 0.5)) {
                bend = bend.max(angle(a, b));
            }
        }
        // A few rounding errors of numbers of size 1; an angle of rounding errors in degrees.
        assert!(gap <= 1e-14 && bend <= 1e-11, "{count} edges: gap {gap:.1e}, angle {bend:.1e} degrees");
    }
}

#[test]
fn loops_are_filled_without_folds_and_keep_their_edges() {
    for count in 3..=8 {
        let (mut problem, edges) = polygon(count);
        split(&mut problem, &edges);
        let (blend, solutions) = solved(&problem, 0.5);
        for (index, solution) in solutions.iter().enumerate() {
            // Twists agree in all corners: no note.
            assert!(solution.report.warnings.is_empty(), "{count}.{index}: {:?}", solution.report.warnings);
            let measured = blend.verify(index, solution, 0.5).expect("finite");
            assert!(measured.boundary_error() < 1e-14, "{count}.{index}: {:?}", measured.boundary_errors);
            let lines: Vec<f64> = (0..=12).map(|step| f64::from(step) / 12.0).collect();
            for normal in normals(&*solution.surface, &lines, &lines, 0.5) {
                assert!(normal[2] > 0.2, "{count}.{index}: {normal:?}");
            }
        }
    }
}

#[test]
fn normals_from_positions_alone_agree_across_a_seam() {
    // One-sided differences into both patches: what is left falls with the step.
    let (mut problem, edges) = polygon(5);
    split(&mut problem, &edges);
    let (_, solutions) = solved(&problem, 0.0);
    let worst = |h: f64| {
        let mut worst = 0.0_f64;
        for seam in edges.seams() {
            let (left, right) = (&*solutions[seam.left].surface, &*solutions[seam.right].surface);
            for along in [0.25, 0.5, 0.75] {
                let on = at(left, Derivative::NONE, 1.0, along, 0.0);
                let further = at(left, Derivative::NONE, 1.0, along + h, 0.0);
                let inside =
                    [at(left, Derivative::NONE, 1.0 - h, along, 0.0), at(right, Derivative::NONE, along, 1.0 - h, 0.0)];
                let difference = |a: [f64; 3]| [a[0] - on[0], a[1] - on[1], a[2] - on[2]];
                let [a, b] = inside.map(|point| {
                    let n = cross(difference(point), difference(further));
                    n.map(|x| x / norm(n))
                });
                worst = worst.max(180.0 - angle(a, b));
            }
        }
        worst
    };
    let angles = [1e-2, 1e-3, 1e-4].map(worst);
    assert!(angles[0] < 5.0 && angles[1] < angles[0] / 5.0 && angles[2] < angles[1] / 5.0, "{angles:?}");
}

#[test]
fn loop_moves_with_params_and_time() {
    let (mut problem, edges) = polygon(6);
    split(&mut problem, &edges);
    let mut blend = Blend::new(problem, &terms("4")).expect("a problem");
    let centre =
        |blend: &Blend, t: f64| at(&*blend.solve(0, t).expect("solvable").surface, Derivative::NONE, 1.0, 1.0, t);
    let (before, later) = (centre(&blend, 0.0), centre(&blend, 1.0));
    blend.set("k", "2").expect("a param");
    let wider = centre(&blend, 0.0);
    // Twice the sag, by time or by param.
    assert!(distance(before, later) > 1e-3 && distance(later, wider) < 1e-14, "{before:?} {later:?} {wider:?}");
}

#[test]
fn centre_goes_where_it_is_asked_to() {
    let (mut problem, mut edges) = polygon(7);
    let (zero, high) = (problem.graph.integer(0), number(&mut problem.graph, 0.75));
    edges.centre = Some([zero, zero, high]);
    split(&mut problem, &edges);
    let (_, solutions) = solved(&problem, 0.0);
    for solution in &solutions {
        assert!(distance(at(&*solution.surface, Derivative::NONE, 1.0, 1.0, 0.0), [0.0, 0.0, 0.75]) < 1e-15);
    }
}

#[test]
fn planar_loop_with_stated_tangents_stays_in_its_plane() {
    let (mut problem, mut edges) = polygon(5);
    let flat: Vec<[f64; 3]> = corners(5).iter().map(|corner| [corner[0], corner[1], 1.0]).collect();
    for index in 0..5 {
        edges.edges[index].curve = edge(&mut problem.graph, flat[index], flat[(index + 1) % 5], 0.0);
    }
    // The tangent along each neighbour, in between linearly: the twists in the corners are no longer zero.
    for index in 0..5 {
        let slope = |a: usize, b: usize| [0, 1, 2].map(|axis| flat[b % 5][axis] - flat[a % 5][axis]);
        let (start, end) = (slope(index, index + 4), slope(index + 1, index + 2));
        edges.edges[index].across = Some(edge(&mut problem.graph, start, end, 0.0));
    }
    split(&mut problem, &edges);
    let bindings = Bindings::evaluate(&problem).expect("values");
    edges.check(&problem, &bindings, 0.0, &Limits::default()).expect("a closed loop");
    let (_, solutions) = solved(&problem, 0.0);
    for solution in &solutions {
        for (u, v) in [(0.1, 0.2), (0.5, 0.5), (0.9, 0.3), (1.0, 1.0)] {
            let point = at(&*solution.surface, Derivative::NONE, u, v, 0.0);
            assert!((point[2] - 1.0).abs() < 1e-14, "{point:?}");
        }
    }
}

#[test]
fn loop_that_does_not_close_is_refused_with_corner_and_gap() {
    let (mut problem, mut edges) = polygon(5);
    let graph = &mut problem.graph;
    let shift = number(graph, 0.125);
    // Edge 3 moves as a whole: corner 3 opens first.
    edges.edges[2].curve[2] = graph.sum([edges.edges[2].curve[2], shift]);
    let bindings = Bindings::evaluate(&problem).expect("values");
    let refused = edges.check(&problem, &bindings, 0.0, &Limits::default()).expect_err("open");
    assert_eq!(refused.code, Code::LoopOpen);
    assert!(
        refused.message.contains("in corner 3: edge 2 ends 1.2e-1 from where edge 3 begins"),
        "{}",
        refused.message
    );
    // And whoever does not check is told when solving.
    split(&mut problem, &edges);
    let blend = Blend::new(problem, &terms("4")).expect("a problem");
    let refusal = (0..5).find_map(|index| blend.solve(index, 0.0).err()).expect("refused");
    assert_eq!(refusal.code, Code::SidesDisagree);
}

#[test]
fn tangent_across_that_does_not_fit_its_neighbour_is_refused() {
    let (mut problem, mut edges) = polygon(4);
    let one = problem.graph.integer(1);
    edges.edges[1].across = Some([one; 3]);
    let bindings = Bindings::evaluate(&problem).expect("values");
    let refused = edges.check(&problem, &bindings, 0.0, &Limits::default()).expect_err("refused");
    assert_eq!(refused.code, Code::SidesDisagree);
    assert!(
        refused.message.contains("across edge 2 of the loop `hole` differs at its beginning"),
        "{}",
        refused.message
    );
    assert!(refused.hints[0].contains("it must be ["), "{:?}", refused.hints);
}

#[test]
fn loops_of_two_and_thirteen_edges_are_refused_and_of_twelve_filled() {
    for (count, is_accepted) in [(2, false), (12, true), (13, false)] {
        let (mut problem, edges) = polygon(count);
        let result = edges.split(&mut problem.graph, &Limits::default());
        assert_eq!(result.as_ref().err().map(|e| e.code), (!is_accepted).then_some(Code::EdgeCount), "{count}");
        if let Ok(patches) = result {
            problem.patches = patches;
            let (_, solutions) = solved(&problem, 0.0);
            assert!(solutions.iter().all(|solution| solution.report.warnings.is_empty()));
        }
    }
}

#[test]
fn edge_without_slope_is_refused_with_its_name() {
    let (mut problem, mut edges) = polygon(3);
    let graph = &mut problem.graph;
    let u = graph.variable(Variable::U);
    edges.edges[0].curve[0] = graph.call(Function::Abs, &[u]);
    let refused = edges.split(&mut problem.graph, &Limits::default()).expect_err("refused");
    assert_eq!(refused.code, Code::NotDifferentiable);
}

/// A cone-like surface whose side u = 1 is the point (0, 0, 1), restricted to the other three sides. `lift` bends the
/// tangents at the apex out of their plane.
fn three_sided(surface: &str) -> (Problem, Vector) {
    let (mut problem, known) = with_vector(BEFORE, BIHARMONIC, surface);
    restrict(&mut problem, known);
    problem.patches[0].conditions.truncate(2);
    let Problem { graph, patches, .. } = &mut problem;
    close_at_apex(graph, &mut patches[0], &Limits::default()).expect("three sides");
    (problem, known)
}

#[test]
fn three_sided_patch_reproduces_a_surface_with_an_apex() {
    // (1 - u) (a + b v), a quarter of it: bicubic, with zero tangent across the sides at the apex.
    let (mut problem, known) = three_sided("[(1 - u)*(1 + v), (1 - u)*v*(2 - v)/2, 1 - (1 - u)^2*(1 - v)/4]");
    let operator = problem.patches[0].operator.clone();
    problem.patches[0].operator.force = applied(&mut problem.graph, &operator, known);
    let (blend, solution) = solve(&problem, &Options::default(), 0.0).expect("solvable");
    assert!(solution.report.warnings.is_empty(), "{:?}", solution.report.warnings);
    assert!(crate::sides::distance(&blend, &*solution.surface, known, Derivative::NONE, 0.0) < 1e-14);
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14, "{:?}", measured.boundary_errors);
    for v in [0.0, 0.4, 1.0] {
        let apex = at(&*solution.surface, Derivative::NONE, 1.0, v, 0.0);
        assert!(distance(apex, [0.0, 0.0, 1.0]) < 1e-15, "{apex:?}");
        // Towards the apex the normal tends to that of the plane z = 1.
        let near = normal_near(&*solution.surface, 1.0 - 1e-6, v);
        assert!(angle(near, [0.0, 0.0, near[2].signum()]) < 1e-3, "{near:?}");
    }
}

fn normal_near(surface: &dyn Surface, u: f64, v: f64) -> [f64; 3] {
    let n = cross(at(surface, Derivative::new(1, 0, 0), u, v, 0.0), at(surface, Derivative::new(0, 1, 0), u, v, 0.0));
    n.map(|x| x / norm(n))
}

#[test]
fn apex_that_is_a_cusp_is_reported_with_its_angle() {
    // Tangents in the apex are -(1 + v, v(2 - v)/2, ...) with z of v (1 - v): between the sides they rise.
    let (problem, _) = three_sided("[(1 - u)*(1 - v), (1 - u)*v, 1 - (1 - u)*v*(1 - v)]");
    let (_, solution) = solve(&problem, &Options::default(), 0.0).expect("solvable");
    let [warning] = solution.report.warnings.as_slice() else { panic!("{:?}", solution.report.warnings) };
    assert_eq!(warning.code, Code::ApexNotSmooth);
    // At v = 1/2 the tangent is (-1/2, -1/2, 1/4): atan(0.25 sqrt 2) = 19.47 degrees.
    assert!(warning.message.contains("u = 1") && warning.message.contains("19.47 degrees"), "{}", warning.message);
}

#[test]
fn sides_that_do_not_end_in_one_point_are_refused() {
    let (problem, _) = three_sided("[(1 - u)*(1 + v), (1 - u)*v + u*v/8, 1]");
    let refused = solve(&problem, &Options::default(), 0.0).err().expect("refused");
    assert_eq!(refused.code, Code::SidesDisagree);
    assert!(
        refused.message.contains("the corner u = 1, v = 0: S differs by 0.0e0, ∂S/∂u by 0.0e0, ∂S/∂v by 1.2e-1"),
        "{}",
        refused.message
    );
}

#[test]
fn patch_with_a_fourth_side_cannot_be_closed_at_an_apex() {
    let (mut problem, known) = with_vector(BEFORE, BIHARMONIC, "[u, v, 0]");
    restrict(&mut problem, known);
    let Problem { graph, patches, .. } = &mut problem;
    let refused = close_at_apex(graph, &mut patches[0], &Limits::default()).expect_err("refused");
    assert_eq!(refused.code, Code::UnsupportedByMethod);
}
