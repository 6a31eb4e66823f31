//! The published figures: the commands of docs/figures.md, and what the examples behind them are.

use std::process::Command;

use trimline::blend::Blend;
use trimline::method::Options;

use crate::spec::{at, example, problem};

fn blend(name: &str) -> Blend {
    Blend::new(problem(&example(name)), &Options::default()).unwrap_or_else(|found| panic!("{name}: {found:?}"))
}

fn point(blend: &Blend, place: [f64; 3]) -> [f64; 3] {
    at(&*blend.solve(0, place[2]).unwrap_or_else(|found| panic!("{found}")).surface, "", place)
}

#[test]
fn commands_of_the_page_of_figures_run() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut count = 0;
    for command in include_str!("../../docs/figures.md").split('`').filter_map(|text| text.strip_prefix("trimline ")) {
        // Small pictures tell as much.
        let sizes: &[&str] = if command.starts_with("render") { &["--size", "64x48"] } else { &[] };
        let words = command.split_whitespace().map(|word| match word.strip_prefix("examples/") {
            Some(name) => root.join("examples").join(name).to_string_lossy().into_owned(),
            None => word.to_owned(),
        });
        let output = Command::new(env!("CARGO_BIN_EXE_trimline"))
            .args(words)
            .args(sizes)
            .current_dir(folder.path())
            .output()
            .expect("the command starts");
        assert!(output.status.success(), "{command}\n{}", String::from_utf8_lossy(&output.stderr));
        count += 1;
    }
    assert!(count >= 16, "{count}");
}

#[test]
fn vases_of_figures_5_and_6_have_the_radius_of_the_reference() {
    // The reference gives two digits.
    for (changes, radius) in
        [(&[][..], -0.41), (&[("d0", "-9000")], -0.03), (&[("ρ", "8")], -0.41), (&[("η", "9")], -0.41)]
    {
        let mut blend = blend("p4_fig5");
        for (name, value) in changes {
            blend.set(name, value).expect("a param");
        }
        let [x, y, _] = point(&blend, [0.5, 0.0, 0.5]);
        assert!((x - radius).abs() <= 0.005 && y == 0.0, "{changes:?}: {x}");
    }
}

#[test]
fn figure_7_is_the_vase_of_figure_5_and_the_printed_terms() {
    let base = blend("p4_fig5");
    for (ζ1, ζ0, power) in [("300", "0", 2), ("0", "19", 1)] {
        let mut bumped = blend("p4_fig7");
        bumped.set("ζ1", ζ1).and_then(|_| bumped.set("ζ0", ζ0)).expect("params");
        let ζ: f64 = if power == 2 { ζ1 } else { ζ0 }.parse().expect("a number");
        for (a, b) in [(0.0, 0.5), (0.5, 0.5), (0.2, 0.7), (0.9, 0.1), (1.0, 1.0), (-1.0, 0.5), (0.5, 1.5)] {
            let (u, v): (f64, f64) = (0.4 + 0.1 * a, 5.03 + 0.62 * b);
            // Eqs. (31) and (32); outside the region nothing is added.
            let inside = f64::from((0.0..=1.0).contains(&a) && (0.0..=1.0).contains(&b));
            let term = inside * ζ * (a * b - a * a * b - a * b * b + a * a * b * b).powi(power);
            let moved = [v.cos(), v.sin(), 1.0].map(|x| term * x);
            let (found, plain) = (point(&bumped, [u, v, 0.5]), point(&base, [u, v, 0.5]));
            for axis in 0..3 {
                // Rounding of the place in the region, whose slopes are of size ζ.
                assert!((found[axis] - plain[axis] - moved[axis]).abs() <= 1e-12, "{a}, {b}: {found:?} {plain:?}");
            }
        }
    }
}
