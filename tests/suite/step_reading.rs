//! STEP files read: what is written comes back, forms of other programs, and files that hold nothing to read.

use trimline::diagnostic::Code;
use trimline::export::{CadFormat, Face, Schema, write_cad};
use trimline::limits::Limits;
use trimline::surface::BsplineSurface;
use trimline::surface::bspline::from_step;

use crate::bspline::{random_knots, random_points};

fn surface(seed: u64) -> BsplineSurface {
    let (u, v) = (random_knots(seed, 3, 6), random_knots(seed + 1, 2, 5));
    BsplineSurface::new(u, v, random_points(seed, 30)).expect("a surface").clamped()
}

fn written(faces: &[Face], schema: Schema) -> String {
    let mut bytes = Vec::new();
    write_cad("model", faces, CadFormat::Step(schema), &mut bytes).expect("a file");
    String::from_utf8(bytes).expect("a text")
}

fn read(text: &str) -> Vec<(String, BsplineSurface)> {
    from_step(text, &Limits::default()).unwrap_or_else(|finding| panic!("{text}\n{finding}"))
}

#[test]
fn surfaces_that_are_written_come_back_bit_for_bit_in_both_schemas() {
    let faces: Vec<Face> =
        [10, 20].map(|seed| Face { name: format!("it's {seed}"), surface: surface(seed) }).into_iter().collect();
    for schema in [Schema::Ap214, Schema::Ap242] {
        let found = read(&written(&faces, schema));
        assert_eq!(found.len(), 2);
        for ((_, found), face) in found.iter().zip(&faces) {
            assert_eq!(found, &face.surface);
        }
    }
}

/// A bilinear face as other programs write it: numbers of any order, a comment, a complex instance, no blanks.
const COMPLEX: &str = "ISO-10303-21;
HEADER;FILE_DESCRIPTION(('a; b #1=X()'),'2;1');ENDSEC;
DATA;
/* points; first */ #4=CARTESIAN_POINT('',(1.E0,1.,-2.5E-1));
#1=CARTESIAN_POINT('',(0.,0.,0.));#2 = CARTESIAN_POINT ( '' , ( 0. , 1. , 0. ) ) ;
#3=CARTESIAN_POINT('',(1.,0.,0.));
#9=(BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,((#1,#2),(#3,#4)),.UNSPECIFIED.,.F.,.F.,.F.)
B_SPLINE_SURFACE_WITH_KNOTS((2,2),(2,2),(0.,1.),(0.,2.),.UNSPECIFIED.)
GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,1.),(1.,1.)))
REPRESENTATION_ITEM('face ''one''')SURFACE());
ENDSEC;
END-ISO-10303-21;
";

#[test]
fn complex_instance_with_equal_weights_is_read() {
    let found = read(COMPLEX);
    let [(name, surface)] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(name, "face 'one'");
    assert_eq!(surface.net(), [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, -0.25]]);
    assert_eq!(surface.knots()[1].as_slice(), [0.0, 0.0, 2.0, 2.0]);
}

#[test]
fn files_without_a_surface_to_read_are_refused_with_the_reason() {
    let changed = |from: &str, to: &str| {
        assert!(COMPLEX.contains(from), "{from}");
        COMPLEX.replace(from, to)
    };
    for (text, code, words) in [
        ("{\"patches\":[]}".to_owned(), Code::BadSplineFile, "does not begin with ISO-10303-21"),
        (changed("#9=", "#x9="), Code::BadSplineFile, "no face on a B-spline surface"),
        (changed("B_SPLINE_SURFACE_WITH_KNOTS", "PLANE"), Code::BadSplineFile, "no face on a B-spline surface"),
        (
            changed("((1.,1.),(1.,1.))", "((1.,1.),(1.,0.5))"),
            Code::BadSplineFile,
            "#9: the B-spline surface is rational",
        ),
        (
            changed("((1.,1.),(1.,1.))", "((0.,0.),(0.,0.))"),
            Code::BadSplineFile,
            "#9: a weight of the B-spline surface is 0",
        ),
        (changed("((1.,1.),(1.,1.))", "((-1.,-1.),(-1.,-1.))"), Code::BadSplineFile, "surface is -1, and not positive"),
        (
            changed("((1.,1.),(1.,1.))", "((1.,1.),(1.))"),
            Code::BadSplineFile,
            "#9: the B-spline surface has 4 control points and 3 weights",
        ),
        (changed("ENDSEC;\nEND-ISO-10303-21;", ""), Code::BadSplineFile, "ends behind #9, before its END-ISO-10303-21"),
        (changed("#2 =", "#1 ="), Code::BadSplineFile, "two instances #1"),
        (changed("#4=", "#5="), Code::BadSplineFile, "#9: the control point #4 is not in the file"),
        (changed("(1.,0.,0.)", "(1.,0.)"), Code::BadSplineFile, "#9: #3 is no point with three coordinates"),
        (changed("(1.,0.,0.)", "(1.,1.E999,0.)"), Code::PointNotFinite, "#9: the control point"),
        (changed("(#3,#4)", "(#3)"), Code::NetSize, "#9: row 1 of the net has 1 points"),
        (changed("(0.,2.)", "(2.,0.)"), Code::KnotsNotAscending, "#9: the knots descend"),
        (changed("(0.,2.)", "(0.,2.,3.)"), Code::BadSplineFile, "#9: knots and their multiplicities"),
        (changed("(2,2),(2,2)", "(2,2),(2,2000000)"), Code::BadSplineFile, "has the multiplicity 2000000"),
        (changed("(1,1,((", "(1,1.5,(("), Code::BadSplineFile, "#9: the degree"),
        (changed("(1,1,((", "(1,9,(("), Code::KnotsNotAscending, "#9: the degree of a B-spline is 9"),
    ] {
        let found = from_step(&text, &Limits::default()).expect_err(words);
        assert_eq!(found.code, code, "{found}");
        assert!(found.message.contains(words), "{words}: {found}");
    }
    let few = Limits { control_points: 3, ..Limits::default() };
    assert_eq!(from_step(COMPLEX, &few).expect_err("four points").code, Code::LimitReached);
}

#[test]
fn every_prefix_and_every_missing_letter_of_a_file_is_answered() {
    for end in 0..COMPLEX.len() {
        let _ = from_step(&COMPLEX[..end], &Limits::default());
        let _ = from_step(&format!("{}{}", &COMPLEX[..end], &COMPLEX[end + 1..]), &Limits::default());
    }
    let deep = COMPLEX.replace("((#1", &format!("{}(#1", "(".repeat(100_000)));
    assert!(from_step(&deep, &Limits::default()).is_err());
}
