#!/usr/bin/env python3
"""Work against precision of the integrators: what tolerance, order and method cost, and what they leave of the error.

`measure` runs each case with every integrator, order and rtol (the Runge–Kutta method: with fixed steps up to its
limit) and writes one row a run. Errors are root mean squares of node distances at the case's times, the largest of
them, over the cloth's diagonal, from a tight run of one method; `reference_error` is that of a tight run of another, so
errors below a few of it say nothing. Work is counted; CPU time is a ratio to the fastest of the default runs before and
after. `limit` finds the largest stable step of the Runge–Kutta method by bisection. `plot` draws a table of `measure`.
"""

import argparse
import csv
import json
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parent.parent
UNDAMPED = "material.damping={mass=0,membrane=0,bending=0}"
# name: (file, settings, times at which motions are compared [s])
CASES = {
    "swing": ("swing.toml", ["cloth.cells=[40,1]", "output.every=0.05"], [0.1, 0.15, 0.2, 0.25, 0.3]),
    "tablecloth": ("tablecloth.toml", ["cloth.cells=[20,20]", "dynamics.duration=0.15", "output.frames=6"], [0.05, 0.1, 0.15]),
    "fold": ("folding_motion.toml", ["model=particle", "cloth.cells=[40,1]", "motion.0.path.duration=0.5", "dynamics.duration=0.5",
                                     "output.frames=10"], [0.2, 0.3, 0.4, 0.5]),
}
TOLERANCES = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7]
METHODS = [(name, order) for name in ("cvode", "ida") for order in range(1, 6)] + [("dirk", order) for order in range(2, 6)]
DEFAULT = ("cvode", 2, 1e-4)
TIGHT = [("dirk", 4, 1e-8), ("cvode", 2, 1e-8)]  # the reference, and the other method that says how good it is
STEPS = [0.9, 0.45, 0.225]                       # of the Runge–Kutta method, over the limit that it reports
COUNTS = ["steps", "force_evaluations", "newton_iterations", "linear_iterations", "factorizations", "error_test_failures",
          "step_solve_failures"]
COLUMNS = ["case", "integrator", "max_order", "rtol", "step_s", "status", "error", "reference_error", *COUNTS, "cpu_ratio",
           "method_dissipated_ratio"]


def settings(integrator, order, rtol):
    return [f"dynamics.integrator={integrator}", f"dynamics.max_order={order}", f"dynamics.rtol={rtol:g}"]


class Runner:
    def __init__(self, executable, time_limit):
        self.executable, self.time_limit = executable, time_limit
        self.folder = tempfile.TemporaryDirectory()

    def run(self, case, sets, limit=None):
        """Summary of a run, with `motion`: positions (F, N, 3) [m] at the case's times; `motion` is None if it did not end."""
        file, common, times = CASES[case]
        folder = Path(self.folder.name)
        result, summary = folder / "result.h5", folder / "summary.json"
        command = [self.executable, "run", str(ROOT / "cases" / file), "-o", str(result), "--force", "--quiet", "--threads", "1",
                   "--summary", str(summary)]
        for setting in [*common, f"dynamics.time_limit={limit or self.time_limit}", *sets]:
            command += ["--set", setting]
        done = subprocess.run(command, check=False, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            raise SystemExit(done.stderr)
        totals = json.loads(summary.read_text())
        totals["motion"] = None
        with h5py.File(result) as f:
            totals["stable_step"] = f["statistics"].attrs.get("rk4_stable_step_s") if "statistics" in f else None
            if done.returncode == 0:
                frames = [int(np.argmin(abs(f["frames/time"][:] - t))) for t in times]
                totals["motion"] = f["frames/position"][:][frames]
                reference = f["mesh/reference"][:]
                totals["diagonal"] = float(np.linalg.norm(np.ptp(reference, axis=0)))
                # gravity's work, had the cloth fallen by its diagonal
                totals["lost"] = totals["method_dissipated_J"] / (totals["weight_N"] * totals["diagonal"])
        return totals

    def reported_limit(self, case, sets):
        """Of the explicit method, which says it at the start [s]."""
        return self.run(case, sets, limit=0.2)["stable_step"]


def distance(run, other):
    """Largest over the times of the root mean square distance of nodes, over the diagonal."""
    apart = np.linalg.norm(run["motion"] - other["motion"], axis=2)
    return float(np.sqrt((apart**2).mean(axis=1)).max() / run["diagonal"])


def measure(options):
    runner = Runner(options.executable, options.time_limit)
    rows = []
    if options.table.exists():  # of cases that are not measured anew
        with options.table.open() as table:
            rows = [row for row in csv.DictReader(table) if row["case"] not in options.cases or row["integrator"] not in options.integrators]
    for case in options.cases:
        reference, other = (runner.run(case, settings(*tight), limit=20 * options.time_limit) for tight in TIGHT)
        doubt = distance(reference, other)
        baseline = [runner.run(case, settings(*DEFAULT))["cpu_seconds"] for _ in range(3)]
        runs = []

        def record(integrator, order, rtol, step, run):
            ended = run["motion"] is not None
            runs.append({"case": case, "integrator": integrator, "max_order": order, "rtol": rtol, "step_s": step,
                         "status": run["status"], "error": f"{distance(run, reference):.3g}" if ended else "",
                         "reference_error": f"{doubt:.2g}", **{name: run[name] for name in COUNTS}, "cpu_ratio": run["cpu_seconds"],
                         "method_dissipated_ratio": f"{run['lost']:.3g}" if ended else ""})
            print(*runs[-1].values(), flush=True)

        for integrator, order in [method for method in METHODS if method[0] in options.integrators]:
            for rtol in TOLERANCES:
                run = runner.run(case, settings(integrator, order, rtol))
                record(integrator, order, rtol, "", run)
                if run["motion"] is None and rtol < 1e-3:
                    break  # tighter takes longer still
        limit = runner.reported_limit(case, ["dynamics.integrator=rk4"])
        for part in STEPS if "rk4" in options.integrators else []:
            step = part * limit
            run = runner.run(case, ["dynamics.integrator=rk4", f"dynamics.step={step:.6g}"])
            record("rk4", 4, "", f"{step:.4g}", run)
            if run["motion"] is None:
                break
        baseline += [runner.run(case, settings(*DEFAULT))["cpu_seconds"] for _ in range(3)]
        for row in runs:
            row["cpu_ratio"] = f"{row['cpu_ratio'] / min(baseline):.3g}"
        rows += runs
        with options.table.open("w", newline="") as out:
            writer = csv.DictWriter(out, COLUMNS)
            writer.writeheader()
            writer.writerows(rows)


def limit(options):
    """Largest step with which the motion ends and has gained no more than a thousandth of what it moved, to 1 %."""
    runner = Runner(options.executable, options.time_limit)
    print("case,damping,reported_limit_s,measured_limit_s,ratio")
    for case, damping in (("swing", "none"), ("tablecloth", "none"), ("tablecloth", "its own"), ("fold", "none")):
        sets = [UNDAMPED] if damping == "none" and case != "swing" else []
        explicit = ["dynamics.integrator=rk4", *sets]
        reported = runner.reported_limit(case, explicit)

        def stable(ratio):
            run = runner.run(case, [*explicit, f"dynamics.step={ratio * reported:.8g}"])
            return run["motion"] is not None and run["lost"] > -1e-3

        low, high = 0.5, 3.0
        if not stable(low) or stable(high):
            print(f"{case},{damping},{reported:.4g},outside [0.5, 3] of it,")
            continue
        while high - low > 0.005:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if stable(middle) else (low, middle)
        print(f"{case},{damping},{reported:.4g},{low * reported:.4g},{low:.3f}", flush=True)


def plot(options):
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"svg.hashsalt": "sundrape", "svg.fonttype": "none", "font.size": 8})
    rows = [row for row in csv.DictReader(options.table.open()) if row["error"]]
    cases = list(dict.fromkeys(row["case"] for row in rows))
    shown = [("cvode", 2, "o-", "0", "CVODE, order 2"), ("cvode", 5, "o:", "0.55", "CVODE, order 5"), ("ida", 2, "s--", "0.3", "IDA, order 2"),
             ("dirk", 2, "^-", "0", "DIRK, order 2"), ("dirk", 3, "v-", "0.35", "DIRK, order 3"), ("dirk", 4, "D--", "0.5", "DIRK, order 4"),
             ("dirk", 5, "P:", "0.65", "DIRK, order 5"), ("rk4", 4, "x-", "0.2", "RK4, fixed steps")]
    figure, axes = plt.subplots(1, len(cases), figsize=(3.1 * len(cases), 3.7))
    figure.subplots_adjust(left=0.07, right=0.99, top=0.92, bottom=0.27, wspace=0.28)
    for ax, case in zip(np.atleast_1d(axes), cases):
        for integrator, order, style, grey, label in shown:
            line = [row for row in rows if row["case"] == case and row["integrator"] == integrator and int(row["max_order"]) == order]
            ax.loglog([float(row["error"]) for row in line], [int(row["force_evaluations"]) for row in line], style, color=grey,
                      markersize=4, markerfacecolor="white", linewidth=1, label=label)
        doubt = next(float(row["reference_error"]) for row in rows if row["case"] == case)
        ax.axvline(doubt, color="0.8", linewidth=4, zorder=0)
        ax.set(title=case, xlabel="largest RMS error of nodes / diagonal (–)", ylabel="force evaluations (–)")
        ax.invert_xaxis()
        ax.grid(True, which="major", linewidth=0.3)
    figure.legend(*np.atleast_1d(axes)[0].get_legend_handles_labels(), loc="lower center", ncol=4, frameon=False)
    figure.savefig(options.figure, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(required=True)
    for name, body in (("measure", measure), ("limit", limit), ("plot", plot)):
        verb = verbs.add_parser(name)
        verb.set_defaults(body=body)
        verb.add_argument("--executable", default=str(ROOT / "build/sundrape"), help="default: %(default)s")
        verb.add_argument("--table", type=Path, default=ROOT / "docs/figures/work_precision.csv", help="default: %(default)s")
        verb.add_argument("--figure", type=Path, default=ROOT / "docs/figures/work_precision.svg", help="default: %(default)s")
        verb.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
        verb.add_argument("--integrators", nargs="+", choices=("cvode", "ida", "dirk", "rk4"), default=["cvode", "ida", "dirk", "rk4"])
        verb.add_argument("--time-limit", type=float, default=15, help="of a run [s] (default: %(default)s)")
    options = parser.parse_args()
    options.body(options)


if __name__ == "__main__":
    main()
