"""Makes the made-up measurements of this folder: `/usr/bin/python3 measurements.py SUNDRAPE`.

Each is what a case computes with its own numbers, seen at some points, with noise of a stated standard deviation and a
fixed seed; so a fit should find the case's numbers again."""
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
CASES = HERE.parent


def computed(executable, case, *sets):
    """Positions of the last frame, material coordinates and node sets of a case."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.h5"
        options = [word for each in sets for word in ("--set", each)]
        subprocess.run([executable, "run", CASES / case, "-o", out, "--quiet", *options], check=True)
        with h5py.File(out) as f:
            return f["frames/position"][-1], f["mesh/material"][:], {k: v[:] for k, v in f["mesh/sets"].items()}


def write(name, points, deviation, seed, heading):
    """Points [m] as centimetres, each coordinate with noise of a standard deviation [m]."""
    noisy = points + deviation * np.random.default_rng(seed).standard_normal(points.shape)
    np.savetxt(HERE / name, 100 * noisy, delimiter=",", fmt="%.4f", header=heading, comments="")


def main(executable):
    # a strip of twill, photographed from the side: 18 points, 1 mm of noise on 10 cm
    q, material, sets = computed(executable, "fits/twill_cantilever.toml")
    nodes = sets["bottom"][np.argsort(material[sets["bottom"], 0])]
    write("cantilever.csv", q[nodes[4::2]][:, [0, 2]], 1e-3, 1, "x,z")
    # the same of measured bending, 0.2 mm of noise
    q, material, sets = computed(executable, "shell_heavy_cantilever.toml")
    nodes = sets["bottom"][np.argsort(material[sets["bottom"], 0])]
    write("polynomial.csv", q[nodes[2:]][:, [0, 2]], 2e-4, 2, "x,z")
    # a tablecloth from above: every third node of its edge, 2 mm of noise on 20 cm
    q, material, sets = computed(executable, "tablecloth_static.toml")
    write("tablecloth.csv", q[sets["boundary"][::3]][:, :2], 2e-3, 3, "x,y")


if __name__ == "__main__":
    main(sys.argv[1])
