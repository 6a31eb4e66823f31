//! Ratios, each measured in one run: frames against what the machine can store, least-squares problems in microseconds,
//! threads against one.
//!
//! `cargo bench --bench surfaces`
#![allow(missing_docs)]

use std::hint::black_box;
use std::time::Instant;

use trimline::blend::Blend;
use trimline::diagnostic::{Diagnostics, Source};
use trimline::expr::Derivative;
use trimline::kernels::peak;
use trimline::method::{Options, Settings};
use trimline::surface::SurfaceOnGrid;
use trimline::threads;

const SPECS: [(&str, &str); 2] =
    [("eq19", include_str!("../examples/eq19.trim")), ("eq29_30", include_str!("../examples/eq29_30.trim"))];

/// Repetitions; the fastest counts, since other programs only ever make work slower.
const ROUNDS: usize = 5;
/// Doubles written past the caches: 96 MB.
const STREAMED: usize = 12_000_000;
/// Vertices along u and v of a frame, and frames.
const SIDE: usize = 256;
const FRAMES: usize = 1000;

fn fastest(mut work: impl FnMut()) -> f64 {
    work();
    let once = |()| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    [(); ROUNDS].map(once).into_iter().fold(f64::INFINITY, f64::min)
}

fn compiled(name: &str, text: &str, method: &str, settings: &[(&str, &str)]) -> Result<Blend, Diagnostics> {
    let mut given = Settings::default();
    for (key, value) in settings {
        given.set(key, value, None).map_err(|finding| vec![finding])?;
    }
    let options = Options { method: Some(method.to_owned()), settings: given, ..Options::default() };
    Blend::compile(&Source::new(name, text), &options)
}

/// A thousand instants of a solution that holds at all of them, each written to the same buffer as a consumer of frames
/// would read it; the solution and all tables are part of the time.
fn frames() -> Result<(), Diagnostics> {
    let mut buffer = vec![0.0; STREAMED];
    let store = (8 * STREAMED) as f64 / fastest(|| peak::stream(black_box(&mut buffer), 1.0));
    println!("stores past the caches: {:.1} GB/s", 1e-9 * store);
    let mut values = vec![[0.0; 3]; SIDE * SIDE];
    for (name, text) in SPECS {
        let blend = compiled(name, text, "exact", &[])?;
        let Some(patch) = blend.patches.first() else { continue };
        let axis = |[from, to]: [f64; 2]| -> Vec<f64> {
            (0..SIDE).map(|i| from + (to - from) * i as f64 / (SIDE - 1) as f64).collect()
        };
        let (u, v, [start, end]) = (axis(patch.domain.u), axis(patch.domain.v), patch.domain.t);
        let rank = {
            let solution = blend.solve(0, start).map_err(|finding| vec![finding])?;
            let surface = solution.separable().map_err(|finding| vec![finding])?;
            surface.modes.count().min(surface.basis.len())
        };
        let seconds = fastest(|| {
            let mut grid = SurfaceOnGrid::new(&u, &v);
            for frame in 0..FRAMES {
                let t = start + (end - start) * frame as f64 / (FRAMES - 1) as f64;
                let solution = patch.solve(&blend.bindings, t).expect("it was solved before");
                let surface = solution.separable().expect("exact solutions are sums of products");
                grid.evaluate(surface, Derivative::NONE, t, black_box(&mut values)).expect("it was evaluated before");
            }
        });
        let written = (FRAMES * size_of_val(values.as_slice())) as f64 / seconds;
        println!(
            "{FRAMES} frames of {SIDE}x{SIDE}, {name}, rank {rank}: {:.1} µs a frame, {:.1} GB/s, {:.0} % of the stores",
            1e6 * seconds / FRAMES as f64,
            1e-9 * written,
            100.0 * written / store
        );
    }
    Ok(())
}

/// Solutions at ever new instants, 121 points for each basis function: of the equation as it stands, in which some of the
/// functions meet their first derivative in t, and without that term, where one factorisation holds at all instants.
fn least_squares() -> Result<(), Diagnostics> {
    let [_, (name, text)] = SPECS;
    let shared = text.replace("η = 1", "η = 0");
    for (about, text) in [("η = 1", text), ("η = 0", shared.as_str())] {
        println!("{name} with {about}:");
        least_squares_of(name, text)?;
    }
    Ok(())
}

fn least_squares_of(name: &str, text: &str) -> Result<(), Diagnostics> {
    const SOLUTIONS: usize = 1000;
    for method in ["sine", "polynomial"] {
        for terms in [5, 10] {
            // The method `polynomial` counts powers, of which the constraints take the first four.
            let highest = if method == "sine" { terms } else { terms + 3 };
            let count = highest.to_string();
            let settings = [("terms", count.as_str()), ("points", "11x11")];
            let blend = compiled(name, text, method, &settings)?;
            let Some(patch) = blend.patches.first() else { continue };
            let functions = patch.decomposition.basis.len();
            let [start, end] = patch.domain.t;
            let seconds = fastest(|| {
                for index in 0..SOLUTIONS {
                    let t = start + (end - start) * index as f64 / SOLUTIONS as f64;
                    black_box(patch.solve(&blend.bindings, t).expect("the example can be solved"));
                }
            });
            let microseconds = 1e6 * seconds / SOLUTIONS as f64;
            println!("{functions} least-squares problems of 121x{terms} by {method}: {microseconds:.2} µs");
        }
    }
    Ok(())
}

fn main() -> Result<(), Diagnostics> {
    println!("one thread");
    threads::with(1, || frames().and_then(|()| least_squares())).map_err(|error| {
        vec![trimline::diagnostic::Diagnostic::new(trimline::diagnostic::Code::HostUnsupported, error.to_string())]
    })??;
    let count = threads::count();
    if count > 1 {
        println!("{count} threads");
        frames()?;
    }
    Ok(())
}
