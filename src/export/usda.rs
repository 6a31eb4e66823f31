//! Universal Scene Description as text: a mesh prim per patch, frames as time samples.
//!
//! Time codes count the frames from 0, which is how programs step through them, and `timeCodesPerSecond` makes a
//! second of them a unit of t. The instants themselves are samples of the attribute `trimline:t`, in double precision.

use std::fmt::Display;
use std::io::{self, Write};

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Role, Scene};

use super::name::{distinct_words, on_one_line};
use super::single::in_single_precision;
use super::{Content, ExportError, Row};
use crate::diagnostic::{Shortest, Single};

pub(super) const ROW: Row = Row {
    name: "USDA",
    extension: "usda",
    description: "text for film and Omniverse; quads, normals, (u, v), fields in single precision; an animation",
    content: Content::Animation(write),
    holds_fields: true,
    is_single: true,
};

fn write(frames: &[Scene], out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    let Some(first) = frames.first() else { return Ok(Vec::new()) };
    frames.iter().flat_map(|frame| &frame.meshes).try_for_each(|mesh| in_single_precision(ROW.name, mesh).map(drop))?;
    writeln!(out, "#usda 1.0\n(\n    defaultPrim = \"trimline\"\n    upAxis = \"Z\"\n    metersPerUnit = 1")?;
    writeln!(out, "    doc = \"trimline {}\"", env!("CARGO_PKG_VERSION"))?;
    if frames.len() > 1 {
        let rate = codes_per_second(frames)?;
        writeln!(out, "    startTimeCode = 0\n    endTimeCode = {}", frames.len() - 1)?;
        writeln!(out, "    timeCodesPerSecond = {}\n    framesPerSecond = {}", Shortest(rate), Shortest(rate))?;
    }
    writeln!(out, ")\n\ndef Xform \"trimline\" (\n    kind = \"component\"\n)\n{{")?;
    let times = frames.iter().map(|frame| Shortest(frame.time).to_string());
    attribute(out, "    custom double trimline:t", None, times)?;
    let names = distinct_words(first.meshes.iter().map(|mesh| mesh.name.as_str()));
    for (index, (mesh, name)) in first.meshes.iter().zip(names).enumerate() {
        let moved: Vec<&Mesh> = frames.iter().filter_map(|frame| frame.meshes.get(index)).collect();
        write_mesh(mesh, &name, &moved, out)?;
    }
    writeln!(out, "}}")?;
    Ok(Vec::new())
}

/// How many frames one unit of t has.
fn codes_per_second(frames: &[Scene]) -> Result<f64, ExportError> {
    let unfit = |before: &Scene, after: &Scene| ExportError::UnfitInstants {
        format: ROW.name,
        time: before.time,
        next: after.time,
    };
    if let Some([before, after]) = frames.array_windows().find(|[before, after]| before.time >= after.time) {
        return Err(unfit(before, after));
    }
    let Some((first, last)) = frames.first().zip(frames.last()) else { return Ok(1.0) };
    let rate = (frames.len() - 1) as f64 / (last.time - first.time);
    // A time domain may be as short or as long as doubles go.
    if rate.is_finite() && rate > 0.0 { Ok(rate) } else { Err(unfit(first, last)) }
}

fn write_mesh(mesh: &Mesh, name: &str, frames: &[&Mesh], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n    def Mesh \"{name}\" (\n        displayName = {}\n    )\n    {{", quoted(&mesh.name))?;
    writeln!(out, "        uniform token subdivisionScheme = \"none\"\n        uniform bool doubleSided = 1")?;
    let color = match mesh.role {
        Role::Blend => "(0.32, 0.52, 0.78)",
        Role::Primary => "(0.72, 0.7, 0.66)",
    };
    writeln!(out, "        color3f[] primvars:displayColor = [{color}]")?;
    writeln!(out, "        int[] faceVertexCounts = [{}]", list(mesh.quads.iter().map(|_| 4)))?;
    writeln!(out, "        int[] faceVertexIndices = [{}]", list(mesh.quads.iter().flatten()))?;
    let sampled = |part: fn(&Mesh) -> String| frames.iter().map(move |mesh| part(mesh));
    attribute(out, "        float3[] extent", None, sampled(extent))?;
    attribute(out, "        point3f[] points", None, sampled(|mesh| vectors(&mesh.positions)))?;
    attribute(out, "        normal3f[] normals", Some("vertex"), sampled(|mesh| vectors(&mesh.normals)))?;
    let uv = mesh.uv.iter().map(|[u, v]| format!("({}, {})", Single(*u as f32), Single(*v as f32)));
    let uv = std::iter::once(format!("[{}]", list(uv)));
    attribute(out, "        texCoord2f[] primvars:st", Some("vertex"), uv)?;
    for (index, field) in mesh.fields.iter().enumerate() {
        let values = frames
            .iter()
            .filter_map(|mesh| mesh.fields.get(index))
            .map(|field| format!("[{}]", list(field.values.iter().map(|value| scalar(*value)))));
        attribute(out, &format!("        float[] primvars:{}", field.name), Some("vertex"), values)?;
    }
    writeln!(out, "    }}")
}

/// One value as a plain one, several as time samples.
fn attribute(
    out: &mut dyn Write,
    declaration: &str,
    interpolation: Option<&str>,
    values: impl Iterator<Item = String>,
) -> io::Result<()> {
    let values: Vec<String> = values.collect();
    let metadata =
        interpolation.map(|kind| format!(" (\n            interpolation = \"{kind}\"\n        )")).unwrap_or_default();
    if let [only] = values.as_slice() {
        return writeln!(out, "{declaration} = {only}{metadata}");
    }
    if !metadata.is_empty() {
        writeln!(out, "{declaration}{metadata}")?;
    }
    writeln!(out, "{declaration}.timeSamples = {{")?;
    for (frame, value) in values.iter().enumerate() {
        writeln!(out, "            {frame}: {value},")?;
    }
    writeln!(out, "        }}")
}

fn vectors(values: &[[f64; 3]]) -> String {
    format!("[{}]", list(values.iter().map(vector)))
}

fn vector(value: &[f64; 3]) -> String {
    let [x, y, z] = value.map(|x| Single(x as f32));
    format!("({x}, {y}, {z})")
}

/// A field may have no value; USD writes that as Python does.
fn scalar(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { Single(value as f32).to_string() }
}

fn extent(mesh: &Mesh) -> String {
    let corner = |from: f64, pick: fn(f64, f64) -> f64| {
        let fold = |[x, y, z]: [f64; 3], [px, py, pz]: &[f64; 3]| [pick(x, *px), pick(y, *py), pick(z, *pz)];
        mesh.positions.iter().fold([from; 3], fold)
    };
    let corners = [corner(f64::INFINITY, f64::min), corner(f64::NEG_INFINITY, f64::max)];
    format!("[{}]", list(corners.iter().map(vector)))
}

fn list(items: impl Iterator<Item = impl Display>) -> String {
    let items: Vec<String> = items.map(|item| item.to_string()).collect();
    items.join(", ")
}

/// A name as a string of USDA; line ends and what disguises itself are gone already.
fn quoted(name: &str) -> String {
    format!("\"{}\"", on_one_line(name).replace('"', "'"))
}
