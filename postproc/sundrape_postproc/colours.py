"""A field as colours: its range over the frames shown, the colour of every value, and the legend that says so."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from . import fields
from .errors import BAD_USE, PostprocError
from .load import Result
from .units import scale_for

WHITE = (
    0.28  # mixed into cividis, legend and cloth alike: shading would not show on its dark blue, and folds are shading
)
COLOUR_MAP = ListedColormap(
    (1 - WHITE) * matplotlib.colormaps["cividis"](np.linspace(0, 1, 256))[:, :3] + WHITE, "light cividis"
)
PERCENTILE = 99.5  # that the range ends at: single nodes do not set it
WEAVE = "weave"  # the look without a field
NAMES = (WEAVE, *fields.FIELDS)


@dataclass(frozen=True)
class Scale:
    """The range of colours of one field."""

    field: fields.Field
    low: float  # in the field's SI unit
    high: float
    extend: str = "neither"  # neither | min | max | both: where values lie beyond the range

    def rgb(self, values: np.ndarray) -> np.ndarray:
        """(P,) in SI -> (P, 3) of bytes; beyond the range the colour of its end, grey where there is no number."""
        finite = np.isfinite(values)
        share = np.clip((np.where(finite, values, self.low) - self.low) / (self.high - self.low), 0, 1)
        colours = COLOUR_MAP(share, bytes=True)[:, :3]
        return np.where(finite[:, None], colours, np.uint8(128)).astype(np.uint8)

    @property
    def shown(self) -> tuple[float, str]:
        """(factor, unit) that the legend has: % for ratios, an SI prefix otherwise."""
        if self.field.unit == "1":
            return 100.0, "%"
        if self.field.unit.startswith("1/"):  # a prefix there would belong to the denominator
            return 1.0, self.field.unit
        factor, prefix = scale_for(max(abs(self.low), abs(self.high)))
        return factor, prefix + self.field.unit

    @property
    def label(self) -> str:
        return f"{self.field.label} [{self.shown[1]}]"


def scale_of(result: Result, name: str, frames: Sequence[int], limits: tuple[float, float] | None = None) -> Scale:
    """From 0 to the 99.5th percentile over the frames, or between the `limits` given in the field's SI unit.

    Raises PostprocError, status 2: no such field, or a result without what it needs.
    """
    field = fields.field(name)
    seen = np.concatenate([fields.values(result, name, frame).astype(np.float32) for frame in frames])
    seen = seen[np.isfinite(seen)]
    if limits is None:
        top = float(np.percentile(seen, PERCENTILE)) if seen.size else 0.0
        limits = (0.0, top if top > 0 else max(float(seen.max(initial=0.0)), 0.0) or 1.0)
    low, high = limits
    below, above = bool((seen < low - 1e-6 * (high - low)).any()), bool((seen > high + 1e-6 * (high - low)).any())
    return Scale(field, low, high, {(0, 0): "neither", (1, 0): "min", (0, 1): "max", (1, 1): "both"}[below, above])


def draw_legend(figure: Figure, scale: Scale, box: tuple[float, float, float, float], text: float = 8.5) -> None:
    """A level bar in `box` (left, bottom, width, height of the bar, over the figure's size); its label is above it."""
    factor, _ = scale.shown
    axes = figure.add_axes(box)
    colours = ScalarMappable(Normalize(factor * scale.low, factor * scale.high), COLOUR_MAP)
    bar = figure.colorbar(colours, cax=axes, orientation="horizontal", extend=scale.extend, extendfrac=0.06)
    bar.locator = MaxNLocator(4, steps=[1, 2, 2.5, 5, 10], min_n_ticks=3)
    bar.update_ticks()
    bar.outline.set_linewidth(0.5)
    axes.tick_params(labelsize=text, length=2.5, width=0.5, pad=2)
    axes.set_title(scale.label, fontsize=text, fontweight="normal", loc="left", pad=4)


def parse_range(text: str) -> tuple[float, float]:
    """ "a:b" in SI -> (a, b), a < b.

    Raises PostprocError, status 2.
    """
    try:
        low, high = (float(part) for part in text.split(":"))
    except ValueError:
        low = high = 0.0
    if not (np.isfinite([low, high]).all() and low < high):
        raise PostprocError(f"--range {text}: not LOW:HIGH, two numbers in SI units, the lower one first", BAD_USE)
    return low, high
