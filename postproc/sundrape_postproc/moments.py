"""Moments of a motion between the frames that a result has."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from .load import Obstacle, Result


@dataclass(frozen=True)
class Moment:
    """A frame, or a mixture of two."""

    before: int
    after: int
    share: float = 0.0  # of `after`, from 0 to below 1

    def mixed(self, first: np.ndarray, second: np.ndarray) -> np.ndarray:
        """Linear between a quantity at `before` and the same at `after`."""
        return first if self.share == 0 else (1 - self.share) * first + self.share * second

    def time(self, result: Result) -> float:
        """[s], or the load factor."""
        return float(self.mixed(result.time[self.before], result.time[self.after]))

    def position(self, result: Result) -> np.ndarray:
        """(N, 3) [m]."""
        return self.mixed(result.position[self.before], result.position[self.after])

    def obstacles(self, result: Result) -> list[Obstacle]:
        """Where they stand."""
        return [self._placed(obstacle) for obstacle in result.obstacles.values()]

    def _placed(self, obstacle: Obstacle) -> Obstacle:
        first, second = obstacle.at(self.before), obstacle.at(self.after)
        if obstacle.path is None or self.share == 0:
            return first
        left, _, right = np.linalg.svd(self.mixed(first.rotation, second.rotation))  # the rotation next to the mixture
        return replace(first, position=self.mixed(first.position, second.position), rotation=left @ right)


def at_frame(frame: int) -> Moment:
    return Moment(frame, frame)


def evenly_in_time(result: Result, frames: Sequence[int], step: float) -> list[Moment]:
    """Every `step` seconds from the first to the last of the `frames`, mixtures of those next to it."""
    times = result.time[list(frames)]
    count = math.floor((times[-1] - times[0]) / step * (1 + 1e-12) + 1e-9) + 1
    wanted = times[0] + step * np.arange(count)
    found = []
    for time in wanted:
        k = int(np.clip(np.searchsorted(times, time, side="right") - 1, 0, max(len(frames) - 2, 0)))
        if len(frames) == 1 or times[k + 1] <= times[k]:
            found.append(at_frame(frames[k]))
            continue
        share = float(np.clip((time - times[k]) / (times[k + 1] - times[k]), 0, 1))
        found.append(at_frame(frames[k + 1]) if share > 1 - 1e-9 else Moment(frames[k], frames[k + 1], share))
    return found
