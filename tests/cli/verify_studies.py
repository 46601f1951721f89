"""Ready-made studies: what their tables say against theory and against a motion that is known otherwise."""
import csv
import math
import unittest

from command_line import CASES, CommandLineTest


class ReadyMade(CommandLineTest):
    timeout = 1500

    def table(self, name, status=0):
        done = self.sundrape("study", CASES / f"studies/{name}.toml", "-o", name, "--quiet")
        self.assertEqual(done.returncode, status, done.stderr)
        with (self.folder / name / "study.csv").open() as file:
            return list(csv.DictReader(file))

    def test_net_and_shell_are_of_second_order_in_the_mesh(self):
        rows = self.table("mesh_swing")
        for model in ("particle", "shell"):
            # the independent solution is good to 0.003 mm, so 160 cells are left out
            coarse, middle, fine = [float(r["error [mm]"]) for r in rows if r["model"] == model][:3]
            print(f"{model}: {coarse:.4f} {middle:.4f} {fine:.4f} mm")
            self.assertAlmostEqual(math.log2(coarse / middle), 2, delta=0.25)
            self.assertAlmostEqual(math.log2(middle / fine), 2, delta=0.4)

    def test_runge_kutta_is_of_fourth_order_up_to_its_limit(self):
        rows = self.table("time_step_rk4", status=1)  # steps beyond the limit fail, which is what they are for
        errors = [float(r["error [%]"]) for r in rows if r["status"] == "done"]
        self.assertAlmostEqual(math.log2(errors[1] / errors[0]), 4, delta=0.1)
        self.assertAlmostEqual(math.log2(errors[2] / errors[1]), 4, delta=0.1)
        # Threads of the strip: ω = 2 √(EA/m)/a with a = 5 mm, EA/m = E h/(w/g); the method follows up to ωh = 2√2. The strip's
        # two edges carry half a cell's stiffness and mass each, so that its width is of no account.
        modulus, thickness, weight, gravity = 60446, 0.0489, 0.02665, 980.665  # gf/cm², cm, gf/cm², cm/s²
        omega = 2 * math.sqrt(modulus * thickness * gravity / weight) / 0.5
        limit = 1e6 * 2 * math.sqrt(2) / omega  # [us]
        stable = max(float(r["step"].split()[0]) for r in rows if r["status"] == "done")
        unstable = min(float(r["step"].split()[0]) for r in rows if r["status"] == "failed")
        print(f"limit {limit:.1f} us, stable at {stable}, not at {unstable} us")
        # just beyond the limit a mode grows too slowly to show in 0.3 s, and a finite chain's highest is a little below ω
        self.assertLess(stable, 1.01 * limit)
        self.assertLess(limit, unstable)

    def test_a_softer_membrane_stretches_in_proportion(self):
        rows = self.table("stiffness_swing")
        for bending in {r["bending"] for r in rows}:
            _, soft, stiff = [float(r["strain [%]"]) for r in rows if r["bending"] == bending]
            self.assertAlmostEqual(soft / stiff, 10, delta=0.5)  # the same pull, up to strains of 0.3 % in where the strip goes

    def test_every_method_comes_nearer_with_its_tolerance(self):
        rows = self.table("time_step_swing")
        for method in dict.fromkeys(r["method"] for r in rows):
            errors = [float(r["error [%]"]) for r in rows if r["method"] == method]
            self.assertLess(errors[-1], 0.03 * errors[0], method)
            self.assertLess(errors[-1], 0.1, method)  # of the diagonal


if __name__ == "__main__":
    unittest.main()
