"""study: the figures that a study describes."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from ..errors import PostprocError

HELP = "the figures that a study describes"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="what sundrape study wrote")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FOLDER", help="made if it is not there")
    parser.add_argument("--figure", action="append", metavar="NAME", help="one of them; repeatable (default: all)")
    parser.add_argument("--format", choices=("png", "pdf", "svg"), default="png", help="of the files (default png)")


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from .. import page, study

    found = study.read(options.folder)
    wanted = study.figures(found, options.figure)
    try:
        options.output.mkdir(parents=True, exist_ok=True)
    except OSError as trouble:
        raise PostprocError(f"{options.output}: {trouble.strerror or trouble}") from trouble
    for figure in wanted:
        page.save(study.draw(found, figure), options.output / f"{figure['name']}.{options.format}")
