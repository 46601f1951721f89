"""Numbers of the diagrams: balance, labels, prefixes."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from sundrape_postproc import load
from sundrape_postproc.energies import deepest_penetration, facts, method_dissipation, spread
from sundrape_postproc.units import quantity, scale_for
from tests.synthetic import ENERGIES, bowl, write_result


class Balance(unittest.TestCase):
    def result(self, energies, **options):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        motion = bowl(frames=3)
        motion.energies = {name: np.asarray(energies.get(name, [0, 0, 0]), dtype=float) for name in ENERGIES}
        return load(write_result(Path(folder.name) / "result.h5", motion, **options))

    def test_what_the_balance_lacks_is_lost_by_the_method(self):
        # 5 J of gravity and 1 J of work; 2 J kinetic, 1 J bending, 2.5 J dissipated: 0.5 J missing
        result = self.result(
            {
                "gravity": [7, 5, 2],
                "external_work": [0, 0, 1],
                "kinetic": [0, 2, 2],
                "bending": [0, 0, 1],
                "dissipated": [0, 0, 2.5],
            }
        )
        np.testing.assert_allclose(method_dissipation(result), [0, 0, 0.5], atol=1e-15)

    def test_the_table_names_model_integrator_steps_and_penetration(self):
        result = self.result({}, status="interrupted")
        self.assertEqual(deepest_penetration(result), 3.1e-5)
        rows = dict(facts(result))
        self.assertEqual(rows["integrator"], "CVODE")
        self.assertEqual(rows["deepest penetration"], "31 µm")
        self.assertEqual(rows["steps"], "488 for 300 ms")
        self.assertEqual(rows["status"], "interrupted")


class Labels(unittest.TestCase):
    def test_crowded_labels_part_about_their_middle_and_free_ones_stay(self):
        np.testing.assert_allclose(spread(np.array([0.1, 0.5, 0.5, 0.5]), 0.1), [0.1, 0.4, 0.5, 0.6])
        np.testing.assert_allclose(spread(np.array([0.0, 0.5, 1.0]), 0.1), [0.0, 0.5, 1.0])

    def test_prefixes(self):
        self.assertEqual(scale_for(3.2e-3), (1e3, "m"))
        self.assertEqual(scale_for(1.0), (1.0, ""))
        self.assertEqual(quantity(1e-3, "J"), "1 mJ")
        self.assertEqual(quantity(0.0, "m"), "0 m")


if __name__ == "__main__":
    unittest.main()
