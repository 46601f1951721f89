"""drapes: every drape that a study found."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from ..display import ensure_display
from . import options as common

HELP = "every drape that a study found"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="what sundrape study wrote")
    common.add_output(parser)
    common.add_size(parser, (1500, 900))


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from .. import drapes, page

    title, found = drapes.read(options.folder)
    panel = drapes.grid(len(found), options.size)[2]
    ensure_display()
    from ..scene import Scene

    scenes = []
    for drape in found:
        frame = drape.result.last_frame
        scenes.append(Scene(drape.result, [frame], panel, drapes.CAPTION_ROOM).draw(frame))
    page.save(drapes.page(title, found, scenes, options.size), options.output)
