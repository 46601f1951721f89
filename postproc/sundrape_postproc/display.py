"""An X display for VTK, which before version 9.4 draws off screen only under X."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Sequence

from .errors import FILE_TROUBLE, PostprocError

GUARD = "SUNDRAPE_POSTPROC_UNDER_XVFB"


def ensure_display(arguments: Sequence[str]) -> None:
    """Where there is no display, run this very command again under a virtual one; does not return then."""
    if os.environ.get("DISPLAY") or sys.platform != "linux":
        return
    xvfb = shutil.which("xvfb-run")
    if xvfb is None or GUARD in os.environ:
        raise PostprocError("no display to draw on: `apt install xvfb xauth` gives a virtual one", FILE_TROUBLE)
    os.environ[GUARD] = "1"
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [here, os.environ.get("PYTHONPATH")]))
    sys.stdout.flush()
    sys.stderr.flush()
    screen = "-screen 0 1280x1024x24"
    os.execv(xvfb, [xvfb, "-a", "-s", screen, sys.executable, "-m", "sundrape_postproc", *arguments])
