"""A run that was killed, interrupted or stopped: its file is readable, and --resume takes it to the same end."""
import json
import random
import signal
import time
import unittest

import h5py
import numpy as np

from command_line import CommandLineTest, hanging

RTOL = 1e-5
LENGTH = 0.2  # [m]
# Each step errs by about RTOL times the way that a node goes, which is about LENGTH. The motion is damped and its end
# close to rest, so that such errors are forgotten in the end rather than summed up over all steps; an unbroken run ends
# 40 RTOL LENGTH from one with a tenth of RTOL. A resumed run takes other steps and may end this far from an unbroken one:
TOLERANCE = 100 * RTOL * LENGTH


class Resume(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.case = self.write("strip.toml", hanging(cells="[20, 4]", duration="2 s", rtol=RTOL, frames=50, more='linear_solver = "cg"',
                                                     output='checkpoint_every = "20 ms"'))

    def read(self, name):
        """Status, frames and whether a checkpoint is there, after checking what must hold of every file."""
        with h5py.File(self.folder / name) as result:
            count = len(result["frames/time"])
            frames = {what: result[f"frames/{what}"][:count] for what in ("time", "position", "velocity", "contact_force", "residual")}
            for what, values in frames.items():
                self.assertTrue(np.isfinite(values).all(), what)
            self.assertTrue((np.diff(frames["time"]) > 0).all())
            steps = result["steps/time"][...]
            self.assertTrue((np.diff(steps) > 0).all())
            slots = [slot["sequence"][0] for slot in result["checkpoint"].values()] if "checkpoint" in result else []
            return result.attrs["status"].decode(), frames, any(slots)

    def expect_same_end(self, name, whole):
        status, frames, _ = self.read(name)
        self.assertEqual(status, "done")
        np.testing.assert_array_equal(frames["time"], whole["time"])
        distance = np.linalg.norm(frames["position"][-1] - whole["position"][-1], axis=1).max()
        self.assertLess(distance, TOLERANCE)

    def unbroken(self):
        started = time.monotonic()
        self.done("run", self.case, "--quiet", "-o", "whole.h5", "--summary", "whole.json")
        return self.read("whole.h5")[1], time.monotonic() - started

    def test_ten_kills_at_random_moments(self):
        whole, seconds = self.unbroken()
        moments = random.Random(5)
        resumed = 0
        for number in range(10):
            name = f"killed{number}.h5"
            run = self.start("run", self.case, "--quiet", "-o", name)
            time.sleep(moments.uniform(0.1, 1) * seconds)
            run.kill()
            run.wait()
            with self.subTest(number):
                if not (self.folder / name).exists():
                    continue
                status, frames, has_checkpoint = self.read(name)
                self.assertIn(status, ("running", "done"))
                result = self.sundrape("run", self.case, "--quiet", "--resume", name)
                if not has_checkpoint:
                    self.assertEqual(result.returncode, 3)
                    self.assertRegex(result.stderr, f"^{name}: holds no checkpoint")
                    continue
                self.assertEqual(result.returncode, 0, result.stderr)
                self.expect_same_end(name, whole)
                resumed += 1
        self.assertGreater(resumed, 4)

    def interrupted(self, signal_number, name="broken.h5"):
        run = self.start("run", self.case, "-o", name, "--summary", "broken.json")
        while not (self.folder / name).exists():
            time.sleep(0.002)
        time.sleep(0.05)
        run.send_signal(signal_number)
        errors = run.communicate(timeout=30)[1]
        self.assertEqual(run.returncode, 130, errors)
        return errors

    def test_ctrl_c_leaves_a_checkpoint(self):
        whole, _ = self.unbroken()
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal_number):
                name = f"stopped{signal_number}.h5"
                errors = self.interrupted(signal_number, name)
                self.assertRegex(errors, r"^strip\.toml: interrupted at t = .* s: continue with --resume\n$")
                status, frames, has_checkpoint = self.read(name)
                self.assertEqual(status, "interrupted")
                self.assertTrue(has_checkpoint)
                self.assertLess(len(frames["time"]), len(whole["time"]))
                self.done("run", self.case, "--quiet", "--resume", name)
                self.expect_same_end(name, whole)

    def test_totals_are_those_of_all_parts(self):
        self.interrupted(signal.SIGINT)
        first = json.loads((self.folder / "broken.json").read_text())
        self.done("run", self.case, "--quiet", "--resume", "broken.h5", "-o", "on.h5", "--summary", "on.json")
        both = json.loads((self.folder / "on.json").read_text())
        with h5py.File(self.folder / "on.h5") as result:
            self.assertEqual(both["steps"], len(result["steps/time"]))
            self.assertEqual(both["newton_iterations"], result["steps/newton_iterations"][...].sum())
            self.assertEqual(both["frames"], len(result["frames/time"]))
            self.assertEqual(result["statistics"].attrs["steps"], both["steps"])
            # the books go on where they were: no energy appears or vanishes at the seam
            lost = result["frames/energy/method_dissipated"][...]
            self.assertLess(np.abs(np.diff(lost)).max(), 1e-3 * both["weight_N"] * LENGTH)
        for name in ("steps", "newton_iterations", "linear_iterations", "force_evaluations", "wall_seconds", "cpu_seconds"):
            self.assertGreater(both[name], first[name], name)
        for name in ("largest_edge_strain", "sharpest_bend_deg"):
            self.assertGreaterEqual(both[name], first[name], name)

    def test_a_finished_run_is_taken_further(self):
        self.done("run", self.case, "--quiet", "-o", "short.h5", "--set", "dynamics.duration='0.4 s'", "--set", "output.frames=4")
        self.done("run", self.case, "--quiet", "--resume", "short.h5", "-o", "long.h5", "--set", "dynamics.duration='0.8 s'", "--set", "output.frames=8")
        np.testing.assert_allclose(self.read("long.h5")[1]["time"], 0.1 * np.arange(9), atol=1e-12)
        self.done("run", self.case, "--quiet", "--resume", "long.h5", "--set", "dynamics.duration='0.8 s'", "--set", "output.frames=8", "--summary", "again.json")
        again = json.loads((self.folder / "again.json").read_text())
        with h5py.File(self.folder / "long.h5") as result:  # nothing was left to do, and nothing is lost
            self.assertEqual(len(result["frames/time"]), 9)
            self.assertEqual(again["final"]["energy_J"]["kinetic"], result["frames/energy/kinetic"][-1])
            np.testing.assert_array_equal(again["final"]["reaction_N"]["hand"], result["frames/reaction/hand"][-1])

    def test_every_integrator_with_a_memory_of_its_own_takes_up_what_was_left(self):
        for integrator in ("ida", "dirk"):
            with self.subTest(integrator):
                def run(name, duration, frames, *more):
                    self.done("run", self.case, "--quiet", "--set", f"dynamics.integrator={integrator}", "--set", f"dynamics.duration={duration}",
                              "--set", f"output.frames={frames}", "-o", name, *more)
                run(f"{integrator}_whole.h5", 2, 10)
                run(f"{integrator}_half.h5", 1, 5)
                run(f"{integrator}_both.h5", 2, 10, "--resume", f"{integrator}_half.h5")
                self.expect_same_end(f"{integrator}_both.h5", self.read(f"{integrator}_whole.h5")[1])

    def test_what_cannot_be_resumed_is_named(self):
        self.done("run", self.case, "--quiet", "-o", "short.h5", "--set", "dynamics.duration='10 ms'", "--set", "output.frames=1")
        for settings, reason in ((["--set", "cloth.cells=[10, 2]"], "mesh"), (["--set", "analysis=relaxation"], "relaxation")):
            with self.subTest(settings):
                result = self.sundrape("run", self.case, "--resume", "short.h5", "-o", "on.h5", *settings)
                self.assertEqual(result.returncode, 3)
                self.assertRegex(result.stderr, f"^short\\.h5: .*{reason}")
                self.assertFalse((self.folder / "on.h5").exists())

    def test_a_result_without_a_checkpoint_says_so(self):
        self.done("run", self.case, "--quiet", "-o", "short.h5", "--set", "dynamics.duration='10 ms'", "--set", "output.frames=1")
        with h5py.File(self.folder / "short.h5", "r+") as result:  # as if killed before the first step's end
            for slot in result["checkpoint"].values():
                slot["sequence"][...] = 0
        result = self.sundrape("run", self.case, "--resume", "short.h5")
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"^short\.h5: holds no checkpoint")


if __name__ == "__main__":
    unittest.main()
