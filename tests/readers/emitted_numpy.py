#!/usr/bin/env python3
"""Emitted NumPy code gives the surface that `trimline eval` gives, on every example.

usage: emitted_numpy.py BINARY      (needs numpy)
"""

import itertools
import json
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


def is_emitted(spec, patch):
    """`emit` refuses patches that are no sums of products or hold a measured curve, and only them."""
    done = subprocess.run([BINARY, "emit", spec, "--lang", "numpy", "--patch", patch], capture_output=True, text=True)
    assert done.returncode == 0 or "E0709" in done.stderr or "E0710" in done.stderr, done.stderr
    return done.returncode == 0


def deviation(spec, patch, time, options):
    """The largest difference of S, S_u and S_v at random points, over the largest coordinate of each."""
    names = {}
    options = [*options, "--patch", patch]
    text = trimline("emit", spec, "--lang", "numpy", "--time", time, *options)
    exec(compile(text, spec.name, "exec"), names)
    surface = names[f"{patch}_surface"]
    low, high = map(float, re.search(r"for u in \[(\S+), (\S+)\]", text).groups())
    chance = np.random.default_rng(20121)
    # v in [0, 1] lies in the domain of every example.
    u, v = low + (high - low) * np.r_[0.0, 1.0, chance.random(30)], np.r_[0.0, 1.0, chance.random(30)]
    takes_time = surface.__code__.co_argcount == 3
    found = surface(u, v, time) if takes_time else surface(u, v)
    rows = "\n".join(f"{a!r},{b!r},{time!r}" for a, b in zip(u.tolist(), v.tolist()))
    table = trimline("eval", spec, "--points", "-", "--derivatives", "u,v", *options, text=f"u,v,t\n{rows}\n")
    expected = np.genfromtxt(table.splitlines(), delimiter=",", skip_header=1)[:, 3:].reshape(-1, 3, 3)
    worst = 0.0
    for k, values in enumerate(found):
        assert values.shape == (32, 3), values.shape
        worst = max(worst, np.abs(values - expected[:, k]).max() / max(np.abs(expected[:, k]).max(), 1.0))
    # Arrays broadcast: a column of u against a row of v is a grid.
    arguments = (u[:4, None], v[None, :5]) + ((time,) if takes_time else ())
    grid = surface(*arguments)[0]
    assert grid.shape == (4, 5, 3) and np.array_equal(grid[2, 2], found[0][2]), grid.shape
    return worst


# A surface without basis functions.
ZERO = "at u = 0: S = [0, 0, 0], dS/du = [0, 0, 0]\nat u = 1: S = [0, 0, 0], dS/du = [0, 0, 0]\n"


def main():
    folder = tempfile.TemporaryDirectory()
    zero = pathlib.Path(folder.name) / "zero.trim"
    zero.write_text(ZERO)
    # B-spline nets and imported surfaces have no basis functions either, and are not emitted; nor are copies.
    is_left_out = re.compile(r"^(bspline|mirror|repeat) |= bspline\(", re.MULTILINE).search
    examples = [path for path in sorted(EXAMPLES.glob("*.trim")) if not is_left_out(path.read_text())]
    specs = [zero, *examples]
    compared = 0
    for spec in specs:
        patches = [patch["name"] for patch in json.loads(trimline("basis", spec, "--format", "json"))["patches"]]
        methods = [[], ["--method", "exact"]] if spec.stem in ("eq19", "eq27", "eq29_30") else [[]]
        for patch, options in itertools.product(patches, methods):
            if not is_emitted(spec, patch):
                continue
            compared += 1
            worst = deviation(spec, patch, 0.125, options)
            # The tables agree to 1e-12 of the size or are not written; functions of two libraries differ by some ulp.
            assert worst <= 1e-12, f"{spec.name} {patch} {options}: {worst:.1e}"
            print(f"ok      {spec.name} {patch} {' '.join(options)}: {worst:.1e}")
    assert compared >= 20, compared


main()
