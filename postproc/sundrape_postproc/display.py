"""An X display for VTK, which before version 9.4 draws off screen only under X."""

from __future__ import annotations

import atexit
import ctypes
import os
import secrets
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from .errors import FILE_TROUBLE, PostprocError

NEEDED = "no display to draw on: `apt install xvfb` gives a virtual one"
PR_SET_PDEATHSIG = 1  # of Linux's prctl
ANY_DISPLAY = 0xFFFF  # an entry of an X authority file that holds for every display
PROTOCOL = b"MIT-MAGIC-COOKIE-1"


def ensure_display() -> None:
    """Where there is no display, start a virtual one, which ends with this process."""
    if os.environ.get("DISPLAY") or sys.platform != "linux":
        return
    server = shutil.which("Xvfb")
    if server is None:
        raise PostprocError(NEEDED, FILE_TROUBLE)
    folder = Path(tempfile.mkdtemp(prefix="sundrape-display-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    authority = folder / "authority"
    authority.write_bytes(_cookie())
    told, tell = os.pipe()
    subprocess.Popen(  # ends when we are dead, and not before: windows that are left open would go down with it
        [server, "-displayfd", str(tell), "-auth", str(authority), "-nolisten", "tcp", "-screen", "0", "1280x1024x24"],
        pass_fds=(tell,),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl-C is for us: a display that goes first takes us with it
        preexec_fn=_die_with_parent,  # not before: VTK's windows close last of all, and need it to
    )
    os.close(tell)
    with os.fdopen(told) as answer:
        number = answer.readline().strip()
    if not number:
        raise PostprocError(f"{server} does not start a display", FILE_TROUBLE)
    os.environ.update(DISPLAY=f":{number}", XAUTHORITY=str(authority))


def _cookie() -> bytes:
    """An X authority file with a secret of its own: nobody else draws on this display, or looks at it."""
    parts = (b"", b"", PROTOCOL, secrets.token_bytes(16))
    return struct.pack(">H", ANY_DISPLAY) + b"".join(struct.pack(">H", len(part)) + part for part in parts)


def _die_with_parent() -> None:
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
