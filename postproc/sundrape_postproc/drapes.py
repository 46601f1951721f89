"""The distinct drapes of a study, side by side: its study.json and the results that stand for each drape."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from .camera import Room
from .errors import BAD_USE, PostprocError
from .load import Result, load
from .json_report import read_report
from .page import GUTTER, STYLE, new_figure, place_image
from .units import quantity

CAPTION_ROOM = Room(top=0.02, bottom=0.17)
MOST = 24  # panels; more would be stamps


@dataclass(frozen=True)
class Drape:
    """One drape of a study and the result that stands for it."""

    result: Result
    title: str  # "drape 1: 14 of 20 runs"
    facts: str  # energy and stability
    group: str  # values of the group's axes; empty where the study has one group


def read(folder: Path) -> tuple[str, list[Drape]]:
    """The study's title and its drapes, in the order of study.json.

    Raises PostprocError: status 3 for files that are missing or cannot be read, 2 for what is not a study's.
    """
    study = read_report(folder, "study.json", "sundrape study")
    drapes = []
    if "group_by" not in study:
        raise PostprocError(f"{folder}: the study sorts no drapes: add [branches] to it", BAD_USE)
    for group in study["groups"]:
        values = ", ".join(f"{key.rsplit('.', 1)[-1]} = {value}" for key, value in zip(study["group_by"], group["values"]))
        runs = sum(drape["count"] for drape in group["drapes"])
        drapes += [_drape(folder, k, runs, drape, values) for k, drape in enumerate(group["drapes"], 1)]
    if not drapes:
        raise PostprocError(f"{folder}: no run of the study is done", BAD_USE)
    return study["title"], drapes[:MOST]


def _drape(folder: Path, number: int, runs: int, drape: Mapping[str, Any], group: str) -> Drape:
    pivots = drape["negative_pivots"]
    stable = {0: "stable", -1: "stability not known"}.get(pivots, f"unstable ({pivots})")
    title = f"drape {number}: {drape['count']} of {runs} runs"
    return Drape(load(folder / drape["representative"]), title, f"{quantity(drape['total_energy_J'], 'J')}, {stable}", group)


def grid(count: int, size: tuple[int, int]) -> tuple[int, int, tuple[int, int]]:
    """Columns, rows and pixels of each panel: as near to square panels as the page allows."""
    shapes = [(c, -(-count // c)) for c in range(1, count + 1)]
    columns, rows = max(shapes, key=lambda s: min(size[0] / s[0], size[1] / s[1]))
    return columns, rows, ((size[0] - GUTTER * (columns - 1)) // columns, (size[1] - GUTTER * (rows - 1)) // rows)


def page(title: str, drapes: list[Drape], scenes: list[np.ndarray], size: tuple[int, int]) -> Figure:
    """Scenes (height, width, 3) in rows, each with its count, energy and stability below."""
    columns, rows, (width, height) = grid(len(drapes), size)
    with plt.rc_context(STYLE):
        figure = new_figure(size)
        for k, (drape, scene) in enumerate(zip(drapes, scenes)):
            left, bottom = (k % columns) * (width + GUTTER), (rows - 1 - k // columns) * (height + GUTTER)
            place_image(figure, scene, left, bottom)
            x = (left + width / 2) / size[0]
            lines = [(drape.title, 11, "bold"), (drape.facts, 9.5, "normal"), (drape.group, 9.5, "normal")]
            for line, (text, points, weight) in enumerate(entry for entry in lines if entry[0]):
                y = (bottom + 0.145 * height - 0.05 * height * line) / size[1]
                figure.text(x, y, text, ha="center", va="center", fontsize=points, fontweight=weight)
        figure.text(0.012, 0.985, title, fontsize=13, fontweight="bold", va="top")
        return figure
