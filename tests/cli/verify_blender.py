"""Blender opens what `sundrape export` writes for it. Needs Debian's blender: apt-get install --no-install-recommends blender."""
import shutil
import subprocess
import unittest
from pathlib import Path

import numpy as np

from command_line import CommandLineTest
from exports import SHOW, truth


@unittest.skipUnless(shutil.which("blender"), "Blender is not installed")
class Blender(CommandLineTest):
    def test_has_every_frame_of_the_motion(self):
        result, _ = self.run_case(self.write("CASE.toml", SHOW))
        expected = truth(result)
        for name in ("show.glb", "cloth.mdd"):
            self.done("export", "out.h5", "-o", name)
        np.save(self.folder / "times.npy", expected.time - expected.time[0])
        script = Path(__file__).with_name("in_blender.py")
        done = subprocess.run(
            ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", script, "--", self.folder],
            capture_output=True, text=True, timeout=600,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        names = (self.folder / "names.txt").read_text().split("\n")
        self.assertEqual(names, ["ball", "capsule", "cloth", "floor", "pedestal", "rod", "round box", "sharp box"])
        for name in ("glb.npy", "mdd.npy"):
            shapes = np.load(self.folder / name)
            self.assertEqual(shapes.shape, expected.position.shape, name)
            # Blender evaluates the animation at times in single precision, between keys 5 ms apart
            moved = np.abs(np.diff(expected.position, axis=0)).max()
            np.testing.assert_allclose(shapes, expected.position, atol=expected.single_precision + 1e-3 * moved, err_msg=name)


if __name__ == "__main__":
    unittest.main()
