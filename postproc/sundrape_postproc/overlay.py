"""Several results in one picture: their cloths through each other, their middle lines, and how far apart they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkRenderingCore import vtkActor

from . import bodies, page
from .camera import Room, View, three_quarter
from .clearance import drape_over
from .energies import Look
from .ground import Ground
from .load import Result
from .measured import Points, to_line, to_surface
from .scene import BODY_COLOUR, LIFT, shaded
from .shapes import plane as plane_of
from .stage import STILL, Stage
from .strip import middle_line, silhouettes
from .surface import SmoothSurface
from .threads import thread_spacing
from .units import quantity, scale_for
from .weave import net_texture

SHARE = 0.58  # of the width for the view in space
LOOKS = (
    Look("", "#0072B2"),
    Look("", "#E69F00", (0, (6, 2))),
    Look("", "#009E73", (0, (1, 1.2))),
    Look("", "#CC79A7", (0, (4, 1.4, 1, 1.4))),
    Look("", "#56B4E9", (0, (2.5, 1.2))),
    Look("", "#555555", (0, (8, 1.5, 1, 1.5, 1, 1.5))),
)
POINT_COLOUR = "#000000"
MARKERS = "os^Dv<>" * 5
NEAR = 0.05  # of the cloth's width: points beside the middle line that the side view shows


@dataclass(frozen=True)
class Layer:
    """One result at its end."""

    result: Result
    name: str

    @property
    def shape(self) -> np.ndarray:
        """(N, 3) [m]."""
        return self.result.position[self.result.last_frame]

    @property
    def line(self) -> np.ndarray:
        """Of the middle warp line (K, 3) [m]."""
        return self.shape[middle_line(self.result)]


def layers(results: Sequence[Result]) -> list[Layer]:
    """Named by their files; by folder too where files have the same name."""
    stems = [result.path.stem for result in results]
    names = [
        stem if stems.count(stem) == 1 else f"{result.path.resolve().parent.name}/{stem}"
        for stem, result in zip(stems, results)
    ]
    return [Layer(result, name) for result, name in zip(results, names)]


def apart(first: Layer, second: Layer) -> tuple[float, float] | None:
    """Largest and RMS distance [m] of the nodes of two layers; None if their meshes are not the same."""
    if not np.array_equal(first.result.quads, second.result.quads) or first.shape.shape != second.shape.shape:
        return None
    distance = np.linalg.norm(second.shape - first.shape, axis=1)
    return float(distance.max()), float(np.sqrt(np.mean(distance**2)))


def from_points(layer: Layer, points: Points) -> np.ndarray:
    """Distance of each measured point [m]: from the surface, or in the plane x–z from the middle line."""
    if points.in_plane:
        return to_line(points.place[:, [0, 2]], layer.line[:, [0, 2]])
    return to_surface(points.place, layer.shape, layer.result.quads)


def legend_text(layer: Layer, first: Layer, points: Sequence[Points]) -> str:
    """Two or more lines on a layer."""
    result = layer.result
    lines = [f"{layer.name}: {result.model}, {result.analysis}"]
    if layer is not first:
        distances = apart(first, layer)
        if distances is None:
            lines.append(f"mesh is not that of {first.name}")
        else:
            largest, typical = (_length(d) for d in distances)
            lines.append(f"nodes from {first.name}: at most {largest}, RMS {typical}")
    for measured in points:
        distance = from_points(layer, measured)
        rms = float(np.sqrt(np.mean(distance**2)))
        lines.append(f"points {measured.name} from it: at most {_length(float(distance.max()))}, RMS {_length(rms)}")
    return "\n   ".join(lines)


def table(drawn: Sequence[Layer], points: Sequence[Points]) -> list[str]:
    """Lines of CSV: every measured point and how far it is from each layer."""
    lines = []
    for measured in points:
        distances = [from_points(layer, measured) for layer in drawn]
        lines.append(
            ",".join(["points", "x [m]", "y [m]", "z [m]", *(f"distance from {layer.name} [m]" for layer in drawn)])
        )
        for k, place in enumerate(measured.place):
            y = "" if measured.in_plane else f"{place[1]:.6g}"
            values = [f"{place[0]:.6g}", y, f"{place[2]:.6g}", *(f"{distance[k]:.4g}" for distance in distances)]
            lines.append(",".join([f"{measured.name} {k + 1}", *values]))
        rms = [f"{np.sqrt(np.mean(distance**2)):.4g}" for distance in distances]
        lines.append(",".join([f"{measured.name} RMS", "", "", "", *rms]))
    return lines


def in_space(drawn: Sequence[Layer], size: tuple[int, int]) -> tuple[np.ndarray, View]:
    """The cloths as translucent nets (height, width, 3), and where they are seen from; with the first one's obstacles."""
    shapes = [layer.shape for layer in drawn]
    result = drawn[0].result
    obstacles = [obstacle.at(result.last_frame) for obstacle in result.obstacles.values()]
    solid = [bodies.body(o) for o in obstacles if o.kind != "plane"]
    surfaces = [np.array(bodies.points_of(data)) for data in solid]
    view = three_quarter(np.concatenate(shapes), surfaces, size[0] / size[1], Room(top=0.08, bottom=0.04))
    stage = Stage(size, STILL, view.radius, see_through=True)
    thrown = []
    for k, (layer, look) in enumerate(zip(drawn, LOOKS)):
        mesh = SmoothSurface(layer.result.quads, len(layer.shape))
        points = drape_over(
            mesh.points(layer.shape), mesh.quads, obstacles, (1 + 0.6 * k) * LIFT * view.radius
        )  # side by side
        nearer = points + 0.003 * k * (view.eye - points)  # seen as before, but never in the very place of another cloth
        stage.renderer.AddActor(_net(layer, mesh, nearer, look))
        thrown.append(points)
    for data in solid:
        stage.renderer.AddActor(shaded(data, BODY_COLOUR, specular=0.12))
    planes = [plane_of(o) for o in obstacles if o.kind == "plane"]
    heights = np.concatenate([[points[:, 2].min(), points[:, 2].max()] for points in [*shapes, *surfaces]])
    ground = Ground(planes, (float(heights.min()), float(heights.max())), view, STILL.shadow_pixels)
    ground.stand(surfaces)
    ground.cast([np.concatenate(thrown)])
    for actor in ground.actors:
        stage.renderer.AddActor(actor)
    image = stage.image(view)
    stage.close()
    return image, view


def _net(layer: Layer, mesh: SmoothSurface, points: np.ndarray, look: Look) -> vtkActor:
    data = bodies.polydata(points, mesh.quads)
    actor = shaded(None, to_rgb(look.colour))
    material = layer.result.material
    if material is not None:
        lines = mesh.interpolated(material) / thread_spacing(material)
        data.GetPointData().SetTCoords(numpy_to_vtk(np.ascontiguousarray(lines), deep=True))
        actor.SetTexture(net_texture(STILL.texture_filtering))
    else:
        actor.GetProperty().SetOpacity(0.5)
    actor.ForceTranslucentOn()
    actor.GetMapper().SetInputData(bodies.with_normals(data))
    return actor


def overlay(
    drawn: Sequence[Layer], points: Sequence[Points], size: tuple[int, int], space: tuple[np.ndarray, View]
) -> Figure:
    """The page: `space` is what `in_space` drew, in `space_size(size)`."""
    image, view = space
    with plt.rc_context(page.STYLE):
        figure = page.new_figure(size)
        page.place_image(figure, image, 0)
        titles = list(dict.fromkeys(layer.result.title for layer in drawn))
        title = titles[0] if len(titles) == 1 else f"{titles[0]} and {len(titles) - 1} more"
        figure.text(0.02, 0.955, title, fontsize=13, fontweight="bold", va="top")
        extent = space_size(size)
        for measured, marker in zip(points, MARKERS):
            if not measured.in_plane:
                seen = view.pixels(measured.place, extent) / size
                for x, y in seen[((seen > 0) & (seen < np.divide(extent, size))).all(axis=1)]:
                    figure.add_artist(plt.Line2D([x], [y], marker=marker, markersize=4.5, markerfacecolor="white",
                                                 markeredgecolor=POINT_COLOUR, markeredgewidth=1.1))  # fmt: skip
        lines = sum(legend_text(layer, drawn[0], points).count("\n") + 1 for layer in drawn) + len(points)
        below = min(0.16 + 0.024 * lines * 760 / size[1], 0.6)
        axes = figure.add_axes((SHARE + 0.065, below, 1 - SHARE - 0.085, 0.93 - below))
        _side(axes, drawn, points)
        axes.legend(loc="upper left", bbox_to_anchor=(SHARE + 0.015, below - 0.075), bbox_transform=figure.transFigure,
                    frameon=False, fontsize=8.5, borderaxespad=0, handlelength=3.2, labelspacing=0.7)  # fmt: skip
        return figure


def space_size(size: tuple[int, int]) -> tuple[int, int]:
    """Pixels of the view in space on a page of `size`."""
    return round(SHARE * size[0]), size[1]


def _side(axes: Axes, drawn: Sequence[Layer], points: Sequence[Points]) -> None:
    lines = [layer.line[:, [0, 2]] for layer in drawn]
    near = [measured.place[_beside(measured, drawn[0])][:, [0, 2]] for measured in points]
    every = np.concatenate([*lines, *near])
    factor, prefix = scale_for(float(np.ptp(every, axis=0).max()))
    for layer, line, look in zip(drawn, lines, LOOKS):
        label = legend_text(layer, drawn[0], points)
        axes.plot(*(factor * line.T), color=look.colour, linestyle=look.dashes, linewidth=1.8, label=label)
    for measured, marker in zip(points, MARKERS):
        near = measured.place[_beside(measured, drawn[0])]
        text = f"points {measured.name}: {len(measured.place)} measured"
        if len(near) < len(measured.place):
            text += f", {len(near)} of them near the middle line"
        axes.plot(
            *(factor * near[:, [0, 2]].T),
            marker,
            color=POINT_COLOUR,
            markersize=4.5,
            markerfacecolor="white",
            label=text,
        )
    low, high = factor * every.min(axis=0), factor * every.max(axis=0)
    silhouettes(axes, drawn[0].result, factor, drawn[0].result.last_frame)
    margin = 0.06 * float(max(high - low))
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_title("The middle warp line, from the side", loc="left")
    axes.grid(True, color="#ececec", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.set_xlabel(f"x [{prefix}m]")
    axes.set_ylabel(f"z [{prefix}m]")


def _beside(measured: Points, layer: Layer) -> np.ndarray:
    """Which points (P,) belong in the side view: those in its plane, or near the middle line."""
    if measured.in_plane:
        return np.ones(len(measured.place), dtype=bool)
    width = float(np.ptp(layer.result.reference[:, 1]))
    return np.abs(measured.place[:, 1] - layer.line[:, 1].mean()) <= NEAR * width


def _length(value: float) -> str:
    return quantity(value, "m") if value > 0 else "0 m"
