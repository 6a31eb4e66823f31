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
use trimline::method::{Options, Settings, choose};
use trimline::problem::Bindings;
use trimline::resolve::resolve;
use trimline::syntax;
use trimline::tessellate::{Grid, tessellate};

const SPEC: &str = include_str!("../examples/eq29_30.trim");

fn first_point(source: &Source) -> Result<[f64; 3], Diagnostics> {
    let blend = Blend::compile(source, &Options::default())?;
    let one = |finding| vec![finding];
    let solution = blend.solve(0, 0.5).map_err(one)?;
    let mut point = [[0.0; 3]];
    solution.surface.evaluate(Derivative::NONE, &[[0.5, 1.0, 0.5]], &mut point).map_err(one)?;
    Ok(point.into_iter().next().unwrap_or_default())
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
    let method = choose(Some("sine"), None, &decomposition, &limits).expect("the method accepts the example");
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
        let method = choose(Some(name), None, &decomposition, &limits).expect("both methods accept the example");
        let settings = Settings::read(&patch.solve.settings).expect("the example's settings are valid");
        let options = Options { settings: settings.only(method.settings()), ..Options::default() };
        let solver = method.prepare(&decomposition, &options).expect("the example can be prepared");
        group.bench_function(format!("solve by {name}"), |b| {
            b.iter(|| solver.solve(black_box(bindings.as_slice()), ranges, 0.5));
        });
    }

    group.bench_function("text to first point", |b| b.iter(|| first_point(black_box(&source))));
    group.finish();
}

criterion_group!(benches, stages);
criterion_main!(benches);
