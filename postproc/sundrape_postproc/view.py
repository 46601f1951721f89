"""A result as one page that shows itself: the built viewer (viewer.html) with the numbers of the result in it.

The page reads a JSON object, `describe`, and blocks of packed arrays, `blocks`, by their names. F frames, N nodes.
"""

from __future__ import annotations

import html
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from . import fields, shapes
from .coding import Quantised, pack_array, pack_series, quantise_field, quantise_positions
from .energies import GIVEN_AND_LOST, STORED, Look, facts, method_dissipation
from .errors import PostprocError
from .load import Obstacle, Probe, Result
from .threads import thread_spacing

TEMPLATE = Path(__file__).with_name("viewer.html")
TITLE_MARK, DATA_MARK = "<!-- sundrape: title -->", "<!-- sundrape: data -->"
NEGATIVE = 0.1  # of the upper end of the colours: values farther below zero are shown as such
ROBUST = 99.5  # per cent of all values of a field that its colours cover
ROWS = 2000  # of a probe's curve, at most
STATIC_DURATION = 8.0  # of all frames of a static analysis at speed 1 [s]
STORED_LOOKS = STORED | {"membrane": Look("membrane", "#56B4E9")}  # gravity, in the same list here, is the other blue
PROBE_LOOKS = (
    *(("#0072B2", ""), ("#D55E00", "6 2"), ("#009E73", "2 2"), ("#CC79A7", "8 2 2 2")),
    *(("#7a5230", "4 3"), ("#555555", "1 2")),
)  # colours of Okabe & Ito, dashes of SVG


@dataclass(frozen=True)
class ShownField:
    """A field ready for the page."""

    field: fields.Field
    low: float  # of the colours, SI
    high: float
    smallest: float  # of all values
    largest: float
    quantised: Quantised  # (F, N)

    @property
    def cut_below(self) -> bool:
        return self.smallest < self.low - self.quantised.quantum / 2

    @property
    def cut_above(self) -> bool:
        return self.largest > self.high + self.quantised.quantum / 2


def write(result: Result, output: Path, most_frames: int | None = None) -> None:
    """Write the page of a result. `most_frames`: leave out some, evenly, if there are more.

    Raises PostprocError: the viewer is not built, the result has nothing finite to show, the file cannot be written.
    """
    text = page(result, most_frames)
    try:
        output.write_text(text, encoding="utf-8")
    except OSError as trouble:
        raise PostprocError(f"{output}: {trouble.strerror or trouble}") from trouble


def page(result: Result, most_frames: int | None = None) -> str:
    """The text of the page."""
    try:
        template = TEMPLATE.read_text(encoding="utf-8")
    except FileNotFoundError as trouble:
        raise PostprocError("the viewer is not built yet: run `./dev viewer` once, in sundrape's folder") from trouble
    whole = len(result.time)
    result = shown_frames(result, most_frames)
    shown = shown_fields(result)
    about = describe(result, shown) | {"framesInFile": whole}
    data = json.dumps(about, ensure_ascii=False, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    parts = [f'<script type="application/json" id="about">{data}</script>']
    parts += [f'<script type="text/plain" id="{name}">{text}</script>' for name, text in blocks(result, shown).items()]
    return template.replace(TITLE_MARK, html.escape(result.title), 1).replace(DATA_MARK, "\n".join(parts), 1)


def shown_frames(result: Result, most: int | None) -> Result:
    """The result with its finite frames only, at most `most` of them, the first and the last included."""
    last = result.last_frame  # raises if none is finite
    finite = np.flatnonzero(np.isfinite(result.position[: last + 1]).all(axis=(1, 2)))
    if most is not None and finite.size > most:
        finite = finite[np.rint(np.linspace(0, finite.size - 1, most)).astype(int)]
    if finite.size == len(result.time):
        return result

    def cut(series: np.ndarray | None) -> np.ndarray | None:
        return None if series is None else series[finite]

    nodal = {name: cut(getattr(result, name)) for name in ("velocity", "contact_force", "director", "energy_density")}
    obstacles = {
        name: o if o.path is None else replace(o, path=(o.path[0][finite], o.path[1][finite]))
        for name, o in result.obstacles.items()
    }
    return replace(
        result,
        time=result.time[finite],
        position=result.position[finite],
        energies={name: value[finite] for name, value in result.energies.items()},
        residual=cut(result.residual),
        penetration=cut(result.penetration),
        obstacles=obstacles,
        frames={name: value[finite] for name, value in result.frames.items()},
        **nodal,
    )


def shown_fields(result: Result) -> list[ShownField]:
    """The fields that the result has and that are not the same everywhere, with the range of their colours."""
    shown = []
    for field in fields.available(result):
        values = np.stack([fields.values(result, field.name, k) for k in range(len(result.time))])
        finite = values[np.isfinite(values)]
        if finite.size == 0:
            continue
        smallest, largest = float(finite.min()), float(finite.max())
        low, high = np.percentile(finite, [100 - ROBUST, ROBUST])
        high = float(high) if high > 1e-6 * largest else largest
        low = float(low) if low < -NEGATIVE * high else 0.0  # a little below zero is zero: the colours begin there
        if high - low > 1e-12 * max(abs(high), abs(low), 1e-300) and largest - smallest > 1e-9 * max(abs(largest), 1e-6):
            shown.append(ShownField(field, low, high, smallest, largest, quantise_field(values, low, high)))
    return shown


def blocks(result: Result, shown: Sequence[ShownField]) -> dict[str, str]:
    """Packed arrays by the name of their element in the page."""
    packed = {
        "positions": pack_series(quantise_positions(result.position).codes.transpose(0, 2, 1)),
        "quads": pack_array(result.quads, "<u4"),
    }
    if result.material is not None:
        packed["threads"] = pack_array(result.material / thread_spacing(result.material), "<f4")
    for item in shown:
        packed[f"field-{item.field.name}"] = pack_series(item.quantised.codes[:, None])
    for k, obstacle in enumerate(result.obstacles.values()):
        if obstacle.kind != "plane":
            packed |= {f"body-{k}-{name}": text for name, text in _body(obstacle).items()}
        if obstacle.path is not None:
            places = np.concatenate([obstacle.path[0], obstacle.path[1].reshape(-1, 9)], axis=1)
            packed[f"body-{k}-path"] = pack_array(places, "<f4")
    for k, probe in enumerate(result.probes.values()):
        packed[f"probe-{k}"] = pack_array(_probe_rows(result, probe), "<f4")
    return packed


def describe(result: Result, shown: Sequence[ShownField]) -> dict[str, Any]:
    """What the page is told besides the blocks: plain numbers and texts, SI."""
    places = quantise_positions(result.position)
    return {
        "title": result.title,
        "file": result.path.name,
        "model": result.model,
        "analysis": result.analysis,
        "status": result.status,
        "message": result.message,
        "warnings": list(result.warnings),
        "facts": [list(row) for row in facts(result)],
        "nodes": result.position.shape[1],
        "quads": len(result.quads),
        "frames": len(result.time),
        "axis": _axis(result),
        "low": places.low.tolist(),
        "quantum": places.quantum,
        "threadSpacing": None if result.material is None else thread_spacing(result.material),
        "colours": _cividis(),
        "fields": [_field(item) for item in shown],
        "obstacles": [_obstacle(k, name, o) for k, (name, o) in enumerate(result.obstacles.items())],
        "probes": [_probe(k, name, p) for k, (name, p) in enumerate(result.probes.items())],
        "diagrams": _diagrams(result),
    }


def _axis(result: Result) -> dict[str, Any]:
    """What the slider runs over: time, or the number of the frame where the load goes up and down again.

    `values` ascend; `perSecond` is how far they go in a second at speed 1; `labels` are what the clock shows.
    """
    time = np.asarray(result.time, dtype=float)
    ascends = bool(np.all(np.diff(time) > 0))
    physical = ascends and not result.is_static
    values = time if ascends and result.analysis != "arc-length" else np.arange(len(time), dtype=float)
    span = max(float(values[-1] - values[0]), 1e-12)
    is_load = result.analysis == "arc-length"
    return {
        "name": ("time" if physical else "pseudo-time") if ascends and not is_load else "frame",
        "unit": "s" if ascends and not is_load else "",
        "labelName": "load factor" if is_load else "",
        "labels": _plain(time) if is_load else None,
        "values": values.tolist(),
        "physical": physical,
        "perSecond": 1.0 if physical else span / STATIC_DURATION,
    }


def _field(item: ShownField) -> dict[str, Any]:
    return {
        "name": item.field.name,
        "label": item.field.label,
        "unit": item.field.unit,
        "low": item.low,
        "high": item.high,
        "cutBelow": item.cut_below,
        "cutAbove": item.cut_above,
        "largest": item.largest,
    }


def _obstacle(k: int, name: str, obstacle: Obstacle) -> dict[str, Any]:
    local = replace(obstacle, position=np.zeros(3), rotation=np.eye(3), path=None)
    plane = shapes.plane(local) if obstacle.kind == "plane" else None
    return {
        "name": name,
        "kind": obstacle.kind,
        "position": obstacle.position.tolist(),
        "rotation": obstacle.rotation.ravel().tolist(),
        "block": f"body-{k}",
        "moves": obstacle.path is not None,
        "point": None if plane is None else plane[0].tolist(),
        "normal": None if plane is None else plane[1].tolist(),
    }


def _body(obstacle: Obstacle) -> dict[str, str]:
    """Vertices, normals and triangles of a bounded obstacle in its own frame, corners alike shared."""
    points, faces = shapes.surface(obstacle)
    normals = np.round(shapes.corner_normals(points, faces), 3)
    corners = np.concatenate([faces.reshape(-1, 1), normals.reshape(-1, 3)], axis=1)
    shared, index = np.unique(corners, axis=0, return_inverse=True)
    index = index.reshape(faces.shape)
    fans = [index[:, [0, k, k + 1]] for k in range(1, faces.shape[1] - 1)]
    return {
        "points": pack_array(points[shared[:, 0].astype(int)], "<f4"),
        "normals": pack_array(shared[:, 1:], "<f4"),
        "triangles": pack_array(np.concatenate(fans), "<u4"),
    }


def _probe(k: int, name: str, probe: Probe) -> dict[str, Any]:
    colour, dashes = PROBE_LOOKS[k % len(PROBE_LOOKS)]
    return {"name": name, "node": probe.node, "block": f"probe-{k}", "colour": colour, "dashes": dashes}


def _probe_rows(result: Result, probe: Probe) -> np.ndarray:
    """Columns along the axis of the slider: its value, x, y, z (4, S); every so many steps where there are many."""
    if result.analysis == "arc-length":
        if probe.node is None:
            return np.zeros((4, 0))
        return np.concatenate([np.arange(len(result.time))[None], result.position[:, probe.node].T])
    rows = np.concatenate([probe.time[None], probe.position.T])
    rows = rows[:, np.isfinite(rows).all(axis=0)]
    if rows.shape[1] > ROWS:
        rows = rows[:, np.unique(np.rint(np.linspace(0, rows.shape[1] - 1, ROWS)).astype(int))]
    return rows


def _diagrams(result: Result) -> list[dict[str, Any]]:
    """Curves over the frames: energies as the pictures have them, of a static analysis the residual too."""
    energies = {name: np.array(value, dtype=float) for name, value in result.energies.items()}
    if "gravity" in energies:
        energies["gravity"] -= energies["gravity"][0]  # its zero is arbitrary
    lost = method_dissipation(result)
    if lost is not None:
        energies["method_dissipated"] = lost
    diagrams = []
    if not result.is_static:
        diagrams.append(_diagram("Given and lost", "J", _curves(energies, GIVEN_AND_LOST)))
    diagrams.append(_diagram("Stored in cloth and contact", "J", _curves(energies, STORED_LOOKS)))
    if result.is_static and result.residual is not None and np.any(result.residual > 0):
        look = Look("residual", "#0072B2")
        curve = [_curve(look, np.where(result.residual > 0, result.residual, np.nan))]
        diagrams.append(_diagram("Out-of-balance over external force", "1", curve) | {"logarithmic": True})
    return [d for d in diagrams if d["curves"]]


def _diagram(title: str, unit: str, curves: list[dict[str, Any]]) -> dict[str, Any]:
    return {"title": title, "unit": unit, "curves": curves, "logarithmic": False}


def _curves(energies: Mapping[str, np.ndarray], looks: Mapping[str, Look]) -> list[dict[str, Any]]:
    present = (name for name in looks if name in energies and np.any(np.nan_to_num(energies[name]) != 0))
    return [_curve(looks[name], energies[name]) for name in present]


def _curve(look: Look, values: np.ndarray) -> dict[str, Any]:
    dashes = "" if isinstance(look.dashes, str) else " ".join(f"{1.8 * part:.3g}" for part in look.dashes[1])
    return {"label": look.label, "colour": look.colour, "dashes": dashes, "values": _plain(values)}


def _plain(values: np.ndarray) -> list[float | None]:
    """Seven digits; None for what is no number."""
    return [float(f"{v:.7g}") if np.isfinite(v) else None for v in np.asarray(values, dtype=float)]


def _cividis() -> str:
    """256 colours, two hexadecimal digits a channel, one after the other."""
    from matplotlib import colormaps

    return (colormaps["cividis"](np.arange(256), bytes=True)[:, :3]).astype(np.uint8).tobytes().hex()
