"""Compiles every LaTeX block that trimline prints for the given specs in a document of its own kind: `article` with `amsmath`.

Usage: latex.py TRIMLINE SPEC…
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

trimline, *specs = sys.argv[1:]


def output(*arguments: str) -> str:
    return subprocess.run([trimline, *arguments, "--quiet"], check=True, capture_output=True, text=True).stdout


blocks = []
for spec in specs:
    # One display per patch, with a blank line between two.
    blocks.extend(output("basis", spec, "--format", "latex").split("\n\n"))
    for patch in json.loads(output("check", spec, "--explain", "--format", "json"))["patches"]:
        blocks.extend(patch["explanation"]["latex"].values())
blocks = [block.strip() for block in blocks if block.strip()]
if len(blocks) < 2 * len(specs):
    sys.exit(f"only {len(blocks)} blocks were printed")


body = "\n\n".join(rf"\[ {block} \]" for block in blocks)
text = rf"""\documentclass{{article}}
\usepackage{{amsmath}}
\begin{{document}}
{body}
\end{{document}}
"""
with tempfile.TemporaryDirectory() as folder:
    Path(folder, "blocks.tex").write_text(text, encoding="utf-8")
    command = ["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "blocks.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
    if done.returncode != 0 or not Path(folder, "blocks.pdf").exists():
        errors = [line for line in done.stdout.splitlines() if line.startswith(("!", "l."))]
        sys.exit("\n".join(errors) or done.stdout)
print(f"{len(blocks)} blocks of {len(specs)} specs compiled by pdflatex")
