"""The drape tester's case, run and measured, and what theory says of it. For test_cusick.py and verify_drape.py."""
import math
import pathlib
import sys

from command_line import CASES, CommandLineTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "postproc"))
from sundrape_postproc import drape  # noqa: E402
from sundrape_postproc.load import load  # noqa: E402

SUPPORT, OVERHANG = 9.0, 6.0  # [cm]


def free_wedges(bending_length, steps=2000):
    """Drape coefficient of an overhang that is cut into narrow wedges along its radii, each free to bend down by itself.

    A wedge at the distance s from the support is R + s wide. With the bending length c = (B/w)^(1/3) [cm],

        c³ ((R + s) θ')' = -cos θ ∫ from s to L of (R + σ) dσ,   θ = 0 at the clamp, θ' = 0 at the tip.

    Shot from the tip, whose angle is found by bisection; Runge-Kutta's method. Whole cloth resists in hoops besides, so that it
    hangs less: a lower bound that knows of bending alone."""

    def rates(s, angle, moment):
        beyond = SUPPORT * (OVERHANG - s) + (OVERHANG**2 - s**2) / 2
        return moment / (bending_length**3 * (SUPPORT + s)), -math.cos(angle) * beyond, math.cos(angle)

    def clamp(tip):  # angle at the clamp, and how far the wedge reaches
        h, state = -OVERHANG / steps, (tip, 0.0, 0.0)
        for k in range(steps):
            s = OVERHANG + k * h
            a = rates(s, *state[:2])
            b = rates(s + h / 2, *(state[i] + h / 2 * a[i] for i in (0, 1)))
            c = rates(s + h / 2, *(state[i] + h / 2 * b[i] for i in (0, 1)))
            d = rates(s + h, *(state[i] + h * c[i] for i in (0, 1)))
            state = tuple(state[i] + h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) for i in range(3))
        return state[0], -state[2]

    low, high = 0.0, math.pi / 2
    for _ in range(60):
        tip = (low + high) / 2
        low, high = (tip, high) if clamp(tip)[0] < 0 else (low, tip)
    out = clamp(low)[1]
    return ((SUPPORT + out) ** 2 - SUPPORT**2) / ((SUPPORT + OVERHANG) ** 2 - SUPPORT**2)


class DrapeTest(CommandLineTest):
    timeout = 3000

    def drape(self, fabric, *sets):
        """Runs cases/cusick.toml to its end: a stable equilibrium under the whole weight that does not pass through itself."""
        out, summary = self.run_case(CASES / "cusick.toml", f"material.fabric={fabric}", *sets)
        result = load(out)
        self.assertEqual(result.status, "done")
        self.assertEqual(result.time[-1], 1)  # the load factor
        self.assertEqual(summary["final"]["negative_pivots"], 0)
        test = drape.measure(result, result.last_frame)
        self.assertEqual(test.crossings, 0)
        return test
