"""Tables of studies: what their outputs are, against the results read by h5py; references; what is refused."""
import csv
import json
import unittest

import h5py
import numpy as np

from command_line import GRAVITY, MATERIAL, CommandLineTest

# A strip that is let go at one end and swings.
STRIP = f"""title = "A swinging strip"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["20 cm", "2 cm"]
cells = [10, 1]
{MATERIAL}
[[fix]]
name = "clamp"
nodes = "left"
[[obstacle]]
kind = "plane"
point = [0, 0, "-8 cm"]
{GRAVITY}
[dynamics]
duration = "0.4 s"
[output]
frames = 20
probes = [ {{ name = "the tip", near = ["10 cm", "1 cm", 0] }} ]
"""

AXES = """title = "Swings"
case = "strip.toml"
[[axis]]
key = "dynamics.rtol"
values = { from = 1e-3, to = 1e-5, count = 2, spacing = "log" }
[[axis]]
name = "method"
settings = [["dynamics.integrator=cvode"], ["dynamics.integrator=ida", "dynamics.max_order=1"]]
labels = ["BDF2", "BDF1"]
"""


def output(name, value, unit=None):
    return f'[[output]]\nname = "{name}"\nvalue = "{value}"\n' + (f'unit = "{unit}"\n' if unit else "")


class StudyTable(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("strip.toml", STRIP)

    def study(self, text, *more):
        return self.sundrape("study", self.write("study.toml", text), "-o", "out", *more)

    def rows(self, name="study.csv"):
        with (self.folder / "out" / name).open() as file:
            return list(csv.DictReader(file))


class Outputs(StudyTable):
    def test_every_kind_of_measure_is_what_the_result_holds(self):
        text = AXES
        text += output("tip at 0.2 s", "at(probe.the_tip.z, 200 ms)", "cm")
        text += output("speed", "max(probe.the_tip.vx)", "cm/s")
        text += output("fall", "first(energy.gravity) - min(energy.gravity)", "mJ")
        text += output("total", "last(energy.total)")
        text += output("pull", "max(reaction.clamp.z)", "gf")
        text += output("touch", "max(contact.force.z)")
        text += output("sunk", "max(contact.penetration)")
        text += output("when", "argmin(shape.bottom)", "ms")
        text += output("mean step", "mean(step.step_size)")
        text += output("work", "newton_iterations / steps")
        text += output("share", "nodes * diagonal")
        done = self.study(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.rows()
        self.assertEqual([(r["run"], r["dynamics.rtol"], r["method"], r["status"]) for r in rows],
                         [("rtol=0.001,method=BDF2", "0.001", "BDF2", "done"), ("rtol=0.001,method=BDF1", "0.001", "BDF1", "done"),
                          ("rtol=1e-05,method=BDF2", "1e-05", "BDF2", "done"), ("rtol=1e-05,method=BDF1", "1e-05", "BDF1", "done")])
        for row in rows:
            with h5py.File(self.folder / f"out/runs/{row['run']}.h5") as result:
                frames, probe = result["frames"], result["probes/the tip"]
                energy = {name: e[:] for name, e in frames["energy"].items()}
                stored = sum(energy[k][-1] for k in ("kinetic", "membrane", "shear", "bending", "gravity", "contact"))
                z = frames["position"][:, :, 2]
                at = 10  # the frame at 0.2 s: the probe's node, interpolated by the integrator itself
                tip = frames["position"][at, probe.attrs["node"], 2]
                step, time = result["steps/step_size"][:], result["steps/time"][:]
                statistics = result["statistics"].attrs
                expected = {
                    "speed [cm/s]": 100 * probe["velocity"][:, 0].max(),
                    "fall [mJ]": 1e3 * (energy["gravity"][0] - energy["gravity"].min()),
                    "total [J]": stored,
                    "pull [gf]": frames["reaction/clamp"][:, 2].max() / 9.80665e-3,
                    "touch [N]": frames["contact_force_sum"][:, 2].max(),
                    "sunk [m]": frames["penetration"][:].max(),
                    "when [ms]": 1e3 * frames["time"][int(z.min(axis=1).argmin())],
                    "mean step [s]": np.trapz(step, time) / (time[-1] - time[0]),
                    "work": statistics["newton_iterations"] / statistics["steps"],
                    "share": 22 * np.hypot(0.2, 0.02),
                }
            for name, value in expected.items():
                self.assertAlmostEqual(float(row[name]), value, delta=1e-12 * abs(value), msg=name)
            # steps of some ms and a cubic between them: the two interpolations agree to a few micrometres
            self.assertAlmostEqual(float(row["tip at 0.2 s [cm]"]), 100 * tip, delta=2e-3)
            self.assertGreater(float(row["touch [N]"]), 0)  # it does land

    def test_the_hdf5_table_is_the_csv_table(self):
        done = self.study(AXES + output("tip", "last(probe.the_tip.z)", "cm") + output("steps", "steps"))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.rows()
        with h5py.File(self.folder / "out/study.h5") as study:
            self.assertEqual(study.attrs["format"], "sundrape study")
            self.assertEqual(sorted(study["outputs"]), ["steps", "tip"])
            self.assertEqual(study["outputs/tip"].attrs["units"], "cm")
            self.assertEqual(study["outputs/tip"].attrs["description"], "last(probe.the_tip.z)")
            self.assertEqual([float(r["tip [cm]"]) for r in rows], study["outputs/tip"][:].tolist())
            names = [n.decode() for n in study["runs/name"]]
            self.assertEqual([r["run"] for r in rows], names)
            labels = {name: [x.decode() for x in axis["label"]] for name, axis in study["axes"].items()}
            order = sorted(labels, key=lambda name: study["axes"][name].attrs["position"])
            for row, chosen in zip(rows, study["runs/value"]):
                self.assertEqual([row[name] for name in order], [labels[name][k] for name, k in zip(order, chosen)])
            np.testing.assert_allclose(study["axes/dynamics.rtol/number"], [1e-3, 1e-5])
            self.assertNotIn("number", study["axes/method"])

    def test_tables_are_bit_identical_however_many_jobs_there_are(self):
        text = AXES + output("tip", "last(probe.the_tip.z)") + output("cpu", "cpu_seconds", "ms")
        tables = []
        for jobs in (1, 2):
            self.assertEqual(self.study(text, "--jobs", jobs).returncode, 0)
            tables.append([(self.folder / "out" / name).read_bytes() for name in ("study.csv", "study.h5")])
            (self.folder / "out").rename(self.folder / f"out{jobs}")
        self.assertEqual(*tables)
        self.assertNotIn(b"cpu", tables[0][0])  # seconds are in a table of their own
        with (self.folder / "out1/timings.csv").open() as file:
            self.assertTrue(all(float(row["cpu [ms]"]) > 0 for row in csv.DictReader(file)))

    def test_distances_are_measured_from_the_reference(self):
        text = AXES.replace("[[axis]]", 'set = ["dynamics.duration=0.1 s"]\n[[axis]]', 1)  # until it lands
        text += '[reference]\nset = ["dynamics.rtol=1e-7"]\n'
        text += output("error", "max(reference.rms)") + output("end", "last(reference.max)")
        done = self.study(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(self.folder / "out/runs/reference.h5") as file:
            reference = file["frames/position"][:]
        errors = {}
        for row in self.rows():
            with h5py.File(self.folder / f"out/runs/{row['run']}.h5") as file:
                apart = np.linalg.norm(file["frames/position"][:] - reference, axis=2)
            self.assertAlmostEqual(float(row["error [m]"]), np.sqrt((apart**2).mean(axis=1)).max(), delta=1e-12)
            self.assertAlmostEqual(float(row["end [m]"]), apart[-1].max(), delta=1e-12)
            errors[row["run"]] = float(row["error [m]"])
        self.assertLess(errors["rtol=1e-05,method=BDF2"], 0.3 * errors["rtol=0.001,method=BDF2"])

    def test_a_run_that_fails_leaves_its_line_without_numbers(self):
        text = AXES.replace('"dynamics.integrator=cvode"', '"dynamics.time_limit=0.0001"') + output("tip", "last(probe.the_tip.z)")
        done = self.study(text)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual([(r["status"], r["tip [m]"] == "") for r in self.rows()], [("failed", True), ("done", False)] * 2)
        report = json.loads((self.folder / "out/study.json").read_text())
        self.assertNotIn("outputs", report["runs"][0])
        with h5py.File(self.folder / "out/study.h5") as study:
            self.assertTrue(np.isnan(study["outputs/tip"][0]))
            self.assertIn(b"time limit", study["runs/message"][0])

    def test_a_measure_that_a_result_does_not_have_is_said(self):
        done = self.study(AXES + output("pivots", "negative_pivots"))  # of static analyses
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, "no number: pivots: .*holds no 'negative_pivots'")


class Programs(StudyTable):
    PROGRAM = """import json, sys, h5py
with h5py.File(sys.argv[1]) as result:
    z = result["frames/position"][-1][:, 2]
    if len(sys.argv) > 3 and result["steps/order"][:].max() == 1:
        sys.exit("what is this?")
json.dump({"heights": [{"low": z.min(), "word": "no number"}]}, open(sys.argv[2], "w"))
"""

    def program(self, *more, numbers='["low=/heights/0/low"]'):
        self.write("lowest.py", self.PROGRAM)
        words = json.dumps(["/usr/bin/python3", str(self.folder / "lowest.py"), "{result}", "{json}", *more])
        return f"[[program]]\ncommand = {words}\nnumbers = {numbers}\n"

    def test_their_numbers_stand_in_outputs(self):
        done = self.study(AXES + self.program() + output("low", "low", "cm") + output("none", "low - last(shape.bottom)"))
        self.assertEqual(done.returncode, 0, done.stderr)
        for row in self.rows():
            with h5py.File(self.folder / f"out/runs/{row['run']}.h5") as result:
                low = result["frames/position"][-1][:, 2].min()
            self.assertAlmostEqual(float(row["low [cm]"]), 100 * low, delta=1e-12)
            self.assertEqual(float(row["none"]), 0)

    def test_one_that_fails_or_does_not_say_leaves_no_number(self):
        done = self.study(AXES + self.program("--of-order-2") + output("low", "low"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no number: /usr/bin/python3 failed: what is this?", done.stdout)
        self.assertEqual([row["low"] == "" for row in self.rows()], [False, True, False, True])
        done = self.study(AXES + self.program(numbers='["word=/heights/0/word"]') + output("word", "word"))
        self.assertRegex(done.stdout, "no number: word: no number at /heights/0/word of ")

    def test_one_without_a_report(self):
        done = self.study(AXES + '[[program]]\ncommand = ["true"]\nnumbers = ["a=/b"]\n')
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^study.toml:11: program.0.command: no word has \{json\}")


class Refusals(StudyTable):
    def refused(self, text, pattern):
        done = self.study(AXES + text)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, pattern)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_probe_that_the_case_does_not_have(self):
        self.refused(output("tip", "last(probe.tip.z)"),
                     r"^study.toml:12: output.0.value: 'probe.tip.z': 'tip' is not there.*accepted: the_tip")

    def test_a_unit_of_another_dimension(self):
        self.refused(output("tip", "last(probe.the_tip.z)", "s"), "^study.toml:12: output.0.value: '1 s' is a time, a length is expected")

    def test_a_distance_without_a_reference(self):
        self.refused(output("error", "max(reference.rms)"), r"^study.toml:12: .*add \[reference\]")


if __name__ == "__main__":
    unittest.main()
