"""Obstacles as triangle meshes in space. A body's own frame and parameters are those of the case file."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from .clearance import edge_radius
from .errors import PostprocError
from .load import Obstacle

ROUND = 96  # facets about a full circle


def polydata(points: np.ndarray, faces: np.ndarray) -> vtkPolyData:
    """(N, 3) points [m] and (E, k) faces as VTK wants them."""
    cells = np.concatenate([np.full((len(faces), 1), faces.shape[1]), faces], axis=1).astype(np.int64)
    array = vtkCellArray()
    array.ImportLegacyFormat(numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    data = vtkPolyData()
    data.SetPoints(vertices)
    data.SetPolys(array)
    return data


def points_of(data: vtkPolyData) -> np.ndarray:
    """(N, 3) [m]; the data's own memory."""
    return vtk_to_numpy(data.GetPoints().GetData())


def with_normals(data: vtkPolyData, feature_angle: float | None = None) -> vtkPolyData:
    """Smooth normals, split at edges sharper than `feature_angle` [deg] if one is given."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SetSplitting(feature_angle is not None)
    normals.SetFeatureAngle(feature_angle or 180)
    normals.Update()
    return normals.GetOutput()


def body(obstacle: Obstacle) -> vtkPolyData:
    """The surface of a bounded obstacle, placed [m]. Planes have none: see `plane`."""
    try:
        points, faces = _SHAPES[obstacle.kind](obstacle)
    except KeyError as trouble:
        raise PostprocError(f"obstacle of kind {obstacle.kind!r}: cannot be drawn: no {trouble}") from trouble
    return with_normals(polydata(obstacle.position + points @ obstacle.rotation.T, faces), 40)


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
