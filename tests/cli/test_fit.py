"""`sundrape fit` on made-up measurements, where the truth is known, and its messages."""
import json
import unittest

import h5py
import numpy as np

from command_line import CASES, CommandLineTest

TRUTH = 0.5 * 9.80665e-5  # [N m]
CANTILEVER = """analysis = "relaxation"
[cloth]
shape = "rectangle"
size = ["10 cm", "1 cm"]
cells = [10, 1]
place = { translate = ["5 cm", 0, 0] }
waviness = { amplitude = 0, seed = 1 }
[material]
thickness = "0.5 mm"
weight = "0.025 gf/cm^2"
youngs_modulus = "20 MPa"
poisson = 0
bending = { law = "linear", rigidity = "0.5 gf*cm^2/cm" }
[[fix]]
nodes = "left"
[[load]]
kind = "gravity"
[output]
probes = [ { name = "tip", near = ["10 cm", 0, 0] } ]
"""
FIT = """case = "CASE.toml"
[[parameter]]
key = "material.bending.rigidity"
start = "0.2 gf*cm^2/cm"
"""
CURVE = """[[measured]]
kind = "curve"
nodes = "bottom"
file = "points.csv"
unit = "cm"
sd = "1 mm"
"""


class FitTest(CommandLineTest):
    def computed(self, name):
        """Where the case's own numbers take the cloth: positions of the last frame, material coordinates, node sets."""
        out = self.folder / f"{name}.h5"
        self.done("run", f"{name}.toml", "-o", out, "--force", "--quiet")
        with h5py.File(out) as f:
            return f["frames/position"][-1], f["mesh/material"][:], {k: v[:] for k, v in f["mesh/sets"].items()}

    def profile(self, name="CASE"):
        """Of the cantilever, from the clamp to the tip, without the clamped nodes [m]."""
        q, material, sets = self.computed(name)
        nodes = sets["bottom"][np.argsort(material[sets["bottom"], 0])][2:]
        return q[nodes][:, [0, 2]]

    def fit(self, text, status=0):
        run = self.sundrape("fit", self.write("FIT.toml", text), "-o", "fit", "--quiet")
        self.assertEqual(run.returncode, status, run.stderr)
        return json.loads((self.folder / "fit" / "fit.json").read_text()) if status == 0 else run

    def test_ten_noisy_points_tell_a_rigidity_and_how_well(self):
        """One per cent of noise; the 95 % interval has to hold the truth in 33 to 40 of 40 made-up experiments: fewer
        happen with a probability below 0.1 %, all 40 with 13 %. Nor may it be too wide: what the estimates scatter by,
        which 40 of them tell to 11 %, is their standard error."""
        self.write("CASE.toml", CANTILEVER)
        points = self.profile()
        held, logarithms, errors = 0, [], []
        for seed in range(40):
            noise = 1e-3 * np.random.default_rng(seed).standard_normal(points.shape)
            np.savetxt(self.folder / "points.csv", 100 * (points + noise), delimiter=",", header="x, z [cm]")
            found = self.fit(FIT + CURVE)["parameters"][0]
            self.assertAlmostEqual(found["value"] / TRUTH, 1, delta=0.25)
            held += found["low"] <= TRUTH <= found["high"]
            logarithms.append(np.log(found["value"] / TRUTH))
            errors.append(found["relative_standard_error"])
        self.assertGreaterEqual(held, 33)
        self.assertAlmostEqual(np.std(logarithms) / np.mean(errors), 1, delta=0.35)
        self.assertLess(abs(np.mean(logarithms)), 3 * np.mean(errors) / np.sqrt(40))

    def test_without_noise_the_truth_comes_back(self):
        self.write("CASE.toml", CANTILEVER)
        np.savetxt(self.folder / "points.csv", 100 * self.profile(), delimiter=",")
        found = self.fit(FIT + CURVE)
        self.assertEqual(found["status"], "converged")
        self.assertAlmostEqual(found["parameters"][0]["value"] / TRUTH, 1, delta=1e-4)
        self.assertEqual(found["settings"][0].split("=")[0], "material.bending.rigidity")
        with h5py.File(self.folder / "fit" / "fitted.h5") as f:
            self.assertIn("material.bending.rigidity", f["sensitivity"])

    def test_a_moving_probe_tells_a_rigidity(self):
        self.write("CASE.toml", CANTILEVER.replace('"relaxation"', '"dynamics"') + 'every = "20 ms"\n'
                   '[dynamics]\nduration = "80 ms"\nrtol = 1e-5\n')
        self.done("run", "CASE.toml", "-o", "t.h5", "--quiet")
        with h5py.File(self.folder / "t.h5") as f:
            node = f["probes/tip"].attrs["node"]
            at = {t: f["frames/position"][k, node] for k, t in enumerate(np.round(f["frames/time"][:], 9))}
        measured = "".join(f'[[measured]]\nkind = "probe"\nname = "tip"\ntime = {t}\nx = {at[t][0]}\nz = {at[t][2]}\n'
                           'sd = "0.1 mm"\n' for t in (0.04, 0.08))
        found = self.fit(FIT + measured)["parameters"][0]
        self.assertAlmostEqual(found["value"] / TRUTH, 1, delta=1e-3)

    def test_the_outline_of_a_tablecloth_tells_its_stiffness(self):
        """From the measured shape, for the sake of its branch; 1 % of noise, three seeds of which one interval may miss."""
        case = (CASES / "tablecloth_static.toml").read_text().replace("cells = [20, 20]", "cells = [12, 12]")
        self.write("CASE.toml", case)
        q, _, sets = self.computed("CASE")
        points = q[sets["boundary"]][:, :2]
        fit = ('case = "CASE.toml"\nset = ["cloth.start=CASE.h5"]\n[[parameter]]\nkey = "material.youngs_modulus"\nstart = "90 gf/mm^2"\n'
               '[[measured]]\nkind = "outline"\nfile = "points.csv"\nunit = "cm"\nsd = "2 mm"\n')
        truth, held = 118.1176 * 9806.65, 0
        for seed in range(3):
            noise = 2e-3 * np.random.default_rng(seed).standard_normal(points.shape)
            np.savetxt(self.folder / "points.csv", 100 * (points + noise), delimiter=",")
            found = self.fit(fit)
            self.assertLess(found["residual_variance"], 2)  # of several sd were it another branch
            held += found["parameters"][0]["low"] <= truth <= found["parameters"][0]["high"]
        self.assertGreaterEqual(held, 2)

    def test_numbers_that_cannot_be_told_apart_are_named(self):
        # the profile goes by B over the weight, so their ratio alone shows
        self.write("CASE.toml", CANTILEVER)
        np.savetxt(self.folder / "points.csv", 100 * self.profile(), delimiter=",")
        both = FIT + '[[parameter]]\nkey = "material.weight"\n' + CURVE
        found = self.fit(both)
        self.assertGreater(abs(found["correlation"][0][1]), 0.99)
        self.assertTrue(any("correlated" in w or "combination" in w for w in found["warnings"]), found["warnings"])

    def test_what_has_not_converged_fails_with_what_it_has(self):
        self.write("CASE.toml", CANTILEVER)
        np.savetxt(self.folder / "points.csv", 100 * self.profile(), delimiter=",")
        run = self.fit("max_iterations = 2\n" + FIT + CURVE, status=1)
        self.assertIn("ran out of iterations", run.stderr)
        self.assertEqual(json.loads((self.folder / "fit" / "fit.json").read_text())["runs"], 2)

    def test_what_is_wrong_is_said_with_its_line(self):
        self.write("CASE.toml", CANTILEVER)
        self.write("points.csv", "1 2\n3 x\n")
        for text, message in [
            (FIT.replace("rigidity", "rigidty") + CURVE, r"^.*FIT\.toml:3: parameter\.0\.key: .*did you mean 'rigidity'\?"),
            (FIT + CURVE.replace("points", "nothing"), r"^.*FIT\.toml:8: measured\.0\.file: "),
            (FIT + CURVE.replace('kind = "curve"', 'kind = "height"'), r"^.*FIT\.toml:7: "),
            (FIT.replace("0.2 gf*cm^2/cm", "0.2 gf") + CURVE, r"^.*FIT\.toml:4: parameter\.0\.start: "),
            (FIT + '[[measured]]\nkind = "probe"\nname = "tpi"\nsd = 1\nx = 1\n', r"^.*FIT\.toml:7: .*no probe 'tpi'"),
            (FIT, r"^.*FIT\.toml:1: measured: missing"),
        ]:
            with self.subTest(message):
                self.assertRegex(self.fit(text, status=2).stderr, message)


if __name__ == "__main__":
    unittest.main()
