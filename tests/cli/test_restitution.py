"""Nodes dropped on a floor bounce as the coefficient of restitution says (cases/dropped_node.toml)."""
import unittest

import h5py
import numpy as np

from command_line import CASES, CommandLineTest

GRAVITY = 9.80665
REACH = 0.1 * 0.5e-3  # contact begins a tenth of the thickness above the floor, which is where impacts happen [m]
DROP = 0.1 - REACH  # [m]


class Restitution(CommandLineTest):
    def bounce(self, *settings):
        """Times, heights over the place of impact and vertical velocities of the probed node."""
        out, _ = self.run_case(CASES / "dropped_node.toml", *settings)
        with h5py.File(out) as result:
            probe = result["probes/node"]
            return probe["time"][...], probe["position"][:, 2] - REACH, probe["velocity"][:, 2]

    def apexes(self, height, velocity):
        """Of the flights between impacts: in free flight height + v²/2g stays what it is."""
        rising = (velocity[:-1] > 0) & (velocity[1:] <= 0)
        return (height + velocity**2 / (2 * GRAVITY))[:-1][rising]

    def test_apexes_stand_to_each_other_as_the_coefficient_squared(self):
        for integrator in ("cvode", "ida", "dirk"):
            for coefficient in (0.7, 0.5):
                with self.subTest(integrator=integrator, coefficient=coefficient):
                    _, height, velocity = self.bounce(f"contact.restitution={coefficient}", f"dynamics.integrator={integrator}")
                    # as long as nodes arrive with ten times the speed below which there is no impact
                    count = int(np.log(np.sqrt(2 * GRAVITY * DROP) / (10 * 0.05)) / -np.log(coefficient))
                    heights = np.concatenate([[DROP], self.apexes(height, velocity)[:count]])
                    self.assertGreaterEqual(count, 1)
                    np.testing.assert_allclose(heights[1:] / heights[:-1], coefficient**2, rtol=0.01)

    def test_the_first_impact_is_when_and_as_fast_as_a_fall_says(self):
        time, _, velocity = self.bounce("contact.restitution=0.7")
        first = np.argmax(velocity > 0)
        self.assertAlmostEqual(time[first], np.sqrt(2 * DROP / GRAVITY), delta=1e-4)
        self.assertAlmostEqual(velocity[first] / np.sqrt(2 * GRAVITY * DROP), 0.7, delta=0.001)

    def test_without_loss_the_energy_is_kept_over_three_bounces(self):
        time, height, velocity = self.bounce("contact.restitution=1")
        bounces = np.count_nonzero((velocity[:-1] < 0) & (velocity[1:] > 0))
        self.assertEqual(bounces, 3)
        with h5py.File(self.folder / "out.h5") as result:
            energy = result["frames/energy"]
            total = energy["kinetic"][...] + energy["gravity"][...] + energy["contact"][...]
            weight = 0.2 * 0.01**2 * GRAVITY
            self.assertLess(np.abs(total - total[0]).max() / (weight * DROP), 1e-3)
            self.assertEqual(energy["dissipated"][-1], 0)

    def test_the_energy_of_impacts_is_booked_as_dissipated(self):
        self.bounce("contact.restitution=0.7", "dynamics.duration='0.3 s'")
        with h5py.File(self.folder / "out.h5") as result:
            weight = 0.2 * 0.01**2 * GRAVITY
            self.assertAlmostEqual(result["frames/energy/dissipated"][-1] / (weight * DROP), 1 - 0.7**2, delta=0.002)

    def test_dropped_nodes_come_to_rest_on_the_floor(self):
        _, height, velocity = self.bounce("contact.restitution=0.5", "dynamics.duration='1.5 s'", "material.damping.mass='20 1/s'")
        self.assertLess(abs(velocity[-1]), 1e-3)
        with h5py.File(self.folder / "out.h5") as result:
            weight = 0.2 * 0.01**2 * GRAVITY
            self.assertAlmostEqual(result["frames/contact_force_sum"][-1][2] / weight, 1, delta=0.01)


if __name__ == "__main__":
    unittest.main()
