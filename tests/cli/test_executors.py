"""Runs of a study as processes of this machine: what a kill does to them, who is kept out, what an executor needs."""
import os
import unittest
from unittest import mock

from batches import BatchTest


class Local(BatchTest):
    def test_a_killed_worker_is_tried_again(self):
        self.survives_a_killed_worker("out", "--jobs", 2)

    def test_a_worker_that_is_killed_every_time_is_given_up(self):
        started = self.start(*self.words("out", "--jobs", 1, "--retries", 1))
        name = "limit=long,bending=2.h5"
        for _ in range(2):
            (worker,) = self.wait_for(lambda: self.workers("out", name))
            os.kill(worker, 9)
            self.wait_for(lambda worker=worker: worker not in self.workers("out", name))
        out = self.finish(started, "out")
        self.assertIn("failed: killed by signal 9, 2 times", out)

    def test_the_driver_may_be_killed(self):
        self.survives_a_killed_driver("out", "--jobs", 2)

    def test_a_second_driver_is_kept_out(self):
        started = self.start(*self.words("out"))
        self.wait_for(lambda: self.workers("out"))
        second = self.sundrape(*self.words("out"))
        self.assertEqual(second.returncode, 3, second.stderr)
        self.assertRegex(second.stderr, "another process is at work on it")
        self.finish(started, "out")

    def test_a_second_run_into_one_result_is_kept_out_or_waits(self):
        started = self.start("run", "strip.toml", "-o", "one.h5", "--quiet")
        self.wait_for(lambda: "one.h5.lock" in self.files())
        second = self.sundrape("run", "strip.toml", "-o", "one.h5", "--quiet", "--force")
        self.assertEqual(second.returncode, 3, second.stderr)
        self.assertIn("one.h5: another process is at work on it", second.stderr)
        self.done("run", "strip.toml", "-o", "one.h5", "--quiet", "--force", "--wait", 60)
        self.assertEqual(started.wait(60), 0)
        self.assertNotIn("one.h5.lock", self.files())


class Needs(BatchTest):
    def refused(self, executor, pattern):
        with mock.patch.dict(os.environ, {"PATH": str(self.folder)}):  # nothing is on it
            done = self.sundrape(*self.words("out", "--executor", executor))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, pattern)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_slurm_needs_its_commands(self):
        self.refused("slurm", "'sbatch' is not on the path: .*slurm-client")

    @unittest.skipIf(os.path.exists("/usr/lib/python3/dist-packages/distributed"), "Dask distributed is installed")
    def test_dask_needs_its_package(self):
        self.refused("dask", "python3-distributed")

    def test_another_executor_is_unknown(self):
        done = self.sundrape(*self.words("out", "--executor", "cloud"))
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
