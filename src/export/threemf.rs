//! 3MF: a zip archive with one XML model; an object per patch.
//!
//! Patches are open surfaces, so the objects are of type `surface`: a program that prints has to be given thickness.

use std::io::Write;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::diagnostic::Diagnostic;
use crate::tessellate::{Mesh, Scene};

use super::error::count_of;
use super::name::on_one_line;
use super::triangles::triangles;
use super::zipped::Archive;
use super::{Content, ExportError, Row};
use crate::diagnostic::Shortest;

pub(super) const ROW: Row = Row {
    name: "3MF",
    extension: "3mf",
    description: "for printing; triangles and patch names, decimals exact to the last digit, one unit is a millimetre",
    content: Content::Still(write),
    holds_fields: false,
    is_single: true,
};

const CORE: &str = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const RELATIONSHIPS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const CONTENT_TYPES: &str = "http://schemas.openxmlformats.org/package/2006/content-types";
const MODEL_RELATIONSHIP: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

fn write(scene: &Scene, out: &mut dyn Write) -> Result<Vec<Diagnostic>, ExportError> {
    for mesh in &scene.meshes {
        // The specification numbers vertices and triangles below 2^31.
        let count = count_of(ROW.name, "vertices", mesh.positions.len())?;
        if i32::try_from(count).is_err() {
            return Err(ExportError::TooMany {
                format: ROW.name,
                items: "vertices",
                largest: i32::MAX.unsigned_abs(),
                count: mesh.positions.len(),
            });
        }
    }
    let mut archive = Archive::new();
    archive.add("[Content_Types].xml", |out| {
        let xml = &mut document(out)?;
        let types = xml.create_element("Types").with_attribute(("xmlns", CONTENT_TYPES));
        types.write_inner_content(|xml| {
            let default = |extension, kind| [("Extension", extension), ("ContentType", kind)];
            let relationships = default("rels", "application/vnd.openxmlformats-package.relationships+xml");
            xml.create_element("Default").with_attributes(relationships).write_empty()?;
            let model = default("model", "application/vnd.ms-package.3dmanufacturing-3dmodel+xml");
            xml.create_element("Default").with_attributes(model).write_empty()?;
            Ok(())
        })?;
        Ok(())
    })?;
    archive.add("_rels/.rels", |out| {
        let xml = &mut document(out)?;
        let relationships = xml.create_element("Relationships").with_attribute(("xmlns", RELATIONSHIPS));
        relationships.write_inner_content(|xml| {
            let model = [("Target", "/3D/3dmodel.model"), ("Id", "model"), ("Type", MODEL_RELATIONSHIP)];
            xml.create_element("Relationship").with_attributes(model).write_empty()?;
            Ok(())
        })?;
        Ok(())
    })?;
    archive.add("3D/3dmodel.model", |out| write_model(scene, out))?;
    archive.finish(out)?;
    Ok(Vec::new())
}

fn document<W: Write>(out: W) -> std::io::Result<Writer<W>> {
    let mut xml = Writer::new(out);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    Ok(xml)
}

fn write_model(scene: &Scene, out: &mut dyn Write) -> std::io::Result<()> {
    let xml = &mut document(out)?;
    let attributes = [("unit", "millimeter"), ("xml:lang", "en-US"), ("xmlns", CORE)];
    xml.create_element("model").with_attributes(attributes).write_inner_content(|xml| {
        let time = format!("trimline {}, t = {}", env!("CARGO_PKG_VERSION"), Shortest(scene.time));
        let description = xml.create_element("metadata").with_attribute(("name", "Description"));
        description.write_text_content(quick_xml::events::BytesText::new(&time))?;
        xml.create_element("resources").write_inner_content(|xml| {
            scene.meshes.iter().zip(1_usize..).try_for_each(|(mesh, id)| write_object(mesh, id, xml))
        })?;
        xml.create_element("build").write_inner_content(|xml| {
            for (_, id) in scene.meshes.iter().zip(1_usize..) {
                xml.create_element("item").with_attribute(("objectid", id.to_string().as_str())).write_empty()?;
            }
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(())
}

fn write_object<W: Write>(mesh: &Mesh, id: usize, xml: &mut Writer<W>) -> std::io::Result<()> {
    let (id, name) = (id.to_string(), on_one_line(&mesh.name));
    let attributes = [("id", id.as_str()), ("type", "surface"), ("name", name.as_str())];
    xml.create_element("object").with_attributes(attributes).write_inner_content(|xml| {
        xml.create_element("mesh").write_inner_content(|xml| {
            xml.create_element("vertices").write_inner_content(|xml| {
                for position in &mesh.positions {
                    let [x, y, z] = position.map(|coordinate| Shortest(coordinate).to_string());
                    let attributes = [("x", x.as_str()), ("y", y.as_str()), ("z", z.as_str())];
                    xml.create_element("vertex").with_attributes(attributes).write_empty()?;
                }
                Ok(())
            })?;
            xml.create_element("triangles").write_inner_content(|xml| {
                for triangle in triangles(mesh) {
                    let [a, b, c] = triangle.map(|index| index.to_string());
                    let attributes = [("v1", a.as_str()), ("v2", b.as_str()), ("v3", c.as_str())];
                    xml.create_element("triangle").with_attributes(attributes).write_empty()?;
                }
                Ok(())
            })?;
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(())
}
