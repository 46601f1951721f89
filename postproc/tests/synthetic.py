"""Result files without a solver: a coarse explicit spring net falls on a box, written as the file format says.

The net is there to give the pictures something cloth-like to show; nothing is measured against it.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import h5py
import numpy as np

TABLE = {"table": {"kind": "box", "parameters": {"size": [0.08, 0.08, 0.08]}, "position": [0.0, 0.0, -0.04]}}

ENERGIES = ("kinetic", "membrane", "shear", "bending", "gravity", "contact", "dissipated", "external_work")

CASE = """title = "Tablecloth on a square table"
model = "particle"
analysis = "{analysis}"
[dynamics]
integrator = "cvode"
[relaxation]
tolerance = 1e-6
"""

EVERY_KIND: dict[str, dict[str, Any]] = {
    "floor": {"kind": "plane", "parameters": {"point": [0, 0, -0.2], "normal": [0, 0, 1]}},
    "wall": {"kind": "plane", "parameters": {"point": [0, 0.2, 0], "normal": [0, -1, 0]}},
    "box": {"kind": "box", "parameters": {"size": [0.06, 0.05, 0.04], "edge_radius": 0.004}, "position": [0, 0, -0.03]},
    "sharp": {"kind": "box", "parameters": {"size": [0.03, 0.03, 0.03]}, "position": [0.13, -0.12, -0.185]},
    "cylinder": {
        "kind": "cylinder",
        "parameters": {"radius": 0.02, "length": 0.08, "axis": [1, 0, 0], "edge_radius": 0.003},
        "position": [-0.12, -0.1, -0.18],
    },
    "sphere": {"kind": "sphere", "parameters": {"radius": 0.03}, "position": [0.15, 0.05, -0.17]},
    "capsule": {
        "kind": "capsule",
        "parameters": {"radius": 0.02, "length": 0.06, "axis": [0, 0, 1]},
        "position": [-0.16, 0.06, -0.15],
        "rotation": [1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8],
    },
    "disc": {"kind": "disc", "parameters": {"radius": 0.04, "height": 0.1}, "position": [0, 0, -0.1]},
}


@dataclass
class Motion:
    """What a run would have computed. F frames, N nodes."""

    reference: np.ndarray  # (N, 3) [m]
    quads: np.ndarray  # (E, 4)
    time: np.ndarray  # (F,) [s]
    position: np.ndarray  # (F, N, 3) [m]
    velocity: np.ndarray  # (F, N, 3) [m/s]
    energies: dict[str, np.ndarray] = field(default_factory=dict)  # (F,) each [J]


def square(size: float, cells: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (N, 3) [m] and quads (E, 4) of a flat square cloth in the plane z = 0, centred on the origin."""
    line = np.linspace(-size / 2, size / 2, cells + 1)
    y, x = np.meshgrid(line, line, indexing="ij")
    nodes = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    index = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    quads = np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1).reshape(-1, 4)
    return nodes, quads


def disc(radius: float, cells: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (N, 3) [m] and quads (E, 4) of a flat disc as the solver meshes it: a square core with bulging sides, and rings.

    `cells`: quads across the diameter, 3 or more.
    """
    rings = max(1, (cells + 3) // 6)
    n = cells - 2 * rings  # the core has n × n cells, a ring 4 n
    v, u = np.meshgrid(*2 * [np.linspace(-1, 1, n + 1)], indexing="ij")
    bulge = 0.3
    half = 0.79 * radius * n / cells
    x, y = (half * a * (1 - bulge + bulge * np.sqrt(2 - b * b)) for a, b in ((u, v), (v, u)))
    index = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    nodes = [np.stack([x.ravel(), y.ravel()], axis=1)]
    quads = [np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1).reshape(-1, 4)]
    border = np.concatenate([index[:-1, -1], index[-1, :0:-1], index[:0:-1, 0], index[0, :-1]])  # anticlockwise
    angle = np.pi / 4 * (2 * np.arange(4 * n) / n - 1)
    outer = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    inside = border
    for ring in range(1, rings + 1):
        nodes.append((1 - ring / rings) * nodes[0][border] + ring / rings * outer)
        outside = (n + 1) ** 2 + (ring - 1) * 4 * n + np.arange(4 * n)
        quads.append(np.stack([inside, outside, np.roll(outside, -1), np.roll(inside, -1)], axis=1))
        inside = outside
    plane = np.concatenate(nodes)
    return np.concatenate([plane, np.zeros((len(plane), 1))], axis=1), np.concatenate(quads)


def falling_tablecloth(cells: int = 20, frames: int = 60, duration: float = 1.0, step: float = 2e-4) -> Motion:
    """A 20 cm cloth over the 8 cm TABLE by semi-implicit Euler: 40 N/m threads, 0.2384 kg/m², strain-rate damping."""
    size = 0.2
    reference, quads = square(size, cells)
    index = np.arange(len(reference)).reshape(cells + 1, cells + 1)

    def pairs(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.stack([a.ravel(), b.ravel()], axis=1)

    threads = np.concatenate([pairs(index[:, :-1], index[:, 1:]), pairs(index[:-1], index[1:])])
    diagonals = np.concatenate([pairs(index[:-1, :-1], index[1:, 1:]), pairs(index[:-1, 1:], index[1:, :-1])])
    springs = np.concatenate([threads, diagonals])
    stiffness = np.concatenate([np.full(len(threads), 40.0), np.full(len(diagonals), 1.5)])
    rest = np.linalg.norm(reference[springs[:, 1]] - reference[springs[:, 0]], axis=1)
    triples = np.concatenate(
        [
            np.stack([index[:, :-2].ravel(), index[:, 1:-1].ravel(), index[:, 2:].ravel()], axis=1),
            np.stack([index[:-2].ravel(), index[1:-1].ravel(), index[2:].ravel()], axis=1),
        ]
    )
    bend = 0.06  # N/m on the second difference
    damping = 2.5e-4  # s
    g = 9.80665
    mass = np.full(len(reference), 0.2384 * size**2 / len(reference))
    x = reference + np.random.default_rng(1).uniform(-1, 1, reference.shape) * [0, 0, 2e-5]
    v = np.zeros_like(x)
    half, contact_stiffness = np.array([0.04, 0.04, 0.04]), 20.0
    dissipated = 0.0
    shape = (frames, *x.shape)
    motion = Motion(reference, quads, np.linspace(0, duration, frames), np.zeros(shape), np.zeros(shape))
    motion.energies = {name: np.zeros(frames) for name in ENERGIES}
    next_frame = 0
    for n in range(int(round(duration / step)) + 1):
        force = np.zeros_like(x)
        d = x[springs[:, 1]] - x[springs[:, 0]]
        length = np.linalg.norm(d, axis=1)
        direction = d / length[:, None]
        rate = np.sum(direction * (v[springs[:, 1]] - v[springs[:, 0]]), axis=1)
        tension = stiffness * (length - rest + damping * rate)
        for end, sign in ((0, 1.0), (1, -1.0)):
            for axis in range(3):
                force[:, axis] += sign * np.bincount(springs[:, end], tension * direction[:, axis], len(x))
        bow = x[triples[:, 0]] - 2 * x[triples[:, 1]] + x[triples[:, 2]]
        bow_rate = v[triples[:, 0]] - 2 * v[triples[:, 1]] + v[triples[:, 2]]
        pull = bend * (bow + 20 * damping * bow_rate)
        for corner, weight in ((0, -1.0), (1, 2.0), (2, -1.0)):
            for axis in range(3):
                force[:, axis] += weight * np.bincount(triples[:, corner], pull[:, axis], len(x))
        local = x - [0, 0, -0.04]
        depth = np.minimum((half - np.abs(local)).min(axis=1) + 3e-4, 1e-2)
        side = np.argmin(half - np.abs(local), axis=1)
        inside = depth > 0
        push = np.zeros_like(x)
        hit = np.flatnonzero(inside)
        push[hit, side[hit]] = contact_stiffness * depth[hit] * np.sign(local[hit, side[hit]])
        push -= 0.02 * inside[:, None] * v
        force += push
        power = np.sum(stiffness * damping * rate**2) + 20 * damping * bend * np.sum(bow_rate**2)
        dissipated += step * (power + 0.02 * np.sum(v[inside] ** 2))

        if next_frame < frames and n * step >= motion.time[next_frame] - step / 2:
            motion.position[next_frame], motion.velocity[next_frame] = x, v
            stretch = 0.5 * stiffness * (length - rest) ** 2
            row = {
                "kinetic": 0.5 * np.sum(mass[:, None] * v**2),
                "membrane": stretch[: len(threads)].sum(),
                "shear": stretch[len(threads) :].sum(),
                "bending": 0.5 * bend * np.sum(bow**2),
                "gravity": np.sum(mass * g * x[:, 2]),
                "contact": 0.5 * contact_stiffness * np.sum(depth[inside] ** 2),
                "dissipated": dissipated,
            }
            for name, value in row.items():
                motion.energies[name][next_frame] = value
            next_frame += 1
        v = v + step * (force / mass[:, None] + [0, 0, -g])
        x = x + step * v
    return motion


def bowl(cells: int = 6, frames: int = 4) -> Motion:
    """A cheap motion for the tests: a square that deepens into a bowl."""
    reference, quads = square(0.2, cells)
    time = np.linspace(0, 0.3, frames)
    depth = -4 * (time / 0.3)[:, None] * np.sum(reference[:, :2] ** 2, axis=1)
    position = np.repeat(reference[None], frames, axis=0)
    position[:, :, 2] = depth
    energies = {name: 1e-3 * (k + 1) * time for k, name in enumerate(ENERGIES)}
    return Motion(reference, quads, time, position, np.zeros_like(position), energies)


def swing(cells: int = 20, frames: int = 25) -> Motion:
    """A strip that hangs from one edge and falls from the horizontal as a bending pendulum, in the plane x–z."""
    length, width = 0.1, 0.02
    s = np.linspace(0, length, cells + 1)
    across = np.tile([-width / 2, width / 2], cells + 1)
    reference = np.stack([np.repeat(s, 2), across, np.zeros_like(across)], axis=1)
    row = 2 * np.arange(cells)
    quads = np.stack([row, row + 2, row + 3, row + 1], axis=1)
    time = np.linspace(0, 0.3, frames)
    angle = -2.4 * np.sin(np.pi / 2 * time / 0.3)[:, None] ** 2 * (1 + 0.5 * np.sin(np.pi * s / length))[None]
    ds = length / cells
    position = np.repeat(reference[None], frames, axis=0)
    middle = 0.5 * (angle[:, 1:] + angle[:, :-1])
    for axis, part in ((0, np.cos(middle)), (2, np.sin(middle))):
        line = np.concatenate([np.zeros((frames, 1)), np.cumsum(ds * part, axis=1)], axis=1)
        position[:, :, axis] = np.repeat(line, 2, axis=1)
    energies = {name: np.zeros(frames) for name in ENERGIES}
    return Motion(reference, quads, time, position, np.zeros_like(position), energies)


def waving(cells: int = 100, frames: int = 200) -> Motion:
    """A flag of 40 cm in the wind, held at the edge x = 0: waves of three lengths run along it; 2 s."""
    nodes, quads = square(0.4, cells)
    reference = nodes + [0.2, 0, 0]
    time = np.linspace(0, 2, frames)
    x, y = reference[:, 0], reference[:, 1]
    t = time[:, None]
    height = 0.0
    sway = 0.0
    for length, speed, size, lean in ((0.31, 0.9, 0.10, 2.0), (0.13, 0.6, 0.035, -3.1), (0.057, 0.4, 0.012, 5.3)):
        phase = 2 * np.pi * (x - speed * t) / length + lean * y / 0.4
        height = height + size * x * np.sin(phase)
        sway = sway + 0.4 * size * x * np.cos(0.7 * phase + 1)
    position = np.stack([np.broadcast_to(x - 0.1 * x * x, height.shape), y + sway, height], axis=2)
    velocity = np.gradient(position, time, axis=0)
    energies = {name: np.sum(velocity**2, axis=(1, 2)) * 1e-6 * (k + 1) for k, name in enumerate(ENERGIES)}
    return Motion(reference, quads, time, position, velocity, energies)


def write_result(
    path: Path,
    motion: Motion,
    obstacles: dict[str, dict[str, Any]] | None = None,
    analysis: str = "dynamics",
    status: str = "done",
    title: str = "Tablecloth on a square table",
) -> Path:
    """Write `motion` as a result file."""
    with h5py.File(path, "w") as file:
        file.attrs.update(format="sundrape", format_version=1, sundrape_version="0.1.0", title=title, model="particle")
        file.attrs.update(analysis=analysis, status=status, case=CASE.format(analysis=analysis))

        def put(name: str, data: np.ndarray, units: str, description: str) -> None:
            file.create_dataset(name, data=data, maxshape=(None, *data.shape[1:]))
            file[name].attrs.update(units=units, description=description)

        put("mesh/reference", motion.reference, "m", "nodes at rest")
        put("mesh/material", motion.reference[:, :2], "m", "warp and weft coordinates")
        put("mesh/quads", motion.quads.astype(np.int32), "1", "node indices of each face")
        put("frames/time", motion.time, "s", "time of each frame")
        put("frames/position", motion.position, "m", "node positions")
        put("frames/velocity", motion.velocity, "m/s", "node velocities")
        for name, value in motion.energies.items():
            put(f"frames/energy/{name}", value, "J", f"{name} energy")
        put("frames/penetration", np.full(len(motion.time), 3.1e-5), "m", "deepest penetration into an obstacle")
        accepted = np.linspace(motion.time[0], motion.time[-1], 488)
        put("steps/time", accepted, "s", "time after each accepted step")
        put("steps/step_size", np.full(488, 2e-3), "s", "size of each accepted step")
        put("steps/order", np.full(488, 2), "1", "order of the formula")
        if analysis == "relaxation":
            k = np.arange(488) / 488
            residual = np.where(k < 0.9, 10 ** (-2.5 * k + 0.4 * np.sin(60 * k)), 10 ** (-2.4 - 45 * (k - 0.9)))
            put("steps/residual", residual, "1", "out-of-balance force over external force")
            per_frame = np.geomspace(1, 1e-7, len(motion.time))
            put("frames/residual", per_frame, "1", "out-of-balance force over external force")
        tip = motion.position[:, -1]
        put("probes/tip/time", motion.time, "s", "time after each accepted step")
        put("probes/tip/position", tip, "m", "position of the node")
        for name, obstacle in (obstacles or {}).items():
            group = file.create_group(f"obstacles/{name}")
            group.attrs["kind"] = obstacle["kind"]
            parameters = {key: np.atleast_1d(value).tolist() for key, value in obstacle["parameters"].items()}
            group.attrs["parameters"] = json.dumps(parameters)  # numbers too are lists, of one
            group.attrs["position"] = np.asarray(obstacle.get("position", [0, 0, 0]), dtype=float)
            group.attrs["rotation"] = np.asarray(obstacle.get("rotation", np.eye(3).ravel()), dtype=float)
        statistics = file.create_group("statistics")
        statistics.attrs.update(steps=488, newton_iterations=1063, integrator="cvode")
    return path
