//! A mesh of what the page shows, as a file to keep.

use axum::http::header;
use axum::response::IntoResponse;

use trimline::export::{Format, write};
use trimline::tessellate::{Grid, Scene, tessellate};

use super::live::{Answerable, Live};
use super::server::Question;
use crate::failure::Failure;
use crate::options::{option_finding, read_grid};
use crate::parts::Located;

/// `format=obj&grid=64x128` at the page's instant and values, in full precision.
pub fn of(live: &Live, question: &Question) -> Result<impl IntoResponse + use<>, Failure> {
    let extension = question.option("format").unwrap_or("obj");
    let format =
        Format::from_extension(extension).ok_or_else(|| Failure::Usage(format!("there is no format `{extension}`")))?;
    let grid = read_grid(question.option("grid").unwrap_or("64x128"))?;
    live.answer_with(&question.changes, question.time, |answerable| {
        let scene = scene(answerable, grid)?;
        let mut bytes = Vec::new();
        write(&scene, format, &mut bytes)
            .map_err(|error| Failure::Found { source: None, findings: vec![error.to_diagnostic()] })?;
        let name = scene.meshes.first().map_or("surface", |mesh| mesh.name.as_str());
        let name: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        let disposition = format!("attachment; filename=\"{name}.{}\"", format.extension());
        let kind = "application/octet-stream".to_owned();
        Ok(([(header::CONTENT_TYPE, kind), (header::CONTENT_DISPOSITION, disposition)], bytes))
    })
}

fn scene(answerable: &Answerable<'_>, (u_cells, v_cells): (usize, usize)) -> Result<Scene, Failure> {
    let spec = answerable.spec;
    let grid = Grid::new(u_cells, v_cells, &spec.limits)
        .map_err(|finding| option_finding("grid", &format!("{u_cells}x{v_cells}"), finding))?;
    let mut meshes = Vec::new();
    for piece in &answerable.pieces {
        let ranges = (piece.domain().u, piece.domain().v);
        let mesh = tessellate(piece.name(), &*piece.surface, ranges, answerable.time, grid);
        let (mesh, _) = mesh.map_err(|finding| spec.fault(finding))?;
        meshes.push(if piece.is_reflection { mesh.turned() } else { mesh });
    }
    Ok(Scene { meshes, time: answerable.time })
}
