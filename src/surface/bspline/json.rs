//! B-spline surfaces as JSON: degrees, knots and nets, at full precision, to write and to read back.
//!
//! `{"patches":[{"name","degree":[p,q],"knots_u":[…],"knots_v":[…],"control_net":[[[x,y,z],…],…]}]}`, rows of equal i.
//! Other keys are ignored.

use serde::{Deserialize, Serialize};

use super::{BsplineSurface, KnotVector};
use crate::diagnostic::{Code, Diagnostic};
use crate::limits::Limits;

#[derive(Serialize, Deserialize)]
#[serde(expecting = "an object with `patches`")]
struct File {
    patches: Vec<Patch>,
}

#[derive(Serialize, Deserialize)]
#[serde(expecting = "an object with name, degrees, knots and a net")]
struct Patch {
    name: String,
    degree: [usize; 2],
    knots_u: Vec<f64>,
    knots_v: Vec<f64>,
    control_net: Vec<Vec<[f64; 3]>>,
}

/// Named surfaces as JSON. Every number reads back to the same double.
///
/// # Errors
/// [`Code::OutputFailed`] if a number cannot be written, which finite ones can.
pub fn to_json(surfaces: &[(&str, &BsplineSurface)]) -> Result<String, Diagnostic> {
    let patches = surfaces.iter().map(|(name, surface)| Patch {
        name: (*name).to_owned(),
        degree: surface.knots().map(KnotVector::degree),
        knots_u: surface.u.as_slice().to_vec(),
        knots_v: surface.v.as_slice().to_vec(),
        control_net: surface.rows().map(<[[f64; 3]]>::to_vec).collect(),
    });
    serde_json::to_string(&File { patches: patches.collect() })
        .map_err(|error| Diagnostic::new(Code::OutputFailed, format!("a B-spline is not JSON: {error}")))
}

/// Reads what [`to_json`] writes.
///
/// # Errors
/// [`Code::BadSplineFile`] for text that is not such JSON, with line and column; [`Code::LimitReached`] for more control
/// points than `limits` allow; the errors of [`KnotVector::new`] and [`BsplineSurface::new`] with the patch's name.
pub fn from_json(text: &str, limits: &Limits) -> Result<Vec<(String, BsplineSurface)>, Diagnostic> {
    let file: File = serde_json::from_str(text).map_err(|error| {
        let message = ["usize", "f64"].into_iter().zip(["a whole number", "a number"]);
        let message = message.fold(error.to_string(), |text, (name, words)| text.replace(name, words));
        Diagnostic::new(Code::BadSplineFile, format!("this is no file of B-splines: {message}"))
            .hint("`trimline fit` writes such files; docs/bspline.md describes them")
    })?;
    let points: usize = file.patches.iter().flat_map(|patch| &patch.control_net).map(Vec::len).sum();
    if points > limits.control_points {
        let message =
            format!("{points} control points are above the limit `control-points` of {}", limits.control_points);
        return Err(Diagnostic::new(Code::LimitReached, message));
    }
    file.patches.into_iter().map(surface).collect()
}

fn surface(patch: Patch) -> Result<(String, BsplineSurface), Diagnostic> {
    let name = patch.name;
    let named = |finding: Diagnostic| {
        let hints = finding.hints.clone();
        let renamed = Diagnostic::new(finding.code, format!("patch `{name}`: {}", finding.message));
        hints.into_iter().fold(renamed, Diagnostic::hint)
    };
    let [degree_u, degree_v] = patch.degree;
    let u = KnotVector::new(degree_u, patch.knots_u).map_err(named)?;
    let v = KnotVector::new(degree_v, patch.knots_v).map_err(named)?;
    if let Some(index) = patch.control_net.iter().position(|row| row.len() != v.points()) {
        let length = patch.control_net.get(index).map_or(0, Vec::len);
        let message =
            format!("row {index} of the net has {length} points, and the knots of v belong to {}", v.points());
        return Err(named(Diagnostic::new(Code::NetSize, message).hint("all rows have the same length")));
    }
    let surface = BsplineSurface::new(u, v, patch.control_net.into_iter().flatten().collect()).map_err(named)?;
    Ok((name, surface))
}
