"""film: the motion, as MP4 or GIF."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence

from ..display import ensure_display
from . import options as common

HELP = "the motion in 3D as a film, in its own time, slower or faster"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser, (".mp4", ".gif"))
    common.add_size(parser, (1280, 720))
    common.add_colour(parser)
    parser.add_argument(
        "--fps", type=_positive, metavar="N", help="pictures a second (default 30; 10 where there is no time)"
    )
    parser.add_argument("--speed", type=_positive, default=1.0, metavar="X", help="times its own speed (default 1)")
    parser.add_argument("--camera", choices=("fixed", "orbit"), default="fixed", help="(default fixed)")
    parser.add_argument(
        "--turns", type=float, default=1.0, metavar="X", help="of an orbit (default 1; negative: clockwise)"
    )
    parser.add_argument(
        "--frames", type=_frames, metavar="A:B:S", help="frames from A up to B, without B, every S-th, as in Python"
    )
    parser.add_argument(
        "--fine", action="store_true", help="folds darken each other, as in pictures; five times slower"
    )
    parser.add_argument("--jobs", type=_jobs, metavar="N", help="processes that draw (default: processors, at most 4)")


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..encoder import Encoder, ensure_ffmpeg
    from ..load import load

    result = load(options.result)
    ensure_ffmpeg()
    ensure_display()
    from dataclasses import replace

    from .. import film, page
    from ..scene import Scene
    from ..stage import MOVING, STILL

    orbit = options.camera == "orbit"
    rate = options.fps or (film.STATIC_RATE if result.is_static else film.MOTION_RATE)
    size = (options.size[0] & ~1, options.size[1] & ~1)  # H.264 halves the colours' resolution
    frames = film.chosen_frames(result, options.frames)
    shots = film.shots(result, frames, rate, options.speed, options.turns if orbit else 0.0)
    scale = common.scale_of(options, result, frames)
    quality = replace(MOVING, occlusion=options.fine, texture_filtering=STILL.texture_filtering if options.fine else 2)

    def painter() -> film.Painter:
        scene = Scene(result, frames, size, page.room(scale), scale, quality, all_round=orbit)
        return film.Painter(scene, result.title, scale, size)

    with Encoder(options.output, size, rate) as encoder:
        for picture in film.with_progress(
            film.paint_all(painter, shots, options.jobs or common.processors()), len(shots)
        ):
            encoder.add(picture)


def _positive(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = 0.0
    if not 0 < number < 1e6:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number above 0")
    return number


def _jobs(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 64:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of processes from 1 to 64")
    return int(text)


def _frames(text: str) -> tuple[int | None, int | None, int]:
    match = re.fullmatch(r"(-?\d+)?:(-?\d+)?(?::([1-9]\d*))?", text)
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not FIRST:END or FIRST:END:STEP, e.g. 0:100:2")
    first, last = (None if part is None else int(part) for part in match.groups()[:2])
    return first, last, int(match[3] or 1)
