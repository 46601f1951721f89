"""Several pieces of cloth in one case: their sets, fabrics and names."""
import unittest

import h5py
from command_line import CASES, GRAVITY, MATERIAL, CommandLineTest, sheets


class Pieces(CommandLineTest):
    def test_sets_and_fabrics_of_pieces(self):
        case = self.write("two.toml", f"""model = "shell"
analysis = "relaxation"
[[cloth]]
name = "one"
shape = "rectangle"
size = ["8 cm", "2 cm"]
cells = [8, 2]
[[cloth]]
name = "two"
shape = "rectangle"
size = ["8 cm", "2 cm"]
cells = [8, 2]
place = {{ translate = [0, "5 cm", 0] }}
material = {{ fabric = "cotton-twill" }}
{MATERIAL}
{GRAVITY}
[[fix]]
name = "hands"
nodes = "left"
[[fix]]
name = "corner"
nodes = "two.top_right"
components = ["y"]
""")
        out, summary = self.run_case(case)
        self.assertEqual(summary["final"]["negative_pivots"], 0)
        with h5py.File(out) as result:
            hands = result["frames/reaction/hands"][-1, 2]
            x = result["frames/position"][-1]
            tips = [x[result[f"mesh/sets/{name}.right"][:], 2].mean() for name in ("one", "two")]
        self.assertLess(abs(-hands - summary["weight_N"]), 1e-3 * summary["weight_N"])
        # each alone hangs as it does beside the other
        alone = """model = "shell"
analysis = "relaxation"
[cloth]
shape = "rectangle"
size = ["8 cm", "2 cm"]
cells = [8, 2]
{}
{}
[[fix]]
nodes = "left"
"""
        # The pieces do not touch, and the hold of the corner in y has nothing to hold: the strips bend in x and z. So both
        # runs have the same equilibrium, each up to the 1e-6 of the weight that relaxation.tolerance leaves unbalanced. That
        # moves a tip by less than this part of the strip's length: at tolerances from 1e-1 to 1e-6 by at most 0.013 of it.
        length, unbalanced = 0.08, 1e-6
        for tip, material in zip(tips, (MATERIAL, '[material]\nfabric = "cotton-twill"\n')):
            out, _ = self.run_case(self.write("alone.toml", alone.format(material, GRAVITY)))
            with h5py.File(out) as result:
                right = result["frames/position"][-1][result["mesh/sets/right"][:], 2].mean()
            self.assertLess(abs(tip - right), 2 * unbalanced * length)

    def test_a_piece_must_not_be_called_like_a_set(self):
        case = f"""model = "particle"
analysis = "relaxation"
{sheets([((0, 0, 0), (0, 0, 1), 0), ((0, 0, 0.1), (0, 0, 1), 0)]).replace('shape', 'name = "left"' + chr(10) + 'shape', 1)}
{MATERIAL}
{GRAVITY}
"""
        refused = self.sundrape("check", self.write("left.toml", case))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("a piece cannot be called 'left'", refused.stderr)

    def test_errors_name_the_piece(self):
        case = f"""model = "particle"
analysis = "relaxation"
{sheets([((0, 0, 0), (0, 0, 1), 0), ((0, 0, 0.1), (0, 0, 1), 0)])}material = {{ fabric = "siilk" }}
{MATERIAL}
{GRAVITY}
"""
        refused = self.sundrape("check", self.write("silk.toml", case))
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(refused.stderr, r"silk.toml:\d+: cloth.1.material.fabric: there is no fabric 'siilk'")

    def test_crosschecks_are_for_single_sheets(self):
        refused = self.sundrape("crosscheck", CASES / "stacked_sheets.toml")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("shapes of one sheet", refused.stderr)


if __name__ == "__main__":
    unittest.main()
