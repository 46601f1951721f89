"""What a run writes and says, and what the other verbs make of its result."""
import json
import unittest
import xml.etree.ElementTree

import h5py
import numpy as np

from command_line import SHEET, CommandLineTest, hanging

WEIGHT = 0.2 * 0.08 * 0.06 * 9.80665  # of SHEET [N]


class Run(CommandLineTest):
    def test_quiet_prints_nothing(self):
        result = self.done("run", self.write("sheet.toml", SHEET), "--quiet")
        self.assertEqual(result.stdout + result.stderr, "")
        self.assertEqual(self.files(), ["sheet.h5", "sheet.toml", "sheet.xdmf"])

    def test_it_says_what_it_did(self):
        result = self.done("run", self.write("sheet.toml", SHEET))
        self.assertIn("5 frames in sheet.h5", result.stdout)
        self.assertRegex(result.stdout, r"\d+ steps, \d+ Newton iterations")

    def test_the_summary_has_its_numbers(self):
        self.done("run", self.write("sheet.toml", SHEET), "--quiet", "--summary", "sheet.json", "--set", "dynamics.linear_solver=cg")
        summary = json.loads((self.folder / "sheet.json").read_text())
        self.assertEqual(summary["status"], "done")
        self.assertEqual(summary["mesh"], {"nodes": 20, "quads": 12})
        self.assertEqual(summary["frames"], 5)
        self.assertAlmostEqual(summary["weight_N"], WEIGHT, delta=1e-9 * WEIGHT)
        for name in ("steps", "force_evaluations", "newton_iterations", "linear_solves", "linear_iterations", "factorizations"):
            self.assertGreater(summary[name], 0, name)
        for name in ("error_test_failures", "step_solve_failures", "restarts", "wall_seconds", "cpu_seconds", "deepest_penetration_m", "largest_edge_strain",
                     "sharpest_bend_deg"):
            self.assertGreaterEqual(summary[name], 0, name)
        with h5py.File(self.folder / "sheet.h5") as result:
            self.assertEqual(summary["steps"], len(result["steps/time"]))
            self.assertEqual(summary["newton_iterations"], result["steps/newton_iterations"][...].sum())
            for kind, energy in summary["final"]["energy_J"].items():
                self.assertEqual(energy, result[f"frames/energy/{kind}"][-1], kind)
            np.testing.assert_array_equal(summary["final"]["contact_force_sum_N"], result["frames/contact_force_sum"][-1])
            np.testing.assert_array_equal(summary["final"]["reaction_N"]["pin"], result["frames/reaction/pin"][-1])

    def test_an_existing_result_is_kept_unless_forced(self):
        case = self.write("sheet.toml", SHEET)
        self.done("run", case, "--quiet")
        before = (self.folder / "sheet.h5").read_bytes()
        refused = self.sundrape("run", case)
        self.assertIn(refused.returncode, (2, 3))
        self.assertIn("--force", refused.stderr)
        self.assertEqual((self.folder / "sheet.h5").read_bytes(), before)
        self.done("run", case, "--quiet", "--force", "--set", "output.frames=2")
        with h5py.File(self.folder / "sheet.h5") as result:
            self.assertEqual(len(result["frames/time"]), 3)

    def test_the_result_keeps_the_case_as_run(self):
        self.done("run", self.write("sheet.toml", SHEET), "--quiet", "--set", "output.frames=2", "--set", "material.poisson=0.25")
        with h5py.File(self.folder / "sheet.h5") as result:
            self.write("again.toml", result.attrs["case"])
        resolved = self.done("check", "again.toml").stdout
        self.assertRegex(resolved, r"material\.poisson *= 0\.25")

    def test_one_thread_and_two_give_the_same_numbers_to_the_last_bit(self):
        case = self.write("strip.toml", hanging(duration="0.1 s", cells="[24, 6]"))
        for threads in (1, 2):
            self.done("run", case, "--quiet", "--threads", threads, "-o", f"{threads}.h5")
        with h5py.File(self.folder / "1.h5") as one, h5py.File(self.folder / "2.h5") as two:
            for name in ("frames/position", "frames/velocity", "steps/time", "steps/linear_iterations"):
                np.testing.assert_array_equal(one[name][...], two[name][...], err_msg=name)

    def test_integrators_agree_on_a_smooth_motion(self):
        # to the accuracy of the methods, whose steps are independent of each other: 2 % of the way that the free end goes
        case = self.write("strip.toml", hanging(duration="0.2 s", cells="[6, 1]", frames="4"))
        ends = {}
        for integrator in ("cvode", "ida", "dirk", "rk4"):
            step = ["--set", "dynamics.step='0.1 ms'"] if integrator == "rk4" else []
            self.done("run", case, "--quiet", "--set", f"dynamics.integrator={integrator}", "--set", "dynamics.rtol=1e-5", *step, "-o", f"{integrator}.h5")
            with h5py.File(self.folder / f"{integrator}.h5") as result:
                ends[integrator] = result["frames/position"][-1]
                way = np.abs(result["frames/position"][-1] - result["frames/position"][0]).max()
        for integrator in ("cvode", "ida", "dirk"):
            self.assertLess(np.abs(ends[integrator] - ends["rk4"]).max(), 0.02 * way, integrator)

    def test_a_fixed_step_of_dirk_is_kept_to_the_end(self):
        case = self.write("strip.toml", hanging(duration="0.1 s", cells="[6, 1]", frames="4"))
        self.done("run", case, "--quiet", "--set", "dynamics.integrator=dirk", "--set", "dynamics.max_order=3", "--set", "dynamics.step='1 ms'", "-o", "out.h5")
        with h5py.File(self.folder / "out.h5") as result:
            steps = result["steps/step_size"][...]
            np.testing.assert_allclose(steps[:-1], 1e-3, rtol=1e-9)  # rounding may leave a last one of next to nothing
            self.assertAlmostEqual(steps.sum(), 0.1, delta=1e-9)
            self.assertEqual(set(result["steps/order"][...]), {3})


class OtherVerbs(CommandLineTest):
    def test_check_prints_what_is_resolved_and_writes_nothing(self):
        case = self.write("sheet.toml", SHEET)
        result = self.done("check", case, "--set", "material.thickness='0.6 mm'")
        self.assertRegex(result.stdout, r"material\.thickness *= 0\.0006 m")
        self.assertRegex(result.stdout, r"nodes = 20\b")
        self.assertRegex(result.stdout, r"weight of the cloth under its load = 0\.00941")
        self.assertEqual(self.files(), ["sheet.toml"])

    def test_check_finds_what_only_the_mesh_shows(self):
        case = self.write("sheet.toml", SHEET.replace("near = [0, 0, 0]", "box = [[1, 1, 1], [2, 2, 2]]"))
        result = self.sundrape("check", case)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^sheet\.toml:\d+: fix\.0\.nodes: ")

    def test_info_speaks_json_and_text(self):
        self.done("run", self.write("sheet.toml", SHEET), "--quiet")
        told = json.loads(self.done("info", "sheet.h5", "--json").stdout)
        self.assertEqual(told["status"], "done")
        self.assertIn("A sheet on a table", json.dumps(told))
        self.assertIn("A sheet on a table", self.done("info", "sheet.h5").stdout)

    def test_a_result_compared_with_itself_has_no_distance(self):
        self.done("run", self.write("sheet.toml", SHEET), "--quiet")
        told = json.loads(self.done("compare", "sheet.h5", "sheet.h5", "--json").stdout)

        def numbers(item):
            if isinstance(item, dict):
                for key, value in item.items():
                    yield from ((f"{key}.{name}", number) for name, number in numbers(value))
            elif isinstance(item, list):
                for value in item:
                    yield from numbers(value)
            elif isinstance(item, (int, float)):
                yield "", item

        distances = [(name, number) for name, number in numbers(told) if any(word in name for word in ("rms", "max", "difference"))]
        self.assertGreater(len(distances), 3)
        for name, number in distances:
            self.assertEqual(number, 0, name)

    def test_two_meshes_are_not_compared(self):
        case = self.write("sheet.toml", SHEET)
        self.done("run", case, "--quiet", "-o", "a.h5")
        self.done("run", case, "--quiet", "-o", "b.h5", "--set", "cloth.cells=[3, 3]")
        result = self.sundrape("compare", "a.h5", "b.h5")
        self.assertIn(result.returncode, (2, 3))
        self.assertNotEqual(result.stderr, "")

    def test_the_xdmf_beside_a_result_has_its_frames(self):
        self.done("run", self.write("sheet.toml", SHEET), "--quiet")
        xdmf = xml.etree.ElementTree.parse(self.folder / "sheet.xdmf")
        self.assertEqual(len(xdmf.findall(".//Grid[@CollectionType='Temporal']/Grid")), 5)

    def test_help_and_version(self):
        for arguments in (["--help"], *([verb, "--help"] for verb in ("run", "check", "info", "compare"))):
            self.assertGreater(len(self.done(*arguments).stdout), 80, arguments)
        self.assertRegex(self.done("--version").stdout, r"^sundrape \d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
