"""Several frames of a motion in the plane x–z on top of each other: swings, cantilevers, folds."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from . import bodies, shapes
from .load import Result
from .page import DPI, STYLE
from .units import quantity, scale_for

BODY_COLOUR = "#b5bac0"


def middle_line(result: Result) -> np.ndarray:
    """Nodes of the warp line nearest to the middle of the cloth, in the order of warp."""
    material = result.material if result.material is not None else result.reference[:, :2]
    weft = material[:, 1]
    rows = np.unique(np.round(weft, 9))
    row = rows[np.argmin(np.abs(rows - (weft.min() + weft.max()) / 2))]
    nodes = np.flatnonzero(np.abs(weft - row) < 1e-8)
    return nodes[np.argsort(material[nodes, 0])]


def strip(result: Result, count: int, size: tuple[int, int]) -> Figure:
    """`count` frames, evenly spread over the run, from light to dark; probes as thin paths."""
    line = middle_line(result)
    frames = np.unique(np.linspace(0, result.last_frame, count).round().astype(int))
    shapes = result.position[frames][:, line][:, :, [0, 2]]  # (frames, nodes of the line, 2)
    factor, prefix = scale_for(float(np.ptp(shapes.reshape(-1, 2), axis=0).max()))
    with plt.rc_context(STYLE):
        figure = plt.figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI, facecolor="white", layout="constrained")
        figure.get_layout_engine().set(w_pad=0.15, h_pad=0.15)  # inches
        axes = figure.add_subplot()
        axes.set_title(result.title, loc="left", fontsize=12)
        shades = plt.get_cmap("cividis")(np.linspace(0.88, 0.0, len(frames)))
        for (x, z), frame, shade in zip(factor * shapes.transpose(0, 2, 1), frames, shades):
            label = quantity(float(result.time[frame]), "s") if not result.is_static else f"frame {frame}"
            axes.plot(x, z, color=shade, linewidth=2.0, solid_capstyle="round", label=label)
        for probe in result.probes.values():
            axes.plot(*(factor * probe.position[:, [0, 2]]).T, color="#555555", linewidth=0.7, linestyle=(0, (4, 2)))
        low, high = axes.dataLim.min, axes.dataLim.max
        silhouettes(axes, result, factor)
        margin = 0.06 * float(max(high - low))
        axes.set_xlim(low[0] - margin, high[0] + margin)
        axes.set_ylim(low[1] - margin, high[1] + margin)
        axes.set_aspect("equal")
        axes.grid(True, color="#ececec", linewidth=0.7)
        axes.set_axisbelow(True)
        axes.set_xlabel(f"x [{prefix}m]")
        axes.set_ylabel(f"z [{prefix}m]")
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False)
        return figure


def silhouettes(axes: Axes, result: Result, factor: float, frame: int = 0) -> None:
    """Cuts of the obstacles, where they stand at a frame, with the plane y = middle of the cloth at the start."""
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersCore import vtkCutter, vtkStripper
    from vtkmodules.util.numpy_support import vtk_to_numpy

    middle = float(result.position[0, :, 1].mean())
    for obstacle in (kept.at(frame) for kept in result.obstacles.values()):
        if obstacle.kind == "plane":
            point, normal = shapes.plane(obstacle)
            if abs(normal[1]) < 0.999:
                along = np.array([normal[2], -normal[0]])
                start = factor * point[[0, 2]]
                axes.axline(start, start + along, color=BODY_COLOUR, linewidth=1.5, zorder=0)
            continue
        cut = vtkCutter()
        cut.SetInputData(bodies.body(obstacle))
        plane = vtkPlane()
        plane.SetOrigin(0, middle, 0)
        plane.SetNormal(0, 1, 0)
        cut.SetCutFunction(plane)
        chain = vtkStripper()
        chain.SetInputConnection(cut.GetOutputPort())
        chain.Update()
        outline = chain.GetOutput()
        for k in range(outline.GetNumberOfCells()):
            points = vtk_to_numpy(outline.GetCell(k).GetPoints().GetData())
            axes.fill(*(factor * points[:, [0, 2]]).T, color=BODY_COLOUR, zorder=0)
