"""Cloth in air: the drag of a fall, and the wind."""
import math
import unittest

import h5py
from command_line import CASES, GRAVITY, UNDAMPED, CommandLineTest


class Air(CommandLineTest):
    def test_a_flat_sheet_falls_at_its_terminal_velocity(self):
        drag, density = 1.1, 1.2
        out, summary = self.run_case(self.write("fall.toml", f"""model = "particle"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["10 cm", "10 cm"]
cells = [10, 10]
{UNDAMPED}
{GRAVITY}
[[load]]
kind = "wind"
density = {density}
drag = {drag}
[dynamics]
duration = "2 s"
[output]
frames = 10
"""))
        area_weight = summary["weight_N"] / 0.01
        with h5py.File(out) as result:
            speed = -result["frames/velocity"][-1, :, 2]
        self.assertLess(abs(speed - math.sqrt(2 * area_weight / (density * drag))).max(), 2e-3 * speed.mean())
        # what gravity gave and is not motion the air has got
        energy = summary["final"]["energy_J"]
        self.assertLess(abs(energy["method_dissipated"]), 1e-3 * energy["dissipated"])

    def test_a_curtain_in_gusts_takes_its_energy_from_the_wind(self):
        out, summary = self.run_case(CASES / "curtain.toml", "cloth.0.cells=[8,16]", "cloth.1.cells=[8,16]")
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
        energy = summary["final"]["energy_J"]
        self.assertGreater(energy["external_work"], 0)
        self.assert_no_energy_from_nothing(summary)


if __name__ == "__main__":
    unittest.main()
