"""Equilibrium paths: what their results hold, that they go on where they were stopped, and what they say when they fail."""
import unittest

import h5py
import numpy as np

from command_line import CommandLineTest

# A clamped strip under end thrust; its straight path has a bifurcation at pi^2 EI/(4 L^2): with B = 1e-4 N m, L = 10 cm at 0.0247 N/m.
EULER = np.pi**2 * 1e-4 / (4 * 0.1**2)
STRIP = f"""
title = "strut"
model = "shell"
analysis = "arc-length"
[cloth]
shape = "rectangle"
size = ["10 cm", "1 cm"]
cells = [20, 1]
[material]
thickness = "0.5 mm"
density_area = 0.2
youngs_modulus = {12 * 1e-4 / 0.5e-3**3}
poisson = 0
[[fix]]
nodes = "left"
[[load]]
kind = "traction"
nodes = "right"
per_length = [{-1.5 * EULER}, 0, 0]
["arc-length"]
first_load_increment = 0.1
[output]
probes = [ {{ name = "tip", near = ["5 cm", 0, 0] }} ]
"""


class ArcLength(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.case = self.write("strut.toml", STRIP)

    def run_path(self, *options):
        return self.sundrape("run", self.case, "-o", "out.h5", "--force", *options)

    def test_the_result_holds_the_path_and_its_bifurcation(self):
        done = self.run_path()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, "bifurcation at load factor 0.66")
        with h5py.File(self.folder / "out.h5") as result:
            self.assertEqual(len(result["critical/load_factor"]), 1)
            self.assertAlmostEqual(result["critical/load_factor"][0] * 1.5, 1, delta=2 * (np.pi / 40) ** 2 / 12)  # twice the error of 20 elements on a quarter wave
            self.assertEqual(result["critical/limit_point"][0], 0)
            mode = result["critical/mode"][0]
            self.assertAlmostEqual(np.abs(mode[:, 2]).max(), 1, delta=1e-3)  # it bends out of the plane
            self.assertEqual(result["frames/load_factor"][-1], 1)
            self.assertEqual(set(result["frames/stage"][1:]), {1})
            self.assertEqual(result["frames/negative_pivots"][-1], 1)
            self.assertEqual(len(result["probes/tip/load_factor"]), len(result["steps/load_factor"]))
            self.assertLess(result["iterations/residual"][-1], 1e-6)

    def test_a_path_that_was_stopped_goes_on_to_the_same_end(self):
        bent = ["--set", "arc-length.at_bifurcation=switch", "--set", "arc-length.branch_amplitude=1 mm"]
        self.assertEqual(self.run_path(*bent).returncode, 0)
        with h5py.File(self.folder / "out.h5") as result:
            whole = result["frames/position"][-1], len(result["steps/load_factor"])
        stopped = self.run_path(*bent, "--set", "arc-length.max_steps=6")
        self.assertEqual(stopped.returncode, 1)
        self.assertRegex(stopped.stderr, "not come to the full load in 6 steps at load factor .* arc-length.max_steps")
        on = self.sundrape("run", self.case, *bent, "--resume", "out.h5")
        self.assertEqual(on.returncode, 0, on.stderr)
        with h5py.File(self.folder / "out.h5") as result:
            np.testing.assert_allclose(result["frames/position"][-1], whole[0], atol=1e-8)
            self.assertEqual(len(result["steps/load_factor"]), whole[1])

    def test_an_unstable_end_falls_to_its_stable_neighbour(self):
        done = self.run_path("--set", "arc-length.unstable_end=relax")
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(self.folder / "out.h5") as result:
            self.assertEqual(result["frames/negative_pivots"][-1], 0)
            self.assertGreater(abs(result["frames/position"][-1, :, 2]).max(), 0.03)

    def test_load_that_nothing_resists(self):
        loose = self.write("loose.toml", STRIP.replace("[[fix]]\nnodes = \"left\"", "[[fix]]\nnodes = \"left\"\ncomponents = [\"y\", \"z\"]"))
        done = self.sundrape("run", loose, "-o", "loose.h5", "--set", "arc-length.max_steps=50")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "load factor .* of stage 1, after")
        with h5py.File(self.folder / "loose.h5") as result:
            self.assertEqual(result.attrs["status"].decode(), "failed")


if __name__ == "__main__":
    unittest.main()
