"""filmstrip: several frames in 3D, side by side."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from ..display import ensure_display
from . import options as common

HELP = "several frames in 3D, side by side, closer in time where the cloth moves faster"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser)
    common.add_size(parser, (1600, 400))
    common.add_count(parser, 5)
    common.add_colour(parser)


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load

    result = load(options.result)
    frames = result.telling_frames(options.count)
    ensure_display()
    from .. import page
    from ..scene import Scene

    scale = common.scale_of(options, result, frames)
    scene = Scene(result, frames, page.panel_size(options.size, len(frames)), page.strip_room(scale), scale)
    figure = page.filmstrip(result, frames, [scene.draw(frame) for frame in frames], options.size, scale)
    page.save(figure, options.output)
