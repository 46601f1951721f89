"""ParaView opens what `sundrape export` writes for it. Needs Debian's packages:
apt-get install --no-install-recommends paraview python3-paraview xvfb xauth.

Debian's ParaView 5.11 knows VTKHDF without steps in time, which came with 5.12: each frame is read from a file of its
own, and test_export.py holds the steps against the specification."""
import shutil
import subprocess
import unittest
from pathlib import Path

import numpy as np

from command_line import CommandLineTest
from exports import SHOW, truth


@unittest.skipUnless(shutil.which("pvpython") and shutil.which("xvfb-run"), "ParaView is not installed")
class ParaView(CommandLineTest):
    def test_has_every_frame_of_the_motion_and_its_fields(self):
        result, _ = self.run_case(self.write("CASE.toml", SHOW))
        expected = truth(result)
        self.done("export", "out.h5", "-o", "show.xdmf")
        for frame in range(len(expected.time)):
            self.done("export", "out.h5", "-o", f"frame_{frame}.vtkhdf", "--frames", frame)
        np.save(self.folder / "times.npy", expected.time)
        np.save(self.folder / "nodes.npy", expected.nodes)
        script = Path(__file__).with_name("in_paraview.py")
        done = subprocess.run(["xvfb-run", "-a", "pvpython", script, self.folder], capture_output=True, text=True, timeout=600)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        fields = []
        for name in ("xdmf2", "xdmf3", "vtkhdf"):
            np.testing.assert_array_equal(np.load(self.folder / f"{name}.npy"), expected.position, err_msg=name)
            fields.append(dict(np.load(self.folder / f"{name}-fields.npz")))
        for name in ("Normals", "strain", "curvature", "contact_pressure", "energy_density", "texture"):
            for other in fields[1:]:
                columns = slice(None) if fields[0][name].ndim == 1 else slice(0, other[name].shape[-1])
                np.testing.assert_array_equal(fields[0][name][..., columns], other[name], err_msg=name)
        np.testing.assert_allclose(fields[0]["texture"][:, :2], expected.texture, atol=1e-6)


if __name__ == "__main__":
    unittest.main()
