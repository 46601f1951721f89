"""Keeps the drawn surface outside the obstacles. Pure numpy.

Contact acts on nodes: between two nodes on either side of a table's edge the mesh cuts through the corner, by up to
half a cell. The points that the picture adds between the nodes are therefore moved to the nearest face of the body, and
those that were moved are spread evenly over it. Nodes inside a body, by the depth that contact allows, move with them.
Layers on a body keep their order: the nearer a point, the more it is lifted, but never beyond one that was above it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from .load import Obstacle


HAIR = 0.035  # radius drawn for a sharp edge, over the body's smallest size: it catches the light and lets cloth bend
SPREADS = 60  # sweeps of averaging with the neighbours
RINGS = 4  # of neighbours of a moved point that give way with it


def drape_over(points: np.ndarray, quads: np.ndarray, obstacles: Iterable[Obstacle], lift: float) -> np.ndarray:
    """Points (P, 3) [m] of a fine mesh (E, 4) with all of them at least `lift` [m] outside the obstacles."""
    obstacles = list(obstacles)
    outside = lift_off(points, obstacles, lift)
    moved = np.linalg.norm(outside - points, axis=1) > lift * (1 + 1e-9)
    if not moved.any():
        return outside
    sides = [(k, (k + step) % 4) for k in range(4) for step in (1, 3)]
    ends = np.concatenate([quads[:, side].T for side in sides], axis=1)
    for _ in range(RINGS):
        moved[ends[0, moved[ends[1]]]] = True
    moved = np.flatnonzero(moved)
    ends = ends[:, np.isin(ends[0], moved)]
    slot = np.searchsorted(moved, ends[0])
    neighbours = np.bincount(slot, minlength=moved.size)[:, None]
    for _ in range(SPREADS):
        beside = np.stack([np.bincount(slot, outside[ends[1], axis], moved.size) for axis in range(3)], axis=1)
        outside[moved] = push_out((outside[moved] + beside / neighbours) / 2, obstacles, lift)
    return outside


def lift_off(points: np.ndarray, obstacles: Iterable[Obstacle], lift: float) -> np.ndarray:
    """Points (P, 3) [m], those on a body or inside it moved to `lift` [m] from it, those above it by less with height."""
    fade = 3 * lift  # the lift falls more slowly than the height grows

    def lifted(distance: np.ndarray) -> np.ndarray:
        return np.where(distance < 0, lift, distance + lift * np.exp(-np.maximum(distance, 0) / fade))

    return _displaced(points, obstacles, lifted)


def push_out(points: np.ndarray, obstacles: Iterable[Obstacle], lift: float) -> np.ndarray:
    """Points (P, 3) [m], those inside a body or nearer to it than `lift` [m] moved to that distance from it."""
    return _displaced(points, obstacles, lambda distance: np.maximum(distance, lift))


def _displaced(
    points: np.ndarray, obstacles: Iterable[Obstacle], placed: Callable[[np.ndarray], np.ndarray]
) -> np.ndarray:
    """Points (P, 3) [m] along their normals to where their distance [m] is that of `placed`, body after body."""
    points = np.array(points, dtype=float)
    for obstacle in obstacles:
        shape = _NEAREST.get(obstacle.kind)
        if shape is None:
            continue
        local = (points - obstacle.position) @ obstacle.rotation
        distance, normal = shape(obstacle, local)
        points += ((placed(distance) - distance)[:, None] * normal) @ obstacle.rotation.T
    return points


Nearest = tuple[np.ndarray, np.ndarray]  # signed distance (P,) [m], outward unit normal (P, 3)


def edge_radius(obstacle: Obstacle, size: float) -> float:
    """Of the drawn body [m]: the given one, or a hair of its smallest `size` [m] for a sharp edge."""
    return max(float(obstacle.parameters.get("edge_radius", 0.0)), HAIR * size)


def _plane(obstacle: Obstacle, p: np.ndarray) -> Nearest:
    normal = np.asarray(obstacle.parameters.get("normal", [0, 0, 1]), dtype=float)
    normal = normal / np.linalg.norm(normal)
    distance = (p - np.asarray(obstacle.parameters.get("point", [0, 0, 0]), dtype=float)) @ normal
    return distance, np.broadcast_to(normal, p.shape)


def _sphere(obstacle: Obstacle, p: np.ndarray) -> Nearest:
    return _round(p, float(obstacle.parameters["radius"]))


def _capsule(obstacle: Obstacle, p: np.ndarray) -> Nearest:
    axis, half = _axis(obstacle), obstacle.parameters["length"] / 2
    return _round(p - np.clip(p @ axis, -half, half)[:, None] * axis, float(obstacle.parameters["radius"]))


def _box(obstacle: Obstacle, p: np.ndarray) -> Nearest:
    half = np.asarray(obstacle.parameters["size"], dtype=float) / 2
    radius = edge_radius(obstacle, 2 * half.min())
    return _rounded(np.abs(p), half, radius, lambda n: n * np.where(p < 0, -1.0, 1.0))


def _cylinder(obstacle: Obstacle, p: np.ndarray) -> Nearest:
    return _drum(p, _axis(obstacle), obstacle.parameters["radius"], obstacle.parameters["length"], obstacle)


def _disc(obstacle: Obstacle, p: np.ndarray) -> Nearest:
    height = obstacle.parameters["height"]
    return _drum(p + [0, 0, height / 2], np.array([0.0, 0.0, 1.0]), obstacle.parameters["radius"], height, obstacle)


def _drum(p: np.ndarray, axis: np.ndarray, radius: float, length: float, obstacle: Obstacle) -> Nearest:
    """A solid of revolution is a rectangle in (distance from the axis, height)."""
    height = p @ axis
    outward = p - height[:, None] * axis
    reach = np.linalg.norm(outward, axis=1)
    outward = outward / np.maximum(reach, 1e-12)[:, None]
    upward = np.where(height < 0, -1.0, 1.0)[:, None] * axis
    flat = np.stack([reach, np.abs(height)], axis=1)
    edge = edge_radius(obstacle, min(radius, length))
    return _rounded(flat, np.array([radius, length / 2]), edge, lambda n: n[:, :1] * outward + n[:, 1:] * upward)


def _rounded(q: np.ndarray, half: np.ndarray, radius: float, back: Callable[[np.ndarray], np.ndarray]) -> Nearest:
    """Distance of q >= 0 (P, d) from a block of half sizes `half` (d,) with round edges; `back` undoes the folding."""
    beyond = q - (half - radius)
    outer = np.maximum(beyond, 0)
    length = np.linalg.norm(outer, axis=1)
    within = np.eye(q.shape[1])[np.argmax(beyond, axis=1)]  # the face nearest to a point in the core
    normal = np.where(length[:, None] > 0, outer / np.maximum(length, 1e-12)[:, None], within)
    distance = np.where(length > 0, length, beyond.max(axis=1)) - radius
    return distance, back(normal)


def _round(away: np.ndarray, radius: float) -> Nearest:
    length = np.linalg.norm(away, axis=1)
    return length - radius, away / np.maximum(length, 1e-12)[:, None]


def _axis(obstacle: Obstacle) -> np.ndarray:
    axis = np.asarray(obstacle.parameters.get("axis", [0, 0, 1]), dtype=float)
    return axis / np.linalg.norm(axis)


_NEAREST: dict[str, Callable[[Obstacle, np.ndarray], Nearest]] = {
    "plane": _plane,
    "box": _box,
    "cylinder": _cylinder,
    "sphere": _sphere,
    "capsule": _capsule,
    "disc": _disc,
}
