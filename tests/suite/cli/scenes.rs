//! `mesh` and `render` on the command line: files, frames, animations and pictures.

use super::{Folder, done, example, status, text, trimline};

#[test]
fn frames_are_numbered_files_over_the_time_domain() {
    let folder = Folder::new();
    let target = folder.path("out.obj").to_string_lossy().into_owned();
    done(&trimline(&["mesh", &example("eq19.trim"), "-o", &target, "--frames", "3", "--grid", "4x8"]));
    assert_eq!(folder.files(), ["out.0000.obj", "out.0001.obj", "out.0002.obj"]);
    let last = std::fs::read_to_string(folder.path("out.0002.obj")).expect("written");
    assert!(last.lines().next().expect("a comment").contains("t = 0.3"), "{last}");
    // Closed in v: 5 rows of 8 vertices, not of 9.
    assert_eq!(last.lines().filter(|line| line.starts_with("v ")).count(), 40);
    assert_eq!(last.lines().filter(|line| line.starts_with("f ")).count(), 32);
}

#[test]
fn frames_of_an_animated_format_are_one_file() {
    let folder = Folder::new();
    let target = folder.path("out.glb").to_string_lossy().into_owned();
    done(&trimline(&["mesh", &example("eq19.trim"), "-o", &target, "--frames", "3", "--grid", "4x8"]));
    assert_eq!(folder.files(), ["out.glb"]);
}

#[test]
fn frames_of_vtp_have_an_index_of_their_instants() {
    let folder = Folder::new();
    let target = folder.path("out.vtp").to_string_lossy().into_owned();
    done(&trimline(&["mesh", &example("eq19.trim"), "-o", &target, "--frames", "2", "--grid", "4x8"]));
    assert_eq!(folder.files(), ["out.0000.vtp", "out.0001.vtp", "out.pvd"]);
    let index = std::fs::read_to_string(folder.path("out.pvd")).expect("written");
    assert!(index.contains(r#"timestep="0.3" part="0" file="out.0001.vtp""#), "{index}");
}

#[test]
fn more_animated_vertices_than_allowed_are_a_limit() {
    let folder = Folder::new();
    let target = folder.path("out.glb").to_string_lossy().into_owned();
    let spec = example("eq19.trim");
    let run = |limit: &str| {
        let grid = ["--frames", "3", "--grid", "4x8", "--limits", limit];
        trimline(&[&["mesh", &spec, "-o", &target][..], &grid].concat())
    };
    // 5 rows of 8 vertices at 3 instants.
    assert_eq!(status(&run("animated-vertices=119")), 4);
    assert!(folder.files().is_empty());
    assert_eq!(status(&run("animated-vertices=120")), 0);
}

#[test]
fn pictures_sheets_and_animations_are_one_file_each() {
    let folder = Folder::new();
    let draw = |name: &str, options: &[&str]| {
        let target = folder.path(name).to_string_lossy().into_owned();
        let spec = example("eq19.trim");
        let arguments = ["render", &spec, "-o", &target, "--grid", "8x16", "--size", "60x40"];
        done(&trimline(&[&arguments[..], options].concat()));
        std::fs::read(folder.path(name)).expect("written")
    };
    let still = draw("a.png", &["--shade", "curvature", "--lines", "4x4"]);
    let sheet = draw("b.png", &["--frames", "5"]);
    let animation = draw("c.png", &["--animate", "--frames", "3"]);
    assert!(draw("d.gif", &["--animate", "--frames", "3"]).starts_with(b"GIF89a"));
    let width = |png: &[u8]| u32::from_be_bytes(png[16..20].try_into().expect("four bytes"));
    // Three columns of 60 with lines between them.
    assert_eq!((width(&still), width(&sheet), width(&animation)), (60, 182, 60));
    assert!(animation.windows(4).any(|window| window == b"acTL"));
    assert_eq!(folder.files(), ["a.png", "b.png", "c.png", "d.gif"]);
}

#[test]
fn pictures_that_cannot_be_drawn_leave_no_file() {
    let cases: &[(&[&str], i32, &str)] = &[
        (&["--size", "8x8"], 2, "too small"),
        (&["--size", "100000x100000"], 4, "`pixels`"),
        (&["--size", "big"], 2, "WxH"),
        (&["--camera", "0,100"], 2, "--camera"),
        (&["--camera", "left"], 2, "AZIMUTH,ELEVATION"),
        (&["--lines", "0x3"], 2, "--lines"),
        (&["--shade", "pink"], 2, "pink"),
        (&["--fps", "0"], 2, "fps"),
        (&["--animate", "--time", "0.1"], 2, "--time"),
        (&["--frames", "3", "--size", "5000x5000"], 4, "`pixels`"),
    ];
    for (options, expected, fragment) in cases {
        let folder = Folder::new();
        let target = folder.path("out.png").to_string_lossy().into_owned();
        let spec = example("eq19.trim");
        let output = trimline(&[&["render", &spec, "-o", &target][..], options].concat());
        let errors = text(&output.stderr);
        assert_eq!(status(&output), *expected, "{options:?}: {errors}");
        assert!(errors.contains(fragment), "{options:?}: {errors}");
        assert!(folder.files().is_empty(), "{options:?}");
    }
}

#[test]
fn fields_for_a_format_without_them_are_wrong_usage() {
    let folder = Folder::new();
    let target = folder.path("out.stl").to_string_lossy().into_owned();
    let output = trimline(&["mesh", &example("eq19.trim"), "-o", &target, "--fields", "residual"]);
    assert_eq!(status(&output), 2);
    assert!(text(&output.stderr).contains("write PLY, USDA, VTP, NPZ"), "{}", text(&output.stderr));
}

#[test]
fn every_example_meshes_in_every_format_and_repeats_byte_for_byte() {
    for name in ["eq6.trim", "eq19.trim", "eq29_30.trim", "eq31_32.trim"] {
        for extension in ["obj", "ply", "stl", "glb", "usda", "3mf", "vtp", "npz"] {
            let folder = Folder::new();
            let mut bytes = Vec::new();
            for copy in ["a", "b"] {
                let target = folder.path(&format!("{copy}.{extension}"));
                done(&trimline(&["mesh", &example(name), "-o", &target.to_string_lossy(), "--grid", "6x10"]));
                bytes.push(std::fs::read(target).expect("written"));
            }
            assert!(!bytes[0].is_empty());
            assert_eq!(bytes[0], bytes[1], "{name} {extension}");
        }
    }
}
