"""A film of a result: its moments, drawn by one process or several, with title, time and legend on every picture."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np

from .colours import Scale, draw_legend
from .errors import BAD_USE, PostprocError
from .load import Result
from .moments import Moment, at_frame, evenly_in_time
from .page import DPI, STYLE, stage
from .scene import Scene
from .units import scale_for

MOST_PICTURES = 20_000
STATIC_RATE = 10.0  # pictures a second of an analysis without time: a picture is a frame
MOTION_RATE = 30.0


@dataclass(frozen=True)
class Shot:
    """One picture of the film."""

    moment: Moment
    angle: float  # of the camera, from where a picture has it [rad]
    caption: str


def chosen_frames(result: Result, slices: tuple[int | None, int | None, int] | None) -> list[int]:
    """Frames that Python's slice picks, as `sundrape export --frames` does; all of them without; only finite ones.

    Raises PostprocError, status 2: no such frames.
    """
    count = len(result.time)
    chosen = range(count)[slice(*(slices or (None, None, 1)))]
    if not chosen:
        raise PostprocError(f"--frames: picks none of the {count} frames of {result.path}", BAD_USE)
    frames = [k for k in chosen if k <= result.last_frame]
    if not frames:
        raise PostprocError(f"--frames: no frame of {result.path} there has finite positions", BAD_USE)
    return frames


def shots(result: Result, frames: Sequence[int], rate: float, speed: float, turns: float) -> list[Shot]:
    """`rate` pictures a second of a motion that runs at `speed` times its own; of an analysis without time, the frames.

    Raises PostprocError, status 2: more pictures than anybody wants.
    """
    if result.is_static:
        moments = [at_frame(k) for k in frames]
    else:
        length = float(result.time[frames[-1]] - result.time[frames[0]])
        if length * rate / speed > MOST_PICTURES:
            raise PostprocError(
                f"{length * rate / speed:.0f} pictures: more than {MOST_PICTURES}; raise --speed or choose --frames",
                BAD_USE,
            )
        moments = evenly_in_time(result, frames, speed / rate)
    captions = _captions(result, moments)
    return [Shot(m, 2 * np.pi * turns * k / len(moments), text) for k, (m, text) in enumerate(zip(moments, captions))]


def _captions(result: Result, moments: Sequence[Moment]) -> list[str]:
    if result.analysis == "arc-length":
        return [f"load factor {m.time(result):.3f}{stage(result, m.before)}" for m in moments]
    if not result.has_time:
        return [f"frame {m.before} of {len(result.time) - 1}" for m in moments]
    end = max(abs(float(m.time(result))) for m in moments)
    factor, prefix = scale_for(end)  # one unit and one number of digits: a text that jumps draws the eye
    digits = max(0, 3 - len(str(int(factor * end))))
    return [f"t = {factor * m.time(result):.{digits}f} {prefix}s" for m in moments]


class Painter:
    """Draws shots; made once a process."""

    def __init__(self, scene: Scene, title: str, scale: Scale | None, size: tuple[int, int]) -> None:
        self._scene, self._size = scene, size
        self._still = _overlay(size, lambda figure: _still_text(figure, title, scale, size))

    def paint(self, shot: Shot) -> np.ndarray:
        """(height, width, 3) of bytes, top row first."""
        picture = self._scene.draw_moment(shot.moment, self._scene.view.turned(shot.angle))
        picture = _laid_over(picture, self._still, 0)
        strip = max(24, round(0.045 * self._size[1]))  # only these rows change from picture to picture
        text = _overlay((self._size[0], strip), lambda figure: _caption(figure, shot.caption, self._size[1]))
        return _laid_over(picture, text, round(0.088 * self._size[1]))


def _still_text(figure: plt.Figure, title: str, scale: Scale | None, size: tuple[int, int]) -> None:
    text = 0.0135 * size[1]  # points at a hundred dots an inch or so: as large as the picture
    figure.text(0.022, 0.955, title, fontsize=1.6 * text, fontweight="bold", va="top")
    if scale is not None:
        draw_legend(figure, scale, (0.03, 0.058, 0.26, 0.018), text)


def _caption(figure: plt.Figure, text: str, height: int) -> None:
    figure.text(0.022, 0.5, text, fontsize=0.0165 * height, va="center")


def _overlay(size: tuple[int, int], draw: Callable[[plt.Figure], object]) -> np.ndarray:
    """What matplotlib draws, (height, width, 4) of bytes, on nothing."""
    with plt.rc_context(STYLE):
        figure = plt.figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI)
        figure.patch.set_alpha(0)
        try:
            draw(figure)
            figure.canvas.draw()
            return np.asarray(figure.canvas.buffer_rgba()).copy()
        finally:
            plt.close(figure)


def _laid_over(picture: np.ndarray, rgba: np.ndarray, top: int) -> np.ndarray:
    """`rgba` on the rows of the picture from `top` on; both (height, width, ·) of bytes."""
    rows, columns = np.flatnonzero(rgba[..., 3].any(axis=1)), np.flatnonzero(rgba[..., 3].any(axis=0))
    rows = rows[top + rows < len(picture)]
    if rows.size == 0:
        return picture
    inner = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    outer = np.s_[top + rows[0] : top + rows[-1] + 1, columns[0] : columns[-1] + 1]
    alpha = rgba[inner][..., 3:].astype(np.float32) / 255
    picture = picture.copy()
    picture[outer] = (alpha * rgba[inner][..., :3] + (1 - alpha) * picture[outer]).round().astype(np.uint8)
    return picture


def paint_all(make: Callable[[], Painter], shots: Sequence[Shot], jobs: int) -> Iterator[np.ndarray]:
    """The pictures in their order. `make` is called in every process that draws."""
    if jobs == 1 or len(shots) < 2:
        painter = make()
        yield from (painter.paint(shot) for shot in shots)
        return
    context = multiprocessing.get_context("fork")  # the result is shared, not sent
    with ProcessPoolExecutor(min(jobs, len(shots)), context, _begin, (make,)) as pool:
        waiting: deque[Future[np.ndarray]] = deque()
        try:
            for shot in shots:
                waiting.append(pool.submit(_paint, shot))
                if len(waiting) >= 2 * jobs:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        except BrokenProcessPool as trouble:
            raise PostprocError("a process that draws ended: try --jobs 1, or a smaller --size") from trouble
        finally:
            pool.shutdown(cancel_futures=True)


_painter: Painter | None = None


def _begin(make: Callable[[], Painter]) -> None:
    global _painter
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process that waits for us
    os.environ["LP_NUM_THREADS"] = "1"  # Mesa's software renderer: the processes are its threads already
    _painter = make()


def _paint(shot: Shot) -> np.ndarray:
    assert _painter is not None
    return _painter.paint(shot)


def with_progress(pictures: Iterable[np.ndarray], total: int) -> Iterator[np.ndarray]:
    """Says on a terminal how far it is."""
    for done, picture in enumerate(pictures, start=1):
        yield picture
        if sys.stderr.isatty():
            print(
                f"\r\033[Kpicture {done} of {total}",
                end="" if done < total else "\r\033[K",
                file=sys.stderr,
                flush=True,
            )
