"""A smooth surface through the nodes of a quad mesh: subdivision after Catmull & Clark (1978) that interpolates.

The control points are shifted until the subdivided surface passes (nearly) through the nodes, so that the picture
shows the cloth where the solver has it and not shrunk as plain subdivision would.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

FACE_LIMIT = 60_000  # faces to draw; more than that shows no more
SHIFTS = 8  # of the control points; each cuts the distance to the nodes to about a half
RELAXATION = 1.4  # below 2 / (largest eigenvalue of the limit mask, 1)


@dataclass(frozen=True)
class _Level:
    """Topology of one subdivision: N points and E quads become N + M + E points and 4 E quads (M edges)."""

    quads: np.ndarray  # (E, 4)
    edges: np.ndarray  # (M, 2)
    inner: np.ndarray  # (M,) whether exactly two faces share the edge
    edge_of_side: np.ndarray  # (E, 4) edge from corner k to corner k + 1
    valence: np.ndarray  # (N,) faces at a node
    rim: np.ndarray  # (N,) whether on the boundary

    def refine(self, p: np.ndarray) -> np.ndarray:
        """Points (N, d) -> (N + M + E, d): old nodes moved, then edge points, then face points."""
        face = p[self.quads].mean(axis=1)
        middle = p[self.edges].mean(axis=1)
        beside = _sums(self.edge_of_side, np.repeat(face, 4, axis=0), len(self.edges))
        edge = np.where(self.inner[:, None], middle / 2 + beside / 4, middle)

        around = _sums(self.quads, np.repeat(face, 4, axis=0), len(p))  # of the face points about a node
        spokes = _sums(self.edges, np.repeat(middle, 2, axis=0), len(p))
        hem = _sums(self.edges[~self.inner], np.repeat(middle[~self.inner], 2, axis=0), len(p))
        n = np.maximum(self.valence, 1)[:, None]
        inside = (around / n + 2 * spokes / n + (n - 3) * p) / n
        node = np.where(self.rim[:, None], (2 * p + hem) / 4, inside)
        node = np.where(self.valence[:, None] <= 1, p, node)  # a corner of the cloth stays where it is
        return np.concatenate([node, edge, face])

    def refine_linearly(self, p: np.ndarray) -> np.ndarray:
        """The same points by bilinear interpolation: for what only has to lie between its neighbours."""
        return np.concatenate([p, p[self.edges].mean(axis=1), p[self.quads].mean(axis=1)])

    def refined_quads(self) -> np.ndarray:
        first_edge = len(self.valence)
        centre = first_edge + len(self.edges) + np.arange(len(self.quads))
        side = first_edge + self.edge_of_side
        parts = [np.stack([self.quads[:, k], side[:, k], centre, side[:, k - 1]], axis=1) for k in range(4)]
        return np.concatenate(parts)


class SmoothSurface:
    """The refined mesh of a cloth, ready to be evaluated for any frame."""

    def __init__(self, quads: np.ndarray, nodes: int) -> None:
        """`quads`: (E, 4); `nodes`: N."""
        self._levels: list[_Level] = []
        levels = int(np.clip(np.log(FACE_LIMIT / len(quads)) / np.log(4), 1, 3))
        for _ in range(levels):
            level = _level(quads, nodes)
            self._levels.append(level)
            nodes += len(level.edges) + len(quads)
            quads = level.refined_quads()
        self.quads = quads  # (E 4^levels, 4)
        self.hem = _hem(quads)  # (B, 2) boundary edges of the refined mesh

    def points(self, position: np.ndarray) -> np.ndarray:
        """Nodes of one frame (N, 3) [m] -> points of the refined mesh [m]."""
        control = np.array(position, dtype=float)
        for _ in range(SHIFTS):
            control += RELAXATION * (position - self._subdivide(control, 2)[: len(position)])
        return self._subdivide(control, len(self._levels))

    def interpolated(self, of_nodes: np.ndarray) -> np.ndarray:
        """Values of the nodes (N, d), e.g. warp and weft coordinates -> those of the refined mesh's points."""
        for level in self._levels:
            of_nodes = level.refine_linearly(of_nodes)
        return of_nodes

    def _subdivide(self, p: np.ndarray, levels: int) -> np.ndarray:
        for level in self._levels[:levels]:
            p = level.refine(p)
        return p


def _sums(index: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    """Rows of `values` (K, d) summed into `count` places, given by `index` of K entries."""
    return np.stack([np.bincount(index.ravel(), column, count) for column in values.T], axis=1)


def _sides(quads: np.ndarray) -> np.ndarray:
    """(4 E, 2) sides of all quads, nodes sorted, face by face."""
    return np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)


def _level(quads: np.ndarray, nodes: int) -> _Level:
    edges, edge_of_side, faces = np.unique(_sides(quads), axis=0, return_inverse=True, return_counts=True)
    inner = faces == 2
    rim = np.zeros(nodes, dtype=bool)
    rim[edges[~inner].ravel()] = True
    valence = np.bincount(quads.ravel(), minlength=nodes)
    return _Level(quads, edges, inner, edge_of_side.reshape(-1, 4), valence, rim)


def _hem(quads: np.ndarray) -> np.ndarray:
    edges, faces = np.unique(_sides(quads), axis=0, return_counts=True)
    return edges[faces == 1]
