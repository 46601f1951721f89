"""What a run says against itself: what its method lost, how deep cloth went into things, where it failed."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from .energies import RESERVOIRS, deepest_penetration, method_dissipation
from .load import Result
from .units import percent, quantity

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
PLACE = re.compile(rf"\(({NUMBER}), ({NUMBER}), ({NUMBER})\) m\b")
NODE = re.compile(r"\bnode (\d+)\b")
TIME = re.compile(rf"\bt = ({NUMBER})(?: s)?\b")


@dataclass(frozen=True)
class Failure:
    """Why a run did not get to its end, and where."""

    message: str
    frame: int  # the last good state
    time: float | None  # that the message names [s]
    places: tuple[tuple[str, np.ndarray], ...]  # (label, (3,) [m]) of what the message names


def failure(result: Result) -> Failure | None:
    """None of a run that is done."""
    if result.status == "done":
        return None
    message = result.message or {
        "running": "it is still running, or was killed",
        "interrupted": "it was interrupted",
    }.get(result.status, "it did not say why")
    named = TIME.search(message)
    frame = result.last_frame
    return Failure(message, frame, float(named[1]) if named else None, places(message, result.position[frame]))


def places(message: str, position: np.ndarray) -> tuple[tuple[str, np.ndarray], ...]:
    """Points "(x, y, z) m" of a message; of one without, its nodes' in the shape (N, 3) [m]."""
    points = [np.array([float(number) for number in match.groups()]) for match in PLACE.finditer(message)]
    nodes = [int(match[1]) for match in NODE.finditer(message)]
    if points:
        return tuple((f"node {nodes[k]}" if k < len(nodes) else "here", point) for k, point in enumerate(points))
    return tuple((f"node {node}", position[node]) for node in dict.fromkeys(nodes) if node < len(position))


def turned_over(result: Result) -> float | None:
    """Energy that changed its kind from frame to frame [J]: half the sum of all changes of all kinds, for each change
    is a loss of one and a gain of another. What swings to and fro between two frames is not seen. None: not known."""
    lost = method_dissipation(result)
    if lost is None or len(result.time) < 2:
        return None
    kinds = [result.energies[name] for name in (*RESERVOIRS, "dissipated", "external_work") if name in result.energies]
    finite = np.isfinite(np.stack([*kinds, lost])).all(axis=0)
    return float(sum(np.abs(np.diff(kind[finite])).sum() for kind in [*kinds, lost]) / 2)


def numbers(result: Result) -> list[tuple[str, str, str]]:
    """Rows (name, value, what it means) of what tells how far to trust a run."""
    rows: list[tuple[str, str, str]] = []
    lost, turned = method_dissipation(result), turned_over(result)
    if not result.is_static and lost is not None and turned:
        last = float(lost[np.flatnonzero(np.isfinite(lost))[-1]])
        amounts = f"{quantity(last, 'J')} of {quantity(turned, 'J')}"
        meaning = f"{amounts} that changed its kind from frame to frame; negative: gained"
        rows.append(("energy lost by the method", percent(last / turned), meaning))
    if result.is_static:
        residual = result.steps.get("residual", result.residual if result.residual is not None else np.zeros(0))
        if len(residual):
            tolerance = float(result.case.get(result.analysis, {}).get("tolerance", 1e-6))
            meaning = f"out-of-balance force over external force; tolerance {tolerance:g}"
            rows.append(("residual", f"{residual[-1]:.2g}", meaning))
        pivots = result.frames.get("negative_pivots")
        if pivots is not None and pivots[-1] >= 0:
            said = "stable" if pivots[-1] == 0 else f"unstable: {int(pivots[-1])} negative pivots"
            rows.append(("stability at the end", said, "by the signs of the tangent's pivots"))
    depth = deepest_penetration(result)
    if depth is not None:
        when = "at the end" if result.is_static else "at any time"
        meaning = f"into an obstacle, or of cloth into cloth, {when}"
        rows.append(("deepest penetration", quantity(depth, "m", 2) if depth > 0 else "none", meaning))
    strain = result.statistics.get("largest_edge_strain")
    if isinstance(strain, int | float):
        when = "at the end" if result.is_static else "over the frames"
        rows.append(("largest edge strain", percent(strain), f"of a segment of a thread, {when}"))
    crossings = result.frames.get("crossings")
    if crossings is not None and (crossings >= 0).any():
        worst = int(np.argmax(crossings))
        pairs = int(crossings[worst])
        meaning = "pairs of triangles of the cloth that intersect, the most of any frame"
        rows.append(("crossings", f"{pairs} (frame {worst})" if pairs else "none", meaning))
    return rows
