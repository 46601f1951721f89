"""Diagrams of a run, a panel each: energies, steps, reactions, probes, the path of loads, the residual."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, NullFormatter

from .course import course, step_course
from .energies import FAINT, GIVEN_AND_LOST, INK, STORED, Look, balance, draw_curves
from .errors import BAD_USE, PostprocError
from .load import Probe, Result
from .page import DPI, STYLE
from .units import scale_for

BLUE, ORANGE, RED, GREEN = "#0072B2", "#E69F00", "#D55E00", "#009E73"
DASHED, DOTTED = (0, (5, 1.6)), (0, (1, 1.2))
COMPONENTS = {"x": Look("x", BLUE), "y": Look("y", RED, DASHED), "z": Look("z", GREEN, DOTTED)}
STAGES = (Look("", BLUE), Look("", RED, DASHED), Look("", GREEN, DOTTED), Look("", "#555555", (0, (4, 1.4, 1, 1.4))))
CELL = (6.1, 2.75)  # inches of a panel with its labels
INSET = {"left": 0.78, "right": 1.25, "bottom": 0.52, "top": 0.36}  # inches
HEAD = 0.45  # inches for the title of the page


@dataclass(frozen=True)
class Panel:
    """One diagram: `draw` fills axes that have their final place."""

    title: str
    draw: Callable[[Axes], None]


def panels(result: Result, what: Sequence[str] | None = None) -> list[Panel]:
    """Those asked for, or all that the result has.

    Raises PostprocError, status 2: an unknown one, or one that the result does not have.
    """
    unknown = [name for name in what or () if name not in KINDS]
    if unknown:
        raise PostprocError(f"--what {unknown[0]}: there are {', '.join(KINDS)}", BAD_USE)
    made: list[Panel] = []
    for name in what or KINDS:
        found = list(KINDS[name](result))
        if what and not found:
            raise PostprocError(f"--what {name}: {result.path}: has none, being a result of {result.analysis}", BAD_USE)
        made += found
    if not made:
        raise PostprocError(f"{result.path}: nothing in it to plot")
    return made


def plot(result: Result, what: Sequence[str] | None = None, columns: int | None = None) -> Figure:
    """All panels on one page, below each other in one column or two."""
    drawn = panels(result, what)
    columns = columns or (1 if len(drawn) < 3 else 2)
    rows = -(-len(drawn) // columns)
    width, height = columns * CELL[0], rows * CELL[1] + HEAD
    with plt.rc_context(STYLE):
        figure = plt.figure(figsize=(width, height), dpi=DPI, facecolor="white")
        figure.text(0.16 / width, 1 - 0.16 / height, result.title, fontsize=13, fontweight="bold", va="top")
        for k, panel in enumerate(drawn):
            place(figure, panel, (k % columns) * CELL[0], height - HEAD - (k // columns + 1) * CELL[1], CELL)
    return figure


def place(figure: Figure, panel: Panel, left: float, bottom: float, cell: tuple[float, float]) -> Axes:
    """Draws a panel into a cell (width, height) at (left, bottom), all in inches."""
    width, height = figure.get_size_inches()
    inner = (cell[0] - INSET["left"] - INSET["right"], cell[1] - INSET["bottom"] - INSET["top"])
    box = ((left + INSET["left"]) / width, (bottom + INSET["bottom"]) / height, inner[0] / width, inner[1] / height)
    axes = figure.add_axes(box)
    axes.set_title(panel.title, loc="left")
    axes.grid(True, color="#e9e9e9", linewidth=0.7)
    axes.set_axisbelow(True)
    panel.draw(axes)
    if axes.get_xlabel().endswith("[1]"):
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    return axes


def _energies(result: Result) -> Iterator[Panel]:
    curves, over = balance(result), course(result)
    for title, looks in (
        ("Energy (gravity: change from the start)", GIVEN_AND_LOST),
        ("Energy stored in the cloth and its contact", STORED),
    ):
        if curves and len(result.time) > 1:
            yield Panel(title, _curves(over.values, curves, looks, "energy", "J", over.label))


def _curves(
    x: np.ndarray, curves: dict, looks: dict[str, Look], what: str, unit: str, label: str
) -> Callable[[Axes], None]:
    def draw(axes: Axes) -> None:
        draw_curves(axes, x, curves, looks, what, unit)
        axes.set_xlabel(label)

    return draw


def _steps(result: Result) -> Iterator[Panel]:
    over = step_course(result)
    if "step_size" in result.steps and len(over.values) > 1:
        size, name, unit = result.steps["step_size"], "step size", "s"
        if not result.has_time:
            name = "pseudo-time step"
    elif "arc_length" in result.steps and len(over.values) > 1:
        size, name, unit = result.steps["arc_length"], "arc length of the step", "1"
    else:
        return

    def draw_size(axes: Axes) -> None:
        axes.semilogy(over.values, np.where(size > 0, size, np.nan), color=BLUE, linewidth=1.2, drawstyle="steps-pre")
        rejected = (
            ("error_test_failures", "error too large", "v", RED),
            ("convergence_failures", "not converged", "x", INK),
            ("halvings", "halved", "x", INK),
        )
        shown = False
        for column, label, marker, colour in rejected:
            hit = result.steps.get(column, np.zeros(0)) > 0
            if hit.any():
                total = int(result.steps[column].sum())
                axes.plot(over.values[hit], size[hit], marker, color=colour, markersize=5, label=f"{label}: {total}",
                          markerfacecolor="none")  # fmt: skip
                shown = True
        if shown:
            axes.legend(loc="best", framealpha=0.8, edgecolor="none", title="rejected before", title_fontsize=8,
                        fontsize=8, handletextpad=0.2, borderpad=0.2, alignment="left")  # fmt: skip
        positive = size[size > 0]
        if positive.size:  # whole decades, so that there are always two numbers on the axis
            axes.yaxis.set_minor_formatter(NullFormatter())
            axes.set_ylim(10 ** np.floor(np.log10(0.9 * positive.min())), 10 ** np.ceil(np.log10(1.1 * positive.max())))
        axes.set_ylabel(f"{name} [{unit}]")
        axes.set_xlabel(over.label)
        _span(axes, over.values)

    yield Panel(name.capitalize(), draw_size)
    order = result.steps.get("order")
    if order is not None and (order > 0).any():

        def draw_order(axes: Axes) -> None:
            axes.plot(over.values, order, color=BLUE, linewidth=1.2, drawstyle="steps-pre")
            axes.set_ylim(0, max(int(order.max()), 2) + 0.5)
            axes.yaxis.set_major_locator(MaxNLocator(integer=True))
            axes.set_ylabel("order [1]")
            axes.set_xlabel(over.label)
            _span(axes, over.values)

        yield Panel("Order of the method", draw_order)


def _span(axes: Axes, x: np.ndarray) -> None:
    axes.set_xlim(float(x[0]), float(x[-1]) if x[-1] > x[0] else float(x[0]) + 1)


def _reactions(result: Result) -> Iterator[Panel]:
    over = course(result)
    for group, title in (
        ("reaction", "Force of the cloth on “{}”"),
        ("obstacle_force", "Force of obstacle “{}” on the cloth"),
    ):
        for name, force in sorted(result.frames.items()):
            if name.startswith(group + "/") and len(result.time) > 1 and np.any(np.nan_to_num(force)):
                components = dict(zip("xyz", force.T))
                text = title.format(name.removeprefix(group + "/"))
                yield Panel(text, _curves(over.values, components, COMPONENTS, "force", "N", over.label))


def _probes(result: Result) -> Iterator[Panel]:
    for name, probe in result.probes.items():
        if len(probe.position) < 2:
            continue
        over = step_course(result)
        x = over.factor * probe.time if result.has_time else np.arange(1, len(probe.position) + 1, dtype=float)
        components = dict(zip("xyz", probe.position.T))
        yield Panel(f"Place of probe “{name}”", _curves(x, components, COMPONENTS, "coordinate", "m", over.label))


def _load(result: Result) -> Iterator[Panel]:
    """The load factor over the component of a probe that moves most; without probes, of the node that does."""
    if result.analysis != "arc-length":
        return
    for name, node, place, factor, stage in _paths(result):
        yield Panel(f"Path of “{name}”", _path(result, node, place, factor, stage))


def _paths(result: Result) -> Iterator[tuple[str, int | None, np.ndarray, np.ndarray, np.ndarray]]:
    """(name, node, places (S, 3) [m], load factors (S,), stages (S,)) of every probe."""
    ones = np.ones(max(len(result.time), len(result.steps.get("load_factor", ()))), dtype=int)
    for name, probe in result.probes.items():
        if probe.load_factor is not None and len(probe.position) > 1:
            start = _start(result, probe)
            stage = result.steps.get("stage", ones)[: len(probe.position)]
            first = [] if start is None else [start]
            yield (
                name,
                probe.node,
                np.concatenate([np.reshape(first, (-1, 3)), probe.position]),
                np.concatenate([result.time[:1] if first else [], probe.load_factor]),
                np.concatenate([stage[:1] if first else [], stage]),
            )
    if not result.probes and len(result.time) > 1:
        moved = np.linalg.norm(result.position - result.position[0], axis=2).max(axis=0)
        node = int(np.argmax(moved))
        yield f"node {node}", node, result.position[:, node], result.time, result.frames.get("stage", ones)


def _start(result: Result, probe: Probe) -> np.ndarray | None:
    return None if probe.node is None else result.position[0, probe.node]


def _path(
    result: Result, node: int | None, place: np.ndarray, factor: np.ndarray, stage: np.ndarray
) -> Callable[[Axes], None]:
    moved = place - place[0]
    axis = int(np.argmax(np.ptp(moved, axis=0)))
    scale, prefix = scale_for(float(np.abs(moved[:, axis]).max()))

    def draw(axes: Axes) -> None:
        for number, look in zip(np.unique(stage), STAGES * 20):
            rows = np.flatnonzero(stage == number)
            rows = (
                np.concatenate([rows[:1] - 1, rows]) if number > stage[0] else rows
            )  # from where the stage before ended
            load = np.where(stage[rows] == number, factor[rows], 0.0)  # each stage starts at none of its own load
            label = f"stage {int(number)}" if len(np.unique(stage)) > 1 else None
            axes.plot(
                scale * moved[rows, axis], load, color=look.colour, linestyle=look.dashes, linewidth=1.5, label=label
            )
        if node is not None and result.critical:
            at = scale * (result.critical["position"][:, node, axis] - place[0, axis])
            limit = result.critical["limit_point"] > 0
            for kind, label, marker in ((limit, "limit point", "o"), (~limit, "path forks", "D")):
                if kind.any():
                    axes.plot(at[kind], result.critical["load_factor"][kind], marker, color=INK, markersize=4.5,
                              markerfacecolor="white", label=label)  # fmt: skip
        axes.axhline(0, color=FAINT, linewidth=0.6, zorder=0)
        axes.set_xlabel(f"displacement along {'xyz'[axis]} [{prefix}m]")
        axes.set_ylabel("load factor [1]")
        if axes.get_legend_handles_labels()[0]:
            axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.02), frameon=False, fontsize=8, borderpad=0.2)

    return draw


def _residual(result: Result) -> Iterator[Panel]:
    name = next((n for n in ("residual", "relative_residual") if n in result.steps), None)
    residual = np.asarray(result.steps[name] if name else result.residual if result.is_static else ())
    if not result.is_static or residual.size < 2 or not (residual > 0).any():
        return
    over = step_course(result) if name else course(result)

    def draw(axes: Axes) -> None:
        dots = "." if len(residual) < 200 else ""
        axes.semilogy(over.values, np.where(residual > 0, residual, np.nan), dots + "-", color=BLUE, linewidth=1.2)
        tolerance = float(result.case.get(result.analysis, {}).get("tolerance", 1e-6))
        axes.axhline(tolerance, color=INK, linewidth=0.8, linestyle=(0, (4, 2)))
        _span(axes, over.values)
        at = (np.log(tolerance) - np.log(axes.get_ylim()[0])) / np.diff(np.log(axes.get_ylim()))[0]
        axes.annotate("tolerance", (1.0, float(at)), (4, 0), "axes fraction", "offset points", va="center", color=INK)
        axes.set_ylabel("residual [1]")
        axes.set_xlabel(over.label)

    yield Panel("Out-of-balance force over external force", draw)


KINDS: dict[str, Callable[[Result], Iterator[Panel]]] = {
    "energies": _energies,
    "steps": _steps,
    "reactions": _reactions,
    "probes": _probes,
    "load": _load,
    "residual": _residual,
}
