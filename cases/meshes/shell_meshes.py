#!/usr/bin/env python3
"""Writes the meshes of the curved and slit shells in cases/shell_*.toml as OBJ files beside this
script, or into FOLDER.

    python3 cases/meshes/shell_meshes.py [FOLDER]

Slit annular plate: radii 6 and 10, `radial` x `around` elements, in the plane z = 0, counter-clockwise from the slit, which lies
on the positive x axis. Its two edges are opened by 1e-6 rad to either side, so that a box can pick one of them.

Hemisphere with an 18 degree hole: radius 10, the quarter x, y >= 0 between the equator z = 0 and the hole, `n` x `n` elements
that are equal in longitude and latitude.

Arch: a circular strip of radius 0.5 m and 10 mm width over half an angle of 0.1177 rad to either side, its ends on z = 0, `n` x 1
elements. A deep one has twice the angle.

Distorted ones: every interior node is moved in the surface, by a random part of up to 25 % of an element along either direction.

vt are the lengths along the mesh lines of the undistorted surface: the warp follows the first direction.
"""
import math
import pathlib
import random
import sys

OPENING = 1e-6  # rad, half of the slit's
DISTORTION = 0.25  # of an element's edges
SEED = 1


def slit_annulus(r, a):
    """Radius 6 to 10 for r in [0, 1], the way around for a in [0, 1]."""
    radius, angle = 6 + 4 * r, OPENING + a * 2 * (math.pi - OPENING)
    return (radius * math.cos(angle), radius * math.sin(angle), 0.0), (4 * r, 8 * angle)


def hemisphere(a, b):
    """A quarter around for a in [0, 1], equator to hole for b in [0, 1]."""
    longitude, latitude = a * math.pi / 2, b * math.radians(72)
    x, y = math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude)
    on_plane = [0.0 if abs(c) < 1e-12 else 10 * c for c in (x, y, math.sin(latitude))]
    return on_plane, (10 * longitude, 10 * latitude)


def arch(half_angle):
    def surface(a, b):
        """From end to end for a in [0, 1], across for b in [0, 1]."""
        angle = half_angle * (2 * a - 1)
        on_axis = 0.0 if abs(angle) < 1e-12 else 0.5 * math.sin(angle)
        rise = 0.5 * (math.cos(angle) - math.cos(half_angle))
        return (on_axis, 0.01 * (b - 0.5), 0.0 if abs(rise) < 1e-12 else rise), (0.5 * angle, 0.01 * (b - 0.5))
    return surface


def write(folder, name, surface, n, m, distorted=False):
    random_part = random.Random(SEED)
    lines = [f"# written by shell_meshes.py: {n} x {m} elements"
             + (f", distorted by {DISTORTION:.0%} with seed {SEED}" if distorted else "")]
    for j in range(m + 1):
        for i in range(n + 1):
            moved = [0.0, 0.0]
            if distorted and 0 < i < n and 0 < j < m:
                moved = [DISTORTION * random_part.uniform(-1, 1) for _ in range(2)]
            x, t = surface((i + moved[0]) / n, (j + moved[1]) / m)
            lines += ["v " + " ".join(f"{c:.10g}" for c in x), "vt " + " ".join(f"{c:.9g}" for c in t)]
    for j in range(m):
        for i in range(n):
            first = 1 + j * (n + 1) + i
            lines.append("f " + " ".join(f"{k}/{k}" for k in (first, first + 1, first + n + 2, first + n + 1)))
    (folder / (name + ".obj")).write_text("\n".join(lines) + "\n", encoding="ascii")


def write_all(folder):
    write(folder, "arch_40x1", arch(0.1177), 40, 1)
    write(folder, "deep_arch_40x1", arch(2 * 0.1177), 40, 1)
    for radial, around in [(10, 80), (6, 48), (5, 40)]:
        write(folder, f"slit_annulus_{radial}x{around}", slit_annulus, radial, around)
    write(folder, "slit_annulus_10x80_distorted", slit_annulus, 10, 80, distorted=True)
    for cells in (8, 16, 32):
        write(folder, f"hemisphere_{cells}x{cells}", hemisphere, cells, cells)
    for cells in (8, 16):
        write(folder, f"hemisphere_{cells}x{cells}_distorted", hemisphere, cells, cells, distorted=True)


if __name__ == "__main__":
    write_all(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
