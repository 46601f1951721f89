"""A result as one page that shows itself: the built viewer (viewer.html) with the numbers of the result in it.

The page reads a JSON object, `describe`, and blocks of packed arrays, `blocks`, by their names. F frames, N nodes.
"""

from __future__ import annotations

import html
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from . import fields, shapes
from .coding import Quantised, pack_array, pack_series, quantise_field, quantise_positions
from .energies import facts
from .errors import PostprocError
from .load import Obstacle, Result
from .threads import thread_spacing
from .view_curves import counts_frames, describe_probe, diagrams, plain, probe_rows

TEMPLATE = Path(__file__).with_name("viewer.html")
TITLE_MARK, DATA_MARK = "<!-- sundrape: title -->", "<!-- sundrape: data -->"
NEGATIVE = 0.1  # of the upper end of the colours: values farther below zero are shown as such
ROBUST = 99.5  # per cent of all values of a field that its colours cover
STATIC_DURATION = 8.0  # of all frames of a static analysis at speed 1 [s]


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
        if largest - smallest > 1e-9 * max(abs(largest), abs(smallest)):
            low, high = _range(finite)
            shown.append(ShownField(field, low, high, smallest, largest, quantise_field(values, low, high)))
    return shown


def _range(values: np.ndarray) -> tuple[float, float]:
    """Of the colours: from zero, or from below where much is below, to what only the rarest values exceed."""
    low, high = (float(v) for v in np.percentile(values, [100 - ROBUST, ROBUST]))
    largest = float(values.max())
    high = max(high if high > 1e-6 * largest else largest, 0.0)
    low = low if low < -NEGATIVE * high else 0.0
    return (low, high) if high > low else (float(values.min()), high)


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
        packed[f"probe-{k}"] = pack_array(probe_rows(result, probe), "<f4")
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
        "probes": [describe_probe(k, name, p) for k, (name, p) in enumerate(result.probes.items())],
        "diagrams": diagrams(result),
    }


def _axis(result: Result) -> dict[str, Any]:
    """What the slider runs over: time, or the number of the frame where the load goes up and down again.

    `values` ascend; `perSecond` is how far they go in a second at speed 1; `labels` are what the clock shows.
    """
    time = np.asarray(result.time, dtype=float)
    counted = counts_frames(result)
    physical = not counted and not result.is_static
    values = np.arange(len(time), dtype=float) if counted else time
    is_load = result.analysis == "arc-length"
    return {
        "name": "frame" if counted else "time" if physical else "pseudo-time",
        "unit": "" if counted else "s",
        "labelName": "load factor" if is_load else "",
        "labels": plain(time) if is_load else None,
        "values": values.tolist(),
        "physical": physical,
        "perSecond": 1.0 if physical else max(float(values[-1] - values[0]), 1e-12) / STATIC_DURATION,
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


def _cividis() -> str:
    """256 colours, two hexadecimal digits a channel, one after the other."""
    from matplotlib import colormaps

    return (colormaps["cividis"](np.arange(256), bytes=True)[:, :3]).astype(np.uint8).tobytes().hex()
