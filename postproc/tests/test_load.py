"""Reading of result files, whole, cut short and foreign. Expected values are those that were written."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from sundrape_postproc import PostprocError, load
from tests.synthetic import ENERGIES, EVERY_KIND, bowl, write_result


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "result.h5"


class WholeFile(Files):
    def test_arrays_come_back_as_written(self):
        motion = bowl()
        result = load(write_result(self.path, motion))
        np.testing.assert_array_equal(result.position, motion.position)
        np.testing.assert_array_equal(result.time, motion.time)
        np.testing.assert_array_equal(result.quads, motion.quads)
        self.assertEqual(set(result.energies), set(ENERGIES))
        np.testing.assert_array_equal(result.energies["bending"], motion.energies["bending"])
        self.assertEqual(len(result.steps["order"]), 488)
        np.testing.assert_array_equal(result.probes["tip"].position, motion.position[:, -1])

    def test_attributes_case_and_units_are_plain_values(self):
        result = load(write_result(self.path, bowl(), analysis="relaxation", status="failed", title="A bowl"))
        self.assertEqual((result.title, result.model, result.status), ("A bowl", "particle", "failed"))
        self.assertTrue(result.is_static)
        self.assertEqual(result.case["relaxation"]["tolerance"], 1e-6)
        self.assertEqual(result.units["frames/energy/kinetic"], "J")
        self.assertEqual(result.statistics["newton_iterations"], 1063)

    def test_fixed_length_strings_read_as_text(self):
        write_result(self.path, bowl())
        with h5py.File(self.path, "a") as file:
            file.attrs["title"] = np.bytes_("A bowl")
            file.attrs["format"] = np.bytes_("sundrape")
        self.assertEqual(load(self.path).title, "A bowl")

    def test_obstacles_carry_shape_and_place(self):
        capsule = load(write_result(self.path, bowl(), EVERY_KIND)).obstacles["capsule"]
        self.assertEqual((capsule.kind, capsule.parameters["radius"]), ("capsule", 0.02))
        np.testing.assert_array_equal(capsule.position, [-0.16, 0.06, -0.15])
        np.testing.assert_array_equal(capsule.rotation[1], [0, 0.8, -0.6])  # row major


class CutFile(Files):
    def test_frames_ahead_of_the_others_are_left_out(self):
        write_result(self.path, bowl(frames=4), status="running")
        with h5py.File(self.path, "a") as file:
            file["frames/energy/contact"].resize(2, axis=0)
            file["frames/velocity"].resize(3, axis=0)
            file["steps/order"].resize(400, axis=0)
        result = load(self.path)
        self.assertEqual((len(result.time), len(result.position), len(result.energies["kinetic"])), (2, 2, 2))
        self.assertEqual({len(column) for column in result.steps.values()}, {400})
        self.assertEqual(result.status, "running")

    def test_missing_groups_are_empty(self):
        write_result(self.path, bowl())
        with h5py.File(self.path, "a") as file:
            for name in ("steps", "probes", "statistics", "frames/energy", "mesh/material"):
                del file[name]
        result = load(self.path)
        self.assertEqual((result.steps, result.probes, result.statistics, result.energies), ({}, {}, {}, {}))
        self.assertIsNone(result.material)

    def test_no_complete_frame_is_an_error(self):
        write_result(self.path, bowl())
        with h5py.File(self.path, "a") as file:
            file["frames/time"].resize(0, axis=0)
        with self.assertRaisesRegex(PostprocError, "no complete frame") as caught:
            load(self.path)
        self.assertEqual(caught.exception.status, 3)

    def test_a_file_of_half_its_bytes_is_file_trouble(self):
        whole = write_result(self.path, bowl()).read_bytes()
        self.path.write_bytes(whole[: len(whole) // 2])
        with self.assertRaisesRegex(PostprocError, "cannot be read") as caught:
            load(self.path)
        self.assertEqual(caught.exception.status, 3)

    def test_last_frame_is_the_last_finite_one(self):
        motion = bowl(frames=4)
        motion.position[3, 0, 0] = np.nan
        self.assertEqual(load(write_result(self.path, motion)).last_frame, 2)


class TellingFrames(Files):
    def test_they_crowd_where_the_cloth_moves(self):
        motion = bowl(frames=11)
        motion.position[5:] = motion.position[5]  # at rest from frame 5 on
        frames = load(write_result(self.path, motion)).telling_frames(6)
        self.assertEqual(frames, [0, 1, 2, 3, 4, 5, 10])


class ForeignFile(Files):
    def test_missing_is_status_3(self):
        with self.assertRaisesRegex(PostprocError, "No such file") as caught:
            load(self.path)
        self.assertEqual(caught.exception.status, 3)

    def test_not_hdf5_is_status_2(self):
        self.path.write_text("time,energy\n0,1\n")
        with self.assertRaisesRegex(PostprocError, "not an HDF5 file") as caught:
            load(self.path)
        self.assertEqual(caught.exception.status, 2)

    def test_hdf5_of_another_program_is_status_2(self):
        with h5py.File(self.path, "w") as file:
            file["frames/position"] = np.zeros((1, 4, 3))
        with self.assertRaisesRegex(PostprocError, "not a sundrape result") as caught:
            load(self.path)
        self.assertEqual(caught.exception.status, 2)


if __name__ == "__main__":
    unittest.main()
