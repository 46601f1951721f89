"""A case of sheets that fall from random poses into a pit, and onto each other: of a seed, always the same."""
import numpy as np

SIDE, CELLS = 0.2, 10  # of a sheet: [m], along each side
ROOM = np.array([[-0.25, 0.25], [-0.25, 0.25], [0.5, 3.5]])  # in which their centres are put [m]
SLOPE = 30  # of the pit's three walls [deg]: steeper than friction holds


def poses(count, seed):
    """Centres [m], axes and angles [rad] of sheets none of which can touch another: their circumspheres are apart."""
    random = np.random.default_rng(seed)
    reach = SIDE / np.sqrt(2)
    centres = []
    while len(centres) < count:
        centre = random.uniform(*ROOM.T).round(3)
        if all(np.linalg.norm(centre - other) > 2 * reach + 0.005 for other in centres):
            centres.append(centre)
    return [(centre, random.normal(size=3).round(3), round(random.uniform(0, np.pi), 3)) for centre in centres]


def heap_case(count, seed, duration="4 s"):
    """Its text: tablecloth cotton in still air, into a pit of three slopes."""
    sheets = "".join(
        f"""
[[cloth]]
shape = "rectangle"
size  = ["{SIDE} m", "{SIDE} m"]
cells = [{CELLS}, {CELLS}]
place = {{ translate = {[float(x) for x in centre]}, rotate = {{ axis = {[float(x) for x in axis]}, angle = "{angle} rad" }} }}
"""
        for centre, axis, angle in poses(count, seed))
    walls = "".join(
        f"""
[[obstacle]]
kind     = "plane"
name     = "wall {k + 1}"
friction = 0.3
place    = {{ rotate = {{ axis = [{np.cos(turn):.6f}, {np.sin(turn):.6f}, 0], angle = "{SLOPE} deg" }} }}
"""
        for k, turn in enumerate(2 * np.pi / 3 * np.arange(3)))
    return f"""# {count} sheets fall from random poses (seed {seed}) into a pit, onto each other and themselves. Made by tests/cli/heap_case.py.
title    = "Heap of {count} sheets"
model    = "particle"
analysis = "dynamics"
{sheets}
[material]
fabric  = "tablecloth-cotton"
damping = {{ membrane = "1 ms", bending = "0.3 ms" }}

[[load]]
kind = "gravity"

[[load]]
kind = "wind"
{walls}
[contact]
friction = 0.3

[dynamics]
duration = "{duration}"

[output]
frames = 100
"""


if __name__ == "__main__":
    import sys

    count, seed = (int(each) for each in sys.argv[1:])
    print(heap_case(count, seed), end="")
