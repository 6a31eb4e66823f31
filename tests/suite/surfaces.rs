//! Primary surfaces: their values, their derivatives, joins, and how joins and seams are judged.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic, Source};
use trimline::expr::{Derivative, Notation, Variable};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::problem::{Bindings, Problem};
use trimline::surface::Surface;
use trimline::verify::{Edge, JoinDeviation, Line, verify_joins};

use crate::spec::{problem, problem_within};

const SURFACES: &str = "param r = 2, u1 = 0.5
surface A(u, v, t) = [r cos(v) e^(u t), u^2 v^3, u t + v]
surface B(p, q) = [p q^2, sin(p) q, p^3 + t]
";

/// S at u = 0 of a document with [`SURFACES`].
fn data(value: &str) -> [String; 3] {
    let text = format!("{SURFACES}at u = 0: S = {value}, dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let problem = problem(&text);
    let values = problem.patches[0].conditions[0].value;
    values.map(|id| problem.graph.text(id, Notation::Ascii, 1 << 12).expect("short"))
}

/// Two values are the same expressions.
fn same(left: &str, right: &str) {
    assert_eq!(data(left), data(right), "{left}");
}

/// Code, marked text and message of every finding.
fn findings(text: &str) -> Vec<String> {
    let source = Source::new("spec", text);
    let line = |finding: &Diagnostic| {
        let marked = finding.span.map_or("", |span| source.slice(span));
        format!("{} `{marked}` {}", finding.code, finding.message)
    };
    problem_within(text, &Limits::default()).expect_err(text).iter().map(line).collect()
}

#[test]
fn use_of_a_surface_puts_the_arguments_in_place_of_its_parameters() {
    same("A(u1, v, t)", "[r cos(v) e^(u1 t), u1^2 v^3, u1 t + v]");
    // At once, not one after the other: v stands for u and 2 for v.
    same("A(v, 2, t)", "[r cos(2) e^(v t), 8 v^2, v t + 2]");
    same("A(1, v, 3)", "[r cos(v) e^3, v^3, 3 + v]");
    same("2 A(0, v, t) + [1, 0, 0]", "[2 r cos(v) + 1, 0, 2 v]");
}

#[test]
fn surface_of_two_parameters_moves_with_the_time_of_the_document() {
    same("B(1, v)", "[v^2, sin(1) v, 1 + t]");
}

#[test]
fn component_of_a_surface_is_a_number() {
    same("[A_z(u1, v, t), B_x(2, v), A_{y}(1, v, t)]", "[u1 t + v, 2 v^2, v^3]");
}

#[test]
fn derivative_of_a_surface_is_taken_in_its_own_parameter_and_then_evaluated() {
    same("∂A(u1, v, t)/∂u", "[r cos(v) t e^(u1 t), 2 u1 v^3, t]");
    // No chain rule: the argument 2v is put in afterwards.
    same("∂A(1, 2v, t)/∂v", "[-r sin(2v) e^t, 3 (2v)^2, 1]");
    same("∂²A(u1, v, t)/∂u∂v", "[-r sin(v) t e^(u1 t), 6 u1 v^2, 0]");
    same("∂A(1, v, t)/∂t", "[r cos(v) e^t, 0, 1]");
}

#[test]
fn derivative_of_a_surface_has_several_spellings() {
    for spelling in [
        "dA(u1, v, t)/du",
        "∂A/∂u (u1, v, t)",
        "dA/du(u1, v, t)",
        "[dA_x(u1, v, t)/du, ∂A_y/∂u (u1, v, t), ∂A_z(u1, v, t)/∂u]",
    ] {
        same(spelling, "∂A(u1, v, t)/∂u");
    }
    same("d2A(u1, v, t)/du2", "∂²A(u1, v, t)/∂u²");
    same("d2A(u1, v, t)/dudv", "∂²A(u1, v, t)/∂u∂v");
}

#[test]
fn parameter_of_a_surface_is_named_as_it_is_declared_or_by_its_place() {
    for spelling in ["∂B(2, v)/∂q", "∂B(2, v)/∂v", "dB(2, v)/dq", "∂B/∂q(2, v)"] {
        same(spelling, "[4 v, sin(2), 0]");
    }
    same("∂²B(2, v)/∂p∂q", "[2 v, cos(2), 0]");
    same("∂³B(v, 1)/∂p³", "[0, -cos(v), 6]");
}

#[test]
fn quotient_of_params_that_looks_like_a_derivative_is_a_quotient() {
    let text = "param dr0 = 6, du = 2\nat u = 0: S = [dr0 v/du, 0, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0";
    let problem = problem(text);
    let bindings = Bindings::evaluate(&problem).expect("finite");
    let value = problem.patches[0].conditions[0].value[0];
    assert_eq!(problem.graph.value(value, bindings.as_slice(), [0.0, 1.0, 0.0]), 3.0);
}

#[test]
fn surfaces_are_made_of_surfaces_and_definitions() {
    let lets = "let f(x) = x^2\nlet lift = [0, 0, f(t)]\nsurface C(u, v) = B(v, f(u)) + lift\n";
    let text = format!("{SURFACES}{lets}at u = 0: S = C(2, v), dS/du = ∂C(2, v)/∂u\nat u = 1: S = 0, dS/du = 0");
    let problem = problem(&text);
    let text = |order: usize| {
        let values = problem.patches[0].conditions[order].value;
        values.map(|id| problem.graph.text(id, Notation::Ascii, 1 << 12).expect("short"))
    };
    assert_eq!(text(0).to_vec(), data("[16 v, 4 sin(v), v^3 + t + t^2]").to_vec());
    assert_eq!(text(1).to_vec(), data("[32 v, 4 sin(v), 0]").to_vec());
}

/// Two values under further declarations are the same expressions.
fn nested(declarations: &str, value: &str, by_hand: &str) {
    let text = |value: &str| {
        let text = format!("{SURFACES}{declarations}\nat u = 0: S = {value}, dS/du = 0\nat u = 1: S = 0, dS/du = 0");
        let problem = problem(&text);
        problem.patches[0].conditions[0]
            .value
            .map(|id| problem.graph.text(id, Notation::Ascii, 1 << 12).expect("short"))
    };
    assert_eq!(text(value), text(by_hand), "{declarations}");
}

#[test]
fn surface_uses_an_earlier_one_under_names_of_its_own() {
    nested("surface D(p, q) = 2 B(p, q)", "D(3, v)", "2 [3 v^2, sin(3) v, 27 + t]");
    nested("surface D(p, q) = B(q, p)", "D(v, 3)", "[3 v^2, sin(3) v, 27 + t]");
    nested("surface D(v, u) = B(v, u)", "D(3, v)", "[3 v^2, sin(3) v, 27 + t]");
    nested("surface D(p, q, s) = A(q, p, s)", "D(v, 2, t)", "A(2, v, t)");
}

#[test]
fn derivative_of_a_nested_surface_follows_the_chain_of_names() {
    nested("surface D(p, q) = B(q, 2p)", "∂D(v, 3)/∂p", "[24 v, 2 sin(3), 0]");
    nested("surface D(p, q) = ∂B(q, p)/∂p", "D(v, 3)", "[v^2, cos(3) v, 27]");
}

#[test]
fn time_of_a_surface_of_two_parameters_is_hidden_where_another_time_is_declared() {
    let text =
        format!("{SURFACES}surface D(p, q, s) = B(p, q)\nat u = 0: S = 0, dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let found = findings(&text);
    assert!(found[0].starts_with("E0201 `B` `B` depends on `t`"), "{found:?}");
}

#[test]
fn join_is_position_tangent_and_curvature_up_to_half_the_order() {
    let conditions = |pde: &str, join: &str| {
        let spec = format!("{SURFACES}{pde}\nat u = 0: {join}\nat u = 1: join A at u = 3");
        let problem = problem(&spec);
        let conditions = problem.patches[0].conditions.iter().take(problem.patches[0].conditions.len() / 2);
        let text = |id| problem.graph.text(id, Notation::Ascii, 1 << 12).expect("short");
        conditions.map(|condition| condition.value.map(text)).collect::<Vec<_>>()
    };
    let (second, sixth) = ("pde d2S/du2 + d2S/dv2 = 0", "pde d6S/du6 + d6S/dv6 = 0");
    let [value, tangent, curvature] = ["A(u1, v, t)", "∂A(u1, v, t)/∂u", "∂²A(u1, v, t)/∂u²"].map(data);
    assert_eq!(conditions(second, "join A at u = u1")[..], *std::slice::from_ref(&value));
    assert_eq!(conditions("", "join A at u = u1"), [value.clone(), tangent.clone()]);
    assert_eq!(conditions(sixth, "join A at u = u1"), [value.clone(), tangent, curvature]);
    let scaled = ["-3 ∂A(u1, v, t)/∂u", "9 ∂²A(u1, v, t)/∂u²"].map(data);
    let scaled = [value, scaled[0].clone(), scaled[1].clone()];
    assert_eq!(conditions(sixth, "join A at u = u1, strength = 3, flip"), scaled);
    assert_eq!(conditions(sixth, "join A at u = u1, flip, strength = 3"), scaled);
    assert_eq!(conditions("", "join A at v = 2"), ["A(v, 2, t)", "∂A(v, 2, t)/∂v"].map(data));
}

#[test]
fn standard_surfaces_are_as_documented() {
    let (p, q) = (0.4_f64, 1.1_f64);
    let (s, c) = (q.sin(), q.cos());
    let cases: [(&str, [f64; 3]); 9] = [
        ("plane(0.4, 1.1)", [p, q, 0.0]),
        ("cylinder(0.4, 1.1, 2, 3)", [2.0 * c, 2.0 * s, 3.0 * p]),
        ("cone(0.4, 1.1, 2, 3)", [1.2 * c, 1.2 * s, 1.2]),
        ("sphere(0.4, 1.1, 2)", [2.0 * p.cos() * c, 2.0 * p.cos() * s, 2.0 * p.sin()]),
        ("torus(0.4, 1.1, 3, 1)", [(3.0 + p.cos()) * c, (3.0 + p.cos()) * s, p.sin()]),
        ("paraboloid(0.4, 1.1, 2)", [p * c, p * s, 0.32]),
        ("hyperboloid1(0.4, 1.1, 2, 3)", [2.0 * p.cosh() * c, 2.0 * p.cosh() * s, 3.0 * p.sinh()]),
        ("hyperboloid_2(0.4, 1.1, 2, 3)", [2.0 * p.sinh() * c, 2.0 * p.sinh() * s, 3.0 * p.cosh()]),
        ("catenoid(0.4, 1.1, 2)", [2.0 * 0.2_f64.cosh() * c, 2.0 * 0.2_f64.cosh() * s, p]),
    ];
    for (call, expected) in cases {
        let problem = problem(&format!("at u = 0: S = {call}, dS/du = 0\nat u = 1: S = 0, dS/du = 0"));
        let values = problem.patches[0].conditions[0].value.map(|id| problem.graph.value(id, &[], [0.0; 3]));
        for (found, expected) in values.into_iter().zip(expected) {
            // Two libraries of functions, a rounding or two each.
            assert!((found - expected).abs() < 1e-14, "{call}: {found} {expected}");
        }
    }
}

#[test]
fn definition_of_a_document_takes_the_place_of_a_standard_surface() {
    let text = "let sphere(x) = [x, 0, 0]\nparam torus = 2\nat u = 0: S = torus sphere(v), dS/du = 0\nat u = 1: S = 0, dS/du = 0";
    let problem = problem(text);
    let value = problem.patches[0].conditions[0].value[0];
    assert_eq!(problem.graph.text(value, Notation::Ascii, 99).expect("short"), "torus*v");
}

#[test]
fn slips_with_surfaces_are_refused_where_they_stand() {
    let whole = |line: &str| format!("{SURFACES}{line}");
    let value = |value: &str| format!("{SURFACES}at u = 0: S = {value}, dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let join = |join: &str| format!("{SURFACES}at u = 0: {join}\nat u = 1: S = 0, dS/du = 0");
    let rest = "\nat u = 0: S = 0, dS/du = 0\nat u = 1: S = 0, dS/du = 0";
    let cases = [
        (value("A(u1, v)"), "E0208 `A(u1, v)` `A` takes 3 arguments, found 2"),
        (value("A"), "E0208 `A` `A` is a surface, which takes its parameters in brackets"),
        (value("∂A(u1, v, t)/∂w"), "E0201 `w` `A` has no parameter `w`"),
        (value("∂²A(u1, v, t)/∂u"), "E0102 `∂²A(u1, v, t)/∂u` the derivative has order 2 above the bar and 1 below"),
        (value("∂Q(u1, v, t)/∂u"), "E0201 `Q` unknown name `Q`"),
        (value("∂r(u1, v, t)/∂u"), "E0201 `r` `r` is not a surface"),
        (value("d9A(u1, v, t)/du9"), "E0901 `d9A(u1, v, t)/du9` the derivative is above the limit `derivative-order`"),
        (value("A(u, v, t)"), "E0203 `A(u, v, t)` "),
        (join("join Q at u = 1"), "E0201 `Q` unknown name `Q`"),
        (join("join r at u = 1"), "E0201 `r` `r` is not a surface"),
        (join("join A at t = 1"), "E0102 `t` a trimline of `A` is where its first or second parameter is constant"),
        (join("join A at u = v"), "E0211 `v` the position of a trimline must not depend on u, v or t"),
        (join("join A at u = 1, flip, flip"), "E0210 `flip` this is said twice of the same join"),
        (join("join A at u = 1, S = 0"), "E0204 `join A at u = 1` S_x at u = 0 is given twice"),
        (whole(&format!("surface D(p) = [p, 0, 0]{rest}")), "E0208 `D` a surface has two parameters"),
        (
            whole(&format!("surface D(p, p) = [p, 0, 0]{rest}")),
            "E0202 `p` two parameters of the surface are called `p`",
        ),
        (whole(&format!("surface D(p, q) = [p, u, 0]{rest}")), "E0201 `u` `u` is not a parameter of this surface"),
        (whole(&format!("let c = cos v\nsurface D(p, q) = [p, c, 0]{rest}")), "E0201 `c` `c` depends on `v`"),
        (whole(&format!("surface D(p, q, s) = [p, t, s]{rest}")), "E0201 `t` `t` is not a parameter of this surface"),
        (whole(&format!("surface D(p, q) = p{rest}")), "E0209 `p` a surface is a vector"),
        (whole(&format!("surface r(p, q) = [p, q, 0]{rest}")), "E0202 `r` `r` is declared twice"),
        (whole(&format!("surface D(p, q) = [p, q, 0] with s in [0, 1]{rest}")), "E0201 `s` `s` is not a parameter"),
        (whole(&format!("seam spec at u = 0 with other at u = 1{rest}")), "E0201 `other` there is no patch `other`"),
        (whole(&format!("seam spec at u = 0 with spec at u = 2{rest}")), "E0715 `2` `spec` has no edge at u = 2"),
        (
            whole(&format!("seam spec at v = 0 with spec at u = 1{rest}")),
            "E0102 `v` the patch `spec` has no data at fixed v",
        ),
    ];
    for (text, expected) in cases {
        let found = findings(&text);
        assert!(matches!(found.as_slice(), [only] if only.starts_with(expected)), "{expected}\n{found:?}");
    }
}

#[test]
fn surface_without_a_tangent_where_it_is_joined_is_refused() {
    let text = "surface D(p, q) = [abs(p), q, 0]\nat u = 0: join D at p = 1\nat u = 1: S = 0, dS/du = 0";
    assert!(findings(text)[0].starts_with("E0301 `join D at p = 1`"), "{:?}", findings(text));
}

/// A document solved at t, and how its first patch meets the surfaces it joins.
fn joins(text: &str, t: f64) -> Vec<JoinDeviation> {
    let blend =
        Blend::compile(&Source::new("spec", text), &Options::default()).unwrap_or_else(|found| panic!("{found:?}"));
    let solution = blend.solve(0, t).unwrap_or_else(|finding| panic!("{finding}"));
    judged(&blend, &blend.problem, &*solution.surface, t)
}

fn judged(blend: &Blend, problem: &Problem, surface: &dyn Surface, t: f64) -> Vec<JoinDeviation> {
    let at = (&blend.bindings, &blend.patches[0].domain, t);
    verify_joins(problem, &problem.patches[0], surface, at, &Limits::default())
        .unwrap_or_else(|finding| panic!("{finding}"))
}

const JOINED: &str = "surface A(u, v, t) = [(2 + sin t) cos v, 2 sin v, 1 - u]
surface B(p, q) = torus(p, q, 4, 1)
";

#[test]
fn joined_surfaces_are_met_to_rounding_at_every_instant() {
    let text = format!("{JOINED}at u = 0: join A at u = 0.5, strength = 2\nat u = 1: join B at p = 3, flip");
    for t in [0.0, 0.4, 1.0] {
        for join in joins(&text, t) {
            // Sizes are about 5; the trimlines and tangents are met by construction.
            assert!(
                join.gap < 1e-14 && join.tangent.unwrap() < 1e-14 && join.angle_degrees.unwrap() < 1e-11,
                "{join:?}"
            );
            assert_eq!((join.curvature, join.without_normal), (None, 0));
        }
    }
}

#[test]
fn join_that_is_written_out_is_judged_like_one_that_is_not() {
    let text =
        format!("{JOINED}at u = 0: S = A(0.5, v, t), dS/du = -∂A(0.5, v, t)/∂u\nat u = 1: S = 0, dS/du = [0, 0, 1]");
    let found = joins(&text, 0.3);
    let [only] = found.as_slice() else { panic!("{found:?}") };
    assert!(only.gap < 1e-14 && only.tangent.unwrap() < 1e-14, "{only:?}");
}

#[test]
fn tangent_that_is_turned_is_measured_by_its_angle() {
    // The cylinder's tangent plane holds the axis; a tangent at 45 degrees to it leaves the plane by 45 degrees.
    let text = "surface A(u, v) = cylinder(u, v, 1, 1)
at u = 0: S = A(0, v), dS/du = [cos v, sin v, 1]\nat u = 1: S = [cos v, sin v, 3], dS/du = 0";
    let found = joins(text, 0.0);
    assert!((found[0].angle_degrees.unwrap() - 45.0).abs() < 1e-12, "{found:?}");
    // Unit vectors 45 degrees apart.
    assert!((found[0].tangent.unwrap() - 2.0 * (std::f64::consts::PI / 8.0).sin()).abs() < 1e-14, "{found:?}");
}

#[test]
fn gap_is_found_though_the_data_are_met() {
    // The data say one surface, the join another: the judge must look at the surface, not at the data.
    let text = format!("{JOINED}at u = 0: join A at u = 0.5\nat u = 1: join B at p = 3");
    let blend = Blend::compile(&Source::new("spec", text.as_str()), &Options::default()).expect("a document");
    let solution = blend.solve(0, 0.0).expect("a solution");
    let moved = problem(&text.replace("1 - u]", "1.25 - u]"));
    let found = judged(&blend, &moved, &*solution.surface, 0.0);
    assert!((found[0].gap - 0.25).abs() < 1e-14, "{found:?}");
}

#[test]
fn curvature_is_compared_for_equations_of_sixth_order() {
    let pde = "pde d6S/du6 + 3 d6S/du4dv2 + 3 d6S/du2dv4 + d6S/dv6 = 0\n";
    let round =
        format!("{pde}surface A(u, v) = sphere(u, v, 2)\nat u = 0: join A at u = 0.3\nat u = 1: join A at u = 0.8");
    for join in joins(&round, 0.0) {
        // Two derivatives of data of size 2.
        assert!(join.curvature.unwrap() < 1e-12, "{join:?}");
    }
    // Without second derivative the normal curvature across is 0, that of the sphere 1/2.
    let data = "S = A(0.3, v), dS/du = ∂A(0.3, v)/∂u, d2S/du2 = 0";
    let flat = round.replacen("join A at u = 0.3", data, 1);
    assert!((joins(&flat, 0.0)[0].curvature.unwrap() - 0.5).abs() < 1e-12, "{:?}", joins(&flat, 0.0));
}

#[test]
fn trimline_without_normals_is_reported_and_not_a_number_is_not() {
    // The pole of a sphere: one point, and no tangent along it.
    let text = "surface A(u, v) = sphere(u, v, 1)\nat u = 0: join A at u = π/2\nat u = 1: join A at u = 0";
    let found = joins(text, 0.0);
    assert_eq!((found[0].angle_degrees, found[0].without_normal), (None, 37), "{found:?}");
    assert!(found[1].angle_degrees.unwrap() < 1e-12 && found[0].gap < 1e-14, "{found:?}");
}

/// A cone `[(1 + a u) cos v, (1 + a u) sin v, u]`, run through backwards if `turns`.
struct Cone {
    a: f64,
    turns: bool,
}

impl Surface for Cone {
    fn evaluate(&self, d: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let sign = if self.turns { -1.0 } else { 1.0 };
        for ([u, v, _], value) in points.iter().zip(values) {
            let (r, (s, c)) = (1.0 + self.a * u, (sign * v).sin_cos());
            *value = match (d.u, d.v) {
                (0, 0) => [r * c, r * s, *u],
                (1, 0) => [self.a * c, self.a * s, 1.0],
                (0, 1) => [-sign * r * s, sign * r * c, 0.0],
                _ => return Err(Diagnostic::new(Code::NotDifferentiable, "not needed")),
            };
        }
        Ok(())
    }
}

#[test]
fn seam_has_the_gap_and_the_angle_of_its_edges_whichever_way_they_run() {
    let turn = [0.0, std::f64::consts::TAU];
    let (straight, steep) = (Cone { a: 0.0, turns: false }, Cone { a: 1.0, turns: false });
    // The steep cone begins where the straight one ends, or where its own ends run backwards.
    let edge = |surface: &Cone, position: f64, domain: [f64; 2]| {
        let line = Line { across: Variable::U, position, domain, along: turn };
        Edge::sample(surface, line, 0.0).expect("finite")
    };
    let (low, high) = ([-1.0, 0.0], [0.0, 1.0]);
    let kink = edge(&straight, 0.0, low).meet(&edge(&steep, 0.0, high));
    assert!(kink.gap == 0.0 && (kink.angle_degrees.unwrap() - 45.0).abs() < 1e-12, "{kink:?}");
    let backwards = edge(&straight, 0.0, low).meet(&edge(&Cone { a: 1.0, turns: true }, 0.0, high));
    // Points in the opposite order lie elsewhere by rounding of v.
    assert!(backwards.gap < 1e-14 && (backwards.angle_degrees.unwrap() - 45.0).abs() < 1e-12, "{backwards:?}");
    let folded = edge(&straight, 0.0, high).meet(&edge(&steep, 0.0, high));
    assert!((folded.angle_degrees.unwrap() - 135.0).abs() < 1e-12, "{folded:?}");
    let inside = edge(&straight, 0.0, [-1.0, 1.0]).meet(&edge(&steep, 0.0, high));
    assert!((inside.angle_degrees.unwrap() - 45.0).abs() < 1e-12, "{inside:?}");
    let apart = edge(&straight, 0.25, high).meet(&edge(&steep, 0.0, high));
    assert!((apart.gap - 0.25).abs() < 1e-15, "{apart:?}");
}
