"""The page: what is packed into it comes back, it needs nothing else, and it does in a browser what it should."""

from __future__ import annotations

import json
import os
import re
import shutil
import statistics
import subprocess
import tempfile
import unittest
from dataclasses import replace
from functools import cache
from pathlib import Path

import h5py
import numpy as np

from sundrape_postproc import coding, fields, load, shapes, view
from sundrape_postproc.commands.view import _with_output
from sundrape_postproc.errors import PostprocError
from sundrape_postproc.load import Obstacle, Result
from tests.synthetic import EVERY_KIND, TABLE, bowl, falling_tablecloth, waving, write_result
from tests.test_pictures import Pictures, command

VIEWER = Path(__file__).resolve().parents[1] / "viewer"
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
REQUIRED = os.environ.get("SUNDRAPE_REQUIRE_VIEWER") == "1"
NOT_BUILT = None if view.TEMPLATE.exists() else "the viewer is not built (./dev viewer)"


def missing_for_the_browser() -> str | None:
    """What there is too little of to open pages; None where it is all there."""
    if NOT_BUILT:
        return NOT_BUILT
    if shutil.which("node") is None:
        return "node is missing (apt install nodejs)"
    if CHROMIUM is None:
        return "chromium is missing (apt install chromium)"
    if not (VIEWER / "node_modules/playwright-core").exists():
        return "playwright-core is missing (./dev viewer)"
    return None


def needs(reason: str | None):
    """Skips a class for that reason, unless SUNDRAPE_REQUIRE_VIEWER=1: then it runs, and fails."""
    return unittest.skipIf(reason is not None and not REQUIRED, str(reason))


def add_nodal(path: Path, name: str, values: np.ndarray, units: str) -> None:
    with h5py.File(path, "a") as file:
        file[f"frames/{name}"] = values
        file[f"frames/{name}"].attrs["units"] = units


def script(page: str, name: str) -> str:
    """Text of an element of the page's data."""
    found = re.search(rf'<script type="[a-z/]+" id="{name}">(.*?)</script>', page, re.DOTALL)
    assert found is not None, name
    return found[1]


class Coding(unittest.TestCase):
    def test_series_come_back_bit_by_bit(self) -> None:
        random = np.random.default_rng(2)
        for itemsize in (1, 2):
            codes = random.integers(0, 256**itemsize, (7, 3, 11)).astype(f"uint{8 * itemsize}")
            codes[0, 0, :2] = 0, 256**itemsize - 1  # the longest way wraps around
            back = coding.unpack_series(coding.pack_series(codes), codes.shape, itemsize)
            np.testing.assert_array_equal(back, codes)
            self.assertEqual(back.dtype, codes.dtype)

    def test_positions_come_back_to_half_a_quantum(self) -> None:
        position = waving(cells=12, frames=9).position
        quantised = coding.quantise_positions(position)
        extent = float(np.ptp(position, axis=(0, 1)).max())
        self.assertAlmostEqual(quantised.quantum, extent / 65535, delta=1e-15)
        packed = coding.pack_series(quantised.codes.transpose(0, 2, 1))
        codes = coding.unpack_series(packed, (9, 3, 169), 2).transpose(0, 2, 1)
        back = quantised.low + codes * quantised.quantum
        self.assertLessEqual(np.abs(back - position).max(), quantised.quantum / 2 * (1 + 1e-9))

    def test_a_cloth_that_never_moves_from_a_point_has_a_quantum_too(self) -> None:
        quantised = coding.quantise_positions(np.ones((2, 3, 3)))
        np.testing.assert_array_equal(quantised.values, np.ones((2, 3, 3)))

    def test_fields_come_back_to_half_a_quantum_and_end_at_their_range(self) -> None:
        values = np.array([[-3.0, 0.0, 0.37, 1.0, 7.0, np.nan]])
        quantised = coding.quantise_field(values, 0.0, 1.0)
        np.testing.assert_allclose(quantised.values, [[0, 0, 0.37, 1, 1, 0]], atol=0.5 / 255)

    def test_arrays_come_back_as_written(self) -> None:
        numbers = np.array([0.5, -1e-3, 7e5])
        back = coding.unpack_array(coding.pack_array(numbers, "<f4"), "<f4")
        np.testing.assert_array_equal(back, numbers.astype("f4"))


class Results(Pictures):
    """With results to show in self.folder."""

    def loaded(self, motion, obstacles=None, **options) -> Result:
        return load(write_result(self.result, motion, obstacles, **options))


class Choices(Results):
    """What is put into the page."""

    def test_frames_that_are_not_finite_are_left_out_and_the_ends_stay(self) -> None:
        result = self.loaded(bowl(frames=10))
        broken = result.position.copy()
        broken[4, 0, 0] = np.nan
        broken[9] = np.inf
        shown = view.shown_frames(replace(result, position=broken), None)
        np.testing.assert_array_equal(shown.time, np.delete(result.time, [4, 9]))
        self.assertEqual({len(v) for v in shown.energies.values()}, {8})
        few = view.shown_frames(result, 4)
        np.testing.assert_array_equal(few.time, result.time[[0, 3, 6, 9]])
        self.assertEqual(few.velocity.shape, (4, *result.velocity.shape[1:]))

    def test_a_cloth_with_no_finite_frame_cannot_be_shown(self) -> None:
        result = self.loaded(bowl())
        with self.assertRaisesRegex(PostprocError, "no frame has finite positions"):
            view.shown_frames(replace(result, position=result.position * np.nan), None)

    def test_colours_cover_all_but_the_rarest_values_and_fields_of_nothing_are_left_out(self) -> None:
        result = self.loaded(bowl(frames=20))
        force = np.zeros_like(result.position)
        force[..., 2] = np.linspace(0, 1, force[..., 2].size).reshape(force.shape[:2])
        force[-1, -1, 2] = 1000.0
        shown = {s.field.name: s for s in view.shown_fields(replace(result, contact_force=force))}
        self.assertNotIn("speed", shown)  # it is 0 everywhere
        contact = shown["contact"]
        self.assertTrue(contact.cut_above)
        self.assertFalse(contact.cut_below)
        self.assertEqual(contact.low, 0.0)
        self.assertLess(contact.high, contact.largest / 100)
        exact = np.stack([fields.values(replace(result, contact_force=force), "contact", k) for k in range(20)])
        seen = np.clip(exact, contact.low, contact.high)
        self.assertLessEqual(np.abs(contact.quantised.values - seen).max(), contact.quantised.quantum / 2 * (1 + 1e-9))

    def test_colours_of_what_is_below_zero(self) -> None:
        self.assertEqual(view._range(np.array([-1.0, -0.5])), (-0.9975, 0.0))
        low, high = view._range(np.linspace(-1, 1, 401))
        self.assertAlmostEqual(low, -0.99)
        self.assertAlmostEqual(high, 0.99)
        self.assertEqual(view._range(np.array([-1e-3, 0.5, 1.0]))[0], 0.0)  # a little below is noise

    def test_the_slider_runs_over_time_or_over_frames_where_the_load_turns_back(self) -> None:
        dynamics = view._axis(self.loaded(bowl()))
        self.assertEqual((dynamics["name"], dynamics["unit"], dynamics["perSecond"]), ("time", "s", 1.0))
        relaxation = view._axis(self.loaded(bowl(), analysis="relaxation"))
        self.assertEqual((relaxation["name"], relaxation["physical"]), ("pseudo-time", False))
        result = self.loaded(bowl(), analysis="arc-length")
        arc = view._axis(replace(result, time=np.array([0, 0.5, 0.3, 1.0])))
        self.assertEqual((arc["name"], arc["values"], arc["labels"]), ("frame", [0, 1, 2, 3], [0, 0.5, 0.3, 1.0]))
        self.assertEqual(arc["labelName"], "load factor")

    def test_normals_of_bodies_point_out_and_are_split_at_creases_only(self) -> None:
        sphere = Obstacle("sphere", {"radius": 0.1}, np.zeros(3), np.eye(3))
        points, faces = shapes.surface(sphere)
        outward = points[faces] / 0.1
        turned = np.einsum("eki,eki->ek", shapes.corner_normals(points, faces), outward)
        self.assertGreater(turned.min(), np.cos(np.radians(4)))
        corners = np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
        cube = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
        normals = shapes.corner_normals(corners, cube)
        np.testing.assert_allclose(normals, np.broadcast_to(normals[:, :1], normals.shape), atol=1e-12)
        away = np.einsum("ei,ei->e", normals[:, 0], corners[cube].mean(axis=1) - 0.5)
        np.testing.assert_allclose(away, 0.5)

    def test_probes_know_their_node(self) -> None:
        write_result(self.result, bowl())
        self.assertIsNone(load(self.result).probes["tip"].node)
        with h5py.File(self.result, "a") as file:
            file["probes/tip"].attrs["node"] = 48
        self.assertEqual(load(self.result).probes["tip"].node, 48)

    def test_the_command_of_its_own_writes_beside_the_result(self) -> None:
        self.assertEqual(_with_output(["a/b.h5"]), ["a/b.h5", "-o", "a/b.html"])
        self.assertEqual(_with_output(["b.h5", "--frames", "9"]), ["b.h5", "--frames", "9", "-o", "b.html"])
        for given in (["b.h5", "-o", "c.html"], ["b.h5", "--output=c.html"], ["--help"], []):
            self.assertEqual(_with_output(given), given)


@needs(NOT_BUILT)
class Pages(Results):
    """The file that the command writes."""

    def page(self, *arguments: object) -> str:
        written = self.folder / "page.html"
        done = command("view", *arguments, "-o", written)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        return written.read_text(encoding="utf-8")

    def test_it_holds_the_positions_and_fields_of_the_result(self) -> None:
        result = self.loaded(falling_tablecloth(cells=6, frames=8), EVERY_KIND)
        page = self.page(self.result)
        about = json.loads(script(page, "about"))
        self.assertEqual((about["nodes"], about["frames"], about["quads"]), (49, 8, 36))
        codes = coding.unpack_series(script(page, "positions"), (8, 3, 49), 2).transpose(0, 2, 1)
        back = np.array(about["low"]) + codes * about["quantum"]
        self.assertLessEqual(np.abs(back - result.position).max(), about["quantum"] / 2 * (1 + 1e-9))
        for field in about["fields"]:
            codes = coding.unpack_series(script(page, f"field-{field['name']}"), (8, 1, 49), 1)[:, 0]
            quantum = (field["high"] - field["low"]) / 255
            exact = np.stack([fields.values(result, field["name"], k) for k in range(8)])
            exact = np.clip(exact, field["low"], field["high"])
            self.assertLessEqual(np.abs(field["low"] + codes * quantum - exact).max(), quantum / 2 * (1 + 1e-9))
        self.assertEqual([f["name"] for f in about["fields"]], ["strain", "curvature", "speed"])
        self.assertEqual([o["name"] for o in about["obstacles"]], sorted(EVERY_KIND))
        np.testing.assert_array_equal(
            coding.unpack_array(script(page, "quads"), "<u4").reshape(-1, 4), result.quads
        )

    def test_it_refers_to_nothing_outside_and_says_so_to_the_browser(self) -> None:
        page = self.page(write_result(self.result, bowl(), TABLE, title='</script><b> & "cloth"'))
        self.assertNotRegex(page, r"""(?i)\b(src|href)\s*=\s*["']?\s*(https?:)?//""")
        self.assertNotRegex(page, r"""(?i)(@import|\bimport\s*\(|url\(\s*["']?https?:)""")
        self.assertIn("default-src 'none'", page)
        self.assertIn("<title>&lt;/script&gt;&lt;b&gt; &amp; &quot;cloth&quot;</title>", page)
        self.assertEqual(json.loads(script(page, "about"))["title"], '</script><b> & "cloth"')

    def test_frames_can_be_left_out(self) -> None:
        write_result(self.result, bowl(frames=30))
        about = json.loads(script(self.page(self.result, "--frames", "10"), "about"))
        self.assertEqual((about["frames"], about["framesInFile"]), (10, 30))

    def test_what_it_refuses(self) -> None:
        write_result(self.result, bowl())
        self.refused(2, "must end in .html", "view", self.result, "-o", self.png)
        self.refused(3, "absent.h5: No such file", "view", self.folder / "absent.h5", "-o", self.folder / "page.html")
        (self.folder / "text.h5").write_text("no HDF5")
        self.refused(2, "not a sundrape result", "view", self.folder / "text.h5", "-o", self.folder / "page.html")


class NotBuilt(Results):
    def test_it_says_how_to_build_the_viewer(self) -> None:
        result = self.loaded(bowl())
        built, view.TEMPLATE = view.TEMPLATE, self.folder / "absent.html"
        self.addCleanup(setattr, view, "TEMPLATE", built)
        with self.assertRaisesRegex(PostprocError, r"\./dev viewer"):
            view.page(result)


@cache
def driven() -> tuple[dict, Result, dict[str, int]]:
    """What the browser did with a tablecloth of 441 nodes and 100 frames and others; the tablecloth; sizes of pages."""
    if missing := missing_for_the_browser():
        raise AssertionError(missing)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        motion = falling_tablecloth(frames=100)
        path = write_result(folder / "tablecloth.h5", motion, TABLE)
        add_nodal(path, "contact_force", 0.01 * np.abs(motion.velocity), "N")
        add_nodal(path, "energy_density", 1e-4 + 0.3 * motion.position[..., 2] ** 2, "J/m²")
        with h5py.File(path, "a") as file:
            file["probes/tip"].attrs["node"] = 440
        failing = write_result(folder / "failed.h5", bowl(), EVERY_KIND, status="failed")
        with h5py.File(failing, "a") as file:
            file.attrs["message"] = "the step became too small at t = 0.3"
            file["warnings"] = ["a thread folds by 167°"]
        big = write_result(folder / "big.h5", waving(), TABLE)
        result = load(path)
        pages = {}
        for page in (path, failing, big):
            view.write(load(page), page.with_suffix(".html"))
            pages[page.stem] = page.with_suffix(".html").stat().st_size
        task = {
            "chromium": CHROMIUM,
            "page": str(path.with_suffix(".html")),
            "failed": str(failing.with_suffix(".html")),
            "big": str(big.with_suffix(".html")),
            "frames": [0, 37, 99],
            "nodes": [220, 0, 440, 130, 301],
            "position": result.position[0].tolist(),
        }
        (folder / "task.json").write_text(json.dumps(task))
        done = subprocess.run(
            ["node", str(VIEWER / "test/drive.mjs"), str(folder / "task.json")],
            capture_output=True,
            text=True,
            timeout=400,
        )
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        return json.loads(done.stdout), result, pages


@needs(missing_for_the_browser())
class Browser(unittest.TestCase):
    """In headless Chromium, which draws without a graphics card."""

    def setUp(self) -> None:
        self.report, self.result, self.sizes = driven()

    def test_it_is_small_and_soon_there(self) -> None:
        self.assertLess(self.sizes["tablecloth"], 3e6)
        self.assertLess(statistics.median(self.report["firstFrames"][1:]), 1000, self.report["firstFrames"])

    def test_nothing_is_fetched_and_nothing_complained_of(self) -> None:
        self.assertEqual(self.report["requests"], [])
        self.assertEqual(self.report["messages"], [])
        self.assertEqual(self.report["heading"], "Tablecloth on a square table")

    def test_time_runs_as_fast_as_asked(self) -> None:
        for played in self.report["played"]:
            rate = played["advanced"] / played["seconds"] / played["speed"]
            self.assertAlmostEqual(rate, 1, delta=0.02, msg=str(played))
            self.assertGreater(played["pictures"], 1)
            self.assertTrue(played["stands"])  # paused, it is a frame of the file
        end = self.report["end"]
        self.assertEqual((end["time"], end["playing"]), (end["last"], False))

    def test_scrubbing_shows_exactly_that_frame(self) -> None:
        half = coding.quantise_positions(self.result.position).quantum / 2
        for name, shown in self.report["frames"].items():
            frame = int(name)
            self.assertEqual(shown["frame"], frame)
            self.assertAlmostEqual(shown["time"], self.result.time[frame], delta=1e-12)
            wrong = np.abs(np.reshape(shown["positions"], (-1, 3)) - self.result.position[frame]).max()
            self.assertLessEqual(wrong, half + 1e-8)  # the page counts in 32 bits
            self.assertIn(f"frame {frame} of 99", shown["clock"])
            self.assertAlmostEqual(shown["cursor"], frame / 99, delta=0.001)

    def test_a_click_on_a_node_picks_it_and_tells_where_it_is(self) -> None:
        for pick in self.report["picks"]:
            self.assertEqual(pick["picked"], pick["node"])
            x, y, z = 1000 * self.result.position[0, pick["node"]]
            numbers = [float(n.replace("−", "-")) for n in re.findall(r"(−?[\d.]+) mm", pick["card"])]
            np.testing.assert_allclose(numbers, [x, y, z, 0], atol=0.006)
        self.assertIsNone(self.report["pickedInTheSky"])
        marker = self.report["marker"]
        for axis in "xy":
            self.assertAlmostEqual(marker["shown"][axis], marker["wanted"][axis], delta=0.2)

    def test_dragging_turns_the_view_and_reset_brings_it_back(self) -> None:
        orbit = self.report["orbit"]
        self.assertGreater(orbit["turned"], 0.1)
        self.assertLess(orbit["back"], 1e-6)
        self.assertIsNone(orbit["pickedByDragging"])

    def test_colours_change_the_picture_and_their_legends_have_units(self) -> None:
        units = {"strain": "[%]", "curvature": "[1/m]", "contact": "[Pa]", "energy": "J/m²]", "speed": "m/s]"}
        self.assertEqual(self.report["colours"].keys(), units.keys())
        for name, unit in units.items():
            colour = self.report["colours"][name]
            self.assertGreater(colour["changed"], 0.2, name)
            self.assertIn(unit, colour["legend"])
            self.assertIn(fields.field(name).label, colour["legend"])
            exact = fields.values(self.result, name, 60)
            item = next(s for s in view.shown_fields(self.result) if s.field.name == name)
            wrong = np.abs(colour["values"] - np.clip(exact, item.low, item.high)).max()
            self.assertLessEqual(wrong, 0.5001 * item.quantised.quantum + 1e-6 * item.high)
        self.assertIn("≥", self.report["colours"]["strain"]["legend"])
        self.assertFalse(self.report["legendOfTheWeave"])

    def test_diagrams_have_units_and_a_click_in_them_sets_the_time(self) -> None:
        self.assertIn("x [mm]", self.report["axes"])
        self.assertIn("time [s]", self.report["axes"])
        self.assertTrue(any(re.fullmatch(r"Given and lost \[.?J\]", text) for text in self.report["energies"]))
        self.assertIn("bending", self.report["chips"])
        self.assertLessEqual(abs(self.report["plotClick"]["frame"] - 0.25 * 99), 1)

    def test_keys(self) -> None:
        keyed = self.report["keyed"]
        self.assertEqual([keyed[k]["frame"] for k in ("Home", "ArrowRight", "ArrowLeft", "End")], [0, 2, 1, 99])
        self.assertTrue(keyed["Space"]["playing"])
        self.assertFalse(keyed["c"]["playing"])
        self.assertEqual(keyed["c"]["colour"], "strain")

    def test_it_fits_a_phone_and_its_fingers(self) -> None:
        phone = self.report["phone"]
        self.assertLessEqual(phone["scrollWidth"], 390)
        self.assertEqual((phone["small"], phone["outside"]), ([], []))
        self.assertGreater(phone["canvas"]["height"], 300)
        self.assertEqual(phone["tapped"], 220)
        self.assertTrue(phone["playing"])
        self.assertLessEqual(phone["turnedWidth"], 844)

    def test_a_failed_run_says_why(self) -> None:
        self.assertIn("the step became too small at t = 0.3", self.report["failed"])
        self.assertIn("a thread folds by 167°", self.report["failedInfo"])

    def test_ten_thousand_nodes_cost_less_than_5_ms_a_picture(self) -> None:
        big = self.report["big"]
        self.assertGreater(big["played"]["pictures"], 1)
        self.assertLess(statistics.median(big["costs"]), 5, big)


if __name__ == "__main__":
    unittest.main()
