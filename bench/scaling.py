#!/usr/bin/env python3
"""Whole cases on finer and finer nets: processor time, work done, and how both grow with the number of nodes.

Runs the tablecloth in motion and at rest, each `--repeat` times, and prints for the fastest run of each size what its
summary counts, the exponent p of CPU ~ nodes^p from the size before, and ratios to the smallest size. With
`--baseline rk4` (or `lu`, `cholesky`, `ida`) the motion is also run that way, in the same session.
"""

import argparse
import json
import math
import sys
import tempfile
from pathlib import Path

from case_run import run_case

BASELINES = {
    "rk4": ["dynamics.integrator=rk4"],
    "ida": ["dynamics.integrator=ida"],
    "cholesky": ["dynamics.linear_solver=cholesky"],
    "lu": ["dynamics.linear_solver=lu"],
}


def numbers(text):
    return [int(word) for word in text.split(",")]


def words(text):
    unknown = set(text.split(",")) - set(BASELINES)
    if unknown:
        raise argparse.ArgumentTypeError(f"{', '.join(sorted(unknown))}: not one of {', '.join(BASELINES)}")
    return text.split(",")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--executable", default="build/bench/sundrape", help="default: %(default)s")
    parser.add_argument("--sizes", type=numbers, default=[21, 41, 81], metavar="N,N,...",
                        help="nodes a side, ascending; 161 takes minutes (default: 21,41,81)")
    parser.add_argument("--duration", default="1 s", help="of the motion (default: %(default)s)")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each, of which the fastest counts (default: 3)")
    parser.add_argument("--baseline", type=words, default=[], metavar="NAME,...",
                        help=f"other ways to run the motion: {', '.join(BASELINES)}")
    parser.add_argument("--cases", default="dynamic,static", help="which to run (default: %(default)s)")
    parser.add_argument("--json", type=Path, help="write the table here too")
    return parser.parse_args()


def fastest(executable, case, sets, repeat):
    with tempfile.TemporaryDirectory() as folder:
        runs = [run_case(executable, folder, case, sets) for _ in range(repeat)]
    if not all(run["ended"] for run in runs):
        raise RuntimeError(f"{case} with {sets} failed")
    return min(runs, key=lambda r: r["process_cpu"])


def row(nodes, result):
    steps = result.get("steps", result.get("iterations", 0))
    return {
        "nodes": nodes,
        "cpu": result["process_cpu"],
        "steps": steps,
        "newton": result.get("newton_iterations", result.get("iterations", 0)),
        "refused": result.get("error_test_failures", 0) + result.get("step_solve_failures", 0),
        "linear": result.get("linear_iterations", 0),
        "cpu_per_step": result["process_cpu"] / max(steps, 1),
    }


def exponent(before, after, key):
    """p of key ~ nodes^p, by the number of all nodes."""
    if before is None or before[key] <= 0 or after[key] <= 0:
        return math.nan
    return math.log(after[key] / before[key]) / math.log((after["nodes"] / before["nodes"]) ** 2)


def show(number, form):
    return "-" if math.isnan(number) else format(number, form)


def table(title, sizes, measure):
    print(f"\n{title}")
    print(f"{'nodes':>6} {'CPU s':>9} {'steps':>7} {'Newton':>7} {'refused':>7} {'linear it.':>10} {'ms/step':>9}"
          f" {'exponent':>8} {'exp./step':>9} {'CPU ratio':>9}")
    rows = []
    for size in sizes:
        try:
            now = row(size, measure(size))
        except RuntimeError as problem:
            print(f"{size:>5}²  {problem}", file=sys.stderr)
            break
        before = rows[-1] if rows else None
        rows.append(now)
        now["exponent"] = exponent(before, now, "cpu")
        print(f"{size:>5}² {now['cpu']:9.2f} {now['steps']:7} {now['newton']:7} {now['refused']:7} {now['linear']:10}"
              f" {1e3 * now['cpu_per_step']:9.2f} {show(now['exponent'], '.2f'):>8}"
              f" {show(exponent(before, now, 'cpu_per_step'), '.2f'):>9} {now['cpu'] / rows[0]['cpu']:9.2f}", flush=True)
    if len(rows) > 2:
        print(f"exponent from {rows[0]['nodes']}² to {rows[-1]['nodes']}²: {exponent(rows[0], rows[-1], 'cpu'):.2f}")
    return rows


def compare(rows, against):
    by_size = {r["nodes"]: r for r in against}
    ratios = [f"{r['nodes']}²: {r['cpu'] / by_size[r['nodes']]['cpu']:.2f}" for r in rows if r["nodes"] in by_size]
    print(f"CPU as a multiple of the default's:  {'  '.join(ratios)}")


def main():
    args = arguments()
    results = {}

    def measure(case, sets):
        return lambda size: fastest(args.executable, case, [f"cloth.cells=[{size - 1}, {size - 1}]", *sets], args.repeat)

    if "dynamic" in args.cases:
        motion = [f"dynamics.duration={args.duration}"]
        default = table(f"Tablecloth in motion, {args.duration}", args.sizes, measure("tablecloth.toml", motion))
        results["dynamic"] = default
        for name in args.baseline:
            rows = table(f"The same with {' '.join(BASELINES[name])}", args.sizes,
                         measure("tablecloth.toml", motion + BASELINES[name]))
            compare(rows, default)
            results[name] = rows
    if "static" in args.cases:
        results["static"] = table("Tablecloth at rest", args.sizes, measure("tablecloth_static.toml", []))
    if args.json:
        args.json.write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()
