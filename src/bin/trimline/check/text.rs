//! What `check` measured, for reading. Writing to a string does not fail.

use std::fmt::Write;

use trimline::diagnostic::Shortest;

use super::{Checked, CopyReport, LARGE_RESIDUAL, PatchReport};
use crate::joins::JoinReport;
use crate::nets;
use crate::output::rounded;

/// One spec after the other, under its name if there are several; then the verdict.
pub fn text(all: &[Checked]) -> String {
    let mut text = String::new();
    for checked in all {
        if all.len() > 1 {
            let verdict = if checked.is_sound { verdict(checked.passed) } else { "at fault" };
            let _ = writeln!(text, "{}: {verdict}", checked.spec);
        }
        write_checked(&mut text, checked);
    }
    let _ = writeln!(text, "{}", verdict(all.iter().all(|checked| checked.passed)));
    text
}

fn verdict(passed: bool) -> &'static str {
    if passed { "passed" } else { "not passed" }
}

fn write_checked(text: &mut String, checked: &Checked) {
    for patch in &checked.patches {
        let when = instants_text(&patch.times);
        if let Some(explanation) = &patch.explanation {
            let (unicode, latex) = (&explanation.unicode.whole, &explanation.latex.whole);
            let _ = writeln!(text, "patch {} as it was understood\n\n{unicode}\nin LaTeX\n\n{latex}", patch.name);
        }
        let _ = writeln!(text, "patch {}: method {}, {when}", patch.name, patch.method);
        for boundary in &patch.boundaries {
            let what = boundary.describe();
            let _ = writeln!(text, "  {what:20} largest error {}", rounded(boundary.max_error));
        }
        for join in &patch.joins {
            let _ =
                writeln!(text, "  {:20} {}", format!("{} at u = {}", join.surface, Shortest(join.u)), join_text(join));
        }
        for apex in &patch.apexes {
            let (name, position) = apex.u.map_or(("v", apex.v.unwrap_or(f64::NAN)), |u| ("u", u));
            let angle = match apex.angle_degrees {
                Some(angle) => format!("tangents leave one plane by up to {}°", rounded(angle)),
                None => "tangents span no plane".to_owned(),
            };
            let _ = writeln!(text, "  {:20} {angle}", format!("apex at {name} = {position}"));
        }
        let _ = writeln!(text, "  {:20} {}", "PDE residual", residual_text(patch));
    }
    for net in &checked.nets {
        nets::write_report(text, net);
    }
    for CopyReport { name, original } in &checked.copies {
        let _ = writeln!(text, "patch {name}: a copy of {original}");
    }
    for seam in &checked.seams {
        let (gap, angle) = (rounded(seam.gap), angle_text(seam.angle_degrees));
        let _ = writeln!(text, "{}: gap {gap}, {angle}", seam.describe());
    }
    for exceeded in &checked.exceeded {
        let _ = writeln!(text, "{}", exceeded.describe());
    }
}

/// The instants at which something was measured.
pub fn instants_text(times: &[f64]) -> String {
    match times {
        [first, .., last] => format!("{} instants from t = {first} to {last}", times.len()),
        times => times.iter().map(|time| format!("t = {time}")).collect(),
    }
}

fn residual_text(patch: &PatchReport) -> String {
    let mut text = format!("{} of the largest term", rounded(patch.pde_residual));
    if patch.pde_residual > LARGE_RESIDUAL {
        let _ = write!(
            text,
            " at t = {}: the boundary is met, the equation is not solved there",
            Shortest(patch.pde_residual_time)
        );
    }
    text
}

fn join_text(join: &JoinReport) -> String {
    let mut text = format!("gap {}, {}", rounded(join.gap), angle_text(join.angle_degrees));
    if let Some(tangent) = join.tangent {
        let _ = write!(text, ", unit tangents {} apart", rounded(tangent));
    }
    if let Some(curvature) = join.curvature {
        let _ = write!(text, ", curvatures {} apart", rounded(curvature));
    }
    if join.without_normal > 0 {
        let _ = write!(text, "; {} points without a normal", join.without_normal);
    }
    text
}

fn angle_text(angle: Option<f64>) -> String {
    angle.map_or_else(|| "no normals to compare".to_owned(), |angle| format!("angle {}°", rounded(angle)))
}
