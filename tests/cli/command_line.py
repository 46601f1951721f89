"""What the tests of the command line share: a case that runs in a blink, a scratch folder, and the executable itself.

The executable is named by the environment variable SUNDRAPE; ctest sets it."""
import os
import pathlib
import subprocess
import tempfile
import unittest

EXECUTABLE = os.environ["SUNDRAPE"]

MATERIAL = """
[material]
thickness = "0.5 mm"
density_area = 0.2
youngs_modulus = "1 MPa"
poisson = 0.3
damping = { mass = "5 1/s", membrane = "1 ms", bending = "1 ms" }
"""

GRAVITY = """
[[load]]
kind = "gravity"
acceleration = [0, 0, -9.80665]
"""

# A small sheet that drops 0.2 mm onto a table and stays there.
SHEET = f"""title = "A sheet on a table"
model = "particle"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["8 cm", "6 cm"]
cells = [4, 3]
place = {{ translate = [0, 0, "0.2 mm"] }}
{MATERIAL}
[[fix]]
name = "pin"
nodes = {{ near = [0, 0, 0] }}
components = ["x", "y"]
{GRAVITY}
[[obstacle]]
kind = "plane"
[dynamics]
duration = "20 ms"
rtol = 1e-3
[output]
frames = 4
probes = [ {{ name = "corner", near = ["4 cm", "3 cm", 0] }} ]
"""


def hanging(**settings):
    """A strip held by one end, let go at a slant; damped, so that its motion is smooth and forgets its start."""
    values = dict(cells="[12, 2]", duration="1 s", rtol="1e-4", frames="40", more="", output="") | settings
    return f"""title = "A hanging strip"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["20 cm", "3 cm"]
cells = {values["cells"]}
place = {{ translate = ["10 cm", 0, 0] }}
{MATERIAL}
[[fix]]
name = "hand"
nodes = "left"
components = ["x", "y", "z"]
{GRAVITY}
[dynamics]
duration = "{values["duration"]}"
rtol = {values["rtol"]}
{values["more"]}
[output]
frames = {values["frames"]}
{values["output"]}
"""


class CommandLineTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="sundrape-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def command(self, *arguments):
        return [EXECUTABLE, *map(str, arguments)]

    def sundrape(self, *arguments, timeout=600):
        """Runs it in the scratch folder, where relative names mean the test's own files."""
        return subprocess.run(self.command(*arguments), cwd=self.folder, capture_output=True, text=True, timeout=timeout)

    def start(self, *arguments):
        started = subprocess.Popen(self.command(*arguments), cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(started.communicate)
        self.addCleanup(started.kill)
        return started

    def done(self, *arguments, **options):
        result = self.sundrape(*arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())
