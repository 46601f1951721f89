"""Studies on Slurm and on Dask, for real: a cluster of one node, and workers on this machine.

Needs root and `apt-get install slurm-wlm munge python3-distributed` (./dev setup cluster).
"""
import os
import signal
import subprocess
import time
import unittest

import slurm_cluster
from batches import BatchTest

PYTHON = "/usr/bin/python3"  # Debian's, whose packages are installed
HAS_DASK = os.path.exists(PYTHON) and not subprocess.run([PYTHON, "-c", "import distributed"], capture_output=True).returncode


@unittest.skipUnless(slurm_cluster.is_installed() and os.geteuid() == 0, "slurm-wlm is not installed, or this is not root")
class Slurm(BatchTest):
    WORDS = ("--executor", "slurm", "--jobs", 2, "--slurm-options", "--time=10 --comment=test")

    @classmethod
    def setUpClass(cls):
        slurm_cluster.start()
        cls.addClassCleanup(slurm_cluster.stop)

    def arrays(self, folder):
        return sorted(path.name for path in (self.folder / folder / "runs/.slurm").iterdir() if path.is_dir())

    def jobs(self):
        return slurm_cluster.call("squeue", "--noheader", "--array", "--format=%A %K %t").stdout.split("\n")[:-1]

    def test_the_table_is_that_of_one_process(self):
        expected = self.undisturbed()
        self.finish(self.start(*self.words("out", *self.WORDS)), "out")
        self.assertEqual(self.tables("out"), expected)
        self.assertEqual(self.arrays("out"), ["1"])  # each once

    def test_a_killed_worker_is_tried_again(self):
        self.survives_a_killed_worker("out", *self.WORDS)

    def test_a_job_that_is_cancelled_behind_our_back_is_tried_again(self):
        expected = self.undisturbed()
        started = self.start(*self.words("out", *self.WORDS))
        waiting = self.wait_for(lambda: [job for job in self.jobs() if job.endswith("PD") and "-" not in job])
        array, number, _ = waiting[-1].split()
        slurm_cluster.call("scancel", f"{array}")  # one task of the array, by its own number
        out = self.finish(started, "out")
        self.assertIn("its process was lost; trying again", out)
        self.assertEqual(self.tables("out"), expected)
        self.assertEqual(self.arrays("out"), ["1", "2"])

    def test_the_driver_may_be_killed_and_its_jobs_are_taken_over(self):
        self.survives_a_killed_driver("out", *self.WORDS)
        self.assertEqual(self.arrays("out"), ["1"])  # nothing was sent a second time

    def test_jobs_of_a_study_that_was_changed_meanwhile_are_cancelled(self):
        started = self.start(*self.words("out", *self.WORDS))
        self.wait_for(lambda: self.results("out"))
        started.kill()
        started.communicate()
        self.write("strip.toml", (self.folder / "strip.toml").read_text().replace("[60, 6]", "[50, 5]"))
        expected = self.undisturbed()
        self.finish(self.start(*self.words("out", *self.WORDS)), "out")
        self.assertEqual(self.tables("out"), expected)
        self.assertEqual(self.jobs(), [])

    def test_ctrl_c_clears_the_queue(self):
        started = self.start(*self.words("out", *self.WORDS))
        self.wait_for(lambda: self.workers("out"))
        started.send_signal(signal.SIGINT)
        _, err = started.communicate(timeout=60)
        self.assertEqual(started.returncode, 130, err)
        self.assertEqual(self.workers("out"), [])
        self.assertEqual(self.jobs(), [])


@unittest.skipUnless(HAS_DASK, "python3-distributed is not installed")
class Dask(BatchTest):
    WORDS = ("--executor", "dask", "--jobs", 2)

    def nannies_worker(self):
        """A worker process of Dask that carries out a run: the parent of its script's shell."""

        def parent(pid):
            with open(f"/proc/{pid}/stat") as stat:
                return int(stat.read().rsplit(")", 1)[1].split()[1])

        (first, *_) = self.wait_for(lambda: self.workers("out"))
        return parent(parent(first))

    def test_the_table_is_that_of_one_process(self):
        expected = self.undisturbed()
        self.finish(self.start(*self.words("out", *self.WORDS)), "out")
        self.assertEqual(self.tables("out"), expected)

    def test_a_killed_run_is_tried_again(self):
        self.survives_a_killed_worker("out", *self.WORDS)

    def test_a_killed_worker_is_tried_again(self):
        expected = self.undisturbed()
        started = self.start(*self.words("out", *self.WORDS))
        os.kill(self.nannies_worker(), signal.SIGKILL)
        out = self.finish(started, "out")
        self.assertIn("trying again", out)
        self.assertEqual(self.tables("out"), expected)

    def test_the_driver_may_be_killed(self):
        self.survives_a_killed_driver("out", *self.WORDS)

    def test_a_scheduler_that_runs_already(self):
        expected = self.undisturbed()
        scheduler = subprocess.Popen([PYTHON, "-m", "distributed.cli.dask_scheduler", "--port", "18786", "--no-dashboard"],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(scheduler.kill)
        worker = subprocess.Popen([PYTHON, "-m", "distributed.cli.dask_worker", "tcp://127.0.0.1:18786", "--nthreads", "2",
                                   "--no-dashboard", "--local-directory", str(self.folder)],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(worker.kill)
        time.sleep(2)
        self.finish(self.start(*self.words("out", "--executor", "dask", "--dask-scheduler", "tcp://127.0.0.1:18786")), "out")
        self.assertEqual(self.tables("out"), expected)

    def test_ctrl_c_stops_all(self):
        started = self.start(*self.words("out", *self.WORDS))
        self.wait_for(lambda: self.workers("out"))
        started.send_signal(signal.SIGINT)
        _, err = started.communicate(timeout=60)
        self.assertEqual(started.returncode, 130, err)
        self.assertEqual(self.workers("out"), [])


if __name__ == "__main__":
    unittest.main()
