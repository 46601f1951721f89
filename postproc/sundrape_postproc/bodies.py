"""Obstacles as VTK's triangle meshes in space."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from . import shapes
from .load import Obstacle


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
    """The surface of a bounded obstacle, placed [m]. Planes have none: see `shapes.plane`."""
    points, faces = shapes.surface(obstacle)
    return with_normals(polydata(obstacle.position + points @ obstacle.rotation.T, faces), 40)
