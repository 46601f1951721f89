"""Writes ring.obj, a torus about the z axis, in cm: python3 ring.py"""
import math

RADIUS, THICKNESS = 7, 2.5  # of the ring's centre line, and of its section
AROUND, ACROSS = 64, 32

with open("ring.obj", "w") as out:
    out.write("# A ring in cm, by ring.py\n")
    for i in range(AROUND):
        for j in range(ACROSS):
            u, v = 2 * math.pi * i / AROUND, 2 * math.pi * j / ACROSS
            r = RADIUS + THICKNESS * math.cos(v)
            out.write(f"v {r * math.cos(u):.6f} {r * math.sin(u):.6f} {THICKNESS * math.sin(v):.6f}\n")
    for i in range(AROUND):
        for j in range(ACROSS):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            out.write("f " + " ".join(str(a % AROUND * ACROSS + b % ACROSS + 1) for a, b in corners) + "\n")
