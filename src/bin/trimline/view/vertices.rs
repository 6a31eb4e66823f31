//! Vertices of patches that the page cannot evaluate itself: positions, normals and curvatures, as numbers in a row.

use axum::http::header;
use axum::response::IntoResponse;

use trimline::tessellate::{Grid, Mesh, curvatures, tessellate};

use super::live::{Answerable, Live};
use super::server::Question;
use crate::failure::Failure;
use crate::options::{option_finding, read_grid};
use crate::parts::Located;

/// What tells the page which reading of the spec the numbers belong to.
const REVISION: &str = "trimline-revision";

/// `patches=0,2&grid=128x256` at the page's instant and values.
///
/// Every number is a little-endian 32-bit float. For each of the patches asked for, in that order: (x, y, z, Gaussian
/// curvature) of every vertex, u-major, both ends included, then (normal, mean curvature) of every vertex.
pub fn of(live: &Live, question: &Question) -> Result<impl IntoResponse + use<>, Failure> {
    let text = question.option("grid").unwrap_or("64x128");
    let (u_cells, v_cells) = read_grid(text)?;
    let indices = question.option("patches").unwrap_or("0").split(',');
    let indices: Result<Vec<usize>, _> = indices.map(str::parse).collect();
    let indices = indices.map_err(|_| Failure::Usage("patches are numbers, for example patches=0,2".to_owned()))?;
    live.answer_with(&question.changes, question.time, |answerable| {
        let grid = Grid::new(u_cells, v_cells, &answerable.spec.limits)
            .map_err(|finding| option_finding("grid", text, finding))?
            .with_open_seams();
        let mut bytes = Vec::new();
        for &index in &indices {
            add(answerable, index, grid, &mut bytes)?;
        }
        let kind = "application/octet-stream".to_owned();
        Ok(([(header::CONTENT_TYPE.as_str(), kind), (REVISION, answerable.revision.to_string())], bytes))
    })
}

fn add(answerable: &Answerable<'_>, index: usize, grid: Grid, bytes: &mut Vec<u8>) -> Result<(), Failure> {
    let spec = answerable.spec;
    let Some(piece) = answerable.pieces.get(index) else {
        return Err(Failure::Usage(format!("there is no patch number {index}")));
    };
    // Of a copy the page is given what was solved, and puts it where the copy is.
    let (surface, domain) = (piece.of.surface(), piece.domain());
    let (mesh, _) = tessellate(piece.name(), &*surface, (domain.u, domain.v), answerable.time, grid)
        .map_err(|finding| spec.fault(finding))?;
    // A surface without second derivatives can be seen all the same.
    let [gaussian, mean] = curvatures(&*surface, &mesh, answerable.time)
        .map(|fields| fields.map(|field| field.values))
        .unwrap_or_else(|_| [vec![0.0; mesh.positions.len()], vec![0.0; mesh.positions.len()]]);
    let Mesh { positions, normals, .. } = &mesh;
    for (vectors, scalars) in [(positions, &gaussian), (normals, &mean)] {
        for (vector, scalar) in vectors.iter().zip(scalars) {
            // Shaders need not know NaN: where there is no curvature the surface is drawn as flat.
            let scalar = if scalar.is_nan() { 0.0 } else { *scalar };
            for number in vector.iter().chain([&scalar]) {
                bytes.extend((*number as f32).to_le_bytes());
            }
        }
    }
    Ok(())
}
