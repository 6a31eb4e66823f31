//! The same bits whatever the number of threads: grids, check reports and files.

use trimline::blend::Blend;
use trimline::diagnostic::Source;
use trimline::eval::Backend;
use trimline::expr::{Derivative, Function, Graph, Variable};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::surface::{Basis, SurfaceOnGrid};
use trimline::threads;

const COUNTS: &[usize] = if cfg!(feature = "threads") { &[1, 2, 7] } else { &[1] };

/// The bits of a value that `work` computes, the same for every number of threads.
fn same(work: impl Fn() -> Vec<u64> + Send + Sync) -> Vec<u64> {
    let each = COUNTS.iter().map(|count| threads::with(*count, &work).expect("a few threads"));
    let all: Vec<Vec<u64>> = each.collect();
    assert!(all.iter().all(|bits| *bits == all[0]), "{COUNTS:?}");
    all.into_iter().next().unwrap_or_default()
}

fn bits<'a>(values: impl IntoIterator<Item = &'a [f64; 3]>) -> Vec<u64> {
    values.into_iter().flatten().map(|x| x.to_bits()).collect()
}

#[test]
fn rows_of_a_large_grid_are_the_same_in_any_number_of_threads() {
    let text = include_str!("../../examples/eq29_30.trim");
    let blend = Blend::compile(&Source::new("eq29_30", text), &Options::default()).expect("the example compiles");
    let solution = blend.solve(0, 0.3).expect("the example can be solved");
    let surface = solution.separable().expect("a sum of products");
    let axis = |count: usize| -> Vec<f64> { (0..count).map(|i| i as f64 / (count - 1) as f64).collect() };
    // Four pieces, the last of them shorter.
    let (u, v) = (axis(401), axis(130));
    let positions = same(|| {
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        let written = SurfaceOnGrid::new(&u, &v).evaluate(surface, Derivative::NONE, 0.3, &mut values);
        written.expect("finite");
        bits(&values)
    });
    let shape = same(|| {
        let shape = SurfaceOnGrid::new(&u, &v).shape(surface, 0.3).expect("finite");
        let normals = shape.normals.expect("normals");
        let fields = [&shape.positions, &shape.tangents_u, &shape.tangents_v, &normals.unit];
        fields.into_iter().flat_map(bits).chain([normals.least_square.to_bits()]).collect()
    });
    assert_eq!(positions.len(), 3 * 401 * 130);
    assert_eq!(shape.len(), 4 * positions.len() + 1);
    // Each row alone: what a piece writes does not depend on where it was cut.
    for (row, u) in [(0, u[0]), (199, u[199]), (400, u[400])] {
        let mut values = vec![[0.0; 3]; v.len()];
        SurfaceOnGrid::new(&[u], &v).evaluate(surface, Derivative::NONE, 0.3, &mut values).expect("finite");
        assert_eq!(bits(&values), positions[row * 3 * v.len()..(row + 1) * 3 * v.len()], "{row}");
    }
}

#[test]
fn compiled_models_are_the_same_in_any_number_of_threads() {
    let text = include_str!("../../examples/limb_torso.trim");
    let blend = || Blend::compile(&Source::new("limb_torso", text), &Options::default()).expect("the example compiles");
    let surfaces = same(|| {
        let blend = blend();
        let t = blend.patches[0].domain.t[0];
        let solved = |(index, prepared): (usize, &trimline::blend::Prepared)| {
            let solution = blend.solve(index, t).expect("the example can be solved");
            let [u, v] = [prepared.domain.u, prepared.domain.v].map(|[low, high]| [low, 0.3 * low + 0.7 * high, high]);
            let mut values = vec![[0.0; 3]; 9];
            solution.surface.evaluate_grid(Derivative::NONE, (&u, &v, t), &mut values).expect("finite");
            bits(&values)
        };
        threads::map(blend.patches.iter().enumerate().collect(), solved).concat()
    });
    assert!(surfaces.len() > 27);
}

#[test]
fn a_derivative_has_the_same_bits_whichever_was_asked_for_before() {
    let mut graph = Graph::new();
    let [v, t] = [Variable::V, Variable::T].map(|variable| graph.variable(variable));
    let vt = graph.product([v, t]);
    let (sine, wave) = (graph.call(Function::Sin, &[vt]), graph.call(Function::Exp, &[v]));
    let product = graph.product([sine, wave, t]);
    let quotient = {
        let sum = graph.sum([sine, wave, v]);
        graph.product([product, sum])
    };
    let functions = [(product, None), (quotient, None)];
    let basis = || Basis::new(&graph, &functions, Backend::Interpreter, &Limits::default());
    let derivatives = ["v", "t", "vv", "vt", "vvv", "vvvv", "tt"].map(|text| Derivative::parse(text).expect("letters"));
    let (forth, back) = (basis(), basis());
    let values = |basis: &Basis, derivative: Derivative| -> Vec<u64> {
        let samples = [0.1, 0.7, 1.9, 3.3];
        let values = basis.values(derivative, &[], &samples, &[0.2, 0.4, 0.9, 1.3]).expect("finite");
        values.into_iter().map(f64::to_bits).collect()
    };
    let first: Vec<Vec<u64>> = derivatives.iter().map(|derivative| values(&forth, *derivative)).collect();
    let mut second: Vec<Vec<u64>> = derivatives.iter().rev().map(|derivative| values(&back, *derivative)).collect();
    second.reverse();
    assert_eq!(first, second);
}

#[cfg(all(feature = "cli", feature = "threads"))]
mod command_line {
    use crate::cli::{Folder, done, example, status, text, trimline};

    /// What is printed, and the bytes of the files that are written, for 1, 2 and 7 threads.
    fn same(arguments: &[&str], name: Option<&str>) {
        let run = |count: &str| {
            let folder = Folder::new();
            let target = folder.path(name.unwrap_or_default()).to_string_lossy().into_owned();
            let output = if name.is_some() { vec!["-o", &target] } else { Vec::new() };
            let printed = trimline(&[arguments, &output, &["--threads", count]].concat());
            assert_eq!(status(&printed), 0, "{arguments:?}: {}", text(&printed.stderr));
            let files = folder.files();
            assert_eq!(name.is_some(), !files.is_empty(), "{arguments:?}");
            let bytes = files.iter().map(|file| std::fs::read(folder.path(file)).expect("written"));
            // Summaries name the folder.
            let said = text(&printed.stderr).replace(&*folder.path("").to_string_lossy(), "");
            (printed.stdout, said, files.clone(), bytes.collect::<Vec<_>>())
        };
        let one = run("1");
        assert!(!one.0.is_empty() || !one.3.is_empty(), "{arguments:?}");
        for count in ["2", "7"] {
            assert!(run(count) == one, "{count} threads: {arguments:?}");
        }
    }

    #[test]
    fn check_prints_the_same_for_every_number_of_threads() {
        for spec in ["eq24.trim", "limb_torso.trim", "join_cylinder_cone.trim", "p4_fig4.trim", "deformed.trim"] {
            same(&["check", &example(spec), "--format", "json"], None);
        }
        same(&["check", &example("aircraft.trim"), "--time", "0"], None);
    }

    #[test]
    fn meshes_are_the_same_for_every_number_of_threads() {
        let frames = ["--frames", "5", "--grid", "16x24"];
        for (spec, name) in [("eq29_30.trim", "out.npz"), ("eq24.trim", "out.obj"), ("limb_torso.trim", "out.glb")] {
            same(&[&["mesh", &example(spec)], &frames[..]].concat(), Some(name));
        }
        same(&["mesh", &example("eq29_30.trim"), "--grid", "300x200"], Some("out.ply"));
    }

    #[test]
    fn a_number_of_threads_is_from_1_to_1024() {
        for count in ["0", "1025", "-1", "many"] {
            let output = trimline(&["check", &example("eq19.trim"), "--threads", count]);
            assert!(status(&output) == 2 && text(&output.stderr).contains("--threads"), "{}", text(&output.stderr));
        }
        done(&trimline(&["--threads", "3", "check", &example("eq19.trim")]));
    }
}

#[cfg(all(feature = "cli", not(feature = "threads")))]
#[test]
fn a_build_without_threads_says_so() {
    let output = crate::cli::trimline(&["check", &crate::cli::example("eq19.trim"), "--threads", "2"]);
    let said = crate::cli::text(&output.stderr);
    assert!(crate::cli::status(&output) == 2 && said.contains("without the feature `threads`"), "{said}");
}
