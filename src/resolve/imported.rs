//! `surface S1 = bspline("part.step", face = 2)`: a primary surface from a file of B-splines.
//!
//! Its parameters u and v are those of its knots, which are its ranges. Where its two edges are one curve it repeats itself
//! with that period; beyond its knots otherwise there is no surface. Edges that are one but for the digits of the file are
//! made one, and it is said how far control points moved.

use std::rc::Rc;
use std::sync::Arc;

use super::curve;
use super::reading::Reading;
use super::scope::{Meaning, Scope};
use super::surface::SurfaceMeaning;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Span};
use crate::expr::{Number, SplineCall, Variable};
use crate::limits::Limits;
use crate::problem::PrimarySurface;
use crate::surface::BsplineSurface;
use crate::surface::bspline::{Closing, from_json, from_step, uncertainty};
use crate::syntax::ast::{DataFile, Definition, Kind, Name};

/// The names of the parameters.
const PARAMETERS: [&str; 2] = ["u", "v"];

/// Of the breadth between two edges: those that are nearer to each other are one, whatever the file says of itself. Files
/// with ten digits leave less.
const ONE_EDGE: f64 = 1e-9;

/// Of that breadth: no file may mean more by one place, in whatever unit it says so.
const COARSEST: f64 = 1e-6;

/// Of that breadth: whoever leaves a smaller gap may have meant none.
const NEARLY: f64 = 1e-3;

/// What a file holds.
struct Contents {
    /// With their names.
    surfaces: Vec<(String, BsplineSurface)>,
    /// Below which distance two points are one.
    uncertainty: Option<f64>,
}

/// A surface from a file, with what its file says of it.
struct Imported {
    surface: BsplineSurface,
    uncertainty: Option<f64>,
}

/// A surface that is closed where its edges are one.
struct Closed {
    surface: BsplineSurface,
    seams: [Option<usize>; 2],
    remarks: Diagnostics,
}

/// Declares a `surface` from a file, of which `face` says which, from 1.
pub fn declare(definition: &Definition, face: Option<usize>, scope: &mut Scope<'_>, reading: &mut Reading<'_>) {
    let node = reading.tree.node(definition.value);
    let Kind::Text(path) = &node.kind else { return };
    let name = &definition.name.text;
    let file = reading.files.iter().find(|file| file.path == *path);
    let surface = surface(path, file, face, reading.limits).and_then(|imported| {
        let closed = closed(imported, &definition.name);
        let splines = closed.surface.splines(name, PARAMETERS, closed.seams).ok_or_else(|| {
            Diagnostic::new(Code::BadSplineFile, format!("{path}: the values of the B-spline overflow")).hint(
                "knots very close together, or coordinates near the largest double, leave no numbers to compute with",
            )
        })?;
        Ok((closed, splines))
    });
    let meaning = match reading.keep(surface.map_err(|finding| finding.at(node.span))) {
        None => Meaning::Faulty,
        Some((surface, splines)) => {
            let which = face.map_or_else(String::new, |face| format!(", face = {face}"));
            reading.data.push(format!("surface {name} = bspline(\"{path}\"{which})"));
            imported(definition, surface, splines, reading)
        }
    };
    let declared = scope.declare(&definition.name, meaning);
    reading.keep(declared);
}

fn imported(
    definition: &Definition,
    Closed { surface, remarks, .. }: Closed,
    splines: [SplineCall; 3],
    reading: &mut Reading<'_>,
) -> Meaning {
    let arguments = [Variable::U, Variable::V].map(|variable| reading.graph.variable(variable));
    let position = splines.map(|spline| reading.graph.spline(spline, &arguments));
    let mut end = |x: f64| reading.graph.number(Number::from_f64(x).unwrap_or(Number::integer(0)));
    let ranges = surface.domain().map(|range| Some(range.map(&mut end)));
    let index = reading.surfaces.len();
    reading.surfaces.push(PrimarySurface {
        name: definition.name.text.clone(),
        parameters: PARAMETERS.map(str::to_owned).to_vec(),
        position,
        ranges,
        range_origins: [None; 2],
        origin: Some(definition.name.span),
        remarks,
    });
    let parameters = PARAMETERS.map(|name| Name { text: name.to_owned(), span: Span::default() }).to_vec();
    Meaning::Surface(Rc::new(SurfaceMeaning { index: Some(index), parameters, position }))
}

/// The surface with the edges made one that are one.
fn closed(Imported { mut surface, uncertainty }: Imported, name: &Name) -> Closed {
    let mut seams = [None; 2];
    let mut remarks = Diagnostics::new();
    for (seam, parameter) in seams.iter_mut().zip(PARAMETERS) {
        // The other direction's turn comes with the second exchange.
        let breadth = surface.breadth_in_u();
        let stated = uncertainty.map_or(0.0, |uncertainty| uncertainty.min(COARSEST * breadth));
        let tolerance = stated.max(ONE_EDGE * breadth);
        let closing = surface.closed_in_u(tolerance);
        remarks.extend(
            remark(&closing, (&name.text, parameter), [tolerance, breadth]).map(|finding| finding.at(name.span)),
        );
        *seam = closing.seam;
        surface = closing.surface.transposed();
    }
    Closed { surface, seams, remarks }
}

/// What there is to say of edges that were moved together, or are nearly one.
fn remark(closing: &Closing, (name, parameter): (&str, &str), [tolerance, breadth]: [f64; 2]) -> Option<Diagnostic> {
    let Closing { seam, gap, moved, .. } = closing;
    let finding = |message: String| Diagnostic::new(Code::EdgesNearlyMeet, message);
    let edges = format!("the edges of `{name}` at both ends of {parameter}");
    match seam {
        Some(order) if *moved > 0.0 => {
            // Edges that are one already leave only derivatives to agree.
            let meeting =
                if *gap > 0.0 { format!("are up to {gap:.1e} apart and were made one") } else { "meet".to_owned() };
            Some(finding(format!(
                "{edges} {meeting}: control points moved by up to {moved:.1e}, so that derivatives up to order {order} agree there"
            )))
        }
        None if *gap <= NEARLY * breadth => {
            let message = format!(
                "{edges} are up to {gap:.1e} apart, so that it is open there: edges are one within {tolerance:.1e}"
            );
            Some(
                finding(message)
                    .hint("close it in the program it comes from, or write more digits, if it is meant to close"),
            )
        }
        _ => None,
    }
}

/// The surface of a file that is meant.
fn surface(path: &str, file: Option<&DataFile>, face: Option<usize>, limits: &Limits) -> Result<Imported, Diagnostic> {
    let Contents { surfaces: mut found, uncertainty } =
        read(curve::contents(path, file)?, path, limits).map_err(|mut finding| {
            finding.message = format!("{path}: {}", finding.message);
            finding
        })?;
    let count = found.len();
    let what = match count {
        1 => "1 B-spline surface".to_owned(),
        _ => format!("{count} B-spline surfaces"),
    };
    let bad = |message: String| Diagnostic::new(Code::BadSplineFile, message);
    let index = match face {
        _ if count == 0 => {
            let finding = bad(format!("{path}: it holds no B-spline surface"));
            return Err(finding.hint("write the surfaces to it, or name another file"));
        }
        None if count == 1 => 0,
        None => {
            let finding = bad(format!("{path}: it holds {what}, and which of them is meant is missing"));
            return Err(finding.hint(format!("write `bspline(\"{path}\", face = 1)`")));
        }
        Some(face) => face.wrapping_sub(1),
    };
    if index >= count {
        let finding = bad(format!("{path}: there is no face {}: it holds {what}", face.unwrap_or_default()));
        return Err(finding.hint("faces are counted from 1, in the order of the file"));
    }
    Ok(Imported { surface: found.swap_remove(index).1, uncertainty })
}

fn read(bytes: &Arc<[u8]>, path: &str, limits: &Limits) -> Result<Contents, Diagnostic> {
    let text = std::str::from_utf8(bytes).map_err(|_| {
        Diagnostic::new(Code::BadSplineFile, "it is no text").hint("files of B-splines are JSON or STEP")
    })?;
    let extension = path.rsplit_once('.').map_or("", |(_, extension)| extension);
    let is_step = ["step", "stp"].iter().any(|known| extension.eq_ignore_ascii_case(known));
    Ok(match is_step {
        true => Contents { surfaces: from_step(text, limits)?, uncertainty: uncertainty(text) },
        false => Contents { surfaces: from_json(text, limits)?, uncertainty: None },
    })
}
