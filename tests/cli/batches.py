"""A study of a dozen short runs, one of which fails, and what is done to it. For test_executors.py and verify_clusters.py."""
import os
import pathlib
import signal
import time

import h5py

from command_line import GRAVITY, MATERIAL, CommandLineTest

STRIP = f"""title = "A swinging strip"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["20 cm", "2 cm"]
cells = [60, 6]
{MATERIAL}
[[fix]]
nodes = "left"
{GRAVITY}
[dynamics]
rtol = 1e-6
duration = "0.3 s"
[output]
frames = 10
probes = [ {{ name = "tip", near = ["10 cm", "1 cm", 0] }} ]
"""

STUDY = """title = "Swings"
case = "strip.toml"
[[axis]]
name = "limit"
settings = [["dynamics.time_limit=600"], ["dynamics.time_limit=1e-3"]]
labels = ["long", "short"]
[[axis]]
key = "material.scale.bending"
values = { from = 0.5, to = 2, count = RUNS, spacing = "log" }
[[output]]
name = "tip"
value = "last(probe.tip.z)"
unit = "cm"
[[output]]
name = "steps"
value = "steps"
"""


class BatchTest(CommandLineTest):
    """Every run but one of the first half is to fail: `RUNS` of them run, and as many fail at once."""

    runs = 6

    def setUp(self):
        super().setUp()
        self.write("strip.toml", STRIP)
        self.write("study.toml", STUDY.replace("RUNS", str(self.runs)))

    def words(self, folder, *more):
        return "study", "study.toml", "-o", folder, *more

    def tables(self, folder):
        return [(self.folder / folder / name).read_bytes() for name in ("study.csv", "study.h5")]

    def undisturbed(self):
        """The tables of the study as one process after another makes them."""
        done = self.sundrape(*self.words("alone", "--jobs", 1))
        self.assertEqual(done.returncode, 1, done.stderr)  # half of the runs cannot be done
        return self.tables("alone")

    def finish(self, started, folder):
        """Waits for a study, which knows that some of its runs failed."""
        out, err = started.communicate(timeout=self.timeout)
        self.assertEqual(started.returncode, 1, out + err)
        return out

    def results(self, folder):
        """Names of results that are done, each with its file's own number: a result that is made anew is another file."""
        done = {}
        for path in (self.folder / folder / "runs").glob("*.h5"):
            try:
                with h5py.File(path) as result:
                    if result.attrs["status"] == b"done" or result.attrs["status"] == "done":
                        done[path.name] = path.stat().st_ino
            except (OSError, KeyError):
                pass  # it is being written
        return done

    def wait_for(self, happened, seconds=120):
        until = time.monotonic() + seconds
        while not (found := happened()):
            self.assertLess(time.monotonic(), until, "it takes too long")
            time.sleep(0.02)
        return found

    def workers(self, folder, name=""):
        """Processes that carry out a run of that study whose result is called so, or any run."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
                where = os.readlink(entry / "cwd")
            except OSError:
                continue
            mine = where == str(self.folder) and b"run" in words and any(w.startswith(f"{folder}/runs/{name}".encode()) for w in words)
            if mine and b"sh" not in pathlib.Path(words[0].decode()).name.encode():
                found.append(int(entry.name))
        return found

    def kill_a_worker(self, folder):
        os.kill(self.wait_for(lambda: self.workers(folder))[0], signal.SIGKILL)

    def survives_a_killed_worker(self, folder, *more):
        expected = self.undisturbed()
        started = self.start(*self.words(folder, *more))
        self.kill_a_worker(folder)
        out = self.finish(started, folder)
        self.assertIn("killed by signal 9; trying again", out)
        self.assertEqual(self.tables(folder), expected)

    def survives_a_killed_driver(self, folder, *more):
        """Whoever drives the study is killed half-way: what was done stays as it is, and the next one ends it."""
        expected = self.undisturbed()
        started = self.start(*self.words(folder, *more))
        self.wait_for(lambda: len(self.results(folder)) >= 2)
        started.kill()
        started.communicate()
        before = self.results(folder)
        self.assertLess(len(before), self.runs)
        self.finish(self.start(*self.words(folder, *more)), folder)
        self.assertEqual(self.tables(folder), expected)
        after = self.results(folder)
        self.assertEqual({name: after[name] for name in before}, before)
