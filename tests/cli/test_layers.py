"""Cloth that touches cloth: stacks, folds and tangles."""
import math
import unittest

import h5py
import numpy as np
from command_line import CASES, GRAVITY, MATERIAL, UNDAMPED, CommandLineTest, sheets

THICKNESS = 0.54229e-3  # of tablecloth-cotton [m]


class Stacks(CommandLineTest):
    def test_every_layer_is_carried_by_the_one_below(self):
        out, summary = self.run_case(CASES / "stacked_sheets.toml")
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            force, x = result["frames/contact_force"][-1, :, 2], result["frames/position"][-1]
            sheets = {name: result[f"mesh/sets/{name}"][:] for name in ("first", "second", "third", "fourth")}
            table = result["frames/obstacle_force/table"][-1, 2]
        # what touches a sheet from both sides is its own weight, so each interface carries all that lies above it
        weights = {
            "first": 0.0144 * 0.2383845714 * 9.80665,
            "second": 0.01 * 0.2665 * 9.80665,
            "third": 0.2383845714 * 9.80665 * (0.045**2 * math.pi),
            "fourth": 0.0036 * 4.019e-3 * 0.278013851 / 0.0254**2,
        }
        for name, nodes in sheets.items():
            # a disc of ten cells is a polygon
            self.assertLess(abs(force[nodes].sum() - weights[name]), (0.02 if name == "third" else 0.01) * weights[name], name)
        self.assertLess(abs(table - summary["weight_N"]), 1e-3 * summary["weight_N"])
        # where sheets lie on each other, inside of all their edges: the mean of their thicknesses, within a tenth
        middle = {name: x[nodes][np.hypot(x[nodes, 0], x[nodes, 1]) < 0.02, 2].mean() for name, nodes in sheets.items()}
        cotton, twill, polyester = 0.54229e-3, 0.489e-3, 0.469e-3
        for below, above, distance in (
            ("first", "second", (cotton + twill) / 2),
            ("second", "third", (twill + cotton) / 2),
            ("third", "fourth", (cotton + polyester) / 2),
        ):
            self.assertLess(abs(middle[above] - middle[below] - distance), 0.1 * distance, (below, above))

    def incline(self, friction, duration, angle=math.radians(20)):
        gravity = [9.80665 * math.sin(angle), 0, -9.80665 * math.cos(angle)]
        sheet = """shape = "rectangle"
size = ["{0} cm", "4 cm"]
cells = [{1}, 4]
place = {{ translate = [0, 0, "{2} mm"] }}
"""
        case = f"""model = "particle"
analysis = "dynamics"
[[cloth]]
name = "below"
{sheet.format(12, 12, 0)}
[[cloth]]
name = "above"
{sheet.format(4, 4, 0.52)}
{UNDAMPED}
[[fix]]
nodes = "below"
[[load]]
kind = "gravity"
acceleration = {gravity}
[contact]
friction = {friction}
[dynamics]
duration = {duration}
rtol = 1e-5
[output]
frames = 20
"""
        out, _ = self.run_case(self.write("incline.toml", case))
        with h5py.File(out) as result:
            above = result["mesh/sets/above"][:]
            return result["frames/time"][:], result["frames/velocity"][:, above, 0].mean(axis=1)

    def test_sheets_on_an_incline_stick(self):
        _, speed = self.incline(1.01 * math.tan(math.radians(20)), 0.5)
        self.assertLess(abs(speed[-1]), 1e-4)  # the speed of creep of contact.friction_speed

    def test_sheets_on_an_incline_slide(self):
        friction, angle = 0.25, math.radians(20)
        time, speed = self.incline(friction, 0.2)
        late = time > 0.08  # it has landed
        found = np.polyfit(time[late], speed[late], 1)[0]
        expected = 9.80665 * (math.sin(angle) - friction * math.cos(angle))
        self.assertLess(abs(found - expected), 0.01 * expected)


class Folds(CommandLineTest):
    def test_a_full_fold_ends_in_layers_that_do_not_cross(self):
        out, summary = self.run_case(CASES / "full_fold.toml")
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            corner = result["frames/position"][-1, -1]
        self.assertLess(corner[2], 3 * THICKNESS)  # it lies on the other half
        self.assert_no_energy_from_nothing(summary)
        self.assertFalse(any("passes through itself" in each for each in summary["warnings"]))

    def test_without_contact_the_run_says_that_cloth_passes_through_itself(self):
        _, summary = self.run_case(CASES / "full_fold.toml", "contact.self=false", "contact.friction=0", "cloth.cells=[12,12]")
        self.assertTrue(any("passes through itself" in each for each in summary["warnings"]))

    def test_a_ribbon_folds_onto_itself(self):
        out, summary = self.run_case(CASES / "ribbon.toml")
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
        self.assert_no_energy_from_nothing(summary)

    def test_statics_keep_layers_apart_too(self):
        """The strip of folding_strip is laid down by relaxation; with contact its layers stay a thickness apart."""
        out, _ = self.run_case(CASES / "folding_motion.toml", "analysis=relaxation", "cloth.cells=[40,1]", "contact.self=true", "motion.0.path.centre=[0,0,0.0005]")
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)


class Tangles(CommandLineTest):
    def test_sheets_dropped_in_a_heap_never_cross(self):
        random = np.random.default_rng(7)
        poses = [((*random.uniform(-0.01, 0.01, 2).round(4), 0.05 + 0.09 * k), random.normal(size=3).round(3), round(random.uniform(0, 3), 3))
                 for k in range(5)]
        poses = [(tuple(map(float, place)), tuple(map(float, axis)), float(angle)) for place, axis, angle in poses]
        out, summary = self.run_case(self.write("heap.toml", f"""model = "particle"
analysis = "dynamics"
{sheets(poses)}
{MATERIAL}
{GRAVITY}
[[obstacle]]
kind = "plane"
friction = 0.3
[contact]
friction = 0.3
[dynamics]
duration = "0.6 s"
[output]
frames = 60
"""))
        with h5py.File(out) as result:
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            self.assertGreater(result["steps/contacts"][-1], 50)
        self.assert_no_energy_from_nothing(summary)

    def crossed(self, more=""):
        return self.write("crossed.toml", f"""model = "particle"
analysis = "dynamics"
{sheets([((0, 0, 0), (0, 0, 1), 0), ((0.001, 0.002, 0.02), (1, 0, 0), 1.5)])}
{MATERIAL}
{GRAVITY}
{more}
[dynamics]
duration = "0.3 s"
[output]
frames = 10
""")

    def test_a_case_that_starts_tangled_is_refused_with_its_pairs(self):
        refused = self.sundrape("run", self.crossed(), "-o", "out.h5")
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(refused.stderr, r"starts by passing through cloth: \d+ pairs of triangles, with the nodes \(\d+, \d+, \d+\) and")
        self.assertNotIn("out.h5", self.files())
        # where nobody asked for contact it is not an error, but the run says so
        _, summary = self.run_case("crossed.toml", "contact.self=false")
        self.assertTrue(any("passes through itself" in each for each in summary["warnings"]))

    def test_held_sheets_driven_through_each_other_stop_the_run_with_the_pair_and_the_place(self):
        case = self.write("driven.toml", f"""model = "particle"
analysis = "dynamics"
{sheets([((0, 0, 0), (0, 0, 1), 0), ((0, 0, 0.01), (0, 0, 1), 0.3)])}
{MATERIAL}
{GRAVITY}
[[fix]]
nodes = "cloth0.boundary"
[[motion]]
nodes = "cloth1.all"
components = ["x", "y", "z"]
path = {{ kind = "line", by = [0, 0, "-20 cm"], duration = "0.5 s" }}
[dynamics]
duration = "1 s"
[output]
frames = 20
""")
        out, _ = self.run_case(case, "material.breaking_strain=100", status=1)
        self.assertRegex(self.message, r"cloth would pass through cloth, (node \d+ through|the edge of nodes) .*, at \(.*\) m")
        with h5py.File(out) as result:
            self.assertEqual(result.attrs["status"].decode(), "failed")
            self.assertEqual(result["frames/crossings"][:].sum(), 0)
            self.assertGreater(len(result["frames/time"]), 1)


if __name__ == "__main__":
    unittest.main()
