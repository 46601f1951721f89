"""The look of the cloth's surface: a faint plain weave and a line every few centimetres of warp and weft."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture

PIXELS = 512
THREADS = 16  # across one tile
NET_LINE, BETWEEN = 0.04, 0.30  # half width of a net's lines over the tile; opacity between them
LINE = 0.022  # width of the marking line, over the tile


def image_texture(pixels: np.ndarray, repeat: bool, filtering: int = 1) -> vtkTexture:
    """A texture of an image (height, width, 3 or 4) of bytes, bottom row first."""
    height, width, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels).reshape(-1, channels), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetRepeat(repeat)
    texture.InterpolateOn()
    texture.SetMipmap(repeat)
    texture.SetMaximumAnisotropicFiltering(filtering)
    texture.SetColorModeToDirectScalars()
    return texture


def weave_texture(filtering: int) -> vtkTexture:
    """One tile, a marking line along two of its sides; repeated in units of the thread spacing."""
    s = (np.arange(PIXELS) + 0.5) / PIXELS
    warp, weft = np.meshgrid(s, s)
    phase = np.pi * THREADS
    over = np.sign(np.sin(phase * warp) * np.sin(phase * weft))
    round_thread = np.where(over > 0, np.abs(np.sin(phase * warp)), np.abs(np.sin(phase * weft)))
    return _marked(0.90 + 0.10 * np.sqrt(round_thread), filtering)


def line_texture(filtering: int) -> vtkTexture:
    """The marking lines alone: under a field's colours the threads would only be noise."""
    return _marked(np.ones((PIXELS, PIXELS)), filtering)


def net_texture(filtering: int) -> vtkTexture:
    """Lines of a net, and little between them: what is behind shows through."""
    s = (np.arange(PIXELS) + 0.5) / PIXELS
    lines = np.zeros((PIXELS, PIXELS))
    for along in np.meshgrid(s, s):
        distance = np.minimum(along, 1 - along)
        lines = np.maximum(lines, np.clip(1.5 - distance / NET_LINE, 0, 1))
    rgba = np.full((PIXELS, PIXELS, 4), 255, dtype=np.uint8)
    rgba[..., 3] = 255 * (BETWEEN + (1 - BETWEEN) * lines)
    return image_texture(rgba, True, filtering)


def _marked(shade: np.ndarray, filtering: int) -> vtkTexture:
    s = (np.arange(PIXELS) + 0.5) / PIXELS
    for along in np.meshgrid(s, s):
        distance = np.minimum(along, 1 - along)
        shade = shade * (1 - 0.22 * np.clip(1.5 - distance / (LINE / 2), 0, 1))
    return image_texture(np.repeat((255 * shade)[..., None], 3, axis=2).astype(np.uint8), True, filtering)
