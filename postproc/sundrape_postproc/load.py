"""Result files into plain arrays. F frames, N nodes, E quads, S accepted steps; SI units throughout."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from .errors import BAD_USE, PostprocError

HDF5_SIGNATURE = b"\x89HDF\r\n\x1a\n"
NODAL_SERIES = ("position", "velocity", "contact_force", "director", "energy_density")
FRAME_SERIES = (
    *("time", "load_factor", *NODAL_SERIES),
    *("stage", "residual", "negative_pivots", "penetration", "crossings", "contact_force_sum"),
)
FRAME_GROUPS = ("energy", "reaction", "reaction_moment", "obstacle_force", "element")
STATIC_ANALYSES = ("relaxation", "arc-length")


@dataclass(frozen=True)
class Obstacle:
    """A rigid body of the scene, given in its own frame and placed as x = position + rotation @ local."""

    kind: str  # plane | box | cylinder | sphere | capsule | disc | mesh
    parameters: Mapping[str, Any]  # SI: size, edge_radius, radius, length, axis, height, point, normal
    position: np.ndarray  # (3,) [m]
    rotation: np.ndarray  # (3, 3)
    surface: tuple[np.ndarray, np.ndarray] | None = None  # of a mesh: vertices (V, 3) [m], triangles (T, 3)
    path: tuple[np.ndarray, np.ndarray] | None = None  # if it moves: positions (F, 3) [m], rotations (F, 3, 3)

    def at(self, frame: int) -> Obstacle:
        """Where it stands at a frame."""
        if self.path is None:
            return self
        return replace(self, position=self.path[0][frame], rotation=self.path[1][frame], path=None)


@dataclass(frozen=True)
class Probe:
    """The path of one watched node, a row for every accepted step."""

    time: np.ndarray  # (S,) [s]
    position: np.ndarray  # (S, 3) [m]
    velocity: np.ndarray | None  # (S, 3) [m/s]
    load_factor: np.ndarray | None = None  # (S,), of an equilibrium path
    node: int | None = None  # which one it is; None in files that do not say


@dataclass(frozen=True)
class Result:
    """One result file, cut to the frames that all datasets have: after a kill some may be one frame ahead."""

    path: Path
    attributes: Mapping[str, Any]  # of the file: title, model, analysis, status, case, ...
    time: np.ndarray  # (F,) [s], or the load factor of an arc-length analysis [1]
    position: np.ndarray  # (F, N, 3) [m]
    reference: np.ndarray  # (N, 3) [m]
    material: np.ndarray | None  # (N, 2) warp, weft coordinates [m]
    quads: np.ndarray  # (E, 4) node indices
    energies: Mapping[str, np.ndarray]  # (F,) each [J]
    residual: np.ndarray | None  # (F,) |out-of-balance force| / |external force| [1]
    penetration: np.ndarray | None  # (F,) deepest, into an obstacle or of cloth into cloth [m]
    steps: Mapping[str, np.ndarray]  # (S,) each
    probes: Mapping[str, Probe]
    obstacles: Mapping[str, Obstacle]
    statistics: Mapping[str, Any]
    units: Mapping[str, str]  # by dataset, e.g. "frames/time" -> "s"
    case: Mapping[str, Any] = field(default_factory=dict)  # the TOML as run, parsed; empty if it cannot be
    velocity: np.ndarray | None = None  # (F, N, 3) [m/s]
    contact_force: np.ndarray | None = None  # (F, N, 3) on each node [N]
    director: np.ndarray | None = None  # (F, N, 3), of a shell
    energy_density: np.ndarray | None = None  # (F, N) stored elastic energy over area [J/m²]
    frames: Mapping[str, np.ndarray] = field(default_factory=dict)  # (F, ...) the rest: "crossings", "reaction/left", ...
    sets: Mapping[str, np.ndarray] = field(default_factory=dict)  # nodes of each named set
    warnings: tuple[str, ...] = ()
    critical: Mapping[str, np.ndarray] = field(default_factory=dict)  # (C, ...) limit points and bifurcations of a path

    @property
    def title(self) -> str:
        return str(self.attributes.get("title") or self.path.stem)

    @property
    def model(self) -> str:
        return str(self.attributes.get("model", "particle"))

    @property
    def analysis(self) -> str:
        return str(self.attributes.get("analysis", "dynamics"))

    @property
    def status(self) -> str:
        """running (also what a kill leaves behind) | done | failed | interrupted"""
        return str(self.attributes.get("status", "running"))

    @property
    def message(self) -> str:
        """Why it failed or stopped; empty otherwise."""
        return str(self.attributes.get("message") or "")

    @property
    def is_static(self) -> bool:
        return self.analysis in STATIC_ANALYSES

    @property
    def has_time(self) -> bool:
        """Whether the frames' time is that of a motion: not the pseudo-time of a relaxation, nor a load factor."""
        return not self.is_static or (self.analysis == "relaxation" and "equilibria" in self.statistics)

    @property
    def last_frame(self) -> int:
        """The last frame with finite positions: a run that blew up is drawn as it last was."""
        finite = np.flatnonzero(np.isfinite(self.position).all(axis=(1, 2)))
        if finite.size == 0:
            raise PostprocError(f"{self.path}: no frame has finite positions")
        return int(finite[-1])

    def telling_frames(self, count: int) -> list[int]:
        """At most `count` frames from the first to the last, the cloth moving about as far between any two of them."""
        shapes = self.position[: self.last_frame + 1]
        moved = np.sqrt(np.mean(np.sum(np.diff(shapes, axis=0) ** 2, axis=2), axis=1))  # rms over the nodes [m]
        way = np.concatenate([[0.0], np.cumsum(np.nan_to_num(moved))])
        marks = np.linspace(0, way[-1], count)
        chosen = {int(np.argmin(np.abs(way - mark))) for mark in marks}
        return sorted(chosen | ({self.last_frame} if count > 1 else set()))


def load(path: str | Path) -> Result:
    """Read a result file.

    Raises PostprocError: status 3 for a file that is missing or cannot be read, 2 for one that sundrape did not write.
    """
    path = Path(path)
    _check_signature(path)
    try:
        with h5py.File(path, "r") as file:
            return _read(file, path)
    except (OSError, RuntimeError, KeyError) as trouble:  # h5py raises all three on damaged files
        raise PostprocError(f"{path}: cannot be read: {_one_line(trouble)}") from trouble


def _check_signature(path: Path) -> None:
    try:
        with path.open("rb") as file:
            start = file.read(len(HDF5_SIGNATURE))
    except OSError as trouble:
        raise PostprocError(f"{path}: {trouble.strerror or trouble}") from trouble
    if start != HDF5_SIGNATURE:
        raise PostprocError(f"{path}: not a sundrape result: not an HDF5 file", BAD_USE)


def _read(file: h5py.File, path: Path) -> Result:
    attributes = _attributes(file)
    if attributes.get("format") != "sundrape":
        raise PostprocError(f'{path}: not a sundrape result: its attribute "format" is not "sundrape"', BAD_USE)
    for needed in ("mesh/reference", "mesh/quads", "frames/position"):
        if needed not in file:
            raise PostprocError(f"{path}: no dataset /{needed}: the run ended before its first frame")

    frames = file["frames"]
    series = {name: frames[name] for name in FRAME_SERIES if name in frames}
    for group in FRAME_GROUPS:
        series |= {f"{group}/{name}": item for name, item in _datasets(frames.get(group))}
    count = min(item.shape[0] for item in series.values())
    if count == 0:
        raise PostprocError(f"{path}: no complete frame: the run ended before its first one")
    cut = {name: item[:count] for name, item in series.items()}
    time = cut.get("time", cut.get("load_factor"))

    return Result(
        path=path,
        attributes=attributes,
        time=np.arange(count, dtype=float) if time is None else time,
        position=cut["position"],
        reference=file["mesh/reference"][()],
        material=file["mesh/material"][()] if "mesh/material" in file else None,
        quads=file["mesh/quads"][()].astype(np.int64),
        energies={name.removeprefix("energy/"): cut[name] for name in cut if name.startswith("energy/")},
        residual=cut.get("residual"),
        penetration=cut.get("penetration"),
        steps=_columns(file.get("steps")),
        probes={name: _probe(group) for name, group in _members(file.get("probes")) if "position" in group},
        obstacles={name: _obstacle(item, path, _path(frames, name, count)) for name, item in _members(file.get("obstacles"))},
        statistics=_attributes(file["statistics"]) if "statistics" in file else {},
        units=_units(file),
        case=_case(attributes),
        **{name: cut.get(name) for name in NODAL_SERIES if name != "position"},
        frames={name: cut[name] for name in cut if name not in NODAL_SERIES and not name.startswith("energy/")},
        sets={name: item[()].astype(np.int64) for name, item in _datasets(file["mesh"].get("sets"))},
        critical=_columns(file.get("critical")),
        warnings=tuple(_plain(text) for text in file["warnings"][()]) if "warnings" in file else (),
    )


def _columns(group: h5py.Group | None) -> dict[str, np.ndarray]:
    """Datasets that grow together, cut to the rows that all of them have."""
    columns = dict(_datasets(group))
    count = min((item.shape[0] for item in columns.values()), default=0)
    return {name: item[:count] for name, item in columns.items()}


def _probe(group: h5py.Group) -> Probe:
    columns = _columns(group)
    position = columns["position"]
    time = columns.get("time", np.arange(len(position), dtype=float))
    node = group.attrs.get("node")
    return Probe(time, position, columns.get("velocity"), columns.get("load_factor"), None if node is None else int(_plain(node)))


def _path(frames: h5py.Group, name: str, count: int) -> tuple[np.ndarray, np.ndarray] | None:
    """Positions and rotations of an obstacle that moves."""
    try:
        return frames[f"obstacle_position/{name}"][:count], frames[f"obstacle_rotation/{name}"][:count]
    except KeyError:
        return None


def _obstacle(
    item: h5py.Group | h5py.Dataset, path: Path, moves: tuple[np.ndarray, np.ndarray] | None
) -> Obstacle:
    attributes = _attributes(item)
    try:
        return Obstacle(
            kind=str(attributes["kind"]),
            parameters=_numbers(json.loads(attributes.get("parameters", "{}"))),
            position=np.asarray(attributes.get("position", np.zeros(3)), dtype=float).reshape(3),
            rotation=np.asarray(attributes.get("rotation", np.eye(3)), dtype=float).reshape(3, 3),
            surface=(item["vertices"][()], item["triangles"][()].astype(np.int64)) if "vertices" in item else None,
            path=moves,
        )
    except (KeyError, ValueError, AttributeError) as trouble:
        raise PostprocError(f"{path}: {item.name} is not a readable obstacle: {_one_line(trouble)}") from trouble


def _numbers(parameters: Mapping[str, Any]) -> dict[str, Any]:
    """The writer keeps every parameter as a list: lists of one become numbers."""
    return {name: v[0] if isinstance(v, list) and len(v) == 1 else v for name, v in parameters.items()}


def _case(attributes: Mapping[str, Any]) -> dict[str, Any]:
    try:
        return tomllib.loads(str(attributes.get("case", "")))
    except tomllib.TOMLDecodeError:
        return {}


def _units(file: h5py.File) -> dict[str, str]:
    units: dict[str, str] = {}

    def note(name: str, item: h5py.Group | h5py.Dataset) -> None:
        if isinstance(item, h5py.Dataset) and "units" in item.attrs:
            units[name] = str(_plain(item.attrs["units"]))

    file.visititems(note)
    return units


def _members(group: h5py.Group | None) -> list[tuple[str, Any]]:
    return [] if group is None else list(group.items())


def _datasets(group: h5py.Group | None) -> list[tuple[str, h5py.Dataset]]:
    return [(name, item) for name, item in _members(group) if isinstance(item, h5py.Dataset) and item.ndim > 0]


def _attributes(item: h5py.File | h5py.Group | h5py.Dataset) -> dict[str, Any]:
    return {name: _plain(value) for name, value in item.attrs.items()}


def _plain(value: Any) -> Any:
    """Fixed-length HDF5 strings come as bytes, one-element attributes as arrays."""
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.reshape(())[()]
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace").rstrip("\0")
    return value.item() if isinstance(value, np.generic) else value


def _one_line(trouble: BaseException) -> str:
    return " ".join(str(trouble).split())
