"""When an analysis fails: exit status 1, a message that says where and what to try, and a readable result."""
import json
import unittest

import h5py
import numpy as np

from command_line import SHEET, CommandLineTest, hanging


class Failures(CommandLineTest):
    def failed(self, *arguments, pattern):
        result = self.sundrape(*arguments)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertRegex(result.stderr, pattern)
        return result

    def result(self, name):
        file = h5py.File(self.folder / name)
        self.addCleanup(file.close)
        return file

    def test_runge_kutta_above_its_stability_limit_blows_up_and_says_so(self):
        case = self.write("strip.toml", hanging())
        told = self.failed("run", case, "--set", "dynamics.integrator=rk4", "--set", "dynamics.step='2 ms'",
                           pattern=r"^strip\.toml: .*blown up at t = .* s with a step of 0\.002 s.*try a smaller dynamics\.step")
        self.assertRegex(told.stdout, r"warning: dynamics\.step = 0\.002 s is above the stability limit of \d")
        result = self.result("strip.h5")
        self.assertEqual(result.attrs["status"], b"failed")
        self.assertIn(b"blown up", result.attrs["message"])
        # the state before the step that failed is kept, to look at and to go on from
        self.assertGreater(len(result["frames/time"]), 1)
        self.assertTrue(np.isfinite(result["frames/position"][...]).all())
        self.assertEqual(result["frames/time"][-1], result["steps/time"][-1])
        self.done("run", case, "--quiet", "--resume", "strip.h5", "-o", "on.h5", "--set", "dynamics.duration='10 ms'")

    def test_relaxation_that_may_not_iterate_says_where_it_stands(self):
        case = self.write("sheet.toml", SHEET.replace('"dynamics"', '"relaxation"'))
        self.failed("run", case, "--set", "relaxation.max_iterations=3",
                    pattern=r"^sheet\.toml: relaxation has not converged after 3 iterations: residual .* at node \d+; raise relaxation\.max_iterations")
        result = self.result("sheet.h5")
        self.assertEqual(result.attrs["status"], b"failed")
        self.assertEqual(len(result["steps/time"]), 3)
        self.assertEqual(result["frames/time"][-1], result["steps/time"][-1])

    def test_a_failed_relaxation_can_be_resumed_to_the_same_equilibrium(self):
        case = self.write("sheet.toml", SHEET.replace('"dynamics"', '"relaxation"'))
        self.done("run", case, "--quiet", "-o", "whole.h5", "--summary", "whole.json")
        whole = json.loads((self.folder / "whole.json").read_text())
        self.assertGreater(whole["iterations"], 8)
        self.sundrape("run", case, "-o", "parts.h5", "--set", "relaxation.max_iterations=7")
        self.done("run", case, "--quiet", "--resume", "parts.h5", "--summary", "parts.json")
        parts = json.loads((self.folder / "parts.json").read_text())
        self.assertEqual(parts["iterations"], len(self.result("parts.h5")["steps/time"]))
        time = self.result("parts.h5")["frames/time"][...]
        self.assertTrue((np.diff(time) > 0).all(), time)
        # both are equilibria of the pinned sheet; their distance is of the tolerance's size
        difference = self.result("whole.h5")["frames/position"][-1] - self.result("parts.h5")["frames/position"][-1]
        self.assertLess(np.abs(difference).max(), 1e-6)

    def test_a_relaxation_that_stops_on_a_coarser_mesh_can_be_resumed_on_its_own(self):
        # The edge of its sheet is held and nothing else touches it: one equilibrium, however it is reached.
        case = self.write("curtain.toml", SHEET.replace('"dynamics"', '"relaxation"')
                          .replace("cells = [4, 3]", "cells = [24, 18]")
                          .replace('nodes = { near = [0, 0, 0] }\ncomponents = ["x", "y"]', 'nodes = "top"')
                          .replace('[[obstacle]]\nkind = "plane"\n', ""))
        self.done("run", case, "--quiet", "-o", "whole.h5", "--summary", "whole.json")
        whole = json.loads((self.folder / "whole.json").read_text())
        self.assertEqual(whole["coarse_meshes"], 1)
        self.failed("run", case, "-o", "parts.h5", "--set", "relaxation.time_limit='1 us'", pattern=r"time limit of 1e-06 s reached .*--resume")
        with self.result("parts.h5") as parts:
            self.assertEqual(parts["frames/position"].shape[:2], (2, 25 * 19))
            self.assertEqual(len(parts["steps/time"]), 0)
        self.done("run", case, "--quiet", "--resume", "parts.h5")
        self.done("run", case, "--quiet", "-o", "plain.h5", "--set", 'relaxation.continuation="off"', "--summary", "plain.json")
        self.assertNotIn("coarse_meshes", json.loads((self.folder / "plain.json").read_text()))
        for name in ("parts.h5", "plain.h5"):
            self.assertTrue((np.diff(self.result(name)["frames/time"]) > 0).all())
            difference = self.result("whole.h5")["frames/position"][-1] - self.result(name)["frames/position"][-1]
            self.assertLess(np.abs(difference).max(), 1e-5)  # of a sheet that hangs down 3 cm, to residuals of 1e-6

    def test_loads_with_a_ramp_have_their_full_size_in_a_relaxation(self):
        case = self.write("sheet.toml", SHEET.replace('"dynamics"', '"relaxation"').replace("-9.80665]", '-9.80665]\nramp = "1 s"'))
        self.done("run", case, "--quiet", "--summary", "sheet.json")
        summary = json.loads((self.folder / "sheet.json").read_text())
        self.assertAlmostEqual(summary["final"]["contact_force_sum_N"][2] / summary["weight_N"], 1, delta=1e-4)

    def test_a_time_limit_ends_a_run_that_can_be_resumed(self):
        case = self.write("strip.toml", hanging(cells="[40, 10]"))
        self.failed("run", case, "--set", "dynamics.time_limit='0.2 s'", pattern=r"^strip\.toml: time limit of 0\.2 s reached at t = .*--resume")
        result = self.result("strip.h5")
        self.assertEqual(result.attrs["status"], b"failed")
        stopped = result["steps/time"][-1]
        self.assertLess(stopped, 1)
        result.close()
        self.done("run", case, "--quiet", "--resume", "strip.h5", "-o", "on.h5", "--set", f"dynamics.duration='{stopped + 0.005} s'")
        self.assertGreater(self.result("on.h5")["steps/time"][-1], stopped)


if __name__ == "__main__":
    unittest.main()
