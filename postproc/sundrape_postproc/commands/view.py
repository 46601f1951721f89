"""view: a page to play, turn and pick in a browser; the verb `view` and the command `sundrape-view`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from . import options as common

HELP = "a page to play, turn and pick in a browser, without a server"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser, (".html",))
    parser.add_argument(
        "--frames", type=_frames, metavar="N", help="show at most N frames, evenly spaced (default: all)"
    )


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from .. import view
    from ..load import load

    view.write(load(options.result), options.output, options.frames)


def main(arguments: Sequence[str] | None = None) -> int:
    """`sundrape-view OUT.h5` writes OUT.html beside it; otherwise the verb `view`."""
    from ..cli import main as everything

    arguments = list(sys.argv[1:] if arguments is None else arguments)
    return everything(["view", *_with_output(arguments)])


def _with_output(arguments: list[str]) -> list[str]:
    files = [a for a in arguments if a.endswith(".h5")]
    names_output = any(a in ("-h", "--help") or a.startswith(("-o", "--o")) for a in arguments)
    if names_output or len(files) != 1:
        return arguments
    return [*arguments, "-o", files[0].removesuffix(".h5") + ".html"]


def _frames(text: str) -> int:
    if not text.isdecimal() or int(text) < 2:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of frames from 2 up")
    return int(text)
