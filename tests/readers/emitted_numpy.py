#!/usr/bin/env python3
"""Emitted NumPy code gives the surface that `trimline eval` gives, on every example.

usage: emitted_numpy.py BINARY      (needs numpy)
"""

import itertools
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np

BINARY = pathlib.Path(sys.argv[1]).resolve()
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


def trimline(*arguments, text=""):
    done = subprocess.run([BINARY, *map(str, arguments), "--quiet"], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"trimline {arguments}: {done.stderr}")
    return done.stdout


def parts_of(spec):
    """The names of all patches, nets and copies, as `emit` lists them; a spec with one part needs no name."""
    done = subprocess.run([BINARY, "emit", spec, "--lang", "numpy"], capture_output=True, text=True)
    listed = re.search(r"; patches: (.*)", done.stderr)
    return listed.group(1).split(", ") if listed else [None]


def emitted(spec, time, options):
    """The source text and what had to be allowed for it: `emit` refuses patches that are no sums of products or too
    steep for series, and only them, without `--within`."""
    arguments = ["emit", spec, "--lang", "numpy", "--time", time, *options]
    done = subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode == 0:
        return done.stdout, []
    assert "--within" in done.stderr, done.stderr
    within = ["--within", str(WITHIN)]
    return trimline(*arguments, *within), within


def deviations(spec, text, time, options):
    """The largest differences of S, S_u and S_v at random points, over the largest coordinate of each."""
    names = {}
    exec(compile(text, spec.name, "exec"), names)
    [surface] = [value for name, value in names.items() if name.endswith("_surface")]
    ranges = re.search(r"for u in \[(\S+), (\S+)\], v in \[(\S+), (\S+)\]", text).groups()
    low, high, first, last = map(float, ranges)
    chance = np.random.default_rng(20121)
    u, v = low + (high - low) * np.r_[0.0, 1.0, chance.random(30)], first + (last - first) * np.r_[0.0, 1.0, chance.random(30)]
    takes_time = surface.__code__.co_argcount == 3
    found = surface(u, v, time) if takes_time else surface(u, v)
    rows = "\n".join(f"{a!r},{b!r},{time!r}" for a, b in zip(u.tolist(), v.tolist()))
    table = trimline("eval", spec, "--points", "-", "--derivatives", "u,v", *options, text=f"u,v,t\n{rows}\n")
    expected = np.genfromtxt(table.splitlines(), delimiter=",", skip_header=1)[:, 3:].reshape(-1, 3, 3)
    worst = []
    for k, values in enumerate(found):
        assert values.shape == (32, 3), values.shape
        worst.append(np.abs(values - expected[:, k]).max() / max(np.abs(expected[:, k]).max(), 1.0))
    # Arrays broadcast: a column of u against a row of v is a grid.
    arguments = (u[:4, None], v[None, :5]) + ((time,) if takes_time else ())
    grid = surface(*arguments)[0]
    assert grid.shape == (4, 5, 3) and np.array_equal(grid[2, 2], found[0][2]), grid.shape
    return worst


# How far B-splines may be from surfaces that have no formula.
WITHIN = 1e-6

# A surface without basis functions.
ZERO = "at u = 0: S = [0, 0, 0], dS/du = [0, 0, 0]\nat u = 1: S = [0, 0, 0], dS/du = [0, 0, 0]\n"


def main():
    folder = tempfile.TemporaryDirectory()
    zero = pathlib.Path(folder.name) / "zero.trim"
    zero.write_text(ZERO)
    specs = [zero, *sorted(EXAMPLES.glob("*.trim"))]
    compared = 0
    for spec in specs:
        methods = [[], ["--method", "exact"]] if spec.stem in ("eq19", "eq27", "eq29_30") else [[]]
        for part, method in itertools.product(parts_of(spec), methods):
            options = [*method, *(["--patch", part] if part else [])]
            text, within = emitted(spec, 0.125, options)
            compared += 1
            position, *slopes = deviations(spec, text, 0.125, options)
            # The tables agree to 1e-12 of the size or are not written; functions of two libraries differ by some ulp. A
            # B-spline in place of a surface is as near as stated, its derivatives by a few powers of the mesh size less.
            assert position <= (WITHIN if within else 1e-12), f"{spec.name} {options} {within}: {position:.1e}"
            assert max(slopes) <= (1e3 * WITHIN if within else 1e-12), f"{spec.name} {options} {within}: {slopes}"
            print(f"ok      {spec.name} {' '.join(options + within)}: {max(position, *slopes):.1e}")
    assert compared >= 70, compared


main()
