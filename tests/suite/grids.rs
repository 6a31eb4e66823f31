//! Grids and scattered points against the plain formula, and the same bits whatever the machine has and wherever it runs.

use std::sync::Arc;

use trimline::eval::Backend;
use trimline::expr::{Derivative, Function, Graph, Variable};
use trimline::kernels::InstructionSet;
use trimline::kernels::grid::{Across, Along, Number, Outputs, Stores, bound, positions, shape};
use trimline::limits::Limits;
use trimline::surface::{Basis, SeparableSurface, Surface, SurfaceOnGrid};
use trimline::trial::{CorrectedTrial, Sine};

/// Numbers between -1 and 1 without a pattern.
fn number(seed: usize, index: usize) -> f64 {
    let x = (seed as f64 * 0.618_033_988_749_894_9 + index as f64 * 0.414_213_562_373_095_1).fract();
    2.0 * x - 1.0
}

/// Tables of `rank` terms, vectors along v or across u, and the plain sum in doubles.
struct Tables<N> {
    across: Across<N>,
    along: Along<N>,
    expected: Vec<[f64; 3]>,
}

fn tables<N: Number>((rows, columns, rank): (usize, usize, usize), vectors_along: bool, seed: usize) -> Tables<N> {
    let parts = parts(rank);
    let mut across =
        if vectors_along { Across::scalars(rows, rank) } else { Across::vectors(rows, rank, parts.clone()) };
    let mut along = if vectors_along { Along::vectors(rank, columns) } else { Along::scalars(rank, columns) };
    let left: Vec<Vec<f64>> = across.rows_mut().enumerate().map(|(i, row)| written(row, seed + 7 * i)).collect();
    let right: Vec<Vec<f64>> =
        along.rows_mut().enumerate().map(|(r, row)| written(row, seed + 1000 + 11 * r)).collect();
    let before = |c: usize| parts[..c].iter().map(Vec::len).sum::<usize>();
    let term = |i: usize, j: usize, r: usize, c: usize| match vectors_along {
        true => left[i][r] * right[3 * r + c][j],
        false => {
            let place = parts[c].iter().position(|of| *of == r);
            place.map_or(0.0, |place| left[i][before(c) + place] * right[r][j])
        }
    };
    let point = |i, j| [0, 1, 2].map(|c| (0..rank).map(|r| term(i, j, r, c)).sum());
    let expected = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| point(i, j)).collect();
    Tables { across, along, expected }
}

/// Which of `rank` vectors have an x, a y and a z.
fn parts(rank: usize) -> [Vec<usize>; 3] {
    [(0..rank).collect(), (0..rank).filter(|r| r % 3 != 1).collect(), (0..rank).filter(|r| r % 2 == 1).collect()]
}

fn written<N: Number>(row: &mut [N], seed: usize) -> Vec<f64> {
    row.iter_mut().enumerate().for_each(|(index, slot)| *slot = N::rounded(number(seed, index)));
    row.iter().map(|x| x.to_f64()).collect()
}

fn bits<N: Number>(points: &[[N; 3]]) -> Vec<u64> {
    points.iter().flatten().map(|x| x.to_f64().to_bits()).collect()
}

/// One size with every instruction set, kind of store and place in memory: one result, that of the plain sum.
fn check_positions<N: Number + std::fmt::Debug>(size: (usize, usize, usize), vectors_along: bool, epsilon: f64) {
    let (rows, columns, rank) = size;
    let Tables { across, along, expected } = tables::<N>(size, vectors_along, rank);
    let along = along.interleaved();
    let mut first: Option<Vec<u64>> = None;
    for set in InstructionSet::available() {
        for stores in [Stores::Cached, Stores::Streamed] {
            for shift in [0, 1, 5] {
                let outside = N::rounded(77.0);
                let mut buffer = vec![[outside; 3]; shift + rows * columns + 20];
                let target = &mut buffer[shift..shift + rows * columns];
                positions(set, stores, (&across, &along), 0..rows, target);
                for (found, expected) in target.iter().zip(&expected) {
                    for (found, expected) in found.iter().zip(expected) {
                        // One rounding for each of `rank` terms of size 1, in the kernel and in the doubles.
                        let error = (found.to_f64() - expected).abs();
                        assert!(error <= 2.0 * (rank * rank) as f64 * epsilon, "{size:?} {}: {error}", set.name());
                    }
                }
                let found = bits(target);
                assert!(*first.get_or_insert_with(|| found.clone()) == found, "{size:?} {} {shift}", set.name());
                let around = buffer[..shift].iter().chain(&buffer[shift + rows * columns..]);
                assert!(around.flatten().all(|x| *x == outside), "{size:?} {stores:?}: written outside");
                // The same by rows, as threads do it.
                let mut parts = vec![[outside; 3]; rows * columns];
                let step = rows.div_ceil(3).max(1);
                for (part, points) in parts.chunks_mut(step * columns.max(1)).enumerate() {
                    positions(set, stores, (&across, &along), part * step..rows.min((part + 1) * step), points);
                }
                assert!(bits(&parts) == found, "{size:?}: in parts");
            }
        }
    }
}

const SIZES: [(usize, usize, usize); 9] =
    [(1, 1, 1), (1, 40, 3), (2, 7, 4), (3, 16, 5), (9, 17, 2), (8, 24, 9), (65, 33, 3), (130, 8, 2), (129, 50, 1)];

#[test]
fn grid_of_any_size_is_the_plain_sum_with_the_same_bits_on_every_instruction_set() {
    for size in SIZES {
        for vectors_along in [true, false] {
            check_positions::<f64>(size, vectors_along, f64::EPSILON);
            check_positions::<f32>(size, vectors_along, f64::from(f32::EPSILON));
        }
    }
}

#[test]
fn empty_grids_and_tables_that_do_not_fit_write_nothing() {
    let Tables { across, along, .. } = tables::<f64>((4, 5, 3), true, 1);
    let along = along.interleaved();
    let other = tables::<f64>((4, 5, 2), true, 1).along.interleaved();
    let mut points = vec![[7.0; 3]; 20];
    for set in InstructionSet::available() {
        positions(set, Stores::Cached, (&across, &along), 0..0, &mut points);
        positions(set, Stores::Cached, (&across, &along), 9..12, &mut points);
        positions(set, Stores::Cached, (&across, &other), 0..4, &mut points);
        positions(
            set,
            Stores::Cached,
            (&Across::scalars(4, 0), &Along::vectors(3, 0).interleaved()),
            0..4,
            &mut points,
        );
        positions::<f64>(set, Stores::Streamed, (&across, &along), 0..4, &mut []);
        assert!(points.iter().flatten().all(|x| *x == 7.0));
    }
    // A rank of zero is a sum of nothing.
    let nothing = (&Across::scalars(4, 0), &Along::vectors(0, 5).interleaved());
    positions(InstructionSet::best(), Stores::Cached, nothing, 0..4, &mut points);
    assert!(points.iter().flatten().all(|x| *x == 0.0));
}

#[test]
fn bound_holds_and_is_not_finite_where_a_factor_is_not() {
    let Tables { across, mut along, expected } = tables::<f64>((9, 17, 4), true, 3);
    let largest = expected.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let found = bound(&across, &across.largest(), &along);
    assert!((largest..=4.0).contains(&found), "{largest} {found}");
    for value in [f64::NAN, f64::INFINITY] {
        *along.rows_mut().nth(7).unwrap().last_mut().unwrap() = value;
        assert!(!bound(&across, &across.largest(), &along).is_finite());
    }
}

fn cross([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn check_shape<N: Number>(size: (usize, usize, usize), vectors_along: bool, epsilon: f64) {
    let (rows, columns, rank) = size;
    let count = rows * columns;
    let value = tables::<N>(size, vectors_along, 5);
    let slope = tables::<N>(size, vectors_along, 900);
    let mut first: Option<(Vec<Vec<u64>>, f64)> = None;
    for set in InstructionSet::available() {
        for (stores, shift) in [(Stores::Cached, 0), (Stores::Streamed, 0), (Stores::Streamed, 1)] {
            let zero = [N::default(); 3];
            let mut outputs = [(); 4].map(|()| vec![zero; count + shift]);
            let [p, n, u, v] = outputs.each_mut().map(|output| &mut output[shift..]);
            let tables = ([&value.across, &slope.across], [&value.along, &slope.along]);
            let targets = Outputs { positions: p, normals: n, tangents: Some([u, v]) };
            let least = shape(set, stores, tables, 0..rows, targets);
            let found: Vec<Vec<u64>> = outputs.iter().map(|output| bits(&output[shift..])).collect();
            let expected = first.get_or_insert_with(|| (found.clone(), least));
            assert!(*expected == (found, least), "{size:?} {stores:?} {}", set.name());
            // Without tangents, the same.
            let [mut p, mut n] = [(); 2].map(|()| vec![zero; count]);
            let targets = Outputs { positions: &mut p, normals: &mut n, tangents: None };
            shape(set, stores, tables, 0..rows, targets);
            assert!(vec![bits(&p), bits(&n)] == expected.0[..2], "{size:?} {}", set.name());
            if shift > 0 {
                continue;
            }
            let doubles = outputs.map(|output| output.iter().map(|x| x.map(N::to_f64)).collect::<Vec<_>>());
            let [p, n, u, v] = &doubles;
            let mut smallest = f64::INFINITY;
            for (index, expected) in value.expected.iter().enumerate() {
                let normal = cross(u[index], v[index]);
                let square: f64 = normal.iter().map(|x| x * x).sum();
                smallest = smallest.min(square);
                for c in 0..3 {
                    assert!((p[index][c] - expected[c]).abs() <= 2.0 * (rank * rank) as f64 * epsilon);
                    // Products of tangents of size `rank`, over the length of their product.
                    let error = (n[index][c] - normal[c] / square.sqrt()).abs();
                    assert!(
                        error <= 16.0 * epsilon * (1.0 + (rank * rank) as f64 / square.sqrt()),
                        "{size:?}: {error}"
                    );
                }
            }
            let error = (smallest - least).abs();
            assert!(error <= 64.0 * epsilon * (rank * rank) as f64 * smallest.sqrt().max(1.0), "{smallest} {least}");
        }
    }
}

#[test]
fn normals_of_a_grid_are_unit_products_of_the_tangents_on_every_instruction_set() {
    for size in [(1, 1, 3), (2, 7, 4), (3, 16, 3), (9, 37, 5), (65, 33, 4), (40, 8, 3)] {
        for vectors_along in [true, false] {
            check_shape::<f64>(size, vectors_along, f64::EPSILON);
            check_shape::<f32>(size, vectors_along, f64::from(f32::EPSILON));
        }
    }
}

/// `1, t, cos v, sin v, t cos v, t sin v` as far as `count`, over four cardinal functions and two sines.
fn surface(count: usize, instant: Option<f64>) -> SeparableSurface {
    let mut graph = Graph::new();
    let (one, v, t) = (graph.integer(1), graph.variable(Variable::V), graph.variable(Variable::T));
    let (cosine, sine) = (graph.call(Function::Cos, &[v]), graph.call(Function::Sin, &[v]));
    let (moving_cosine, moving_sine) = (graph.product([t, cosine]), graph.product([t, sine]));
    let more: Vec<_> = (2..8)
        .map(|k| {
            let k = graph.integer(k);
            let argument = graph.product([k, v]);
            graph.call(Function::Sin, &[argument])
        })
        .collect();
    let functions = [one, t, cosine, sine, moving_cosine, moving_sine].into_iter().chain(more).take(count);
    let functions: Vec<_> = functions.map(|function| (function, None)).collect();
    let basis = Basis::new(&graph, &functions, Backend::Auto, &Limits::default());
    let functionals = [(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)];
    let modes = CorrectedTrial::new(Arc::new(Sine), 2, [0.0, 1.0], &functionals).expect("independent");
    let table = |seed: usize| {
        let vector = |index: usize| [0, 1, 2].map(|c| number(seed + c, index));
        // Some are zero: these are left out of sums.
        (0..6 * count).map(|index| if index % 5 == 4 { [0.0; 3] } else { vector(index) }).collect()
    };
    SeparableSurface {
        modes: Arc::new(modes),
        basis: Arc::new(basis),
        params: Vec::new(),
        coefficients: Arc::new(if instant.is_some() { vec![table(1), table(2)] } else { vec![table(1)] }),
        instant,
    }
}

const DERIVATIVES: [(usize, usize, usize); 6] = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (2, 1, 0), (0, 0, 1), (0, 4, 1)];

#[test]
fn grid_and_scattered_points_of_a_surface_have_the_same_bits_and_are_the_sum_of_products() {
    // Fewer functions than modes, as many, more; coefficients for all t, and for one instant with a derivative in t.
    for (count, instant) in [(3, None), (6, None), (12, None), (3, Some(0.4)), (12, Some(0.4))] {
        let surface = surface(count, instant);
        let (u, v, t) = ([0.0, 0.31, 0.77, 1.0], (0..19).map(|j| 0.3 * f64::from(j)).collect::<Vec<_>>(), 0.4);
        let points: Vec<_> = u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v, t])).collect();
        // More than a block, so that blocks meet.
        let many: Vec<_> = points.iter().cycle().take(1000).copied().collect();
        for (du, dv, dt) in DERIVATIVES {
            let derivative = Derivative::new(du, dv, dt);
            let mut grid = vec![[0.0; 3]; points.len()];
            surface.evaluate_grid(derivative, (&u, &v, t), &mut grid).expect("finite");
            let mut scattered = vec![[0.0; 3]; many.len()];
            surface.evaluate(derivative, &many, &mut scattered).expect("finite");
            for (index, value) in scattered.iter().enumerate() {
                assert_eq!(value, &grid[index % grid.len()], "{derivative} {index}");
            }
            for ([u, v, t], found) in points.iter().zip(&grid) {
                let mut expected = [0.0; 3];
                let mut size = 0.0;
                for (s, coefficients) in surface.coefficients.iter().enumerate().take(dt + 1) {
                    let orders = Derivative::new(0, dv, dt - s);
                    let basis = surface.basis.values(orders, &[], &[*v], &[*t]).expect("finite");
                    for (m, mode) in surface.modes.derivatives(du, *u).iter().enumerate() {
                        for (j, function) in basis.iter().enumerate() {
                            for (sum, c) in expected.iter_mut().zip(coefficients[m * count + j]) {
                                *sum += mode * function * c;
                                size += (mode * function * c).abs();
                            }
                        }
                    }
                }
                for (found, expected) in found.iter().zip(expected) {
                    // Some roundings of each term.
                    assert!((found - expected).abs() <= 8.0 * f64::EPSILON * size, "{derivative}: {found} {expected}");
                }
            }
        }
    }
}

#[test]
fn several_derivatives_at_once_are_the_single_ones() {
    for (count, instant) in [(3, None), (12, Some(0.4))] {
        let surface = surface(count, instant);
        let points: Vec<_> = (0..700).map(|i| [0.5 + 0.5 * number(1, i), 3.0 * number(2, i), 0.4]).collect();
        let derivatives = DERIVATIVES.map(|(u, v, t)| Derivative::new(u, v, t));
        let mut all = vec![vec![[0.0; 3]; points.len()]; derivatives.len()];
        let mut targets: Vec<&mut [[f64; 3]]> = all.iter_mut().map(Vec::as_mut_slice).collect();
        surface.evaluate_all(&derivatives, &points, &mut targets).expect("finite");
        for (derivative, found) in derivatives.into_iter().zip(&all) {
            let mut single = vec![[0.0; 3]; points.len()];
            surface.evaluate(derivative, &points, &mut single).expect("finite");
            assert_eq!(&single, found, "{derivative}");
        }
    }
}

#[test]
fn values_that_overflow_are_refused_on_grids_and_at_points() {
    let mut surface = surface(3, None);
    let large = surface.coefficients[0].iter().map(|coefficient| coefficient.map(|x| 1e308 * (x + 2.0)));
    surface.coefficients = Arc::new(vec![large.collect()]);
    let axes: (&[f64], &[f64], f64) = (&[0.2, 0.5], &[0.0, 0.1, 0.2], 1.0);
    let refused = surface.evaluate_grid(Derivative::NONE, axes, &mut [[0.0; 3]; 6]).unwrap_err();
    assert!(refused.message.contains("not finite"), "{}", refused.message);
    assert!(surface.shape(axes).is_err());
    assert!(surface.evaluate(Derivative::NONE, &[[0.5, 0.1, 1.0]], &mut [[0.0; 3]]).is_err());
}

#[test]
fn frames_on_one_grid_are_those_of_a_grid_each() {
    let surface = surface(6, None);
    let (u, v): (Vec<f64>, Vec<f64>) = (0..9).map(|i| (f64::from(i) / 8.0, 0.4 * f64::from(i))).unzip();
    let mut grid = SurfaceOnGrid::new(&u, &v);
    for t in [0.0, 0.3, 0.9] {
        let mut expected = vec![[0.0; 3]; 81];
        surface.evaluate_grid(Derivative::NONE, (&u, &v, t), &mut expected).expect("finite");
        let (mut found, mut single) = (vec![[0.0; 3]; 81], vec![[0.0_f32; 3]; 81]);
        grid.evaluate(&surface, Derivative::NONE, t, &mut found).expect("finite");
        assert_eq!(found, expected);
        grid.evaluate(&surface, Derivative::NONE, t, &mut single).expect("finite");
        for (single, expected) in single.iter().flatten().zip(expected.iter().flatten()) {
            // A dozen roundings of terms below 20.
            assert!((f64::from(*single) - expected).abs() < 12.0 * 20.0 * f64::from(f32::EPSILON));
        }
        let shape = grid.shape(&surface, t).expect("finite");
        assert_eq!(shape.positions, expected);
        for set in InstructionSet::available() {
            assert_eq!(SurfaceOnGrid::new(&u, &v).with_instructions(set).shape(&surface, t).expect("finite"), shape);
        }
    }
}
