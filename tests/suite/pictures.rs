//! What pictures promise: what is seen, where, in which colour, and the same every time.

use std::io;

use trimline::diagnostic::Code;
use trimline::limits::Limits;
use trimline::render::{Camera, Picture, Renderer, Shade, Style, write_apng, write_gif, write_png};
use trimline::tessellate::{Field, Role, Scene};

use crate::analytic::*;

const BACKGROUND: [u8; 3] = [255; 3];

fn style(azimuth: f64, elevation: f64) -> Style {
    Style {
        shade: Shade::Plain,
        camera: Camera { azimuth, elevation, zoom: 1.0 },
        size: (120, 90),
        lines: None,
        is_labelled: false,
    }
}

fn draw(scene: &Scene, style: &Style) -> Picture {
    let frames = std::slice::from_ref(scene);
    Renderer::new(frames, style, &Limits::default()).expect("a sound style").draw(scene)
}

fn pixels(picture: &Picture) -> impl Iterator<Item = [u8; 3]> + '_ {
    picture.bytes().chunks(3).map(|pixel| [pixel[0], pixel[1], pixel[2]])
}

fn covered(picture: &Picture) -> usize {
    pixels(picture).filter(|pixel| *pixel != BACKGROUND).count()
}

fn is_red([r, g, b]: [u8; 3]) -> bool {
    r > 150 && g < 120 && b < 120
}

#[test]
fn surface_covers_its_projected_area_and_leaves_the_corners() {
    // A cylinder of radius 1 and height 2 seen from the side is a square, fitted to 0.86 of the lower side.
    let picture = draw(&CYLINDER.scene((8, 64)), &style(10.0, 0.0));
    let side = 0.86 * 90.0;
    // Trimlines reach a pixel beyond two of the sides, and pixels at the rim are covered in part: 3 pixels around.
    let difference = (covered(&picture) as f64 - side * side).abs();
    assert!(difference <= 3.0 * 4.0 * side, "{} of {}", covered(&picture), side * side);
    for (x, y) in [(0, 0), (119, 0), (0, 89), (119, 89)] {
        assert_eq!(picture.get(x, y), Some(BACKGROUND));
    }
}

#[test]
fn zoom_by_a_half_covers_a_quarter() {
    let full = style(10.0, 0.0);
    let half = Style { camera: Camera { zoom: 0.5, ..full.camera }, ..full.clone() };
    let scene = CYLINDER.scene((8, 64));
    let ratio = covered(&draw(&scene, &half)) as f64 / covered(&draw(&scene, &full)) as f64;
    // The rim is as wide in both.
    assert!((0.25..0.3).contains(&ratio), "{ratio}");
}

#[test]
fn symmetric_surface_gives_a_symmetric_picture() {
    // 64 columns around: the mesh is its own mirror image seen from azimuth 0.
    for shade in [Shade::Plain, Shade::Zebra, Shade::U] {
        let picture = draw(&CYLINDER.scene((8, 64)), &Style { shade, size: (91, 90), ..style(0.0, 20.0) });
        let legend = if shade == Shade::U { 30 } else { 0 };
        let mut different = 0;
        for y in 0..90 {
            for x in legend..91 - legend {
                let (pixel, mirrored) = (picture.get(x, y).expect("inside"), picture.get(90 - x, y).expect("inside"));
                let difference = pixel.iter().zip(mirrored).map(|(a, b)| a.abs_diff(b)).max();
                different += usize::from(difference > Some(12));
            }
        }
        // Samples on an edge between two triangles fall to one of them by rounding.
        assert!(different <= 91 * 90 / 200, "{shade:?}: {different}");
    }
}

#[test]
fn nearer_surface_hides_the_farther() {
    let mut scene = PLANE.scene((2, 2));
    let mut cover = scene.meshes[0].clone();
    cover.role = Role::Primary;
    for position in &mut cover.positions {
        position[2] += 1.0;
    }
    let alone = draw(&scene, &style(0.0, 90.0)).get(60, 45).expect("inside");
    scene.meshes.push(cover);
    let from_above = draw(&scene, &style(0.0, 90.0)).get(60, 45).expect("inside");
    let from_below = draw(&scene, &style(0.0, -90.0)).get(60, 45).expect("inside");
    // Grey is what the primary surface shows; the patch is blue outside and orange inside.
    assert!(from_above[0].abs_diff(from_above[2]) < 30, "{from_above:?}");
    assert!(alone[2] > alone[0] + 60, "{alone:?}");
    assert!(from_below[0] > from_below[2] + 60, "{from_below:?}");
}

#[test]
fn trimlines_are_drawn_at_both_ends_of_u_and_nowhere_else() {
    let picture = draw(&CYLINDER.scene((8, 64)), &style(10.0, 0.0));
    let red_in = |y: usize| (0..120).filter(|&x| is_red(picture.get(x, y).expect("inside"))).count();
    let rows: Vec<usize> = (0..90).filter(|&y| red_in(y) > 30).collect();
    let (top, bottom) = ((90.0 - 0.86 * 90.0) / 2.0, (90.0 + 0.86 * 90.0) / 2.0);
    assert!(rows.iter().all(|&y| (y as f64 - top).abs() < 2.5 || (y as f64 - bottom).abs() < 2.5), "{rows:?}");
    assert!(rows.len() >= 2, "{rows:?}");
}

#[test]
fn lines_add_ink_to_the_surface() {
    let scene = CYLINDER.scene((8, 64));
    let dark = |style: &Style| pixels(&draw(&scene, style)).filter(|[r, g, b]| r.max(g).max(b) < &140).count();
    let plain = style(10.0, 0.0);
    assert!(dark(&Style { lines: Some((4, 8)), ..plain.clone() }) > dark(&plain) + 200);
}

#[test]
fn outlines_are_drawn_where_they_are() {
    // An arc of half a radian to both sides of the x axis, half-way up, seen along that axis.
    let mut scene = CYLINDER.scene((8, 64));
    let before = draw(&scene, &style(0.0, 0.0));
    let heights = scene.meshes[0].positions.iter().map(|[_, _, z]| *z);
    let middle = 0.5 * (heights.clone().fold(f64::INFINITY, f64::min) + heights.fold(f64::NEG_INFINITY, f64::max));
    let arc = (0..=16).map(|k| (f64::from(k) - 8.0) / 16.0);
    scene.meshes[0].outlines = vec![arc.map(|angle: f64| [angle.cos(), angle.sin(), middle]).collect()];
    let after = draw(&scene, &style(0.0, 0.0));
    let places = (0..90).flat_map(|y| (0..120).map(move |x| (x, y)));
    let drawn: Vec<(usize, usize)> = places.filter(|&(x, y)| before.get(x, y) != after.get(x, y)).collect();
    // The width of the cylinder is 0.86 of 90 pixels; the line may touch two rows of pixels.
    let half = 0.5_f64.sin() * 0.86 * 45.0;
    assert!((2.0 * half - 2.0..=5.0 * half).contains(&(drawn.len() as f64)), "{}", drawn.len());
    assert!(drawn.iter().all(|(x, y)| y.abs_diff(45) <= 2 && (*x as f64 - 59.5).abs() <= half + 2.0), "{drawn:?}");
}

#[test]
fn field_is_drawn_from_dark_to_light_and_grey_where_it_has_no_value() {
    let mut scene = PLANE.scene((1, 2));
    // Two rows of three columns: low, high, none.
    scene.meshes[0].fields = vec![Field { name: "residual", values: vec![0.0, 1.0, f64::NAN, 0.0, 1.0, f64::NAN] }];
    let seen = draw(&scene, &Style { shade: Shade::Field, ..style(0.0, 90.0) });
    let shown: Vec<[u8; 3]> = pixels(&seen).collect();
    let has = |test: fn(&[u8; 3]) -> bool| shown.iter().filter(|pixel| test(pixel)).count() > 100;
    assert!(has(|[r, g, b]| *r < 90 && *g < 50 && *b > 70), "violet");
    assert!(has(|[r, g, b]| r == g && g == b && *r == 150), "grey");
}

#[test]
fn signed_field_leaves_a_cusp_out_of_its_scale_and_says_so() {
    let mut scene = PLANE.scene((10, 10));
    let mut values: Vec<f64> = (0..121).map(|vertex| f64::from(vertex % 11) - 5.0).collect();
    values[0] = 1e9;
    scene.meshes[0].fields = vec![Field { name: "mean_curvature", values }];
    let signed = Style { shade: Shade::SignedField, ..style(0.0, 90.0) };
    let picture = draw(&scene, &signed);
    // A scale up to 1e9 would show white everywhere.
    assert!(pixels(&picture).filter(|[r, _, b]| r.abs_diff(*b) > 60).count() > 2000);
    scene.meshes[0].fields[0].values[0] = 5.0;
    assert_ne!(picture, draw(&scene, &signed), "without the sign before the ends");
}

#[test]
fn two_runs_draw_equal_bytes() {
    let bytes = || {
        let style = Style { lines: Some((4, 4)), is_labelled: true, shade: Shade::V, ..style(-60.0, 25.0) };
        let mut bytes = Vec::new();
        write_png(&draw(&TORUS_PATCH.scene((12, 24)), &style), &mut bytes).expect("memory");
        bytes
    };
    assert_eq!(bytes(), bytes());
}

#[test]
fn huge_tiny_and_pointlike_scenes_are_drawn_alike_or_not_at_all() {
    let scaled = |factor: f64| {
        let mut scene = CYLINDER.scene((4, 16));
        scene.meshes[0].positions.iter_mut().flatten().for_each(|x| *x *= factor);
        covered(&draw(&scene, &style(10.0, 20.0)))
    };
    let expected = scaled(1.0);
    for factor in [1e-300, 1e300, 8e307] {
        assert!(scaled(factor).abs_diff(expected) <= 20, "{factor:e}");
    }
    assert_eq!(scaled(0.0), 0);
    assert_eq!(covered(&draw(&Scene::default(), &style(0.0, 0.0))), 0);
}

#[test]
fn png_reads_back_as_it_was_drawn() {
    let picture = draw(&CYLINDER.scene((8, 16)), &style(10.0, 20.0));
    let mut bytes = Vec::new();
    write_png(&picture, &mut bytes).expect("memory");
    let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut pixels).expect("a frame");
    assert_eq!(pixels, picture.bytes());
}

#[test]
fn animations_have_a_frame_for_each_picture() {
    let pictures = || {
        (0..3_u8).map(|shade| {
            let mut scene = CYLINDER.scene((2, 8));
            scene.time = f64::from(shade);
            io::Result::Ok(draw(&scene, &Style { is_labelled: true, ..style(10.0, 20.0) }))
        })
    };
    let (mut animated_png, mut gif) = (Vec::new(), Vec::new());
    write_apng(pictures(), 3, 25, &mut animated_png).expect("memory");
    write_gif(pictures(), 25, &mut gif).expect("memory");
    let reader = png::Decoder::new(io::Cursor::new(animated_png)).read_info().expect("a PNG");
    assert_eq!(reader.info().animation_control().map(|control| (control.num_frames, control.num_plays)), Some((3, 0)));
    let mut decoder = gif::DecodeOptions::new().read_info(gif.as_slice()).expect("a GIF");
    let mut delays = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        delays.push(frame.delay);
    }
    assert_eq!(delays, [4; 3], "hundredths of a second");
}

#[test]
fn pictures_that_cannot_be_drawn_are_refused() {
    let plain = style(0.0, 0.0);
    let refusal = |style: &Style, pictures| style.check(pictures, &Limits::default()).expect_err("out of range").code;
    assert_eq!(refusal(&Style { size: (15, 90), ..plain.clone() }, 1), Code::SettingOutOfRange);
    assert_eq!(refusal(&Style { lines: Some((0, 3)), ..plain.clone() }, 1), Code::SettingOutOfRange);
    for (azimuth, elevation, zoom) in [(f64::NAN, 0.0, 1.0), (0.0, 91.0, 1.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1e4)] {
        let camera = Camera { azimuth, elevation, zoom };
        assert_eq!(refusal(&Style { camera, ..plain.clone() }, 1), Code::SettingOutOfRange);
    }
    assert_eq!(refusal(&Style { size: (8000, 8001), ..plain.clone() }, 1), Code::LimitReached);
    assert_eq!(refusal(&Style { size: (usize::MAX, 16), ..plain.clone() }, 2), Code::LimitReached);
    assert!(Style { size: (8000, 8000), ..plain }.check(1, &Limits::default()).is_ok());
}

#[cfg(feature = "cli")]
fn decoded(path: &std::path::Path) -> (u32, u32, Vec<u8>) {
    let file = std::fs::File::open(path).expect("a picture");
    let mut reader = png::Decoder::new(io::BufReader::new(file)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut pixels).expect("a frame");
    (frame.width, frame.height, pixels)
}

#[cfg(feature = "cli")]
#[test]
fn pictures_of_the_documentation_show_what_the_program_draws() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    for line in include_str!("../../docs/pictures/commands.txt").lines() {
        let (name, arguments) = line.split_once(' ').expect("a name and arguments");
        let drawn = folder.path().join(name);
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_trimline"))
            .arg("render")
            .args(arguments.split_whitespace())
            .arg("-o")
            .arg(&drawn)
            .current_dir(root)
            .output()
            .expect("the command starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let stored = root.join("docs/pictures").join(name);
        assert!(std::fs::metadata(&stored).expect("a picture").len() < 60_000, "{name} is too large for a page");
        let ((width, height, expected), (drawn_width, drawn_height, found)) = (decoded(&stored), decoded(&drawn));
        assert_eq!((width, height), (drawn_width, drawn_height), "{name}");
        let different = expected.iter().zip(&found).filter(|(a, b)| a.abs_diff(**b) > 24).count();
        // The last digits of the surface may change and move a pixel at an edge; nobody sees one in two hundred.
        assert!(different <= expected.len() / 200, "{name}: {different} values; run docs/pictures/make");
    }
}
