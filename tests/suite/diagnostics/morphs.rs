//! Bad `morph` statements with what must be said about them.

use trimline::diagnostic::Code::*;

use super::table::{Row, Spec::Whole};

/// A statement before three patches that could morph into each other.
macro_rules! before_patches {
    ($statement:literal) => {
        Whole(concat!(
            $statement,
            "\npatch p {\nat u = 0: S = [cos v, sin v, 0], dS/du = 0\nat u = 1: S = [cos v, sin v, 1], dS/du = 0\n}\n",
            "patch q {\nat u = 0: S = [cos v, sin v, 0], dS/du = 0\nat u = 1: S = [cos v, sin v, 2], dS/du = 0\n}\n",
            "patch r {\nat u = 0: S = [cos v, sin v, 0], dS/du = 0\nat u = 1: S = [cos v, sin v, 3], dS/du = 0\n}\n",
        ))
    };
}

#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    (before_patches!("morph from p to s"), UnknownName, "1:17", "s", "patches: p, q, r"),
    (before_patches!("morph from p to p"), ShapesDiffer, "1:12", "p to p", "the patch `p` would become itself"),
    (before_patches!("morph from p to q, r to p"), DuplicateStatement, "1:25", "p", "stands in the morph twice"),
    (before_patches!("morph from p to q\nmorph from q to r"), DuplicateStatement, "2:1", "morph from q to r", "pairs are separated by commas"),
    (before_patches!("morph from p to q by shape"), UnknownSetting, "1:22", "shape", "by boundary, modes or both"),
    (before_patches!("morph from p to q, frames = 3"), UnknownSetting, "1:20", "frames", "its setting: steps"),
    (before_patches!("morph from p to q, steps = 0"), UnknownSetting, "1:28", "0", "a whole number from 1"),
    (before_patches!("morph from p to q, steps = 3, steps = 4"), DuplicateStatement, "1:31", "steps", "`steps` is given twice"),
    (before_patches!("morph p to q"), UnexpectedText, "1:7", "p", "expected `from`"),
    (before_patches!("morph from p"), UnexpectedText, "1:13", "", "expected `to`"),
    (Whole("patch p {\nmorph from p to p\n}"), UnexpectedText, "2:12", "p", "a morph belongs to all patches"),
    (Whole("bspline b {\nmorph from p to q\n}"), UnexpectedText, "2:12", "p", "no place in a `bspline` block"),
];
