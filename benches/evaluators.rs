//! Ratios, each measured in one run: the basis of Eqs. (29)-(30) beside what a C compiler makes of it, grids beside what
//! the machine can store, scattered points beside its arithmetic, and memory over many compilations.
//!
//! `cargo bench --bench evaluators`, with part of a name to run what has it in its name. The C program
//! (benches/peers/basis.c) is compiled with `cc` and the vector library of glibc; without them its rows are missing.
#![allow(missing_docs)]

use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

use trimline::blend::Blend;
use trimline::diagnostic::{Diagnostic, Diagnostics, Source};
use trimline::eval::{Backend, Jet, JetValues, Program, Samples, compile};
use trimline::expr::{Derivative, ExprId, Graph, Number};
use trimline::kernels::grid::Outputs;
use trimline::kernels::{InstructionSet, Rows, grid, peak};
use trimline::method::{Options, Settings};
use trimline::surface::{SeparableSurface, Surface, SurfaceOnGrid};
use trimline::threads;

const SPEC: &str = include_str!("../examples/eq29_30.trim");
/// Repetitions; the fastest counts, since other programs only ever make work slower.
const ROUNDS: usize = 31;
/// Points of the basis, in blocks.
const POINTS: usize = 131_072;
const BLOCK: usize = 1024;
/// Vertices along u and v of a grid.
const SIDE: usize = 1000;
/// Points anywhere.
const SCATTERED: usize = 1_000_000;
/// Compilations of which the memory is measured.
const CYCLES: usize = 10_000;

/// Any reason why something was not measured.
type Fault = Box<dyn Error + Send + Sync>;
type Outcome = Result<(), Fault>;
type Part = fn() -> Outcome;

fn fastest(rounds: usize, mut work: impl FnMut()) -> f64 {
    work();
    let mut once = || {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..rounds).map(|_| once()).fold(f64::INFINITY, f64::min)
}

fn reported(findings: Diagnostics) -> Fault {
    let text: Vec<String> = findings.into_iter().map(|finding| finding.message).collect();
    text.join("; ").into()
}

fn one(finding: Diagnostic) -> Fault {
    finding.message.into()
}

/// The problem by the method `sine` with `terms` terms.
fn compiled(terms: usize) -> Result<Blend, Fault> {
    let mut settings = Settings::default();
    settings.set("terms", &terms.to_string(), None).map_err(one)?;
    let options = Options { method: Some("sine".to_owned()), settings, ..Options::default() };
    Blend::compile(&Source::new("eq29_30", SPEC), &options).map_err(reported)
}

/// Points all over `2π x 1`, without a pattern.
fn samples(count: usize) -> (Vec<f64>, Vec<f64>) {
    let at = |i: usize, step: f64| (i as f64 * step).fract();
    let v = (1..=count).map(|i| std::f64::consts::TAU * at(i, 0.414_213_562_373_095_1));
    (v.collect(), (1..=count).map(|i| at(i, 0.732_050_807_568_877_2)).collect())
}

/// The basis and its derivatives vv, vvvv, t, tt, with the constants that the C program has.
struct Basis {
    graph: Graph,
    outputs: Vec<ExprId>,
    params: Vec<f64>,
}

impl Basis {
    fn new(blend: &Blend) -> Result<Basis, Fault> {
        let patch = blend.patches.first().ok_or("the example has a patch")?;
        let mut graph = patch.decomposition.graph.clone();
        let orders = [(0, 0), (2, 0), (4, 0), (0, 1), (0, 2)].map(|(v, t)| Derivative::new(0, v, t));
        let mut outputs = Vec::new();
        for function in &patch.decomposition.basis {
            for derivative in orders {
                outputs.push(graph.derivative(function.expr, derivative).map_err(|_| "the basis is smooth")?);
            }
        }
        let constants = [("a1", 1.3), ("a2", 0.4), ("a3", 2.0), ("a4", 0.8), ("a5", 3.0)];
        let of = |name: &str| constants.iter().find(|(known, _)| *known == name).map_or(0.0, |(_, value)| *value);
        let params = graph.symbols().map(of).collect();
        Ok(Basis { graph, outputs, params })
    }

    /// `Σ_k values_k / (k + 3)`
    fn weighted_sum(&self) -> (Graph, ExprId) {
        let mut graph = self.graph.clone();
        let weights = (3..).filter_map(|k| Number::fraction(1, k));
        let terms: Vec<ExprId> =
            self.outputs.iter().zip(weights).map(|(output, weight)| graph.scale(weight, *output)).collect();
        let sum = graph.sum(terms);
        (graph, sum)
    }
}

/// Nanoseconds a point of the C program, the faster of two block sizes: all values, and their weighted sum.
fn peer() -> Option<[f64; 2]> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers/basis.c");
    let mut best: Option<[f64; 2]> = None;
    for block in [64, 256] {
        let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("basis{block}"));
        let flags = ["-O3", "-march=native", "-ffast-math", "-mprefer-vector-width=512"];
        let mut compiler = Command::new("cc");
        compiler.args(flags).arg(format!("-DBLOCK={block}")).arg(&source).arg("-o").arg(&program);
        if !compiler.args(["-lmvec", "-lm"]).status().ok()?.success() {
            return None;
        }
        let output = String::from_utf8(Command::new(&program).output().ok()?.stdout).ok()?;
        let figure = |name| output.lines().find_map(|line| line.strip_prefix(name)?.trim().parse().ok());
        let here = [figure("values ")?, figure("sum ")?];
        best = Some(best.map_or(here, |[values, sum]| [f64::min(values, here[0]), f64::min(sum, here[1])]));
    }
    best
}

fn beside(own: f64, peer: Option<f64>) -> String {
    peer.map_or_else(|| "no peer".to_owned(), |peer| format!("C {peer:.2} ns, ratio {:.2}", own / peer))
}

fn basis() -> Outcome {
    let basis = Basis::new(&compiled(10)?)?;
    let (v, t) = samples(POINTS);
    let peer = peer();
    let jet = Arc::new(Jet::new(&basis.graph, &basis.outputs, Backend::Auto));
    for block in [256, 512, BLOCK] {
        let mut values = JetValues::new(Arc::clone(&jet));
        let seconds = fastest(ROUNDS, || {
            for (v, t) in v.chunks(block).zip(t.chunks(block)) {
                values.evaluate(&basis.params, Samples { u: v, v, t }).expect("lengths fit");
                black_box(values.row(0));
            }
        });
        let own = 1e9 * seconds / POINTS as f64;
        let (all, distinct) = (jet.len(), jet.distinct());
        println!(
            "basis: {all} values, of which {distinct} are stored, blocks of {block}: {own:.2} ns a point, {}",
            beside(own, peer.map(|[values, _]| values))
        );
    }
    let (graph, sum) = basis.weighted_sum();
    let (evaluator, _) = compile(Program::compile(&graph, &[sum]), Backend::Auto);
    let (mut row, mut workspace) = (Rows::default(), Default::default());
    let seconds = fastest(ROUNDS, || {
        for (v, t) in v.chunks(BLOCK).zip(t.chunks(BLOCK)) {
            let samples = Samples { u: v, v, t };
            evaluator.evaluate_rows(&basis.params, samples, &mut row, &mut workspace).expect("lengths fit");
            black_box(row.row(0));
        }
    });
    let own = 1e9 * seconds / POINTS as f64;
    println!("basis: one weighted sum: {own:.2} ns a point, {}", beside(own, peer.map(|[_, sum]| sum)));
    // How the basis would be written without a jet: every value stored.
    let (interpreter, _) = compile(Program::compile(&basis.graph, &basis.outputs), Backend::Interpreter);
    let (machine_code, _) = compile(Program::compile(&basis.graph, &basis.outputs), Backend::Jit);
    for count in [1, 2, 4, 8, 16, 64, 256, BLOCK] {
        let (Some(v), Some(t)) = (v.get(..count), t.get(..count)) else { continue };
        let mut rows = Rows::default();
        let mut time = |evaluator: &dyn trimline::eval::Evaluator| {
            let calls = 1 + 20_000 / count;
            let seconds = fastest(ROUNDS, || {
                for _ in 0..calls {
                    let samples = Samples { u: v, v, t };
                    evaluator.evaluate_rows(&basis.params, samples, &mut rows, &mut workspace).expect("lengths fit");
                    black_box(rows.row(0));
                }
            });
            1e9 * seconds / calls as f64
        };
        let (interpreted, run) = (time(&*interpreter), time(&*machine_code));
        println!("basis: {count} samples a call: interpreter {interpreted:.0} ns, machine code {run:.0} ns");
    }
    Ok(())
}

/// A solution taken to hold at all instants, so that points may have any: the work is the same.
fn surface(terms: usize) -> Result<SeparableSurface, Fault> {
    let blend = compiled(terms)?;
    let solution = blend.solve(0, 0.5).map_err(one)?;
    let surface = solution.separable().map_err(one)?;
    Ok(SeparableSurface {
        modes: Arc::clone(&surface.modes),
        basis: Arc::clone(&surface.basis),
        params: surface.params.clone(),
        coefficients: Arc::new(surface.coefficients.iter().take(1).cloned().collect()),
        instant: None,
    })
}

/// The same with a coefficient for every mode, function and component: what the reference calls 16 x 9.
fn dense(surface: &SeparableSurface) -> SeparableSurface {
    let number = |index: usize| ((index * 29) % 101) as f64 / 50.0 - 1.005;
    let count = surface.modes.count() * surface.basis.len();
    let coefficients = (0..count).map(|index| [3 * index, 3 * index + 1, 3 * index + 2].map(number)).collect();
    SeparableSurface {
        modes: Arc::clone(&surface.modes),
        basis: Arc::clone(&surface.basis),
        params: surface.params.clone(),
        coefficients: Arc::new(vec![coefficients]),
        instant: None,
    }
}

fn grids() -> Outcome {
    let mut buffer = vec![0.0; 3 * SIDE * SIDE];
    let bytes = size_of_val(buffer.as_slice()) as f64;
    let nanoseconds_per_byte = 1e9 * fastest(ROUNDS, || peak::stream(black_box(&mut buffer), 1.0)) / bytes;
    println!(
        "grid: stores past the caches {:.1} GB/s, {nanoseconds_per_byte:.4} ns a byte",
        1.0 / nanoseconds_per_byte
    );
    let surface = surface(5)?;
    for (name, surface) in [("Eqs. (29)-(30)", &surface), ("every coefficient", &dense(&surface))] {
        grids_of::<f64>(name, "f64", surface, nanoseconds_per_byte)?;
        grids_of::<f32>(name, "f32", surface, nanoseconds_per_byte)?;
    }
    Ok(())
}

fn grids_of<N: grid::Number>(name: &str, number: &str, surface: &SeparableSurface, byte: f64) -> Outcome {
    let axis = |to: f64| (0..SIDE).map(|i| to * i as f64 / (SIDE - 1) as f64).collect::<Vec<f64>>();
    let (u, v) = (axis(1.0), axis(std::f64::consts::TAU));
    let [mut positions, mut normals] = [(); 2].map(|()| vec![[N::default(); 3]; SIDE * SIDE]);
    let vertices = (SIDE * SIDE) as f64;
    let share = |seconds: f64, outputs: usize| {
        let floor = byte * (outputs * size_of::<[N; 3]>()) as f64;
        (1e9 * seconds / vertices, 100.0 * floor * vertices / (1e9 * seconds))
    };
    let seconds = fastest(ROUNDS, || {
        let mut grid = SurfaceOnGrid::new(&u, &v);
        grid.evaluate(surface, Derivative::NONE, 0.5, black_box(&mut positions)).expect("the surface is finite");
    });
    let (each, of_stores) = share(seconds, 1);
    println!("grid: {name}, {number}, positions: {each:.2} ns a vertex, {of_stores:.0} % of the stores");
    let seconds = fastest(ROUNDS, || {
        let outputs = Outputs { positions: black_box(&mut positions), normals: &mut normals, tangents: None };
        SurfaceOnGrid::new(&u, &v).write_shape(surface, 0.5, outputs).expect("the surface is finite");
    });
    let (each, of_stores) = share(seconds, 2);
    println!("grid: {name}, {number}, positions and normals: {each:.2} ns a vertex, {of_stores:.0} % of the stores");
    Ok(())
}

fn scattered() -> Outcome {
    const ADDS: usize = 100_000;
    let set = InstructionSet::best();
    let seconds = fastest(ROUNDS, || {
        black_box(peak::multiply_add(set, black_box(ADDS), black_box(0.5), black_box(0.5)));
    });
    let multiply_add = 1e9 * seconds / (ADDS * peak::MULTIPLY_ADDS) as f64;
    let (v, t) = samples(SCATTERED);
    let u = (1..=SCATTERED).map(|i| (i as f64 * 0.618_033_988_749_894_9).fract());
    let points: Vec<[f64; 3]> = u.zip(v.iter().zip(&t)).map(|(u, (v, t))| [u, *v, *t]).collect();
    let derivatives = [Derivative::NONE, Derivative::new(1, 0, 0), Derivative::new(0, 1, 0)];
    let mut values = [(); 3].map(|()| vec![[0.0; 3]; SCATTERED]);
    let surface = surface(5)?;
    println!("points: {multiply_add:.4} ns a fused multiply-add; 891 of them for every coefficient of 16 x 9");
    for (name, surface) in [("Eqs. (29)-(30)", &surface), ("every coefficient", &dense(&surface))] {
        let seconds = fastest(5, || {
            let [s, s_u, s_v] = &mut values;
            let mut targets = [s.as_mut_slice(), s_u.as_mut_slice(), s_v.as_mut_slice()];
            surface.evaluate_all(&derivatives, &points, &mut targets).expect("the surface is finite");
        });
        println!("points: {name}: S, S_u and S_v: {:.1} ns a point", 1e9 * seconds / SCATTERED as f64);
    }
    Ok(())
}

/// Bytes of memory that the process holds; `None` where the system does not say.
fn resident() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: f64 = text.split_whitespace().nth(1)?.parse().ok()?;
    Some(4096.0 * pages)
}

fn memory() -> Outcome {
    let basis = Basis::new(&compiled(10)?)?;
    let program = Program::compile(&basis.graph, &basis.outputs);
    let mut before = None;
    for cycle in 0..=CYCLES {
        // The first tenth fills the allocator's lists.
        if cycle % (CYCLES / 10) == 0
            && let Some(bytes) = resident()
        {
            let growth =
                before.map_or_else(String::new, |before: f64| format!(", {:+.0} KiB", (bytes - before) / 1024.0));
            println!("memory: after {cycle} compilations {:.1} MiB{growth}", bytes / 1_048_576.0);
            before = Some(bytes);
        }
        drop(black_box(compile(program.clone(), Backend::Jit)));
    }
    Ok(())
}

fn main() -> Outcome {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let is_wanted = |name: &str| wanted.is_empty() || wanted.iter().any(|part| name.contains(part.as_str()));
    let parts: [(&str, Part); 4] = [("basis", basis), ("grids", grids), ("points", scattered), ("memory", memory)];
    for (name, part) in parts.iter().filter(|(name, _)| is_wanted(name)) {
        threads::with(1, part).map_err(|error| format!("{name}: {error}"))??;
    }
    Ok(())
}
