"""What the scene stands on: patches for planes, and a soft shadow on the floor (only shadow if there is none)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from . import bodies
from .camera import View
from .weave import image_texture

PIXELS = 768
PATCH = 4.0  # half side of a patch, over the radius of what is shown
LIGHT = np.array([-0.25, 0.30, 1.0])  # towards the lamp that throws the shadow
PLANE_COLOUR = np.array([0.87, 0.875, 0.88])
SHADOW_COLOUR = np.array([0.20, 0.22, 0.26])
DEPTH = 0.55  # of the darkest shadow


def actors(
    cloth: np.ndarray, casters: Sequence[np.ndarray], planes: Sequence[tuple[np.ndarray, np.ndarray]], view: View
) -> list[vtkActor]:
    """Patches for the planes (point, normal) and the floor; `casters`: (P, 3) points [m], dense where they shade."""
    lowest = min(float(points[:, 2].min()) for points in casters)
    floors = [float(point[2]) for point, normal in planes if normal[2] > 0.999]
    drawn = [_patch(point, normal, view, 0.85) for point, normal in planes if normal[2] <= 0.999]
    height = max(floors) if floors else lowest - 0.01 * view.radius
    return drawn + [_floor(height, casters, view, solid=bool(floors))]


def _floor(height: float, casters: Sequence[np.ndarray], view: View, solid: bool) -> vtkActor:
    centre = np.array([view.target[0], view.target[1], height])
    half = PATCH * view.radius
    shadow = DEPTH * np.clip(_shadow(casters, centre, half), 0, 1)
    fade = _fade()
    base = fade if solid else np.zeros_like(fade)
    alpha = shadow + base * (1 - shadow)
    weight = np.divide(shadow, alpha, out=np.zeros_like(alpha), where=alpha > 0)[..., None]
    colour = weight * SHADOW_COLOUR + (1 - weight) * PLANE_COLOUR
    return _quad(centre, np.array([0.0, 0.0, 1.0]), half, np.concatenate([colour, alpha[..., None]], axis=2))


def _patch(point: np.ndarray, normal: np.ndarray, view: View, opacity: float) -> vtkActor:
    """A plane that is not the floor: the part of it nearest to the scene, see-through at its rim."""
    centre = view.target - normal * np.dot(view.target - point, normal)
    alpha = opacity * _fade()
    colour = np.broadcast_to(PLANE_COLOUR, (*alpha.shape, 3))
    return _quad(centre, normal, 0.4 * PATCH * view.radius, np.concatenate([colour, alpha[..., None]], axis=2))


def _fade() -> np.ndarray:
    s = np.linspace(-1, 1, PIXELS)
    r = np.hypot(*np.meshgrid(s, s))
    t = np.clip((1 - r) / 0.7, 0, 1)
    return t * t * (3 - 2 * t)


def _quad(centre: np.ndarray, normal: np.ndarray, half: float, rgba: np.ndarray) -> vtkActor:
    frame = bodies.frame_of(normal) if abs(normal[2]) < 0.999 else np.eye(3)
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float)
    data = bodies.polydata(centre + half * corners @ frame[:, :2].T, np.arange(4)[None])
    data.GetPointData().SetTCoords(numpy_to_vtk((corners + 1) / 2, deep=True))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetTexture(image_texture((255 * rgba).round().astype(np.uint8), repeat=False))
    actor.GetProperty().LightingOff()
    actor.ForceTranslucentOn()
    return actor


def _shadow(casters: Sequence[np.ndarray], centre: np.ndarray, half: float) -> np.ndarray:
    """Darkness (PIXELS, PIXELS) in 0..1: points thrown along the light, blurred the more the higher they are."""
    total = np.ones((PIXELS, PIXELS))
    pixel = 2 * half / PIXELS
    for points in casters:
        above = points[points[:, 2] >= centre[2] - 1e-9]
        rise = above[:, 2] - centre[2]
        thrown = above[:, :2] - rise[:, None] * LIGHT[:2] / LIGHT[2] - centre[:2] + half
        limits = np.quantile(rise, [0, 0.34, 0.67, 1]) if len(rise) else []
        for low, high in zip(limits[:-1], limits[1:]):
            layer = thrown[(rise >= low) & (rise <= high)]
            count, _, _ = np.histogram2d(layer[:, 1], layer[:, 0], bins=PIXELS, range=[[0, 2 * half]] * 2)
            if not count.any():
                continue
            cover = np.clip(_blur(np.minimum(count, 1), 2.0) * 4, 0, 1)
            blur = max((0.25 * (low + high) / 2 + 0.01 * half) / pixel, 1.0)
            total *= 1 - np.clip(_blur(cover, blur), 0, 1)
    return 1 - total


def _blur(image: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian blur, sigma in pixels, periodic (the patch's rim is empty)."""
    f = np.fft.fftfreq(PIXELS)
    kernel = np.exp(-2 * (np.pi * sigma * f) ** 2)
    return np.real(np.fft.ifft2(np.fft.fft2(image) * kernel[:, None] * kernel[None, :]))
