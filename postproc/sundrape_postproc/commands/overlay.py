"""overlay: several results on one picture."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from ..display import ensure_display
from ..errors import BAD_USE, PostprocError
from . import options as common

HELP = "where several results end, laid on each other and on measured points"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "results", type=Path, nargs="+", metavar="RESULT.h5", help="2 to 6; distances are from the first"
    )
    common.add_output(parser)
    common.add_size(parser, (1500, 760))
    parser.add_argument(
        "--points",
        type=Path,
        action="append",
        default=[],
        metavar="CSV",
        help="measured points: x [cm],z [cm] or with y; repeatable",
    )


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load
    from ..measured import read_points

    if not (2 - bool(options.points) <= len(options.results) <= 6):
        raise PostprocError("overlay: needs 2 to 6 results, or 1 with --points", BAD_USE)
    points = [read_points(path) for path in options.points]
    results = [load(path) for path in options.results]
    ensure_display()
    from .. import overlay, page

    drawn = overlay.layers(results)
    space = overlay.in_space(drawn, overlay.space_size(options.size))
    page.save(overlay.overlay(drawn, points, options.size, space), options.output)
    for line in overlay.table(drawn, points):
        print(line)
