"""Fields on the cloth's nodes: what pictures, films and the viewer colour by. Pure numpy; F frames, N nodes, E quads.

Strain and curvature are the quads', shared by their nodes: strain from the sides and diagonals of a net's cell, which are
its springs, and at the centre of a shell's element; curvature from the turn of the normal. The strains and stress
resultants that the solver stores of a shell are in Result.frames ("element/membrane_strain", ...).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .errors import BAD_USE, PostprocError
from .load import Result


@dataclass(frozen=True)
class Field:
    """A quantity with one number a node."""

    name: str  # what commands call it
    label: str  # what legends call it
    unit: str  # SI; "1" of a ratio, which legends show in per cent
    evaluate: Callable[[Result, int], np.ndarray]  # (result, frame) -> (N,)
    needs: str = ""  # member of Result that it is made of, besides positions


def field(name: str) -> Field:
    """The field of that name.

    Raises PostprocError, status 2: no such field.
    """
    if name not in FIELDS:
        raise PostprocError(f"no field {name!r}; there are {', '.join(FIELDS)}", BAD_USE)
    return FIELDS[name]


def available(result: Result) -> list[Field]:
    """The fields that a result has what they need for."""
    return [f for f in FIELDS.values() if not f.needs or getattr(result, f.needs) is not None]


def values(result: Result, name: str, frame: int) -> np.ndarray:
    """One frame of a field (N,), in the field's SI unit.

    Raises PostprocError, status 2: no such field, or a result without what it needs.
    """
    chosen = field(name)
    if chosen.needs and getattr(result, chosen.needs) is None:
        raise PostprocError(f"{result.path}: has no {chosen.needs.replace('_', ' ')}, which {name!r} needs", BAD_USE)
    return chosen.evaluate(result, frame)


def node_areas(result: Result) -> np.ndarray:
    """Tributary area of each node at rest (N,) [m²]: a quarter of each quad's at it, as the solver shares them."""
    return _geometry(result.reference.tobytes(), result.reference.shape[0], result.quads.tobytes()).node_areas


def node_normals(position: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """Unit normals (N, 3) of a shape (N, 3) [m]: the mean of the adjacent quads', weighted by their areas."""
    a, b = position[quads[:, 2]] - position[quads[:, 0]], position[quads[:, 3]] - position[quads[:, 1]]
    normals = _gathered(np.cross(a, b), quads, len(position))
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.divide(normals, length, out=np.zeros_like(normals), where=length > 0)


def principal_strain(result: Result, frame: int) -> np.ndarray:
    """Largest principal stretch less 1 (N,)."""
    stretch = _metric(result.reference, result.position[frame], result.quads, result.model == "shell")
    c11, c12, c22 = stretch.T
    largest = (c11 + c22) / 2 + np.hypot((c11 - c22) / 2, c12)
    return _to_nodes(result, np.sqrt(np.maximum(largest, 0)) - 1)


def principal_curvature(result: Result, frame: int) -> np.ndarray:
    """The larger of the two principal curvatures' sizes (N,) [1/m], from the turn of the normal along the sheet."""
    geometry = _geometry_of(result)
    x, quads = result.position[frame], result.quads
    normals = node_normals(x, quads)
    first, second = _midlines(x, quads)
    turn_first, turn_second = _midlines(normals, quads)
    # shape operator in a frame of the current tangent plane: (change of the normal) = −S (change of place)
    e1 = _unit(first)
    e2 = _unit(second - _dot(second, e1)[:, None] * e1)
    place = np.stack([_in_plane(v, e1, e2) for v in (first, second)], axis=2)  # (E, 2, 2), columns are midlines
    turn = np.stack([_in_plane(v, e1, e2) for v in (turn_first, turn_second)], axis=2)
    shape = -turn @ np.linalg.inv(_regular(place))
    mean = np.trace(shape, axis1=1, axis2=2) / 2
    deviator = np.hypot((shape[:, 0, 0] - shape[:, 1, 1]) / 2, (shape[:, 0, 1] + shape[:, 1, 0]) / 2)
    return _gathered((np.abs(mean) + deviator) * geometry.quad_areas, quads, len(x)) / geometry.gathered_areas


def contact_pressure(result: Result, frame: int) -> np.ndarray:
    """Size of the contact force over the node's area (N,) [Pa], friction included."""
    assert result.contact_force is not None
    return np.linalg.norm(result.contact_force[frame], axis=1) / node_areas(result)


def energy_density(result: Result, frame: int) -> np.ndarray:
    """Stored elastic energy over the node's area (N,) [J/m²], as the solver has it."""
    assert result.energy_density is not None
    return result.energy_density[frame]


def speed(result: Result, frame: int) -> np.ndarray:
    """(N,) [m/s]."""
    assert result.velocity is not None
    return np.linalg.norm(result.velocity[frame], axis=1)


FIELDS = {
    f.name: f
    for f in (
        Field("strain", "largest principal strain", "1", principal_strain),
        Field("curvature", "curvature", "1/m", principal_curvature),
        Field("contact", "contact force over area", "Pa", contact_pressure, "contact_force"),
        Field("energy", "elastic energy over area", "J/m²", energy_density, "energy_density"),
        Field("speed", "speed", "m/s", speed, "velocity"),
    )
}


@dataclass(frozen=True)
class _Geometry:
    """Of the rest shape."""

    quad_areas: np.ndarray  # (E,) [m²]
    gathered_areas: np.ndarray  # (N,) sum over the quads at a node [m²]

    @property
    def node_areas(self) -> np.ndarray:
        return self.gathered_areas / 4


@lru_cache(maxsize=4)
def _geometry(reference: bytes, nodes: int, quads: bytes) -> _Geometry:
    x = np.frombuffer(reference).reshape(nodes, 3)
    q = np.frombuffer(quads, dtype=np.int64).reshape(-1, 4)
    areas = np.linalg.norm(np.cross(x[q[:, 2]] - x[q[:, 0]], x[q[:, 3]] - x[q[:, 1]]), axis=1) / 2
    return _Geometry(areas, _gathered(areas, q, nodes))


def _geometry_of(result: Result) -> _Geometry:
    return _geometry(result.reference.tobytes(), len(result.reference), result.quads.tobytes())


def _gathered(of_quads: np.ndarray, quads: np.ndarray, nodes: int) -> np.ndarray:
    """Σ over the quads at a node: (E, ...) -> (N, ...)."""
    columns = of_quads.reshape(len(quads), -1)
    flat = quads.ravel()
    sums = [np.bincount(flat, np.repeat(columns[:, k], 4), nodes) for k in range(columns.shape[1])]
    return np.stack(sums, axis=1).reshape(nodes, *of_quads.shape[1:])


def _to_nodes(result: Result, of_quads: np.ndarray) -> np.ndarray:
    """Mean over the quads at a node, weighted by their areas at rest."""
    geometry = _geometry_of(result)
    return _gathered(of_quads * geometry.quad_areas, result.quads, len(result.reference)) / geometry.gathered_areas


def _midlines(x: np.ndarray, quads: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two midlines (E, 3) of each quad, from side 3–0 to 1–2 and from 0–1 to 2–3."""
    p = x[quads]
    return (p[:, 1] + p[:, 2] - p[:, 0] - p[:, 3]) / 2, (p[:, 2] + p[:, 3] - p[:, 0] - p[:, 1]) / 2


def _dots(x: np.ndarray, quads: np.ndarray, centre: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """a·a, a·b and b·b (E,) [m²] of the directions a from side 3–0 to 1–2 and b from 0–1 to 2–3 of each quad.

    At the centre of a shell's element; of a net's cell, whose springs are its sides and its diagonals, their means.
    """
    if centre:
        a, b = _midlines(x, quads)
        return _dot(a, a), _dot(a, b), _dot(b, b)
    squares = [_dot(d, d) for d in (x[quads[:, j]] - x[quads[:, i]] for i, j in ((0, 1), (3, 2), (0, 3), (1, 2), (0, 2), (1, 3)))]
    return (squares[0] + squares[1]) / 2, (squares[4] - squares[5]) / 4, (squares[2] + squares[3]) / 2


def _metric(rest: np.ndarray, x: np.ndarray, quads: np.ndarray, centre: bool) -> np.ndarray:
    """Squares of stretches c11, c12, c22 (E, 3) in a frame at right angles whose first axis is a at rest."""
    aa, ab, bb = _dots(rest, quads, centre)
    now_aa, now_ab, now_bb = _dots(x, quads, centre)
    lean, height = ab / aa, np.sqrt(bb - ab * ab / aa)  # b = lean a + height e2
    c12 = (now_ab - lean * now_aa) / (np.sqrt(aa) * height)
    c22 = (now_bb - 2 * lean * now_ab + lean * lean * now_aa) / height**2
    return np.stack([now_aa / aa, c12, c22], axis=1)


def _dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.einsum("ei,ei->e", a, b)


def _unit(v: np.ndarray) -> np.ndarray:
    return v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-300)


def _in_plane(v: np.ndarray, e1: np.ndarray, e2: np.ndarray) -> np.ndarray:
    return np.stack([_dot(v, e1), _dot(v, e2)], axis=1)


def _regular(m: np.ndarray) -> np.ndarray:
    """(E, 2, 2) with those that cannot be inverted, of quads that have collapsed, replaced by the unit matrix."""
    flat = np.abs(np.linalg.det(m)) <= 1e-12 * np.einsum("eij,eij->e", m, m)
    return np.where(flat[:, None, None], np.eye(2), m)
