"""Cases in which a sheet ends in layers: folded in four, dropped on a ball and on a mesh; on coarse meshes, to be fast."""
import unittest

import h5py
import numpy as np

from command_line import CASES, CommandLineTest


def layers_over(position, quads, place):
    """How many triangles lie over or under a place in the plane."""
    a, b, c, d = (position[quads[:, k], :2] - place for k in range(4))
    count = 0
    for corners in ((a, b, c), (a, c, d)):
        sides = [corners[k - 1][:, 0] * corners[k][:, 1] - corners[k - 1][:, 1] * corners[k][:, 0] for k in range(3)]
        count += int((np.all(np.array(sides) > 0, axis=0) | np.all(np.array(sides) < 0, axis=0)).sum())
    return count


class Dropped(CommandLineTest):
    def run_on(self, case, cells):
        """The result's file, after checking what holds of every such run."""
        out, self.summary = self.run_case(CASES / f"{case}.toml", f"cloth.cells=[{cells}, {cells}]")
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            energy = {name: series[:] for name, series in result["frames/energy"].items()}
        # nothing comes from nothing, to 1 % of what was turned into heat
        self.assertGreater(energy["method_dissipated"].min(), -0.01 * energy["dissipated"][-1])
        return out

    def test_a_square_folded_in_four_has_four_layers(self):
        with h5py.File(self.run_on("fold_in_four", 20)) as result:
            x, quads = result["frames/position"][-1], result["mesh/quads"][:]
        low, high = x.min(axis=0)[:2], x.max(axis=0)[:2]
        # folded at the middle it would be 15 cm each way; creases are loops, and slide along the table as they close
        self.assertTrue((high - low < 0.22).all(), high - low)
        for share in (0.35, 0.5, 0.65):
            self.assertEqual(layers_over(x, quads, low + [0.7, share] * (high - low)), 4)

    def test_a_square_on_a_ball_hangs_from_it(self):
        out = self.run_on("square_on_sphere", 20)
        with h5py.File(out) as result:
            x, force = result["frames/position"][:], result["frames/obstacle_force/ball"][-40:]
        distance = np.linalg.norm(x - [0, 0, -0.2], axis=2).min()
        self.assertGreater(distance, 0.2 * (1 - 1e-3))
        # it still swings: the ball carries the weight in the mean over what is left of the two seconds
        self.assertLess(abs(force[:, 2].mean() / self.summary["weight_N"] - 1), 0.05)
        self.assertLess(x[-1, :, 2].min(), -0.35)

    def test_a_square_on_a_mesh_hangs_from_it(self):
        with h5py.File(self.run_on("cloth_on_pawn", 20)) as result:
            x = result["frames/position"][-1]
            force = sum(series[-10:] for series in result["frames/obstacle_force"].values())
        # its top, 22 cm high, carries the cloth's middle
        self.assertLess(abs(x[np.hypot(x[:, 0], x[:, 1]).argmin(), 2] - 0.22), 2e-3)
        # moving on by some 2 cm/s, which over a third of a second changes the force by 1 %; samples scatter
        self.assertLess(abs(force[:, 2].mean() / self.summary["weight_N"] - 1), 0.05)


if __name__ == "__main__":
    unittest.main()
