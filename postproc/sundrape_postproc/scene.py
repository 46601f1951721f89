"""The cloth and its obstacles as a shaded picture, drawn off screen by VTK."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkProperty,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the renderer with VTK's factories
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

from . import bodies, ground
from .camera import NO_ROOM, Room, three_quarter
from .clearance import drape_over
from .load import Obstacle, Result
from .surface import SmoothSurface
from .weave import thread_spacing, weave_texture

SUPERSAMPLING = 2
LIFT = 0.005  # of the drawn cloth off its obstacles, over the radius of what is shown
OCCLUSION = 0.5  # share of the picture with ambient occlusion; all of it looks sooty
FACE_COLOUR = (0.985, 0.955, 0.895)  # unbleached linen
BACK_COLOUR = (0.86, 0.76, 0.62)  # its back, darker, so that folds read in grey
HEM_COLOUR = (0.45, 0.38, 0.29)
BODY_COLOUR = (0.56, 0.61, 0.66)  # slate
BACKGROUND_TOP, BACKGROUND_BOTTOM = (0.90, 0.92, 0.94), (0.985, 0.985, 0.98)


class Scene:
    """All frames of a result seen from one camera that fits those asked for."""

    def __init__(self, result: Result, frames: Sequence[int], size: tuple[int, int], free: Room = NO_ROOM) -> None:
        """`size`: pixels across and down; `free`: what the fit leaves for text."""
        self._result = result
        self._size = size
        self._surface = SmoothSurface(result.quads, result.position.shape[1])
        self._cloth_points = np.concatenate([result.position[k] for k in frames])
        shown = [_points(body) for k in frames for body in self._bodies(k)]
        self._view = three_quarter(self._cloth_points, shown, size[0] / size[1], free)

    def _obstacles(self, frame: int) -> list[Obstacle]:
        return [obstacle.at(frame) for obstacle in self._result.obstacles.values()]

    def _bodies(self, frame: int) -> list[vtkPolyData]:
        return [bodies.body(o) for o in self._obstacles(frame) if o.kind != "plane"]

    def draw(self, frame: int) -> np.ndarray:
        """One frame as an image (height, width, 3) of bytes, top row first."""
        points = self._surface.points(self._result.position[frame])
        points = drape_over(points, self._surface.quads, self._obstacles(frame), LIFT * self._view.radius)
        renderer = vtkRenderer()
        renderer.GradientBackgroundOn()
        renderer.SetBackground(*BACKGROUND_BOTTOM)
        renderer.SetBackground2(*BACKGROUND_TOP)
        for actor in self._cloth(points):
            renderer.AddActor(actor)
        drawn = self._bodies(frame)
        planes = [bodies.plane(o) for o in self._obstacles(frame) if o.kind == "plane"]
        for data in drawn:
            renderer.AddActor(_actor(data, BODY_COLOUR, specular=0.12))
        shadow_casters = [points] + [_points(data) for data in drawn]
        for actor in ground.actors(self._cloth_points, shadow_casters, planes, self._view):
            renderer.AddActor(actor)
        _light(renderer)
        self._view.apply(renderer)
        return _render(renderer, self._size, self._view.radius)

    def _cloth(self, points: np.ndarray) -> list[vtkActor]:
        data = bodies.polydata(points, self._surface.quads)
        face = _actor(data, FACE_COLOUR, specular=0.04)
        if self._result.material is not None:
            material = self._surface.coordinates(self._result.material)
            spacing = thread_spacing(self._result.material)
            data.GetPointData().SetTCoords(numpy_to_vtk(np.ascontiguousarray(material / spacing), deep=True))
            face.SetTexture(weave_texture())
        data = bodies.with_normals(data)
        face.GetMapper().SetInputData(data)
        back = vtkProperty()
        back.DeepCopy(face.GetProperty())
        back.SetColor(*BACK_COLOUR)
        face.SetBackfaceProperty(back)
        return [face, self._hem(points)]

    def _hem(self, points: np.ndarray) -> vtkActor:
        """The cloth's edge as a thin cord: without it folds that lie on each other run together."""
        lines = bodies.polydata(points, self._surface.hem)
        cord = vtkPolyData()
        cord.SetPoints(lines.GetPoints())
        cord.SetLines(lines.GetPolys())
        tube = vtkTubeFilter()
        tube.SetInputData(cord)
        tube.SetRadius(0.0016 * self._view.radius)
        tube.SetNumberOfSides(6)
        tube.Update()
        return _actor(tube.GetOutput(), HEM_COLOUR)


def _points(data: vtkPolyData) -> np.ndarray:
    return vtk_to_numpy(data.GetPoints().GetData())


def _actor(data: vtkPolyData, colour: tuple[float, float, float], specular: float = 0.0) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetColor(*colour)
    surface.SetInterpolationToPhong()
    surface.SetAmbient(0.32)
    surface.SetDiffuse(0.73)
    surface.SetSpecular(specular)
    surface.SetSpecularPower(30)
    return actor


def _light(renderer: vtkRenderer) -> None:
    """A key light from the upper left, a warm fill from the right, a weak one from behind: all move with the camera."""
    renderer.AutomaticLightCreationOff()
    renderer.RemoveAllLights()
    for position, intensity, colour in (
        ((-0.7, 1.2, 1.1), 0.80, (1.0, 0.99, 0.97)),
        ((1.2, 0.1, 1.0), 0.42, (1.0, 0.96, 0.92)),
        ((0.2, 0.9, -1.0), 0.22, (1.0, 1.0, 1.0)),
    ):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(intensity)
        light.SetColor(*colour)
        renderer.AddLight(light)


def _render(renderer: vtkRenderer, size: tuple[int, int], radius: float) -> np.ndarray:
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*(SUPERSAMPLING * n for n in size))
    window.AddRenderer(renderer)
    plain = _grab(window)
    occlusion = vtkSSAOPass()
    occlusion.SetRadius(0.12 * radius)
    occlusion.SetBias(0.004 * radius)
    occlusion.SetKernelSize(48)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtkRenderStepsPass())
    renderer.SetPass(occlusion)
    image = OCCLUSION * _grab(window) + (1 - OCCLUSION) * plain
    window.Finalize()
    height, width, n = size[1], size[0], SUPERSAMPLING
    return image.reshape(height, n, width, n, 3).mean(axis=(1, 3)).round().astype(np.uint8)


def _grab(window: vtkRenderWindow) -> np.ndarray:
    """What the window shows, (height, width, 3), top row first."""
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    width, height = grab.GetOutput().GetDimensions()[:2]
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[::-1, :, :3].astype(np.float32)
