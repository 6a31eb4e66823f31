//! Seams along a part of a side: stated, found, and refused.

use serde_json::Value;

use crate::cli::{Folder, done, status, text, trimline};

/// A wall over v in [0, 3] and a tab on its upper side that begins at v = `from`, leaves it at a slope of a half and runs
/// `length` along it, as much as its own v runs from 0 to `range`.
fn spec(from: f64, length: f64, range: f64, statement: &str) -> String {
    format!(
        "param from = {from}, pace = {length}/{range}, lift = 0.3
domain t in [0, 1]
pde ∂⁴S/∂u⁴ = 0
let bend(s) = [s, t, 0.2 s^2 + lift t s]
patch wall {{
    domain v in [0, 3]
    at u = 0: S = bend(v) - [0, 1, 0], ∂S/∂u = [0, 1, 0]
    at u = 1: S = bend(v), ∂S/∂u = [0, 1, 0]
}}
patch tab {{
    domain v in [0, {range}]
    let s = from + pace v
    at u = 0: S = bend(s), ∂S/∂u = [0, 1, 0.5]
    at u = 1: S = bend(s) + [0, 1, 0.7], ∂S/∂u = [0, 1, 0.5]
}}
{statement}\n"
    )
}

fn seams(spec: &str) -> Vec<Value> {
    let folder = Folder::new();
    let output = done(&trimline(&["check", &folder.spec(spec), "--format", "json"]));
    let report: Value = serde_json::from_str(&output).expect("JSON");
    report["seams"].as_array().expect("seams").clone()
}

/// The slope of a half, seen across a curve of slope 0.4 x + 0.3 t: the steepest where that is least.
fn angle(x: f64, t: f64) -> f64 {
    0.5_f64.atan2((0.4 * x + 0.3 * t).hypot(1.0)).to_degrees()
}

fn assert_part(place: &Value, patch: &str, part: Option<[f64; 2]>) {
    assert_eq!(place["patch"], patch);
    match part {
        None => assert!(place.get("part").is_none(), "{place}"),
        Some(ends) => {
            let found: [f64; 2] = serde_json::from_value(place["part"].clone()).unwrap_or_else(|_| panic!("{place}"));
            // Newton's step ends at rounding.
            assert!(ends.iter().zip(found).all(|(a, b)| (a - b).abs() < 1e-12), "{place}");
        }
    }
}

#[test]
fn seam_along_a_part_of_a_side_is_found_with_its_gap_and_angle() {
    for (from, length, range, of_wall, of_tab) in [
        (1.0, 1.0, 1.0, Some([1.0 / 3.0, 2.0 / 3.0]), None),
        (0.0, 1.0, 2.0, Some([0.0, 1.0 / 3.0]), None),
        (2.5, -1.0, 1.0, Some([0.5, 2.5 / 3.0]), None),
        // Each reaches past the other; and the whole wall on a part of the tab.
        (2.0, 2.0, 1.0, Some([2.0 / 3.0, 1.0]), Some([0.0, 0.5])),
        (4.0, -2.0, 1.0, Some([2.0 / 3.0, 1.0]), Some([1.0, 0.5])),
        (-1.0, 5.0, 1.0, None, Some([0.2, 0.8])),
    ] {
        let found = seams(&spec(from, length, range, ""));
        let [seam] = found.as_slice() else { panic!("{from}: {found:?}") };
        assert_eq!(seam["stated"], false);
        let [wall, tab] = [0, 1].map(|index| &seam["between"][index]);
        assert_part(wall, "wall", of_wall);
        assert_part(tab, "tab", of_tab);
        assert!(seam["gap"].as_f64().expect("a gap") < 1e-14, "{seam}");
        let steepest = angle(from.min(from + length).max(0.0), 0.0);
        assert!((seam["angle_degrees"].as_f64().expect("an angle") - steepest).abs() < 1e-9, "{seam} {steepest}");
    }
}

#[test]
fn sides_that_touch_in_a_point_or_run_apart_have_no_seam() {
    // The tab begins where the wall ends; beside it; and where a corner of the tab lies on the wall.
    assert_eq!(seams(&spec(3.0, 1.0, 1.0, "")), [Value::Null; 0]);
    assert_eq!(seams(&spec(3.5, 1.0, 1.0, "")), [Value::Null; 0]);
    let leaving = spec(1.0, 1.0, 1.0, "")
        .replace("S = bend(s), ∂S/∂u = [0, 1, 0.5]", "S = bend(s) + [0, v, 0], ∂S/∂u = [0, 1, 0.5]");
    assert_eq!(seams(&leaving), [Value::Null; 0]);
}

#[test]
fn stated_part_of_a_side_is_measured_and_found_no_second_time() {
    for statement in [
        "seam wall at u = 1, v in [from, from + 1] with tab at u = 0",
        "seam tab at u = 0, v in [0, 1] with wall at u = 1, v in [1, 2]",
    ] {
        let found = seams(&spec(1.0, 1.0, 1.0, statement));
        let [seam] = found.as_slice() else { panic!("{found:?}") };
        assert_eq!(seam["stated"], true);
        let wall = if statement.starts_with("seam wall") { 0 } else { 1 };
        assert_part(&seam["between"][wall], "wall", Some([1.0 / 3.0, 2.0 / 3.0]));
        assert_part(&seam["between"][1 - wall], "tab", None);
        assert!(seam["gap"].as_f64().expect("a gap") < 1e-15, "{seam}");
    }
    let folder = Folder::new();
    let told = done(&trimline(&[
        "check",
        &folder.spec(spec(1.0, 1.0, 1.0, "seam wall at u = 1, v in [1, 2] with tab at u = 0")),
    ]));
    assert!(told.contains("wall at u = 1, v in [1, 2] with tab at u = 0"), "{told}");
}

#[test]
fn stated_part_that_is_open_fails_with_the_distance() {
    let folder = Folder::new();
    let open = folder.spec(spec(1.0, 1.0, 1.0, "seam wall at u = 1, v in [1, 2.25] with tab at u = 0"));
    let output = trimline(&["check", &open, "--time", "0"]);
    assert_eq!(status(&output), 1);
    // The ends (2.25, 0.2 2.25²) and (2, 0.8).
    let gap = 0.25_f64.hypot(0.2 * 2.25 * 2.25 - 0.8);
    assert!(
        text(&output.stderr)
            .contains(&format!("error[E0416]: the patches do not meet here: they are up to {gap:.1e} apart")),
        "{}",
        text(&output.stderr)
    );
}

/// A flat net over x in [0, 2] that ends at y = 0 where v = 1, and nets that go on from there as `[x, y, 0.3 x y]`; linear
/// functions of the Greville points are the surface itself.
fn nets(statement: &str) -> String {
    format!(
        "domain u in [0, 2], v in [0, 1]
bspline deck {{
    net 5 x 4 from [u, v - 1, 0]
}}
bspline onward {{
    net 5 x 6 from [u, v, 0.3 u v]
}}
{statement}\n"
    )
}

#[test]
fn sides_of_nets_at_fixed_v_are_measured_whichever_coordinates_meet_there() {
    // Twisted by 0.3 x across the edge: steepest at x = 2.
    let expected = 0.6_f64.atan().to_degrees();
    let swapped = "domain u in [0, 1], v in [0, 2]\n    net 4 x 5 from [v, u, 0.3 v u]";
    let against = "net 5 x 6 from [2 - u, 1 - v, 0.3 (2 - u) (1 - v)]";
    for (side, stated) in [("v = 0", None), ("u = 0", Some(swapped)), ("v = 1", Some(against))] {
        let change = |spec: String| {
            spec.replace("net 5 x 6 from [u, v, 0.3 u v]", stated.unwrap_or("net 5 x 6 from [u, v, 0.3 u v]"))
        };
        for is_stated in [false, true] {
            let statement = if is_stated { format!("seam deck at v = 1 with onward at {side}") } else { String::new() };
            let found = seams(&change(nets(&statement)));
            let [seam] = found.as_slice() else { panic!("{side}: {found:?}") };
            assert_eq!(seam["stated"], is_stated);
            assert_eq!(seam["between"][0]["v"], 1.0);
            let (name, position) = side.split_once(" = ").expect("a side");
            assert_eq!(seam["between"][1][name].as_f64(), position.parse().ok());
            assert!(seam["gap"].as_f64().expect("a gap") < 1e-15, "{seam}");
            // Tangents of size 1, with a few roundings.
            assert!((seam["angle_degrees"].as_f64().expect("an angle") - expected).abs() < 1e-12, "{seam}");
        }
    }
}

#[test]
fn part_of_a_side_of_a_net_meets_a_patch_and_a_copy_of_a_net() {
    let strip = "patch strip {
    domain u in [0, 1], v in [0, 1]
    pde ∂⁴S/∂u⁴ = 0
    at u = 0: S = [0.5 + v, -1, 0], ∂S/∂u = [0, -1, -0.5]
    at u = 1: S = [0.5 + v, -2, -0.5], ∂S/∂u = [0, -1, -0.5]
}
mirror deck in y = 0
seam deck at v = 0, u in [0.5, 1.5] with strip at u = 0
seam deck at v = 1 with deck_mirrored at v = 1";
    let found = seams(&nets(strip).replace("[u, v, 0.3 u v]", "[u, v, 5 + u v]"));
    let [of_strip, of_copy] = found.as_slice() else { panic!("{found:?}") };
    assert_part(&of_strip["between"][0], "deck", Some([0.25, 0.75]));
    assert!((of_strip["angle_degrees"].as_f64().expect("an angle") - 0.5_f64.atan().to_degrees()).abs() < 1e-12);
    assert_eq!((&of_copy["between"][1]["patch"], &of_copy["between"][1]["v"]), (&"deck_mirrored".into(), &1.0.into()));
    for seam in &found {
        assert!(seam["stated"] == true && seam["gap"].as_f64().expect("a gap") < 1e-15, "{seam}");
    }
}

#[test]
fn seams_of_nets_are_bounded_and_refused_where_there_is_no_edge() {
    let folder = Folder::new();
    let lifted = "[u, v, 0.3 u v + 0.01]";
    let open = folder.spec(nets("seam deck at v = 1 with onward at v = 0").replace("[u, v, 0.3 u v]", lifted));
    let output = trimline(&["check", &open]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stderr).contains("they are up to 1.0e-2 apart"), "{}", text(&output.stderr));
    let creased = folder.spec(nets(""));
    assert_eq!(status(&trimline(&["check", &creased, "--max-gap", "1e-12"])), 0);
    let output = trimline(&["check", &creased, "--max-angle", "30"]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stdout).contains("seam deck at v = 1 with onward at v = 0"), "{}", text(&output.stdout));
    assert_eq!(status(&trimline(&["check", &creased, "--max-angle", "31"])), 0);
    let output = trimline(&["check", &folder.spec(nets("seam deck at v = 0.5 with onward at v = 0"))]);
    assert!(text(&output.stderr).contains("`deck` has no edge at v = 0.5"), "{}", text(&output.stderr));
}
