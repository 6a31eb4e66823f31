use super::*;
use crate::diagnostic::Source;
use crate::expr::Notation;
#[test]
fn play() {
    for f in std::fs::read_dir("examples").unwrap() {
        let f = f.unwrap().path();
        if f.extension() != Some("trim".as_ref()) {
            continue;
        }
        let l = Limits::default();
        let s = Source::new("x", std::fs::read_to_string(&f).unwrap());
        let d = crate::syntax::parse(&s, &l).unwrap();
        let p = crate::resolve::resolve(&d, "x", &l).unwrap();
        let dec = decompose(&p, &p.patches[0], &l).unwrap();
        println!("{f:?}\n{}", dec.to_text(Notation::Unicode, &l).unwrap());
    }
}
