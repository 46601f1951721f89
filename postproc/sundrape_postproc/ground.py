"""What the scene stands on: patches for planes, and a soft shadow on the floor (only shadow if there is none)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from . import bodies, shapes
from .camera import View
from .weave import image_texture

PIXELS = 768  # of the shadow that the blurs below are measured in
PATCH = 4.0  # half side of a patch, over the radius of what is shown
LIGHT = np.array([-0.25, 0.30, 1.0])  # towards the lamp that throws the shadow
PLANE_COLOUR = np.array([0.87, 0.875, 0.88])
SHADOW_COLOUR = np.array([0.20, 0.22, 0.26])
LAYERS = 4  # heights that shadows are blurred for
DEPTH = 0.55  # of the darkest shadow


class Ground:
    """The patches of a scene's planes and the floor with its shadow."""

    def __init__(
        self, planes: Sequence[tuple[np.ndarray, np.ndarray]], span: tuple[float, float], view: View, pixels: int
    ) -> None:
        """`planes`: (point, normal) each; `span`: heights of the lowest and the highest point ever shown [m];
        `pixels` of the shadow."""
        lowest, self._top = span
        floors = [float(point[2]) for point, normal in planes if normal[2] > 0.999]
        height = max(floors) if floors else lowest - 0.01 * view.radius
        self._base = _fade(pixels) * bool(floors)
        self._centre = np.array([view.target[0], view.target[1], height])
        self._half = PATCH * view.radius
        self._still = np.ones((pixels, pixels))
        self._floor = _quad(self._centre, np.array([0.0, 0.0, 1.0]), self._half)
        patches = [_patch(point, normal, view, 0.85, pixels) for point, normal in planes if normal[2] <= 0.999]
        self.actors = [*patches, self._floor]

    def stand(self, casters: Sequence[np.ndarray]) -> None:
        """Throw the shadow of what does not move: (P, 3) points [m] each, dense where they shade."""
        self._still = _light_left(casters, self._centre, self._half, self._top, len(self._base))

    def cast(self, casters: Sequence[np.ndarray]) -> None:
        """Throw the shadow of what moves."""
        light = self._still * _light_left(casters, self._centre, self._half, self._top, len(self._base))
        shadow = DEPTH * np.clip(1 - light, 0, 1)
        alpha = shadow + self._base * (1 - shadow)
        weight = np.divide(shadow, alpha, out=np.zeros_like(alpha), where=alpha > 0)[..., None]
        _paint(
            self._floor,
            np.concatenate([weight * SHADOW_COLOUR + (1 - weight) * PLANE_COLOUR, alpha[..., None]], axis=2),
        )


def _patch(point: np.ndarray, normal: np.ndarray, view: View, opacity: float, pixels: int) -> vtkActor:
    """A wall: a patch where the scene is nearest to the plane."""
    centre = view.target - normal * np.dot(view.target - point, normal)
    alpha = opacity * _fade(pixels)
    colour = np.broadcast_to(PLANE_COLOUR, (*alpha.shape, 3))
    actor = _quad(centre, normal, 0.4 * PATCH * view.radius)
    _paint(actor, np.concatenate([colour, alpha[..., None]], axis=2))
    return actor


def _fade(pixels: int) -> np.ndarray:
    s = np.linspace(-1, 1, pixels)
    r = np.hypot(*np.meshgrid(s, s))
    t = np.clip((1 - r) / 0.7, 0, 1)
    return t * t * (3 - 2 * t)


def _quad(centre: np.ndarray, normal: np.ndarray, half: float) -> vtkActor:
    frame = shapes.frame_of(normal) if abs(normal[2]) < 0.999 else np.eye(3)
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float)
    data = bodies.polydata(centre + half * corners @ frame[:, :2].T, np.arange(4)[None])
    data.GetPointData().SetTCoords(numpy_to_vtk((corners + 1) / 2, deep=True))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.ForceTranslucentOn()
    return actor


def _paint(actor: vtkActor, rgba: np.ndarray) -> None:
    actor.SetTexture(image_texture((255 * rgba).round().astype(np.uint8), repeat=False))


def _light_left(casters: Sequence[np.ndarray], centre: np.ndarray, half: float, top: float, pixels: int) -> np.ndarray:
    """Share (pixels, pixels) of light that passes points thrown along it, blurred the more the higher they are.

    Every point counts in the two of LAYERS heights that it lies between, in shares that go with its own: a shadow
    changes steadily as its caster rises.
    """
    total = np.ones((pixels, pixels))
    pixel = 2 * half / pixels
    grain = 2.0 * pixels / PIXELS  # what closes the gaps between points
    for points in casters:
        above = points[points[:, 2] >= centre[2] - 1e-9]
        rise = above[:, 2] - centre[2]
        thrown = (above[:, :2] - rise[:, None] * LIGHT[:2] / LIGHT[2] - centre[:2] + half) / pixel
        count = _sums(thrown, np.ones(len(thrown)), pixels)
        if not count.any():
            continue
        cover = np.clip(_blur(np.minimum(count, 1), grain) * 4, 0, 1)
        near = np.maximum(_blur(count, grain), 1e-9)
        height = np.clip(rise / max(top - centre[2], 1e-9), 0, 1) * (LAYERS - 1)
        dark = np.zeros_like(cover)
        for layer in range(LAYERS):
            share = np.clip(1 - np.abs(height - layer), 0, 1)
            if share.any():
                sigma = (0.25 * (top - centre[2]) * layer / (LAYERS - 1) + 0.01 * half) / pixel
                here = np.clip(_blur(_sums(thrown, share, pixels), grain) / near, 0, 1)
                dark += _blur(cover * here, max(sigma, 1.0))
        total *= 1 - np.clip(dark, 0, 1)
    return total


def _sums(places: np.ndarray, shares: np.ndarray, pixels: int) -> np.ndarray:
    """Sums (pixels, pixels) of the shares (P,) at places (P, 2) in pixels, x first, over each pixel (rows y)."""
    cell = np.floor(places).astype(np.int64)
    inside = ((cell >= 0) & (cell < pixels)).all(axis=1)
    index = cell[inside, 1] * pixels + cell[inside, 0]
    return np.bincount(index, shares[inside], pixels**2).reshape(pixels, pixels)


def _blur(image: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian blur, sigma in pixels, periodic (the patch's rim is empty)."""
    rows, columns = np.fft.fftfreq(len(image)), np.fft.rfftfreq(len(image))
    kernels = [np.exp(-2 * (np.pi * sigma * f) ** 2) for f in (rows, columns)]
    return np.fft.irfft2(np.fft.rfft2(image) * kernels[0][:, None] * kernels[1][None, :], s=image.shape)
