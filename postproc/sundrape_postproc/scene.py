"""The cloth and its obstacles as a shaded picture, drawn off screen by VTK."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty, vtkRenderer

from . import bodies, fields, shapes
from .camera import NO_ROOM, Room, View, three_quarter
from .clearance import drape_over
from .colours import Scale
from .ground import Ground
from .load import Obstacle, Result
from .moments import Moment, at_frame
from .stage import STILL, Quality, Stage
from .surface import SmoothSurface
from .threads import thread_spacing
from .weave import line_texture, weave_texture

LIFT = 0.005  # of the drawn cloth off its obstacles, over the radius of what is shown
HEM = 0.0016  # radius of the cord along the cloth's edge, over the same
FACE_COLOUR = (0.985, 0.955, 0.895)  # unbleached linen
BACK_COLOUR = (0.86, 0.76, 0.62)  # its back, darker, so that folds read in grey
HEM_COLOUR = (0.45, 0.38, 0.29)
BODY_COLOUR = (0.56, 0.61, 0.66)  # slate


class Scene:
    """All frames of a result seen from one camera that fits those asked for.

    Window, textures and actors are made at the first picture and kept: the next ones only move points.
    """

    def __init__(
        self,
        result: Result,
        frames: Sequence[int],
        size: tuple[int, int],
        free: Room = NO_ROOM,
        scale: Scale | None = None,
        quality: Quality = STILL,
        all_round: bool = False,
    ) -> None:
        """`size`: pixels across and down; `free`: what the fit leaves for text; `scale`: of the field that the cloth is
        coloured by, its weave without one; `all_round`: the fit is for a camera that goes round the scene."""
        self._result, self._size, self._scale, self._quality = result, size, scale, quality
        self._surface = SmoothSurface(result.quads, result.position.shape[1])
        cloth = np.concatenate([result.position[k] for k in frames])
        shown = [
            bodies.points_of(bodies.body(o)) for k in frames for o in at_frame(k).obstacles(result) if o.kind != "plane"
        ]
        self.view = three_quarter(cloth, shown, size[0] / size[1], free, all_round)
        heights = np.concatenate([[points[:, 2].min(), points[:, 2].max()] for points in [cloth, *shown]])
        self._span = (float(heights.min()), float(heights.max()))
        self._stage: Stage | None = None
        self._values = lru_cache(maxsize=2)(self._evaluate)

    def _evaluate(self, frame: int) -> np.ndarray:
        """The field on the nodes (N,)."""
        assert self._scale is not None
        return fields.values(self._result, self._scale.field.name, frame)

    def draw(self, frame: int) -> np.ndarray:
        """One frame as an image (height, width, 3) of bytes, top row first."""
        return self.draw_moment(at_frame(frame))

    def draw_moment(self, moment: Moment, view: View | None = None) -> np.ndarray:
        """The same of any moment, and from another place."""
        stage = self._stage or self._set_up()
        self._move(moment, stage.renderer)
        return stage.image(view or self.view)

    def close(self) -> None:
        """Give the window back; the next picture opens a new one."""
        if self._stage is not None:
            self._stage.close()
            self._stage = None

    def _set_up(self) -> Stage:
        self._stage = Stage(self._size, self._quality, self.view.radius)
        self._cloth = _Cloth(self._surface, self._result.material, self.view.radius, self._scale, self._quality)
        self._ground: Ground | None = None
        self._bodies: dict[int, vtkActor] = {}
        for actor in self._cloth.actors:
            self._stage.renderer.AddActor(actor)
        return self._stage

    def _move(self, moment: Moment, renderer: vtkRenderer) -> None:
        obstacles = moment.obstacles(self._result)
        points = self._surface.points(moment.position(self._result))
        points = drape_over(points, self._surface.quads, obstacles, LIFT * self.view.radius)
        self._cloth.move(points)
        if self._scale is not None:
            of_nodes = moment.mixed(self._values(moment.before), self._values(moment.after))
            self._cloth.colour(self._scale.rgb(self._surface.interpolated(of_nodes[:, None])[:, 0]))
        moving = [points]
        for k, (obstacle, kept) in enumerate(zip(obstacles, self._result.obstacles.values())):
            if obstacle.kind != "plane":
                body = self._place(renderer, k, obstacle, moves=kept.path is not None)
                if kept.path is not None:
                    moving.append(bodies.points_of(body))
        self._stand(renderer, obstacles).cast(moving)

    def _place(self, renderer: vtkRenderer, k: int, obstacle: Obstacle, moves: bool) -> vtkPolyData:
        if k not in self._bodies:
            self._bodies[k] = shaded(bodies.body(obstacle), BODY_COLOUR, specular=0.12)
            renderer.AddActor(self._bodies[k])
        elif moves:
            self._bodies[k].GetMapper().SetInputData(bodies.body(obstacle))
        return self._bodies[k].GetMapper().GetInput()

    def _stand(self, renderer: vtkRenderer, obstacles: Sequence[Obstacle]) -> Ground:
        """The ground: once, or anew when one of its planes moves."""
        moves = any(o.kind == "plane" and o.path is not None for o in self._result.obstacles.values())
        if self._ground is not None and not moves:
            return self._ground
        for actor in self._ground.actors if self._ground else []:
            renderer.RemoveActor(actor)
        planes = [shapes.plane(o) for o in obstacles if o.kind == "plane"]
        self._ground = Ground(planes, self._span, self.view, self._quality.shadow_pixels)
        still = [k for k, o in enumerate(self._result.obstacles.values()) if o.kind != "plane" and o.path is None]
        self._ground.stand([bodies.points_of(self._bodies[k].GetMapper().GetInput()) for k in still])
        for actor in self._ground.actors:
            renderer.AddActor(actor)
        return self._ground


class _Cloth:
    """Its surface and hem."""

    def __init__(
        self, surface: SmoothSurface, material: np.ndarray | None, radius: float, scale: Scale | None, quality: Quality
    ) -> None:
        self._quads = surface.quads
        rest = np.zeros((int(surface.quads.max()) + 1, 3))
        self._data = bodies.polydata(rest, surface.quads)
        face = shaded(self._data, FACE_COLOUR, specular=0.04)
        if material is not None:
            lines = surface.interpolated(material) / thread_spacing(material)
            self._data.GetPointData().SetTCoords(numpy_to_vtk(np.ascontiguousarray(lines), deep=True))
            texture = weave_texture if scale is None else line_texture
            face.SetTexture(texture(quality.texture_filtering))
        if scale is not None:
            face.GetMapper().ScalarVisibilityOn()
            face.GetProperty().SetAmbient(0.46)  # flatter than linen: a colour has to be found again in the legend
            face.GetProperty().SetDiffuse(0.62)
        back = vtkProperty()
        back.DeepCopy(face.GetProperty())
        back.SetColor(*BACK_COLOUR)
        face.SetBackfaceProperty(back)
        self._cord = _lines(rest, surface.hem)
        tube = vtkTubeFilter()  # the edge as a thin cord: without it folds that lie on each other run together
        tube.SetInputData(self._cord)
        tube.SetRadius(HEM * radius)
        tube.SetNumberOfSides(6)
        hem = shaded(None, HEM_COLOUR)
        hem.GetMapper().SetInputConnection(tube.GetOutputPort())
        self.actors = [face, hem]

    def move(self, points: np.ndarray) -> None:
        """To points (P, 3) [m]."""
        for data in (self._data, self._cord):
            data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
            data.GetPoints().Modified()
            data.Modified()
        normals = fields.node_normals(points, self._quads).astype(np.float32)
        self._data.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))

    def colour(self, rgb: np.ndarray) -> None:
        """Every point (P, 3) of bytes."""
        self._data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(rgb), deep=True))


def _lines(points: np.ndarray, pairs: np.ndarray) -> vtkPolyData:
    made = bodies.polydata(points, pairs)
    lines = vtkPolyData()
    lines.SetPoints(made.GetPoints())
    lines.SetLines(made.GetPolys())
    return lines


def shaded(data: vtkPolyData | None, colour: tuple[float, float, float], specular: float = 0.0) -> vtkActor:
    mapper = vtkPolyDataMapper()
    if data is not None:
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
