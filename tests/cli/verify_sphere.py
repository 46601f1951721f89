"""A square metre of cloth, 101 x 101 nodes, on a ball of 20 cm: minutes, so not a fast test."""
import unittest

import h5py
import numpy as np

from command_line import CASES, CommandLineTest

RADIUS, NODES = 0.2, 101  # [m]


class Sphere(CommandLineTest):
    timeout = 3000

    def test_the_cloth_neither_sinks_in_nor_stretches(self):
        out, summary = self.run_case(CASES / "square_on_sphere.toml")
        with h5py.File(out) as result:
            x = result["frames/position"][:]
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            end = result["frames/time"][-1]
        inside = 1 - np.linalg.norm(x - [0, 0, -RADIUS], axis=2).min() / RADIUS
        grid = x.reshape(len(x), NODES, NODES, 3)
        edge = 1 / (NODES - 1)
        largest = np.array([max((np.linalg.norm(np.diff(frame, axis=k), axis=2) / edge - 1).max() for k in (0, 1)) for frame in grid])
        print(f"{summary['cpu_seconds'] / end:.0f} s of CPU per simulated second; nodes at most {inside:.3%} of the radius inside;"
              f" edges stretched by {largest[-1]:.2%} in the end, by {largest.max():.2%} in the fall")
        self.assertLess(inside, 1e-3)
        self.assertLess(summary["deepest_penetration_m"], 1e-3 * RADIUS)
        self.assertLess(largest[-1], 0.02)


if __name__ == "__main__":
    unittest.main()
