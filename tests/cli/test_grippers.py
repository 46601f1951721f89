"""Supports that carry cloth along, and that close and open: what is lifted, torn, let go and missed."""
import unittest

import h5py
import numpy as np
from command_line import CASES, LOOSE_SHEET, CommandLineTest


class Grippers(CommandLineTest):
    LIFT = """[[motion]]
nodes = "top"
components = ["x", "y", "z"]
path = { kind = "line", by = [0, 0, "5 cm"], duration = "0.5 s" }
"""

    def test_a_lifted_sheet_hangs_on_its_gripper(self):
        case = self.write("lift.toml", LOOSE_SHEET + self.LIFT)
        for sets in (["analysis=relaxation"], ["dynamics.duration=6"]):
            with self.subTest(sets=sets):
                out, summary = self.run_case(case, *sets)
                with h5py.File(out) as result:
                    reaction = result["frames/reaction/top"][-1]
                self.assertLess(abs(reaction[2] + summary["weight_N"]), 1e-4 * summary["weight_N"])

    def test_grippers_that_part_tear_the_cloth(self):
        pull = self.LIFT.replace('[0, 0, "5 cm"]', '[0, "5 cm", 0]')
        case = self.write("tear.toml", LOOSE_SHEET + pull + '[[fix]]\nnodes = "bottom"\n')
        for analysis in ("dynamics", "relaxation"):
            with self.subTest(analysis=analysis):
                out, summary = self.run_case(case, f"analysis={analysis}", status=1)
                self.assertIn("the cloth tears", self.message)
                self.assertIn("breaking_strain", self.message)
                with h5py.File(out) as result:
                    self.assertEqual(result.attrs["status"].decode(), "failed")
                    self.assertIn("checkpoint", result)
                    self.assertGreater(len(result["frames/time"]), 0)

    def test_cloth_that_is_let_go_falls(self):
        """Its centre of mass falls g t²/2, whatever else it does."""
        held = '[[fix]]\nnodes = "top"\nrelease = "0.25 s"\n'
        case = self.write("drop.toml", LOOSE_SHEET + held)
        for more in (["model=particle"], ["model=shell"], ["dynamics.integrator=ida", "shell.director=massless"]):
            with self.subTest(more=more):
                sets = [*more, "material.damping.mass=0", "output.frames=20"]
                if "shell.director=massless" in more:
                    sets.append("model=shell")
                out, summary = self.run_case(case, *sets)
                with h5py.File(out) as result:
                    time, z = result["frames/time"][:], result["frames/position"][:, :, 2]
                    reaction = result["frames/reaction/top"][:]
                nodes = np.outer([0.5] + 3 * [1] + [0.5], [0.5] + 7 * [1] + [0.5]).ravel()  # tributary areas
                centre = z @ nodes / nodes.sum()
                free = time >= 0.25
                since = time[free] - 0.25
                start = np.polyfit(since, centre[free] + 0.5 * 9.80665 * since**2, 1)
                self.assertLess(abs(np.polyval(start, since) - centre[free] - 0.5 * 9.80665 * since**2).max(), 1e-4)
                self.assertGreater(abs(reaction[~free][1:, 2]).min(), 0)
                self.assertEqual(abs(reaction[time > 0.25]).max(), 0)
                energy = summary["final"]["energy_J"]
                self.assertLess(abs(energy["method_dissipated"]), 0.01 * abs(energy["gravity"]))

    def test_a_gripper_that_closes_on_lying_cloth_lifts_it(self):
        table = '[[obstacle]]\nkind = "plane"\n'
        hand = """[[motion]]
name = "hand"
nodes = { box = [["-6 cm", "2 cm", "-1 cm"], ["6 cm", "3 cm", "1 cm"]] }
grip = "0.1 s"
path = { kind = "line", by = [0, 0, "8 cm"], duration = "0.5 s" }
"""
        case = self.write("lift.toml", LOOSE_SHEET + table + hand)
        whole, summary = self.run_case(case, "dynamics.duration=5")
        with h5py.File(whole) as result:
            reaction = result["frames/reaction/hand"][:]
            end = result["frames/position"][-1]
        self.assertEqual(abs(reaction[0]).max(), 0)
        self.assertLess(abs(reaction[-1, 2] + summary["weight_N"]), 1e-4 * summary["weight_N"])
        self.assertAlmostEqual(end[:, 2].max(), 0.08, delta=1e-4)  # from where it lay, 0.05 mm above the table
        # taken further while the gripper is closed, and from before it was
        for first in (0.05, 0.4, 2):
            self.run_case(case, f"dynamics.duration={first}", "output.frames=1")
            (self.folder / "out.h5").rename(self.folder / "part.h5")
            self.done("run", case, "-o", "part.h5", "--resume", "part.h5", "--set", "dynamics.duration=5")
            with h5py.File(self.folder / "part.h5") as result:
                self.assertLess(abs(result["frames/position"][-1] - end).max(), 1e-4)

    def test_statics_have_nothing_to_say_about_grips(self):
        case = self.write("grip.toml", LOOSE_SHEET + '[[fix]]\nnodes = "left"\nrelease = "0.5 s"\n')
        done = self.sundrape("crosscheck", case)
        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing to check this case against", done.stderr)

    def test_a_grip_on_nothing_says_where_the_cloth_is(self):
        for nodes in ('{ near = ["5 cm", 0, "5 cm"] }', '{ box = [[1, 1, 1], [2, 2, 2]] }'):
            hand = f'[[fix]]\nname = "hand"\nnodes = {nodes}\ngrip = "0.1 s"\n[[fix]]\nnodes = "left"\n'
            case = self.write("miss.toml", LOOSE_SHEET + hand)
            self.run_case(case, status=1)
            self.assertRegex(self.message, "'hand' grips nothing at t = 0.1 s.*The cloth is then between")
            with h5py.File(self.folder / "out.h5") as result:
                self.assertIn("checkpoint", result)
                self.assertAlmostEqual(result["frames/time"][-1], 0.1)
            again = self.sundrape("run", case, "-o", "out.h5", "--resume", "out.h5")
            self.assertEqual(again.returncode, 1)
            self.assertIn("grips nothing", again.stderr)

    def test_a_net_holds_no_slope_that_it_grips_later(self):
        hand = '[[fix]]\nnodes = "left"\ncomponents = ["x", "rotation"]\ngrip = "0.1 s"\n'
        done = self.sundrape("check", self.write("slope.toml", LOOSE_SHEET + hand))
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "'rotation' with a `grip` needs model")

    def test_two_grippers_carry_a_napkin_along(self):
        out, summary = self.run_case(CASES / "pick_and_place.toml", "dynamics.rtol=1e-4")
        with h5py.File(out) as result:
            start, end = result["frames/position"][0], result["frames/position"][-1]
        self.assertLess(end[:, 2].max(), 1e-3)  # flat again
        moved = end - start
        self.assertAlmostEqual(moved[:, 0].mean(), 0.39, delta=0.005)
        self.assertLess(abs(moved[:, 1]).max(), 0.005)


if __name__ == "__main__":
    unittest.main()
