//! Local deformations: the reference of You and Zhang 2003, Fig. 7, smoothness across the border, and what is refused.

use std::sync::Arc;

use serde_json::Value;
use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic};
use trimline::eval::Backend;
use trimline::expr::{Derivative, ExprId, Function, Number, Variable};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::problem::{Bindings, Deformation, Problem};
use trimline::surface::{Bump, DeformedSurface, Surface};
use trimline::tessellate::{Grid, tessellate};

use crate::sides::{ClosedForm, Vector, with_vector};

const TURN: &str = "param k = 1\ndomain u in [0, 1], v in [0, 2π], t in [0, 1]";

fn number(problem: &mut Problem, value: f64) -> ExprId {
    problem.graph.number(Number::parse(&value.to_string()).expect("a number"))
}

fn deformation(problem: &mut Problem, region: [[f64; 2]; 2], by: Vector, keeps: usize) -> Deformation {
    let region = region.map(|range| range.map(|end| number(problem, end)));
    Deformation { region, by, keeps, origin: None }
}

/// A closed form with deformations, over u in [0, 1] and v in [0, 2π].
fn deformed(problem: &Problem, base: Vector, deformations: &[Deformation]) -> Result<DeformedSurface, Diagnostic> {
    let bumps: Vec<Arc<Bump>> = deformations
        .iter()
        .map(|one| Bump::compile(problem, one, Backend::Interpreter, &Limits::default()).map(Arc::new))
        .collect::<Result<_, _>>()?;
    let params = Bindings::evaluate(problem)?.as_slice().to_vec();
    let base = Arc::new(ClosedForm { graph: problem.graph.clone(), vector: base, params: params.clone() });
    DeformedSurface::new(base, &bumps, &params, [[0.0, 1.0], [0.0, std::f64::consts::TAU]])
}

fn at(surface: &dyn Surface, derivative: Derivative, u: f64, v: f64) -> [f64; 3] {
    let mut value = [[0.0; 3]];
    surface.evaluate(derivative, &[[u, v, 0.0]], &mut value).expect("a point of the domain");
    value[0]
}

#[test]
fn deformation_of_the_paper_agrees_with_the_reference() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/p4_local_c1.json");
    let reference: Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect("the file is there")).expect("JSON");
    let radius = "(3/10*u^3 + 67/100*u^2 - 147/100*u + 9/10)";
    let base = format!("[{radius}*cos(v), {radius}*sin(v), 6*u^3 - 87/10*u^2 - 3/10*u + 3]");
    let (mut problem, base) = with_vector(TURN, "d4S/du4", &base);
    // The paper's displacement is 300 (cos v, sin v, 1) times the square of a product of at most 1/16.
    let graph = &mut problem.graph;
    let (v, one) = (graph.variable(Variable::V), graph.integer(1));
    let by = [graph.call(Function::Cos, &[v]), graph.call(Function::Sin, &[v]), one];
    let factor = Number::fraction(300, 256).expect("a number");
    let by = by.map(|component| graph.scale(factor, component));
    let bumps = [deformation(&mut problem, [[0.4, 0.5], [5.03, 5.65]], by, 1)];
    let surface = deformed(&problem, base, &bumps).expect("inside");
    let rows = reference["samples_u_v_deformed_xyz_base_xyz"].as_array().expect("rows");
    assert_eq!(rows.len(), 81);
    for row in rows {
        let row: Vec<f64> = row.as_array().expect("a row").iter().filter_map(Value::as_f64).collect();
        for (found, expected) in at(&surface, Derivative::NONE, row[0], row[1]).iter().zip(&row[2..5]) {
            // A few rounding errors of numbers below 3.
            assert!((found - expected).abs() < 1e-14, "{row:?}: {found}");
        }
    }
    // The largest jump of second derivatives across the border, which the reference gives.
    let mut jump = 0.0_f64;
    for step in 0..=400 {
        let v = 5.03 + 0.62 * f64::from(step) / 400.0;
        let (inside, outside) =
            (at(&surface, Derivative::new(2, 0, 0), 0.4, v), at(&surface, Derivative::new(2, 0, 0), 0.4 - 1e-12, v));
        jump = (0..3).fold(jump, |most, axis| most.max((inside[axis] - outside[axis]).abs()));
    }
    let expected = reference["max_jump_of_derivatives_0..3"][2].as_f64().expect("a number");
    assert!((jump / expected - 1.0).abs() < 1e-6, "{jump} {expected}");
}

#[test]
fn derivatives_up_to_the_order_that_is_kept_do_not_jump_and_the_next_one_does() {
    for keeps in 0..=2 {
        let (mut problem, by) = with_vector(TURN, "d4S/du4", "[u, k*v, 1 + u*v]");
        let bump = deformation(&mut problem, [[0.25, 0.75], [1.0, 2.0]], by, keeps);
        let zero = problem.graph.integer(0);
        let surface = deformed(&problem, [zero; 3], &[bump]).expect("inside");
        let jump = |orders: usize, along_u: bool| {
            let derivative = if along_u { Derivative::new(orders, 0, 0) } else { Derivative::new(0, orders, 0) };
            let (u, v) = if along_u { (0.25, 1.5) } else { (0.5, 2.0) };
            let value = at(&surface, derivative, u, v);
            value.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
        };
        for along_u in [true, false] {
            for orders in 0..=keeps {
                assert_eq!(jump(orders, along_u), 0.0, "C{keeps}, order {orders}");
            }
            assert!(jump(keeps + 1, along_u) > 1.0, "C{keeps}");
        }
        assert_eq!(at(&surface, Derivative::NONE, 0.2, 1.5), [0.0; 3], "outside");
    }
}

#[test]
fn middle_of_the_region_moves_by_what_is_asked() {
    let (mut problem, by) = with_vector(TURN, "d4S/du4", "[0, 1/10, 2*k]");
    let bumps = [
        deformation(&mut problem, [[0.0, 0.5], [1.0, 2.0]], by, 1),
        deformation(&mut problem, [[0.25, 1.0], [1.0, 4.0]], by, 2),
    ];
    let zero = problem.graph.integer(0);
    let one = deformed(&problem, [zero; 3], &bumps[..1]).expect("inside");
    assert_eq!(at(&one, Derivative::NONE, 0.25, 1.5), [0.0, 0.1, 2.0]);
    // Where regions overlap displacements add up.
    let other = deformed(&problem, [zero; 3], &bumps[1..]).expect("inside");
    let both = deformed(&problem, [zero; 3], &bumps).expect("inside");
    let [a, b, sum] = [&one, &other, &both].map(|surface| at(surface, Derivative::NONE, 0.4, 1.3)[2]);
    assert!(a > 0.01 && b > 0.01 && (sum - a - b).abs() < 1e-15, "{a} {b} {sum}");
}

#[test]
fn derivatives_of_a_deformation_agree_with_difference_quotients() {
    let (mut problem, by) = with_vector(TURN, "d4S/du4", "[sin(u*v), k*v, exp(u)]");
    let base = problem.patches[0].operator.force;
    let bump = deformation(&mut problem, [[0.25, 0.75], [1.0, 2.0]], by, 2);
    let surface = deformed(&problem, base, &[bump]).expect("inside");
    let h = 1e-5;
    for (p, q) in [(0, 0), (1, 0), (1, 1), (2, 1)] {
        let value = |p, q, u, v| at(&surface, Derivative::new(p, q, 0), u, v);
        for axis in 0..3 {
            let in_u = (value(p, q, 0.4 + h, 1.7)[axis] - value(p, q, 0.4 - h, 1.7)[axis]) / (2.0 * h);
            let in_v = (value(p, q, 0.4, 1.7 + h)[axis] - value(p, q, 0.4, 1.7 - h)[axis]) / (2.0 * h);
            // Derivatives of order 5 are below 1e7, and h²/6 of that remains.
            assert!((in_u - value(p + 1, q, 0.4, 1.7)[axis]).abs() < 2e-4, "{p} {q}");
            assert!((in_v - value(p, q + 1, 0.4, 1.7)[axis]).abs() < 2e-4, "{p} {q}");
        }
    }
}

#[test]
fn regions_that_do_not_fit_are_refused_with_advice() {
    let cases = [
        ([[0.5, 0.25], [1.0, 2.0]], "the region u in [0.5, 0.25] is empty", "`u in [0.25, 0.5]`"),
        ([[0.25, 0.5], [1.0, 1.0]], "the region v in [1, 1] is empty", "below"),
        ([[0.25, 1.25], [1.0, 2.0]], "the region u in [0.25, 1.25] leaves the patch", "u in [0, 1]"),
        ([[0.25, 0.5], [-1.0, 2.0]], "the region v in [-1, 2] leaves the patch", "v in [0, 6.28"),
    ];
    for (region, message, hint) in cases {
        let (mut problem, by) = with_vector(TURN, "d4S/du4", "[0, 0, 1]");
        let bump = deformation(&mut problem, region, by, 1);
        let refused = deformed(&problem, by, &[bump]).err().expect("refused");
        assert_eq!((refused.code, refused.message.as_str()), (Code::RegionDoesNotFit, message));
        assert!(refused.hints[0].contains(hint), "{:?}", refused.hints);
    }
    let (mut problem, by) = with_vector(TURN, "d4S/du4", "[0, 0, 1]");
    let bump = deformation(&mut problem, [[0.25, 0.5], [1.0, 2.0]], by, 3);
    assert_eq!(deformed(&problem, by, &[bump]).err().map(|e| e.code), Some(Code::RegionDoesNotFit));
}

const CYLINDER: &str = "param k = 1
at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]
at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]
";

/// A tube with a bump over `region`.
fn cylinder(region: [[f64; 2]; 2], keeps: usize) -> Result<Blend, Diagnostic> {
    let mut problem = crate::spec::problem(CYLINDER);
    let k = problem.graph.symbol("k");
    let zero = problem.graph.integer(0);
    let bump = deformation(&mut problem, region, [k, zero, zero], keeps);
    problem.patches[0].deformations.push(bump);
    Blend::new(problem, &Options::default())
}

#[test]
fn deformed_patch_meets_its_boundary_and_shows_its_true_residual() {
    // The region touches the trimline u = 0.
    let mut blend = cylinder([[0.0, 0.5], [1.0, 2.0]], 1).expect("a problem");
    let solution = blend.solve(0, 0.0).expect("solvable");
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14, "{:?}", measured.boundary_errors);
    assert!(measured.relative_residual() > 0.1 && !solution.report.is_exact);
    let plain = spec_solution(CYLINDER);
    let moved = |surface: &dyn Surface| at(surface, Derivative::NONE, 0.25, 1.5)[0] - plain;
    assert!((moved(&*solution.surface) - 1.0).abs() < 1e-14);
    blend.set("k", "3").expect("a param");
    let solution = blend.solve(0, 0.0).expect("solvable");
    assert!((moved(&*solution.surface) - 3.0).abs() < 1e-14);
}

/// x of the middle of the region, undeformed.
fn spec_solution(text: &str) -> f64 {
    let blend = Blend::new(crate::spec::problem(text), &Options::default()).expect("a problem");
    at(&*blend.solve(0, 0.0).expect("solvable").surface, Derivative::NONE, 0.25, 1.5)[0]
}

#[test]
fn mesh_has_the_border_of_a_deformation_as_an_outline() {
    let blend = cylinder([[0.25, 0.5], [1.0, 2.0]], 0).expect("a problem");
    let solution = blend.solve(0, 0.0).expect("solvable");
    assert_eq!(solution.surface.regions(), [[[0.25, 0.5], [1.0, 2.0]]]);
    let domain = &blend.patches[0].domain;
    let grid = Grid::new(4, 8, &Limits::default()).expect("a grid");
    let (mesh, _) = tessellate("p", &*solution.surface, (domain.u, domain.v), 0.0, grid).expect("a mesh");
    let [outline] = mesh.outlines.as_slice() else { panic!("{:?}", mesh.outlines) };
    assert_eq!(outline.first(), outline.last());
    let corners = [[0.25, 1.0], [0.5, 1.0], [0.5, 2.0], [0.25, 2.0]];
    let places = corners.map(|[u, v]| at(&*solution.surface, Derivative::NONE, u, v));
    assert!(places.iter().all(|place| outline.contains(place)), "{places:?}");
    let middle = at(&*solution.surface, Derivative::NONE, 0.375, 2.0);
    let gap = |p: &[f64; 3]| p.iter().zip(middle).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(outline.iter().map(gap).fold(f64::INFINITY, f64::min) < 1e-14, "{outline:?}");
}

#[test]
fn deformation_that_bends_a_trimline_is_refused() {
    let blend = cylinder([[0.0, 0.5], [1.0, 2.0]], 0).expect("a problem");
    let refused = blend.solve(0, 0.0).err().expect("refused");
    assert_eq!(refused.code, Code::RegionDoesNotFit);
    assert!(refused.hints[0].contains("keep C1"), "{:?}", refused.hints);
    // Away from the trimlines C0 is as good as C1.
    assert!(cylinder([[0.25, 0.5], [1.0, 2.0]], 0).expect("a problem").solve(0, 0.0).is_ok());
}
