"""What a report on a run says, ready to be laid out as a page for a browser or for paper."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from . import colours, page
from .camera import View
from .colours import Scale, draw_legend
from .energies import facts
from .honest import Failure, failure, numbers
from .load import Result
from .plot import KINDS, Panel, panels
from .scene import Scene
from .units import quantity

PICTURE = (720, 540)  # pixels
MARKED = (1080, 640)
MARK = "#D55E00"
STATUS = {
    "done": "done",
    "failed": "failed",
    "interrupted": "interrupted",
    "running": "not finished: still running, or killed",
}
UNITS = {"m": "m", "J": "J", "N": "N", "deg": "°", "seconds": "s"}  # endings of the names in /statistics
DRAWN = ("energies", "load", "steps", "residual")


@dataclass(frozen=True)
class Picture:
    """An image with what is below it."""

    caption: str
    pixels: np.ndarray  # (height, width, 3) of bytes


@dataclass(frozen=True)
class Report:
    """All of it, in the order of the page."""

    title: str
    status: str  # a key of STATUS
    failure: Failure | None
    failed_at: Picture | None
    ran: list[tuple[str, str]]
    pictures: list[list[Picture]]  # rows
    panels: list[Panel]
    numbers: list[tuple[str, str, str]]
    warnings: tuple[str, ...]
    statistics: list[tuple[str, str, str]]
    case: str  # TOML


def report(result: Result) -> Report:
    """Draws all pictures of a result."""
    failed = failure(result)
    return Report(
        title=result.title,
        status=result.status,
        failure=failed,
        failed_at=None if failed is None else _marked(result, failed),
        ran=_ran(result),
        pictures=_pictures(result),
        panels=_panels(result),
        numbers=numbers(result),
        warnings=result.warnings,
        statistics=statistics(result),
        case=str(result.attributes.get("case", "")).strip(),
    )


def statistics(result: Result) -> list[tuple[str, str, str]]:
    """Rows (name, value, description) of /statistics."""
    try:
        described: dict[str, Any] = json.loads(result.statistics.get("descriptions", "{}"))
    except (TypeError, ValueError):
        described = {}
    rows = []
    for name, value in sorted(result.statistics.items()):
        if name != "descriptions":
            rows.append((*_named(name, value), str(described.get(name, ""))))
    return rows


def _named(name: str, value: Any) -> tuple[str, str]:
    """("deepest_penetration_m", 5e-6) -> ("deepest penetration", "5 µm")."""
    stem, _, unit = name.rpartition("_")
    if unit in UNITS and isinstance(value, int | float):
        shown = (
            f"{value:.3g}°" if unit == "deg" else quantity(float(value), UNITS[unit]) if value else f"0 {UNITS[unit]}"
        )
        return (stem.replace("_", " ") + (" time" if unit == "seconds" else ""), shown)
    return name.replace("_", " "), f"{value:.4g}" if isinstance(value, float) else str(value)


def _ran(result: Result) -> list[tuple[str, str]]:
    known = {"analysis": result.analysis, **dict(facts(result))}
    known.pop("deepest penetration", None)
    known.pop("status", None)
    rows = [(name, known.pop(name)) for name in ("model", "analysis", "integrator") if name in known]
    rows += list(known.items())
    rows.append(("frames", str(len(result.time))))
    if result.obstacles:
        rows.append(("obstacles", ", ".join(f"{name} ({o.kind})" for name, o in result.obstacles.items())))
    for name, key in (("computing time", "cpu_seconds"), ("wall-clock time", "wall_seconds")):
        if key in result.statistics:
            rows.append((name, quantity(float(result.statistics[key]), "s")))
    version, form = (result.attributes.get(name, "?") for name in ("sundrape_version", "format_version"))
    rows.append(("version", f"sundrape {version}, file format {form}"))
    rows.append(("file", result.path.name))
    return rows


def _panels(result: Result) -> list[Panel]:
    return panels(result, [name for name in DRAWN if any(True for _ in KINDS[name](result))])


def _pictures(result: Result) -> list[list[Picture]]:
    """Start, middle and end: a row of the cloth, one of its strain."""
    frames = result.telling_frames(3)
    rows: list[list[Picture]] = []
    strain = colours.scale_of(result, "strain", frames)
    for scale in (None, strain):
        scene = Scene(result, frames, PICTURE, page.Room(bottom=0.16) if scale else page.Room(), scale)
        rows.append([])
        for frame in frames:
            pixels = scene.draw(frame)
            caption = page.caption(result, frame)
            if scale is not None:
                pixels, caption = _with_legend(pixels, scale), f"{caption}, {scale.field.label}"
            rows[-1].append(Picture(caption, pixels))
        scene.close()
    return rows


def _marked(result: Result, failed: Failure) -> Picture:
    scene = Scene(result, [failed.frame], MARKED, page.Room(top=0.05, bottom=0.05))
    pixels = scene.draw(failed.frame)
    scene.close()
    text = ", ".join(
        dict.fromkeys(["the last good state", f"frame {failed.frame}", page.caption(result, failed.frame)])
    )
    if failed.places:
        pixels = _annotated(pixels, lambda figure: mark(figure, scene.view, failed.places, MARKED))
        text += "; where it failed is marked"
    return Picture(text, pixels)


def mark(figure: Figure, view: View, places: tuple[tuple[str, np.ndarray], ...], size: tuple[int, int]) -> None:
    """A ring about each place (3,) [m] in a picture of `size` that fills the figure, and its label."""
    for row, (label, place) in enumerate(places):
        x, y = view.pixels(place[None], size)[0] / size
        ring = plt.Line2D([x], [y], marker="o", markersize=17, color=MARK, markerfacecolor="none", markeredgewidth=2.2)
        ring.set_path_effects([withStroke(linewidth=4.5, foreground="white")])
        figure.add_artist(ring)
        side = -1 if x > 0.7 else 1
        text = figure.text(x + side * 0.016, y + 0.03 + 0.035 * row, label, ha="left" if side > 0 else "right")
        text.set(fontsize=11, fontweight="bold", color=MARK)
        text.set_path_effects([withStroke(linewidth=4, foreground="white")])


def _with_legend(pixels: np.ndarray, scale: Scale) -> np.ndarray:
    return _annotated(pixels, lambda figure: draw_legend(figure, scale, (0.06, 0.085, 0.52, 0.026), 14))


def _annotated(pixels: np.ndarray, draw: Callable[[Figure], None]) -> np.ndarray:
    size = (pixels.shape[1], pixels.shape[0])
    with plt.rc_context(page.STYLE):
        figure = page.new_figure(size)
        try:
            page.place_image(figure, pixels, 0)
            draw(figure)
            figure.canvas.draw()
            return np.asarray(figure.canvas.buffer_rgba())[..., :3].copy()
        finally:
            plt.close(figure)
