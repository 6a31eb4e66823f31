//! NumPy's NPZ: every array in double precision, shaped as the surface is, time first.
//!
//! `positions`, `derivative_u` and `derivative_v` are frames x rows x columns x 3, fields frames x rows x columns,
//! `u` the parameter of the rows, `v` that of the columns, `t` that of the frames. With several patches the name of the
//! patch and a dot stand before each but `t`. A seam is welded as in every format: the last column is left out.

use std::io::Write;

use npyz::WriterBuilder;

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

use super::name::distinct_words;
use super::zipped::Archive;
use super::{Content, ExportError, Row};

pub(super) const ROW: Row = Row {
    name: "NPZ",
    extension: "npz",
    description: "NumPy arrays of doubles: positions, S_u, S_v, fields, u, v and t; all frames in one file",
    content: Content::Animation(write),
    holds_fields: true,
    is_single: false,
};

fn write(frames: &[Scene], out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    let mut archive = Archive::new();
    let times: Vec<f64> = frames.iter().map(|frame| frame.time).collect();
    add(&mut archive, "t", &[times.len()], times.iter())?;
    let Some(first) = frames.first() else { return Ok(Vec::new()) };
    let names = distinct_words(first.meshes.iter().map(|mesh| mesh.name.as_str()));
    for (index, (mesh, name)) in first.meshes.iter().zip(names).enumerate() {
        let prefix = if first.meshes.len() == 1 { String::new() } else { name + "." };
        let moved: Vec<&Mesh> = frames.iter().filter_map(|frame| frame.meshes.get(index)).collect();
        add_mesh(&mut archive, &prefix, mesh, &moved)?;
    }
    archive.finish(out)?;
    Ok(Vec::new())
}

fn add_mesh(archive: &mut Archive, prefix: &str, mesh: &Mesh, frames: &[&Mesh]) -> Result<(), ExportError> {
    let (u, v) = mesh.axes();
    let shape = [frames.len(), u.len(), v.len()];
    let of_vectors = [frames.len(), u.len(), v.len(), 3];
    add(archive, &format!("{prefix}u"), &[u.len()], u.iter())?;
    add(archive, &format!("{prefix}v"), &[v.len()], v.iter())?;
    let add_vectors = |archive: &mut Archive, name: &str, part: fn(&Mesh) -> &Vec<[f64; 3]>| {
        let values = frames.iter().flat_map(|mesh| part(mesh)).flatten();
        add(archive, &format!("{prefix}{name}"), &of_vectors, values)
    };
    add_vectors(archive, "positions", |mesh| &mesh.positions)?;
    add_vectors(archive, "derivative_u", |mesh| &mesh.tangents_u)?;
    add_vectors(archive, "derivative_v", |mesh| &mesh.tangents_v)?;
    for (index, field) in mesh.fields.iter().enumerate() {
        let values = frames.iter().filter_map(|mesh| mesh.fields.get(index)).flat_map(|field| &field.values);
        add(archive, &format!("{prefix}{}", field.name), &shape, values)?;
    }
    Ok(())
}

fn add<'a>(
    archive: &mut Archive,
    name: &str,
    shape: &[usize],
    values: impl Iterator<Item = &'a f64>,
) -> Result<(), ExportError> {
    let shape: Vec<u64> = shape.iter().map(|length| *length as u64).collect();
    archive.add(&format!("{name}.npy"), |out| {
        let mut array = npyz::WriteOptions::new().default_dtype().shape(&shape).writer(out).begin_nd()?;
        array.extend(values.copied())?;
        array.finish()
    })
}
