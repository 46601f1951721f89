"""What the page plots: paths of the probes, energies, and the residual of a static analysis. F frames, S steps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .energies import GIVEN_AND_LOST, STORED, Look, method_dissipation
from .load import Probe, Result

ROWS = 2000  # of a probe's curve, at most
STORED_LOOKS = STORED | {"membrane": Look("membrane", "#56B4E9")}  # gravity, in the same list here, is the other blue
PROBE_LOOKS = (
    *(("#0072B2", ""), ("#D55E00", "6 2"), ("#009E73", "2 2"), ("#CC79A7", "8 2 2 2")),
    *(("#7a5230", "4 3"), ("#555555", "1 2")),
)  # colours of Okabe & Ito, dashes of SVG


def counts_frames(result: Result) -> bool:
    """Whether the slider runs over the numbers of the frames: the load goes up and down again, or time does not ascend."""
    return result.analysis == "arc-length" or not bool(np.all(np.diff(result.time) > 0))


def describe_probe(k: int, name: str, probe: Probe) -> dict[str, Any]:
    colour, dashes = PROBE_LOOKS[k % len(PROBE_LOOKS)]
    return {"name": name, "node": probe.node, "block": f"probe-{k}", "colour": colour, "dashes": dashes}


def probe_rows(result: Result, probe: Probe) -> np.ndarray:
    """Columns along the axis of the slider: its value, x, y, z (4, S); every so many steps where there are many."""
    if counts_frames(result):
        if probe.node is None:
            return np.zeros((4, 0))
        return np.concatenate([np.arange(len(result.time))[None], result.position[:, probe.node].T])
    rows = np.concatenate([probe.time[None], probe.position.T])
    rows = rows[:, np.isfinite(rows).all(axis=0)]
    if rows.shape[1] > ROWS:
        rows = rows[:, np.unique(np.rint(np.linspace(0, rows.shape[1] - 1, ROWS)).astype(int))]
    return rows


def diagrams(result: Result) -> list[dict[str, Any]]:
    """Curves over the frames: energies as the pictures have them, of a static analysis the residual too."""
    energies = {name: np.array(value, dtype=float) for name, value in result.energies.items()}
    if "gravity" in energies:
        energies["gravity"] -= energies["gravity"][0]  # its zero is arbitrary
    lost = method_dissipation(result)
    if lost is not None:
        energies["method_dissipated"] = lost
    drawn = []
    if not result.is_static:
        drawn.append(_diagram("Given and lost", "J", _curves(energies, GIVEN_AND_LOST)))
    drawn.append(_diagram("Stored in cloth and contact", "J", _curves(energies, STORED_LOOKS)))
    if result.is_static and result.residual is not None and np.any(result.residual > 0):
        look = Look("residual", "#0072B2")
        curve = [_curve(look, np.where(result.residual > 0, result.residual, np.nan))]
        drawn.append(_diagram("Out-of-balance over external force", "1", curve) | {"logarithmic": True})
    return [d for d in drawn if d["curves"]]


def _diagram(title: str, unit: str, curves: list[dict[str, Any]]) -> dict[str, Any]:
    return {"title": title, "unit": unit, "curves": curves, "logarithmic": False}


def _curves(energies: Mapping[str, np.ndarray], looks: Mapping[str, Look]) -> list[dict[str, Any]]:
    present = (name for name in looks if name in energies and np.any(np.nan_to_num(energies[name]) != 0))
    return [_curve(looks[name], energies[name]) for name in present]


def _curve(look: Look, values: np.ndarray) -> dict[str, Any]:
    dashes = "" if isinstance(look.dashes, str) else " ".join(f"{1.8 * part:.3g}" for part in look.dashes[1])
    return {"label": look.label, "colour": look.colour, "dashes": dashes, "values": plain(values)}


def plain(values: np.ndarray) -> list[float | None]:
    """Seven digits; None for what is no number."""
    return [float(f"{v:.7g}") if np.isfinite(v) else None for v in np.asarray(values, dtype=float)]
