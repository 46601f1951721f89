"""strip: several frames of a motion in the plane x–z on top of each other."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from . import options as common

HELP = "several frames of a motion in the plane x-z on top of each other"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser)
    common.add_size(parser, (1000, 700))
    common.add_count(parser, 9)


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load

    result = load(options.result)
    from .. import page, strip

    page.save(strip.strip(result, options.count, options.size), options.output)
