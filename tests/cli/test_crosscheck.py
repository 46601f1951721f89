"""Crosschecks, motions until they rest, and starts from where an earlier result ended."""
import json
import unittest

import h5py
import numpy as np

from command_line import GRAVITY, MATERIAL, SHEET, CommandLineTest, hanging

# A strip held by its left edge, which hangs straight down in the end: one equilibrium, whichever way one gets there.
HANGING = hanging().replace('analysis = "dynamics"', 'analysis = "relaxation"')

# A shallow arch of cloth between two held edges, 5 mm high. Let go under 6.2 m/s² at once it swings through and hangs
# down; lowered onto its equilibrium it stays up. That is as it must be: a load that is there at once buckles an arch
# below the load that does so slowly (here from 5.6 and from 6.9 m/s²: found by trying both).
ARCH = f"""title = "An arch"
analysis = "relaxation"
[cloth]
shape = "mesh"
file = "arch.obj"
{MATERIAL.replace('"0.5 mm"', '"2 mm"')}
[[fix]]
name = "ends"
nodes = {{ plane = {{ point = [0.1, 0, 0], normal = [1, 0, 0] }} }}
[[fix]]
name = "other ends"
nodes = {{ plane = {{ point = [-0.1, 0, 0], normal = [1, 0, 0] }} }}
[[load]]
kind = "gravity"
acceleration = [0, 0, -6.2]
"""


def arch(height, cells=16):
    """A strip 20 cm by 2 cm that rises by `height` in its middle, as an OBJ file."""
    x = np.linspace(-0.1, 0.1, cells + 1)
    z = height * np.cos(np.pi * x / 0.2) ** 2
    lines = [f"v {a:.17g} {y} {b:.17g}" for a, b in zip(x, z) for y in (-0.01, 0.01)]
    lines += [f"f {2 * i + 1} {2 * i + 3} {2 * i + 4} {2 * i + 2}" for i in range(cells)]
    return "\n".join(lines) + "\n"


class Crosscheck(CommandLineTest):
    def crosscheck(self, case, *more):
        return self.sundrape("crosscheck", self.write("case.toml", case), "-o", "out", "--jobs", 2,
                             "--methods", "relaxation,dynamics", *more)

    def report(self):
        return json.loads((self.folder / "out/crosscheck.json").read_text())

    def test_static_and_dynamic_ends_of_one_branch_agree(self):
        done = self.crosscheck(HANGING)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("relaxation and dynamics are on the same branch.", done.stdout)
        self.assertIn("sundrape_postproc crosscheck out -o out/crosscheck.png", done.stdout)
        self.assertTrue(done.stdout.endswith("\n") and (self.folder / "out/crosscheck.txt").read_text() in done.stdout)
        report = self.report()
        methods = {method["name"]: method for method in report["methods"]}
        self.assertEqual({m["status"] for m in methods.values()}, {"done"})
        pair = next(p for p in report["pairs"] if p["second"] == "dynamics")
        self.assertTrue(pair["same_branch"])
        self.assertLess(pair["rms_over_size"], 1e-3)  # what the methods are asked to agree to
        with h5py.File(self.folder / "out/relaxation.h5") as a, h5py.File(self.folder / "out/dynamics.h5") as b:
            apart = np.linalg.norm(a["frames/position"][-1] - np.array(pair["second_position_m"]), axis=1)
            self.assertAlmostEqual(np.sqrt(np.mean(apart**2)), pair["rms_m"], delta=1e-12)
            self.assertAlmostEqual(apart.max(), pair["max_m"], delta=1e-12)
            self.assertLess(b["frames/time"][-1], 400 * np.sqrt(0.2 / 9.80665))  # it was found at rest before its time
            self.assertIn("rests_at_s", b["statistics"].attrs)
        weight = 0.2 * 0.2 * 0.03 * 9.80665
        for method in methods.values():  # the hand carries all of it
            self.assertAlmostEqual(method["reactions_N"]["hand"][2], -weight, delta=2e-3 * weight)

    def test_another_branch_is_told_and_found_to_be_an_equilibrium_too(self):
        self.write("arch.obj", arch(0.005))
        done = self.crosscheck(ARCH)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("relaxation and dynamics are on different branches.", done.stdout)
        self.assertIn("an equilibrium of relaxation too, another one than it finds from the start", done.stdout)
        pair = next(p for p in self.report()["pairs"] if p["second"] == "dynamics")
        with h5py.File(self.folder / "out/relaxation.h5") as up, h5py.File(self.folder / "out/dynamics-relaxed.h5") as down:
            self.assertGreater(up["frames/position"][-1][:, 2].max(), 2e-3)
            self.assertLess(down["frames/position"][-1][:, 2].min(), -2e-3)
            start, end = down["frames/position"][0], down["frames/position"][-1]
            moved = np.sqrt(np.mean(np.sum((end - start) ** 2, axis=1)))
            self.assertAlmostEqual(moved, pair["relaxed"]["moved_rms_m"], delta=1e-12)
        self.assertLess(pair["relaxed"]["moved_rms_m"], 1e-3 * pair["rms_m"])
        self.assertEqual(pair["relaxed"]["negative_pivots"], 0)
        again = self.crosscheck(ARCH)
        self.assertIn("2 of 2 results are there already", again.stdout)
        self.assertIn("1 of 1 results are there already", again.stdout)  # the relaxation of the end

    def test_an_end_that_is_no_equilibrium_decides_nothing(self):
        # the motion is cut off while it falls
        done = self.crosscheck(HANGING, "--set", "dynamics.duration=0.05")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, "whether relaxation and dynamics are on one branch is undecided: dynamics ended where "
                                      "forces do not balance")
        pair = self.report()["pairs"][0]
        self.assertEqual((pair["verdict"], pair["same_branch"]), ("undecided", False))

    def test_reactions_are_those_of_the_methods_own_model(self):
        # a wavy rest shape by arc-length, a flat one by relaxation: the hand carries the weight in both
        done = self.sundrape("crosscheck", self.write("case.toml", HANGING), "-o", "out", "--methods",
                             "relaxation,arc-length", "--set", "arc-length.max_iterations=60")
        self.assertEqual(done.returncode, 0, done.stderr)
        weight = 0.2 * 0.2 * 0.03 * 9.80665
        laid = self.report()["pairs"][0]["second_laid_on_first"]
        # forces balance to the path's tolerance, 1e-6 of the load
        self.assertAlmostEqual(laid["reactions_N"]["hand"][2], -weight, delta=1e-5 * weight)

    def test_the_analysis_is_not_for_the_command_line_to_say(self):
        done = self.crosscheck(HANGING, "--set", "analysis=relaxation")
        self.assertEqual(done.returncode, 2)
        self.assertIn("choose among them by --methods", done.stderr)

    def test_a_changed_mesh_file_is_noticed(self):
        self.write("arch.obj", arch(0.005))
        self.crosscheck(ARCH)
        self.write("arch.obj", arch(0.00501))
        self.assertNotIn("results are there already", self.crosscheck(ARCH).stdout)

    def test_what_failed_is_said_and_the_rest_is_compared(self):
        done = self.crosscheck(HANGING, "--set", "dynamics.time_limit=1e-3")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stdout, "dynamics +failed: .*time limit")
        self.assertEqual([m["status"] for m in self.report()["methods"] if m["name"] == "dynamics"], ["failed"])

    def test_every_method_is_run_that_there_is(self):
        done = self.sundrape("crosscheck", self.write("case.toml", HANGING), "-o", "out", "--jobs", 2)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        names = {m["name"] for m in self.report()["methods"]}
        self.assertEqual(names, {"relaxation", "arc-length", "dynamics"})

    def test_methods_that_are_not(self):
        done = self.crosscheck(HANGING, "--methods", "relaxing")
        self.assertEqual(done.returncode, 2)
        self.assertIn("relaxing", done.stderr)

    def test_a_bad_case(self):
        done = self.crosscheck(HANGING.replace("poisson", "poison"))
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "^case.toml:.*did you mean 'poisson'")


class UntilRest(CommandLineTest):
    def test_a_motion_ends_where_it_rests(self):
        case = self.write("sheet.toml", SHEET.replace('"20 ms"', '"60 s"'))
        self.done("run", case, "--quiet", "--set", "dynamics.until_rest=1e-8", "--set", "dynamics.rtol=1e-4",
                  "--summary", "s.json")
        summary = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(summary["status"], "done")
        with h5py.File(self.folder / "sheet.h5") as result:
            end = result["frames/time"][-1]
            self.assertEqual(summary["rests_at_s"], end)
            self.assertLess(end, 30)
            self.assertGreater(end, 2 * np.pi * np.sqrt(0.08 / 9.80665))  # calm for a swing of its length
            weight = 0.2 * 0.08 * 0.06 * 9.80665
            self.assertLess(result["frames/energy/kinetic"][-1], 1e-8 * weight * 0.08)
            self.assertLess(result["frames/residual"][-1], 0.02)

    def test_a_motion_does_not_rest_while_a_load_still_grows(self):
        load = '[[load]]\nkind = "force"\nnodes = "right"\ntotal = [0, 0, -1e-4]\nramp = "5 s"\n'
        case = self.write("sheet.toml", SHEET.replace('"20 ms"', '"60 s"') + load)
        self.done("run", case, "--quiet", "--set", "dynamics.until_rest=1e-6", "--set", "dynamics.rtol=1e-3")
        with h5py.File(self.folder / "sheet.h5") as result:
            self.assertGreater(result["frames/time"][-1], 5)

    def test_a_motion_that_does_not_rest_says_so(self):
        result = self.done("run", self.write("sheet.toml", SHEET), "--set", "dynamics.until_rest=1e-8")
        self.assertIn("the cloth does not rest at the end", result.stdout)
        with h5py.File(self.folder / "sheet.h5") as file:
            self.assertEqual(file["frames/time"][-1], 0.02)


class Start(CommandLineTest):
    def relax(self, output, *more, model="particle"):
        self.done("run", "case.toml", "-o", output, "--set", "analysis=relaxation", "--set", f"model={model}",
                  "--summary", output + ".json", *more)
        with h5py.File(self.folder / output) as result:
            return result["frames/position"][:], json.loads((self.folder / (output + ".json")).read_text())

    def test_from_an_equilibrium_a_relaxation_stays_there(self):
        self.write("case.toml", hanging())
        for model in ("particle", "shell"):
            first, cold = self.relax(f"{model}.h5", model=model)
            again, warm = self.relax(f"{model}-again.h5", "--set", f"cloth.start={model}.h5", model=model)
            np.testing.assert_allclose(again[0], first[-1], atol=1e-15)
            np.testing.assert_allclose(again[-1], first[-1], atol=2e-6)  # 1e-5 of the length
            self.assertLess(warm["iterations"], cold["iterations"] / 3)

    def test_what_is_held_stays_where_the_case_puts_it(self):
        self.write("case.toml", hanging())
        first, _ = self.relax("first.h5")
        moved, _ = self.relax("moved.h5", "--set", "cloth.start=first.h5", "--set", 'cloth.place.translate=["10 cm", 0, "1 mm"]')
        hand = np.abs(first[0, :, 0]) < 1e-12
        np.testing.assert_allclose(moved[0][hand, 2], 1e-3, atol=1e-15)
        np.testing.assert_allclose(moved[0][~hand], first[-1][~hand], atol=1e-15)
        np.testing.assert_allclose(moved[-1][:, 2], first[-1][:, 2] + 1e-3, atol=2e-6)

    def test_starts_that_are_of_no_use_are_refused(self):
        self.write("case.toml", hanging())
        self.relax("first.h5")
        absent = self.sundrape("run", "case.toml", "--set", "cloth.start=absent.h5")
        self.assertEqual(absent.returncode, 2)
        self.assertIn("cloth.start: 'absent.h5' is not there", absent.stderr)
        other = self.sundrape("run", "case.toml", "--set", "cloth.start=first.h5", "--set", "cloth.cells=[6,2]")
        self.assertEqual(other.returncode, 2)
        self.assertRegex(other.stderr, "cloth.start: .*first.h5: belongs to another mesh: the meshes have 21 and 39 nodes")
        text = self.sundrape("run", "case.toml", "--set", "cloth.start=case.toml")
        self.assertEqual(text.returncode, 2)
        self.assertIn("cloth.start", text.stderr)


if __name__ == "__main__":
    unittest.main()
