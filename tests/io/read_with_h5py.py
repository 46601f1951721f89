#!/usr/bin/env python3
"""Reads every result in a folder with plain h5py and checks its frames: read_with_h5py.py FOLDER

The results are those of result_samples.hpp, whose numbers are known. Exit 0 only if all of them are right."""
import pathlib
import sys

import h5py
import numpy as np


def check(path):
    with h5py.File(path, "r") as file:
        count = file["frames/time"].shape[0]
        np.testing.assert_array_equal(file["frames/time"][...], 0.01 * np.arange(count))
        nodes = file["mesh/reference"].shape[0]
        ramp = 2.0**-10 * np.arange(3 * nodes).reshape(nodes, 3)
        for array, name in enumerate(("position", "velocity", "contact_force"), start=1):
            phase = np.sin(0.125 * np.arange(count) + array)
            expected = phase[:, None, None] + ramp
            np.testing.assert_allclose(file["frames"][name][:count], expected, rtol=0, atol=1e-12, err_msg=name)
        steps = file["steps/time"].shape[0]
        np.testing.assert_array_equal(file["steps/step_size"][:steps], np.arange(steps) + 0.5)
        missing = []
        file.visititems(lambda name, item: missing.append(name) if isinstance(item, h5py.Dataset)
                        and not name.startswith("checkpoint")
                        and not ("units" in item.attrs and "description" in item.attrs) else None)
        assert not missing, f"without units or description: {missing}"
        return count


if __name__ == "__main__":
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.h5"))
    frames = [check(path) for path in files]
    print(f"h5py read {len(files)} files with {sum(frames)} frames")
