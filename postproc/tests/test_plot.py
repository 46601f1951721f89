"""Diagrams: which ones a result has, what is on their axes, and where the curves are."""

from __future__ import annotations

import unittest
from dataclasses import replace

import h5py
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from sundrape_postproc import load, plot
from sundrape_postproc.load import Result
from tests.synthetic import TABLE, bowl, write_result
from tests.test_pictures import Pictures


def arc(result: Result) -> Result:
    """The result as that of a path of two stages over 4 frames, with two critical points at its last frame."""
    probe = replace(result.probes["tip"], position=result.position[1:, 5], load_factor=np.array([0.5, 1, 0.5]), node=5)
    critical = {
        "load_factor": np.array([0.7, 0.6]),
        "limit_point": np.array([1, 0]),
        "position": np.stack([result.position[3], result.position[3]]),
    }
    stage = np.array([1, 1, 2])
    return replace(
        result,
        attributes={**result.attributes, "analysis": "arc-length"},
        time=np.array([0, 0.5, 1, 0.5]),
        steps={
            "load_factor": probe.load_factor,
            "stage": stage,
            "arc_length": np.full(3, 0.1),
            "residual": np.full(3, 1e-8),
        },
        probes={"crown": probe},
        critical=critical,
    )


class Plots(Pictures):
    def setUp(self):
        super().setUp()
        self.addCleanup(plt.close, "all")
        write_result(self.result, bowl(), TABLE)
        with h5py.File(self.result, "a") as file:
            force = np.outer(np.arange(4), [0, 0, 0.1])
            file["frames/reaction/left"] = force
            file["steps/error_test_failures"] = np.arange(488) == 100
        self.loaded = load(self.result)

    def named(self, figure: Figure) -> dict:
        return {axes.get_title(loc="left"): axes for axes in figure.axes}

    def test_every_axis_has_a_unit(self):
        for result in (self.loaded, arc(self.loaded)):
            for axes in plot.plot(result).axes:
                for label in (axes.get_xlabel(), axes.get_ylabel()):
                    self.assertRegex(label, r"\[(1|[pnµmkM]?(s|m|J|N))\]$", axes.get_title(loc="left"))

    def test_all_that_a_motion_has(self):
        titles = list(self.named(plot.plot(self.loaded)))
        self.assertEqual(
            titles,
            [
                "Energy (gravity: change from the start)",
                "Energy stored in the cloth and its contact",
                "Step size",
                "Order of the method",
                "Force of the cloth on “left”",
                "Place of probe “tip”",
            ],
        )

    def test_the_balance_has_what_the_method_lost(self):
        axes = self.named(plot.plot(self.loaded, ["energies"]))["Energy (gravity: change from the start)"]
        self.assertIn("lost by method", [text.get_text() for text in axes.texts])

    def test_steps_are_logarithmic_and_rejected_ones_marked(self):
        axes = self.named(plot.plot(self.loaded, ["steps"]))
        size = axes["Step size"]
        self.assertEqual(size.get_yscale(), "log")
        np.testing.assert_allclose(size.lines[0].get_ydata(), 2e-3)
        self.assertEqual([t.get_text() for t in size.get_legend().get_texts()], ["error too large: 1"])
        self.assertAlmostEqual(size.lines[1].get_xdata()[0], 1e3 * self.loaded.steps["time"][100])
        self.assertEqual(axes["Order of the method"].lines[0].get_drawstyle(), "steps-pre")

    def test_the_path_of_loads_starts_unloaded_and_has_its_critical_points(self):
        axes = self.named(plot.plot(arc(self.loaded), ["load"]))["Path of “crown”"]
        self.assertRegex(axes.get_xlabel(), r"displacement along z \[mm\]")
        first, second = axes.lines[:2]
        np.testing.assert_allclose(first.get_ydata(), [0, 0.5, 1])
        moved = 1e3 * (self.loaded.position[:, 5, 2] - self.loaded.position[0, 5, 2])
        np.testing.assert_allclose(first.get_xdata(), moved[:3])
        np.testing.assert_allclose(second.get_xdata(), moved[2:])
        np.testing.assert_allclose(second.get_ydata(), [0, 0.5])
        labels = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(labels, ["stage 1", "stage 2", "limit point", "path forks"])
        self.assertEqual(axes.lines[2].get_ydata()[0], 0.7)

    def test_residuals_of_statics_stand_against_the_tolerance(self):
        write_result(self.result, bowl(), analysis="relaxation")
        (axes,) = plot.plot(load(self.result), ["residual"]).axes
        self.assertEqual(axes.get_yscale(), "log")
        np.testing.assert_allclose(axes.lines[1].get_ydata(), 1e-6)

    def test_files_for_paper_and_screen(self):
        for kind, start in ((".pdf", b"%PDF"), (".svg", b"<?xml"), (".png", b"\x89PNG")):
            path = self.folder / f"plot{kind}"
            self.done("plot", self.result, "-o", path, "--what", "energies,steps")
            self.assertTrue(path.read_bytes().startswith(start))

    def test_what_is_not_there_is_said(self):
        self.refused(2, "there are energies, steps", "plot", self.result, "-o", self.png, "--what", "colours")
        self.refused(2, "--what load: .*dynamics", "plot", self.result, "-o", self.png, "--what", "load")
        self.refused(2, "must end in .png or .pdf or .svg", "plot", self.result, "-o", self.folder / "a.jpg")


if __name__ == "__main__":
    unittest.main()
