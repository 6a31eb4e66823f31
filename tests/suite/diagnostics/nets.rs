//! Bad nets with what must be said about them.

use trimline::diagnostic::Code::*;

use super::table::{Row, Spec::Whole};

#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    (Whole("bspline b {\n}"), NetSize, "1:9", "b", "write `net n x m`"),
    (Whole("bspline b {\nnet 2 x 5 from [i, j, 0]\n}"), NetSize, "2:5", "2 x 5", "n + 1 points in u"),
    (Whole("bspline b {\nnet 5 x 99999999999999999999 from [i, j, 0]\n}"), LimitReached, "2:5", "5 x 99999999999999999999", "`control-points`"),
    (Whole("bspline b {\nnet 5 x 5 from [i, j, 0]\nnet 5 x 5 from [i, j, 0]\n}"), DuplicateStatement, "3:1", "net 5 x 5 from [i, j, 0]", "first stated here"),
    (Whole("bspline b {\nnet 5 x 5\n}"), MissingConstraint, "1:9", "b", "i = 0, i = 1, i = n, j = 0, j = 1, j = m"),
    (Whole("bspline b {\nnet 5 x 5\nlayer i = 2: [0, j, 0]\n}"), NetSize, "3:11", "2", "i = 2 is no layer: those are i = 0, 1 and n = 5"),
    (Whole("bspline b {\nnet 5 x 5 from [i, j, 0]\nlayer i = 0: [0, j, 0]\n}"), DuplicateStatement, "3:7", "i", "leave out either"),
    (Whole("bspline b {\nnet 3 x 3\nlayer i = 0: [0, j, 0]\nlayer i = 1: [1, j, 0]\nlayer i = n: [3, j, 0]\nlayer j = 0: [i, 0, 0]\nlayer j = 1: [i, 1, i]\nlayer j = m: [i, 3, 0]\n}"), LayersDisagree, "4:14", "[1, j, 0]", "P(1, 1) two places, 1.0e0 apart: [1, 1, 0] and [1, 1, 1]"),
    (Whole("bspline b {\nnet 5 x 5 from [1/(i - 1), j, 0]\n}"), PointNotFinite, "2:16", "[1/(i - 1), j, 0]", "P(1, 0) is [inf, 0, 0]"),
    (Whole("bspline b {\nknots [0, 0, 0, 0, 1, 1, 2, 2, 2, 2] in u\nnet 5 x 5 from [i, j, 0]\n}"), KnotRepeated, "2:7", "[0, 0, 0, 0, 1, 1, 2, 2, 2, 2]", "the knot 1 of u stands 2 times"),
    (Whole("bspline b {\nknots [0, 0, 0, 0, 2, 1, 3, 3, 3, 3] in v\nnet 5 x 5 from [i, j, 0]\n}"), KnotsNotAscending, "2:7", "[0, 0, 0, 0, 2, 1, 3, 3, 3, 3]", "the knots descend from 2 to 1 at number 5"),
    (Whole("bspline b {\nknots [0, 0, 0, 0, 1, 1] in v\nnet 5 x 5 from [i, j, 0]\n}"), NetSize, "2:7", "[0, 0, 0, 0, 1, 1]", "6 knots are given, and m = 5 takes 10"),
    (Whole("bspline b {\nknots [0, 0, 0, 0, 0, 0, 0, 0] in u\nnet 3 x 5 from [i, j, 0]\n}"), KnotsNotAscending, "2:7", "[0, 0, 0, 0, 0, 0, 0, 0]", "the domain of a net"),
    (Whole("bspline b {\nknots open in u\nnet 5 x 5 from [i, j, 0]\n}"), UnknownName, "2:7", "open", "`uniform`, `clamped` or a list"),
    (Whole("bspline b {\nknots clamped in t\nnet 5 x 5 from [i, j, 0]\n}"), UnknownName, "2:18", "t", "knots in u and in v"),
    (Whole("bspline b {\nknots clamped in u, uniform in u\nnet 5 x 5 from [i, j, 0]\n}"), DuplicateStatement, "2:32", "u", "first stated here"),
    (Whole("bspline b {\nknots [0, 0, 0, 0, i, 2, 2, 2, 2] in u\nnet 4 x 5 from [i, j, 0]\n}"), UnknownName, "2:20", "i", "unknown name `i`"),
    (Whole("bspline b {\ndomain u in [0, 1]\nknots [0, 0, 0, 0, 1, 2, 2, 2, 2] in u\nnet 4 x 5 from [i, j, 0]\n}"), DuplicateStatement, "2:8", "u", "leave out this range"),
    (Whole("bspline b {\nnet 5 x 5 from surface X sampled greville\n}"), UnknownName, "2:24", "X", "unknown name `X`"),
    (Whole("bspline b {\nnet 5 x 5 from points(2)\n}"), UnexpectedText, "2:22", "(2)", "a data file is named by one text in quotes"),
    (Whole("bspline b {\nnet 5 x 5 from points(\"../net.csv\")\n}"), DataFileMissing, "2:23", "\"../net.csv\"", "in the folder of the spec"),
    (Whole("surface X(u, v) = [u, v, 0]\nbspline b {\nnet 5 x 5 from surface X sampled evenly\n}"), UnknownName, "3:34", "evenly", "`sampled uniform`"),
    (Whole("param i = 1\nbspline b {\nnet 5 x 5 from [i, j, 0]\n}"), DuplicateName, "1:7", "i", "choose another name"),
    (Whole("bspline b {\nnet 5 x 5 from i + j\n}"), NotScalar, "2:16", "i + j", "write `[x, y, z]`"),
    (Whole("bspline b {\nnet 5 x 5 from [i, j, 0]\npde with γ = 2\n}"), UnexpectedText, "3:1", "pde with γ = 2", "its equation is ∂⁶S/∂u³∂v³ = 0"),
    (Whole("net 5 x 5"), UnexpectedText, "1:1", "net 5 x 5", "open one first: `bspline NAME {`"),
    (Whole("bspline b {\nnet 5 x 5 from [i, j, 0]\n}\nsolve fourier"), UnexpectedText, "4:7", "fourier", "by the method `mask`"),
    (Whole("bspline b {\nnet 5 x 5 from [i, j, 0]\n}\nbspline b {\nnet 5 x 5 from [i, j, 0]\n}"), DuplicateName, "4:9", "b", "first declared here"),
    (Whole("bspline b\nnet 5 x 5 from [i, j, 0]"), UnexpectedText, "1:10", "", "the statements of a bspline stand in braces"),
    (Whole("bspline b {\nnet 60 x 5 from [i, j, 0]\n}"), NetAmplifies, "2:5", "60 x 5", "magnifies changes of its boundary layers by up to 87 in u and 4 in v"),
];
