//! One patch at one instant becomes one mesh.

use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;
use crate::surface::Surface;

use super::grid::Grid;
use super::instants::evenly_spaced;
use super::mesh::{Mesh, Role};
use super::normals::normals;
use super::samples::Samples;

/// Below this a ring is no ring: two quads around would share both their sides, one quad its own.
const SMALLEST_RING: usize = 3;

/// Pieces of each side of an outline.
const OUTLINE: usize = 32;

/// Cuts `surface` at instant `t` into quads over the parameter ranges `(u_range, v_range)`.
///
/// Normals are those of the surface, from its exact derivatives, not of the quads. Where `S_u x S_v` vanishes, as
/// at a pole, a vertex gets the mean of the adjacent quads' normals, weighted by area. If S, S_u and S_v on the
/// last column equal those on the first up to rounding, and there are at least three columns, the two are welded,
/// unless the grid leaves seams open.
///
/// Returns the mesh and at most one warning, [`Code::DegenerateNormals`], when vertices are left whose normal
/// nothing determines; they get (0, 0, 1).
///
/// # Errors
/// What the surface reports, among it a derivative that does not exist; [`Code::EmptyDomain`] when a range is
/// not finite and ascending; [`Code::SettingOutOfRange`] when `t` is not finite; [`Code::SolutionNotFinite`]
/// when the surface yields a value that is not finite without reporting it.
pub fn tessellate(
    name: &str,
    surface: &dyn Surface,
    (u_range, v_range): ([f64; 2], [f64; 2]),
    t: f64,
    grid: Grid,
) -> Result<(Mesh, Vec<Diagnostic>), Diagnostic> {
    for ([start, end], parameter) in [(u_range, "u"), (v_range, "v")] {
        // A descending range would turn the quads against the normals.
        if !(start < end && start.is_finite() && end.is_finite()) {
            return Err(Diagnostic::new(
                Code::EmptyDomain,
                format!("`{name}` has no extent: {parameter} from {start} to {end}"),
            ));
        }
    }
    if !t.is_finite() {
        return Err(Diagnostic::new(Code::SettingOutOfRange, format!("`{name}` has no shape at t = {t}")));
    }
    let u = evenly_spaced(u_range, grid.u_cells());
    let mut v = evenly_spaced(v_range, grid.v_cells());
    let mut samples = Samples::evaluate(name, surface, (&u, &v, t))?;
    let is_closed_in_v = grid.welds() && grid.v_cells() >= SMALLEST_RING && samples.closes_in_v();
    if is_closed_in_v {
        samples = samples.without_last_column();
        v.pop();
    }
    let quads = grid.quads(is_closed_in_v);
    let (normals, arbitrary) = match samples.normals.take() {
        Some(normals) => (normals, 0),
        None => normals(&samples, &quads),
    };
    let warnings = if arbitrary == 0 { Vec::new() } else { vec![degenerate(name, arbitrary, normals.len())] };
    let outlines = surface.regions().into_iter().map(|region| outline(surface, region, t));
    let mesh = Mesh {
        outlines: outlines.collect::<Result<_, _>>()?,
        name: name.to_owned(),
        role: Role::Blend,
        positions: samples.position,
        normals,
        tangents_u: samples.tangent_u,
        tangents_v: samples.tangent_v,
        uv: u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v])).collect(),
        fields: Vec::new(),
        columns: v.len(),
        quads,
        is_closed_in_v,
    };
    Ok((mesh, warnings))
}

/// Points along the border of a region, back to where they begin.
fn outline(surface: &dyn Surface, [u, v]: [[f64; 2]; 2], t: f64) -> Result<Vec<[f64; 3]>, Diagnostic> {
    let (along_u, along_v) = (evenly_spaced(u, OUTLINE), evenly_spaced(v, OUTLINE));
    let [[u_low, u_high], [v_low, v_high]] = [u, v];
    let there = along_u.iter().map(|u| [*u, v_low, t]).chain(along_v.iter().map(|v| [u_high, *v, t]));
    let back = along_u.iter().rev().map(|u| [*u, v_high, t]).chain(along_v.iter().rev().map(|v| [u_low, *v, t]));
    let points: Vec<[f64; 3]> = there.chain(back).collect();
    let mut line = vec![[0.0; 3]; points.len()];
    surface.evaluate(Derivative::NONE, &points, &mut line)?;
    Ok(line)
}

fn degenerate(name: &str, arbitrary: usize, vertices: usize) -> Diagnostic {
    Diagnostic::new(
        Code::DegenerateNormals,
        format!("`{name}` has no normal at {arbitrary} of {vertices} vertices; they are given (0, 0, 1)"),
    )
    .hint("the surface shrinks to a curve or a point there, or folds back on itself")
}
