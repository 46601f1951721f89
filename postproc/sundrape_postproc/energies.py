"""The right-hand side of the picture: energies over time, or the residual of a static analysis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from .course import course
from .load import Result
from .units import quantity, scale_for

INK, FAINT = "#2b2b2b", "#8a8a8a"


@dataclass(frozen=True)
class Look:
    """Colours of Okabe & Ito, told apart in grey by the dashes and by the label at the curve's end."""

    label: str
    colour: str
    dashes: str | tuple[int, tuple[float, ...]] = "-"


GIVEN_AND_LOST = {
    "gravity": Look("gravity", "#0072B2"),
    "kinetic": Look("kinetic", "#D55E00"),
    "dissipated": Look("dissipated", "#009E73", (0, (5, 1.6))),
    "external_work": Look("external work", "#7a5230", (0, (1, 1.2))),
    "method_dissipated": Look("lost by method", "#555555", (0, (4, 1.4, 1, 1.4))),
}
STORED = {
    "membrane": Look("membrane", "#0072B2"),
    "shear": Look("shear", "#E69F00", (0, (5, 1.6))),
    "bending": Look("bending", "#CC79A7"),
    "contact": Look("contact", "#555555", (0, (1, 1.2))),
}
RESERVOIRS = ("kinetic", "membrane", "shear", "bending", "gravity", "contact")


def method_dissipation(result: Result) -> np.ndarray | None:
    """What the integrator itself took out of the system (F,) [J]: the balance of work, stored energy and dissipation.

    Taken from the file where it is stored; None when a term of the balance is missing.
    """
    if "method_dissipated" in result.energies:
        return result.energies["method_dissipated"]
    if not {"kinetic", "gravity", "dissipated"} <= result.energies.keys():
        return None
    total = sum(result.energies[name] for name in RESERVOIRS if name in result.energies)
    work = result.energies.get("external_work", np.zeros_like(result.time))
    dissipated = result.energies["dissipated"]
    return (work - work[0]) - (total - total[0]) - (dissipated - dissipated[0])


def deepest_penetration(result: Result) -> float | None:
    """[m], of the whole motion (statics: of its end) where statistics tell, else of the frames; None where nothing tells."""
    value = result.statistics.get("deepest_penetration_m")
    if isinstance(value, int | float):
        return float(value)
    if result.penetration is None or not np.isfinite(result.penetration).any():
        return None
    return float(result.penetration[-1] if result.is_static else np.nanmax(result.penetration))


def facts(result: Result) -> list[tuple[str, str]]:
    """Rows (name, value) of the table."""
    rows = [("model", f"{result.model}, {_whole(result.position.shape[1])} nodes, {_whole(len(result.quads))} faces")]
    steps = len(next(iter(result.steps.values()), ()))
    if result.is_static:
        rows.append(("analysis", result.analysis))
        name = "steps of the path" if result.analysis == "arc-length" else "iterations"
        name = "equilibria" if result.has_time else name
        rows.append((name, _whole(steps) if steps else "–"))
    else:
        integrator = result.statistics.get("integrator") or result.case.get("dynamics", {}).get("integrator", "cvode")
        rows.append(("integrator", str(integrator).upper()))
        rows.append(("steps", f"{_whole(steps)} for {quantity(float(result.time[-1]), 's')}"))
    penetration = deepest_penetration(result)
    if penetration is not None:
        rows.append(("deepest penetration", quantity(penetration, "m", 2) if penetration > 0 else "none"))
    if result.status != "done":
        rows.append(("status", result.status))
    return rows


def _whole(number: int) -> str:
    return f"{number:,}".replace(",", "\u2009")  # thin spaces between thousands


def balance(result: Result) -> dict[str, np.ndarray]:
    """The energies (F,) [J], gravity's from the first frame on, with what the method lost where that is known."""
    curves = {name: np.array(value, dtype=float) for name, value in result.energies.items()}
    if "gravity" in curves:
        curves["gravity"] = curves["gravity"] - curves["gravity"][0]  # its zero is arbitrary
    method = method_dissipation(result)
    if method is not None:
        curves["method_dissipated"] = method
    return curves


def draw_history(upper: Axes, lower: Axes, result: Result, frame: int) -> None:
    """Energies [J] of a dynamic run: what gravity gives and what becomes of it above, what the cloth stores below."""
    curves, over = balance(result), course(result)
    for axes, looks in ((upper, GIVEN_AND_LOST), (lower, STORED)):
        draw_curves(axes, over.values, curves, looks, "energy", "J")
        if frame < len(over.values) - 1:
            axes.axvline(over.values[frame], color=INK, linewidth=0.8, linestyle=(0, (2, 2)))
    upper.set_title("Energy (gravity: change from the start)", loc="left")
    lower.set_title("Energy stored in the cloth and its contact", loc="left")
    upper.tick_params(labelbottom=False)
    lower.set_xlabel(over.label)


def draw_residual(upper: Axes, lower: Axes, result: Result) -> None:
    """Convergence of a static analysis above, its energies at rest below."""
    name = next((n for n in ("residual", "relative_residual") if n in result.steps), None)
    residual = result.steps[name] if name else result.residual
    upper.set_title("Out-of-balance force over external force", loc="left")
    upper.set_xlabel("iteration" if name else "frame")
    upper.grid(True, which="major", color="#e4e4e4", linewidth=0.7)
    if residual is not None and np.any(np.asarray(residual) > 0):
        positive = np.where(np.asarray(residual) > 0, residual, np.nan)
        upper.semilogy(np.arange(1, len(positive) + 1), positive, color="#0072B2", linewidth=1.5)
        tolerance = float(result.case.get(result.analysis, {}).get("tolerance", 1e-6))
        upper.axhline(tolerance, color=INK, linewidth=0.8, linestyle=(0, (4, 2)))
        upper.annotate("tolerance", (0, tolerance), (3, 3), ("axes fraction", "data"), "offset points", color=INK)
        upper.margins(x=0.01)
    _bars(lower, result)


def draw_curves(
    axes: Axes, x: np.ndarray, curves: Mapping[str, np.ndarray], looks: Mapping[str, Look], what: str, unit: str
) -> None:
    """`curves` over `x`, zeros left out, each with its label at its right end; the y axis has `what` and SI `unit`."""
    shown = {name: curves[name] for name in looks if name in curves and np.any(np.nan_to_num(curves[name]) != 0)}
    largest = max((float(np.nanmax(np.abs(c))) for c in shown.values()), default=0.0)
    factor, prefix = scale_for(largest)
    ends: list[tuple[float, str, str]] = []
    if not shown:
        axes.annotate("none in this result", (0.5, 0.5), xycoords="axes fraction", ha="center", color=FAINT)
        axes.set_yticks([])
    for name, curve in shown.items():
        look = looks[name]
        axes.plot(x, factor * curve, color=look.colour, linestyle=look.dashes, linewidth=1.6)
        finite = np.flatnonzero(np.isfinite(curve))
        ends.append((float(factor * curve[finite[-1]]), look.label, look.colour))
    axes.set_ylabel(f"{what} [{prefix}{unit}]")
    axes.axhline(0, color=FAINT, linewidth=0.6, zorder=0)
    axes.grid(True, color="#e9e9e9", linewidth=0.7)
    low, high = float(np.min(x)), float(np.max(x))
    axes.set_xlim(low, high if high > low else low + 1)
    label_ends(axes, ends)


def label_ends(axes: Axes, ends: Sequence[tuple[float, str, str]]) -> None:
    """Names at the curves' right ends, pushed apart where they would overlap, each joined to its curve."""
    if not ends:
        return
    low, high = axes.get_ylim()
    axes.set_ylim(low, high)
    height = axes.get_position().height * axes.figure.get_figheight() * 72  # points
    line = 1.25 * 8.5 / height
    order = sorted(ends)
    wanted = np.array([np.clip((value - low) / (high - low), 0, 1) for value, _, _ in order])
    placed = spread(wanted, line)
    for (value, label, colour), place in zip(order, placed):
        at = (value - low) / (high - low)
        axes.annotate(
            label,
            xy=(1.0, at),
            xytext=(1.045, place),
            xycoords="axes fraction",
            textcoords="axes fraction",
            color=colour,
            va="center",
            annotation_clip=False,
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0},
        )


def spread(wanted: np.ndarray, gap: float) -> np.ndarray:
    """Ascending places moved as little as may be so that neighbours are at least `gap` apart."""
    groups: list[list[float]] = []  # [sum of (wanted - offset in group), members]
    for place in wanted:
        groups.append([float(place), 1])
        while len(groups) > 1 and _start(groups[-2]) + groups[-2][1] * gap > _start(groups[-1]):
            total, members = groups.pop()
            before = groups[-1]
            before[0] += total - before[1] * gap * members
            before[1] += members
    return np.array([_start(group) + k * gap for group in groups for k in range(int(group[1]))])


def _start(group: list[float]) -> float:
    return group[0] / group[1]


def _bars(axes: Axes, result: Result) -> None:
    energies = {name: float(result.energies[name][-1]) for name in STORED if name in result.energies}
    axes.set_title("Energy at rest", loc="left")
    factor, prefix = scale_for(max(map(abs, energies.values()), default=0.0))
    names = list(energies)[::-1]
    values = [factor * energies[name] for name in names]
    axes.barh([STORED[name].label for name in names], values, color=[STORED[name].colour for name in names], height=0.6)
    for row, value in enumerate(values):
        axes.annotate(f"{value:.3g}", (value, row), (4, 0), "data", "offset points", va="center", color=INK)
    axes.margins(x=0.14)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(f"energy [{prefix}J]")
