//! VTK polygonal data: XML that describes, then raw little-endian arrays; and the index of a series of such files.
//!
//! Each patch is a piece; the cell array `patch` numbers them from 0, and the field array `patches` has their names.

use std::io::{self, BufWriter, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

use super::name::on_one_line;
use super::{Content, ExportError, Row};
use crate::diagnostic::Shortest;

pub(super) const ROW: Row = Row {
    name: "VTP",
    extension: "vtp",
    description: "VTK for ParaView; quads, normals, S_u, S_v, (u, v) and fields in double precision; frames by a .pvd",
    content: Content::Still(write),
    holds_fields: true,
    is_single: false,
};

fn write(scene: &Scene, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    let mut appended = Appended::default();
    let mut xml = Writer::new(&mut *out);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let attributes =
        [("type", "PolyData"), ("version", "1.0"), ("byte_order", "LittleEndian"), ("header_type", "UInt64")];
    xml.write_event(Event::Start(BytesStart::new("VTKFile").with_attributes(attributes)))?;
    xml.create_element("PolyData").write_inner_content(|xml| {
        xml.create_element("FieldData").write_inner_content(|xml| field_data(scene, xml))?;
        scene.meshes.iter().enumerate().try_for_each(|(index, mesh)| piece(mesh, index, &mut appended, xml))
    })?;
    xml.write_event(Event::Start(BytesStart::new("AppendedData").with_attributes([("encoding", "raw")])))?;
    out.write_all(b"_")?;
    out.write_all(&appended.bytes)?;
    let mut xml = Writer::new(out);
    for element in ["AppendedData", "VTKFile"] {
        xml.write_event(Event::End(BytesEnd::new(element)))?;
    }
    Ok(Vec::new())
}

/// The instant, as VTK's readers look for it, and the names of the patches, as VTK writes text.
fn field_data<W: Write>(scene: &Scene, xml: &mut Writer<W>) -> io::Result<()> {
    let time = [("type", "Float64"), ("Name", "TimeValue"), ("NumberOfTuples", "1"), ("format", "ascii")];
    let text = Shortest(scene.time).to_string();
    xml.create_element("DataArray").with_attributes(time).write_text_content(BytesText::new(&text))?;
    let count = scene.meshes.len().to_string();
    let names = [("type", "String"), ("Name", "patches"), ("NumberOfTuples", count.as_str()), ("format", "ascii")];
    let text: Vec<String> = scene
        .meshes
        .iter()
        .flat_map(|mesh| on_one_line(&mesh.name).into_bytes().into_iter().chain([0]))
        .map(|byte| byte.to_string())
        .collect();
    xml.create_element("DataArray").with_attributes(names).write_text_content(BytesText::new(&text.join(" ")))?;
    Ok(())
}

fn piece<W: Write>(mesh: &Mesh, index: usize, appended: &mut Appended, xml: &mut Writer<W>) -> io::Result<()> {
    let (points, quads) = (mesh.positions.len().to_string(), mesh.quads.len().to_string());
    let counts = [
        ("NumberOfPoints", points.as_str()),
        ("NumberOfVerts", "0"),
        ("NumberOfLines", "0"),
        ("NumberOfStrips", "0"),
        ("NumberOfPolys", quads.as_str()),
    ];
    xml.create_element("Piece").with_attributes(counts).write_inner_content(|xml| {
        xml.create_element("PointData").with_attribute(("Normals", "normals")).write_inner_content(|xml| {
            appended.doubles("normals", 3, mesh.normals.iter().flatten(), xml)?;
            appended.doubles("derivative_u", 3, mesh.tangents_u.iter().flatten(), xml)?;
            appended.doubles("derivative_v", 3, mesh.tangents_v.iter().flatten(), xml)?;
            appended.doubles("uv", 2, mesh.uv.iter().flatten(), xml)?;
            mesh.fields.iter().try_for_each(|field| appended.doubles(field.name, 1, field.values.iter(), xml))
        })?;
        xml.create_element("CellData")
            .write_inner_content(|xml| appended.integers("patch", mesh.quads.iter().map(|_| index as i64), xml))?;
        xml.create_element("Points")
            .write_inner_content(|xml| appended.doubles("points", 3, mesh.positions.iter().flatten(), xml))?;
        xml.create_element("Polys").write_inner_content(|xml| {
            appended.integers("connectivity", mesh.quads.iter().flatten().map(|index| i64::from(*index)), xml)?;
            appended.integers("offsets", (1_i64..).map(|quad| 4 * quad).take(mesh.quads.len()), xml)
        })?;
        Ok(())
    })?;
    Ok(())
}

/// The arrays that stand behind the description, each after its length in bytes.
#[derive(Default)]
struct Appended {
    bytes: Vec<u8>,
}

impl Appended {
    fn doubles<'a, W: Write>(
        &mut self,
        name: &str,
        components: usize,
        values: impl Iterator<Item = &'a f64>,
        xml: &mut Writer<W>,
    ) -> io::Result<()> {
        self.describe("Float64", name, components, xml)?;
        self.append(values.flat_map(|value| value.to_le_bytes()));
        Ok(())
    }

    fn integers<W: Write>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = i64>,
        xml: &mut Writer<W>,
    ) -> io::Result<()> {
        self.describe("Int64", name, 1, xml)?;
        self.append(values.flat_map(i64::to_le_bytes));
        Ok(())
    }

    fn describe<W: Write>(&self, kind: &str, name: &str, components: usize, xml: &mut Writer<W>) -> io::Result<()> {
        let (components, offset) = (components.to_string(), self.bytes.len().to_string());
        let attributes = [
            ("type", kind),
            ("Name", name),
            ("NumberOfComponents", components.as_str()),
            ("format", "appended"),
            ("offset", offset.as_str()),
        ];
        xml.create_element("DataArray").with_attributes(attributes).write_empty()?;
        Ok(())
    }

    fn append(&mut self, values: impl Iterator<Item = u8>) {
        let start = self.bytes.len();
        self.bytes.extend([0; 8]);
        self.bytes.extend(values);
        let length = (self.bytes.len() - start - 8) as u64;
        if let Some(header) = self.bytes.get_mut(start..start + 8) {
            header.copy_from_slice(&length.to_le_bytes());
        }
    }
}

/// Writes the PVD file that tells ParaView the instants of a series: each with the name of its VTP file.
///
/// # Errors
/// [`ExportError::Io`] when `out` fails.
pub fn write_pvd(series: &[(f64, String)], out: &mut dyn Write) -> Result<(), ExportError> {
    let mut xml = Writer::new(BufWriter::new(out));
    xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let attributes = [("type", "Collection"), ("version", "1.0"), ("byte_order", "LittleEndian")];
    xml.create_element("VTKFile").with_attributes(attributes).write_inner_content(|xml| {
        xml.create_element("Collection").write_inner_content(|xml| {
            for (time, file) in series {
                let time = Shortest(*time).to_string();
                let attributes = [("timestep", time.as_str()), ("part", "0"), ("file", file.as_str())];
                xml.create_element("DataSet").with_attributes(attributes).write_empty()?;
            }
            Ok(())
        })?;
        Ok(())
    })?;
    xml.into_inner().flush()?;
    Ok(())
}
