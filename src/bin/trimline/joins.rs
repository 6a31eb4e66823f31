//! How patches meet the surfaces that they join, as it is reported.

use serde::Serialize;

use trimline::verify::JoinDeviation;

use crate::failure::Failure;
use crate::workflow::{Patched, Spec};

/// How the patch meets a surface that it joins.
#[derive(Serialize)]
pub struct JoinReport {
    pub surface: String,
    pub u: f64,
    pub gap: f64,
    pub tangent: Option<f64>,
    pub angle_degrees: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub curvature: Option<f64>,
    /// Points where the patch or the surface has no tangent plane.
    pub without_normal: usize,
}

/// What was measured at the joins of a patch, in their order.
pub fn reports(spec: &Spec, patched: &Patched, met: Vec<JoinDeviation>) -> Result<Vec<JoinReport>, Failure> {
    let mut reports = Vec::with_capacity(met.len());
    for (join, met) in patched.prepared.patch().joins.iter().zip(met) {
        let u = spec.bindings.constant(&spec.problem, join.u, None, "the position of a boundary");
        let surface = spec.problem.surfaces.get(join.surface);
        reports.push(JoinReport {
            surface: surface.map_or_else(String::new, |surface| surface.name.clone()),
            u: u.map_err(|finding| spec.fault(finding))?,
            gap: met.gap,
            tangent: met.tangent,
            angle_degrees: met.angle_degrees,
            curvature: met.curvature,
            without_normal: met.without_normal,
        });
    }
    Ok(reports)
}
