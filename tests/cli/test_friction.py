"""Friction on obstacles: slopes, a capstan, a table that moves and a tablecloth pulled away."""
import math
import unittest

import h5py
import numpy as np
from command_line import CASES, LOOSE_SHEET, CommandLineTest


class Friction(CommandLineTest):
    DOWN = np.array([math.cos(math.pi / 6), 0, -0.5])
    G = 9.80665

    def slope_speeds(self, *sets):
        out, summary = self.run_case(CASES / "incline.toml", *sets)
        with h5py.File(out) as result:
            return result["frames/time"][:], result["frames/velocity"][:] @ self.DOWN, summary

    def test_holds_one_per_cent_above_the_slope_and_creeps_as_it_says(self):
        for more in ([], ["dynamics.integrator=ida"], ["model=shell"]):
            with self.subTest(more=more):
                time, speed, summary = self.slope_speeds(*more)
                self.assertLess(abs(speed[time > 1]).max(), 0.1e-3)
                # a part r of the largest friction creeps at s0 (1 - (1 - r)^(1/3)) (friction_law.hpp)
                part = math.tan(math.pi / 6) / 0.5831
                # 5 % of s0: what Newton's iteration may leave (docs/friction.md)
                self.assertAlmostEqual(speed[-1].mean(), 1e-4 * (1 - (1 - part) ** (1 / 3)), delta=0.05e-4)
                self.assertAlmostEqual(summary["fastest_creep_m_per_s"], speed[-1].max(), delta=0.05e-4)

    def test_holds_with_an_explicit_method_too(self):
        """Its step is then a matter of friction's slope at rest; s0 is large here, to make that bearable."""
        time, speed, summary = self.slope_speeds(
            "dynamics.integrator=rk4", "dynamics.duration=0.3", 'contact.friction_speed="10 mm/s"'
        )
        part = math.tan(math.pi / 6) / 0.5831
        self.assertAlmostEqual(speed[-1].mean(), 1e-2 * (1 - (1 - part) ** (1 / 3)), delta=0.01e-2)

    def test_slides_below_the_slope_with_what_is_left(self):
        for friction in (0.57, 0.5, 0.3):  # 0.57 is 1.3 % below the slope
            time, speed, _ = self.slope_speeds(f"obstacle.0.friction={friction}")
            late = time > 1
            acceleration = np.polyfit(time[late], speed[late].mean(axis=1), 1)[0]
            expected = self.G * (0.5 - friction * math.cos(math.pi / 6))
            self.assertLess(abs(acceleration - expected), 0.01 * expected)

    def test_a_capstan_multiplies_what_it_is_pulled_with(self):
        """Euler and Eytelwein: exp(μφ), over a quarter turn at μ = 0.3; one way and the other, at rest in between."""
        out, summary = self.run_case(CASES / "capstan.toml")
        with h5py.File(out) as result:
            time, pull = result["frames/time"][:], result["frames/reaction/hand"][:, 0]
        ratio = math.exp(0.3 * math.pi / 2)

        def mean(start, end):
            return pull[(time > start) & (time < end)].mean()

        self.assertLess(abs(mean(2.3, 2.95) / (0.1 * ratio) - 1), 0.03)
        self.assertLess(abs(mean(4.3, 4.95) / (0.1 / ratio) - 1), 0.03)
        self.assertGreater(mean(3.1, 3.9), 1.4 * 0.1)  # friction keeps what it had, but for creep

    def test_a_moving_table_takes_the_cloth_along(self):
        table = """[[obstacle]]
kind = "plane"
friction = 0.5
motion = { kind = "line", by = ["20 cm", 0, 0], duration = "1 s" }
"""
        out, summary = self.run_case(self.write("table.toml", LOOSE_SHEET + table))
        with h5py.File(out) as result:
            moved = result["frames/position"][-1, :, 0] - result["frames/position"][0, :, 0]
            self.assertLess(abs(moved - 0.2).max(), 0.2e-3)  # it creeps, for 1 s at up to 0.1 mm/s
            self.assertAlmostEqual(result["frames/obstacle_position/plane0"][-1, 0], 0.2)

    def test_a_fast_hand_leaves_a_tablecloth_books_that_close(self):
        _, summary = self.run_case(CASES / "tablecloth_pulled.toml")
        energy = summary["final"]["energy_J"]
        self.assertLess(abs(energy["method_dissipated"]), 0.01 * energy["external_work"])

    def test_statics_say_that_they_do_not_see_it(self):
        _, summary = self.run_case(CASES / "incline.toml", "analysis=relaxation", "relaxation.max_iterations=3", status=1)
        self.assertTrue(any("friction acts in dynamics only" in each for each in summary["warnings"]))


if __name__ == "__main__":
    unittest.main()
