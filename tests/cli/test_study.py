"""Studies: what they run, sort, write and say; what they do with runs that fail or are stopped."""
import csv
import json
import signal
import time
import unittest

import h5py
import numpy as np

from command_line import GRAVITY, MATERIAL, CommandLineTest

# A strip held at its end and beyond its middle; the mirror across its width is the one symmetry that these leave.
STRIP = f"""title = "A strip between two hands"
analysis = "relaxation"
[cloth]
shape = "rectangle"
size = ["20 cm", "2 cm"]
cells = [12, 2]
waviness = {{ amplitude = "0.1 mm", seed = 1 }}
{MATERIAL}
[[fix]]
name = "left hand"
nodes = "left"
[[fix]]
name = "right hand"
nodes = {{ near = ["5 cm", 0, 0] }}
{GRAVITY}
[output]
probes = [ {{ name = "tip", near = ["10 cm", "1 cm", 0] }} ]
"""

STUDY = """title = "Strips"
case = "strip.toml"
[[axis]]
key = "cloth.waviness.seed"
values = { from = 1, to = 3 }
"""


class Study(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("strip.toml", STRIP)

    def study(self, text=STUDY, *more, **options):
        return self.sundrape("study", self.write("study.toml", text), "-o", "out", "--jobs", 2, *more, **options)

    def report(self):
        return json.loads((self.folder / "out/study.json").read_text())

    def rows(self, name):
        with (self.folder / "out" / name).open() as file:
            return list(csv.DictReader(file))


class Drapes(Study):
    def test_seeds_of_one_drape(self):
        done = self.study()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Strips: 3 of 3 runs are done", done.stdout)
        self.assertIn("one drape of 3 runs, up to 2 symmetries of the case", done.stdout)  # the strip's own mirror
        self.assertIn("sundrape_postproc drapes out -o out/drapes.png", done.stdout)
        group, = self.report()["groups"]
        drape, = group["drapes"]
        self.assertEqual((drape["count"], drape["runs"]), (3, ["seed=1", "seed=2", "seed=3"]))
        self.assertEqual(drape["negative_pivots"], 0)
        self.assertLess(drape["residual"], 1e-6)  # relaxation.tolerance
        self.assertAlmostEqual(group["diagonal_m"], float(np.hypot(0.2, 0.02)), places=12)

    def test_the_tables_say_what_the_results_say(self):
        self.assertEqual(self.study().returncode, 0)
        rows = self.rows("study.csv")
        self.assertEqual([(r["run"], r["cloth.waviness.seed"], r["status"], r["drape"]) for r in rows],
                         [(f"seed={k}", str(k), "done", "1") for k in (1, 2, 3)])
        for row in rows:
            with h5py.File(self.folder / f"out/runs/{row['run']}.h5") as result:
                kinds = ("membrane", "shear", "bending", "gravity", "contact")
                stored = sum(result[f"frames/energy/{kind}"][-1] for kind in kinds)
                tip = result["frames/position"][-1][result["probes/tip"].attrs["node"]]
                self.assertAlmostEqual(float(row["total_energy_J"]), stored, delta=1e-9 * abs(stored))
                np.testing.assert_allclose([float(row[f"tip.{k}_m"]) for k in "xyz"], tip, rtol=1e-8, atol=1e-12)
        line, = self.rows("drapes.csv")
        self.assertEqual((line["drape"], line["count"], line["runs"]), ("1", "3", "1 2 3"))

    def test_axes_that_change_the_case_make_groups(self):
        text = STUDY + '[[axis]]\nkey = "material.thickness"\nvalues = ["0.5 mm", "1 mm"]\n'
        done = self.study(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = self.report()
        self.assertEqual(report["group_by"], ["material.thickness"])
        self.assertEqual([(g["values"], sum(d["count"] for d in g["drapes"])) for g in report["groups"]],
                         [(["0.5 mm"], 3), (["1 mm"], 3)])
        self.assertEqual(len(report["runs"]), 6)
        self.assertIn('material.thickness = 1 mm: one drape of 3 runs', done.stdout)

    def test_a_smaller_threshold_tells_more_apart(self):
        # thicknesses in one group differ by far more than 0.01 % of the diagonal
        text = STUDY.replace("waviness.seed", "waviness.amplitude").replace("{ from = 1, to = 3 }", '["0.1 mm", "0.2 mm"]')
        text += '[[axis]]\nkey = "material.thickness"\nvalues = ["0.5 mm", "1 mm"]\n[branches]\ngroup_by = []\n'
        self.assertEqual(self.study(text + "same_shape = 1e-4\n").returncode, 0)
        self.assertEqual([d["count"] for d in self.report()["groups"][0]["drapes"]], [2, 2])
        self.assertEqual(self.study(text + "same_shape = 1.0\n").returncode, 0)
        self.assertEqual([d["count"] for d in self.report()["groups"][0]["drapes"]], [4])


class Runs(Study):
    def test_finished_runs_are_used_again_and_others_are_not(self):
        self.assertEqual(self.study().returncode, 0)
        files = {p.name: p.stat().st_mtime_ns for p in (self.folder / "out/runs").glob("*.h5")}
        (self.folder / "out/runs/seed=2.h5").unlink()
        again = self.study(STUDY.replace("to = 3", "to = 4"))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("2 of 4 results are there already", again.stdout)
        for name in ("seed=1.h5", "seed=3.h5"):
            self.assertEqual((self.folder / "out/runs" / name).stat().st_mtime_ns, files[name])
        self.assertEqual([run["reused"] for run in self.report()["runs"]], [True, False, True, False])
        # another case: none of them will do
        self.write("strip.toml", STRIP.replace("12, 2", "10, 2"))
        self.assertNotIn("there already", self.study().stdout)

    def test_a_run_that_fails_is_reported_and_takes_no_other_with_it(self):
        text = STUDY.replace("cloth.waviness.seed", "relaxation.max_iterations").replace("{ from = 1, to = 3 }", "[2000, 3]")
        done = self.study(text)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("1 of 2 runs are done", done.stdout)
        self.assertRegex(done.stdout, "failed: max_iterations=3: .*has not converged")
        self.assertEqual([r["status"] for r in self.rows("study.csv")], ["done", "failed"])
        self.assertIn("has not converged", self.report()["runs"][1]["message"])

    def test_the_children_stop_with_it_and_the_next_time_goes_on(self):
        slow = STRIP.replace("[12, 2]", "[200, 60]").replace('analysis = "relaxation"', 'analysis = "dynamics"')
        self.write("strip.toml", slow + "[dynamics]\nduration = 2\n")
        started = self.start("study", self.write("study.toml", STUDY), "-o", "out", "--jobs", 2)
        runs = self.folder / "out/runs"
        self.wait_for(lambda: len(self.with_a_checkpoint(runs)) == 2)
        started.send_signal(signal.SIGINT)
        out, err = started.communicate(timeout=60)
        self.assertEqual(started.returncode, 130, err)
        self.assertIn("interrupted: 0 of 3 runs are done", err)
        for name in ("seed=1", "seed=2"):
            with h5py.File(runs / f"{name}.h5") as result:
                self.assertEqual(result.attrs["status"].decode(), "interrupted")
        self.assertFalse((self.folder / "out/study.json").exists())
        self.assertFalse((runs / "seed=3.h5").exists())

    def test_after_a_kill_it_goes_on_where_it_was(self):
        slow = STRIP.replace("[12, 2]", "[60, 10]").replace('analysis = "relaxation"', 'analysis = "dynamics"')
        self.write("strip.toml", slow + "[dynamics]\nduration = 0.3\n")
        study = "resume = true\n" + STUDY.replace("to = 3", "to = 1")
        started = self.start("study", self.write("study.toml", study), "-o", "out")
        runs = self.folder / "out/runs"
        self.wait_for(lambda: self.with_a_checkpoint(runs))
        started.kill()
        started.communicate()
        self.wait_for(lambda: self.status(runs / "seed=1.h5") != "running")  # its child is asked to stop, and does
        done = self.study(study)
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(runs / "seed=1.h5") as result:
            self.assertEqual(result["frames/time"][-1], 0.3)
            self.assertEqual(len(result["frames/time"]), 61)  # output.frames = 60 and the start: no frame twice

    def test_a_table_does_not_tell_that_a_run_was_stopped_on_the_way(self):
        slow = STRIP.replace("[12, 2]", "[60, 10]").replace('analysis = "relaxation"', 'analysis = "dynamics"')
        self.write("strip.toml", slow + "[dynamics]\nduration = 0.3\n")
        study = STUDY.replace("to = 3", "to = 2") + '[[output]]\nname = "tip"\nvalue = "last(probe.tip.z)"\n' \
            '[[output]]\nname = "steps"\nvalue = "steps"\n'
        started = self.start("study", self.write("study.toml", study), "-o", "out", "--jobs", 2)
        runs = self.folder / "out/runs"
        self.wait_for(lambda: self.with_a_checkpoint(runs))
        started.kill()
        started.communicate()
        self.wait_for(lambda: all(self.status(runs / f"seed={k}.h5") != "running" for k in (1, 2)))
        self.assertFalse((self.folder / "out/study.csv").exists())
        tables = []
        for _ in range(2):  # after the kill, and undisturbed in a folder that is not there yet
            self.assertEqual(self.study(study).returncode, 0)
            tables.append([(self.folder / "out" / name).read_bytes() for name in ("study.csv", "study.h5")])
            (self.folder / "out").rename(self.folder / f"out{len(tables)}")
        self.assertEqual(*tables)

    def wait_for(self, happened, seconds=60):
        until = time.monotonic() + seconds
        while not happened():
            self.assertLess(time.monotonic(), until, "it takes too long")
            time.sleep(0.02)

    def status(self, path):
        try:
            with h5py.File(path) as result:
                return result.attrs["status"].decode()
        except (OSError, KeyError):  # it is being renamed
            return "running"

    def with_a_checkpoint(self, folder):
        def ready(path):
            try:
                with h5py.File(path) as result:
                    return any(slot["sequence"][0] > 0 for slot in result["checkpoint"].values())
            except (OSError, KeyError):
                return False

        return [path for path in folder.glob("*.h5") if ready(path)]


class Refusals(Study):
    def refused(self, text, status, pattern):
        done = self.study(text)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertRegex(done.stderr, pattern)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_bad_study(self):
        self.refused(STUDY.replace("key =", "kee ="), 2, "^study.toml:4: axis.0.kee: unknown key, did you mean 'key'")

    def test_a_value_that_the_case_does_not_take(self):
        self.refused(STUDY.replace("{ from = 1, to = 3 }", "[1, -2]"), 2,
                     r"^study.toml:5: axis.0.values: cloth.waviness.seed = -2: -2 is outside \[0, ")

    def test_a_key_that_the_case_does_not_have(self):
        self.refused(STUDY.replace("waviness.seed", "waviness.sede"), 2,
                     "^study.toml:5: axis.0.values: .*unknown key, did you mean 'seed'")

    def test_a_bad_case(self):
        self.write("strip.toml", STRIP.replace("poisson = 0.3", "poisson = 3"))
        self.refused(STUDY, 2, "strip.toml:.*material.poisson: 3 is outside")

    def test_a_case_that_cannot_be_built(self):
        self.write("strip.toml", STRIP.replace('nodes = "left"', 'nodes = "hem"'))
        self.refused(STUDY, 2, "strip.toml:.*fix.0.nodes:.*hem")

    def test_meshes_that_cannot_be_compared(self):
        text = STUDY + '[[axis]]\nkey = "cloth.cells"\nvalues = [[6, 1], [8, 1]]\n[branches]\ngroup_by = []\n'
        done = self.study(text)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, "study.toml: branches.group_by: .* cannot be compared: .*name the axis")
        self.assertFalse((self.folder / "out").exists())  # said before anything has run

    def test_models_that_cannot_be_compared(self):
        text = STUDY + '[[axis]]\nkey = "model"\nvalues = ["particle", "shell"]\n[branches]\ngroup_by = []\n'
        self.refused(text, 2, "study.toml: branches.group_by: .* cannot be compared: one is a particle net")

    def test_results_of_others_are_not_written_over(self):
        (self.folder / "out/runs").mkdir(parents=True)
        self.write("out/runs/seed=1.h5", "somebody's")
        done = self.study()
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, "seed=1.h5: exists already and is of no earlier study")
        self.assertEqual((self.folder / "out/runs/seed=1.h5").read_text(), "somebody's")

    def test_a_missing_study(self):
        self.assertEqual(self.sundrape("study", "absent.toml").returncode, 3)


if __name__ == "__main__":
    unittest.main()
