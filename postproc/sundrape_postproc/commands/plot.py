"""plot: diagrams of a run on one page."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from . import options as common

HELP = "energies, step sizes, reactions, probes, the path of loads and the residual over a run"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser, (".png", ".pdf", ".svg"))
    parser.add_argument(
        "--what",
        type=lambda text: text.split(","),
        metavar="LIST",
        help="of energies,steps,reactions,probes,load,residual (default: all that the result has)",
    )


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load

    result = load(options.result)
    from .. import page, plot

    page.save(plot.plot(result, options.what), options.output)
