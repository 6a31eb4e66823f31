//! `trimline morph` as its users run it.

use serde_json::Value;

use crate::cli::{Folder, done, example, status, text, trimline};

fn shapes() -> [String; 2] {
    ["p3_positions.trim", "p3_flask.trim"].map(example)
}

fn glasses() -> [String; 2] {
    ["p3_water_glass.trim", "p3_wine_glass.trim"].map(example)
}

fn report(options: &[&str]) -> Value {
    let [source, target] = shapes();
    let arguments = [&["morph", &source, &target, "--format", "json", "-q"], options].concat();
    serde_json::from_str(&done(&trimline(&arguments))).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Patch, u, v, position and first derivatives of the glass at ε = 0.3.
fn reference() -> Vec<(&'static str, Vec<f64>)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/p3_morph.json");
    let reference: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a text")).expect("JSON");
    let variants = reference["variants"].as_array().expect("variants").iter();
    let rows = variants.flat_map(|variant| {
        let patch = if variant["id"] == "patch_base" { "base" } else { "body" };
        let rows = variant["values"].as_array().expect("rows").iter();
        rows.map(move |row| (patch, row.as_array().expect("a row").iter().map(number).collect()))
    });
    rows.collect()
}

/// Compares what a command prints for the points of the reference, whose patches have names that begin with `prefix`.
fn assert_reference(prefix: &str, arguments: &[&str]) {
    let rows = reference();
    let folder = Folder::new();
    let points = folder.path("points.csv");
    let lines: String =
        rows.iter().map(|(patch, row)| format!("{prefix}{patch},{:?},{:?}\n", row[0], row[1])).collect();
    std::fs::write(&points, format!("patch,u,v\n{lines}")).expect("written");
    let points = points.to_string_lossy().into_owned();
    let table = done(&trimline(&[arguments, &["--points", &points, "--derivatives", "u,v"]].concat()));
    assert_eq!(table.lines().count(), 81);
    for (line, (_, expected)) in table.lines().skip(1).zip(&rows) {
        let found: Vec<f64> = line.split(',').skip(3).map(|cell| cell.parse().expect("a number")).collect();
        assert_eq!(found.len(), 9);
        for (found, expected) in found.iter().zip(&expected[2..]) {
            // What the reference asks for.
            assert!((found - expected).abs() <= 1e-9 * (1.0 + expected.abs()), "{line}");
        }
    }
}

#[test]
fn points_of_a_frame_are_those_of_extended_precision() {
    let [source, target] = glasses();
    assert_reference("", &["morph", &source, &target, "--steps", "9", "--frame", "3"]);
    assert_reference("", &["morph", &source, &target, "--at", "0.3"]);
    let both = example("p3_glasses.trim");
    assert_reference("water_", &["morph", &both, "--frame", "3"]);
    assert_reference("water_", &["eval", &both, "--morph", "0.3"]);
}

#[test]
fn morph_that_a_spec_states_is_that_of_two_specs() {
    let ([water, wine], [vase, flask]) = (glasses(), shapes());
    let cases: [(&str, &[&str], [&str; 3]); 2] = [
        ("p3_glasses.trim", &[], [&water, &wine, "boundary"]),
        ("p3_vase_to_flask.trim", &[], [&vase, &flask, "both"]),
    ];
    for (name, options, [source, target, by]) in cases {
        let printed = |specs: &[&str]| done(&trimline(&[&["morph", "-q"], specs, options].concat()));
        assert_eq!(printed(&[&example(name)]), printed(&[source, target, "--by", by]), "{name}");
    }
}

#[test]
fn steps_of_boundary_morphs_fall_as_one_over_their_number() {
    let [few, many] = ["9", "39"].map(|steps| number(&report(&["--steps", steps])["largest_step"]));
    // The shapes lie on a straight line, so that all steps are equal: 10 and 40 of them.
    assert!((few / many - 4.0).abs() < 1e-9, "{few} {many}");
}

#[test]
fn steps_of_combined_morphs_fall_as_one_over_their_number() {
    let inner = |steps| number(&report(&["--by", "both", "--steps", steps])["largest_inner_step"]);
    let [few, many] = ["41", "81"].map(inner);
    // Steps are straight up to second order: halving them changes what is left of the ratio by about 1/40.
    assert!((few / many - 2.0).abs() < 0.1, "{few} {many}");
}

#[test]
fn morph_by_modes_jumps_where_the_boundary_changes_at_once() {
    let report = report(&["--by", "modes"]);
    let frames = report["frames"].as_array().expect("frames");
    let modes: Vec<Option<f64>> = frames.iter().map(|frame| frame["modes"].as_f64()).collect();
    let between = [5.0, 4.0, 3.0, 2.0, 1.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Some);
    assert_eq!(modes, [&[None], &between[..], &[None]].concat());
    let largest = number(&report["largest_step"]);
    assert_eq!(number(&frames[6]["step"]), largest, "from one mode of the source to one of the target");
}

#[test]
fn first_and_last_step_of_a_morph_by_modes_are_the_remainders() {
    // Frame 1 has the source's modes without its remainder; the vase's is 0.050, from arithmetic of 50 digits.
    let report = report(&["--by", "modes"]);
    assert!((number(&report["frames"][1]["step"]) - 0.050).abs() < 5e-4, "{report}");
}

#[test]
fn frames_become_one_animation_or_numbered_files() {
    let [source, target] = glasses();
    let folder = Folder::new();
    for name in ["glass.glb", "glass.obj"] {
        let path = folder.path(name).to_string_lossy().into_owned();
        let arguments = ["morph", &source, &target, "--steps", "2", "--grid", "4x12", "-o", &path];
        let output = trimline(&arguments);
        assert!(done(&output).is_empty());
        assert!(text(&output.stderr).contains("largest step"), "{}", text(&output.stderr));
    }
    let files = ["glass.0000.obj", "glass.0001.obj", "glass.0002.obj", "glass.0003.obj", "glass.glb"];
    assert_eq!(folder.files(), files);
    let one = folder.path("one.obj").to_string_lossy().into_owned();
    done(&trimline(&["morph", &source, &target, "--at", "0.5", "--grid", "4x12", "-o", &one]));
    assert!(folder.files().contains(&"one.obj".to_owned()));
}

#[test]
fn frames_are_drawn_on_a_sheet_or_as_an_animation() {
    let folder = Folder::new();
    let spec = example("p3_glasses.trim");
    let draw = |name: &str, options: &[&str]| {
        let path = folder.path(name);
        let file = path.to_string_lossy().into_owned();
        let arguments = ["morph", &spec, "-q", "--grid", "4x12", "--size", "40x50", "-o", &file];
        assert!(done(&trimline(&[&arguments[..], options].concat())).is_empty());
        let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(path).expect("written")));
        let mut reader = decoder.read_info().expect("a PNG");
        let animation = reader.info().animation_control.map(|control| control.num_frames);
        let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
        reader.next_frame(&mut pixels).expect("a picture");
        ((reader.info().width, reader.info().height), animation, pixels)
    };
    // Eleven in rows of four, with a line between.
    let (size, animation, _) = draw("sheet.png", &[]);
    assert_eq!((size, animation), ((4 * 41 - 1, 3 * 51 - 1), None));
    let (size, animation, first) = draw("film.png", &["--animate"]);
    assert_eq!((size, animation), ((40, 50), Some(11)));
    let (size, animation, last) = draw("one.png", &["--frame", "10"]);
    assert_eq!((size, animation), ((40, 50), None));
    assert_ne!(first, last);
}

#[test]
fn morph_of_a_spec_asks_for_what_it_needs() {
    let folder = Folder::new();
    let flat = "at u = 0: S = [cos v, sin v, 0]\nat u = 1: S = [cos v, sin v, 1]\n";
    let pair = |from: &str, to: &str| {
        folder.spec(format!("pde d2S/du2 + d2S/dv2 = 0\nmorph from p to q\npatch p {{\n{from}}}\npatch q {{\n{to}}}\n"))
    };
    let said = |arguments: &[&str], expected| {
        let output = trimline(arguments);
        assert_eq!(status(&output), expected, "{}", text(&output.stderr));
        assert!(output.stdout.is_empty());
        text(&output.stderr)
    };
    let spec = pair(flat, flat);
    let still = done(&trimline(&["morph", &spec, "-q"]));
    assert!(still.ends_with("largest step 0.000000\n"), "{still}");
    let spec = pair(flat, &format!("domain v in [0, 1]\n{flat}"));
    assert!(said(&["morph", &spec], 1).contains("domain"), "{}", said(&["morph", &spec], 1));
    let [water, _] = glasses();
    assert!(said(&["morph", &water], 2).contains("states no `morph from A to B`"));
    let both = example("p3_glasses.trim");
    assert!(said(&["eval", &both, "--points", "nowhere.csv", "--morph", "1.5"], 2).contains("outside [0, 1]"));
}

#[test]
fn bad_requests_have_their_status_and_leave_nothing() {
    let ([water, wine], [vase, _]) = (glasses(), shapes());
    let cases: &[(&str, &[&str], i32, &str)] = &[
        (&vase, &[], 1, "the source has no patch `base`"),
        (&wine, &["--frame", "11"], 2, "the target is frame 10"),
        (&wine, &["--at", "1.5"], 2, "outside [0, 1]"),
        (&wine, &["--by", "modes", "--at", "0.5"], 2, "--frame"),
        (&wine, &["--by", "modes", "--steps", "7"], 2, "has 1 + 1 frames"),
        (&wine, &["--by", "modes", "--method", "exact"], 1, "needs `fourier`"),
        (&wine, &["--steps", "0"], 2, "nothing in between"),
        (&wine, &["--steps", "20000"], 4, "frames = 10000"),
        (&wine, &["--points", "nowhere.csv"], 2, "choose it with --frame or --at"),
        (&wine, &["--frame", "2"], 2, "say what to write"),
        (&wine, &["-o", "glass.xyz"], 2, "the extension `.xyz`"),
        (&wine, &["--frame", "1", "--at", "0.5"], 2, "cannot be used with"),
    ];
    for (target, options, expected, words) in cases {
        let source = if *target == vase { &wine } else { &water };
        let (source, target) = if *target == vase { (*target, source.as_str()) } else { (source.as_str(), *target) };
        let output = trimline(&[&["morph", source, target], *options].concat());
        let said = text(&output.stderr);
        assert_eq!(status(&output), *expected, "{options:?}: {said}");
        assert!(said.contains(words), "{options:?}: {said}");
        assert!(output.stdout.is_empty(), "{options:?}");
    }
}

#[test]
fn check_refuses_a_stated_morph_of_shapes_that_do_not_correspond() {
    let patch = |name: &str, last: &str| {
        format!(
            "patch {name} {{\ndomain u in [0, {last}]\nat u = 0: S = [cos v, sin v, 0]\nat u = {last}: S = [cos v, sin v, 1]\n}}\n"
        )
    };
    let spec =
        |last: &str| format!("pde ∂²S/∂u² + ∂²S/∂v² = 0\nmorph from p to q\n{}{}", patch("p", "1"), patch("q", last));
    let folder = Folder::new();
    let [same, other] = [("same.trim", "1"), ("other.trim", "2")].map(|(name, last)| {
        std::fs::write(folder.path(name), spec(last)).expect("written");
        folder.path(name).to_string_lossy().into_owned()
    });
    assert_eq!(status(&trimline(&["check", &same])), 0);
    let refused = trimline(&["check", &other]);
    assert_eq!(status(&refused), 1);
    assert!(text(&refused.stderr).contains("E0220"), "{}", text(&refused.stderr));
}

/// A ring that rises by 2, a net, and copies of both.
const WITH_COPIES: &str = "morph from a to b\npde d2S/du2 + d2S/dv2 = 0\nparam far = 5\n\
    patch a { at u = 0: S = [cos v, sin v, 0]; at u = 1: S = [2 cos v, 2 sin v, 1] }\n\
    patch b { at u = 0: S = [cos v, sin v, 2]; at u = 1: S = [2 cos v, 2 sin v, 3] }\n\
    bspline s { net 4 x 4 from [i, j, 0] }\nmirror s in x = -3\nrepeat a 2 times moved by [far, 0, 0]\n";

#[test]
fn nets_stay_as_they_are_and_copies_follow_their_originals() {
    let folder = Folder::new();
    let spec = folder.spec(WITH_COPIES);
    let points = folder.path("points.csv");
    std::fs::write(&points, "patch,u,v\na,0,0\na2,0,0\ns,0,0\ns_mirrored,0,0\n").expect("written");
    let table = done(&trimline(&["morph", &spec, "--at", "0.25", "--points", &points.to_string_lossy()]));
    let positions: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').skip(3).map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    let expected = [[1.0, 0.0, 0.5], [6.0, 0.0, 0.5], [0.0, 0.0, 0.0], [-6.0, 0.0, 0.0]];
    for (found, expected) in positions.iter().zip(expected) {
        // Sums of a few numbers below 10.
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{table}");
    }
    assert_eq!(positions.len(), 4);
    // At the ends too, and of the parts that do not change nothing is as far from frame to frame as of those that do.
    let target = folder.path("out.obj");
    for epsilon in ["0", "0.5", "1"] {
        let arguments = ["morph", &spec, "--at", epsilon, "--grid", "2x4", "-o", &target.to_string_lossy()];
        done(&trimline(&arguments));
        let written = std::fs::read_to_string(&target).expect("a mesh");
        let objects: Vec<&str> = written.lines().filter_map(|line| line.strip_prefix("o ")).collect();
        assert_eq!(objects, ["a", "s", "s_mirrored", "a2"], "{epsilon}");
    }
    let picture = folder.path("out.png").to_string_lossy().into_owned();
    done(&trimline(&["morph", &spec, "--at", "0.5", "--shade", "residual", "--size", "64x64", "-o", &picture]));
}

#[test]
fn what_a_morph_cannot_take_along_is_refused_with_its_reason() {
    let folder = Folder::new();
    let refused = |text_of_spec: String, options: &[&str], fragment: &str| {
        let spec = folder.spec(text_of_spec);
        let mut arguments = vec!["morph", spec.as_str()];
        arguments.extend(options.iter().map(|option| if *option == "SPEC" { spec.as_str() } else { option }));
        let output = trimline(&arguments);
        let errors = text(&output.stderr);
        assert_eq!(status(&output), 1, "{errors}");
        assert!(errors.contains("E0402") && errors.contains(fragment), "{errors}");
    };
    let whole = WITH_COPIES.to_owned();
    refused(whole.clone(), &["--patch", "s"], "`s` is a B-spline net");
    refused(whole.clone(), &["--patch", "a2"], "`a2` is a copy of `a`");
    refused(whole.clone(), &["SPEC"], "`s` is a B-spline net");
    refused(
        format!("{whole}mirror b in x = 9\n"),
        &[],
        "`b_mirrored` is a copy of `b`, which is what the morph makes of `a`",
    );
    done(&trimline(&["morph", &folder.spec(format!("{whole}mirror b in x = 9\n")), "--patch", "a"]));
}
