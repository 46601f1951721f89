"""Where the lines on the cloth are drawn."""

from __future__ import annotations

import numpy as np


def thread_spacing(material: np.ndarray) -> float:
    """A round length [m], 1, 2 or 5 times a power of ten, near a twentieth of the cloth: (N, 2) coordinates [m]."""
    target = float(np.ptp(material, axis=0).max()) / 18
    decade = 10 ** np.floor(np.log10(target))
    return float(min((decade * m for m in (1, 2, 5, 10)), key=lambda length: abs(np.log(length / target))))
