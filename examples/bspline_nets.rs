//! Surfaces from boundary layers: a net filled by the sixth-order equation, four patches inside four curves, and a
//! closed ring, written as STEP files to the folder that is named.
//!
//! Run: `cargo run --example bspline_nets -- FOLDER`.

use std::path::Path;

use trimline::diagnostic::Diagnostic;
use trimline::export::{CadFormat, Face, Schema, write_cad};
use trimline::net::{Filled, Outline, Strip, fill, quarter, ring};
use trimline::surface::{BsplineCurve, KnotVector};

/// A catenoid, of which only three layers in each direction are kept.
fn catenoid() -> Result<Filled, Diagnostic> {
    let knots = KnotVector::uniform(3, 8)?;
    let height = 2.0_f64.acosh();
    let point = |s: f64, t: f64| [t.cosh() * s.cos(), t.cosh() * s.sin(), t];
    let place = |i: usize, j: usize| point(std::f64::consts::PI * i as f64 / 7.0, height * j as f64 / 7.0);
    let net: Vec<[f64; 3]> = (0..8).flat_map(|i| (0..8).map(move |j| (i, j))).map(|(i, j)| place(i, j)).collect();
    fill(&knots, &knots, &net)
}

/// A cubic curve over `breakpoints`, from its places at the Greville points.
fn curve(breakpoints: &[f64], place: impl Fn(f64) -> [f64; 3]) -> Result<BsplineCurve, Diagnostic> {
    let knots = KnotVector::clamped(3, breakpoints)?;
    let points = knots.greville().into_iter().map(place).collect();
    BsplineCurve::new(knots, points)
}

/// Four wavy curves around a square, filled with four patches and a hill over the seams.
fn square() -> Result<[Filled; 4], Diagnostic> {
    let line = [0.0, 1.0, 2.0, 3.0, 4.0];
    let wave = |x: f64| 0.2 * x * (4.0 - x);
    let outline = Outline {
        along_u: [curve(&line, |u| [u, -wave(u), 0.0])?, curve(&line, |u| [u, 4.0, wave(u)])?],
        along_v: [curve(&line, |v| [0.0, v, 0.0])?, curve(&line, |v| [4.0 + wave(v), v, 0.0])?],
    };
    let lift = |_, _, [x, y, z]: [f64; 3]| [x, y, z + 0.1 * (x * (4.0 - x) * y * (4.0 - y)).max(0.0)];
    quarter(&outline, [2.0, 2.0], &lift)
}

/// A closed curve around the z axis.
fn around(radius: f64, height: f64) -> Result<BsplineCurve, Diagnostic> {
    let breakpoints: Vec<f64> = (0..=8).map(f64::from).collect();
    let knots = KnotVector::clamped(3, &breakpoints)?;
    let turn = |x: f64| {
        let (sin, cos) = (x * std::f64::consts::TAU / 8.0).sin_cos();
        [radius * cos, radius * sin, height]
    };
    let mut points: Vec<[f64; 3]> = knots.greville().into_iter().map(turn).collect();
    // The closing point lies between its neighbours, so that the tangent closes too.
    if let [first, second, .., before, last] = points.as_mut_slice() {
        let [[ax, ay, az], [bx, by, bz]] = [*second, *before];
        *first = [0.5 * (ax + bx), 0.5 * (ay + by), 0.5 * (az + bz)];
        *last = *first;
    }
    BsplineCurve::new(knots, points)
}

fn vase() -> Result<[Filled; 2], Diagnostic> {
    let strip = Strip {
        across: KnotVector::clamped(3, &[0.0, 1.0, 2.0, 3.0])?,
        layers: [around(1.0, 0.0)?, around(1.5, 0.3)?, around(2.0, 3.0)?],
        split: 4.0,
        beside_first_seam: None,
        second_seam: None,
    };
    let ring = ring(&strip)?;
    println!("the ring is off by {:.1e} at its second seam", ring.crease);
    Ok(ring.patches)
}

fn write(folder: &Path, name: &str, patches: &[Filled]) -> std::io::Result<()> {
    let face =
        |(index, patch): (usize, &Filled)| Face { name: format!("{name} {index}"), surface: patch.surface.clone() };
    let faces: Vec<Face> = patches.iter().enumerate().map(face).collect();
    let mut file = std::fs::File::create(folder.join(format!("{name}.step")))?;
    write_cad(name, &faces, CadFormat::Step(Schema::Ap214), &mut file).map_err(std::io::Error::other)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("name a folder")?;
    let folder = Path::new(&folder);
    let catenoid = catenoid()?;
    println!("the catenoid's net magnifies its layers by {:.1?} in u and v", catenoid.amplification);
    write(folder, "catenoid", &[catenoid])?;
    write(folder, "square", &square()?)?;
    write(folder, "vase", &vase()?)?;
    Ok(())
}
