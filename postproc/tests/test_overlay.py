"""Overlays: distances against displacements and points that are known, and what CSV files have to say."""

from __future__ import annotations

import unittest
from dataclasses import replace

import matplotlib.image
import numpy as np

from sundrape_postproc import load, measured, overlay
from sundrape_postproc.errors import PostprocError
from tests.synthetic import TABLE, bowl, square, write_result
from tests.test_pictures import Pictures, command


class Overlays(Pictures):
    def setUp(self):
        super().setUp()
        self.other = self.folder / "other.h5"
        motion = bowl()
        write_result(self.result, motion, TABLE)
        write_result(self.other, replace(motion, position=motion.position + [0, 0, 0.003]), TABLE)
        self.csv = self.folder / "scan.csv"

    def test_distances_of_a_shift_are_the_shift(self):
        first, second = overlay.layers([load(self.result), load(self.other)])
        np.testing.assert_allclose(overlay.apart(first, second), (0.003, 0.003))
        lines = overlay.legend_text(second, first, []).splitlines()
        self.assertEqual(lines[0], "other: particle, dynamics")
        self.assertEqual(lines[1].strip(), "nodes from result: at most 3 mm, RMS 3 mm")
        write_result(self.other, bowl(cells=5))
        first, second = overlay.layers([load(self.result), load(self.other)])
        self.assertIsNone(overlay.apart(first, second))
        self.assertIn("mesh is not that of result", overlay.legend_text(second, first, []))

    def test_measured_points_are_as_far_as_they_were_put(self):
        nodes, quads = square(0.2, 4)
        points = np.array([[0.01, 0.02, 0.005], [0.1, 0.1, -0.002], [0.13, 0, 0.04], [-0.1, -0.13, 0]])
        np.testing.assert_allclose(measured.to_surface(points, nodes, quads), [0.005, 0.002, 0.05, 0.03], atol=1e-15)
        collapsed = nodes * [1, 0, 1]
        np.testing.assert_allclose(measured.to_surface(points[:1], collapsed, quads), np.hypot(0.02, 0.005), atol=1e-15)
        line = np.array([[0.0, 0], [1, 0], [1, 2]])
        np.testing.assert_allclose(measured.to_line(np.array([[0.5, 0.3], [2, 1], [1, 3]]), line), [0.3, 1, 1])

    def test_the_command_draws_and_lists_the_distance_of_every_point(self):
        lowest = load(self.result).position[-1, -1]  # a corner
        rows = [f"a,{100 * x},{100 * y},{100 * z}" for x, y, z in (lowest, lowest + [0.01, 0.01, -0.01])]
        self.csv.write_text("\n".join(["name,x [cm],y [cm],z [cm]", *rows]))
        arguments = ("--points", self.csv, "--size", "700x400")
        done = command("overlay", self.result, self.other, "-o", self.png, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        head, first, second, rms = (line.split(",") for line in done.stdout.splitlines())
        self.assertEqual(head[4:], ["distance from result [m]", "distance from other [m]"])
        self.assertEqual(first[0], "scan 1")
        self.assertAlmostEqual(float(first[4]), 0, places=12)
        self.assertLessEqual(float(first[5]), 0.003)
        self.assertGreater(float(second[4]), 0.01)
        self.assertAlmostEqual(float(rms[4]), float(second[4]) / np.sqrt(2), places=5)
        pixels = matplotlib.image.imread(self.png)[..., :3]
        self.assertEqual(pixels.shape, (400, 700, 3))
        scene = pixels[:, :406]
        for colour in ((0, 2), (2, 0)):  # one cloth is blue, one orange
            self.assertGreater((scene[..., colour[1]] > scene[..., colour[0]] + 0.12).mean(), 0.01)

    def test_units_of_points(self):
        for unit, metres in (("m", 1), ("cm", 0.01), ("mm", 1e-3), ("in", 0.0254)):
            self.csv.write_text(f"# scanned\n\n z [{unit}], X [m] ,note\n3,0.5,top\n")
            points = measured.read_points(self.csv)
            self.assertTrue(points.in_plane)
            np.testing.assert_allclose(points.place, [[0.5, 0, 3 * metres]])

    def test_points_that_do_not_say_what_they_should(self):
        for text, said in (
            ("x,z [cm]\n1,2", r"scan\.csv:1: column x has no unit: write x \[cm\]"),
            ("x [cm],y [cm]\n1,2", r"scan\.csv:1: no column z"),
            ("x [cm],z [furlong]\n1,2", r"scan\.csv:1: column z: unit 'furlong' is none of m, cm, mm, in"),
            ("x [cm],z [cm]\n1,2\n3,high", r"scan\.csv:3: column z: 'high' is not a number"),
            ("x [cm],z [cm]\n\n1", r"scan\.csv:3: column z: '' is not a number"),
            ("x [cm],x [m],z [cm]\n1,2,3", r"scan\.csv:1: two columns x"),
            ("x [cm],z [cm]\n", r"scan\.csv:1: no points"),
            ("", r"scan\.csv:1: is empty"),
        ):
            self.csv.write_text(text)
            with self.assertRaisesRegex(PostprocError, said) as caught:
                measured.read_points(self.csv)
            self.assertEqual(caught.exception.status, 2)

    def test_refusals(self):
        self.csv.write_text("x,z\n1,2")
        one = ("overlay", self.result, "-o", self.png)
        self.refused(2, "2 to 6 results", *one)
        self.refused(2, r"scan\.csv:1: column x has no unit", *one, "--points", self.csv)
        self.refused(3, "absent.csv: cannot be read: No such file", *one, "--points", self.folder / "absent.csv")


if __name__ == "__main__":
    unittest.main()
