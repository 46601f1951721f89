"""Reports: what they say, of failed runs above all, and that nothing in them is asked of a server."""

from __future__ import annotations

import re
import shutil
import subprocess
import unittest
from dataclasses import replace

import h5py
import numpy as np

from sundrape_postproc import honest, load, plot, report, report_html, report_pdf
from sundrape_postproc.camera import three_quarter
from sundrape_postproc.errors import PostprocError
from tests.synthetic import TABLE, bowl, write_result
from tests.test_pictures import Pictures

TORN = "at t = 0.124 s the cloth tears: the edge from node 8 at (0.04006, -0.04009, 1.199e-05) m to node 9 is too long"


class Reports(Pictures):
    def setUp(self):
        super().setUp()
        write_result(self.result, bowl(), TABLE)

    def broken(self, message: str) -> None:
        with h5py.File(self.result, "a") as file:
            file.attrs.update(status="failed", message=message)
            file["warnings"] = np.array(["it is <tight>"], dtype=h5py.string_dtype())
            file["statistics"].attrs["descriptions"] = '{"newton_iterations": "iterations of Newton\'s method"}'

    def test_a_failed_run_says_what_and_where_in_one_file(self):
        self.broken(TORN)
        path = self.folder / "run.html"
        self.done("report", self.result, "-o", path)
        page = path.read_text()
        self.assertIn("<title>Tablecloth on a square table</title>", page)
        self.assertIn('class="status failed"', page)
        for text in (
            "the cloth tears",
            "node 8 at (0.04006, -0.04009, 1.199e-05) m",
            "t = 0.124 s",
            "it is &lt;tight&gt;",
        ):
            self.assertIn(text, page)
        self.assertIn("the last good state, frame 3, t = 300 ms; where it failed is marked", page)
        self.assertIn("iterations of Newton&#x27;s method", page)
        for text in (
            "CVODE",
            "49 nodes",
            "sundrape 0.1.0",
            "energy lost by the method",
            "[relaxation]",
            "@media print",
        ):
            self.assertIn(text, page)
        sources = re.findall(r'(?:src|href)="?([^" >]+)|url\(([^)]+)\)|@import', page)
        self.assertEqual(
            len(sources), 1 + 6 + 4
        )  # the failure; cloth and strain at three times; energies, step size, order
        self.assertTrue(all(source[0].startswith("data:image/") for source in sources))
        self.assertNotRegex(page, r"<script|<link")

    def drawn_by_hand(self) -> report.Report:
        """A report without the pictures in space, which take their time."""
        result = load(self.result)
        grey = report.Picture("t = 0 s", np.full((54, 72, 3), 128, np.uint8))
        failed = honest.failure(result)
        return report.Report(
            title=result.title,
            status=result.status,
            failure=failed,
            failed_at=failed and grey,
            ran=[("model", result.model)],
            pictures=[[grey, grey, grey]],
            panels=plot.panels(result, ["energies"]),
            numbers=honest.numbers(result),
            warnings=result.warnings,
            statistics=report.statistics(result),
            case=result.attributes["case"],
        )

    def test_a_page_on_a_run_that_is_done_has_no_failure(self):
        page = report_html.page(self.drawn_by_hand())
        self.assertIn('class="status done"', page)
        self.assertNotIn("failure", page.split("<body>")[1])

    def test_paper(self):
        self.broken(TORN)
        path = self.folder / "run.pdf"
        report_pdf.write(self.drawn_by_hand(), path)
        self.assertGreaterEqual(len(re.findall(rb"/Type\s*/Page\b", path.read_bytes())), 2)
        if shutil.which("pdftotext"):
            text = subprocess.run(["pdftotext", path, "-"], capture_output=True, text=True, check=True).stdout
            for said in ("the cloth tears", "it is <tight>", "deepest penetration", "[relaxation]"):
                self.assertIn(said, text)
        with self.assertRaisesRegex(PostprocError, "cannot be written"):
            report_pdf.write(self.drawn_by_hand(), self.folder)

    def test_statistics_have_units(self):
        result = replace(load(self.result), statistics={"cpu_seconds": 0.25, "deepest_penetration_m": 5e-6, "steps": 7})
        rows = [row[:2] for row in report.statistics(result)]
        self.assertEqual(rows, [("cpu time", "250 ms"), ("deepest penetration", "5 µm"), ("steps", "7")])

    def test_refusals(self):
        self.refused(2, "must end in .html or .pdf", "report", self.result, "-o", self.png)
        self.refused(3, "absent.h5: No such file", "report", self.folder / "absent.h5", "-o", self.folder / "a.html")


class Honesty(Pictures):
    def setUp(self):
        super().setUp()
        self.bowl = load(write_result(self.result, bowl(), TABLE))

    def failed(self, message: str, status: str = "failed") -> honest.Failure:
        return honest.failure(
            replace(self.bowl, attributes={**self.bowl.attributes, "status": status, "message": message})
        )

    def test_places_are_those_of_the_message_or_of_its_nodes(self):
        self.assertIsNone(honest.failure(self.bowl))
        torn = self.failed(TORN)
        ((label, place),) = torn.places
        self.assertEqual((label, torn.time, torn.frame), ("node 8", 0.124, 3))
        np.testing.assert_allclose(place, [0.04006, -0.04009, 1.199e-05])
        ((label, place),) = self.failed("residual 1.49, largest out-of-balance force at node 13; raise it").places
        self.assertEqual(label, "node 13")
        np.testing.assert_array_equal(place, self.bowl.position[3, 13])
        for message in ("no solution", "node 4000000 is bad", "(1, 2) m"):
            self.assertEqual(self.failed(message).places, ())
        self.assertIn("killed", self.failed("", "running").message)

    def test_energy_turned_over_is_half_of_all_changes(self):
        energies = {name: np.zeros(4) for name in self.bowl.energies}
        energies["gravity"] = np.array([4.0, 1.0, 1.0, 1.0])
        energies["kinetic"] = np.array([0.0, 3.0, 1.0, 0.0])
        energies["dissipated"] = np.array([0.0, 0.0, 1.5, 2.5])  # the method loses 0.5 with it
        result = replace(self.bowl, energies=energies)
        self.assertAlmostEqual(honest.turned_over(result), 3 + 2 + 1)
        name, value, meaning = honest.numbers(result)[0]
        self.assertEqual((name, value), ("energy lost by the method", "8.3 %"))
        self.assertIn("500 mJ of 6 J", meaning)

    def test_a_place_is_marked_where_it_is_seen(self):
        nodes = self.bowl.position[3]
        size = (800, 500)
        view = three_quarter(nodes, [], size[0] / size[1])
        seen = view.pixels(nodes, size)
        self.assertTrue((seen > 0).all() and (seen < size).all())
        middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
        np.testing.assert_allclose(middle, [400, 250], atol=3)  # as the camera is made to fit
        higher = view.pixels(nodes + [0, 0, 0.01], size)
        self.assertTrue((higher[:, 1] > seen[:, 1]).all())


if __name__ == "__main__":
    unittest.main()
