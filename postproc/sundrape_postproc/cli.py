"""The command line: picture, filmstrip and strip of one result, drapes and crosscheck of a folder of them.

Heavy imports wait until arguments and file are known good.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import BAD_USE, FILE_TROUBLE, PostprocError

if TYPE_CHECKING:
    from .load import Result

NEEDED = "apt install python3-h5py python3-numpy python3-matplotlib python3-vtk9 xvfb xauth"


def main(arguments: Sequence[str] | None = None) -> int:
    """Exit status: 0 done, 2 bad command line or not a result file, 3 file trouble."""
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    options = _parser().parse_args(arguments)
    try:
        _check_output(options.output)
        _draw(options, arguments)
    except PostprocError as error:
        print(error, file=sys.stderr)
        return error.status
    except ImportError as error:
        print(f"{error.name or error} is missing for this python ({sys.executable}): {NEEDED}", file=sys.stderr)
        return FILE_TROUBLE
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="sundrape_postproc", description="Draw sundrape's result files.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name, size, what in (
        ("picture", (1500, 860), "the cloth in 3D beside its energies (or the residual of a static analysis)"),
        ("filmstrip", (1600, 400), "several frames in 3D, side by side, closer in time where the cloth moves faster"),
        ("strip", (1000, 700), "several frames of a motion in the plane x-z on top of each other"),
    ):
        command = commands.add_parser(name, help=what, description=f"Draw {what}.")
        command.add_argument("result", type=Path, metavar="RESULT.h5")
        command.add_argument("-o", "--output", type=Path, required=True, metavar="PICTURE.png")
        command.add_argument("--size", type=_size, default=size, metavar="WxH", help="in pixels (default %dx%d)" % size)
        if name == "picture":
            command.add_argument("--frame", type=int, metavar="K", help="0 is the first, -1 the last (default)")
        else:
            count = 5 if name == "filmstrip" else 9
            command.add_argument("--count", type=_count, default=count, metavar="N", help=f"frames (default {count})")
    for name, size, verb, what in (
        ("drapes", (1500, 900), "study", "every drape that a study found"),
        ("crosscheck", (1400, 640), "crosscheck", "where the methods of a crosscheck ended, and how far apart"),
    ):
        command = commands.add_parser(name, help=what, description=f"Draw {what}.")
        command.add_argument("folder", type=Path, metavar="FOLDER", help=f"what sundrape {verb} wrote")
        command.add_argument("-o", "--output", type=Path, required=True, metavar="PICTURE.png")
        command.add_argument("--size", type=_size, default=size, metavar="WxH", help="in pixels (default %dx%d)" % size)
    return parser


def _draw(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    if options.command == "drapes":
        _draw_drapes(options, arguments)
    elif options.command == "crosscheck":
        from . import crosscheck, page

        page.save(crosscheck.page(options.folder, crosscheck.read(options.folder), options.size), options.output)
    else:
        _draw_result(options, arguments)


def _draw_drapes(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from . import drapes, page

    title, found = drapes.read(options.folder)
    panel = drapes.grid(len(found), options.size)[2]
    from .display import ensure_display

    ensure_display(arguments)
    from .scene import Scene

    scenes = []
    for drape in found:
        frame = drape.result.last_frame
        scenes.append(Scene(drape.result, [frame], panel, drapes.CAPTION_ROOM).draw(frame))
    page.save(drapes.page(title, found, scenes, options.size), options.output)


def _draw_result(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from .load import load

    result = load(options.result)
    if options.command == "strip":
        from . import page, strip

        page.save(strip.strip(result, options.count, options.size), options.output)
        return

    frames = [_frame(options.frame, result)] if options.command == "picture" else result.telling_frames(options.count)
    from .display import ensure_display

    ensure_display(arguments)
    from . import page
    from .scene import Scene

    if options.command == "picture":
        scene = Scene(result, frames, page.scene_size(options.size), page.TITLE_ROOM)
        figure = page.picture(result, frames[0], scene.draw(frames[0]), options.size)
    else:
        scene = Scene(result, frames, page.panel_size(options.size, len(frames)), page.CAPTION_ROOM)
        figure = page.filmstrip(result, frames, [scene.draw(frame) for frame in frames], options.size)
    page.save(figure, options.output)


def _frame(wanted: int | None, result: Result) -> int:
    """A frame number counted from either end; the last drawable one by default."""
    count = len(result.time)
    if wanted is None:
        return result.last_frame
    if not -count <= wanted < count:
        raise PostprocError(f"--frame {wanted}: {result.path} has frames 0 to {count - 1}", BAD_USE)
    return wanted % count


def _check_output(path: Path) -> None:
    if path.suffix.lower() != ".png":
        raise PostprocError(f"{path}: the picture's name must end in .png", BAD_USE)
    if not path.resolve().parent.is_dir():
        raise PostprocError(f"{path}: no such directory: {path.parent}")


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    if match is None or not all(100 <= int(n) <= 8000 for n in match.groups()):
        raise argparse.ArgumentTypeError(f"{text!r} is not WIDTHxHEIGHT in pixels, each from 100 to 8000")
    return int(match[1]), int(match[2])


def _count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 50:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of frames from 1 to 50")
    return int(text)
