#!/usr/bin/env python3
"""Processor time that derivatives by one and by four parameters add to a motion, over that of the motion alone.

Least of several runs on one core. The table of docs/sensitivities.md is made by it.
"""

import argparse
import json
import tempfile

from case_run import ROOT, run_case

RUBBED = ["obstacle.0.friction=0.1"]
# motion, file, settings, first parameter; the others are the same for all
MOTIONS = [
    ("swing 80x1 net", "swing.toml", [], "material.bending.rigidity"),
    ("swing 40x1 shell", "swing.toml", ["model=shell", "cloth.cells=[40,1]"], "material.bending.rigidity"),
    ("tablecloth 20x20 net", "tablecloth.toml", ["cloth.cells=[20,20]", "dynamics.duration=0.5", *RUBBED], "material.poisson"),
    ("tablecloth 40x40 net", "tablecloth.toml", ["cloth.cells=[40,40]", "dynamics.duration=0.3", *RUBBED], "material.poisson"),
    (
        "tablecloth 20x20 shell",
        "tablecloth.toml",
        ["model=shell", "cloth.cells=[20,20]", "dynamics.duration=0.3", *RUBBED],
        "material.poisson",
    ),
]
OTHERS = ["material.weight", "material.thickness", "material.youngs_modulus"]


def cpu_seconds(executable, folder, file, settings, parameters, repetitions):
    wanted = [f"sensitivity.parameters={json.dumps(parameters)}"] if parameters else []
    return min(run_case(executable, folder, file, [*settings, *wanted])["cpu_seconds"] for _ in range(repetitions))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--executable", default=str(ROOT / "build/sundrape"), help="default: %(default)s")
    parser.add_argument("--repetitions", type=int, default=3, help="of each run (default: %(default)s)")
    options = parser.parse_args()
    print("motion,one,each_further,four_each")
    with tempfile.TemporaryDirectory() as folder:
        for name, file, settings, first in MOTIONS:
            alone, *more = (
                cpu_seconds(options.executable, folder, file, settings, [first, *OTHERS][:count], options.repetitions)
                for count in (0, 1, 4)
            )
            one, four = (time / alone - 1 for time in more)
            print(f"{name},{one:.2f},{(four - one) / 3:.2f},{four / 4:.2f}", flush=True)


if __name__ == "__main__":
    main()
