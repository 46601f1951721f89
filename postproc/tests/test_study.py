"""Figures of studies: which points make a curve, what is written and what is refused."""

import json
import unittest

import numpy as np

from sundrape_postproc import study
from tests.test_folders import Folders
from tests.test_pictures import command


def figure(**changes) -> dict:
    return {"name": "work", "x": "steps", "y": ["error"], "by": "method", "panels": "", "log_x": True, "log_y": True} | changes


class Figures(Folders):
    """Errors that fall with the square of the steps, three times larger of the second method."""

    RTOL = (1e-3, 1e-4, 1e-5)

    def setUp(self):
        super().setUp()
        runs = []
        for k, rtol in enumerate(self.RTOL):
            for method, factor in (("one", 1), ("two", 3)):
                steps = 100 * 2**k
                runs.append({"values": {"rtol": f"{rtol:g}", "method": method}, "outputs": {"steps": steps, "error": factor / steps**2}})
        del runs[-1]["outputs"]["error"]  # a run that failed
        self.study = {
            "format": "sundrape study",
            "title": "Sample",
            "axes": [
                {"name": "rtol", "values": [f"{x:g}" for x in self.RTOL], "numbers": list(self.RTOL), "unit": ""},
                {"name": "method", "values": ["one", "two"], "unit": ""},
            ],
            "outputs": [{"name": "steps", "unit": ""}, {"name": "error", "unit": "cm"}],
            "runs": runs,
            "figures": [figure()],
        }

    def read(self):
        self.write("study.json", self.study)
        return study.read(self.folder)

    def test_a_curve_runs_along_the_axis_that_the_figure_does_not_name(self):
        read = self.read()
        one, two = study.curves(read, figure(), "error", None)
        np.testing.assert_array_equal(one.x, [100, 200, 400])
        np.testing.assert_allclose(one.y, 1 / one.x**2)
        np.testing.assert_array_equal(two.x, [100, 200])  # without the run that failed
        self.assertAlmostEqual(study.observed_slope(one), -2, places=12)
        self.assertIsNone(study.observed_slope(study.Curve(0, np.array([1.0]), np.array([1.0]))))

    def test_over_an_axis_other_axes_make_a_curve_each(self):
        read = self.read()
        drawn = list(study.curves(read, figure(x="rtol", by=""), "error", None))
        self.assertEqual([list(curve.x) for curve in drawn], [list(self.RTOL), list(self.RTOL[:2])])
        panel = list(study.curves(read, figure(x="rtol", by="", panels="method"), "error", 1))
        self.assertEqual([list(curve.x) for curve in panel], [list(self.RTOL[:2])])

    def test_named_values_are_drawn_in_their_order(self):
        read = self.read()
        chosen = figure(curves=["two", "one"])
        self.assertEqual([len(curve.x) for curve in study.curves(read, chosen, "error", None)], [2, 3])
        page = study.draw(read, chosen)
        colours = [line.get_color() for line in page.axes[0].lines]
        self.assertEqual(colours, [look[0] for look in study.LOOKS[:2]])
        self.assertEqual([text.get_text() for text in page.axes[0].get_legend().get_texts()], ["two", "one"])
        (two,) = study.curves(read, figure(curves=["two"]), "error", None)
        np.testing.assert_allclose(two.y, 3 / two.x**2)

    def test_every_curve_has_a_look_of_its_own(self):
        self.assertEqual(len({marker for _, marker, _ in study.LOOKS}), len(study.LOOKS))
        self.assertEqual(len({(colour, str(dashes)) for colour, _, dashes in study.LOOKS}), len(study.LOOKS))

    def test_a_logarithmic_axis_of_few_values_has_ticks_at_them(self):
        self.study["axes"][0]["numbers"] = [20, 40, 80]
        page = study.draw(self.read(), figure(x="rtol"))
        self.assertEqual([text.get_text() for text in page.axes[0].get_xticklabels()], ["20", "40", "80"])
        self.assertEqual(list(page.axes[0].get_xticks(minor=True)), [])

    def test_every_figure_becomes_a_file(self):
        self.study["figures"] = [figure(slope=-2), figure(name="words", x="method", by="rtol", log_x=False)]
        self.write("study.json", self.study)
        done = command("study", self.folder, "-o", self.folder / "figures", "--format", "svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        self.assertEqual(sorted(p.name for p in (self.folder / "figures").iterdir()), ["words.svg", "work.svg"])
        first = (self.folder / "figures/work.svg").read_bytes()
        command("study", self.folder, "-o", self.folder / "figures", "--format", "svg")
        self.assertEqual((self.folder / "figures/work.svg").read_bytes(), first)

    def test_what_is_refused(self):
        self.write("study.json", self.study)
        self.refused(2, "--figure other: there are work", "study", self.folder, "-o", self.folder, "--figure", "other")
        self.study["figures"] = []
        self.write("study.json", self.study)
        self.refused(2, "describes no figure", "study", self.folder, "-o", self.folder)
        self.write("study.json", json.loads(json.dumps(self.study)) | {"groups": []})
        self.refused(2, "sorts no drapes", "drapes", self.folder, "-o", self.png)


if __name__ == "__main__":
    unittest.main()
