"""CAD files as other programs see them.

Usage: cad.py TRIMLINE_BINARY

Reads with gmsh (its own geometry kernel, and OpenCASCADE's) and with scipy what `trimline fit` writes, and compares
points with each other and with `trimline eval`. Needs gmsh, numpy and scipy. Prints what it measured; fails loudly.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import gmsh
import numpy
from scipy.interpolate import BSpline

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRIMLINE = sys.argv[1]

# An open patch beside the closed one of Eq. (19): v runs over less than a turn.
OPEN = """param r = 1.5
domain v in [0.25, 2]
at u = 0: S = [r cos v, r sin v, e^v], dS/du = [0, 0, -1]
at u = 1: S = [2 cos v, 2 sin v, 0], dS/du = [cos v, sin v, 0]
"""

# A cone-like cap: u = 1 is a point, whose edge is left out.
CAP = """at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]
at u = 1: S = [0, 0, 1], dS/du = [-cos v, -sin v, 0]
"""

# Loops of edges, whose patches meet with u of one along v of the next, and a net with a copy.
LOOPS = {
    "three": """nsided cap {
    edge [u, 0, 0.3u(1-u)]
    edge [1 - u/2, u, 0]
    edge [(1-u)/2, 1-u, 0.2 u (1 - u)]
}
""",
    "four": """nsided cap {
    edge [u, 0, -u^2 (1 - u)^2]
    edge [1, u, 0]
    edge [1 - u, 1, 0.2 u (1 - u)]
    edge [0, 1 - u, 0]
    centre = [0.5, 0.5, 0.3]
}
""",
    "mirrored": """bspline un { net 5 x 5 from [j (1 + 0.1 i), i (1 + 0.2 j), 0.4 sin(j) cos(i/2)] }
mirror un in y = 0
""",
}


def run(*arguments, stdin=None):
    done = subprocess.run([TRIMLINE, *map(str, arguments)], input=stdin, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def json_surface(path):
    (patch,) = json.loads(path.read_text())["patches"]
    net = numpy.array(patch["control_net"])
    knots = [numpy.array(patch["knots_u"]), numpy.array(patch["knots_v"])]
    degree = patch["degree"]

    def at(u, v):
        rows = BSpline(knots[0], net.transpose(0, 2, 1), degree[0])(u)  # 3 x columns
        return BSpline(knots[1], rows.T, degree[1])(v)

    domain = [(k[p], k[-p - 1]) for k, p in zip(knots, degree)]
    return at, domain, net.shape


def gmsh_surface(path):
    """Evaluates the only face of a file; also its kind and how many curves and points bound it."""
    gmsh.clear()
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    entities = gmsh.model.occ.importShapes(str(path), highestDimOnly=False)
    gmsh.model.occ.synchronize()
    faces = [tag for dimension, tag in entities if dimension == 2]
    assert len(faces) == 1, entities
    face = faces[0]
    low, high = gmsh.model.getParametrizationBounds(2, face)

    def at(u, v):
        return numpy.array(gmsh.model.getValue(2, face, [u, v]))

    counts = [len(gmsh.model.getEntities(dimension)) for dimension in (0, 1, 2)]
    return at, list(zip(low, high)), gmsh.model.getType(2, face), counts


def places(domain):
    return [
        [a + (b - a) * share for share in (0.0, 0.0713, 0.31, 0.5, 0.777, 0.93, 1.0)] for a, b in domain
    ]


def eval_points(spec, time, points):
    table = "u,v\n" + "".join(f"{float(u)!r},{float(v)!r}\n" for u, v in points)
    lines = run("eval", spec, "--points", "-", "--time", time, stdin=table).splitlines()[1:]
    return numpy.array([[float(x) for x in line.split(",")[2:5]] for line in lines])


def check(folder, name, spec, time, degree, tolerance, counts):
    options = ["--time", time, "--degree", degree, "--tolerance", tolerance, "--format", "json"]
    files = {}
    for key, extra in [("json", []), ("step", ["--schema", "ap214"]), ("stp", ["--schema", "ap242"]), ("igs", [])]:
        files[key] = folder / f"{name}.{key}"
        (report,) = json.loads(run("fit", spec, "-o", files[key], *options, *extra))["patches"]
    ours, domain, shape = json_surface(files["json"])
    assert list(shape[:2]) == report["control_points"], (shape, report)
    points = [(u, v) for u in places(domain)[0] for v in places(domain)[1]]
    fitted = numpy.array([ours(u, v) for u, v in points])
    size = numpy.abs(fitted).max()
    # What the fit claims, against the surface itself: the claim is a measurement, and points differ.
    deviation = numpy.linalg.norm(fitted - eval_points(spec, time, points), axis=1).max()
    assert deviation <= tolerance, (name, deviation)
    for key in ("step", "stp", "igs"):
        theirs, bounds, kind, found = gmsh_surface(files[key])
        assert kind == "BSpline surface", (name, key, kind)
        assert numpy.allclose(bounds, domain, rtol=0, atol=1e-12), (name, key, bounds, domain)
        error = max(numpy.abs(theirs(u, v) - point).max() for (u, v), point in zip(points, fitted))
        assert error <= 1e-12 * size, (name, key, error)
        # IGES has surfaces without edges of their own; a point for an edge is made anew by some readers.
        if key != "igs" and counts is not None:
            assert found == counts, (name, key, "points, curves, faces", found)
        print(f"{name}.{key}: {shape[0]} x {shape[1]} points, {kind}, read back to {error:.1e}, off the surface by {deviation:.1e}")


def seams(folder):
    """Patches inside curves, a ring of two, a net and its image: OpenCASCADE finds edges shared, which is one shell."""
    command = ["cargo", "run", "--quiet", "--example", "bspline_nets", "--", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    for name, text in LOOPS.items():
        (folder / f"{name}.trim").write_text(text)
        run("fit", folder / f"{name}.trim", "-o", folder / f"{name}.step")
    # Of four patches in a square 4 of 12 edges are seams; of two in a ring 2 of 6; of n in a loop n of 3n; of a net and
    # its mirror image 1 of 7.
    expected = [("square", 4, 4, 8), ("vase", 2, 2, 4), ("three", 3, 3, 6), ("four", 4, 4, 8), ("mirrored", 2, 1, 6)]
    for name, faces, shared, free in expected:
        gmsh.clear()
        gmsh.model.occ.importShapes(str(folder / f"{name}.step"), highestDimOnly=False)
        gmsh.model.occ.synchronize()
        curves = [set(gmsh.model.getAdjacencies(1, tag)[0]) for _, tag in gmsh.model.getEntities(1)]
        counts = [len(gmsh.model.getEntities(2)), sum(len(c) == 2 for c in curves), sum(len(c) == 1 for c in curves)]
        assert counts == [faces, shared, free], (name, "faces, seams, free edges", counts)
        reached = {min(curves[0])}
        for _ in curves:
            reached |= set().union(*(c for c in curves if c & reached))
        assert len(reached) == faces, (name, "faces in one shell", len(reached))
        print(f"{name}.step: {faces} faces in one shell, {shared} seams, {free} free edges")


def fit_by_their_own_evaluation(folder):
    """The fit of Eq. (19) at t = 0.2, evaluated by OpenCASCADE, against the surface itself."""
    spec, path = ROOT / "examples/eq19.trim", folder / "confirmed.step"
    run("fit", spec, "-o", path, "--time", 0.2, "--tolerance", 1e-6)
    theirs, bounds, _, _ = gmsh_surface(path)
    grid = [numpy.linspace(low, high, count) for (low, high), count in zip(bounds, (61, 131))]
    points = [(float(u), float(v)) for u in grid[0] for v in grid[1]]
    found = numpy.array([theirs(u, v) for u, v in points])
    deviation = numpy.linalg.norm(found - eval_points(spec, 0.2, points), axis=1).max()
    assert 1e-8 < deviation <= 1e-6, deviation
    print(f"eq19 to 1e-6: off by {deviation:.2e} at {len(points)} points, by OpenCASCADE's evaluation")


def main():
    gmsh.initialize(["", "-v", "1"])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for stem, text in [("open", OPEN), ("cap", CAP)]:
            (folder / f"{stem}.trim").write_text(text)
        # A ring has two closed edges and its seam; an open patch four; a cap one closed edge and its seam.
        for degree in (3, 4, 5):
            check(folder, f"eq19_{degree}", ROOT / "examples/eq19.trim", 0.2, degree, 1e-6, [2, 3, 1])
            check(folder, f"open_{degree}", folder / "open.trim", 0, degree, 1e-7, [4, 4, 1])
        check(folder, "cap", folder / "cap.trim", 0, 3, 1e-5, None)
        seams(folder)
        fit_by_their_own_evaluation(folder)
    gmsh.finalize()
    print("CAD files: all read back")


main()
