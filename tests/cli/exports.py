"""What the tests of exports share: a run with obstacles of every kind, one of which moves, and its result as h5py has it."""
import dataclasses
import pathlib

import h5py
import numpy as np

from command_line import GRAVITY, MATERIAL

# The sheet falls on to the ball; the other bodies are only there to be exported.
SHOW = f"""title = "One of each & <all>"
analysis = "dynamics"
[cloth]
shape = "rectangle"
size = ["9 cm", "6 cm"]
cells = [6, 4]
place = {{ translate = [0, 0, "0.4 mm"], rotate = {{ axis = [0, 0, 1], angle = "20 deg" }} }}
{MATERIAL}
{GRAVITY}
[[obstacle]]
kind = "sphere"
name = "ball"
radius = "3 cm"
place = {{ translate = [0, 0, "-3 cm"] }}
[[obstacle]]
kind = "plane"
name = "floor"
point = [0, 0, "-8 cm"]
[[obstacle]]
kind = "box"
name = "sharp box"
size = ["2 cm", "3 cm", "4 cm"]
place = {{ translate = ["20 cm", 0, 0], rotate = {{ axis = [0, 1, 0], angle = "30 deg" }} }}
[[obstacle]]
kind = "box"
name = "round box"
size = ["2 cm", "3 cm", "4 cm"]
edge_radius = "4 mm"
place = {{ translate = ["25 cm", 0, 0] }}
[[obstacle]]
kind = "cylinder"
name = "rod"
radius = "1 cm"
length = "5 cm"
axis = [1, 0, 0]
edge_radius = "2 mm"
place = {{ translate = ["-20 cm", 0, 0] }}
[[obstacle]]
kind = "capsule"
name = "capsule"
radius = "1 cm"
length = "5 cm"
axis = [0, 1, 1]
place = {{ translate = ["-25 cm", 0, 0] }}
[[obstacle]]
kind = "disc"
name = "pedestal"
radius = "2 cm"
height = "5 cm"
place = {{ translate = [0, "20 cm", 0] }}
motion = {{ kind = "arc", centre = [0, "20 cm", 0], axis = [0, 0, 1], angle = "270 deg", duration = "40 ms" }}
[dynamics]
duration = "40 ms"
rtol = 1e-3
[output]
frames = 8
probes = [ {{ name = "corner", near = ["4.5 cm", "3 cm", 0] }} ]
"""


@dataclasses.dataclass(frozen=True)
class Truth:
    """What exports are held against. F frames, N nodes."""

    time: np.ndarray  # (F,) [s]
    position: np.ndarray  # (F, N, 3) [m]
    quads: np.ndarray  # (E, 4)
    material: np.ndarray  # (N, 2) [m]

    @property
    def nodes(self) -> int:
        return self.position.shape[1]

    @property
    def single_precision(self) -> float:
        """Largest rounding of a coordinate that is stored in single precision, or as a difference of two such."""
        return 2 * float(np.finfo(np.float32).eps) * float(np.abs(self.position).max())

    @property
    def texture(self) -> np.ndarray:
        """(N, 2): warp and weft over the longer side."""
        from_corner = self.material - self.material.min(axis=0)
        return from_corner / from_corner.max()


def truth(result: pathlib.Path) -> Truth:
    with h5py.File(result) as file:
        return Truth(
            file["frames/time"][()], file["frames/position"][()], file["mesh/quads"][()], file["mesh/material"][()]
        )
