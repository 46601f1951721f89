#!/usr/bin/env python3
"""Largest stable step of the explicit method, by bisection, against the one that a run reports at its start.

Stable: the run ends, and has gained no more than a thousandth of the work that gravity had done, had the cloth fallen by its
diagonal. The table of docs/time-step.md is made by it.
"""

import argparse
import tempfile
from pathlib import Path

import h5py
import numpy as np
from case_run import ROOT, run_case

UNDAMPED = ["material.damping={mass=0,membrane=0,bending=0}"]
FOLD = ["model=particle", "cloth.cells=[40,1]", "motion.0.path.duration=0.5", "dynamics.duration=0.5"]
# motion, damping, file, settings
MOTIONS = [
    ("swing", "none", "swing.toml", ["cloth.cells=[40,1]"]),
    ("tablecloth", "none", "tablecloth.toml", ["dynamics.duration=0.15", *UNDAMPED]),
    ("tablecloth", "its own", "tablecloth.toml", ["dynamics.duration=0.15"]),
    ("fold", "none", "folding_motion.toml", [*FOLD, *UNDAMPED]),
]


def run(executable, folder, file, settings, time_limit):
    """The reported limit [s], and what the method lost over weight times diagonal; None if the run did not end."""
    explicit = ["dynamics.integrator=rk4", f"dynamics.time_limit={time_limit}"]
    totals = run_case(executable, folder, file, [*settings, *explicit])
    with h5py.File(Path(folder) / "result.h5") as f:
        reported = float(f["statistics"].attrs["rk4_stable_step_s"])
        diagonal = np.linalg.norm(np.ptp(f["mesh/reference"][:], axis=0))
    return reported, totals["method_dissipated_J"] / (totals["weight_N"] * diagonal) if totals["ended"] else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--executable", default=str(ROOT / "build/sundrape"), help="default: %(default)s")
    parser.add_argument("--time-limit", type=float, default=60, help="of a run [s] (default: %(default)s)")
    options = parser.parse_args()
    print("motion,damping,reported_limit_s,measured_limit_s,ratio")
    with tempfile.TemporaryDirectory() as folder:
        for motion, damping, file, settings in MOTIONS:
            reported, _ = run(options.executable, folder, file, settings, time_limit=0.2)

            def stable(ratio):
                step = f"dynamics.step={ratio * reported:.8g}"
                _, lost = run(options.executable, folder, file, [*settings, step], options.time_limit)
                return lost is not None and lost > -1e-3

            low, high = 0.5, 3.0
            if not stable(low) or stable(high):
                print(f"{motion},{damping},{reported:.4g},outside [0.5, 3] of it,")
                continue
            while high - low > 0.005:
                middle = 0.5 * (low + high)
                low, high = (middle, high) if stable(middle) else (low, middle)
            print(f"{motion},{damping},{reported:.4g},{low * reported:.4g},{low:.3f}", flush=True)


if __name__ == "__main__":
    main()
