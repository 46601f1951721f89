"""Arguments that several commands have, and their checks."""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import BAD_USE, PostprocError

if TYPE_CHECKING:
    from ..colours import Scale
    from ..load import Result

COLOURS = ("weave", "strain", "curvature", "contact", "energy", "speed")


LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}


def add_result(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("result", type=Path, metavar="RESULT.h5")


def add_output(parser: argparse.ArgumentParser, kinds: tuple[str, ...] = (".png",)) -> None:
    """`-o`, whose name has to end in one of `kinds`, in a folder that is there."""

    def output(text: str) -> Path:
        path = Path(text)
        if path.suffix.lower() not in kinds:
            raise PostprocError(f"{path}: its name must end in {' or '.join(kinds)}", BAD_USE)
        return writable(text)

    parser.add_argument("-o", "--output", type=output, required=True, metavar="FILE" + "|".join(kinds))


def add_size(parser: argparse.ArgumentParser, default: tuple[int, int] | None = None) -> None:
    """`--size`; without a default the command makes its page as large as it needs."""
    usual = "as it needs" if default is None else "%dx%d" % default
    parser.add_argument("--size", type=_size, default=default, metavar="WxH", help=f"in pixels (default {usual})")


def add_frame(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--frame", type=int, metavar="K", help="0 is the first, -1 the last (default)")


def add_count(parser: argparse.ArgumentParser, default: int) -> None:
    parser.add_argument("--count", type=_count, default=default, metavar="N", help=f"frames (default {default})")


def add_colour(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--colour", choices=COLOURS, default=COLOURS[0], help="of the cloth: its weave, or a field")
    parser.add_argument("--range", metavar="LOW:HIGH", help="of the colours, SI (default: 0 to the 99.5th percentile)")


def scale_of(options: argparse.Namespace, result: Result, frames: Sequence[int]) -> Scale | None:
    """The scale of `--colour` and `--range` over the frames that are shown; None for the weave."""
    from .. import colours

    if options.colour == colours.WEAVE:
        if options.range is not None:
            raise PostprocError("--range: needs --colour FIELD", BAD_USE)
        return None
    limits = None if options.range is None else colours.parse_range(options.range)
    return colours.scale_of(result, options.colour, frames, limits)


def processors() -> int:
    """That this process may use, at most 4: more processes wait for memory."""
    return min(len(os.sched_getaffinity(0)), 4)


def writable(text: str) -> Path:
    """A file to be, in a folder that is there."""
    path = Path(text)
    if not path.resolve().parent.is_dir():
        raise PostprocError(f"{path}: no such directory: {path.parent}")
    return path


def length(text: str) -> float:
    """A positive length [m]: "9 cm", "90mm", "0.09 m" or "0.09"."""
    match = re.fullmatch(r"\s*([0-9.]+(?:[eE][-+]?\d+)?)\s*(mm|cm|m|in)?\s*", text)
    try:
        value = float(match[1]) * LENGTHS[match[2] or "m"] if match else 0.0
    except ValueError:
        value = 0.0
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r} is not a length such as 9cm, 90mm, 0.09m or 0.09")
    return value


def frame_of(wanted: int | None, result: Result) -> int:
    """A frame number counted from either end; the last drawable one by default."""
    count = len(result.time)
    if wanted is None:
        return result.last_frame
    if not -count <= wanted < count:
        raise PostprocError(f"--frame {wanted}: {result.path} has frames 0 to {count - 1}", BAD_USE)
    return wanted % count


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    if match is None or not all(100 <= int(n) <= 8000 for n in match.groups()):
        raise argparse.ArgumentTypeError(f"{text!r} is not WIDTHxHEIGHT in pixels, each from 100 to 8000")
    return int(match[1]), int(match[2])


def _count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 50:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of frames from 1 to 50")
    return int(text)
