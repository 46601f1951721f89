"""Films as players see them: read back with ffprobe and decoded with ffmpeg. Colours of fields at their nodes."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from sundrape_postproc import colours, fields, film, load, moments
from sundrape_postproc.errors import PostprocError
from sundrape_postproc.surface import SmoothSurface
from tests.synthetic import TABLE, bowl, swing, write_result
from tests.test_pictures import HOME, Pictures

MISSING = not all(map(shutil.which, ("ffmpeg", "ffprobe")))
SMALL = ("--size", "320x180", "--jobs", 1)


@unittest.skipIf(MISSING and os.environ.get("SUNDRAPE_REQUIRE_FILM") != "1", "needs ffmpeg: ./dev setup film")
class Films(Pictures):
    def filmed(self, name: str, *arguments: object) -> dict:
        """Runs a command that must succeed in silence; what ffprobe says of the film's stream."""
        self.film = self.folder / name
        self.done("film", self.result, "-o", self.film, *arguments)
        asked = ["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json", str(self.film)]
        (stream,) = json.loads(subprocess.run(asked, capture_output=True, check=True).stdout)["streams"]
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith(".")], [])
        return stream

    def pixels(self, stream: dict) -> np.ndarray:
        """All pictures of the film (K, height, width, 3) in 0..255."""
        asked = ["ffmpeg", "-v", "error", "-i", str(self.film), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
        raw = subprocess.run(asked, capture_output=True, check=True).stdout
        return np.frombuffer(raw, np.uint8).reshape(-1, stream["height"], stream["width"], 3).astype(float)

    def test_a_film_runs_as_long_as_the_motion_in_the_format_of_all_players(self):
        write_result(self.result, bowl(), TABLE)  # 0.3 s in 4 frames
        stream = self.filmed("a.mp4", "--size", "321x181", "--fps", 20, "--speed", 0.5, "--jobs", 2)
        self.assertEqual((stream["codec_name"], stream["pix_fmt"]), ("h264", "yuv420p"))
        self.assertEqual((stream["width"], stream["height"]), (320, 180))
        self.assertEqual(stream["r_frame_rate"], "20/1")
        self.assertEqual(int(stream["nb_read_frames"]), 13)
        self.assertAlmostEqual(float(stream["duration"]), 13 / 20, places=3)
        start = self.film.read_bytes()
        self.assertLess(start.index(b"moov"), start.index(b"mdat"))  # plays while it loads
        pictures = self.pixels(stream)
        self.assertGreater(pictures[0].std(), 10)
        self.assertGreater(np.abs(pictures[-1] - pictures[0]).mean(), 2)
        steps = np.abs(np.diff(pictures, axis=0)).mean(axis=(1, 2, 3))
        self.assertLess(steps.max(), 8 * np.median(steps))  # moves on between the frames of the result, without jumps
        corner = pictures[:, 60:90, -20:]
        self.assertLess(np.ptp(corner.mean(axis=(1, 2)), axis=0).max(), 1.0)  # the background stands still

    def test_a_gif_of_chosen_frames_from_a_camera_that_goes_round(self):
        write_result(self.result, swing(frames=9), analysis="relaxation")
        fixed = self.pixels(self.filmed("fixed.gif", *SMALL, "--frames", "::2"))
        stream = self.filmed("round.gif", *SMALL, "--frames", "::2", "--camera", "orbit", "--turns", 0.5)
        self.assertEqual((stream["codec_name"], int(stream["nb_read_frames"])), ("gif", 5))
        self.assertEqual(stream["avg_frame_rate"], "10/1")
        self.assertGreater(np.abs(self.pixels(stream)[-1] - fixed[-1]).mean(), 1)

    def test_a_film_coloured_by_a_field_has_its_colours(self):
        write_result(self.result, bowl(), TABLE)
        plain = self.pixels(self.filmed("plain.mp4", *SMALL, "--frames", "2:", "--fps", 10))
        stream = self.filmed("coloured.mp4", *SMALL, "--frames", "2:", "--fps", 10, "--colour", "curvature")
        difference = np.abs(self.pixels(stream)[-1] - plain[-1]).max(axis=2) > 30
        self.assertGreater(difference[40:140].mean(), 0.1)  # the cloth
        self.assertGreater(difference[160:, :110].mean(), 0.1)  # the legend

    def test_ctrl_c_leaves_nothing_behind(self):
        write_result(self.result, bowl(), TABLE)
        path = self.folder / "long.mp4"
        run = [sys.executable, "-m", "sundrape_postproc", "film", self.result, "-o", path, *SMALL[:2], "--fps", 2000]
        process = subprocess.Popen(
            list(map(str, run)),
            env=os.environ | {"PYTHONPATH": str(HOME)},
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        wait = time.monotonic() + 60
        while not any(self.folder.glob(".long.mp4-*/film.mp4")) and time.monotonic() < wait:
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)
        said = process.communicate(timeout=60)[1].decode()
        self.assertEqual((process.returncode, said), (130, ""))
        self.assertEqual([p.name for p in self.folder.iterdir()], [self.result.name])


class Refusals(Pictures):
    def test_without_ffmpeg_the_package_is_named(self):
        write_result(self.result, bowl())
        self.refused(3, "apt install ffmpeg", "film", self.result, "-o", self.folder / "a.mp4", DISPLAY=":0", PATH="")

    def test_what_cannot_be_filmed(self):
        write_result(self.result, bowl())
        out = ("-o", self.folder / "a.mp4")
        if not MISSING:
            self.refused(2, "picks none of the 4 frames", "film", self.result, *out, "--frames", "9:")
            self.refused(2, "more than 20000", "film", self.result, *out, "--speed", "1e-5")
            self.refused(2, "has no contact force", "film", self.result, *out, "--colour", "contact")
            self.refused(2, "at most 50", "film", self.result, "-o", self.folder / "a.gif", "--fps", 60)
        self.refused(2, "must end in .mp4 or .gif", "film", self.result, "-o", self.folder / "a.avi")
        self.refused(2, "not LOW:HIGH", "picture", self.result, "-o", self.png, "--colour", "strain", "--range", "3:1")


class Colours(Pictures):
    def setUp(self):
        super().setUp()
        self.bowl = load(write_result(self.result, bowl(), TABLE))

    def test_the_colour_at_a_node_is_that_of_the_field_there(self):
        scale = colours.scale_of(self.bowl, "curvature", [1, 3])
        curvature = fields.values(self.bowl, "curvature", 3)
        refined = SmoothSurface(self.bowl.quads, curvature.size).interpolated(curvature[:, None])[:, 0]
        np.testing.assert_array_equal(refined[: curvature.size], curvature)
        self.assertLessEqual(refined.max(), curvature.max())
        share = np.array([0, 0.5, 1, 2, np.nan])
        ends = scale.rgb(scale.low + share * (scale.high - scale.low)).astype(int)
        self.assertTrue((np.diff(ends[:3].sum(axis=1)) > 0).all())  # lighter and lighter
        np.testing.assert_array_equal(ends[3], ends[2])
        np.testing.assert_array_equal(ends[4], 128)

    def test_the_range_is_from_0_to_a_percentile_of_the_frames_shown_or_as_asked(self):
        shown = np.concatenate([fields.values(self.bowl, "curvature", k) for k in (1, 3)])
        scale = colours.scale_of(self.bowl, "curvature", [1, 3])
        self.assertEqual(scale.low, 0)
        self.assertAlmostEqual(scale.high, np.percentile(shown, 99.5), places=4)
        self.assertEqual(scale.extend, "max")
        self.assertEqual(colours.scale_of(self.bowl, "curvature", [3], (0, 1e6)).extend, "neither")
        still = colours.scale_of(self.bowl, "speed", [0, 1])
        self.assertGreater(still.high, still.low)
        for text in ("1", "a:b", "2:2", "0:nan", "1:2:3"):
            with self.assertRaisesRegex(PostprocError, "--range"):
                colours.parse_range(text)
        self.assertEqual(colours.parse_range("-1e-3:2"), (-1e-3, 2))

    def test_legends_have_units(self):
        for name, limits, label, last in (
            ("strain", (0, 0.02), "largest principal strain [%]", 2),
            ("curvature", (0, 200), "curvature [1/m]", 200),
            ("speed", (0, 0.004), "speed [mm/s]", 4),
        ):
            figure = Figure()
            colours.draw_legend(figure, colours.scale_of(self.bowl, name, [1], limits), (0.1, 0.1, 0.5, 0.02))
            (axes,) = figure.axes
            self.assertEqual(axes.get_title(loc="left"), label)
            self.assertAlmostEqual(axes.get_xlim()[1], last)
        self.assertEqual(replace(fields.field("contact"), unit="Pa").label, "contact force over area")
        pressure = colours.Scale(fields.field("contact"), 0.0, 2500.0)
        self.assertEqual(pressure.shown, (1e-3, "kPa"))


class Moments(Pictures):
    def test_between_frames_nodes_go_straight_and_captions_tell_the_time(self):
        result = load(write_result(self.result, bowl()))
        shots = film.shots(result, [0, 1, 2, 3], 20, 0.5, 0.0)
        self.assertEqual(len(shots), 13)
        self.assertEqual([shots[k].caption for k in (0, 1, 12)], ["t = 0 ms", "t = 25 ms", "t = 300 ms"])
        middle = shots[2].moment  # t = 50 ms, between frames at 0 and 100 ms
        np.testing.assert_allclose(middle.position(result), (result.position[0] + result.position[1]) / 2, atol=1e-15)
        np.testing.assert_array_equal(shots[12].moment.position(result), result.position[3])
        ends = moments.evenly_in_time(result, [2], 0.01)
        self.assertEqual(ends, [moments.at_frame(2)])

    def test_an_obstacle_that_turns_stays_rigid_between_frames(self):
        result = load(write_result(self.result, bowl(frames=2), TABLE))
        turned = np.array([np.eye(3), [[0, -1, 0], [1, 0, 0], [0, 0, 1]]], dtype=float)
        table = replace(result.obstacles["table"], path=(np.array([[0, 0, 0], [0, 0, 1.0]]), turned))
        (half,) = moments.Moment(0, 1, 0.5).obstacles(replace(result, obstacles={"table": table}))
        np.testing.assert_allclose(half.rotation @ half.rotation.T, np.eye(3), atol=1e-14)
        np.testing.assert_allclose(half.rotation[0, :2], np.sqrt([0.5, 0.5]) * [1, -1], atol=1e-14)
        np.testing.assert_allclose(half.position, [0, 0, 0.5])


if __name__ == "__main__":
    unittest.main()
