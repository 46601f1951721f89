#!/usr/bin/env python3
"""Draws docs/images/block_modes.png: for which bending rigidity D and edge ratio b/L a sheet held at the four corners of a
block drapes without losing its stability, and under which part of its weight it does otherwise (figure 8 of Eischen, Deng,
Clapp 1996).

    python3 docs/figures/block_modes.py build/release/sundrape cases/block_drape.toml -o docs/images/block_modes.png

runs the perfect sheet up to its first bifurcation for 5 rigidities and 5 ratios, two at a time (half a minute); --full takes 9
and 10. A sheet that reaches its whole weight is stable all the way, in the large-deflection mode: the article's stable area.
Where its path has a bifurcation before, there are buckling modes beside it: the article's area of multiple solutions.
"""
import argparse
import concurrent.futures
import pathlib
import subprocess
import tempfile

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

LENGTH, WEIGHT = 10, 5.425e-3  # in, ozf/in^2, of the case
RIGIDITY = 2688 * 0.02135**3 / (12 * (1 - 0.3**2))  # ozf in, of the case
POLYESTER = RIGIDITY / (WEIGHT * LENGTH**3)


def critical_load(executable, case, factor, block, folder):
    """Part of the weight at the first bifurcation; 1 where there is none."""
    result = folder / f"{factor:.4g}-{block}.h5"
    if not result.exists():
        settings = ["arc-length.at_bifurcation=stop", "arc-length.frame_every=1000", "arc-length.tolerance=1e-5",
                    f"material.youngs_modulus={2688 * factor:.8g} ozf/in^2",
                    f"arc-length.first_load_increment={min(0.05, 2.5e-4 * factor):.4g}"]
        for k, (x, y) in enumerate([(-1, -1), (1, -1), (-1, 1), (1, 1)]):
            settings.append(f'fix.{k}.nodes={{ near = ["{x * block / 2} in", "{y * block / 2} in", 0] }}')
        command = [executable, "run", case, "--quiet", "--force", "-o", result]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with h5py.File(result) as file:
        found = file["critical/load_factor"][:]
        return float(found[0]) if len(found) else 1.0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sundrape")
    parser.add_argument("case")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--results", type=pathlib.Path, help="where results are kept, and looked for")
    options = parser.parse_args()
    rigidity = np.logspace(-4, 0, 9 if options.full else 5)
    blocks = range(1, 11) if options.full else range(2, 11, 2)
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(2) as pool:
        folder = options.results or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        runs = {(d, b): pool.submit(critical_load, options.sundrape, options.case, d / POLYESTER, b, folder)
                for b in blocks for d in rigidity}
        loads = {key: run.result() for key, run in runs.items()}
    figure, axes = plt.subplots(figsize=(6.4, 4.4), dpi=130)
    for b in blocks:
        print(f"b/L = {b / LENGTH:.1f} ", *(f"{loads[d, b]:8.4f}" for d in rigidity))
        for d in rigidity:
            stable = loads[d, b] >= 1
            axes.plot(b / LENGTH, d, "o" if stable else "v", markersize=13, color="#1f3b73" if stable else "#dd8452")
            if not stable:
                axes.annotate(f"{loads[d, b]:.2g}", (b / LENGTH, d), textcoords="offset points", xytext=(9, 4), fontsize=7)
    axes.plot([], [], "o", color="#1f3b73", label="stable area: the large-deflection mode alone")
    axes.plot([], [], "v", color="#dd8452", label="multiple solutions: buckles at this part of its weight")
    axes.axhline(POLYESTER, color="black", linewidth=0.8, linestyle=":", label="polyester plain weave, 10 in")
    axes.set(yscale="log", xlabel="edge ratio b/L", ylabel="bending rigidity D / (w L³)", xlim=(0.05, 1.08))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.24), fontsize=8, frameon=False)
    figure.tight_layout()
    figure.savefig(options.output)


if __name__ == "__main__":
    main()
