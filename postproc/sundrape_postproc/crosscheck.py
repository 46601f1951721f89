"""Where the methods of a crosscheck ended: the shapes laid on each other, and how far apart each node is."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Line3DCollection

from .errors import BAD_USE, PostprocError
from .load import Result, load
from .page import STYLE, new_figure
from .json_report import read_report

FIRST_COLOUR, SECOND_COLOUR = "#0072B2", "#D55E00"  # Okabe & Ito


def read(folder: Path) -> dict[str, Any]:
    """crosscheck.json of a folder, with at least one pair of methods to draw.

    Raises PostprocError: status 3 for files that are missing or cannot be read, 2 for what is not a crosscheck's.
    """
    report = read_report(folder, "crosscheck.json", "sundrape crosscheck")
    if not report["pairs"]:
        raise PostprocError(f"{folder}: fewer than two methods came to an end, nothing to compare", BAD_USE)
    return report


def page(folder: Path, report: dict[str, Any], size: tuple[int, int]) -> Figure:
    """One row a pair of methods: both shapes as nets of mesh lines, and the distance of the nodes over the rest sheet."""
    names = {method["name"]: method["result"] for method in report["methods"]}
    pairs = report["pairs"]
    with plt.rc_context(STYLE):
        figure = new_figure(size)
        figure.text(0.012, 0.985, report["title"], fontsize=13, fontweight="bold", va="top")
        for row, pair in enumerate(pairs):
            first = load(folder / names[pair["first"]])
            second = np.asarray(pair["second_position_m"], dtype=float)
            bottom, height = 1 - 0.09 - 0.91 * (row + 1) / len(pairs) + 0.03, 0.91 / len(pairs) - 0.05
            _shapes(figure.add_axes((0.0, bottom, 0.56, height), projection="3d"), first, second, pair)
            _distances(figure, (0.62, bottom + 0.07 * height, 0.28, 0.8 * height), first, second, report)
        return figure


def _shapes(axes: Any, first: Result, second: np.ndarray, pair: dict[str, Any]) -> None:
    shape = first.position[first.last_frame]
    sides = np.unique(np.sort(np.stack([first.quads, np.roll(first.quads, -1, axis=1)], 2).reshape(-1, 2), 1), axis=0)
    for points, colour, name in ((shape, FIRST_COLOUR, pair["first"]), (second, SECOND_COLOUR, pair["second"])):
        axes.add_collection3d(Line3DCollection(points[sides], colors=colour, linewidths=0.6, label=name))
    both = np.concatenate([shape, second])
    low, high = both.min(axis=0), both.max(axis=0)
    room = np.maximum(high - low, 0.05 * (high - low).max())
    for name, a, b in zip("xyz", (low + high - room) / 2, (low + high + room) / 2):
        getattr(axes, f"set_{name}lim")(a, b)
    axes.set_box_aspect(room, zoom=1.45)
    axes.set_axis_off()
    axes.view_init(elev=22, azim=-58)
    verdict = {"same branch": "the same branch", "undecided": "undecided"}.get(pair["verdict"], "different branches")
    axes.legend(loc="lower left", frameon=False)
    axes.set_title(f"{pair['first']} and {pair['second']}: {verdict}", y=0.98)


def _distances(figure: Figure, box: tuple[float, ...], first: Result, second: np.ndarray, report: dict[str, Any]) -> None:
    """Node distance in per cent of the longest side, over warp and weft."""
    axes = figure.add_axes(box)
    apart = 100 * np.linalg.norm(second - first.position[first.last_frame], axis=1) / report["size_m"]
    flat = 100 * (first.material if first.material is not None else first.reference[:, :2])  # [cm]
    patches = PolyCollection(flat[first.quads], array=apart[first.quads].mean(axis=1), cmap="cividis", edgecolors="face")
    axes.add_collection(patches)
    axes.autoscale_view()
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("warp [cm]")
    axes.set_ylabel("weft [cm]")
    bar = figure.colorbar(patches, cax=figure.add_axes((box[0] + box[2] + 0.02, box[1], 0.014, box[3])))
    bar.set_label("distance [% of L]")
    axes.set_title(f"RMS {np.sqrt(np.mean(apart**2)):.3g} % of L, at most {apart.max():.3g} %")
