"""Draws drape tests: each one's shadow in plan, the polar profiles below or beside, and the numbers."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from .drape import Drape
from .energies import INK, Look, spread
from .page import STYLE, new_figure

CM = 100.0  # per metre
MOST = 6  # tests on a page
LOOKS = (  # Okabe & Ito, told apart in grey by the dashes and by the label at the curve's end
    Look("", "#0072B2"),
    Look("", "#D55E00", (0, (6, 1.6))),
    Look("", "#009E73", (0, (3, 1.2))),
    Look("", "#7a5230", (0, (6, 1.4, 1, 1.4))),
    Look("", "#CC79A7", (0, (1, 1))),
    Look("", "#555555", (0, (3, 1.2, 1, 1.2))),
)
SHADOW = "#d5dce2"
SUPPORT_DASHES, SPECIMEN_DASHES = (0, (1.2, 1.6)), (0, (5, 2.5))


def page(title: str, drapes: Sequence[Drape], size: tuple[int, int]) -> Figure:
    """One test: plan, profile and table side by side; several: plans in a row, their profiles in one diagram below."""
    with plt.rc_context(STYLE):
        figure = new_figure(size)
        figure.text(0.02, 0.975, title, fontsize=13, fontweight="bold", va="top")
        if len(drapes) == 1:
            _single(figure, drapes[0])
        else:
            _row(figure, drapes)
        return figure


def _single(figure: Figure, drape: Drape) -> None:
    width, height = figure.get_size_inches()
    side = 0.74  # of the page's height
    plan = figure.add_axes((0.062, 0.11, side * height / width, side))
    _plan(plan, drape, LOOKS[0], 1.06 * _reach([drape]))
    plan.set_ylabel("y [cm]")
    plan.set_title(_heading(drape), loc="left")
    left = 0.062 + side * height / width + 0.09
    profile = figure.add_axes((left, 0.43, 0.965 - left, 0.42))
    _profiles(profile, [drape], [LOOKS[0]])
    profile.set_title("Outermost point of the shadow", loc="left")
    rows = _facts(drape)
    half = -(-len(rows) // 2)
    for k, (name, value) in enumerate(rows):
        x = left + 0.235 * (k // half)
        y = 0.27 - 0.045 * (k % half)
        figure.text(x, y, name, color="#5a5a5a")
        figure.text(x + 0.108, y, value)


def _row(figure: Figure, drapes: Sequence[Drape]) -> None:
    width, height = figure.get_size_inches()
    left, right, gap = 0.055, 0.985, 0.014
    share = (right - left - gap * (len(drapes) - 1)) / len(drapes)
    tall = min(share * width / height, 0.42)
    share = tall * height / width
    reach = 1.06 * _reach(drapes)
    for k, (drape, look) in enumerate(zip(drapes, LOOKS)):
        plan = figure.add_axes((left + k * (share + gap), 0.865 - tall, share, tall))
        _plan(plan, drape, look, reach)
        plan.set_title(f"{_heading(drape)}\n", loc="left")
        numbers = f"drape coefficient {100 * drape.coefficient:.1f} %, {_count(drape)}"
        plan.text(0, 1.02, numbers, transform=plan.transAxes, va="bottom", fontsize=8.5)
        if k == 0:
            plan.set_ylabel("y [cm]")
        else:
            plan.tick_params(labelleft=False)
    profile = figure.add_axes((left, 0.085, 0.80 - left, 0.865 - tall - 0.085 - 0.125))
    _profiles(profile, drapes, LOOKS)
    profile.set_title("Outermost point of the shadow", loc="left")


def _plan(axes: Axes, drape: Drape, look: Look, reach: float) -> None:
    """The shadow from above with the circles of specimen and support; folds have a mark and a number."""
    axes.fill(*(CM * drape.outline.T), facecolor=SHADOW, edgecolor=look.colour, linewidth=1.6)
    for radius, dashes in ((drape.support_radius, SUPPORT_DASHES), (drape.specimen_radius, SPECIMEN_DASHES)):
        axes.add_patch(Circle((0, 0), CM * radius, fill=False, color=INK, linewidth=1.0, linestyle=dashes))
    at_support = (0, -CM * drape.support_radius)
    axes.annotate("support", at_support, (0, 4), textcoords="offset points", ha="center", fontsize=7.5)
    specimen = "specimen" if drape.is_disc else "circle of the\nspecimen's area"
    axes.text(0.99, 0.012, specimen, transform=axes.transAxes, ha="right", va="bottom", fontsize=7.5)
    at = drape.folds.peaks
    x, y = CM * drape.radius[at] * np.array([np.cos(drape.angle[at]), np.sin(drape.angle[at])])
    axes.plot(x, y, "o", color=look.colour, markersize=5, markeredgecolor="white", markeredgewidth=0.8, zorder=5)
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    axes.xaxis.set_major_locator(plt.MultipleLocator(_step(reach)))
    axes.yaxis.set_major_locator(plt.MultipleLocator(_step(reach)))
    axes.set_xlabel("x [cm]")


def _profiles(axes: Axes, drapes: Sequence[Drape], looks: Sequence[Look]) -> None:
    """Radius against angle; a dot at every fold; the radii of specimen and support where all tests share them."""
    ends = []
    for drape, look in zip(drapes, looks):
        degrees = np.degrees(np.append(drape.angle, 2 * np.pi))
        radius = CM * np.append(drape.radius, drape.radius[0])
        axes.plot(degrees, radius, color=look.colour, linestyle=look.dashes, linewidth=1.6)
        at = drape.folds.peaks
        axes.plot(
            degrees[at], radius[at], "o", color=look.colour, markersize=5, markeredgecolor="white", markeredgewidth=0.8, zorder=5
        )
        ends.append((float(radius[-1]), drape.label, look.colour))
    axes.grid(True, color="#e9e9e9", linewidth=0.7)
    axes.set_xlim(0, 360)
    axes.set_xticks(range(0, 361, 45))
    axes.set_xlabel("direction, anticlockwise from x [°]")
    axes.set_ylabel("radius [cm]")
    lines = []
    for name in ("specimen", "support"):
        radii = {round(CM * getattr(drape, f"{name}_radius"), 6) for drape in drapes}
        if len(radii) == 1:
            dashes = SPECIMEN_DASHES if name == "specimen" else SUPPORT_DASHES
            lines.append((radii.pop(), name))
            axes.axhline(lines[-1][0], color=INK, linewidth=1.0, linestyle=dashes)
    values = [line for line, _ in lines]
    values += [CM * r for drape in drapes for r in (drape.radius.min(), drape.radius.max())]
    room = 0.09 * (max(values) - min(values))
    axes.set_ylim(min(values) - room, max(values) + room)
    for value, name in lines:
        axes.annotate(
            name, (1, value), (-3, 2.5), ("axes fraction", "data"), "offset points", ha="right", va="bottom", fontsize=7.5
        )
    if len(drapes) > 1:
        _label_ends(axes, ends)


def _label_ends(axes: Axes, ends: Sequence[tuple[float, str, str]]) -> None:
    """Names at the right, pushed apart where they would overlap, each joined to its curve."""
    low, high = axes.get_ylim()
    line = 1.4 * 8.5 / (axes.get_position().height * axes.figure.get_figheight() * 72)
    order = sorted(ends)
    places = spread(np.array([(value - low) / (high - low) for value, _, _ in order]), line)
    for (value, label, colour), place in zip(order, places):
        axes.annotate(
            label,
            (1.0, (value - low) / (high - low)),
            (1.035, place),
            "axes fraction",
            "axes fraction",
            color=colour,
            va="center",
            annotation_clip=False,
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0},
        )


def _facts(drape: Drape) -> list[tuple[str, str]]:
    """Rows (name, value) of the table."""
    rows = [
        ("drape coefficient", f"{100 * drape.coefficient:.2f} %"),
        ("shadow", f"{1e4 * drape.shadow_area:.2f} cm²"),
        ("specimen", f"{1e4 * drape.specimen_area:.2f} cm²"),
        ("support", f"{1e4 * drape.support_area:.2f} cm²"),
        ("mean radius", f"{CM * drape.mean_radius:.2f} cm"),
        ("folds", str(drape.fold_count)),
        ("fold depth", f"{CM * drape.fold_depth:.2f} cm"),
        ("largest wave", f"{drape.harmonic} a turn, ±{CM * drape.harmonic_amplitude:.2f} cm" if drape.harmonic else "none"),
        ("asymmetry", "–" if drape.asymmetry is None else f"{drape.asymmetry:.2f}"),
        ("off the axis by", f"{CM * drape.offset:.2f} cm"),
    ]
    if drape.crossings:
        rows.append(("crossings", str(drape.crossings)))
    return rows


def _heading(drape: Drape) -> str:
    """Its name, and what to know before one believes it."""
    notes = [f"run {drape.status}"] if drape.status != "done" else []
    notes += [] if drape.is_last else [f"frame {drape.frame}"]
    return f"{drape.label} ({', '.join(notes)})" if notes else drape.label


def _count(drape: Drape) -> str:
    return f"{drape.fold_count} fold" + ("" if drape.fold_count == 1 else "s")


def _reach(drapes: Sequence[Drape]) -> float:
    """Largest radius on the page [cm]."""
    return CM * max(max(drape.specimen_radius, float(drape.radius.max())) for drape in drapes)


def _step(reach: float) -> float:
    """Round distance [cm] between ticks, about three to a side."""
    power = 10.0 ** np.floor(np.log10(reach / 3))
    return float(power * min((1, 2, 5, 10), key=lambda m: abs(m * power - reach / 3)))
