"""Nodes that several supports hold, together or one after another: hinges, jaws, lifts and hands that come and go."""
import unittest

import h5py
from command_line import LOOSE_SHEET, CommandLineTest, set_options


class SharedSupports(CommandLineTest):
    def ends_alike(self, case, at, *sets):
        """Broken off at some times and taken on, a run ends where it does unbroken."""
        out, _ = self.run_case(case, *sets)
        with h5py.File(out) as result:
            end = result["frames/position"][-1]
        for first in at:
            self.run_case(case, *sets, f"dynamics.duration={first}", "output.frames=1")
            self.done("run", case, "-o", "out.h5", "--resume", "out.h5", *set_options(sets))
            with h5py.File(self.folder / "out.h5") as result:
                self.assertLess(abs(result["frames/position"][-1] - end).max(), 1e-4, first)

    def tip(self):
        with h5py.File(self.folder / "out.h5") as result:
            return result["frames/position"][-1, :, 2].min()

    def test_a_jaw_that_opens_or_closes_on_a_hinge_is_resumed_as_it_was(self):
        hinge = '[[fix]]\nnodes = "left"\ncomponents = ["x", "y", "z"]\n'
        opens = self.write("opens.toml", LOOSE_SHEET + hinge + '[[fix]]\nname = "jaw"\nnodes = "left"\nrelease = "0.25 s"\n')
        damped = ("material.damping.mass=20", "dynamics.rtol=1e-5")
        tips = {}
        for model in ("particle", "shell"):
            self.ends_alike(opens, (0.1, 0.4), f"model={model}", *damped)
            tips[model] = self.tip()
        always = self.write("always.toml", LOOSE_SHEET + '[[fix]]\nnodes = "left"\n')
        for model in ("particle", "shell"):  # both hang as from a hinge, lower than clamped
            self.run_case(always, f"model={model}", *damped)
            self.assertLess(tips[model], self.tip() - 1e-3)
        closes = '[[fix]]\nname = "jaw"\nnodes = "left"\ngrip = "0.1 s"\nrelease = "0.8 s"\n'
        self.ends_alike(self.write("closes.toml", LOOSE_SHEET + hinge + closes), (0.05, 0.4, 0.9), "model=shell", *damped)

    def test_a_clamp_that_another_support_holds_stays_when_one_opens(self):
        clamp = '[[fix]]\nnodes = "left"\ncomponents = ["x", "z", "rotation"]\n'
        jaw = '[[fix]]\nname = "jaw"\nnodes = "left"\nrelease = "0.25 s"\n'
        sets = ("material.damping.mass=20", "dynamics.duration=2")
        self.run_case(self.write("both.toml", LOOSE_SHEET + clamp + jaw), *sets)
        released = self.tip()
        self.run_case(self.write("clamp.toml", LOOSE_SHEET + clamp), *sets)
        self.assertAlmostEqual(released, self.tip(), delta=1e-4)

    def test_hands_that_come_and_go_leave_a_lift_where_it_is(self):
        lift = """[[motion]]
name = "lift"
nodes = "top"
components = ["z"]
path = { kind = "line", by = [0, 0, "1 cm"], duration = "0.9 s" }
[[motion]]
name = "hand"
nodes = "top"
components = ["x", "y"]
grip = "0.1 s"
release = "0.4 s"
path = { kind = "line", by = [0, "1 cm", "2 cm"], duration = "0.2 s" }
"""
        case = self.write("lift.toml", LOOSE_SHEET + lift)
        self.ends_alike(case, (0.05, 0.2, 0.6), "dynamics.rtol=1e-5")

    def test_what_is_held_for_good_no_gripper_takes_away(self):
        hand = """[[fix]]
nodes = "left"
[[motion]]
name = "hand"
nodes = NODES
grip = "0.1 s"
path = { kind = "line", by = [0, 0, "2 cm"], duration = "0.2 s" }
"""
        done = self.sundrape("check", self.write("hand.toml", LOOSE_SHEET + hand.replace("NODES", '"left"')))
        self.assertEqual(done.returncode, 2)
        self.assertIn("another support holds for good", done.stderr)
        here = '{ near = ["-5 cm", 0, 0] }'
        self.run_case(self.write("hand.toml", LOOSE_SHEET + hand.replace("NODES", here)), status=1)
        self.assertRegex(self.message, "'hand' grips node [0-9]+ at t = 0.1 s, which another support holds for good")


if __name__ == "__main__":
    unittest.main()
