"""Twenty sheets that fall from random poses onto each other and themselves: minutes a heap, so not a fast test."""
import unittest

import h5py

from command_line import CASES, CommandLineTest
from heap_case import heap_case


class Heap(CommandLineTest):
    timeout = 1800

    def fall(self, seed):
        out, summary = self.run_case(self.write("heap.toml", heap_case(20, seed)))
        with h5py.File(out) as result:
            energy = {name: series[:] for name, series in result["frames/energy"].items()}
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            self.assertEqual(len(result["frames/crossings"]), 101)
            self.assertGreater(result["steps/contacts"][-1], 1000)  # a heap it is
        mechanical = sum(energy[name] for name in ("kinetic", "gravity", "membrane", "shear", "bending", "contact"))
        # what falls loses energy to air, friction and damping; of work from outside there is none but the wind's, which is still
        turned_over = energy["gravity"][0] - energy["gravity"][-1]
        self.assertLessEqual((mechanical - mechanical[0] - energy["external_work"]).max(), 1e-12 * turned_over)
        # with the heat that was seen to arise it is never more than there was, but for the quadrature of that heat
        self.assertGreater(energy["method_dissipated"].min(), -0.01 * turned_over)
        # and it comes to rest
        self.assertLess(energy["kinetic"][-1], 1e-6 * turned_over)
        print(f"seed {seed}: {summary['cpu_seconds']:.0f} s of CPU,"
              f" the method lost {energy['method_dissipated'][-1] / turned_over:.2%} of the energy turned over")

    def test_the_case_is_that_of_the_first_seed(self):
        self.assertEqual((CASES / "heap.toml").read_text(), heap_case(20, 1))

    def test_first_seed(self):
        self.fall(1)

    def test_second_seed(self):
        self.fall(2)

    def test_third_seed(self):
        self.fall(3)


if __name__ == "__main__":
    unittest.main()
