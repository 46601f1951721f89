"""What the diagrams of a result go over: its time, or the number of the frame where an analysis has none."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .load import Result
from .units import scale_for


@dataclass(frozen=True)
class Course:
    values: np.ndarray  # (F,) in the unit of the label
    label: str
    factor: float = 1.0  # from SI to the label's unit


def course(result: Result) -> Course:
    """Of the frames."""
    if result.has_time:
        factor, prefix = scale_for(float(result.time[-1]))
        return Course(factor * result.time, f"time [{prefix}s]", factor)
    label = "frame along the path [1]" if result.analysis == "arc-length" else "frame [1]"
    return Course(np.arange(len(result.time), dtype=float), label)


def step_course(result: Result) -> Course:
    """Of the accepted steps, on the same axis where the frames have time."""
    rows = len(next(iter(result.steps.values()), ()))
    if result.has_time and "time" in result.steps:
        frames = course(result)
        return Course(frames.factor * result.steps["time"], frames.label, frames.factor)
    label = "step along the path [1]" if result.analysis == "arc-length" else "iteration [1]"
    return Course(np.arange(1, rows + 1, dtype=float), label)
