"""Figures of a study: curves of its outputs over an axis or another output, as its study.json describes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .energies import INK
from .errors import BAD_USE, PostprocError
from .json_report import read_report
from .page import DPI, STYLE

# Okabe-Ito colours in an order of lightness that grey printing keeps apart, then grey and two of them again with other dashes;
# each has a marker of its own
LOOKS = (
    ("#0072B2", "o", "-"),
    ("#D55E00", "s", (0, (5, 1.6))),
    ("#009E73", "^", (0, (1, 1.2))),
    ("#000000", "D", (0, (4, 1.4, 1, 1.4))),
    ("#E69F00", "v", "-"),
    ("#56B4E9", "P", (0, (5, 1.6))),
    ("#CC79A7", "X", (0, (1, 1.2))),
    ("#7F7F7F", "*", (0, (4, 1.4, 1, 1.4))),
    ("#0072B2", "<", (0, (1, 1.2))),
    ("#D55E00", ">", (0, (4, 1.4, 1, 1.4))),
)
PANEL = (3.9, 2.9)  # inches
LEGEND = 1.7  # inches beside the panels
HEAD = 0.45  # inches for the title


@dataclass(frozen=True)
class Axis:
    name: str
    labels: tuple[str, ...]
    numbers: tuple[float, ...] | None  # in `unit`, where all values are numbers
    unit: str

    @property
    def title(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass(frozen=True)
class Output:
    name: str
    unit: str

    @property
    def title(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass(frozen=True)
class Curve:
    """One line of a panel: its points in the order of the study's runs."""

    place: int  # of its value of `by` among those that the figure draws
    x: np.ndarray
    y: np.ndarray


@dataclass(frozen=True)
class Study:
    """What a study's folder holds. R runs, A axes."""

    title: str
    axes: tuple[Axis, ...]
    outputs: tuple[Output, ...]
    figures: tuple[dict[str, Any], ...]
    choice: np.ndarray  # (R, A) which value of each axis a run has
    values: dict[str, np.ndarray]  # of outputs, by name: (R,), nan where there is none

    def axis(self, name: str) -> int | None:
        """Its index; None if there is no such axis."""
        return next((k for k, axis in enumerate(self.axes) if axis.name == name), None)

    def column(self, name: str) -> np.ndarray:
        """(R,) of an axis, whose values are counted where they are no numbers, or of an output."""
        k = self.axis(name)
        if k is None:
            return self.values[name]
        numbers = self.axes[k].numbers or tuple(range(len(self.axes[k].labels)))
        return np.asarray(numbers, dtype=float)[self.choice[:, k]]


def read(folder: Path) -> Study:
    """Raises PostprocError: status 3 for files that are missing or cannot be read, 2 for what is not a study's."""
    report = read_report(folder, "study.json", "sundrape study")
    axes = tuple(
        Axis(axis["name"], tuple(axis["values"]), tuple(axis["numbers"]) if "numbers" in axis else None, axis["unit"])
        for axis in report["axes"]
    )
    outputs = tuple(Output(output["name"], output["unit"]) for output in report.get("outputs", ()))
    runs = report["runs"]
    choice = np.array([[axis.labels.index(run["values"][axis.name]) for axis in axes] for run in runs], dtype=int)
    values = {
        output.name: np.array([run.get("outputs", {}).get(output.name, np.nan) for run in runs], dtype=float)
        for output in outputs
    }
    return Study(report["title"], axes, outputs, tuple(report.get("figures", ())), choice, values)


def curve_labels(study: Study, figure: dict[str, Any]) -> tuple[str, ...]:
    """Of the values of `by` that the figure draws, in its order; one without words where there is no `by`."""
    by = study.axis(figure["by"])
    return ("",) if by is None else tuple(figure.get("curves", study.axes[by].labels))


def curves(study: Study, figure: dict[str, Any], y: str, panel: int | None) -> Iterator[Curve]:
    """Of one panel: one for each value of `by` that is drawn and each combination of the axes that are not named."""
    named = [figure["x"], figure["by"], figure["panels"]]
    others = [k for k, axis in enumerate(study.axes) if axis.name not in named]
    if study.axis(figure["x"]) is None and others:
        others = others[:-1]  # over an output a curve runs along the last of them
    by, panels = study.axis(figure["by"]), study.axis(figure["panels"])
    keys = study.choice[:, others]
    for place, label in enumerate(curve_labels(study, figure)):
        for key in dict.fromkeys(map(tuple, keys)):
            chosen = (keys == key).all(axis=1)
            if by is not None:
                chosen &= study.choice[:, by] == study.axes[by].labels.index(label)
            if panels is not None:
                chosen &= study.choice[:, panels] == panel
            x, value = study.column(figure["x"])[chosen], study.values[y][chosen]
            there = np.isfinite(x) & np.isfinite(value)
            if there.any():
                yield Curve(place, x[there], value[there])


def observed_slope(curve: Curve) -> float | None:
    """Of the straight line through the points by least squares, both scales being logarithmic."""
    if len(curve.x) < 2 or (curve.x <= 0).any() or (curve.y <= 0).any() or len(set(curve.x)) < 2:
        return None
    return float(np.polyfit(np.log(curve.x), np.log(curve.y), 1)[0])


def draw(study: Study, figure: dict[str, Any]) -> Figure:
    """One figure: a row of panels for each of its outputs and a column for each value of `panels`, or, without `panels`,
    its outputs side by side."""
    panels, by = study.axis(figure["panels"]), study.axis(figure["by"])
    if panels is None:
        grid = [[(y, None) for y in figure["y"]]]
    else:
        grid = [[(y, panel) for panel in range(len(study.axes[panels].labels))] for y in figure["y"]]
    beside = LEGEND if by is not None or "slope" in figure else 0.2
    width, height = PANEL[0] * len(grid[0]) + beside, PANEL[1] * len(grid) + HEAD
    with plt.rc_context(STYLE):
        page = plt.figure(figsize=(width, height), dpi=DPI, facecolor="white")
        page.text(0.16 / width, 1 - 0.16 / height, study.title, fontsize=12, fontweight="bold", va="top")
        for row, cells in enumerate(grid):
            for column, (y, panel) in enumerate(cells):
                left, bottom = column * PANEL[0] + 0.78, height - HEAD - (row + 1) * PANEL[1] + 0.52
                axes = page.add_axes(
                    (left / width, bottom / height, (PANEL[0] - 0.95) / width, (PANEL[1] - 0.85) / height)
                )
                drawn = list(curves(study, figure, y, panel))
                _panel(axes, study, figure, y, drawn)
                if panel is not None:
                    axes.set_title(f"{study.axes[panels].name} = {study.axes[panels].labels[panel]}", loc="left")
                if column == len(cells) - 1 and (row == 0 or "slope" in figure):
                    _legend(axes, study, by, drawn, figure)
        return page


def _panel(axes: Axes, study: Study, figure: dict[str, Any], y: str, drawn: Sequence[Curve]) -> None:
    axes.grid(True, color="#e9e9e9", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.set_xscale("log" if figure["log_x"] else "linear")
    if figure["log_y"] and drawn and all((curve.y <= 0).all() for curve in drawn):
        axes.text(0.5, 0.5, "no value above 0", transform=axes.transAxes, ha="center")
    else:
        axes.set_yscale("log" if figure["log_y"] else "linear")
    for curve in drawn:
        colour, marker, dashes = LOOKS[curve.place % len(LOOKS)]
        axes.plot(curve.x, curve.y, color=colour, marker=marker, linestyle=dashes, markersize=4.5, linewidth=1.3)
    if "slope" in figure and drawn and figure["log_x"] and figure["log_y"]:
        _guide(axes, figure["slope"], drawn)
    k = study.axis(figure["x"])
    if k is not None:
        axes.set_xlabel(study.axes[k].title)
        numbers = study.axes[k].numbers
        if numbers is None:
            axes.set_xticks(range(len(study.axes[k].labels)), study.axes[k].labels)
        elif figure["log_x"] and len(numbers) <= 6 and max(numbers) < 100 * min(numbers):
            # powers of ten are too few there, and matplotlib's labels between them run into each other
            axes.set_xticks(numbers, [f"{number:.4g}" for number in numbers])
            axes.set_xticks([], minor=True)
    else:
        axes.set_xlabel(next(output.title for output in study.outputs if output.name == figure["x"]))
    axes.set_ylabel(next(output.title for output in study.outputs if output.name == y))


def _guide(axes: Axes, slope: float, drawn: Sequence[Curve]) -> None:
    """A straight line of that slope through the middle of all points."""
    x = np.concatenate([curve.x for curve in drawn])
    y = np.concatenate([curve.y for curve in drawn])
    there = (x > 0) & (y > 0)
    if not there.any():
        return
    limits = axes.get_ylim()
    middle_x, middle_y = np.exp(np.log(x[there]).mean()), np.exp(np.log(y[there]).mean())
    ends = np.array([x[there].min(), x[there].max()])
    axes.plot(ends, middle_y * (ends / middle_x) ** slope, color="#9a9a9a", linewidth=0.9, zorder=1)
    axes.set_ylim(limits)


def _legend(axes: Axes, study: Study, by: int | None, drawn: Sequence[Curve], figure: dict[str, Any]) -> None:
    handles, texts = [], []
    labels = curve_labels(study, figure)
    for place in dict.fromkeys(curve.place for curve in drawn):
        colour, marker, dashes = LOOKS[place % len(LOOKS)]
        text = labels[place]
        if "slope" in figure:
            slopes = [observed_slope(curve) for curve in drawn if curve.place == place]
            known = [slope for slope in slopes if slope is not None]
            if known:
                text += f"{', ' if text else ''}slope {np.mean(known):.2f}".replace("-", "\N{MINUS SIGN}")
        if text:
            handles.append(plt.Line2D([], [], color=colour, marker=marker, linestyle=dashes, markersize=4.5))
            texts.append(text)
    if "slope" in figure and figure["log_x"] and figure["log_y"]:
        handles.append(plt.Line2D([], [], color="#9a9a9a", linewidth=0.9))
        texts.append(f"slope {figure['slope']:g}".replace("-", "\N{MINUS SIGN}"))
    if handles:
        title = None if by is None else study.axes[by].name
        axes.legend(
            handles, texts, title=title, loc="upper left", bbox_to_anchor=(1.02, 1.02), frameon=False, labelcolor=INK
        )


def figures(study: Study, names: Sequence[str] | None = None) -> list[dict[str, Any]]:
    """Those asked for, or all. Raises PostprocError, status 2: one that the study does not describe, or none at all."""
    if not study.figures:
        raise PostprocError("the study describes no figure: add [[figure]] to it", BAD_USE)
    known = {figure["name"]: figure for figure in study.figures}
    for name in names or ():
        if name not in known:
            raise PostprocError(f"--figure {name}: there are {', '.join(known)}", BAD_USE)
    return [known[name] for name in names] if names else list(study.figures)
