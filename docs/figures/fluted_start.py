#!/usr/bin/env python3
"""Rewrites the last frame of a drape test as a disc with a given number of equal folds, to relax from (docs/drape.md).

    python3 docs/figures/fluted_start.py out/rest.h5 6 out/six.h5
    sundrape run cases/cusick.toml --set analysis=relaxation --set cloth.start=$PWD/out/six.h5 -o out/six_folds.h5

What hangs over a support of 9 cm leans by 0.75 + 0.45 cos(n θ) rad, so that every radius keeps its length.
"""
from __future__ import annotations

import argparse
import shutil

import h5py
import numpy as np

SUPPORT = 0.09  # [m]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("result", help="of cases/cusick.toml")
    parser.add_argument("folds", type=int)
    parser.add_argument("start", help="the result to write")
    options = parser.parse_args()
    shutil.copy(options.result, options.start)
    with h5py.File(options.start, "r+") as file:
        x, y = file["mesh/reference"][:, 0], file["mesh/reference"][:, 1]
        r, angle = np.hypot(x, y), np.arctan2(y, x)
        lean = 0.75 + 0.45 * np.cos(options.folds * (angle - 0.1))  # 0.1 rad: not along the mesh's symmetries
        out = np.maximum(r - SUPPORT, 0)
        reach = np.minimum(r, SUPPORT) + out * np.cos(lean)
        position = np.stack([reach * np.cos(angle), reach * np.sin(angle), -out * np.sin(lean)], axis=1)
        quads = file["mesh/quads"][()]
        across = np.cross(position[quads[:, 2]] - position[quads[:, 0]], position[quads[:, 3]] - position[quads[:, 1]])
        normal = np.zeros_like(position)
        for corner in range(4):
            np.add.at(normal, quads[:, corner], across)
        file["frames/position"][-1] = position
        file["frames/director"][-1] = normal / np.linalg.norm(normal, axis=1, keepdims=True)


if __name__ == "__main__":
    main()
