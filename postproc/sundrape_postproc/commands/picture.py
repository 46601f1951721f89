"""picture: one frame in 3D beside its energies."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from ..display import ensure_display
from . import options as common

HELP = "the cloth in 3D beside its energies (or the residual of a static analysis)"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser)
    common.add_size(parser, (1500, 860))
    common.add_frame(parser)
    common.add_colour(parser)


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load

    result = load(options.result)
    frame = common.frame_of(options.frame, result)
    ensure_display()
    from .. import page
    from ..scene import Scene

    scale = common.scale_of(options, result, [frame])
    scene = Scene(result, [frame], page.scene_size(options.size), page.room(scale), scale)
    page.save(page.picture(result, frame, scene.draw(frame), options.size, scale), options.output)
