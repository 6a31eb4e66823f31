//! glTF 2.0 in its binary container: a mesh per patch; frames are morph targets.
//!
//! The first frame is the base mesh, every other frame a target that holds the differences of positions and normals,
//! and the animation blends from one to the next: at the k-th instant the weight of frame k is 1, all others 0.
//! Coordinates are those of the document, with no turn to glTF's upward y.

use std::io::Write;

use serde_json::{Value, json};

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Role, Scene};

use super::error::count_of;
use super::name::on_one_line;
use super::single::in_single_precision;
use super::triangles::triangles;
use super::{Content, ExportError, Row};
use crate::diagnostic::Shortest;

pub(super) const ROW: Row = Row {
    name: "GLB",
    extension: "glb",
    description: "binary glTF for the web and Blender; triangles, normals and (u, v) in single precision; an animation",
    content: Content::Animation(write),
    holds_fields: false,
    is_single: true,
};

// The numbers that the specification gives to what it names.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const JSON_CHUNK: u32 = 0x4E4F_534A;
const BINARY_CHUNK: u32 = 0x004E_4942;

/// A material each for patches and for the surfaces they join.
const COLORS: [(Role, [f32; 4]); 2] = [(Role::Blend, [0.32, 0.52, 0.78, 1.0]), (Role::Primary, [0.72, 0.7, 0.66, 1.0])];

fn write(frames: &[Scene], out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    let times = input_times(frames)?;
    let Some(first) = frames.first() else { return Ok(Vec::new()) };
    let mut buffer = Buffer::default();
    let mut meshes = Vec::new();
    for (index, mesh) in first.meshes.iter().enumerate() {
        let later: Vec<&Mesh> = frames.iter().skip(1).filter_map(|frame| frame.meshes.get(index)).collect();
        meshes.push(mesh_json(mesh, &later, frames, &mut buffer)?);
    }
    let animations =
        if frames.len() > 1 { json!([animation(&times, frames, meshes.len(), &mut buffer)]) } else { json!([]) };
    let nodes: Vec<Value> = (0..meshes.len())
        .zip(&first.meshes)
        .map(|(index, mesh)| json!({ "mesh": index, "name": on_one_line(&mesh.name) }))
        .collect();
    let mut document = json!({
        "asset": { "version": "2.0", "generator": concat!("trimline ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }],
        "nodes": nodes,
        "meshes": meshes,
        "materials": materials(&first.meshes),
        "animations": animations,
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{ "byteLength": buffer.bytes.len() }],
    });
    // The schema wants a list to have an entry, or not to be there.
    if let Some(members) = document.as_object_mut() {
        members.retain(|_, value| value.as_array().is_none_or(|list| !list.is_empty()));
    }
    write_container(document.to_string().into_bytes(), buffer.bytes, out)?;
    Ok(Vec::new())
}

/// The instants in seconds: those of the document, moved to begin at 0 if they begin before.
fn input_times(frames: &[Scene]) -> Result<Vec<f32>, ExportError> {
    let start = frames.first().map_or(0.0, |frame| frame.time).min(0.0);
    let times: Vec<f32> = frames.iter().map(|frame| (frame.time - start) as f32).collect();
    for (pair, exact) in times.windows(2).zip(frames.windows(2)) {
        if let ([time, next], [before, after]) = (pair, exact)
            && !(time < next && next.is_finite())
        {
            return Err(ExportError::UnfitInstants { format: ROW.name, time: before.time, next: after.time });
        }
    }
    Ok(times)
}

fn materials(meshes: &[Mesh]) -> Vec<Value> {
    let material = |(role, color): &(Role, [f32; 4])| {
        let name = match role {
            Role::Blend => "patch",
            Role::Primary => "primary surface",
        };
        // Patches are open: their inside can be seen.
        json!({ "name": name, "doubleSided": true,
                "pbrMetallicRoughness": { "baseColorFactor": color, "metallicFactor": 0.0, "roughnessFactor": 0.5 } })
    };
    // A material that nothing uses is a finding of validators; patches come first.
    let is_used = |role: Role| role == Role::Blend || meshes.iter().any(|mesh| mesh.role == role);
    COLORS.iter().filter(|(role, _)| is_used(*role)).map(material).collect()
}

fn mesh_json(mesh: &Mesh, later: &[&Mesh], frames: &[Scene], buffer: &mut Buffer) -> Result<Value, ExportError> {
    count_of(ROW.name, "vertices", mesh.positions.len())?;
    let base = in_single_precision(ROW.name, mesh)?;
    let normals: Vec<[f32; 3]> = mesh.normals.iter().map(|normal| normal.map(|x| x as f32)).collect();
    let uv: Vec<[f32; 2]> = mesh.uv.iter().map(|uv| uv.map(|x| x as f32)).collect();
    let indices = triangles(mesh);
    let mut targets = Vec::with_capacity(later.len());
    let attributes = json!({
        "POSITION": buffer.vectors(&base, true),
        "NORMAL": buffer.vectors(&normals, false),
        "TEXCOORD_0": buffer.vectors(&uv, false),
    });
    let indices = buffer.add(
        indices.iter().flatten().flat_map(|index| index.to_le_bytes()),
        json!({ "componentType": UNSIGNED_INT, "count": 3 * indices.len(), "type": "SCALAR" }),
        Some(ELEMENT_ARRAY_BUFFER),
    );
    for frame in later {
        in_single_precision(ROW.name, frame)?;
        targets.push(json!({
            "POSITION": buffer.vectors(&differences(&frame.positions, &base), true),
            "NORMAL": buffer.vectors(&differences(&frame.normals, &normals), false),
        }));
    }
    let material = usize::from(mesh.role == Role::Primary);
    let mut primitive = json!({ "attributes": attributes, "indices": indices, "material": material });
    let mut value = json!({ "name": on_one_line(&mesh.name) });
    if !targets.is_empty() {
        let names: Vec<String> = frames.iter().skip(1).map(|frame| format!("t = {}", Shortest(frame.time))).collect();
        insert(&mut primitive, "targets", json!(targets));
        insert(&mut value, "weights", json!(vec![0.0; later.len()]));
        insert(&mut value, "extras", json!({ "targetNames": names }));
    }
    insert(&mut value, "primitives", json!([primitive]));
    Ok(value)
}

fn insert(object: &mut Value, member: &str, value: Value) {
    if let Some(members) = object.as_object_mut() {
        members.insert(member.to_owned(), value);
    }
}

/// What is to be added to the rounded `base` to come nearest to `exact`.
fn differences(exact: &[[f64; 3]], base: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let difference = |([x, y, z], [bx, by, bz]): (&[f64; 3], &[f32; 3])| {
        [x - f64::from(*bx), y - f64::from(*by), z - f64::from(*bz)].map(|x| x as f32)
    };
    exact.iter().zip(base).map(difference).collect()
}

fn animation(times: &[f32], frames: &[Scene], meshes: usize, buffer: &mut Buffer) -> Value {
    let ends = [times.first(), times.last()].map(|end| json!([end]));
    let [min, max] = ends;
    let input = buffer.add(
        times.iter().flat_map(|time| time.to_le_bytes()),
        json!({ "componentType": FLOAT, "count": times.len(), "type": "SCALAR", "min": min, "max": max }),
        None,
    );
    let targets = times.len() - 1;
    let weights =
        (0..times.len()).flat_map(|frame| (1..=targets).map(move |target| f32::from(u8::from(frame == target))));
    let output = buffer.add(
        weights.flat_map(f32::to_le_bytes),
        json!({ "componentType": FLOAT, "count": times.len() * targets, "type": "SCALAR" }),
        None,
    );
    let channels: Vec<Value> =
        (0..meshes).map(|node| json!({ "sampler": 0, "target": { "node": node, "path": "weights" } })).collect();
    json!({
        "name": "t",
        "samplers": [{ "input": input, "output": output, "interpolation": "LINEAR" }],
        "channels": channels,
        // In double precision, and not moved to begin at 0.
        "extras": { "t": frames.iter().map(|frame| frame.time).collect::<Vec<_>>() },
    })
}

/// The one binary buffer with its views and accessors; everything in it is a multiple of 4 bytes long.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Appends a vertex attribute and gives the number of its accessor; `bounded` ones state their range.
    fn vectors<const N: usize>(&mut self, values: &[[f32; N]], bounded: bool) -> usize {
        let mut accessor = json!({ "componentType": FLOAT, "count": values.len(), "type": format!("VEC{N}") });
        if bounded {
            let fold = |from: f32, pick: fn(f32, f32) -> f32| {
                values.iter().fold([from; N], |bound, value| std::array::from_fn(|axis| at(&bound, axis, value, pick)))
            };
            insert(&mut accessor, "min", json!(fold(f32::INFINITY, f32::min).to_vec()));
            insert(&mut accessor, "max", json!(fold(f32::NEG_INFINITY, f32::max).to_vec()));
        }
        self.add(values.iter().flatten().flat_map(|x| x.to_le_bytes()), accessor, Some(ARRAY_BUFFER))
    }

    fn add(&mut self, bytes: impl Iterator<Item = u8>, mut accessor: Value, target: Option<u32>) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let mut view = json!({ "buffer": 0, "byteOffset": start, "byteLength": self.bytes.len() - start });
        if let Some(target) = target {
            insert(&mut view, "target", json!(target));
        }
        insert(&mut accessor, "bufferView", json!(self.views.len()));
        self.views.push(view);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

fn at<const N: usize>(bound: &[f32; N], axis: usize, value: &[f32; N], pick: fn(f32, f32) -> f32) -> f32 {
    match (bound.get(axis), value.get(axis)) {
        (Some(bound), Some(value)) => pick(*bound, *value),
        _ => 0.0,
    }
}

fn write_container(mut json: Vec<u8>, mut binary: Vec<u8>, out: &mut dyn Write) -> Result<(), ExportError> {
    json.resize(json.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = |bytes: usize| count_of(ROW.name, "bytes", bytes);
    let total = length(12 + 8 + json.len() + 8 + binary.len())?;
    out.write_all(b"glTF")?;
    for number in [2, total, length(json.len())?, JSON_CHUNK] {
        out.write_all(&number.to_le_bytes())?;
    }
    out.write_all(&json)?;
    for number in [length(binary.len())?, BINARY_CHUNK] {
        out.write_all(&number.to_le_bytes())?;
    }
    out.write_all(&binary)?;
    Ok(())
}
