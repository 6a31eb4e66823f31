//! What the written files promise, read back by readers of their own.
#![allow(clippy::indexing_slicing, clippy::unwrap_used)]

use std::io::{self, Cursor, Write};

use trimline::diagnostic::Code;
use trimline::export::{ExportError, Format, write};
use trimline::tessellate::{Mesh, Scene};

use crate::analytic::*;

fn bytes(scene: &Scene, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    assert_eq!(write(scene, format, &mut bytes).unwrap(), []);
    bytes
}

/// Two patches of different size and shape, with awkward instants and names.
fn two_patches() -> Scene {
    let mut torus = TORUS_PATCH.mesh((3, 7));
    torus.name = "left\nwing α".to_owned();
    Scene { meshes: vec![PLANE.mesh((2, 3)), torus], time: 0.1 + 0.2 }
}

/// What a file holds: positions, normals, parameters, quads.
#[derive(Default)]
struct ReadBack {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    uv: Vec<[f64; 2]>,
    quads: Vec<[usize; 4]>,
    objects: Vec<String>,
}

fn read_obj(bytes: Vec<u8>) -> ReadBack {
    let mut file = ReadBack::default();
    for line in String::from_utf8(bytes).unwrap().lines() {
        let (keyword, rest) = line.split_once(' ').unwrap();
        let numbers = || rest.split(' ').map(|word| word.parse().unwrap()).collect::<Vec<f64>>();
        match keyword {
            "#" => {}
            "o" => file.objects.push(rest.to_owned()),
            "v" => file.positions.push(numbers().try_into().unwrap()),
            "vn" => file.normals.push(numbers().try_into().unwrap()),
            "vt" => file.uv.push(numbers().try_into().unwrap()),
            "f" => {
                let corners: Vec<usize> = rest.split(' ').map(corner).collect();
                file.quads.push(corners.try_into().unwrap());
            }
            other => panic!("an OBJ line starts with `{other}`"),
        }
    }
    file
}

/// The zero-based index of `a/a/a`.
fn corner(word: &str) -> usize {
    let indices: Vec<usize> = word.split('/').map(|index| index.parse().unwrap()).collect();
    assert_eq!(indices, [indices[0]; 3]);
    indices[0] - 1
}

fn read_ply(bytes: &[u8]) -> (String, ReadBack) {
    let marker = b"end_header\n";
    let end = bytes.windows(marker.len()).position(|window| window == marker).unwrap() + marker.len();
    let header = String::from_utf8(bytes[..end].to_vec()).unwrap();
    let count = |element: &str| -> usize {
        header.lines().find_map(|line| line.strip_prefix(element)).unwrap().trim().parse().unwrap()
    };
    let (vertices, faces) = (count("element vertex"), count("element face"));
    let (vertex_bytes, face_bytes) = bytes[end..].split_at(vertices * 64);
    assert_eq!(face_bytes.len(), faces * 17);
    let mut file = ReadBack::default();
    for vertex in vertex_bytes.chunks(64) {
        let n: Vec<f64> = vertex.chunks(8).map(|number| f64::from_le_bytes(number.try_into().unwrap())).collect();
        file.positions.push([n[0], n[1], n[2]]);
        file.normals.push([n[3], n[4], n[5]]);
        file.uv.push([n[6], n[7]]);
    }
    for face in face_bytes.chunks(17) {
        assert_eq!(face[0], 4);
        let n: Vec<usize> =
            face[1..].chunks(4).map(|index| u32::from_le_bytes(index.try_into().unwrap()) as usize).collect();
        file.quads.push(n.try_into().unwrap());
    }
    (header, file)
}

fn read_stl(bytes: Vec<u8>) -> stl_io::IndexedMesh {
    stl_io::read_stl(&mut Cursor::new(bytes)).unwrap()
}

fn bits<const N: usize>(values: &[[f64; N]]) -> Vec<[u64; N]> {
    values.iter().map(|value| value.map(f64::to_bits)).collect()
}

fn joined<T: Clone>(scene: &Scene, part: impl Fn(&Mesh) -> &Vec<T>) -> Vec<T> {
    scene.meshes.iter().flat_map(|mesh| part(mesh).clone()).collect()
}

fn assert_holds_scene(file: &ReadBack, scene: &Scene) {
    assert_eq!(bits(&file.positions), bits(&joined(scene, |mesh| &mesh.positions)));
    assert_eq!(bits(&file.normals), bits(&joined(scene, |mesh| &mesh.normals)));
    assert_eq!(bits(&file.uv), bits(&joined(scene, |mesh| &mesh.uv)));
    let mut first = 0;
    let mut quads = Vec::new();
    for mesh in &scene.meshes {
        quads.extend(mesh.quads.iter().map(|quad| quad.map(|index| first + index as usize)));
        first += mesh.positions.len();
    }
    assert_eq!(file.quads, quads);
}

#[test]
fn obj_of_two_patches_reads_back_bit_for_bit() {
    let scene = two_patches();
    assert_holds_scene(&read_obj(bytes(&scene, Format::Obj)), &scene);
}

#[test]
fn obj_of_extreme_coordinates_reads_back_bit_for_bit() {
    let mut scene = PLANE.scene((2, 2));
    let extremes = [5e-324, -f64::MIN_POSITIVE, f64::MAX, -0.0, 1.0 / 3.0, 1e17, 1e-5, 123_456_789.123_456_79, 1e22];
    for (position, extreme) in scene.meshes[0].positions.iter_mut().zip(extremes) {
        position[1] = extreme;
    }
    assert_holds_scene(&read_obj(bytes(&scene, Format::Obj)), &scene);
}

#[test]
fn obj_begins_with_the_instant_and_names_each_patch_on_one_line() {
    let bytes = bytes(&two_patches(), Format::Obj);
    assert!(bytes.starts_with(b"# trimline"));
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(text.lines().next().unwrap().ends_with("t = 0.30000000000000004"));
    assert_eq!(read_obj(bytes).objects, ["plane", "left_wing α"]);
}

#[test]
fn ply_of_two_patches_reads_back_bit_for_bit() {
    let scene = two_patches();
    let (_, file) = read_ply(&bytes(&scene, Format::Ply));
    assert_holds_scene(&file, &scene);
}

#[test]
fn ply_header_is_ascii_and_lists_the_properties_in_order() {
    let (header, _) = read_ply(&bytes(&two_patches(), Format::Ply));
    assert!(header.is_ascii());
    assert!(header.starts_with("ply\nformat binary_little_endian 1.0\ncomment "));
    assert!(header.contains("\ncomment patch left_wing u+3b1: 28 vertices\n"), "{header}");
    let properties: Vec<&str> = header.lines().filter_map(|line| line.strip_prefix("property double ")).collect();
    assert_eq!(properties, ["x", "y", "z", "nx", "ny", "nz", "u", "v"]);
    assert!(header.ends_with("property list uchar uint vertex_indices\nend_header\n"));
}

#[test]
fn stl_of_a_closed_patch_merges_back_to_its_vertices() {
    let mesh = read_stl(bytes(&TORUS_PATCH.scene((3, 7)), Format::Stl));
    assert_eq!((mesh.vertices.len(), mesh.faces.len()), (4 * 7, 2 * 3 * 7));
    let mut open = 0;
    let edges: Vec<[usize; 2]> =
        mesh.faces.iter().flat_map(|face| [0, 1, 2].map(|k| [face.vertices[k], face.vertices[(k + 1) % 3]])).collect();
    for &[a, b] in &edges {
        match edges.iter().filter(|&&edge| edge == [b, a]).count() {
            0 => open += 1,
            opposite => assert_eq!(opposite, 1),
        }
    }
    assert_eq!(open, 2 * 7, "the two rims are all that is open");
}

#[test]
fn stl_facet_normals_agree_with_the_surface() {
    let mesh = read_stl(bytes(&CYLINDER.scene((4, 32)), Format::Stl));
    for face in &mesh.faces {
        let normal = face.normal.0.map(f64::from);
        // Each component is rounded to f32 once: 2^-25 of it at most.
        assert!((length(normal) - 1.0).abs() < 1e-7);
        let [x, y, _] = mesh.vertices[face.vertices[0]].0.map(f64::from);
        // A facet's normal lies half a cell, 5.6 degrees, from that of its corner.
        assert!(dot(normal, [x, y, 0.0]) > 5.7f64.to_radians().cos());
    }
}

#[test]
fn stl_splits_quads_with_equal_diagonals_all_the_same_way() {
    // The quads of a torus are symmetric trapezoids; their diagonals differ by rounding only.
    let mesh = read_stl(bytes(&TORUS_PATCH.scene((4, 31)), Format::Stl));
    for halves in mesh.faces.chunks(2) {
        // Split along a-c, both halves begin at a.
        assert_eq!(halves[0].vertices[0], halves[1].vertices[0]);
    }
}

#[test]
fn stl_of_a_cone_leaves_out_the_empty_triangles_at_the_pole() {
    let mesh = read_stl(bytes(&CONE.scene((4, 8)), Format::Stl));
    assert_eq!((mesh.vertices.len(), mesh.faces.len()), (1 + 4 * 8, 8 + 2 * 3 * 8));
}

#[test]
fn stl_of_a_patch_too_small_for_f32_at_its_place_warns_with_the_count() {
    let mut scene = PLANE.scene((2, 3));
    for position in &mut scene.meshes[0].positions {
        *position = position.map(|x| 1e6 + 1e-4 * x);
    }
    let warnings = write(&scene, Format::Stl, &mut Vec::new()).unwrap();
    assert_eq!(warnings.len(), 2);
    assert!(warnings.iter().all(|warning| warning.code == Code::PrecisionLost));
    assert!(warnings[0].message.starts_with("12 triangles are left out"), "{}", warnings[0].message);
}

/// Halves at 1e8 lie between singles, which are 8 apart there.
#[test]
fn scene_that_single_precision_deforms_is_a_warning_of_the_formats_that_have_it() {
    let mut far = PLANE.scene((2, 3));
    far.meshes[0].positions.iter_mut().for_each(|position| position[0] += 1e8 + 0.5);
    for &format in Format::ALL {
        let warnings = write(&far, format, &mut Vec::new()).unwrap();
        let is_told = warnings.iter().any(|warning| warning.message.contains("single precision, in which the points"));
        let is_single = ["STL", "GLB", "USDA", "3MF"].contains(&format.name());
        assert_eq!(is_told, is_single, "{}: {warnings:?}", format.name());
        assert_eq!(write(&PLANE.scene((2, 3)), format, &mut Vec::new()).unwrap().len(), 0, "{}", format.name());
    }
}

#[test]
fn stl_of_coordinates_beyond_f32_is_an_error_before_the_first_byte() {
    let mut scene = PLANE.scene((2, 3));
    scene.meshes[0].positions[5][2] = -1e39;
    let mut bytes = Vec::new();
    let refused = write(&scene, Format::Stl, &mut bytes).unwrap_err();
    assert!(matches!(refused, ExportError::CoordinateTooLarge { value: -1e39, .. }));
    assert!(bytes.is_empty());
}

#[test]
fn two_runs_write_equal_bytes() {
    for &format in Format::ALL {
        assert_eq!(bytes(&two_patches(), format), bytes(&two_patches(), format), "{}", format.name());
    }
}

#[test]
fn scene_without_patches_is_a_readable_file() {
    let empty = Scene::default();
    assert!(read_obj(bytes(&empty, Format::Obj)).positions.is_empty());
    assert!(read_ply(&bytes(&empty, Format::Ply)).1.quads.is_empty());
    assert!(read_stl(bytes(&empty, Format::Stl)).faces.is_empty());
}

/// Takes `room` bytes, then fails like a full disk.
struct FullDisk {
    room: usize,
}

impl Write for FullDisk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.room == 0 {
            return Err(io::Error::new(io::ErrorKind::StorageFull, "no space left"));
        }
        let taken = bytes.len().min(self.room);
        self.room -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn writer_failing_after_any_number_of_bytes_gives_an_error() {
    let scene = two_patches();
    for &format in Format::ALL {
        let size = bytes(&scene, format).len();
        for room in (0..size).step_by(13).chain([size - 1]) {
            match write(&scene, format, &mut FullDisk { room }) {
                Err(ExportError::Io(error)) => assert_eq!(error.kind(), io::ErrorKind::StorageFull),
                other => panic!("{} with room for {room} of {size} bytes: {other:?}", format.name()),
            }
        }
        assert!(write(&scene, format, &mut FullDisk { room: size }).is_ok());
    }
}

#[test]
fn writer_failing_only_at_the_flush_gives_an_error() {
    struct Unflushable;
    impl Write for Unflushable {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Err(io::Error::other("the disk is gone"))
        }
    }
    for &format in Format::ALL {
        assert!(
            matches!(write(&two_patches(), format, &mut Unflushable), Err(ExportError::Io(_))),
            "{}",
            format.name()
        );
    }
}

/// The two patches at three instants.
#[cfg(feature = "formats")]
fn frames_of_two_patches() -> Vec<Scene> {
    let frame = |(index, time): (usize, f64)| {
        let mut scene = Scene { time, ..two_patches() };
        for position in scene.meshes.iter_mut().flat_map(|mesh| &mut mesh.positions) {
            position[2] += index as f64;
        }
        scene
    };
    [-0.5, 0.1, 0.25].into_iter().enumerate().map(frame).collect()
}

#[cfg(feature = "formats")]
fn animation(frames: &[Scene], format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    assert_eq!(trimline::export::write_frames(frames, format, &mut bytes).unwrap(), []);
    bytes
}

/// The JSON chunk of a GLB file; the lengths of file and chunks are checked.
#[cfg(feature = "formats")]
fn glb_json(bytes: &[u8]) -> serde_json::Value {
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], number(4), number(8)), (b"glTF".as_slice(), 2, bytes.len()));
    let json = number(12);
    assert_eq!(20 + json + 8 + number(20 + json), bytes.len());
    serde_json::from_slice(&bytes[20..20 + json]).unwrap()
}

#[cfg(feature = "formats")]
#[test]
fn glb_of_two_patches_animates_a_named_node_for_each() {
    let json = glb_json(&animation(&frames_of_two_patches(), Format::Glb));
    let names: Vec<&str> =
        json["nodes"].as_array().unwrap().iter().map(|node| node["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["plane", "left_wing α"]);
    let animation = &json["animations"][0];
    assert_eq!(animation["channels"].as_array().unwrap().len(), 2);
    assert_eq!(json["meshes"][1]["primitives"][0]["targets"].as_array().unwrap().len(), 2);
    // Instants before 0 are moved; the document's own stand beside.
    let input = &json["accessors"][animation["samplers"][0]["input"].as_u64().unwrap() as usize];
    assert_eq!((input["min"][0].as_f64(), input["max"][0].as_f64()), (Some(0.0), Some(0.75)));
    assert_eq!(animation["extras"]["t"], serde_json::json!([-0.5, 0.1, 0.25]));
}

#[cfg(feature = "formats")]
#[test]
fn glb_of_instants_that_single_precision_cannot_tell_apart_is_refused() {
    for last in [0.1 + 1e-9, 1e39] {
        let mut frames = frames_of_two_patches();
        frames[2].time = last;
        let error = trimline::export::write_frames(&frames, Format::Glb, &mut Vec::new()).unwrap_err();
        assert!(matches!(error, ExportError::UnfitInstants { .. }), "{error}");
    }
}

#[cfg(feature = "formats")]
#[test]
fn usda_of_instants_without_a_rate_is_refused() {
    for times in [[0.0, 0.0, 1.0], [0.0, 1e-320, 2e-320], [-f64::MAX, 0.0, f64::MAX]] {
        let mut frames = frames_of_two_patches();
        frames.iter_mut().zip(times).for_each(|(frame, time)| frame.time = time);
        let error = trimline::export::write_frames(&frames, Format::Usda, &mut Vec::new()).unwrap_err();
        assert!(matches!(error, ExportError::UnfitInstants { .. }), "{error}");
    }
}

#[cfg(feature = "formats")]
#[test]
fn usda_of_two_patches_has_a_prim_for_each_with_a_sample_a_frame() {
    let text = String::from_utf8(animation(&frames_of_two_patches(), Format::Usda)).unwrap();
    assert_eq!(text.matches("def Mesh").count(), 2);
    assert!(text.contains("def Mesh \"left_wing_u3b1\" (\n        displayName = \"left_wing α\""), "{text}");
    assert_eq!(text.matches("point3f[] points.timeSamples").count(), 2);
    assert!(text.contains("1: 0.1,\n"));
}

#[cfg(feature = "formats")]
#[test]
fn vtp_of_two_patches_has_a_piece_for_each() {
    let text = String::from_utf8_lossy(&bytes(&two_patches(), Format::Vtp)).into_owned();
    assert_eq!(text.matches("<Piece ").count(), 2);
    assert!(text.contains(">0.30000000000000004</DataArray>"), "the instant");
}

#[cfg(feature = "formats")]
#[test]
fn npz_of_two_patches_prefixes_the_arrays_with_their_names() {
    let bytes = animation(&frames_of_two_patches(), Format::Npz);
    let text = String::from_utf8_lossy(&bytes);
    for name in ["t.npy", "plane.positions.npy", "left_wing_u3b1.derivative_v.npy", "left_wing_u3b1.v.npy"] {
        assert!(text.contains(name), "{name}");
    }
    assert!(text.replace(' ', "").contains("'shape':(3,4,7,3"), "frames, rows, columns of the torus, components");
}

#[cfg(feature = "formats")]
#[test]
fn threemf_of_two_patches_builds_an_object_for_each() {
    let bytes = bytes(&two_patches(), Format::ThreeMf);
    let text = String::from_utf8_lossy(&bytes);
    assert_eq!((text.matches("<object ").count(), text.matches("<item ").count()), (2, 2));
    assert!(text.contains("name=\"left_wing α\""));
}

#[test]
fn ply_holds_fields_after_the_properties_of_the_vertex() {
    let mut scene = PLANE.scene((1, 1));
    let values = vec![1.0, f64::NAN, -3.5, 1e300];
    scene.meshes[0].fields = vec![trimline::tessellate::Field { name: "residual", values: values.clone() }];
    let bytes = bytes(&scene, Format::Ply);
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.contains("property double v\nproperty double residual\nelement face"));
    let start = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    for (vertex, value) in values.iter().enumerate() {
        let at = start + vertex * 72 + 64;
        assert_eq!(bytes[at..at + 8], value.to_le_bytes());
    }
}
