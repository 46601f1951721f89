"""Ready-made studies: what their tables say against theory and against a motion that is known otherwise."""
import csv
import math
import unittest

from command_line import CASES, CommandLineTest

FIRST_ORDER = ("CVODE 1", "IDA 1")


class ReadyMade(CommandLineTest):
    timeout = 1500

    def table(self, name, status=(0,)):
        done = self.sundrape("study", CASES / f"studies/{name}.toml", "-o", name, "--quiet")
        self.assertIn(done.returncode, status, done.stderr)
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
        rows = self.table("time_step_rk4", status=(1,))  # steps beyond the limit fail, which is what they are for
        errors = [float(r["error [%]"]) for r in rows if r["status"] == "done"]
        self.assertAlmostEqual(math.log2(errors[1] / errors[0]), 4, delta=0.1)
        self.assertAlmostEqual(math.log2(errors[2] / errors[1]), 4, delta=0.1)
        # Threads of the strip: ω = 2 √(EA/m)/a with a = 5 mm, EA/m = E h/(w/g); the method follows up to ωh = 2√2. The strip's
        # two edges carry half a cell's stiffness and mass each, so that its width is of no account.
        modulus, thickness, weight, gravity = 60446, 0.0489, 0.02665, 980.665  # gf/cm², cm, gf/cm², cm/s²
        omega = 2 * math.sqrt(modulus * thickness * gravity / weight) / 0.5
        limit = 1e6 * 2 * math.sqrt(2) / omega  # [us]
        # just beyond the limit the stiffest mode grows, but the run ends before it has blown up
        stays = {float(r["step"].split()[0]): r["status"] == "done" and float(r["lost or gained [%]"]) < 0.1 for r in rows}
        stable = max(step for step, stayed in stays.items() if stayed)
        unstable = min(step for step, stayed in stays.items() if not stayed)
        print(f"limit {limit:.1f} us, stable at {stable}, not at {unstable} us")
        self.assertLess(0.97 * limit, stable)
        self.assertLess(stable, limit)
        self.assertLess(limit, unstable)
        self.assertIn("failed", {r["status"] for r in rows})

    def test_a_softer_membrane_stretches_in_proportion(self):
        rows = self.table("stiffness_swing")
        for bending in {r["bending"] for r in rows}:
            _, soft, stiff = [float(r["strain [%]"]) for r in rows if r["bending"] == bending]
            self.assertAlmostEqual(soft / stiff, 10, delta=0.5)  # the same pull, up to strains of 0.3 % in where the strip goes

    def test_methods_without_damping_come_nearer_with_their_tolerance_unless_they_gain_energy(self):
        # BDF of orders 3 to 5 gains energy in undamped modes; by the machine's speed its longest runs end in time, or fail
        rows = self.table("time_step_swing", status=(0, 1))
        gaining = [f"{name} {order}" for name in ("CVODE", "IDA") for order in (3, 4, 5)]
        stable = [r for r in rows if r["method"] not in gaining]
        self.comes_nearer([r for r in stable if r["method"] in FIRST_ORDER], 0.2)
        self.comes_nearer([r for r in stable if r["method"] not in FIRST_ORDER], 0.02)
        for r in stable:
            if float(r["rtol"]) <= 1e-5 and r["method"] not in FIRST_ORDER:
                self.assertLess(float(r["lost or gained [%]"]), 0.2, r["run"])
        for method in gaining[:-1]:  # ten times the energy by which it falls; IDA 5 escapes at these tolerances
            runs = [r for r in rows if r["method"] == method]
            self.assertTrue(any(r["status"] != "done" or float(r["lost or gained [%]"]) > 1000 for r in runs), method)

    def test_methods_come_nearer_with_their_tolerance_in_contact_and_damped(self):
        self.comes_nearer(self.table("time_step_fold"), 0.1)
        rows = self.table("time_step_tablecloth")
        # by an order of 1 the folds still go another way at the tightest tolerance
        self.comes_nearer([r for r in rows if r["method"] not in FIRST_ORDER], 0.02)

    def comes_nearer(self, rows, most):
        """Each method's error falls to 3 % from its loosest to its tightest tolerance, and below `most` [%]."""
        for method in dict.fromkeys(r["method"] for r in rows):
            runs = [r for r in rows if r["method"] == method]
            self.assertEqual({r["status"] for r in runs}, {"done"}, method)
            errors = [float(r["error [%]"]) for r in runs]
            if method == "RK4":  # has no tolerance: one run, told six times
                self.assertEqual(len(set(errors)), 1)
                self.assertLess(errors[0], 1e-4)
                continue
            self.assertLess(errors[-1], 0.03 * errors[0], method)
            self.assertLess(errors[-1], most, method)


if __name__ == "__main__":
    unittest.main()
