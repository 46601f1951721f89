"""What a drape tester measures: the cloth's shadow, its drape coefficient and its folds. numpy and shapely; SI units.

A round specimen lies on a smaller round support, and what overhangs hangs down. With parallel light along gravity,

    drape coefficient = (shadow - support) / (specimen - support)        of the three areas

(ISO 9073-9; G. E. Cusick, Journal of the Textile Institute 59, 1968) is 1 of a board and 0 of a cloth that hangs straight down. The shadow is that of the smooth surface through the nodes, as
pictures have it: chords between the rim's nodes would take up to a per cent off every area.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from shapely.geometry import MultiPolygon, Point, Polygon
from shapely.ops import polygonize, unary_union

from .errors import BAD_USE, PostprocError
from .load import Obstacle, Result
from .surface import SmoothSurface

DIRECTIONS = 720  # of the polar profile, half a degree apart
SMOOTHING = np.radians(2.0)  # standard deviation of the Gaussian that folds are counted after
LEAST_PROMINENCE = 0.05  # of a fold, over the mean overhang
ROUND = 1e-3  # a specimen whose rim keeps to its radius as closely as that is a disc
UPRIGHT = np.cos(np.radians(5.0))  # a support's axis leans by less
CIRCLE_SIDES = 4 * DIRECTIONS  # of the polygon that stands for the support; its area is 1e-6 too small
SLIVER = 1e-9  # triangles smaller than this part of the specimen, over their number, are faces seen edge on


@dataclass(frozen=True)
class Support:
    """The round plate that carries the specimen."""

    radius: float  # [m]
    centre: np.ndarray  # (3,) a point of its axis [m]


@dataclass(frozen=True)
class View:
    """Orthogonal axes of the shadow's plane: looking along `down`, `right` and `up` span what is seen."""

    down: np.ndarray  # (3,) unit
    right: np.ndarray  # (3,)
    up: np.ndarray  # (3,)

    def project(self, points: np.ndarray) -> np.ndarray:
        """(..., 3) -> (..., 2)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


@dataclass(frozen=True)
class Folds:
    """Maxima and minima of a polar profile that stand out."""

    peaks: np.ndarray  # (n,) indices of the profile, ascending
    valleys: np.ndarray  # (n,) the lowest place after each peak
    smooth: np.ndarray  # (D,) the profile that they were counted on [m]


@dataclass(frozen=True)
class Drape:
    """One test. Lengths in m, areas in m², angles in rad counted from the view's right; D = DIRECTIONS."""

    label: str
    source: str  # the result file
    status: str  # of the run: done | failed | ...
    frame: int
    is_last: bool  # whether it is the run's last frame
    coefficient: float  # [1]
    specimen_area: float
    specimen_radius: float  # of the circle of that area
    is_disc: bool
    support_area: float
    support_radius: float
    shadow_area: float
    outline: np.ndarray  # (P, 2) the shadow's edge about the support's axis, closed
    angle: np.ndarray  # (D,)
    radius: np.ndarray  # (D,) of the outermost point of the shadow in each direction
    folds: Folds
    harmonic: int  # of the largest Fourier coefficient of `radius` from the second on; 0 where no wave is a fold's height
    harmonic_amplitude: float  # half the difference of that wave's crest and trough
    asymmetry: float | None  # see `irregularity`
    offset: float  # of the shadow's centroid from the axis
    crossings: int | None  # pairs of triangles of the cloth that intersect

    @property
    def mean_radius(self) -> float:
        return float(self.radius.mean())

    @property
    def fold_count(self) -> int:
        return len(self.folds.peaks)

    @property
    def fold_depth(self) -> float:
        """Mean radius at the crests of folds less that at the troughs between them."""
        if self.fold_count == 0:
            return 0.0
        return float(self.folds.smooth[self.folds.peaks].mean() - self.folds.smooth[self.folds.valleys].mean())


def measure(result: Result, frame: int, support_radius: float | None = None, label: str | None = None) -> Drape:
    """The drape test at one frame of a result.

    `support_radius` [m] takes the place of the result's own support. Raises PostprocError, status 2: no support, or a
    specimen that is not larger than it.
    """
    view = view_along(gravity(result))
    support = _support(result, frame, view, support_radius)
    specimen_area, is_disc = specimen(result)
    support_area = np.pi * support.radius**2
    if specimen_area <= support_area:
        text = f"{result.path}: the specimen, {1e4 * specimen_area:.4g} cm², is no larger than the support, "
        raise PostprocError(text + f"{1e4 * support_area:.4g} cm²", BAD_USE)

    surface = SmoothSurface(result.quads, len(result.reference))
    centre = view.project(support.centre)
    points = view.project(surface.points(result.position[frame])) - centre
    plate = Point(0, 0).buffer(support.radius, CIRCLE_SIDES // 4)
    over = np.hypot(*points.T)[surface.quads].max(axis=1) < support.radius * np.cos(np.pi / CIRCLE_SIDES)
    shadow = shadow_of(points, surface.quads[~over], specimen_area).union(plate)  # the plate covers the others
    outline = _outline(shadow)
    angle, radius = polar_profile(outline)
    least = LEAST_PROMINENCE * (float(radius.mean()) - support.radius)
    folds = find_folds(radius, least)
    harmonic, amplitude = largest_harmonic(radius, least)
    crossings = result.frames.get("crossings")
    return Drape(
        label=label or fabric_title(result),
        source=result.path.name,
        status=result.status,
        frame=frame,
        is_last=frame == len(result.time) - 1,
        coefficient=(shadow.area - support_area) / (specimen_area - support_area),
        specimen_area=specimen_area,
        specimen_radius=float(np.sqrt(specimen_area / np.pi)),
        is_disc=is_disc,
        support_area=support_area,
        support_radius=support.radius,
        shadow_area=shadow.area,
        outline=outline,
        angle=angle,
        radius=radius,
        folds=folds,
        harmonic=harmonic,
        harmonic_amplitude=amplitude,
        asymmetry=irregularity(radius, len(folds.peaks)),
        offset=float(np.hypot(shadow.centroid.x, shadow.centroid.y)),
        crossings=None if crossings is None else int(crossings[frame]),
    )


def fabric_title(result: Result) -> str:
    """The fabric's title, or the case's where it has none."""
    material = result.case.get("material")
    return str(material.get("title") or result.title) if isinstance(material, dict) else result.title


def gravity(result: Result) -> np.ndarray:
    """Direction (3,) of the case's gravity; down the z axis where the case does not say."""
    loads = result.case.get("load", [])
    for load in loads if isinstance(loads, list) else []:
        if load.get("kind") == "gravity" and "acceleration" in load:
            direction = np.asarray(load["acceleration"], dtype=float)
            if direction.shape == (3,) and np.linalg.norm(direction) > 0:
                return direction / np.linalg.norm(direction)
    return np.array([0.0, 0.0, -1.0])


def view_along(down: np.ndarray) -> View:
    """From above: x to the right and y up where gravity acts down z."""
    along = np.array([1.0, 0, 0]) if abs(down[0]) < 0.9 else np.array([0, 1.0, 0])
    right = along - (along @ down) * down
    right /= np.linalg.norm(right)
    return View(down, right, np.cross(right, down))


def specimen(result: Result) -> tuple[float, bool]:
    """Area [m²] of the specimen at rest within its outer rim, and whether that is a circle."""
    flat = result.reference - result.reference.mean(axis=0)
    axes = np.linalg.svd(flat, full_matrices=False)[2][:2]  # the plane that it lies in
    surface = SmoothSurface(result.quads, len(result.reference))
    points = surface.points(flat) @ axes.T
    outer = unary_union([Polygon(ring.exterior) for ring in polygonize(points[surface.hem])])  # a hole is over the support
    middle = np.array(outer.centroid.coords[0])
    rim = np.linalg.norm(_outline(outer) - middle, axis=1)
    if np.ptp(rim) < ROUND * rim.max():
        nodes = np.linalg.norm(flat @ axes.T - middle, axis=1)  # they lie on the circle itself
        return float(np.pi * nodes.max() ** 2), True
    return float(outer.area), False


def _support(result: Result, frame: int, view: View, radius: float | None) -> Support:
    """The widest upright disc or cylinder; where `radius` is given and there is none, about the middle of the first frame."""
    round_ones = [obstacle for obstacle in result.obstacles.values() if obstacle.kind in ("disc", "cylinder")]
    plates = [_plate(obstacle.at(frame)) for obstacle in round_ones]
    upright = [support for support, axis in plates if abs(axis @ view.down) > UPRIGHT]
    widest = max(upright, key=lambda support: support.radius, default=None)
    if radius is not None:
        centre = result.position[0].mean(axis=0) if widest is None else widest.centre
        return Support(radius, centre)
    if widest is None:
        text = f"{result.path}: no upright disc or cylinder to be the support; name its radius by --support"
        raise PostprocError(text, BAD_USE)
    return widest


def _plate(obstacle: Obstacle) -> tuple[Support, np.ndarray]:
    axis = np.asarray(obstacle.parameters.get("axis", (0, 0, 1)), dtype=float)
    axis = obstacle.rotation @ (axis / np.linalg.norm(axis))
    return Support(float(obstacle.parameters["radius"]), obstacle.position), axis


def shadow_of(points: np.ndarray, quads: np.ndarray, scale: float) -> Polygon | MultiPolygon:
    """Union of the projections (N, 2) [m] of all faces, each as two triangles, which no fold can turn inside out.

    `scale` [m²]: area of the whole; triangles that are nothing beside it are left out.
    """
    corners = points[np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
    return unary_union([Polygon(triangle) for triangle in corners[area > SLIVER * scale / len(corners)]])


def _parts(shape: Polygon | MultiPolygon) -> list[Polygon]:
    return list(getattr(shape, "geoms", [shape]))


def _outline(shape: Polygon | MultiPolygon) -> np.ndarray:
    """Edge (P, 2) of the largest part, closed."""
    return np.asarray(max(_parts(shape), key=lambda part: part.area).exterior.coords)


def polar_profile(outline: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angles (D,) [rad] and the outermost crossing (D,) [m] of each ray from the origin with a closed polygon (P, 2)."""
    angle = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    ray = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    start, side = outline[:-1], np.diff(outline, axis=0)
    radius = np.zeros(DIRECTIONS)
    for k, direction in enumerate(ray):
        # start + s side = r direction: both unknowns by crossing with the other's direction
        turn = direction[0] * side[:, 1] - direction[1] * side[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            s = (start[:, 0] * direction[1] - start[:, 1] * direction[0]) / turn
            r = (start[:, 0] * side[:, 1] - start[:, 1] * side[:, 0]) / turn
        hit = (s >= -1e-12) & (s <= 1 + 1e-12) & (r > 0)
        radius[k] = r[hit].max(initial=0.0)
    return angle, radius


def find_folds(radius: np.ndarray, least: float) -> Folds:
    """Crests of a polar profile (D,) [m] that rise by `least` [m] or more above the higher of the lowest places beside them.

    Counted on the profile after a Gaussian of SMOOTHING, so that a kink of the mesh is no fold.
    """
    wave = np.arange(len(radius) // 2 + 1)
    smooth = np.fft.irfft(np.fft.rfft(radius) * np.exp(-0.5 * (SMOOTHING * wave) ** 2), len(radius))
    crests = np.flatnonzero((smooth > np.roll(smooth, 1)) & (smooth >= np.roll(smooth, -1)))
    if least <= 0:
        return Folds(crests[:0], crests[:0], smooth)
    peaks = np.array([k for k in crests if _prominence(smooth, k) >= least], dtype=int)
    ends = np.append(peaks[1:], peaks[:1] + len(radius))
    valleys = [(a + int(np.argmin(np.take(smooth, range(a, b), mode="wrap")))) % len(radius) for a, b in zip(peaks, ends)]
    return Folds(peaks, np.array(valleys, dtype=int), smooth)


def _prominence(profile: np.ndarray, peak: int) -> float:
    """How far one has to go down from a crest of a periodic profile before it goes up higher; of the highest: all the way."""
    walk = np.roll(profile, -peak)
    lowest = []
    for way in (walk[1:], walk[:0:-1]):
        higher = np.flatnonzero(way > walk[0])
        lowest.append(way[: higher[0] if higher.size else len(way)].min())
    return float(walk[0] - max(lowest))


def largest_harmonic(radius: np.ndarray, least: float) -> tuple[int, float]:
    """Number and amplitude [m] of the largest wave of a profile (D,); the first one is a shift, not a fold.

    0, 0 where none is higher from crest to trough than `least` [m], as a fold has to be.
    """
    waves = 2 * np.abs(np.fft.rfft(radius))[: len(radius) // 8] / len(radius)
    waves[:2] = 0
    number = int(np.argmax(waves))
    if 2 * waves[number] <= least:
        return 0, 0.0
    return number, float(waves[number])


def irregularity(radius: np.ndarray, folds: int) -> float | None:
    """How little the folds are alike: rms change of a profile when it is turned by one fold, over √2 of its own deviation.

    0: each fold repeats the one before; 1: they have nothing in common. None where there are less than two.
    """
    if folds < 2:
        return None
    whole = len(radius)
    turned = np.interp(np.arange(whole) + whole / folds, np.arange(2 * whole), np.tile(radius, 2))
    return float(np.sqrt(np.mean((turned - radius) ** 2) / (2 * radius.var())))


def report(drapes: Sequence[Drape]) -> dict[str, Any]:
    """What --json writes: numbers with their units in their names."""
    return {"format": "sundrape drape", "drapes": [_entry(drape) for drape in drapes]}


def _entry(drape: Drape) -> dict[str, Any]:
    return {
        "label": drape.label,
        "result": drape.source,
        "status": drape.status,
        "frame": drape.frame,
        "drape_coefficient": drape.coefficient,
        "specimen_area_m2": drape.specimen_area,
        "specimen_is_disc": drape.is_disc,
        "support_area_m2": drape.support_area,
        "support_radius_m": drape.support_radius,
        "shadow_area_m2": drape.shadow_area,
        "folds": drape.fold_count,
        "fold_angles_deg": np.degrees(drape.angle[drape.folds.peaks]).tolist(),
        "fold_depth_m": drape.fold_depth,
        "least_prominence": LEAST_PROMINENCE,
        "largest_harmonic": drape.harmonic,
        "largest_harmonic_amplitude_m": drape.harmonic_amplitude,
        "mean_radius_m": drape.mean_radius,
        "smallest_radius_m": float(drape.radius.min()),
        "largest_radius_m": float(drape.radius.max()),
        "asymmetry": drape.asymmetry,
        "centroid_offset_m": drape.offset,
        "crossings": drape.crossings,
        "profile": {"angle_deg": np.degrees(drape.angle).tolist(), "radius_m": drape.radius.tolist()},
    }
