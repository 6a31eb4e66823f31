"""Reads the files that trimline writes with other people's readers, and compares them with `trimline eval`.

Usage: check_files.py TRIMLINE EXAMPLES. Prints a line for each thing checked; the first that fails ends it.
"""

import csv
import io
import json
import math
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

import lib3mf
import meshio
import numpy as np
import trimesh
from PIL import Image
from pxr import Sdf, Usd, UsdGeom, UsdValidation
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

HERE = pathlib.Path(__file__).parent

# Evaluation on a grid and at points round differently: some hundred roundings of numbers of size 10.
DOUBLE = 1e-13
# Half a unit in the last place of a 32-bit float is 6e-8 of the number; a difference that is added, as much again.
SINGLE = 1.3e-7
# A player's clock is in single precision too: frame times are off by half a unit, 3e-8 of the duration, which is 1e-6 of
# the way between two of 25 frames; frames differ by less than the surface is large.
PLAYED = 2e-6


class Case:
    """A patch with its grid and instants, and what `trimline eval` says about it: that named, or the only one."""

    def __init__(self, trimline, spec, folder, grid, frames, v_range, t_range, is_closed, u_range=(0, 1), patch=None):
        self.trimline, self.spec, self.folder, self.frames, self.is_closed = trimline, spec, folder, frames, is_closed
        self.name, self.grid, self.chosen = patch or spec.stem, grid, ["--patch", patch] if patch else []
        rows, columns = grid[0] + 1, grid[1] + (0 if is_closed else 1)
        self.rows, self.columns = rows, columns
        self.u = np.linspace(*u_range, rows)
        self.v = np.linspace(*v_range, grid[1] + 1)[:columns]
        self.t = np.linspace(*t_range, frames)
        self.vertices, self.quads = rows * columns, grid[0] * grid[1]
        self.positions, self.tangents_u, self.tangents_v = self.evaluate()

    def evaluate(self):
        points = io.StringIO()
        writer = csv.writer(points)
        writer.writerow("uvt")
        for t in self.t:
            writer.writerows((repr(float(u)), repr(float(v)), repr(float(t))) for u in self.u for v in self.v)
        found = self.run("eval", "--points", "-", "--derivatives", "u,v", *self.chosen, input=points.getvalue())
        table = np.array([[float(x) for x in row] for row in list(csv.reader(io.StringIO(found)))[1:]])
        table = table.reshape(self.frames, self.vertices, -1)
        return table[..., 3:6], table[..., 6:9], table[..., 9:12]

    def run(self, command, *options, input=None):
        arguments = [self.trimline, command, str(self.spec), *options]
        done = subprocess.run(arguments, input=input, capture_output=True, text=True)
        assert done.returncode == 0, f"{' '.join(arguments)}\n{done.stderr}"
        return done.stdout

    def mesh(self, name, *options):
        path = self.folder / name
        self.run("mesh", "-o", str(path), "--grid", "x".join(map(str, self.grid)), "--quiet", *options)
        return path

    def animation(self, extension):
        return self.mesh(f"{self.name}.{extension}", "--frames", str(self.frames))

    def still(self, extension, *options):
        return self.mesh(f"{self.name}.{extension}", *options)

    def normals(self):
        """Unit normals; at poles, where there are none from these tangents, NaN."""
        normal = np.cross(self.tangents_u, self.tangents_v)
        length = np.linalg.norm(normal, axis=-1, keepdims=True)
        return np.where(length > 1e-9, normal / np.maximum(length, 1e-300), np.nan)


def near(found, expected, tolerance, what):
    found, expected = np.asarray(found, float), np.asarray(expected, float)
    assert found.shape == expected.shape, f"{what}: {found.shape} instead of {expected.shape}"
    known = np.isfinite(expected)
    error = np.abs(found - expected)[known].max(initial=0)
    size = np.abs(expected)[known].max(initial=1)
    assert error <= tolerance * size and known.any(), f"{what}: off by {error:.1e} of {size:.1e}"


def equal(found, expected, what):
    assert found == expected, f"{what}: {found} instead of {expected}"


def read_glb(path):
    reader = ["node", str(HERE / "read_glb.js"), str(path)]
    found = json.loads(subprocess.run(reader, check=True, capture_output=True, text=True).stdout)
    equal((found["issues"]["numErrors"], found["issues"]["numWarnings"]), (0, 0), f"validator: {found['issues']}")
    return found


def glb(case):
    found = read_glb(case.animation("glb"))
    equal(found["info"]["totalVertexCount"], case.vertices, "vertices")
    near(found["times"], case.t, SINGLE, "times")
    near(found["extras"].get("t", found["times"]), case.t, DOUBLE, "instants")
    equal((found["channels"], found["interpolation"]), (["weights"], "LINEAR"), "animation")
    [mesh] = found["meshes"]
    equal((mesh["name"], mesh["triangles"]), (case.name, 2 * case.quads), "mesh")
    equal(mesh["matrix"], np.eye(4).flatten().tolist(), "placement")
    near(np.reshape(mesh["positions"], case.positions.shape), case.positions, SINGLE, "positions")
    near(np.reshape(mesh["normals"], case.positions.shape), case.normals(), SINGLE, "normals")


def glb_played(case):
    """The animation as three.js plays it: at every instant, and half-way between two, where it blends them."""
    path = case.animation("glb")
    seconds = [float(t - case.t[0]) for t in case.t]
    between = [(a + b) / 2 for a, b in zip(seconds, seconds[1:])]
    player = ["node", str(HERE / "play_glb.js"), str(path), *map(repr, [*seconds, *between])]
    found = json.loads(subprocess.run(player, check=True, capture_output=True, text=True).stdout)
    equal((found["names"], found["clips"]), ([re.sub(r"\s", "_", case.name)], 1), "meshes and animations")
    near(found["duration"], seconds[-1], SINGLE, "duration")
    frames = np.array(found["frames"])[:, 0]
    near(frames[: case.frames], case.positions, PLAYED, "positions")
    near(frames[case.frames :], (case.positions[1:] + case.positions[:-1]) / 2, PLAYED, "positions half-way")


def glb_still(case):
    [mesh] = trimesh.load(case.still("glb"), process=False).geometry.values()
    near(mesh.vertices, case.positions[0], SINGLE, "positions")
    equal(len(mesh.faces), 2 * case.quads, "triangles")


def read_usd(path):
    """The stage and its meshes."""
    stage = Usd.Stage.Open(str(path))
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    assert len(validators) > 10 and not errors, [error.GetMessage() for error in errors]
    return stage, [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]


def usd(case):
    stage, [mesh] = read_usd(case.animation("usda"))
    codes = list(range(case.frames))
    equal((stage.GetStartTimeCode(), stage.GetEndTimeCode()), (0, case.frames - 1), "range of time codes")
    rate = stage.GetTimeCodesPerSecond()
    near([case.t[0] + code / rate for code in codes], case.t, DOUBLE, "times")
    instants = stage.GetDefaultPrim().GetAttribute("trimline:t")
    equal(instants.GetTypeName(), Sdf.ValueTypeNames.Double, "type of the instants")
    near([instants.Get(code) for code in codes], case.t, DOUBLE, "instants")
    equal(mesh.GetPointsAttr().GetTimeSamples(), codes, "samples")
    near([mesh.GetPointsAttr().Get(code) for code in codes], case.positions, SINGLE, "positions")
    near([mesh.GetNormalsAttr().Get(code) for code in codes], case.normals(), SINGLE, "normals")
    equal(list(mesh.GetFaceVertexCountsAttr().Get()), [4] * case.quads, "quads")
    equal(mesh.GetPrim().GetDisplayName(), case.name, "name")
    for code in codes:
        extent = [case.positions[code].min(0), case.positions[code].max(0)]
        near(mesh.GetExtentAttr().Get(code), extent, SINGLE, "extent")


def npz(case):
    found = np.load(case.animation("npz"))
    shape = (case.frames, case.rows, case.columns, 3)
    near(found["positions"], case.positions.reshape(shape), DOUBLE, "positions")
    near(found["derivative_u"], case.tangents_u.reshape(shape), DOUBLE, "derivative in u")
    near(found["derivative_v"], case.tangents_v.reshape(shape), DOUBLE, "derivative in v")
    for name, expected in [("u", case.u), ("v", case.v), ("t", case.t)]:
        near(found[name], expected, DOUBLE, name)


def read_vtp(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()


def vtp(case):
    frames = case.mesh(f"{case.name}.vtp", "--frames", str(case.frames), "--fields", "curvature,residual")
    series = xml.parse(frames.with_suffix(".pvd")).findall("Collection/DataSet")
    near([float(entry.get("timestep")) for entry in series], case.t, DOUBLE, "times")
    for frame, entry in enumerate(series):
        data = read_vtp(case.folder / entry.get("file"))
        equal((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (case.vertices, case.quads), "counts")
        near(vtk_to_numpy(data.GetPoints().GetData()), case.positions[frame], DOUBLE, "positions")
        arrays = data.GetPointData()
        near(vtk_to_numpy(arrays.GetArray("normals")), case.normals()[frame], 1e-9, "normals")
        near(vtk_to_numpy(arrays.GetArray("derivative_u")), case.tangents_u[frame], DOUBLE, "derivative in u")
        near(data.GetFieldData().GetArray("TimeValue").GetValue(0), case.t[frame], DOUBLE, "TimeValue")
        equal(data.GetFieldData().GetAbstractArray("patches").GetValue(0), case.name, "name")
        for name in ["gaussian_curvature", "mean_curvature", "residual"]:
            equal(arrays.GetArray(name).GetNumberOfTuples(), case.vertices, name)
        equal(set(vtk_to_numpy(data.GetCellData().GetArray("patch"))), {0}, "patch")


def threemf(case):
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(case.still("3mf")))
    equal(reader.GetWarningCount(), 0, "warnings")
    objects = model.GetMeshObjects()
    equal(objects.Count(), 1, "objects")
    assert objects.MoveNext()
    mesh = objects.GetCurrentMeshObject()
    equal((mesh.GetName(), mesh.GetTriangleCount()), (case.name, 2 * case.quads), "mesh")
    near([list(vertex.Coordinates) for vertex in mesh.GetVertices()], case.positions[0], SINGLE, "positions")
    equal(model.GetBuildItems().Count(), 1, "items to build")


def ply(case):
    path = case.still("ply", "--fields", "curvature,residual")
    found = meshio.read(path)
    near(found.points, case.positions[0], DOUBLE, "positions")
    equal(found.cells_dict["quad"].shape, (case.quads, 4), "quads")
    grid_u, grid_v = np.meshgrid(case.u, case.v, indexing="ij")
    near(found.point_data["u"], grid_u.flatten(), DOUBLE, "u")
    near(found.point_data["v"], grid_v.flatten(), DOUBLE, "v")
    assert {"gaussian_curvature", "mean_curvature", "residual"} <= set(found.point_data)
    near(trimesh.load(path, process=False).vertices, case.positions[0], DOUBLE, "positions of the second reader")


def obj(case):
    found = meshio.read(case.still("obj"))
    near(found.points, case.positions[0], DOUBLE, "positions")
    equal(found.cells_dict["quad"].shape, (case.quads, 4), "quads")


def stl(case):
    found = trimesh.load(case.still("stl"))
    equal(len(found.faces), 2 * case.quads, "triangles")
    # The reader merges equal corners, so vertices have no order.
    distances = np.linalg.norm(case.positions[0][:, None] - found.vertices[None], axis=-1)
    near(distances.min(axis=1), np.zeros(case.vertices), SINGLE * np.abs(case.positions[0]).max(), "positions")
    near(distances.min(axis=0), np.zeros(len(found.vertices)), SINGLE * np.abs(case.positions[0]).max(), "vertices")


def pictures(case):
    def draw(name, *options):
        path = case.folder / name
        case.run("render", "-o", str(path), "--size", "80x60", "--quiet", *options)
        return Image.open(path)

    still = draw("still.png", "--shade", "zebra", "--lines", "4x8")
    equal((still.size, still.mode, getattr(still, "n_frames", 1)), ((80, 60), "RGB", 1), "picture")
    corner, middle = still.getpixel((0, 0)), still.getpixel((40, 30))
    assert corner == (255, 255, 255) != middle, f"colours {corner} and {middle}"
    equal(draw("sheet.png", "--frames", "5").size, (3 * 81 - 1, 2 * 61 - 1), "sheet")
    for name, duration in [("moving.png", 50.0), ("moving.gif", 50)]:
        moving = draw(name, "--animate", "--frames", "4", "--fps", "20")
        equal((moving.size, moving.n_frames, moving.info["loop"]), ((80, 60), 4, 0), name)
        moving.seek(3)
        equal(moving.info["duration"], duration, f"duration in {name}")


def objects_of_glb(patches, path):
    found = read_glb(path)
    meshes = [(mesh["name"], mesh["triangles"], mesh["positions"]) for mesh in found["meshes"]]
    for patch, (name, triangles, positions) in zip(patches, meshes, strict=True):
        equal((name, triangles), (patch.name, 2 * patch.quads), "mesh")
        near(np.reshape(positions, patch.positions.shape), patch.positions, SINGLE, name)


def objects_of_usd(patches, path):
    _, meshes = read_usd(path)
    for patch, mesh in zip(patches, meshes, strict=True):
        equal(mesh.GetPrim().GetDisplayName() or mesh.GetPrim().GetName(), patch.name, "name")
        found = [mesh.GetPointsAttr().Get(code) for code in range(patch.frames)]
        near(found, patch.positions, SINGLE, patch.name)


def objects_of_obj(patches, path):
    found = trimesh.load(path, process=False, maintain_order=True, split_objects=True).geometry
    equal(sorted(found), sorted(patch.name for patch in patches), "names")
    for patch in patches:
        mesh = found[patch.name]
        equal(len(mesh.faces), 2 * patch.quads, "triangles")
        # The reader may keep the vertices of all objects for each; those of its faces are its own, in some order.
        corners = mesh.vertices[np.unique(mesh.faces)]
        distances = np.linalg.norm(patch.positions[0][:, None] - corners[None], axis=-1)
        for axis in (0, 1):
            near(distances.min(axis=axis), np.zeros(distances.shape[1 - axis]), DOUBLE, patch.name)


def objects_of_vtp(patches, path):
    data = read_vtp(path)
    names = data.GetFieldData().GetAbstractArray("patches")
    equal([names.GetValue(k) for k in range(names.GetNumberOfValues())], [patch.name for patch in patches], "names")
    cells = vtk_to_numpy(data.GetCellData().GetArray("patch"))
    near(cells, np.repeat(range(len(patches)), [patch.quads for patch in patches]), DOUBLE, "patch of each cell")
    positions = np.concatenate([patch.positions[0] for patch in patches])
    near(vtk_to_numpy(data.GetPoints().GetData()), positions, DOUBLE, "positions")


def several_patches(trimline, spec, folder):
    """Each patch of a spec is an object of its own, with its name, in every format that has objects."""
    ranges = [("bowl", (0, 1)), ("stem", (1, 2)), ("foot", (2, 3))]
    patches = [
        Case(trimline, spec, folder, (5, 12), 3, (0, 2 * math.pi), (0, 1), True, u_range, name)
        for name, u_range in ranges
    ]
    readers = [("glb", objects_of_glb), ("usda", objects_of_usd), ("obj", objects_of_obj), ("vtp", objects_of_vtp)]
    for extension, read in readers:
        frames = ["--frames", "3"] if extension in ("glb", "usda") else []
        yield read.__name__, lambda: read(patches, patches[0].mesh(f"{spec.stem}.{extension}", *frames))


def seconds_and_said(trimline, spec, folder, frames, stderr):
    """Draws an animation; how long that took, and what was written to `stderr`, a pair of ends, the command's second."""
    ours, its = stderr
    arguments = [trimline, "render", str(spec), "-o", str(folder / "moving.gif"), "--animate", "--size", "80x60"]
    began = time.monotonic()
    with subprocess.Popen([*arguments, "--frames", str(frames)], stderr=its) as command:
        os.close(its)
        said = b""
        while True:
            try:
                part = os.read(ours, 65536)
            except OSError:  # A terminal whose other end is closed.
                break
            if not part:
                break
            said += part
    os.close(ours)
    equal(command.returncode, 0, "status")
    return time.monotonic() - began, said.decode()


def progress(trimline, spec, folder):
    """A bar is drawn on a terminal, and only there, when the work takes longer than a second."""
    bar = "\N{FULL BLOCK}"
    seconds, said = seconds_and_said(trimline, spec, folder, 2, pty.openpty())
    assert "2 frames" in said and (bar not in said or seconds > 1), said
    seconds, frames = 0, 50
    while seconds < 2.5:
        frames *= 2
        seconds, said = seconds_and_said(trimline, spec, folder, frames, pty.openpty())
    assert bar in said and f"/{frames} frames" in said, said
    _, said = seconds_and_said(trimline, spec, folder, frames, os.pipe())
    assert bar not in said and f"{frames} frames" in said, said


def main(trimline, examples):
    examples = pathlib.Path(examples)
    readers = [glb, glb_played, glb_still, usd, npz, vtp, threemf, ply, obj, stl, pictures]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        # A name that is neither ASCII nor a word.
        odd = folder / "Größe α & 'β' 2.trim"
        shutil.copy(examples / "eq19.trim", odd)
        cases = [
            ("eq31_32", examples / "eq31_32.trim", (16, 32), 25, (0, 2 * math.pi), (0, 1), True),
            ("p1_ex3", examples / "p1_ex3.trim", (6, 9), 1, (0, 2 * math.pi), (0, 1), False),
            ("odd name", odd, (4, 7), 3, (0, 2 * math.pi), (0, 0.3), True),
        ]
        for label, spec, grid, frames, v_range, t_range, is_closed in cases:
            case = Case(trimline, spec, folder, grid, frames, v_range, t_range, is_closed)
            for reader in readers:
                if reader in (glb, glb_played, usd) and frames == 1:
                    continue
                report(label, reader.__name__, lambda: reader(case))
        report("eq31_32", "progress", lambda: progress(trimline, examples / "eq31_32.trim", folder))
        for name, check in several_patches(trimline, examples / "eq24.trim", folder):
            report("eq24", name, check)


def report(label, name, check):
    try:
        check()
    except (AssertionError, ValueError) as error:
        sys.exit(f"{label}: {name}: {error}")
    print(f"{label}: {name} ok")


main(*sys.argv[1:])
