"""What the tests of the command line share: cases that run in a blink, a scratch folder, and the executable itself.

The executable is named by the environment variable SUNDRAPE; ctest sets it."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

EXECUTABLE = os.environ["SUNDRAPE"]
CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

MATERIAL = """
[material]
thickness = "0.5 mm"
density_area = 0.2
youngs_modulus = "1 MPa"
poisson = 0.3
damping = { mass = "5 1/s", membrane = "1 ms", bending = "1 ms" }
"""
UNDAMPED = MATERIAL.replace('mass = "5 1/s", ', "")  # by what is drag in disguise

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

# Nothing holds this one: tests add the supports and obstacles that they are about.
LOOSE_SHEET = f"""model = "particle"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["10 cm", "5 cm"]
cells = [8, 4]
{MATERIAL}
{GRAVITY}
[dynamics]
duration = "1 s"
[output]
frames = 10
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


def sheets(poses, cells=5, size=6):
    """Square pieces of cloth, `size` in cm, one for each place, axis and angle of `poses`."""
    return "".join(f"""[[cloth]]
shape = "rectangle"
size = ["{size} cm", "{size} cm"]
cells = [{cells}, {cells}]
place = {{ translate = {list(place)}, rotate = {{ axis = {list(axis)}, angle = {angle} }} }}
""" for place, axis, angle in poses)


def set_options(sets):
    """Each `key=value` of `sets` after its own --set."""
    return [word for each in sets for word in ("--set", each)]


class CommandLineTest(unittest.TestCase):
    timeout = 600  # of a run [s]

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="sundrape-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def command(self, *arguments):
        return [EXECUTABLE, *map(str, arguments)]

    def sundrape(self, *arguments, timeout=None):
        """Runs it in the scratch folder, where relative names mean the test's own files."""
        return subprocess.run(self.command(*arguments), cwd=self.folder, capture_output=True, text=True,
                              timeout=timeout or self.timeout)

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

    def run_case(self, case, *sets, status=0):
        """The result's file, and the summary; what the run wrote to stderr is then in `message`."""
        done = self.sundrape("run", case, "-o", "out.h5", "--force", "--quiet", "--summary", "out.json", *set_options(sets))
        self.assertEqual(done.returncode, status, done.stderr)
        self.message = done.stderr
        return self.folder / "out.h5", json.loads((self.folder / "out.json").read_text())

    def assert_no_energy_from_nothing(self, summary):
        """Stored, kinetic and turned into heat is never more than was put in, to 1 % of what was turned over."""
        energy = summary["final"]["energy_J"]
        self.assertGreater(energy["method_dissipated"], -0.01 * (energy["dissipated"] + abs(energy["external_work"])))

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())
