"""Pictures into a film by ffmpeg, through a pipe: none of them touches the disk, and a film is whole or not there."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path
from types import TracebackType
from typing import IO

import numpy as np

from .errors import BAD_USE, FILE_TROUBLE, PostprocError

KINDS = (".mp4", ".gif")
GIF_FASTEST = 50  # pictures a second: browsers slow down what is faster
NEEDED = "ffmpeg is missing: apt install ffmpeg"
H264 = ("-c:v", "libx264", "-preset", "medium", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart")
LOSSLESS = ("-c:v", "ffv1", "-pix_fmt", "bgr0")  # between the two passes that a palette needs
COLOURS = "bt709"  # said in the file, and used: players guess otherwise, and shades shift


def ensure_ffmpeg() -> str:
    """Raises PostprocError, status 3, if it is not installed."""
    found = shutil.which("ffmpeg")
    if found is None:
        raise PostprocError(NEEDED, FILE_TROUBLE)
    return found


class Encoder:
    """`with Encoder(...) as film: film.add(picture)`: leaves the film if all went well, nothing if not."""

    def __init__(self, path: Path, size: tuple[int, int], rate: float) -> None:
        """`size`: pixels across and down, even for H.264; `rate`: pictures a second."""
        self._path, self._size, self._rate = path, size, rate
        self._gif = path.suffix.lower() == ".gif"
        if self._gif and rate > GIF_FASTEST:
            raise PostprocError(f"--fps {rate:g}: a GIF has at most {GIF_FASTEST} pictures a second", BAD_USE)

    def __enter__(self) -> Encoder:
        program = ensure_ffmpeg()
        try:
            self._folder = Path(tempfile.mkdtemp(prefix=f".{self._path.name}-", dir=self._path.resolve().parent))
        except OSError as trouble:
            raise PostprocError(f"{self._path}: cannot be written: {trouble.strerror or trouble}") from trouble
        self._begin = [program, "-hide_banner", "-loglevel", "error", "-nostdin", "-y"]
        self._made = self._folder / ("all.mkv" if self._gif else "film.mp4")
        size = "x".join(map(str, self._size))
        pipe = [
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgb24",
            "-video_size",
            size,
            "-framerate",
            f"{self._rate:.12g}",
            "-i",
            "pipe:0",
        ]
        matrix = ["-vf", f"scale=out_color_matrix={COLOURS}:out_range=tv"]
        tags = [part for key in ("colorspace", "color_primaries", "color_trc") for part in (f"-{key}", COLOURS)]
        how = [*LOSSLESS] if self._gif else [*matrix, *H264, *tags]
        self._said: IO[bytes] = (self._folder / "said").open("w+b")
        self._process = subprocess.Popen(
            [*self._begin, *pipe, *how, str(self._made)],
            stdin=subprocess.PIPE,
            stderr=self._said,
            preexec_fn=_deaf,  # Ctrl-C is for us: we end it
        )
        return self

    def add(self, picture: np.ndarray) -> None:
        """(height, width, 3) of bytes."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(np.ascontiguousarray(picture).data)
        except BrokenPipeError:
            self._process.wait()
            raise self._failed() from None

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            if kind is None:
                self._process.communicate()
                if self._process.returncode != 0:
                    raise self._failed()
                os.replace(self._with_palette() if self._gif else self._made, self._path)
        except OSError as trouble:
            raise PostprocError(f"{self._path}: cannot be written: {trouble.strerror or trouble}") from trouble
        finally:
            if self._process.poll() is None:
                self._process.kill()
                self._process.wait()
            self._said.close()
            shutil.rmtree(self._folder, ignore_errors=True)

    def _with_palette(self) -> Path:
        """The best 256 colours of the whole film: two passes, so that no film has to fit into memory."""
        palette, made = self._folder / "palette.png", self._folder / "film.gif"
        self._run("-i", str(self._made), "-vf", "palettegen=stats_mode=full", str(palette))
        use = "paletteuse=dither=sierra2_4a:diff_mode=rectangle"
        self._run("-i", str(self._made), "-i", str(palette), "-lavfi", use, "-loop", "0", str(made))
        return made

    def _run(self, *arguments: str) -> None:
        if subprocess.run([*self._begin, *arguments], stderr=self._said).returncode != 0:
            raise self._failed()

    def _failed(self) -> PostprocError:
        self._said.seek(0)
        last = self._said.read().decode("utf-8", "replace").strip().splitlines()
        return PostprocError(f"{self._path}: ffmpeg failed: {last[-1] if last else 'it did not say why'}")


def _deaf() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
