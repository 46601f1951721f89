"""Puts scenes and diagrams on one page with matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from .camera import Room
from .colours import Scale, draw_legend
from .energies import FAINT, INK, draw_history, draw_residual, facts
from .errors import PostprocError
from .load import Result
from .units import quantity

DPI = 110
SCENE_SHARE = 0.60  # of the picture's width
TITLE_ROOM = Room(top=0.11, bottom=0.03)
CAPTION_ROOM = Room(bottom=0.10)
LEGEND_ROOM = 0.12  # of the height, for a legend below
STRIP_LEGEND_ROOM = 0.20  # of a filmstrip's height, for a legend above
GUTTER = 6  # pixels of white between the scenes of a filmstrip
STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 8.5,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.edgecolor": FAINT,
    "axes.labelcolor": INK,
    "axes.titlecolor": INK,
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.color": INK,
    "ytick.color": INK,
    "text.color": INK,
}


def scene_size(size: tuple[int, int]) -> tuple[int, int]:
    """Pixels of the 3D part of a picture of `size` (width, height)."""
    return round(SCENE_SHARE * size[0]), size[1]


def panel_size(size: tuple[int, int], count: int) -> tuple[int, int]:
    """Pixels of each of `count` scenes in a filmstrip of `size` (width, height)."""
    return (size[0] - GUTTER * (count - 1)) // count, size[1]


def room(scale: Scale | None) -> Room:
    """What a scene with a title leaves free, and with a legend if there is one."""
    return TITLE_ROOM if scale is None else Room(TITLE_ROOM.top, LEGEND_ROOM)


def strip_room(scale: Scale | None) -> Room:
    """What the scenes of a filmstrip leave free."""
    return CAPTION_ROOM if scale is None else Room(STRIP_LEGEND_ROOM, CAPTION_ROOM.bottom)


def caption(result: Result, frame: int) -> str:
    if result.analysis == "arc-length":
        return f"load factor {result.time[frame]:.3g}{stage(result, frame)}"
    if not result.has_time:
        return "at rest" if frame == len(result.time) - 1 and result.status == "done" else f"frame {frame}"
    return f"t = {quantity(float(result.time[frame]), 's')}"


def stage(result: Result, frame: int) -> str:
    """ ", stage 2" where an equilibrium path has several."""
    stages = result.frames.get("stage")
    return "" if stages is None or stages.max() < 2 else f", stage {int(stages[frame])}"


def picture(result: Result, frame: int, scene: np.ndarray, size: tuple[int, int], scale: Scale | None = None) -> Figure:
    """The scene (height, width, 3) at the left, its diagrams and table at the right."""
    with plt.rc_context(STYLE):
        figure = new_figure(size)
        place_image(figure, scene, 0)
        figure.text(0.022, 0.955, result.title, fontsize=14, fontweight="bold", va="top", wrap=False)
        figure.text(0.022, 0.905, caption(result, frame), fontsize=9.5, va="top")
        if scale is not None:
            draw_legend(figure, scale, (0.028, 0.055, 0.20, 0.016))
        left, width = SCENE_SHARE + 0.062, 1 - SCENE_SHARE - 0.062 - 0.105
        upper = figure.add_axes((left, 0.60, width, 0.335))
        lower = figure.add_axes((left, 0.285, width, 0.235))
        if result.is_static:
            upper.set_position((left, 0.64, width + 0.07, 0.295))
            lower.set_position((left + 0.02, 0.30, width + 0.05, 0.20))
            draw_residual(upper, lower, result)
        else:
            draw_history(upper, lower, result, frame)
        rows = facts(result)
        for row, (name, value) in enumerate(rows):
            height = 0.168 - 0.031 * row
            figure.text(left - 0.042, height, name, color="#6a6a6a", va="baseline")
            figure.text(left + 0.082, height, value, va="baseline")
        return figure


def filmstrip(
    result: Result,
    frames: Sequence[int],
    scenes: Sequence[np.ndarray],
    size: tuple[int, int],
    scale: Scale | None = None,
) -> Figure:
    """Scenes side by side, each with its time."""
    with plt.rc_context(STYLE):
        figure = new_figure(size)
        for k, (frame, scene) in enumerate(zip(frames, scenes)):
            left = k * (scene.shape[1] + GUTTER)
            place_image(figure, scene, left)
            figure.text((left + scene.shape[1] / 2) / size[0], 0.05, caption(result, frame), ha="center", fontsize=10)
        if scale is not None:
            width = min(0.22 * size[0], 0.7 * scenes[0].shape[1]) / size[0]
            draw_legend(figure, scale, (0.03, 1 - 34 / size[1], width, 10 / size[1]))
        return figure


def save(figure: Figure, path: Path) -> None:
    # SVG has a date and random names otherwise, and differs each time
    metadata = {"Date": None} if path.suffix == ".svg" else None
    try:
        with plt.rc_context({"svg.hashsalt": "sundrape"}):
            figure.savefig(path, dpi=DPI, metadata=metadata)
    except (OSError, ValueError) as trouble:
        raise PostprocError(f"{path}: cannot be written: {trouble}") from trouble
    finally:
        plt.close(figure)


def new_figure(size: tuple[int, int]) -> Figure:
    """A white page of `size` pixels (width, height)."""
    return plt.figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI, facecolor="white")


def place_image(figure: Figure, image: np.ndarray, left: int, bottom: int = 0) -> None:
    """Pixel for pixel: the image is not resampled."""
    figure.figimage(image, xo=left, yo=bottom, origin="upper", zorder=-1)  # below axes that lie on it
