"""Writes pawn.obj, a chess pawn as tall as a hand and more, turned about the z axis, in cm: python3 pawn.py"""
import math

AROUND, ALONG = 48, 64  # faces
HEIGHT, HEAD, NECK, FOOT = 22.0, 4.0, 2.2, 6.5  # of the whole; radii [cm]
FEATHER = 2.5  # over which radii of the body change [cm]


def radius(z):
    """Of the outline at height z: a round head on a neck that widens to a foot."""
    centre = HEIGHT - HEAD
    head = math.sqrt(max(HEAD**2 - (z - centre) ** 2, 0)) if z > centre - HEAD else 0
    body = NECK + (FOOT - NECK) / (1 + math.exp((z - 5) / FEATHER)) if z < centre else 0
    return max(head, body)


heights = [HEIGHT * math.sin(0.5 * math.pi * k / ALONG) for k in range(ALONG)]  # finer at the head; its top comes last
with open("pawn.obj", "w") as out:
    out.write("# A pawn in cm, by pawn.py\n")
    for z in heights:
        for i in range(AROUND):
            turn = 2 * math.pi * i / AROUND
            out.write(f"v {radius(z) * math.cos(turn):.6f} {radius(z) * math.sin(turn):.6f} {z:.6f}\n")
    out.write(f"v 0 0 {HEIGHT:.6f}\n")
    top = len(heights) * AROUND + 1
    for k in range(len(heights) - 1):
        for i in range(AROUND):
            j = (i + 1) % AROUND
            corners = [(k, i), (k, j), (k + 1, j), (k + 1, i)]
            out.write("f " + " ".join(str(a * AROUND + b + 1) for a, b in corners) + "\n")
    for i in range(AROUND):
        out.write(f"f {(len(heights) - 1) * AROUND + i + 1} {(len(heights) - 1) * AROUND + (i + 1) % AROUND + 1} {top}\n")
    out.write("f " + " ".join(str(i + 1) for i in reversed(range(AROUND))) + "\n")  # what it stands on
