"""The command as a user runs it: what it draws, what it says and how it exits."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import matplotlib.image
import numpy as np

from tests.synthetic import EVERY_KIND, TABLE, bowl, swing, write_result

HOME = Path(__file__).resolve().parents[1]


def command(*arguments: object, **environment: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        [sys.executable, "-m", "sundrape_postproc", *map(str, arguments)],
        env=os.environ | {"PYTHONPATH": str(HOME)} | environment,
        capture_output=True,
        text=True,
        timeout=300,
    )


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.result, self.png = self.folder / "result.h5", self.folder / "picture.png"

    def done(self, *arguments: object) -> None:
        """Runs a command that must succeed in silence."""
        done = command(*arguments)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def drawn(self, *arguments: object) -> np.ndarray:
        """The same; the picture's pixels (height, width, 3) in 0..1."""
        self.done(*arguments, "-o", self.png)
        return matplotlib.image.imread(self.png)[..., :3]

    def refused(self, status: int, pattern: str, *arguments: object, **environment: str) -> None:
        done = command(*arguments, **environment)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertRegex(done.stderr, pattern)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)


class Drawing(Pictures):
    def test_a_picture_has_the_size_asked_for_a_scene_and_curves(self):
        pixels = self.drawn("picture", write_result(self.result, bowl(), TABLE), "--size", "700x420")
        self.assertEqual(pixels.shape, (420, 700, 3))
        scene, diagrams = pixels[:, :420], pixels[:, 420:]
        cloth = (scene[..., 0] > scene[..., 2] + 0.04).mean()  # linen is the only warm colour there
        self.assertGreater(cloth, 0.05)
        self.assertGreater((diagrams < 0.6).any(axis=2).mean(), 0.01)

    def test_every_kind_of_obstacle_is_seen(self):
        bare = self.drawn("picture", write_result(self.result, bowl()), "--size", "600x400")
        full = self.drawn("picture", write_result(self.result, bowl(), EVERY_KIND), "--size", "600x400")
        self.assertGreater((np.abs(full - bare)[:, :360].max(axis=2) > 0.1).mean(), 0.2)

    def test_another_frame_is_another_picture(self):
        write_result(self.result, bowl(), TABLE)
        first = self.drawn("picture", self.result, "--frame", 0, "--size", "500x300")
        last = self.drawn("picture", self.result, "--frame", -1, "--size", "500x300")
        self.assertGreater(np.abs(first - last)[:, :300].mean(), 0.01)

    def test_static_and_cut_files_and_bare_meshes_are_drawn(self):
        write_result(self.result, bowl(), analysis="relaxation", status="running")
        with h5py.File(self.result, "a") as file:
            file["frames/position"].resize(2, axis=0)
            for name in ("mesh/material", "statistics", "probes", "steps"):
                del file[name]
        self.assertEqual(self.drawn("picture", self.result, "--size", "500x300").shape, (300, 500, 3))

    def test_a_filmstrip_shows_frames_that_differ(self):
        pixels = self.drawn("filmstrip", write_result(self.result, bowl(), TABLE), "--count", 2, "--size", "606x300")
        self.assertEqual(pixels.shape, (300, 606, 3))
        self.assertGreater(np.abs(pixels[:250, :300] - pixels[:250, 306:]).mean(), 0.01)

    def test_a_strip_needs_no_display(self):
        write_result(self.result, swing(), TABLE)
        done = command("strip", self.result, "-o", self.png, "--size", "600x400", DISPLAY="", PATH="")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(matplotlib.image.imread(self.png).shape[:2], (400, 600))


class Refusals(Pictures):
    def test_missing_result(self):
        self.refused(3, "absent.h5: No such file", "picture", self.folder / "absent.h5", "-o", self.png)

    def test_foreign_result(self):
        self.result.write_text("not a result")
        self.refused(2, "not a sundrape result", "picture", self.result, "-o", self.png)

    def test_unwritable_place(self):
        write_result(self.result, bowl())
        self.refused(3, "no such directory", "picture", self.result, "-o", self.folder / "nowhere" / "x.png")

    def test_a_frame_that_is_not_there(self):
        write_result(self.result, bowl(frames=4))
        self.refused(2, "--frame 4: .* has frames 0 to 3", "picture", self.result, "-o", self.png, "--frame", 4)

    def test_an_unknown_obstacle(self):
        write_result(self.result, bowl(), {"ring": {"kind": "torus", "parameters": {}}})
        self.refused(3, "torus", "picture", self.result, "-o", self.png)

    def test_no_display_and_no_virtual_one_names_the_package(self):
        write_result(self.result, bowl())
        self.refused(3, "apt install xvfb", "picture", self.result, "-o", self.png, DISPLAY="", PATH="")

    def test_a_python_without_the_libraries_names_the_packages(self):
        done = subprocess.run(  # -S: python without its installed packages
            [sys.executable, "-S", "-m", "sundrape_postproc", "picture", "x.h5", "-o", "x.png"],
            env={"PYTHONPATH": str(HOME)},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr, "^(h5py|numpy) is missing .*apt install python3-h5py[^\n]*\n$")

    def test_a_bad_size_is_a_bad_command_line(self):
        done = command("picture", self.result, "-o", self.png, "--size", "huge")
        self.assertEqual(done.returncode, 2)
        self.assertIn("WIDTHxHEIGHT", done.stderr)


if __name__ == "__main__":
    unittest.main()
