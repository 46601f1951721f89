"""crosscheck: where the methods of a crosscheck ended."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from . import options as common

HELP = "where the methods of a crosscheck ended, and how far apart"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="what sundrape crosscheck wrote")
    common.add_output(parser)
    common.add_size(parser, (1400, 640))


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from .. import crosscheck, page

    page.save(crosscheck.page(options.folder, crosscheck.read(options.folder), options.size), options.output)
