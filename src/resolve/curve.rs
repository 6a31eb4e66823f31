//! `curve C = points("ring.csv")`: a closed curve through measured points, a function of one argument.
//!
//! A curve is used as a surface is: `C(v)`, `C_x(v)`, `∂C(v)/∂v`. Its body stands in the first coordinate.

use std::rc::Rc;
use std::sync::Arc;

use super::reading::Reading;
use super::scope::{Meaning, Scope};
use super::surface::SurfaceMeaning;
use crate::curves::{ClosedCurve, LEAST_POINTS, TableFault, read_points};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::Variable;
use crate::limits::Limits;
use crate::syntax::ast::{DataFile, Definition, Kind, Name};

/// Declares a `curve`.
pub fn declare(definition: &Definition, scope: &mut Scope<'_>, reading: &mut Reading<'_>) {
    let node = reading.tree.node(definition.value);
    let Kind::Text(path) = &node.kind else { return };
    let file = reading.files.iter().find(|file| file.path == *path);
    let curve = curve(&definition.name.text, path, file, reading.limits);
    let curve = reading.keep(curve.map_err(|finding| finding.at(node.span)));
    let meaning = match curve {
        None => Meaning::Faulty,
        Some(curve) => {
            let name = &definition.name.text;
            reading.data.push(format!("curve {name} = points(\"{path}\")"));
            let parameter = reading.graph.variable(Variable::U);
            let position = curve.coordinates.map(|coordinate| reading.graph.spline(coordinate, &[parameter]));
            let parameters = vec![Name { text: "v".to_owned(), span: Span::default() }];
            Meaning::Surface(Rc::new(SurfaceMeaning { index: None, parameters, position }))
        }
    };
    let declared = scope.declare(&definition.name, meaning);
    reading.keep(declared);
}

/// The points of a file with the rows they stand in; `too_many` is said of more than `allowed`.
pub fn rows(
    path: &str,
    file: Option<&DataFile>,
    allowed: usize,
    too_many: impl FnOnce() -> Diagnostic,
) -> Result<Vec<(usize, [f64; 3])>, Diagnostic> {
    read_points(contents(path, file)?, allowed).map_err(|fault| match fault {
        TableFault::TooMany { .. } => too_many(),
        _ => bad(path, &fault.to_string())
            .hint("a row holds x, y and z, separated by commas; a first row of names says in which order"),
    })
}

/// The bytes of a file.
pub fn contents<'a>(path: &str, file: Option<&'a DataFile>) -> Result<&'a Arc<[u8]>, Diagnostic> {
    file.and_then(|file| file.contents.as_ref()).ok_or_else(|| {
        Diagnostic::new(Code::DataFileMissing, format!("the data file `{path}` was not given"))
            .hint("the library reads no files: attach its bytes to the document before it is resolved")
    })
}

/// What is wrong in a file.
pub fn bad(path: &str, what: &str) -> Diagnostic {
    Diagnostic::new(Code::BadDataFile, format!("{path}: {what}"))
}

/// The curve through the points of a file.
fn curve(name: &str, path: &str, file: Option<&DataFile>, limits: &Limits) -> Result<ClosedCurve, Diagnostic> {
    let bad = |what: String| bad(path, &what);
    let rows = rows(path, file, limits.curve_points, || {
        let message = format!("{path}: it holds more points than the limit `curve-points` of {}", limits.curve_points);
        Diagnostic::new(Code::LimitReached, message)
    })?;
    let points = closed(rows).map_err(|(first, second)| {
        bad(format!("rows {first} and {second} hold the same point"))
            .hint("neighbours must differ; only the last point may repeat the first, to close the curve")
    })?;
    if points.len() < LEAST_POINTS {
        return Err(bad(format!("a closed curve needs {LEAST_POINTS} points or more, found {}", points.len())));
    }
    ClosedCurve::through(name, &points).ok_or_else(|| {
        bad("the distances of its points differ too much for a curve through them".to_owned())
            .hint("points that nearly coincide carry no shape: leave one of each pair out")
    })
}

/// The points, without the first at the end once more; the rows of neighbours that are equal otherwise.
fn closed(mut rows: Vec<(usize, [f64; 3])>) -> Result<Vec<[f64; 3]>, (usize, usize)> {
    if let (Some((_, first)), Some((_, last)), true) = (rows.first(), rows.last(), rows.len() > 1)
        && first == last
    {
        rows.pop();
    }
    for pair in rows.windows(2) {
        if let [(row, point), (next, other)] = pair
            && point == other
        {
            return Err((*row, *next));
        }
    }
    Ok(rows.into_iter().map(|(_, point)| point).collect())
}
