"""Obstacles that move cloth or run into it, and obstacles that are meshes."""
import subprocess
import sys
import unittest

import h5py
import numpy as np
from command_line import CASES, LOOSE_SHEET, CommandLineTest


class MovingObstacles(CommandLineTest):
    def test_a_plate_folds_cloth_up(self):
        out, summary = self.run_case(CASES / "folding_plate.toml")
        with h5py.File(out) as result:
            table, plate = (result[f"frames/obstacle_force/{name}"][-1] for name in ("table", "plate"))
            edge = result["frames/position"][-1, -1]
        weight = summary["weight_N"]
        self.assertLess(abs(table[2] + plate[2] - weight), 0.01 * weight)
        self.assertLess(abs(table[0] + plate[0]), 0.01 * weight)
        self.assertGreater(edge[2], 0.05)  # it stands
        energy = summary["final"]["energy_J"]
        self.assertLess(abs(energy["method_dissipated"]), 0.01 * energy["external_work"])

    def test_a_rod_lifts_cloth_to_where_it_hangs(self):
        """Held against the cloth hung over the rod at once, and that against theory (verification)."""
        middle, corner = 220, 20

        def hanging(path):
            with h5py.File(path) as result:
                x = result["frames/position"][-1]
                return x[corner] - x[middle]

        self.run_case(CASES / "diagonal_rod.toml")
        (self.folder / "out.h5").rename(self.folder / "hung.h5")
        lifted, _ = self.run_case(CASES / "diagonal_rod_lifted.toml")
        self.assertLess(np.linalg.norm(hanging(lifted) - hanging(self.folder / "hung.h5")), 1e-4)

    def test_an_obstacle_that_runs_into_held_cloth(self):
        ball = """[[fix]]
nodes = "boundary"
[[obstacle]]
kind = "sphere"
name = "ball"
radius = "2 cm"
place = { translate = ["5 cm", 0, "-2.1 cm"] }
motion = { kind = "line", by = [0, 0, "3 cm"], duration = "1 s" }
"""
        case = self.write("ball.toml", LOOSE_SHEET + ball)
        self.run_case(case, status=1)
        self.assertRegex(self.message, "obstacle 'ball' and held cloth run into each other: node")


class MeshObstacles(CommandLineTest):
    def test_a_cloth_rests_on_a_mesh_that_carries_its_weight(self):
        corners = [(x, y, z) for z in (-4, 0) for y in (-3, 3) for x in (-6, 6)]
        faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
        lines = [f"v {x} {y} {z}" for x, y, z in corners] + ["f " + " ".join(map(str, face)) for face in faces]
        self.write("block.obj", "\n".join(lines) + "\n")
        block = '[[obstacle]]\nkind = "mesh"\nfile = "block.obj"\nunits = "cm"\nfriction = 0.3\n'
        out, summary = self.run_case(self.write("block.toml", LOOSE_SHEET + block))
        force = summary["final"]["contact_force_sum_N"]
        self.assertLess(abs(force[2] - summary["weight_N"]), 1e-3 * summary["weight_N"])
        with h5py.File(out) as result:
            self.assertEqual(result["obstacles/mesh0/triangles"].shape, (12, 3))

    def test_the_ring_is_what_its_script_writes(self):
        script = CASES / "obstacles" / "ring.py"
        subprocess.run([sys.executable, script], cwd=self.folder, check=True)
        kept, again = (path.read_text().split() for path in (script.with_name("ring.obj"), self.folder / "ring.obj"))
        self.assertEqual(len(kept), len(again))
        for word, other in zip(kept, again):  # the last digit is the mathematics library's
            if word != other and "." in word:
                self.assertAlmostEqual(float(word), float(other), delta=2e-6)
            elif "." not in word:
                self.assertEqual(word, other)

    def test_a_napkin_lies_on_the_torus_that_its_ring_stands_for(self):
        out, summary = self.run_case(CASES / "cloth_on_ring.toml")
        energy = summary["final"]["energy_J"]
        self.assertLess(abs(energy["method_dissipated"]), 0.01 * energy["dissipated"])
        force = summary["final"]["contact_force_sum_N"]
        self.assertLess(abs(force[2] - summary["weight_N"]), 1e-3 * summary["weight_N"])
        with h5py.File(out) as result:
            x, y, z = result["frames/position"][-1].T
        gap = np.hypot(np.hypot(x, y) - 0.07, z) - 0.025
        # facets lie up to 95 mm (1 - cos(pi/64)) + 25 mm (1 - cos(pi/32)) = 0.23 mm below the torus
        self.assertGreater(gap.min(), -0.25e-3)
        self.assertLess(gap.min(), 0.05e-3)


if __name__ == "__main__":
    unittest.main()
