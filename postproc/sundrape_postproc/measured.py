"""Measured points from CSV files, and how far they are from a simulated shape. Pure numpy."""

from __future__ import annotations

import csv
import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .errors import BAD_USE, PostprocError

METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
HEADING = re.compile(r"([xyz])\s*(?:\[\s*([^\]]*?)\s*\])?", re.IGNORECASE)
AT_ONCE = 2_000_000  # pairs of a point and a triangle


@dataclass(frozen=True)
class Points:
    """Points in space, or in the plane x–z where the file has no y."""

    name: str
    place: np.ndarray  # (P, 3) [m]; y is 0 in a plane
    in_plane: bool


def read_points(path: Path) -> Points:
    """A CSV file whose first line names columns and their units: x [cm],y [cm],z [cm] or x [cm],z [cm]. Other columns
    are passed over, and so are empty lines and those that begin with #.

    Raises PostprocError: status 3 for a file that cannot be read, 2 with the line for one that is not like this.
    """
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as trouble:
        raise PostprocError(f"{path}: cannot be read: {getattr(trouble, 'strerror', None) or trouble}") from trouble
    rows = [
        (k, next(csv.reader([line])))
        for k, line in enumerate(lines, 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if not rows:
        raise _bad(path, 1, "is empty: its first line names the columns, e.g. x [cm],z [cm]")
    columns = _columns(path, *rows[0])
    place = np.zeros((len(rows) - 1, 3))
    for k, (line, cells) in enumerate(rows[1:]):
        for axis, (column, factor) in columns.items():
            place[k, "xyz".index(axis)] = factor * _number(path, line, cells, column, axis)
    if not len(place):
        raise _bad(path, rows[0][0], "no points below the names of the columns")
    return Points(path.stem, place, "y" not in columns)


def _columns(path: Path, line: int, headings: list[str]) -> dict[str, tuple[int, float]]:
    """axis -> (column, metres in its unit)."""
    columns: dict[str, tuple[int, float]] = {}
    for column, heading in enumerate(headings):
        match = HEADING.fullmatch(heading.strip())
        if match is None:
            continue
        axis, unit = match[1].lower(), match[2]
        if not unit:
            raise _bad(path, line, f"column {axis} has no unit: write {axis} [cm]")
        if unit not in METRES:
            raise _bad(path, line, f"column {axis}: unit {unit!r} is none of {', '.join(METRES)}")
        if axis in columns:
            raise _bad(path, line, f"two columns {axis}")
        columns[axis] = (column, METRES[unit])
    for axis in "xz":
        if axis not in columns:
            raise _bad(path, line, f"no column {axis}: the first line names columns and units, e.g. x [cm],z [cm]")
    return columns


def _number(path: Path, line: int, cells: list[str], column: int, axis: str) -> float:
    text = cells[column].strip() if column < len(cells) else ""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise _bad(path, line, f"column {axis}: {text!r} is not a number")
    return number


def _bad(path: Path, line: int, what: str) -> PostprocError:
    return PostprocError(f"{path}:{line}: {what}", BAD_USE)


def to_surface(points: np.ndarray, position: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """Distances (P,) [m] of points (P, 3) from the nearest place on a mesh (N, 3), (E, 4): four triangles a quad, which
    meet in the mean of its corners."""
    middle = position[quads].mean(axis=1)
    sides = [np.stack([position[quads[:, k]], position[quads[:, (k + 1) % 4]], middle], axis=1) for k in range(4)]
    triangles = np.concatenate(sides)
    batch = max(1, AT_ONCE // len(triangles))
    parts = [points[k : k + batch] for k in range(0, len(points), batch)]
    return np.concatenate([_to_triangles(part, triangles) for part in parts])


def _to_triangles(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Distances (P,) from the nearest of the triangles (T, 3, 3): within its face, or from its sides."""
    a, b, c = (triangles[:, k] for k in range(3))
    u, v = b - a, c - a
    uu, uv, vv = (np.einsum("ti,ti->t", *pair) for pair in ((u, u), (u, v), (v, v)))
    area = uu * vv - uv * uv
    away = points[:, None] - a[None]
    du, dv = np.einsum("pti,ti->pt", away, u), np.einsum("pti,ti->pt", away, v)
    safe = np.where(area > 0, area, 1)
    s, t = (vv * du - uv * dv) / safe, (uu * dv - uv * du) / safe
    inside = (s >= 0) & (t >= 0) & (s + t <= 1) & (area > 0)
    normal = np.cross(u, v)
    height = np.abs(np.einsum("pti,ti->pt", away, normal)) / np.sqrt(safe)
    nearest = np.where(inside, height, np.inf)
    for start, end in ((a, b), (b, c), (c, a)):
        nearest = np.minimum(nearest, _to_segments(points, start, end))
    return nearest.min(axis=1)


def _to_segments(points: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Distances (P, S) of points (P, d) from segments (S, d)."""
    along = end - start
    away = points[:, None] - start[None]
    length = np.maximum(np.einsum("si,si->s", along, along), 1e-300)
    share = np.clip(np.einsum("psi,si->ps", away, along) / length, 0, 1)
    return np.linalg.norm(away - share[..., None] * along[None], axis=2)


def to_line(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    """Distances (P,) [m] of points (P, d) from a chain of segments through `line` (K, d)."""
    return _to_segments(points, line[:-1], line[1:]).min(axis=1)
