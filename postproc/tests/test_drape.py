"""The drape tester's analysis against shapes whose shadows are known by hand.

Tolerances come from the mesh, before anything is measured. A disc of n cells has about 8 n/3 sides at its rim. The rim of
the smooth surface is a cubic spline whose error, at a wave of number k, is of order (k h)⁴ with h the turn from node to node.
h = 2π/104 at 40 cells: 1e-5 of the radius at k = 0, 0.06 % of the wave at k = 8. What limits is the surface between: SHIFTS
of the control points leave about 2⁻⁸ of the distance c²/8R that subdivision would cut a chord of c by, 0.01 % of a radius.
0.5 % of the coefficient, as required, is 0.3 % of the area of a disc of 30 cm over one of 18 cm.
"""

from __future__ import annotations

import json
import unittest
from dataclasses import replace

import numpy as np

from sundrape_postproc import drape
from sundrape_postproc.errors import PostprocError
from sundrape_postproc.load import Obstacle, Result
from tests.synthetic import Motion, bowl, disc, square, write_result
from tests.test_fields import result_of
from tests.test_pictures import Pictures

SPECIMEN, SUPPORT = 0.15, 0.09  # radii [m]
TOLERANCE = 0.005  # of the coefficient
PEDESTAL = Obstacle("disc", {"radius": SUPPORT, "height": 0.1}, np.zeros(3), np.eye(3))
CELLS = 40


def polar(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])


def at(r: np.ndarray, angle: np.ndarray, z: np.ndarray | float) -> np.ndarray:
    return np.stack([r * np.cos(angle), r * np.sin(angle), z + 0 * r], axis=1)


def test_of(shape, cells: int = CELLS, obstacles: dict | None = None, **options: float) -> drape.Drape:
    """Measures a disc of which `shape(r, angle)` makes positions (N, 3)."""
    reference, quads = disc(SPECIMEN, cells)
    result = result_of(reference, quads, shape(*polar(reference)), "shell")
    return drape.measure(replace(result, obstacles={"pedestal": PEDESTAL} if obstacles is None else obstacles), 0, **options)


test_of.__test__ = False  # for pytest: a helper


def flat(r: np.ndarray, angle: np.ndarray) -> np.ndarray:
    return at(r, angle, 0.0)


def hanging(r: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """What overhangs hangs straight down, on the cylinder of the support."""
    return at(np.minimum(r, SUPPORT), angle, -np.maximum(r - SUPPORT, 0))


def cone(r: np.ndarray, angle: np.ndarray, slope: float = 0.5) -> np.ndarray:
    """What overhangs leans at `slope` rad below the horizontal: an outer radius of 9 cm + 6 cm cos(slope)."""
    out = np.maximum(r - SUPPORT, 0)
    return at(np.minimum(r, SUPPORT) + out * np.cos(slope), angle, -out * np.sin(slope))


def fluted(n: int, amplitude: float, mean: float = 0.125, skew: float = 0.0):
    """A rim at r = mean + amplitude cos(n angle) (1 + skew cos(angle)), whose area at skew 0 is π (mean² + amplitude²/2)."""

    def shape(r: np.ndarray, angle: np.ndarray) -> np.ndarray:
        share = np.clip((r - SUPPORT) / (SPECIMEN - SUPPORT), 0, 1)
        rim = mean + amplitude * np.cos(n * angle) * (1 + skew * np.cos(angle))
        return at(np.minimum(r, SUPPORT) + share * (rim - SUPPORT), angle, -0.04 * share)

    return shape


class Coefficient(unittest.TestCase):
    def test_a_board_has_all_of_it_on_every_mesh(self) -> None:
        for cells in (9, 20, CELLS):
            test = test_of(flat, cells)
            self.assertAlmostEqual(test.coefficient, 1, delta=TOLERANCE)
            self.assertTrue(test.is_disc)
            self.assertAlmostEqual(test.specimen_area, np.pi * SPECIMEN**2, delta=1e-9)  # nodes lie on the circle
            self.assertEqual((test.fold_count, test.harmonic, test.fold_depth), (0, 0, 0.0))

    def test_a_cloth_that_hangs_straight_down_has_none_of_it(self) -> None:
        # the mesh has no nodes along the support's edge: a cell that straddles it cuts the corner inwards only
        self.assertAlmostEqual(test_of(hanging).coefficient, 0, delta=TOLERANCE)

    def test_a_cone(self) -> None:
        outer = SUPPORT + (SPECIMEN - SUPPORT) * np.cos(0.5)
        test = test_of(cone)
        expected = (outer**2 - SUPPORT**2) / (SPECIMEN**2 - SUPPORT**2)
        self.assertAlmostEqual(test.coefficient, expected, delta=TOLERANCE)
        np.testing.assert_allclose(test.radius, outer, rtol=TOLERANCE)
        self.assertEqual(test.fold_count, 0)

    def test_a_fluted_shape(self) -> None:
        for n in (3, 5, 8):
            with self.subTest(folds=n):
                test = test_of(fluted(n, 0.012))
                area = np.pi * (0.125**2 + 0.012**2 / 2)
                expected = (area - np.pi * SUPPORT**2) / (np.pi * (SPECIMEN**2 - SUPPORT**2))
                self.assertAlmostEqual(test.coefficient, expected, delta=TOLERANCE)
                self.assertEqual((test.fold_count, test.harmonic), (n, n))
                self.assertAlmostEqual(test.harmonic_amplitude, 0.012, delta=TOLERANCE * 0.012 * n)
                self.assertAlmostEqual(test.fold_depth, 0.024, delta=0.05 * 0.024)  # counted on a smoothed profile
                self.assertAlmostEqual(test.mean_radius, 0.125, delta=TOLERANCE * 0.125)
                crests = np.sort(np.degrees(test.angle[test.folds.peaks]))
                np.testing.assert_allclose(crests, 360 / n * np.arange(n), atol=1.0)
                self.assertLess(test.asymmetry, 0.02)
                self.assertLess(test.offset, 1e-4)

    def test_an_overhanging_fold_counts_by_its_outermost_point(self) -> None:
        # a rim that curls back under itself: the widest place is half-way down the overhang, at 9 cm + 6/π cm
        def curled(r: np.ndarray, angle: np.ndarray) -> np.ndarray:
            turn = np.pi * np.maximum(r - SUPPORT, 0) / (SPECIMEN - SUPPORT)
            bend = (SPECIMEN - SUPPORT) / np.pi
            return at(np.minimum(r, SUPPORT) + bend * np.sin(turn), angle, -bend * (1 - np.cos(turn)))

        outer = SUPPORT + (SPECIMEN - SUPPORT) / np.pi
        expected = (outer**2 - SUPPORT**2) / (SPECIMEN**2 - SUPPORT**2)
        self.assertAlmostEqual(test_of(curled).coefficient, expected, delta=TOLERANCE)

    def test_gravity_says_which_way_shadows_fall(self) -> None:
        reference, quads = disc(SPECIMEN, CELLS)
        turn = np.array([[0, 0, 1.0], [0, 1, 0], [-1, 0, 0]])  # z to x
        position = fluted(5, 0.012)(*polar(reference)) @ turn.T
        case = {"load": [{"kind": "gravity", "acceleration": [-9.81, 0, 0]}]}
        result = replace(result_of(reference, quads, position, "shell"), case=case)
        result = replace(result, obstacles={"pedestal": replace(PEDESTAL, rotation=turn)})
        tilted, upright = drape.measure(result, 0), test_of(fluted(5, 0.012))
        self.assertAlmostEqual(tilted.coefficient, upright.coefficient, places=9)
        self.assertEqual(tilted.fold_count, 5)


class FoldCount(unittest.TestCase):
    """`find_folds` on profiles themselves."""

    angle = 2 * np.pi * np.arange(drape.DIRECTIONS) / drape.DIRECTIONS

    def test_ripples_below_the_threshold_are_no_folds(self) -> None:
        radius = 0.13 + 0.01 * np.cos(4 * self.angle) + 2e-4 * np.cos(23 * self.angle)
        self.assertEqual(len(drape.find_folds(radius, 0.05 * 0.04).peaks), 4)
        self.assertEqual(len(drape.find_folds(np.full(drape.DIRECTIONS, 0.13), 0.05 * 0.04).peaks), 0)

    def test_folds_of_unlike_size_are_counted_each(self) -> None:
        radius = 0.13 + 0.01 * np.cos(5 * self.angle) + 0.004 * np.cos(self.angle - 1)
        folds = drape.find_folds(radius, 0.05 * 0.04)
        self.assertEqual((len(folds.peaks), len(folds.valleys)), (5, 5))

    def test_one_place_stands_out(self) -> None:
        folds = drape.find_folds(0.13 + 0.01 * np.exp(-(((self.angle - 1) / 0.3) ** 2)), 0.002)
        self.assertEqual(len(folds.peaks), 1)
        self.assertAlmostEqual(self.angle[folds.peaks[0]], 1, delta=0.01)

    def test_unlike_folds_are_asymmetric(self) -> None:
        self.assertLess(drape.irregularity(0.13 + 0.01 * np.cos(5 * self.angle), 5), 1e-6)
        self.assertGreater(test_of(fluted(5, 0.012, skew=0.6)).asymmetry, 0.1)
        self.assertIsNone(drape.irregularity(np.full(drape.DIRECTIONS, 0.13), 0))


class Specimens(unittest.TestCase):
    def test_a_square_counts_by_the_area_of_its_mesh(self) -> None:
        reference, quads = square(0.3, 20)
        result = replace(result_of(reference, quads, reference, "shell"), obstacles={"pedestal": PEDESTAL})
        test = drape.measure(result, 0)
        self.assertFalse(test.is_disc)
        self.assertAlmostEqual(test.specimen_area, 0.09, delta=1e-6)
        self.assertAlmostEqual(test.coefficient, 1, delta=TOLERANCE)
        self.assertEqual((test.fold_count, test.harmonic), (4, 4))  # its corners

    def test_a_ring_that_is_held_at_its_hole_is_a_disc(self) -> None:
        angle, r = np.meshgrid(2 * np.pi * np.arange(96) / 96, np.linspace(SUPPORT, SPECIMEN, 9))
        reference = at(r.ravel(), angle.ravel(), 0.0)
        index = np.arange(r.size).reshape(r.shape)
        quads = np.stack([index[:-1], index[1:], np.roll(index[1:], -1, 1), np.roll(index[:-1], -1, 1)], -1).reshape(-1, 4)
        result = replace(result_of(reference, quads, reference, "shell"), obstacles={"pedestal": PEDESTAL})
        test = drape.measure(result, 0)
        self.assertTrue(test.is_disc)
        self.assertAlmostEqual(test.coefficient, 1, delta=TOLERANCE)

    def test_the_support(self) -> None:
        lying = Obstacle("cylinder", {"radius": 0.12, "length": 1, "axis": [1, 0, 0]}, np.zeros(3), np.eye(3))
        narrow = replace(PEDESTAL, parameters={"radius": 0.05})
        test = test_of(flat, 12, {"lying": lying, "narrow": narrow, "wide": PEDESTAL})
        self.assertEqual(test.support_radius, SUPPORT)
        aside = replace(PEDESTAL, position=np.array([0.01, 0, 0]))
        self.assertAlmostEqual(test_of(flat, 12, {"aside": aside}).offset, 0.01, delta=1e-4)
        for nothing in ({}, {"lying": lying}):
            with self.assertRaisesRegex(PostprocError, "--support"):
                test_of(flat, 12, nothing)
        self.assertEqual(test_of(flat, 12, {}, support_radius=0.06).support_radius, 0.06)
        with self.assertRaisesRegex(PostprocError, "no larger than the support"):
            test_of(flat, 12, {}, support_radius=0.2)


class Command(Pictures):
    def write(self, name: str, status: str = "done") -> str:
        reference, quads = disc(SPECIMEN, 12)
        shapes = np.stack([shape(*polar(reference)) for shape in (flat, cone, fluted(3, 0.012))])
        motion = Motion(reference, quads, np.arange(3.0), shapes, np.zeros_like(shapes))
        pedestal = {"pedestal": {"kind": "disc", "parameters": {"radius": SUPPORT, "height": 0.1}}}
        return str(write_result(self.folder / name, motion, pedestal, status=status, title="A disc"))

    def test_one_result_its_numbers_and_its_frames(self) -> None:
        numbers = self.folder / "drape.json"
        found = []
        for frame in ((), ("--frame", "0"), ("--frame", "-2")):
            pixels = self.drawn("drape", self.write("a.h5"), "--json", numbers, "--size", "900x460", *frame)
            self.assertEqual(pixels.shape, (460, 900, 3))
            blue = (pixels[..., 2] > pixels[..., 0] + 0.4).mean()
            self.assertGreater(blue, 1e-3)  # outline and profile
            report = json.loads(numbers.read_text())
            self.assertEqual(report["format"], "sundrape drape")
            (entry,) = report["drapes"]
            found.append((entry["frame"], entry["folds"], len(entry["profile"]["radius_m"])))
        self.assertEqual(found, [(2, 3, 720), (0, 0, 720), (1, 0, 720)])

    def test_several_results_share_a_page(self) -> None:
        pixels = self.drawn("drape", self.write("a.h5"), self.write("b.h5", status="failed"))
        self.assertEqual(pixels.shape, (780, 800, 3))
        self.assertGreater((pixels[..., 0] > pixels[..., 2] + 0.4).mean(), 1e-3)  # the second is orange

    def test_what_it_refuses(self) -> None:
        bare = write_result(self.folder / "bare.h5", bowl())
        self.refused(2, "--support", "drape", bare, "-o", self.png)
        self.drawn("drape", bare, "--support", "5 cm")
        self.refused(2, "no larger than the support", "drape", bare, "-o", self.png, "--support", "0.5")
        self.refused(2, "has frames 0 to 2", "drape", self.write("a.h5"), "-o", self.png, "--frame", "3")
        self.refused(2, "at most 6", "drape", *[self.write("a.h5")] * 7, "-o", self.png)
        self.refused(3, "no such directory", "drape", bare, "-o", self.png, "--json", self.folder / "absent/a.json")
        self.refused(3, "No such file", "drape", self.folder / "absent.h5", "-o", self.png)


del Pictures  # its own tests are not ours to run again

if __name__ == "__main__":
    unittest.main()
