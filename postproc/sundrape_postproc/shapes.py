"""Obstacles as points and faces. Pure numpy; a body's own frame and parameters are those of the case file."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .clearance import edge_radius
from .errors import PostprocError
from .load import Obstacle

ROUND = 96  # facets about a full circle


def surface(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    """Points (P, 3) [m] of a bounded obstacle in its own frame, and faces (E, 3 or 4), counter-clockwise from outside.

    Planes have none: see `plane`.
    """
    try:
        return _SHAPES[obstacle.kind](obstacle)
    except KeyError as trouble:
        raise PostprocError(f"obstacle of kind {obstacle.kind!r}: cannot be drawn: no {trouble}") from trouble


def corner_normals(points: np.ndarray, faces: np.ndarray, crease: float = 40.0) -> np.ndarray:
    """Unit normals (E, k, 3) at each face's corners: the mean of the faces there that turn by less than `crease` [deg].

    Points that lie on each other count as one, so that seams of a surface do not show.
    """
    place = points[faces]
    last = place[:, 3] if faces.shape[1] == 4 else place[:, 0]
    flat = np.cross(place[:, 2] - place[:, 0], last - place[:, 1])  # twice the area of a quad or a triangle
    grain = 1e-9 + 1e-7 * float(np.ptp(points, axis=0).max())
    _, spot = np.unique(np.round(points / grain).astype(np.int64), axis=0, return_inverse=True)
    at = spot.reshape(-1)[faces].ravel()  # the spot of each corner
    face = np.repeat(np.arange(len(faces)), faces.shape[1])
    order = np.argsort(at, kind="stable")
    count = np.bincount(at)
    first = np.concatenate([[0], np.cumsum(count)[:-1]])
    # every corner meets every corner of its spot
    mine = np.repeat(np.arange(at.size), count[at])
    turn = np.arange(mine.size) - np.repeat(np.cumsum(count[at]) - count[at], count[at])
    other = face[order[first[at[mine]] + turn]]
    unit = flat / np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-300)
    alike = np.einsum("ei,ei->e", unit[face[mine]], unit[other]) > np.cos(np.radians(crease))
    sums = np.stack([np.bincount(mine[alike], flat[other[alike], axis], at.size) for axis in range(3)], axis=1)
    length = np.linalg.norm(sums, axis=1, keepdims=True)
    sums = np.where(length > 0, sums / np.maximum(length, 1e-300), [0.0, 0.0, 1.0])
    return sums.reshape(*faces.shape, 3)


def plane(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    """A point (3,) [m] and the unit normal (3,) of a plane, placed."""
    point = np.asarray(obstacle.parameters.get("point", [0, 0, 0]), dtype=float)
    normal = np.asarray(obstacle.parameters.get("normal", [0, 0, 1]), dtype=float)
    return obstacle.position + obstacle.rotation @ point, obstacle.rotation @ (normal / np.linalg.norm(normal))


def frame_of(axis: np.ndarray) -> np.ndarray:
    """A rotation (3, 3) whose third column is the direction of `axis`."""
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    aside = np.eye(3)[np.argmin(np.abs(axis))]
    first = np.cross(aside, axis)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(axis, first), axis], axis=1)


def _box(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    """A box is its inner box, smaller by the edge radius, plus a ball: points of a cube are pulled onto that sum."""
    half = np.asarray(obstacle.parameters["size"], dtype=float) / 2
    radius = edge_radius(obstacle, 2 * half.min())
    bend = np.tan(np.linspace(0, np.pi / 4, 9))  # even angles on the rounding
    ends = half[:, None] - radius * (1 - bend[::-1])  # (3, 9) positive coordinates across the rounding, outermost first
    points, faces = [], []
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        lines = [np.concatenate([-ends[k], ends[k][::-1]]) for k in (first, second)]
        for sign in (-1.0, 1.0):
            grid = np.zeros((len(lines[0]), len(lines[1]), 3))
            grid[..., axis] = sign * half[axis]
            grid[..., first], grid[..., second] = np.meshgrid(*lines, indexing="ij")
            faces.append(_grid_faces(*grid.shape[:2])[:, :: int(sign)] + sum(map(len, points)))
            points.append(grid.reshape(-1, 3))
    cube = np.concatenate(points)
    core = np.clip(cube, -(half - radius), half - radius)
    away = cube - core
    return core + radius * away / np.linalg.norm(away, axis=1)[:, None], np.concatenate(faces)


def _sphere(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    return _revolve(_arc(obstacle.parameters["radius"], 0, 0, -90, 90))


def _capsule(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    radius, half = obstacle.parameters["radius"], obstacle.parameters["length"] / 2
    profile = np.concatenate([_arc(radius, 0, -half, -90, 0), _arc(radius, 0, half, 0, 90)])
    return _turned(_revolve(profile), obstacle)


def _cylinder(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    radius, half = obstacle.parameters["radius"], obstacle.parameters["length"] / 2
    return _turned(_drum(radius, -half, half, edge_radius(obstacle, min(radius, 2 * half))), obstacle)


def _disc(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    radius, height = obstacle.parameters["radius"], obstacle.parameters["height"]
    return _drum(radius, -height, 0.0, edge_radius(obstacle, min(radius, height)))


def _drum(radius: float, bottom: float, top: float, edge: float) -> tuple[np.ndarray, np.ndarray]:
    lower, upper = _arc(edge, radius - edge, bottom + edge, -90, 0), _arc(edge, radius - edge, top - edge, 0, 90)
    return _revolve(np.concatenate([[[0, bottom]], lower, upper, [[0, top]]]))


def _arc(radius: float, r: float, z: float, start: float, end: float) -> np.ndarray:
    """Points (K, 2) as (r, z) [m] of an arc about (r, z), angles in degrees from the horizontal."""
    angle = np.radians(np.linspace(start, end, ROUND // 4 + 1))
    return np.stack([r + radius * np.cos(angle), z + radius * np.sin(angle)], axis=1)


def _revolve(profile: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Turn a profile (K, 2) as (r, z) about the z axis."""
    angle = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
    r, z = profile.T
    points = np.stack([r[:, None] * np.cos(angle), r[:, None] * np.sin(angle), np.tile(z[:, None], ROUND)], axis=-1)
    return points.reshape(-1, 3), _grid_faces(len(profile), ROUND, closed=True)


def _grid_faces(rows: int, columns: int, closed: bool = False) -> np.ndarray:
    index = np.arange(rows * columns).reshape(rows, columns)
    if closed:
        index = np.concatenate([index, index[:, :1]], axis=1)
    return np.stack([index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], axis=-1).reshape(-1, 4)[:, ::-1]


def _turned(shape: tuple[np.ndarray, np.ndarray], obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    points, faces = shape
    return points @ frame_of(obstacle.parameters.get("axis", [0, 0, 1])).T, faces


def _mesh(obstacle: Obstacle) -> tuple[np.ndarray, np.ndarray]:
    if obstacle.surface is None:
        raise KeyError("vertices")
    return obstacle.surface


_SHAPES: dict[str, Callable[[Obstacle], tuple[np.ndarray, np.ndarray]]] = {
    "box": _box,
    "cylinder": _cylinder,
    "sphere": _sphere,
    "capsule": _capsule,
    "disc": _disc,
    "mesh": _mesh,
}
