"""Cloth in contact with cloth by whatever method and model: integrators against each other, shells, a run taken up again."""
import signal
import time
import unittest

import h5py
import numpy as np

from command_line import GRAVITY, MATERIAL, CommandLineTest

# Two sheets, the upper one turned, a little above the lower one, which is held by its rim; it falls on it and bounces.
TWO = f"""model = "particle"
analysis = "dynamics"
[[cloth]]
name = "lower"
shape = "rectangle"
size = ["6 cm", "6 cm"]
cells = [4, 4]
[[cloth]]
name = "upper"
shape = "rectangle"
size = ["5 cm", "5 cm"]
cells = [4, 4]
place = {{ translate = ["1 mm", "2 mm", "1.2 mm"], rotate = {{ axis = [0, 0, 1], angle = 0.3 }} }}
{MATERIAL}
[[fix]]
nodes = "lower.boundary"
{GRAVITY}
[contact]
stiffness = 1e6
"""
THICKNESS = 0.5e-3  # of MATERIAL [m]


class ContactByOtherMethods(CommandLineTest):
    def frames(self, name):
        with h5py.File(self.folder / name) as result:
            self.assertEqual(result.attrs["status"].decode(), "done")
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            return result["frames/position"][:], result["steps/contacts"][:].max()

    def test_all_integrators_see_the_same_bounce(self):
        case = self.write("two.toml", TWO + """[dynamics]
duration = "60 ms"
rtol = 1e-7
[output]
frames = 6
""")
        ends = {}
        # damping that is stiff would make the explicit method creep
        for integrator in ("cvode", "ida", "dirk", "rk4"):
            self.done("run", case, "--quiet", "-o", f"{integrator}.h5", "--set", f"dynamics.integrator={integrator}",
                      "--set", "material.damping.membrane=0.1 ms", "--set", "material.damping.bending=0.1 ms")
            ends[integrator], contacts = self.frames(f"{integrator}.h5")
            self.assertGreater(contacts, 5)
        way = np.ptp(ends["rk4"][:, 25:, 2], axis=0).max()
        self.assertGreater(way, 4 * THICKNESS)
        # the methods share no code but the forces; a fiftieth of the thickness is below what the law of contact resolves
        for integrator in ("cvode", "ida", "dirk"):
            self.assertLess(abs(ends[integrator] - ends["rk4"]).max(), THICKNESS / 50, integrator)

    def test_shells_lie_on_each_other_too(self):
        """By CVODE with rotary inertia, and by IDA without: the same layers, a thickness apart."""
        for director, integrator in (("inertia", "cvode"), ("massless", "ida")):
            case = self.write("shells.toml", TWO.replace('"particle"', '"shell"') + f"""[shell]
director = "{director}"
[dynamics]
integrator = "{integrator}"
duration = "0.8 s"
[output]
frames = 20
""")
            # held everywhere, the lower shell does not sag; corners of the upper one hang over it
            self.done("run", case, "--quiet", "-o", f"{director}.h5", "--set", "fix.0.nodes=lower.all")
            x, _ = self.frames(f"{director}.h5")
            upper = x[-1, 25:50]
            middle = np.hypot(upper[:, 0], upper[:, 1]) < 0.02
            self.assertLess(abs(upper[middle, 2] - THICKNESS).max(), 0.1 * THICKNESS, director)

    def test_a_run_in_contact_can_be_taken_up_again(self):
        case = self.write("two.toml", TWO + """friction = 0.3
[dynamics]
duration = "1 s"
rtol = 1e-5
[output]
frames = 100
checkpoint_every = "20 ms"
""")
        self.done("run", case, "--quiet", "-o", "whole.h5")
        whole, _ = self.frames("whole.h5")
        run = self.start("run", case, "-o", "broken.h5")
        deadline = time.monotonic() + 30
        while not (self.folder / "broken.h5").exists() and time.monotonic() < deadline:
            time.sleep(0.002)
        time.sleep(0.1)
        run.send_signal(signal.SIGINT)
        errors = run.communicate(timeout=30)[1]
        self.assertEqual(run.returncode, 130, errors)
        with h5py.File(self.folder / "broken.h5") as result:
            broken_at = result["frames/time"][-1]
        self.assertLess(broken_at, 1)
        self.done("run", case, "--quiet", "--resume", "broken.h5")
        resumed, _ = self.frames("broken.h5")
        self.assertEqual(len(resumed), len(whole))
        # at rest in the end, it forgets by which steps it came there, but for how far the sheets crept upon each other
        self.assertLess(abs(resumed[-1] - whole[-1]).max(), THICKNESS / 10)


if __name__ == "__main__":
    unittest.main()
