//! STEP: a surface model of shells, whose faces lie on B-spline surfaces, for AP214 and AP242.

use crate::surface::KnotVector;

use super::part21::{Entities, Id, list, real, references, string};
use super::topology::{Edge, OrientedFace, Shell, topology};
use super::{Face, Schema};

/// The file of clamped faces.
pub(super) fn text(name: &str, faces: &[Face], schema: Schema) -> String {
    let model = topology(faces);
    let mut entities = Entities::default();
    let (product, context) = product(&mut entities, name, schema);
    let vertices: Vec<Id> = model.vertices.iter().map(|place| vertex(&mut entities, place)).collect();
    let edges: Vec<Id> = model.edges.iter().map(|one| edge(&mut entities, one, &vertices)).collect();
    let shells: Vec<Id> = model.shells.iter().map(|one| shell(&mut entities, one, faces, &edges)).collect();
    let surfaces = entities.add(&format!("SHELL_BASED_SURFACE_MODEL('',{})", references(&shells)));
    let axes = axes(&mut entities);
    let shape = entities
        .add(&format!("MANIFOLD_SURFACE_SHAPE_REPRESENTATION({},(#{surfaces},#{axes}),#{context})", string(name)));
    entities.add(&format!("SHAPE_DEFINITION_REPRESENTATION(#{product},#{shape})"));
    let schema = match schema {
        Schema::Ap214 => "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }",
        Schema::Ap242 => "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }",
    };
    let program = format!("trimline {}", env!("CARGO_PKG_VERSION"));
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('B-spline surfaces'),'2;1');\n\
         FILE_NAME({},'',(''),(''),'{program}','{program}','');\nFILE_SCHEMA(('{schema}'));\nENDSEC;\nDATA;\n{}ENDSEC;\n\
         END-ISO-10303-21;\n",
        string(name),
        entities.into_text()
    )
}

/// What a part is called and measured in: the shape of its definition, and the context of its geometry.
fn product(entities: &mut Entities, name: &str, schema: Schema) -> (Id, Id) {
    let (application, protocol, year) = match schema {
        Schema::Ap214 => ("core data for automotive mechanical design processes", "automotive_design", 2000),
        Schema::Ap242 => ("managed model based 3d engineering", "ap242_managed_model_based_3d_engineering", 2014),
    };
    let name = string(name);
    let application = entities.add(&format!("APPLICATION_CONTEXT('{application}')"));
    entities
        .add(&format!("APPLICATION_PROTOCOL_DEFINITION('international standard','{protocol}',{year},#{application})"));
    let context = entities.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
    let product = entities.add(&format!("PRODUCT({name},{name},'',(#{context}))"));
    entities.add(&format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#{product}))"));
    let formation = entities.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
    let context = entities.add(&format!("PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"));
    let definition = entities.add(&format!("PRODUCT_DEFINITION('design','',#{formation},#{context})"));
    let shape = entities.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
    let length = entities.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    let angle = entities.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    let solid_angle = entities.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    let uncertainty = entities.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),#{length},'distance_accuracy_value','')",
        real(1e-7)
    ));
    let context = entities.add(&format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{uncertainty}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid_angle}))REPRESENTATION_CONTEXT('',''))"
    ));
    (shape, context)
}

fn axes(entities: &mut Entities) -> Id {
    let origin = entities.point(&[0.0; 3]);
    let [z, x] = ["(0.,0.,1.)", "(1.,0.,0.)"].map(|ratios| entities.add(&format!("DIRECTION('',{ratios})")));
    entities.add(&format!("AXIS2_PLACEMENT3D('',#{origin},#{z},#{x})"))
}

fn vertex(entities: &mut Entities, place: &[f64; 3]) -> Id {
    let point = entities.point(place);
    entities.add(&format!("VERTEX_POINT('',#{point})"))
}

fn edge(entities: &mut Entities, edge: &Edge, vertices: &[Id]) -> Id {
    let points = entities.points(edge.curve.points());
    let [start, end] = edge.ends;
    let knots = edge.curve.knots();
    let curve = entities.add(&format!(
        "B_SPLINE_CURVE_WITH_KNOTS('',{},{points},.UNSPECIFIED.,{},.F.,{},{},.UNSPECIFIED.)",
        knots.degree(),
        logical(start == end),
        multiplicities(knots),
        values(knots),
    ));
    let [start, end] = [start, end].map(|end| vertices.get(end).copied().unwrap_or_default());
    entities.add(&format!("EDGE_CURVE('',#{start},#{end},#{curve},.T.)"))
}

fn shell(entities: &mut Entities, shell: &Shell, faces: &[Face], edges: &[Id]) -> Id {
    let ids: Vec<Id> =
        shell.faces.iter().filter_map(|one| Some(face(entities, one, faces.get(one.face)?, edges))).collect();
    let kind = if shell.is_closed { "CLOSED_SHELL" } else { "OPEN_SHELL" };
    entities.add(&format!("{kind}('',{})", references(&ids)))
}

fn face(entities: &mut Entities, oriented: &OrientedFace, face: &Face, edges: &[Id]) -> Id {
    let mut boundary = oriented.boundary.clone();
    if oriented.is_reversed {
        // The boundary runs around the face's outside, which is then against the surface's normal.
        boundary.reverse();
        boundary.iter_mut().for_each(|(_, is_forward)| *is_forward = !*is_forward);
    }
    let sides: Vec<Id> = boundary
        .iter()
        .map(|(edge, is_forward)| {
            let id = edges.get(*edge).copied().unwrap_or_default();
            entities.add(&format!("ORIENTED_EDGE('',*,*,#{id},{})", logical(*is_forward)))
        })
        .collect();
    let outline = entities.add(&format!("EDGE_LOOP('',{})", references(&sides)));
    let bound = entities.add(&format!("FACE_OUTER_BOUND('',#{outline},.T.)"));
    let surface = surface(entities, face);
    let same_sense = logical(!oriented.is_reversed);
    entities.add(&format!("ADVANCED_FACE({},(#{bound}),#{surface},{same_sense})", string(&face.name)))
}

fn surface(entities: &mut Entities, face: &Face) -> Id {
    let [u, v] = face.surface.knots();
    let rows: Vec<String> = face.surface.rows().map(|row| entities.points(row)).collect();
    let closes_in_u = face.surface.rows().next() == face.surface.rows().next_back();
    let closes_in_v = face.surface.rows().all(|row| row.first() == row.last());
    entities.add(&format!(
        "B_SPLINE_SURFACE_WITH_KNOTS({},{},{},{},.UNSPECIFIED.,{},{},.F.,{},{},{},{},.UNSPECIFIED.)",
        string(&face.name),
        u.degree(),
        v.degree(),
        list(rows.into_iter()),
        logical(closes_in_u),
        logical(closes_in_v),
        multiplicities(u),
        multiplicities(v),
        values(u),
        values(v),
    ))
}

fn multiplicities(knots: &KnotVector) -> String {
    list(knots.multiplicities().into_iter().map(|(_, count)| count.to_string()))
}

fn values(knots: &KnotVector) -> String {
    list(knots.multiplicities().into_iter().map(|(knot, _)| real(knot)))
}

fn logical(is_true: bool) -> &'static str {
    if is_true { ".T." } else { ".F." }
}
