"""Where the scene is seen from: a long lens, three quarters round, slightly above, as wide as what is shown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

AZIMUTH, ELEVATION = -58.0, 24.0  # degrees; azimuth from the x axis
LENS = 20.0  # vertical opening, degrees
MARGIN = 1.07
REACH = 0.6  # how much of an obstacle beyond the cloth is fitted, over the cloth's largest extent


@dataclass(frozen=True)
class Room:
    """Parts of the picture's height that the scene leaves free."""

    top: float = 0.0
    bottom: float = 0.0


NO_ROOM = Room()


@dataclass(frozen=True)
class View:
    eye: np.ndarray  # (3,) [m]
    target: np.ndarray  # (3,) [m]
    radius: float  # of what is shown [m]
    middle: np.ndarray  # (3,) of what is shown [m]

    def pixels(self, points: np.ndarray, size: tuple[int, int]) -> np.ndarray:
        """Where points (P, 3) [m] are seen (P, 2) in a picture of `size` pixels, from its lower left corner."""
        back = self.eye - self.target
        back = back / np.linalg.norm(back)
        right = np.cross([0, 0, 1], back)
        right = right / np.linalg.norm(right)
        away = points - self.eye
        seen = np.stack([away @ right, away @ np.cross(back, right)], axis=1) / -(away @ back)[:, None]
        return np.array(size) / 2 + seen * size[1] / 2 / np.tan(np.radians(LENS / 2))

    def turned(self, angle: float) -> View:
        """From a camera that has gone round the middle by `angle` [rad], counter-clockwise from above."""
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        eye, target = (self.middle + turn @ (p - self.middle) for p in (self.eye, self.target))
        return replace(self, eye=eye, target=target)

    def apply(self, renderer: vtkRenderer) -> None:
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*self.eye)
        camera.SetFocalPoint(*self.target)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(LENS)
        distance = np.linalg.norm(self.eye - self.target)
        camera.SetClippingRange(max(distance - 6 * self.radius, 0.05 * distance), distance + 12 * self.radius)


def three_quarter(
    cloth: np.ndarray, bodies: Sequence[np.ndarray], aspect: float, free: Room = NO_ROOM, all_round: bool = False
) -> View:
    """Fit the cloth (P, 3) and the near parts of the bodies (Q, 3) [m] into a picture of width over height `aspect`.

    `all_round`: from wherever the view is turned to, about the vertical line through `View.middle`.
    """
    low, high = cloth.min(axis=0), cloth.max(axis=0)
    reach = REACH * max(float((high - low).max()), 1e-9)
    near = [np.clip(b, low - reach, high + reach) for b in bodies]
    points = np.concatenate([cloth, *near])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    if all_round:
        points = _revolved(points, middle)

    azimuth, elevation = np.radians(AZIMUTH), np.radians(ELEVATION)
    back = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    right = np.cross([0, 0, 1], back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    axes = np.stack([right, up, back])

    target = (points.min(axis=0) + points.max(axis=0)) / 2
    tangent = np.tan(np.radians(LENS / 2)) * np.array([aspect, 1.0 - free.top - free.bottom]) / MARGIN
    distance = 0.0
    for _ in range(4):  # centre the projection, then step back until all is inside; converges at once for a long lens
        local = (points - target) @ axes.T
        distance = float((np.abs(local[:, :2]) / tangent + local[:, 2:]).max())
        seen = local[:, :2] / (distance - local[:, 2:])
        shift = (seen.min(axis=0) + seen.max(axis=0)) / 2 * distance
        target = target + shift @ axes[:2]
    radius = float(np.linalg.norm(points - target, axis=1).max())
    target = target + (free.top - free.bottom) * np.tan(np.radians(LENS / 2)) * distance * up
    return View(target + distance * back, target, radius, middle)


def _revolved(points: np.ndarray, middle: np.ndarray, layers: int = 96, turns: int = 48) -> np.ndarray:
    """The outline of what points (P, 3) sweep when they turn about the vertical line through the middle."""
    low, high = points[:, 2].min(), points[:, 2].max()
    layer = np.minimum((layers * (points[:, 2] - low) / max(high - low, 1e-12)).astype(int), layers - 1)
    reach = np.zeros(layers)
    np.maximum.at(reach, layer, np.hypot(*(points[:, :2] - middle[:2]).T))
    full = np.flatnonzero(reach)
    angle = np.linspace(0, 2 * np.pi, turns, endpoint=False)
    rings = [
        np.stack([middle[0] + r * np.cos(angle), middle[1] + r * np.sin(angle), np.full(turns, height)], axis=1)
        for edge in (0, 1)
        for r, height in zip(reach[full], low + (full + edge) * (high - low) / layers)
    ]
    return np.concatenate([*rings, points[:1]])
