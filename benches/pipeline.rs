//! Times of every stage from the text of Eqs. (29)-(30) to a first evaluated point, and of all together.
//!
//! `cargo bench --bench pipeline`
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};

use trimline::blend::Blend;
use trimline::decompose::decompose;
use trimline::diagnostic::{Diagnostics, Source};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::method::{METHODS, Method, Options, Settings};
use trimline::net::fill;
use trimline::problem::Bindings;
use trimline::resolve::resolve;
use trimline::surface::KnotVector;
use trimline::syntax;
use trimline::tessellate::{Grid, tessellate};

const SPEC: &str = include_str!("../examples/eq29_30.trim");

/// From text to a first point; `is_judged` with the measurement of the solution that users get.
fn first_point(source: &Source, is_judged: bool) -> Result<[f64; 3], Diagnostics> {
    let blend = Blend::compile(source, &Options::default())?;
    let one = |finding| vec![finding];
    let solution = match blend.patches.first() {
        Some(patch) if !is_judged => patch.solve(&blend.bindings, 0.5),
        _ => blend.solve(0, 0.5),
    };
    let solution = solution.map_err(one)?;
    let mut point = [[0.0; 3]];
    solution.surface.evaluate(Derivative::NONE, &[[0.5, 1.0, 0.5]], &mut point).map_err(one)?;
    Ok(point.into_iter().next().unwrap_or_default())
}

fn method_called(name: &str) -> &'static dyn Method {
    METHODS.iter().copied().find(|method| method.name() == name).expect("the name is that of a method")
}

fn stages(criterion: &mut Criterion) {
    let (source, limits) = (Source::new("eq29_30", SPEC), Limits::default());
    let mut group = criterion.benchmark_group("eq29_30");

    group.bench_function("parse", |b| b.iter(|| syntax::parse(black_box(&source), &limits)));
    let document = syntax::parse(&source, &limits).expect("the example parses");

    group.bench_function("resolve", |b| b.iter(|| resolve(black_box(&document), "eq29_30", &limits)));
    let problem = resolve(&document, "eq29_30", &limits).expect("the example resolves");
    let patch = problem.patches.first().expect("the example has a patch");

    group.bench_function("decompose", |b| b.iter(|| decompose(black_box(&problem), patch, &limits)));
    let decomposition = decompose(&problem, patch, &limits).expect("the example decomposes");

    let settings = Settings::read(&patch.solve.settings).expect("the example's settings are valid");
    let options = Options { settings, ..Options::default() };
    let method = method_called("sine");
    group.bench_function("prepare", |b| b.iter(|| method.prepare(black_box(&decomposition), &options)));

    let solver = method.prepare(&decomposition, &options).expect("the example can be prepared");
    let bindings = Bindings::evaluate(&problem).expect("the example's params are finite");
    let domain = patch.domain.evaluate(&problem, &bindings).expect("the example's domain has extent");
    let ranges = [domain.u, domain.v];
    group.bench_function("solve", |b| b.iter(|| solver.solve(black_box(bindings.as_slice()), ranges, 0.5)));

    let solution = solver.solve(bindings.as_slice(), ranges, 0.5).expect("the example can be solved");
    let grid = Grid::new(64, 128, &limits).expect("a small grid");
    group.bench_function("tessellate 64x128", |b| {
        b.iter(|| tessellate("eq29_30", &*solution.surface, (domain.u, domain.v), black_box(0.5), grid));
    });

    for name in ["exact", "sine"] {
        let method = method_called(name);
        let settings = Settings::read(&patch.solve.settings).expect("the example's settings are valid");
        let options = Options { settings: settings.only(method.settings()), ..Options::default() };
        let solver = method.prepare(&decomposition, &options).expect("the example can be prepared");
        group.bench_function(format!("solve by {name}"), |b| {
            b.iter(|| solver.solve(black_box(bindings.as_slice()), ranges, 0.5));
        });
    }

    group.bench_function("text to first point", |b| b.iter(|| first_point(black_box(&source), false)));
    group.bench_function("text to first point, measured", |b| b.iter(|| first_point(black_box(&source), true)));
    group.finish();
}

/// A document of as many vector constraints, four in each patch, whose data go through a definition of the patch.
fn document_of(constraints: usize) -> String {
    let patch = |i: usize| {
        let (from, to) = (i, i + 1);
        format!(
            "patch p{i} {{\n domain u in [{from}, {to}]\n let ring{i}(s) = [s cos(v + {i} t), s sin(v + {i} t), {i}]\n \
             at u = {from}: S = ring{i}(r), dS/du = [0, 0, h]\n at u = {to}: S = ring{i}(2 r), dS/du = [0, 0, h]\n}}\n"
        )
    };
    let patches: String = (0..constraints / 4).map(patch).collect();
    format!("param r = 1, h = 2\n{patches}")
}

/// Parsing and resolving are linear in the size of the document: four times the constraints, four times as long.
fn long_documents(criterion: &mut Criterion) {
    let limits = Limits::default();
    let mut group = criterion.benchmark_group("constraints");
    for constraints in [250, 1000] {
        let source = Source::new("long", document_of(constraints));
        group.bench_function(format!("parse and resolve {constraints}"), |b| {
            b.iter(|| resolve(&syntax::parse(black_box(&source), &limits)?, "long", &limits));
        });
    }
    group.finish();
}

/// The largest net of docs/bspline.md.
fn nets(criterion: &mut Criterion) {
    let Ok(knots) = KnotVector::clamped_uniform(3, 501) else { return };
    let place = |index: usize| [(index % 501) as f64, (index / 501) as f64, libm::sin(index as f64)];
    let layers: Vec<[f64; 3]> = (0..501 * 501).map(place).collect();
    criterion.bench_function("fill a net of 501x501", |b| b.iter(|| fill(&knots, &knots, black_box(&layers))));
}

/// A model of 100 patches with data on four sides: 25 loops of four bowed edges, which move.
fn model_of_loops() -> String {
    let mut text = "param k = 1\n".to_owned();
    for index in 0..25 {
        let (x, y) = (3 * (index % 5), 3 * (index / 5));
        let corners = [(x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2), (x, y)];
        text += &format!("nsided hole{index} {{\n");
        for (edge, pair) in corners.windows(2).enumerate() {
            if let [(a, b), (c, d)] = pair {
                let sag = f64::from(edge as u32 + 1) * 0.1;
                text += &format!("edge [{a} (1 - u) + {c} u, {b} (1 - u) + {d} u, {sag} k u (1 - u) (1 + t)]\n");
            }
        }
        text += "}\n";
    }
    text
}

/// Compiles, solves and judges a whole model at three instants, as `check` does at nine.
fn models(criterion: &mut Criterion) {
    let source = Source::new("model", model_of_loops());
    let mut group = criterion.benchmark_group("model of 100 patches");
    group.sample_size(10);
    group.bench_function("compile, solve and judge at 3 instants", |b| {
        b.iter(|| -> Result<(), Diagnostics> {
            let blend = Blend::compile(black_box(&source), &Options::default())?;
            for prepared in &blend.patches {
                for t in [0.0, 0.4, 1.0] {
                    let solved = prepared.solve_judged(&blend.problem, &blend.bindings, t);
                    black_box(solved.map_err(|finding| vec![finding])?);
                }
            }
            Ok(())
        });
    });
    group.finish();
}

criterion_group!(benches, stages, long_documents, nets, models);
criterion_main!(benches);
