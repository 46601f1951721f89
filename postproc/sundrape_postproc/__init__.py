"""Reads sundrape's result files and draws them.

`load` needs only h5py and numpy; VTK and matplotlib are imported when something is drawn.
"""

import contextlib

from .errors import PostprocError

with contextlib.suppress(ModuleNotFoundError):  # the command then names the packages to install, on one line
    from .load import Obstacle, Probe, Result, load

__all__ = ["Obstacle", "PostprocError", "Probe", "Result", "load"]
