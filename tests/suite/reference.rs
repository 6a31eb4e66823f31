//! Numbers that were computed elsewhere: published ones, and solves repeated here in the plainest way.

use nalgebra::{DMatrix, SVD};
use serde_json::Value;

use trimline::diagnostic::Code;
use trimline::expr::{Derivative, Notation};
use trimline::limits::Limits;
use trimline::verify::verify;

use crate::spec::{Prepared, at, example, examples, patch, separable};

const FILES: [&str; 6] = ["K5_mid", "K5_end", "K7_mid", "K7_end", "K10_mid", "K10_end"];

struct Reference(Value);

impl Reference {
    fn read(case: &str) -> Reference {
        let path = format!("{}/tests/reference/eq19_sine_{case}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("a reference file");
        Reference(serde_json::from_str(&text).expect("JSON"))
    }

    fn vectors(&self, key: &str) -> Vec<[f64; 3]> {
        let rows = self.0[key].as_array().expect("rows");
        rows.iter().map(|row| [0, 1, 2].map(|axis| row[axis].as_f64().expect("a number"))).collect()
    }

    fn solve(&self, t: f64) -> (Prepared, trimline::method::Solution) {
        let settings = &self.0["settings"];
        let terms = settings["terms"].to_string();
        let points = settings["points"].as_str().expect("a grid");
        let prepared = Prepared::new(&example("eq19"), &[("terms", &terms), ("points", points)]);
        let solution = prepared.solve(t);
        (prepared, solution)
    }
}

fn largest(vectors: &[[f64; 3]]) -> f64 {
    vectors.iter().flatten().fold(0.0, |most, value| most.max(value.abs()))
}

#[test]
fn published_surface_of_eq19_is_reproduced_with_its_tangents() {
    for case in FILES {
        let reference = Reference::read(case);
        let points = reference.vectors("points");
        let size = largest(&reference.vectors("S"));
        let solved = [0.0, 0.1, 0.2, 0.3].map(|t| (t, reference.solve(t).1.surface));
        let surface_at = |t: f64| solved.iter().find(|(instant, _)| *instant == t).expect("a solved instant").1.clone();
        for (key, derivative) in [("S", ""), ("S_u", "u"), ("S_v", "v")] {
            for (point, expected) in points.iter().zip(reference.vectors(key)) {
                let found = at(&*surface_at(point[2]), derivative, *point);
                for axis in 0..3 {
                    let error = (found[axis] - expected[axis]).abs();
                    // The reference's own bound for least squares: rounding times a condition of up to 8e3.
                    assert!(error <= 1e-10 * size, "{case} {key} {point:?} {axis}: {error:.1e}");
                }
            }
        }
    }
}

#[test]
fn published_coefficients_of_eq19_are_reproduced() {
    for case in FILES {
        let reference = Reference::read(case);
        for t in [0.0, 0.3] {
            let (prepared, solution) = reference.solve(t);
            let basis = &prepared.decomposition.basis;
            let names: Vec<&str> =
                reference.0["basis"].as_array().expect("names").iter().filter_map(Value::as_str).collect();
            let columns: Vec<usize> = names.iter().map(|name| position_of(&prepared, name)).collect();
            let stated = reference.0["coefficients"].as_object().expect("coefficients");
            assert_eq!(stated.len(), 5);
            let most = stated.values().flat_map(|values| values.as_array().expect("values"));
            let most = most.filter_map(Value::as_f64).fold(0.0_f64, |most, value| most.max(value.abs()));
            for (key, values) in stated {
                let component = "xyz".find(&key[..1]).expect("a component");
                let j = columns[key[1..].parse::<usize>().expect("a number") - 1];
                for (k, expected) in values.as_array().expect("values").iter().enumerate() {
                    let found = separable(&solution).coefficients[0][(4 + k) * basis.len() + j][component];
                    let error = (found - expected.as_f64().expect("a number")).abs();
                    // A condition of up to 8e3 times a few hundred rounding errors of the largest coefficient.
                    assert!(error <= 1e-10 * most, "{case} t = {t} {key} k = {}: {error:.1e}", k + 1);
                }
            }
        }
    }
}

fn position_of(prepared: &Prepared, name: &str) -> usize {
    let decomposition = &prepared.decomposition;
    let text = |expr| decomposition.text_of(expr, Notation::Ascii, &Limits::default()).expect("short");
    let found = decomposition.basis.iter().position(|function| text(function.expr) == name);
    found.unwrap_or_else(|| panic!("{name} is not in the basis"))
}

/// reference/dynamic.md, section 4: `cond Phi (j = 1)` for K terms on 11 x 11 end points and 11 x 11 midpoints.
#[test]
fn published_conditions_of_eq19_are_reproduced_to_their_two_digits() {
    let only_first = "pde with beta = 1, gamma = 12.1, lambda = 1, rho = 1, eta = 1
        at u = 0: S = [e^t sin v, 0, 0], dS/du = 0
        at u = 1: S = 0, dS/du = 0
        solve sine";
    let published: [(usize, f64, f64); 10] = [
        (1, 1.0, 1.0),
        (2, 1.3e1, 1.4e1),
        (3, 6.8e1, 7.2e1),
        (4, 2.0e2, 2.2e2),
        (5, 4.9e2, 5.3e2),
        (6, 1.0e3, 1.1e3),
        (7, 1.9e3, 2.0e3),
        (8, 3.1e3, 3.4e3),
        (9, 5.0e3, 5.4e3),
        (10, 5.0e3, 8.3e3),
    ];
    for (terms, ends, midpoints) in published {
        for (points, expected) in [("11x11:ends", ends), ("11x11:midpoints", midpoints)] {
            let prepared = Prepared::new(only_first, &[("terms", &terms.to_string()), ("points", points)]);
            assert_eq!(prepared.decomposition.basis.len(), 1);
            let found = prepared.solve(0.0).report.condition.expect("a fit has one");
            // One unit of the second digit: for K = 7 the table has 1.9e3, and 3.4e6 = 1844^2 for its square.
            let unit = 10_f64.powf(expected.log10().floor() - 1.0);
            assert!((found - expected).abs() <= unit, "K = {terms}, {points}: {found} {expected}");
        }
    }
}

/// On the paper's grid `sin(10πu_l)` is zero, so the tenth term of F = 1 is one that no point determines.
#[test]
fn aliased_grid_of_the_paper_leaves_a_term_undetermined_and_says_so() {
    let data = "pde with gamma = 12.1, rho = 1, eta = 1
        at u = 0: S = [1, 0, 0], dS/du = [1, 0, 0]
        at u = 1: S = 0, dS/du = 0
        solve sine, terms = 10, points = 11 x 11 : ends";
    let solution = Prepared::new(data, &[]).solve(0.0);
    assert_eq!(solution.report.rank, 9);
    assert_eq!(solution.report.warnings.first().map(|warning| warning.code), Some(Code::RankDeficient));
    // The equation is met by the cubic alone, so the undetermined term does no harm here.
    assert!(separable(&solution).coefficients[0][4..].iter().flatten().all(|value| value.abs() < 1e-12));
}

#[test]
fn every_example_meets_its_boundary_data_at_every_instant() {
    for (name, text) in examples() {
        let prepared = Prepared::new(&text, &[]);
        let [low, high] = prepared.domain.t;
        for share in [0.0, 0.2, 0.5, 0.77, 1.0] {
            let t = low + share * (high - low);
            let solution = prepared.solve(t);
            let patch = patch(&prepared.problem);
            let numbers = (&prepared.bindings, &prepared.domain, t);
            let found = verify(&prepared.problem, patch, &*solution.surface, numbers).expect("finite data");
            assert_eq!(found.boundary_errors.len(), patch.conditions.len() + patch.side_conditions.len());
            // Interpolation is exact; what is left is rounding of sums of a few terms the size of the surface, and what a
            // series without a remainder says that it leaves out.
            let left_out = solution.report.truncation.filter(|truncation| !truncation.has_remainder);
            let announced = left_out.map_or(0.0, |truncation| 2.0 * truncation.left_out);
            // The default tolerance, four times which is accepted.
            assert!(announced <= 8e-12 * found.data_size, "{name} t = {t}: {announced:e}");
            assert!(found.boundary_error() <= announced + 1e-12 * found.size.max(1.0), "{name} t = {t}: {found:?}");
            // A cubic has no fourth derivative, so an equation of that term alone has no size.
            let has_size = found.largest_term > 0.0 || patch.operator.terms.len() == 1;
            assert!(found.residual.is_finite() && has_size, "{name} t = {t}: {found:?}");
        }
    }
}

/// ζ_k and its derivatives in closed form, and the cubics of Hermite.
fn zeta(k: usize, order: usize, u: f64) -> f64 {
    let wave = std::f64::consts::PI * k as f64;
    let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    let (b, c, d) = (-wave, wave * (2.0 + sign), -wave * (1.0 + sign));
    let sin = (wave * u).sin();
    match order {
        0 => sin + b * u + c * u * u + d * u * u * u,
        2 => -wave * wave * sin + 2.0 * c + 6.0 * d * u,
        _ => wave.powi(4) * sin,
    }
}

fn hermite(order: usize, u: f64) -> [f64; 4] {
    match order {
        0 => [1.0 - 3.0 * u * u + 2.0 * u.powi(3), u - 2.0 * u * u + u.powi(3), 3.0 * u * u - 2.0 * u.powi(3), {
            u.powi(3) - u * u
        }],
        2 => [12.0 * u - 6.0, 6.0 * u - 4.0, 6.0 - 12.0 * u, 6.0 * u - 2.0],
        _ => [0.0; 4],
    }
}

#[test]
fn all_rows_at_once_give_the_fit_of_the_reduced_rows() {
    let (t, terms, count) = (0.5, 10, 11);
    let prepared = Prepared::new(&example("eq29_30"), &[]);
    let solution = prepared.solve(t);
    let decomposition = &prepared.decomposition;
    let mut graph = decomposition.graph.clone();
    let params = prepared.bindings.as_slice();
    let nodes = |low: f64, high: f64| (0..count).map(move |l| low + (high - low) * (l as f64 + 0.5) / count as f64);
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for (j, function) in decomposition.basis.iter().enumerate() {
        let [value, vv, vvvv, t1, tt] = [(0, 0), (2, 0), (4, 0), (0, 1), (0, 2)]
            .map(|(v, t)| graph.derivative(function.expr, Derivative::new(0, v, t)).expect("smooth functions"));
        let stated = DMatrix::from_fn(4, 3, |condition, component| {
            graph.value(decomposition.coefficients[condition][j][component], params, [0.0; 3])
        });
        let mut rows = Vec::new();
        let mut right = Vec::new();
        for u in nodes(0.0, 1.0) {
            for v in nodes(0.0, std::f64::consts::TAU) {
                let [f, vv, vvvv, t1, tt] =
                    [value, vv, vvvv, t1, tt].map(|expr| graph.value(expr, params, [f64::NAN, v, t]));
                // β = λ = ρ = η = 1, γ = 12.1
                let residual =
                    |order: &dyn Fn(usize) -> f64| f * order(4) + 12.1 * vv * order(2) + (vvvv + tt + t1) * order(0);
                rows.extend((1..=terms).map(|k| residual(&|order| zeta(k, order, u))));
                right.extend((0..3).map(|axis| {
                    -residual(&|order| {
                        hermite(order, u).iter().zip(stated.column(axis).iter()).map(|(h, c)| h * c).sum()
                    })
                }));
            }
        }
        let matrix = DMatrix::from_row_slice(count * count, terms, &rows);
        let right = DMatrix::from_row_slice(count * count, 3, &right);
        let svd = SVD::new(matrix, true, true);
        let expected = svd.solve(&right, 1e-12 * svd.singular_values.max()).expect("vectors were computed");
        for k in 0..terms {
            for axis in 0..3 {
                let found = separable(&solution).coefficients[0][(4 + k) * decomposition.basis.len() + j][axis];
                most = most.max(found.abs());
                worst = worst.max((found - expected[(k, axis)]).abs());
            }
        }
    }
    // Both lose a condition of 8e3 on rounding, and its square on the part that no fit reaches.
    assert!(worst <= 1e-10 * most, "{worst:.1e} of {most:.1e}");
    assert!(most > 1e-3, "the fit is not trivial: {most:.1e}");
}

#[test]
fn derivatives_of_the_fit_in_time_are_its_differences() {
    let prepared = Prepared::new(&example("eq29_30"), &[]);
    // Fourth-order differences: the error is h^4 times a sixth derivative, rounding is 1e-16 condition / h^2.
    let (t, h) = (0.5, 0.02);
    let solved: Vec<_> = (-2..=2).map(|step| prepared.solve(t + f64::from(step) * h)).collect();
    let first = |f: [f64; 5]| (f[0] - 8.0 * f[1] + 8.0 * f[3] - f[4]) / (12.0 * h);
    let second = |f: [f64; 5]| (-f[0] + 16.0 * f[1] - 30.0 * f[2] + 16.0 * f[3] - f[4]) / (12.0 * h * h);
    let steps = |value: &dyn Fn(usize) -> f64| [0, 1, 2, 3, 4].map(value);
    let mut compared = [0.0_f64; 2];
    for index in 0..separable(&solved[2]).coefficients[0].len() {
        for axis in 0..3 {
            let found = [1, 2].map(|order| separable(&solved[2]).coefficients[order][index][axis]);
            let values = steps(&|step| separable(&solved[step]).coefficients[0][index][axis]);
            for (order, expected) in [first(values), second(values)].into_iter().enumerate() {
                let error = (found[order] - expected).abs();
                assert!(error < 2e-5, "order {}, coefficient {index}: {error:.1e}", order + 1);
                compared[order] = compared[order].max(expected.abs());
            }
        }
    }
    // Hundreds of times the tolerance: the test would see a derivative that is left out.
    assert!(compared[0] > 2e-3 && compared[1] > 2e-3, "{compared:?}");
    for point in [[0.3, 1.0], [0.7, 4.0], [0.5, 5.9]] {
        for axis in 0..3 {
            let position = |step: usize| {
                let time = t + (step as f64 - 2.0) * h;
                at(&*solved[step].surface, "", [point[0], point[1], time])[axis]
            };
            let values = steps(&position);
            for (letters, expected) in [("t", first(values)), ("tt", second(values))] {
                let found = at(&*solved[2].surface, letters, [point[0], point[1], t])[axis];
                assert!((found - expected).abs() < 2e-5, "{letters} at {point:?}: {found} {expected}");
            }
        }
    }
}

#[test]
fn derivative_in_time_beyond_the_equation_is_refused_by_name() {
    let prepared = Prepared::new(&example("eq19"), &[]);
    let solution = prepared.solve(0.1);
    let mut values = [[0.0; 3]];
    let orders = Derivative::new(0, 0, 3);
    let found = solution.surface.evaluate(orders, &[[0.5, 1.0, 0.1]], &mut values).expect_err("not known");
    assert!(found.message.contains("order 3 in t"), "{found}");
    let found =
        solution.surface.evaluate(Derivative::NONE, &[[0.5, 1.0, 0.2]], &mut values).expect_err("other instant");
    assert!(found.message.contains("holds at t = 0.1"), "{found}");
}
