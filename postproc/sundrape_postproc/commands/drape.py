"""drape: what a drape tester measures, of one result or several."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path

from ..errors import BAD_USE, PostprocError
from . import options as common

HELP = "shadow outline, drape coefficient, fold count and polar profile of a Cusick test"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("results", type=Path, metavar="RESULT.h5", nargs="+", help="several: side by side")
    common.add_output(parser)
    parser.add_argument("--json", type=common.writable, metavar="FILE", help="the numbers, with units in their names")
    common.add_frame(parser)
    parser.add_argument("--support", type=common.length, metavar="LENGTH", help="the support's radius, such as 9cm or 0.09")
    common.add_size(parser)


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load

    results = [load(path) for path in options.results]
    frames = [common.frame_of(options.frame, result) for result in results]
    from .. import drape, drape_page, page

    if len(results) > drape_page.MOST:
        raise PostprocError(f"{len(results)} results: at most {drape_page.MOST} have room on the page", BAD_USE)
    tests = [drape.measure(result, frame, options.support) for result, frame in zip(results, frames)]
    titles = {result.title for result in results}
    title = titles.pop() if len(titles) == 1 else "Drape tests"
    size = options.size or ((1200, 600) if len(tests) == 1 else (400 * len(tests), 780))
    page.save(drape_page.page(title, tests, size), options.output)
    if options.json:
        try:
            options.json.write_text(json.dumps(drape.report(tests), indent=1) + "\n", encoding="utf-8")
        except OSError as trouble:
            raise PostprocError(f"{options.json}: {trouble.strerror or trouble}") from trouble
