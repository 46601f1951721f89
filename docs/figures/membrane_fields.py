#!/usr/bin/env python3
"""Draws docs/images/membrane_fields.png: where the corner of a cloth clamped on its diagonal hangs, by membrane field and mesh.

    python3 docs/figures/membrane_fields.py build/release/sundrape cases/clamped_diagonal.toml -o docs/images/membrane_fields.png

runs the case for every field and mesh (two minutes); with --results DIR it keeps them there and runs only what is missing.
"""
import argparse
import pathlib
import subprocess
import tempfile

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

CELLS = [10, 20, 40, 80]
TRIANGLE = 1.146  # cm; a triangle that bends as a cylinder, tests/verification/clamped_diagonal_test.cpp
SHEETS = {  # label: settings, style
    "shell, edge-tied": (["shell.membrane=edge-tied"], dict(color="#c44e52", marker="^")),
    "shell, bilinear": (["shell.membrane=bilinear"], dict(color="#dd8452", marker="s")),
    "shell, mixed": (["shell.membrane=mixed"], dict(color="#55a868", marker="D")),
    "shell, centre (default)": (["shell.membrane=centre"], dict(color="#1f3b73", marker="o", linewidth=2)),
    "particle net": (["model=particle"], dict(color="#7f7f7f", marker="x", linestyle="--")),
}


def corner(executable, case, settings, cells, folder):
    """x of the corner that starts at (10, -10, 0) cm [cm]."""
    result = folder / f"{settings[0].split('=')[1]}-{cells}.h5"
    if not result.exists():
        command = [executable, "run", case, "-o", result, "--set", f"cloth.cells=[{cells},{cells}]"]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with h5py.File(result) as file:
        material, last = file["mesh/material"][:], file["frames/position"][-1]
        return 100 * last[np.argmax(material[:, 0] - material[:, 1]), 0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sundrape")
    parser.add_argument("case")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--results", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.results or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        figure, axes = plt.subplots(figsize=(6.4, 4.0), dpi=130)
        for label, (settings, style) in SHEETS.items():
            values = [corner(options.sundrape, options.case, settings, cells, folder) for cells in CELLS]
            print(f"{label:24}", *(f"{x:.3f}" for x in values))
            axes.plot(CELLS, values, label=label, **style)
    axes.axhline(TRIANGLE, color="black", linewidth=0.8, linestyle=":", label="triangle that bends as a cylinder")
    axes.set_xscale("log")
    axes.set_xticks(CELLS, [f"{cells}²" for cells in CELLS])
    axes.minorticks_off()
    axes.set_ylim(0, 3.5)
    axes.set_xlabel("cells")
    axes.set_ylabel("x of the corner [cm]")
    axes.set_title("20 cm of tablecloth cotton, clamped on its diagonal", fontsize=10)
    axes.legend(frameon=False, fontsize=9)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.tight_layout()
    figure.savefig(options.output)


if __name__ == "__main__":
    main()
