"""An off-screen window with lights: actors are put on it once, and pictures taken of them as they move."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the renderer with VTK's factories
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

from .camera import View

OCCLUSION = 0.5  # share of the picture with ambient occlusion; all of it looks sooty
BACKGROUND_TOP, BACKGROUND_BOTTOM = (0.90, 0.92, 0.94), (0.985, 0.985, 0.98)


@dataclass(frozen=True)
class Quality:
    """What a picture may cost."""

    supersampling: int  # pixels drawn across one that is shown
    occlusion: bool  # whether folds darken each other; drawn twice then, and its grain would crawl in a film
    shadow_pixels: int  # of the shadow's image, across
    texture_filtering: int  # samples of a texture that is seen at a slant


STILL = Quality(2, True, 768, 8)
MOVING = Quality(2, False, 384, 2)


class Stage:
    """A renderer in its window."""

    def __init__(self, size: tuple[int, int], quality: Quality, radius: float, see_through: bool = False) -> None:
        """`size`: pixels across and down; `radius`: of what is shown [m]; `see_through`: things behind translucent
        ones show, layer by layer, without ambient occlusion."""
        self._size, self._quality = size, quality
        self.renderer = vtkRenderer()
        self.renderer.GradientBackgroundOn()
        self.renderer.SetBackground(*BACKGROUND_BOTTOM)
        self.renderer.SetBackground2(*BACKGROUND_TOP)
        _light(self.renderer)
        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(True)
        self._window.SetMultiSamples(0)
        self._window.SetSize(*(quality.supersampling * n for n in size))
        self._window.AddRenderer(self.renderer)
        if see_through:
            self._window.SetAlphaBitPlanes(True)
            self.renderer.UseDepthPeelingOn()
            self.renderer.SetMaximumNumberOfPeels(8)
            self.renderer.SetOcclusionRatio(0.0)
        self._occlusion = _occlusion(radius) if quality.occlusion and not see_through else None

    def image(self, view: View) -> np.ndarray:
        """What is seen, (height, width, 3) of bytes, top row first."""
        view.apply(self.renderer)
        self.renderer.SetPass(None)
        seen = self._drawn()
        if self._occlusion is not None:
            self.renderer.SetPass(self._occlusion)
            seen = OCCLUSION * self._drawn() + (1 - OCCLUSION) * seen
        return seen.round().astype(np.uint8)

    def close(self) -> None:
        self._window.Finalize()

    def _drawn(self) -> np.ndarray:
        """(height, width, 3) in 0..255."""
        self._window.Render()
        n, (width, height) = self._quality.supersampling, self._size
        pixels = vtkUnsignedCharArray()
        self._window.GetPixelData(0, 0, n * width - 1, n * height - 1, 0, pixels, 0)
        fine = vtk_to_numpy(pixels).reshape(n * height, n * width, 3)[::-1]
        total = np.zeros((height, width, 3), dtype=np.uint16)
        for row in range(n):
            for column in range(n):
                total += fine[row::n, column::n]
        return total.astype(np.float32) / n**2


def _occlusion(radius: float) -> vtkSSAOPass:
    occlusion = vtkSSAOPass()
    occlusion.SetRadius(0.12 * radius)
    occlusion.SetBias(0.004 * radius)
    occlusion.SetKernelSize(48)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtkRenderStepsPass())
    return occlusion


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
