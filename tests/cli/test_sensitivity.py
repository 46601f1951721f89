"""Derivatives of motions by parameters against differences of whole runs, and what results say about them.

Differences of runs mean something only where the runs take the same steps, which `max_step` = `first_step` below what
the error test would allow makes them, and where Newton's iteration leaves little: hence rtol = 1e-5 at least."""
import json
import signal
import time
import unittest

import h5py
import numpy as np

from command_line import CASES, GRAVITY, MATERIAL, SHEET, CommandLineTest, hanging, set_options

AGREEMENT = 1e-3
STRIP = hanging(cells="[10, 1]", duration="0.1 s", rtol="1e-5", frames="4",
                more='max_step = "0.1 ms"\nfirst_step = "0.1 ms"',
                output='probes = [ { name = "tip", near = ["20 cm", 0, 0] } ]')

# the softer one of two strips comes to lie on the other
LAYERS = f"""title = "Two strips"
analysis = "relaxation"
[[cloth]]
name = "lower"
shape = "rectangle"
size = ["10 cm", "2 cm"]
cells = [20, 4]
[[cloth]]
name = "upper"
shape = "rectangle"
size = ["8 cm", "2 cm"]
cells = [17, 4]
place = {{ translate = [0, 0, "1.5 mm"] }}
material = {{ fabric = "cotton-twill", damping = {{ mass = "2 1/s" }} }}
[material]
thickness = "0.5 mm"
weight = "2 N/m^2"
youngs_modulus = "3e7 N/m^2"
poisson = 0.3
damping = {{ mass = "2 1/s" }}
[[fix]]
nodes = "lower.left"
[[fix]]
nodes = "upper.left"
{GRAVITY}
[relaxation]
tolerance = 1e-9
[dynamics]
duration = "0.07 s"
rtol = 1e-5
max_step = 5e-5
first_step = 5e-5
[output]
frames = 7
"""


class SensitivityTest(CommandLineTest):
    def frames(self, name, *sets):
        self.done("run", "CASE.toml", "-o", name, "--force", "--quiet", *set_options(sets))
        return h5py.File(self.folder / name)

    def assert_derivatives(self, case, parameters, *sets, change=1e-3):
        """The derivatives by each parameter, a dict of key: SI value, are those of differences over ± change."""
        self.write("CASE.toml", case)
        with self.frames("s.h5", f"sensitivity.parameters={list(parameters)}", *sets) as f:
            found = {key: f["sensitivity"][key]["position"][:] for key in parameters}
            rates = {key: f["sensitivity"][key]["velocity"][:] for key in parameters}
            steps = f["steps/time"].shape[0]
        for key, value in parameters.items():
            runs = []
            for factor in (1 - change, 1 + change):
                with self.frames("d.h5", f"{key}={value * factor:.17g}", *sets) as f:
                    runs.append((f["frames/position"][:], f["frames/velocity"][:]))
                    self.assertEqual(f["steps/time"].shape[0], steps, "the runs' steps differ: choose a smaller max_step")
            for name, what, k in (("position", found, 0), ("velocity", rates, 1)):
                expected = (runs[1][k] - runs[0][k]) / (2 * change * value)
                worst = np.abs(what[key] - expected).max() / np.abs(expected).max()
                with self.subTest(key=key, of=name, sets=sets):
                    self.assertLess(worst, AGREEMENT)
        return found

    def test_of_a_damped_strip_with_both_integrators(self):
        for integrator in ("cvode", "ida"):
            for model in ("particle", "shell"):
                self.assert_derivatives(STRIP, {"material.youngs_modulus": 1e6, "material.density_area": 0.2,
                                                "material.damping.bending": 1e-3},
                                        f"dynamics.integrator={integrator}", f"model={model}")

    def test_of_an_undamped_strip(self):
        case = (CASES / "swing.toml").read_text().replace("cells = [80, 1]", "cells = [20, 1]")
        self.assert_derivatives(case, {"material.bending.rigidity": 5.7761e-5, "material.weight": 2.6134722},
                                "dynamics.duration=0.1", "dynamics.rtol=1e-5", "dynamics.max_step=1e-4",
                                "dynamics.first_step=1e-4", "output.every=0.02")

    def test_of_a_sheet_that_slides_down_an_incline(self):
        """Its acceleration is g_x − μ g_z, so μ dx/dμ = −½ μ g_z t² once it slides; it lies at rest at the start."""
        sheet = SHEET.replace("acceleration = [0, 0, -9.80665]", "acceleration = [4, 0, -9]") \
                     .replace('kind = "plane"', 'kind = "plane"\nfriction = 0.2').replace('"0.2 mm"', "0") \
                     .replace('components = ["x", "y"]', 'components = ["y"]').replace("5 1/s", "0 1/s")
        self.write("CASE.toml", sheet)
        with self.frames("s.h5", 'sensitivity.parameters=["obstacle.0.friction"]', "dynamics.duration=0.1",
                         "dynamics.rtol=1e-5") as f:
            found = f["sensitivity/obstacle.0.friction/position"][-1, :, 0]
        np.testing.assert_allclose(found, -0.5 * 9 * 0.1**2, rtol=AGREEMENT)

    def test_of_where_a_hand_goes(self):
        # the free end of a strip in a hand that moves follows; the hand's own nodes move as they are told
        case = STRIP.replace("[[fix]]", "[[motion]]").replace(
            'components = ["x", "y", "z"]',
            'components = ["x", "y", "z"]\npath = { kind = "line", by = [0, 0, "2 cm"], duration = "0.08 s" }')
        found = self.assert_derivatives(case, {"motion.0.path.by.2": 0.02})
        np.testing.assert_allclose(found["motion.0.path.by.2"][-1, 0], [0, 0, 1], atol=1e-9)

    def test_of_a_hand_that_leaves_components_free(self):
        # lifted at its free end, which may turn and slide; what is lifted has damped neighbours
        case = STRIP + ('[[motion]]\nnodes = "right"\ncomponents = ["z"]\n'
                        'path = { kind = "line", by = [0, 0, "2 cm"], duration = "0.08 s" }\n')
        for integrator in ("cvode", "ida"):
            self.assert_derivatives(case, {"motion.0.path.by.2": 0.02, "material.damping.bending": 1e-3},
                                    f"dynamics.integrator={integrator}", "dynamics.max_step=5e-5",
                                    "dynamics.first_step=5e-5")

    def test_go_on_after_a_release(self):
        case = STRIP.replace('nodes = "left"', 'nodes = "left"\nrelease = "0.05 s"')
        # where the error test has a say in the steps after the release, differences of runs say nothing
        self.assert_derivatives(case, {"material.youngs_modulus": 1e6, "material.density_area": 0.2},
                                "dynamics.max_step=2e-5", "dynamics.first_step=2e-5")

    def test_a_motion_that_has_come_to_rest_has_those_of_the_equilibrium(self):
        """The swing's are 20 times as large; at 8 1/s e^(−½·8·4) of them is left after 4 s, 2e-6 of the static ones."""
        key = "material.youngs_modulus"
        self.write("CASE.toml", STRIP)
        for model in ("particle", "shell"):
            setting = [f'sensitivity.parameters=["{key}"]', f"model={model}", 'material.damping.mass="8 1/s"']
            with self.frames("static.h5", *setting, "analysis=relaxation", "relaxation.tolerance=1e-9") as f:
                expected = f["sensitivity"][key]["position"][-1]
            for integrator in ("cvode", "ida"):
                with self.frames("rest.h5", *setting, "dynamics.duration=4", "dynamics.max_step=2e-3", "dynamics.rtol=1e-4",
                                 f"dynamics.integrator={integrator}") as f:
                    found = f["sensitivity"][key]["position"][-1]
                with self.subTest(model=model, integrator=integrator):
                    self.assertLess(np.abs(found - expected).max() / np.abs(expected).max(), AGREEMENT)

    def test_of_layers_that_come_to_touch(self):
        # a contact's force bends within the usual ± 0.1 %: errors of differences fall with the square of the change
        for integrator in ("cvode", "ida"):
            self.assert_derivatives(LAYERS, {"material.weight": 2, "material.youngs_modulus": 3e7}, "analysis=dynamics",
                                    f"dynamics.integrator={integrator}", change=2e-4)

    def test_of_equilibria_under_a_load_and_between_hands(self):
        """At the end of a path, of layers, and where supports have moved: against differences of whole solutions."""
        strip = STRIP.replace('analysis = "dynamics"', 'analysis = "relaxation"')
        hands = ('[[motion]]\nnodes = "right"\ncomponents = ["x", "y", "z"]\n'
                 'path = { kind = "line", by = ["-3 cm", 0, "1 cm"], duration = "1 s" }\n[relaxation]\ntimes = [0.5, 1]\n'
                 'tolerance = 1e-9\n')
        pulled = (CASES / "cantilever_tip_force.toml").read_text().replace('"relaxation"', '"arc-length"')
        path, last = slice(1, None), slice(-1, None)
        for case, equilibria, parameters in [
                (pulled + '["arc-length"]\ntolerance = 1e-7\n', path,
                 {"material.youngs_modulus": 10, "load.0.total.2": 3.4641016151377544e-8}),
                (LAYERS, last, {"material.weight": 2, "cloth.1.place.translate.2": 1.5e-3}),
                ('model = "shell"\n' + LAYERS, last, {"material.weight": 2, "material.youngs_modulus": 3e7}),
                (strip + hands, path, {"material.density_area": 0.2, "motion.0.path.by.2": 0.01})]:
            self.write("CASE.toml", case)
            change = 1e-3
            with self.frames("s.h5", f"sensitivity.parameters={list(parameters)}") as f:
                found = {key: f["sensitivity"][key]["position"][:] for key in parameters}
            for key, value in parameters.items():
                ends = []
                for factor in (1 - change, 1 + change):
                    with self.frames("d.h5", f"{key}={value * factor:.17g}") as f:
                        ends.append(f["frames/position"][-1])
                expected = (ends[1] - ends[0]) / (2 * change * value)
                with self.subTest(key=key):
                    self.assertTrue(np.isfinite(found[key][equilibria]).all())
                    self.assertLess(np.abs(found[key][-1] - expected).max() / np.abs(expected).max(), 1e-4)

    def test_results_say_what_they_hold(self):
        self.write("CASE.toml", STRIP)
        with self.frames("s.h5", 'sensitivity.parameters=["material.youngs_modulus"]') as f:
            group = f["sensitivity/material.youngs_modulus"]
            self.assertEqual(group.attrs["unit"], "N/m^2")
            self.assertEqual(group.attrs["value"], 1e6)
            self.assertEqual(group["position"].attrs["units"], "m/(N/m^2)")
            self.assertEqual(group["position"].shape, f["frames/position"].shape)
            self.assertEqual(np.abs(group["position"][0]).max(), 0)
            np.testing.assert_array_equal(group["probes/tip"][:], group["position"][:, f["probes/tip"].attrs["node"]])
        self.assertIn("sensitivity by material.youngs_modulus", self.done("info", "s.h5").stdout)
        self.assertEqual(json.loads(self.done("info", "s.h5", "--json").stdout)["sensitivities"],
                         {"material.youngs_modulus": {"unit": "N/m^2", "value": 1e6}})
        with self.frames("r.h5", 'sensitivity.parameters=["material.youngs_modulus"]', "analysis=relaxation") as f:
            position = f["sensitivity/material.youngs_modulus/position"][:]
            self.assertTrue(np.isfinite(position[-1]).all())
            self.assertTrue(np.isnan(position[0]).all())  # no equilibrium
            self.assertNotIn("velocity", f["sensitivity/material.youngs_modulus"])

    def test_an_interrupted_run_goes_on_with_them(self):
        self.write("CASE.toml", STRIP.replace('duration = "0.1 s"', 'duration = "1 s"').replace("frames = 4", "frames = 80"))
        setting = set_options(['sensitivity.parameters=["material.youngs_modulus"]'])
        self.done("run", "CASE.toml", "-o", "whole.h5", "--quiet", *setting)
        run = self.start("run", "CASE.toml", "-o", "part.h5", "--quiet", *setting)
        while not (self.folder / "part.h5").exists():
            time.sleep(0.01)
        time.sleep(0.1)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(), 130)
        self.done("run", "CASE.toml", "--resume", "part.h5", "--quiet", *setting)
        with h5py.File(self.folder / "whole.h5") as whole, h5py.File(self.folder / "part.h5") as part:
            a, b = (f["sensitivity/material.youngs_modulus/position"][:] for f in (whole, part))
            # the resumed run starts anew at order 1
            self.assertLess(np.abs(a - b).max(), 0.05 * np.abs(a).max())

    def test_what_has_no_derivative_is_refused(self):
        for case, sets, message in [
            (STRIP, ["dynamics.integrator=rk4", "dynamics.max_step=0.1"], r"need dynamics\.integrator = \"cvode\" or \"ida\""),
            (STRIP.replace('nodes = "left"', 'nodes = "left"\ngrip = "0.05 s"'), [], r"a gripper that closes"),
            (SHEET, ["contact.restitution=0.5"], r"leave it out"),
        ]:
            self.write("CASE.toml", case)
            run = self.sundrape("run", "CASE.toml", *set_options([*sets, 'sensitivity.parameters=["material.youngs_modulus"]']))
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertRegex(run.stderr, message)


if __name__ == "__main__":
    unittest.main()
