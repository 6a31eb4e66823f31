//! STEP and IGES files: what they promise about topology and numbers, read back by readers of their own.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use trimline::diagnostic::Class;
use trimline::export::{CadFormat, ExportError, Face, Schema, write_cad};
use trimline::surface::{BsplineSurface, KnotVector};

use crate::bspline::surface;

fn bytes(name: &str, faces: &[Face], format: CadFormat) -> String {
    let mut bytes = Vec::new();
    write_cad(name, faces, format, &mut bytes).unwrap_or_else(|error| panic!("{error}"));
    String::from_utf8(bytes).unwrap()
}

fn step(faces: &[Face]) -> Step {
    Step::read(&bytes("part", faces, CadFormat::Step(Schema::Ap214)))
}

/// The data section of a STEP file: text of each entity by number.
struct Step(BTreeMap<usize, String>);

impl Step {
    fn read(text: &str) -> Step {
        assert!(text.starts_with("ISO-10303-21;\nHEADER;\n") && text.ends_with("ENDSEC;\nEND-ISO-10303-21;\n"));
        assert!(text.is_ascii());
        let data = text.split_once("DATA;\n").unwrap().1.split_once("ENDSEC;").unwrap().0;
        let mut entities = BTreeMap::new();
        for line in data.lines() {
            let (number, entity) = line.strip_prefix('#').unwrap().split_once('=').unwrap();
            let entity = entity.strip_suffix(';').unwrap().to_owned();
            assert!(entities.insert(number.parse().unwrap(), entity).is_none(), "{line}");
        }
        let step = Step(entities);
        for entity in step.0.values() {
            assert!(references(entity).iter().all(|id| step.0.contains_key(id)), "{entity}");
        }
        step
    }

    fn of_kind(&self, kind: &str) -> Vec<&str> {
        let start = format!("{kind}(");
        self.0.values().filter_map(|entity| entity.strip_prefix(start.as_str())).collect()
    }

    fn counts(&self) -> [usize; 5] {
        ["ADVANCED_FACE", "EDGE_CURVE", "ORIENTED_EDGE", "VERTEX_POINT", "OPEN_SHELL"]
            .map(|kind| self.of_kind(kind).len())
    }

    /// How often each edge is run through forwards and backwards, as the shell's outside sees it.
    fn edge_uses(&self) -> BTreeMap<usize, [usize; 2]> {
        let mut uses: BTreeMap<usize, [usize; 2]> = BTreeMap::new();
        for oriented in self.of_kind("ORIENTED_EDGE") {
            uses.entry(references(oriented)[0]).or_default()[usize::from(oriented.ends_with(".T.)"))] += 1;
        }
        uses
    }

    fn points(&self, ids: &[usize]) -> Vec<[f64; 3]> {
        let point = |id: &usize| {
            let text = self.0[id].strip_prefix("CARTESIAN_POINT('',(").unwrap().strip_suffix("))").unwrap();
            let numbers: Vec<f64> = text.split(',').map(real).collect();
            numbers.try_into().unwrap()
        };
        ids.iter().map(point).collect()
    }

    /// Every loop is closed: an edge ends where the next one starts.
    fn check_loops(&self) {
        for boundary in self.of_kind("EDGE_LOOP") {
            let ends: Vec<[usize; 2]> = references(boundary)
                .iter()
                .map(|id| {
                    let oriented = &self.0[id];
                    let edge = references(&self.0[&references(oriented)[0]]);
                    if oriented.ends_with(".T.)") { [edge[0], edge[1]] } else { [edge[1], edge[0]] }
                })
                .collect();
            for (one, next) in ends.iter().zip(ends.iter().cycle().skip(1)) {
                assert_eq!(one[1], next[0], "{boundary}");
            }
        }
    }
}

/// A real of ISO 10303-21 has a decimal point.
fn real(text: &str) -> f64 {
    assert!(text.contains('.'), "{text}");
    text.parse().unwrap()
}

fn references(entity: &str) -> Vec<usize> {
    let digits = |rest: &str| rest.chars().take_while(char::is_ascii_digit).collect::<String>();
    entity.split('#').skip(1).map(|rest| digits(rest).parse().unwrap()).collect()
}

fn face(name: &str, surface: &BsplineSurface) -> Face {
    Face { name: name.to_owned(), surface: surface.clone() }
}

/// Clamped cubic knots from `start` on.
fn knots(start: f64, points: usize) -> KnotVector {
    let breakpoints: Vec<f64> = (0..points - 2).map(|index| start + index as f64).collect();
    KnotVector::clamped(3, &breakpoints).unwrap()
}

/// Control points from a rule for i and j.
fn net(rows: usize, columns: usize, rule: impl Fn(usize, usize) -> [f64; 3]) -> BsplineSurface {
    let points = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| rule(i, j)).collect();
    BsplineSurface::new(knots(0.0, rows), knots(0.0, columns), points).unwrap()
}

fn on_circle(index: usize, count: usize) -> [f64; 2] {
    // The last is the first, bit for bit.
    let (sin, cos) = (std::f64::consts::TAU * (index % count) as f64 / count as f64).sin_cos();
    [cos, sin]
}

#[test]
fn open_face_has_four_edges_and_the_exact_numbers() {
    let one = surface(5, [3, 4], [6, 7]).clamped();
    let step = step(&[face("open", &one)]);
    assert_eq!(step.counts(), [1, 4, 4, 4, 1]);
    step.check_loops();
    let [text] = step.of_kind("B_SPLINE_SURFACE_WITH_KNOTS")[..] else { panic!("one surface") };
    assert_eq!(step.points(&references(text)), one.net());
    let [u, v] = one.knots();
    for knot in u.breakpoints().into_iter().chain(v.breakpoints()) {
        assert!(
            text.split(['(', ')', ',']).any(|word| word.contains('.') && word.parse() == Ok(knot)),
            "{knot} in {text}"
        );
    }
    assert!(text.starts_with("'open',3,4,(("), "{text}");
    assert!(text.contains(".UNSPECIFIED.,.F.,.F.,.F.,(4,1,1,4),(5,1,1,5),"), "{text}");
}

#[test]
fn unclamped_face_is_clamped_before_it_is_written() {
    let one = surface(5, [3, 3], [6, 6]);
    assert_eq!(
        bytes("a", &[face("x", &one)], CadFormat::Iges),
        bytes("a", &[face("x", &one.clamped())], CadFormat::Iges)
    );
    let step = step(&[face("x", &one)]);
    let text = step.of_kind("B_SPLINE_SURFACE_WITH_KNOTS")[0];
    assert_eq!(step.points(&references(text)), one.clamped().net());
}

#[test]
fn face_that_closes_has_a_seam_that_it_runs_through_twice() {
    let tube = net(4, 9, |i, j| [on_circle(j, 8)[0], on_circle(j, 8)[1], i as f64]);
    let step = step(&[face("tube", &tube)]);
    assert_eq!(step.counts(), [1, 3, 4, 2, 1]);
    step.check_loops();
    let mut uses: Vec<[usize; 2]> = step.edge_uses().into_values().collect();
    uses.sort_unstable();
    assert_eq!(uses, [[0, 1], [1, 0], [1, 1]]);
    assert!(step.of_kind("B_SPLINE_SURFACE_WITH_KNOTS")[0].contains(".UNSPECIFIED.,.F.,.T.,.F.,"));
}

#[test]
fn torus_is_a_closed_shell_of_one_face() {
    let torus = net(7, 9, |i, j| {
        let ([a, b], [c, d]) = (on_circle(i, 6), on_circle(j, 8));
        [(3.0 + a) * c, (3.0 + a) * d, b]
    });
    let step = step(&[face("torus", &torus)]);
    assert_eq!(step.counts(), [1, 2, 4, 1, 0]);
    assert_eq!(step.of_kind("CLOSED_SHELL").len(), 1);
    assert!(step.edge_uses().into_values().all(|uses| uses == [1, 1]));
}

#[test]
fn edge_that_is_a_point_is_left_out() {
    let cone = net(4, 9, |i, j| [on_circle(j, 8)[0], on_circle(j, 8)[1], 0.0].map(|x| x * (3 - i) as f64));
    let step = step(&[face("cone", &cone)]);
    // The base and the seam to the tip.
    assert_eq!(step.counts(), [1, 2, 3, 2, 1]);
    step.check_loops();
}

#[test]
fn face_without_area_is_refused_before_the_first_byte() {
    let thin: [(&str, BsplineSurface); 4] = [
        ("a point", net(4, 4, |_, _| [1.0, 2.0, 3.0])),
        ("a point but for rounding", net(4, 4, |i, j| [5.0, 5.0 + (i + 2 * j) as f64 * 4e-16, 0.0])),
        ("a line", net(4, 4, |i, j| [i as f64, (i + j) as f64 * 1e-16, 0.0])),
        ("a curve", net(4, 9, |_, j| [on_circle(j, 8)[0], on_circle(j, 8)[1], 1.0])),
    ];
    let sound = net(4, 4, |i, j| [i as f64, j as f64, 0.0]);
    for (name, thin) in thin {
        for format in [CadFormat::Step(Schema::Ap214), CadFormat::Iges, CadFormat::Json] {
            for faces in [vec![face(name, &thin)], vec![face("sound", &sound), face(name, &thin)]] {
                let mut bytes = Vec::new();
                let error = write_cad("part", &faces, format, &mut bytes).expect_err(name);
                assert!(matches!(&error, ExportError::NoArea { name: refused } if refused == name), "{error}");
                assert_eq!(error.to_diagnostic().class(), Class::Source);
                assert!(bytes.is_empty());
            }
        }
    }
    // Beside a line that is huge, a square has an area, and beside a huge square it is too small for one model.
    let line = net(4, 4, |i, j| [1e300, 1e300 * i as f64, j as f64]);
    let huge = net(4, 4, |i, j| [1e300 * i as f64, 1e300 * j as f64, 0.0]);
    let refusal = |other: &BsplineSurface| {
        let faces = [face("sound", &sound), face("other", other)];
        write_cad("part", &faces, CadFormat::Iges, &mut Vec::new()).expect_err("two sizes")
    };
    assert!(matches!(refusal(&line), ExportError::NoArea { name } if name == "other"));
    assert!(matches!(refusal(&huge), ExportError::TooNarrow { name, .. } if name == "sound"));
    // A strip a ten-millionth as wide as it is long is one.
    let strip = net(4, 4, |i, j| [i as f64, j as f64 * 1e-7, 0.0]);
    assert!(write_cad("part", &[face("strip", &strip)], CadFormat::Iges, &mut Vec::new()).is_ok());
}

/// The square [i, i + 3] x [j, j + 3] with waves.
fn tile(i: usize, j: usize) -> BsplineSurface {
    net(4, 4, |a, b| {
        let (x, y) = ((i + a) as f64, (j + b) as f64);
        [x, y, (x * 1.3).sin() * (y * 0.7).cos()]
    })
}

#[test]
fn four_tiles_share_four_edges_and_one_vertex() {
    let tiles = [tile(0, 0), tile(3, 0), tile(0, 3), tile(3, 3)];
    let faces: Vec<Face> = tiles.iter().map(|tile| face("tile", tile)).collect();
    let step = step(&faces);
    assert_eq!(step.counts(), [4, 12, 16, 9, 1]);
    step.check_loops();
    let shared = step.edge_uses().into_values().filter(|uses| *uses == [1, 1]).count();
    assert_eq!(shared, 4);
    assert!(step.of_kind("ADVANCED_FACE").iter().all(|face| face.ends_with(".T.)")));
}

#[test]
fn tiles_that_face_each_other_the_wrong_way_are_turned() {
    for other in [tile(3, 0).reversed_u(), tile(3, 0).reversed_v(), tile(3, 0).transposed()] {
        let step = step(&[face("a", &tile(0, 0)), face("b", &other)]);
        assert_eq!(step.counts(), [2, 7, 8, 6, 1]);
        step.check_loops();
        assert_eq!(step.edge_uses().into_values().filter(|uses| *uses == [1, 1]).count(), 1);
        let senses: Vec<bool> = step.of_kind("ADVANCED_FACE").iter().map(|face| face.ends_with(".T.)")).collect();
        assert_eq!(senses, [true, false]);
    }
    // Turned twice is not turned.
    let other = tile(3, 0).reversed_u().reversed_v();
    let step = step(&[face("a", &tile(0, 0)), face("b", &other)]);
    assert!(step.of_kind("ADVANCED_FACE").iter().all(|face| face.ends_with(".T.)")));
    assert_eq!(step.counts(), [2, 7, 8, 6, 1]);
}

#[test]
fn seam_shared_but_for_rounding_is_one_edge_and_a_gap_is_two() {
    let shifted = |by: f64| {
        let tile = tile(3, 0);
        let net = tile.net().iter().map(|[x, y, z]| [x + by, *y, *z]).collect();
        BsplineSurface::new(knots(0.0, 4), knots(5.0, 4), net).unwrap()
    };
    let counts = |by: f64| step(&[face("a", &tile(0, 0)), face("b", &shifted(by))]).counts();
    assert_eq!(counts(1e-12), [2, 7, 8, 6, 1]);
    assert_eq!(counts(1e-3), [2, 8, 8, 8, 2]);
}

#[test]
fn moebius_strip_keeps_its_ends_apart() {
    // Half a turn: the last column is the first, run through backwards.
    let strip = net(4, 9, |i, j| {
        let angle = std::f64::consts::PI * j as f64 / 8.0;
        let [c, d] = on_circle(j, 8);
        let across = if j == 8 { 1.5 - i as f64 } else { (i as f64 - 1.5) * angle.cos() };
        let up = if j == 8 { 0.0 } else { (i as f64 - 1.5) * angle.sin() };
        [(4.0 + across) * c, (4.0 + across) * d, up]
    });
    let step = step(&[face("strip", &strip)]);
    assert_eq!(step.counts()[1], 4);
    assert!(step.edge_uses().into_values().all(|uses| uses[0] + uses[1] == 1));
}

#[test]
fn third_face_at_an_edge_gets_an_edge_of_its_own() {
    let wing = net(4, 4, |a, b| {
        let [x, y, z] = tile(0, 0).net()[12 + b];
        [x, y, z + a as f64]
    });
    let step = step(&[face("a", &tile(0, 0)), face("b", &tile(3, 0)), face("wing", &wing)]);
    assert_eq!(step.counts(), [3, 11, 12, 8, 2]);
    assert!(step.edge_uses().into_values().all(|uses| uses.iter().all(|count| *count < 2)));
}

#[test]
fn header_names_the_schema_and_encodes_the_name() {
    let faces = [face("it's α", &tile(0, 0))];
    let text = bytes("it's α", &faces, CadFormat::Step(Schema::Ap214));
    assert!(text.contains("FILE_NAME('it''s \\X2\\03B1\\X0\\','',"), "{text}");
    assert!(text.contains("FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));"));
    let text = bytes("part", &faces, CadFormat::Step(Schema::Ap242));
    assert!(text.contains("'AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }'"));
    assert!(text.contains("'managed model based 3d engineering'"));
}

/// The parameters of every surface of an IGES file, after checking its columns and counts.
fn iges_parameters(text: &str) -> Vec<Vec<String>> {
    let mut counts: BTreeMap<char, usize> = BTreeMap::new();
    let mut data: BTreeMap<usize, String> = BTreeMap::new();
    for line in text.lines() {
        assert_eq!(line.len(), 80, "{line}");
        let section = line.as_bytes()[72] as char;
        let count = counts.entry(section).or_default();
        *count += 1;
        assert_eq!(line[73..].trim().parse(), Ok(*count), "{line}");
        if section == 'P' {
            data.entry(line[65..72].trim().parse().unwrap()).or_default().push_str(line[..64].trim_end());
        }
    }
    let last = text.lines().last().unwrap();
    let stated = format!("S{:>7}G{:>7}D{:>7}P{:>7}", counts[&'S'], counts[&'G'], counts[&'D'], counts[&'P']);
    assert!(last.starts_with(&stated), "{last}");
    assert_eq!(counts[&'D'], 2 * data.len());
    let split = |text: &String| text.strip_suffix(';').unwrap().split(',').map(str::to_owned).collect();
    data.values().map(split).collect()
}

#[test]
fn iges_holds_the_exact_numbers_in_the_order_of_entity_128() {
    let one = surface(5, [3, 2], [6, 5]).clamped();
    let far = net(4, 4, |i, j| [i as f64 * -1e300, j as f64 * 1e299, (i + j) as f64 * 1e-300]);
    // A file each: beside a face of 1e300 one of 10 is a point.
    for surface in [&one, &far] {
        let text = bytes("α part, with; marks", &[face("one", surface), face("two", surface)], CadFormat::Iges);
        let parameters = iges_parameters(&text);
        assert_eq!(parameters.len(), 2);
        for fields in &parameters {
            let [u, v] = surface.knots();
            let heads = [128, u.points() - 1, v.points() - 1, u.degree(), v.degree(), 0, 0, 1, 0, 0];
            assert_eq!(fields[..10], heads.map(|number| number.to_string()));
            let number = |field: &String| -> f64 { field.replace('D', "e").parse().unwrap() };
            let numbers: Vec<f64> = fields[10..fields.len() - 2].iter().map(number).collect();
            let columns = surface.transposed();
            let mut expected: Vec<f64> = u.as_slice().iter().chain(v.as_slice()).copied().collect();
            expected.extend(vec![1.0; surface.net().len()]);
            expected.extend(columns.net().iter().flatten());
            expected.extend([u.domain(), v.domain()].concat());
            assert_eq!(numbers, expected);
        }
    }
}

#[test]
fn formats_are_known_by_their_extensions() {
    for extension in CadFormat::EXTENSIONS {
        assert!(CadFormat::from_extension(&extension.to_uppercase(), Schema::Ap242).is_some(), "{extension}");
    }
    assert_eq!(CadFormat::from_extension("stp", Schema::Ap242), Some(CadFormat::Step(Schema::Ap242)));
    assert_eq!(CadFormat::from_extension("obj", Schema::Ap242), None);
}

#[test]
fn files_repeat_byte_for_byte() {
    let faces = [face("a", &tile(0, 0)), face("b", &tile(3, 0))];
    for format in [CadFormat::Step(Schema::Ap214), CadFormat::Iges, CadFormat::Json] {
        assert_eq!(bytes("part", &faces, format), bytes("part", &faces, format));
    }
}

/// Stops after some bytes.
struct Full(usize);

impl std::io::Write for Full {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0 = self.0.checked_sub(bytes.len()).ok_or_else(|| std::io::Error::other("full"))?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn full_disk_is_reported() {
    let faces = [face("a", &tile(0, 0))];
    for format in [CadFormat::Step(Schema::Ap214), CadFormat::Iges, CadFormat::Json] {
        assert!(matches!(write_cad("part", &faces, format, &mut Full(100)), Err(ExportError::Io(_))));
    }
}
