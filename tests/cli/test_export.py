"""Exports, read back by programs that have nothing to do with sundrape: VTK, meshio, and Python's own readers.

Blender and ParaView, which are too heavy for every run, read them in verify_blender.py and verify_paraview.py."""
import csv
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np

from command_line import CommandLineTest
from exports import SHOW, truth

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "postproc"))
BODIES = ["ball", "capsule", "floor", "pedestal", "rod", "round box", "sharp box"]  # in the order of the result


class Exports(CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory(prefix="sundrape-export-")
        cls.addClassCleanup(cls.shared.cleanup)

    def setUp(self):
        self.folder = pathlib.Path(self.shared.name)  # one run does for all of them
        self.result = self.folder / "out.h5"
        if not self.result.exists():
            self.run_case(self.write("CASE.toml", SHOW))
        self.truth = truth(self.result)

    def export(self, name, *options):
        self.done("export", "out.h5", "-o", name, *options)
        return self.folder / name


class VtkHdf(Exports):
    def read(self, path):
        from vtkmodules.vtkCommonCore import vtkLogger
        from vtkmodules.vtkIOHDF import vtkHDFReader

        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # this VTK may warn of a newer version than its own
        reader = vtkHDFReader()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutputDataObject(0)

    def test_every_frame_alone_is_what_vtk_reads(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        for frame, position in enumerate(self.truth.position):
            grid = self.read(self.export("one.vtkhdf", "--frames", frame))
            points = vtk_to_numpy(grid.GetPoints().GetData())
            np.testing.assert_array_equal(points[: self.truth.nodes], position)
            part = vtk_to_numpy(grid.GetCellData().GetArray("part"))
            self.assertEqual(sorted(set(part)), list(range(len(BODIES) + 1)))
            self.assertEqual(np.count_nonzero(part == 0), len(self.truth.quads))
            self.assertEqual(grid.GetCellType(0), 9)  # a quadrilateral
            corners = [grid.GetCell(5).GetPointId(k) for k in range(4)]
            self.assertEqual(corners, list(self.truth.quads[5]))

    def test_fields_are_those_of_the_python_package(self):
        """The same definitions, written twice: in C++ for exports, in NumPy for pictures."""
        from sundrape_postproc import fields, load
        from vtkmodules.util.numpy_support import vtk_to_numpy

        names = {"strain": "strain", "curvature": "curvature", "contact": "contact_pressure", "energy": "energy_density"}
        for model in ("particle", "shell"):
            self.done("run", "CASE.toml", "-o", f"{model}.h5", "--force", "--quiet", "--set", f"model={model}")
            self.done("export", f"{model}.h5", "-o", "fields.vtkhdf", "--frames", "-1")
            data = self.read(self.folder / "fields.vtkhdf").GetPointData()
            result = load(self.folder / f"{model}.h5")
            for name, exported in names.items():
                expected = fields.values(result, name, len(result.time) - 1)
                values = vtk_to_numpy(data.GetArray(exported))
                np.testing.assert_allclose(values[: len(expected)], expected, rtol=1e-5, atol=1e-7 * np.abs(expected).max())
                self.assertTrue(np.isnan(values[len(expected) :]).all(), name)
            normals = vtk_to_numpy(data.GetArray("Normals"))[: len(result.reference)]
            np.testing.assert_allclose(normals, fields.node_normals(result.position[-1], result.quads), atol=1e-6)

    def test_steps_in_time_lead_to_each_frames_block(self):
        """As the specification says: a step's points begin at PointOffsets, its cells are those of part 0."""
        with h5py.File(self.export("all.vtkhdf")) as file:
            root, steps = file["VTKHDF"], file["VTKHDF/Steps"]
            self.assertEqual(list(root.attrs["Version"]), [2, 0])
            self.assertEqual(root.attrs["Type"], b"UnstructuredGrid")
            self.assertEqual(steps.attrs["NSteps"], len(self.truth.time))
            np.testing.assert_array_equal(steps["Values"], self.truth.time)
            np.testing.assert_array_equal(steps["NumberOfParts"], 1)
            for name in ("PartOffsets", "CellOffsets", "ConnectivityIdOffsets", "CellDataOffsets/part", "PointDataOffsets/texture"):
                np.testing.assert_array_equal(steps[name], 0)
                self.assertEqual(len(steps[name]), len(self.truth.time))
            for k, offset in enumerate(steps["PointOffsets"]):
                np.testing.assert_array_equal(root["Points"][offset : offset + self.truth.nodes], self.truth.position[k])
            for name in ("Normals", "strain", "curvature", "contact_pressure", "energy_density"):
                np.testing.assert_array_equal(steps[f"PointDataOffsets/{name}"], steps["PointOffsets"])
                self.assertEqual(len(root[f"PointData/{name}"]), len(root["Points"]))

    def test_a_body_that_moves_is_where_it_is_in_the_frame(self):
        with h5py.File(self.result) as file, h5py.File(self.export("all.vtkhdf")) as exported:
            root = exported["VTKHDF"]
            pedestal = 1 + BODIES.index("pedestal")
            cells = np.flatnonzero(root["CellData/part"][()] == pedestal)
            offsets = root["Offsets"][()]
            points = np.unique(root["Connectivity"][offsets[cells[0]] : offsets[cells[-1] + 1]])
            blocks = [root["Points"][o : o + root["NumberOfPoints"][0]][points] for o in root["Steps/PointOffsets"]]
            for k, block in enumerate(blocks):
                rotation = file["frames/obstacle_rotation/pedestal"][k] @ file["frames/obstacle_rotation/pedestal"][0].T
                moved = (blocks[0] - file["frames/obstacle_position/pedestal"][0]) @ rotation.T
                np.testing.assert_allclose(block, moved + file["frames/obstacle_position/pedestal"][k], atol=1e-15)
            self.assertGreater(np.abs(blocks[-1] - blocks[0]).max(), 0.02)


def leaves(data):
    """The meshes in a tree of blocks, in its order."""
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data]
    blocks = [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())]
    return [leaf for block in blocks if block is not None for leaf in leaves(block)]


class Gltf(Exports):
    def read(self, path):
        from vtkmodules.vtkIOGeometry import vtkGLTFReader

        reader = vtkGLTFReader()
        reader.SetFileName(str(path))
        reader.ApplyDeformationsToGeometryOn()
        reader.UpdateInformation()
        if reader.GetNumberOfAnimations():
            reader.EnableAnimation(0)
        reader.SetFrameRate(1000)
        return reader

    def test_every_frame_is_where_vtks_animation_brings_it(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        reader = self.read(self.export("show.glb"))
        self.assertEqual(reader.GetNumberOfAnimations(), 1)
        self.assertAlmostEqual(reader.GetAnimationDuration(0), self.truth.time[-1] - self.truth.time[0], places=7)
        for k, time in enumerate(self.truth.time):
            reader.UpdateTimeStep(float(np.float32(time)))
            blocks = leaves(reader.GetOutputDataObject(0))
            self.assertEqual(len(blocks), 1 + len(BODIES))
            y_up = vtk_to_numpy(blocks[0].GetPoints().GetData())
            points = np.stack([y_up[:, 0], -y_up[:, 2], y_up[:, 1]], axis=1)
            # the weights that VTK finds between two keys are right to single precision of the time
            moved = np.abs(np.diff(self.truth.position, axis=0)).max()
            np.testing.assert_allclose(points, self.truth.position[k], atol=self.truth.single_precision + 2e-4 * moved)

    def test_texture_coordinates_are_warp_and_weft(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        reader = self.read(self.export("one.glb", "--frames", "0"))
        reader.Update()
        cloth = leaves(reader.GetOutputDataObject(0))[0]
        texture = vtk_to_numpy(cloth.GetPointData().GetArray("TEXCOORD_0"))
        np.testing.assert_allclose(texture * [1, -1] + [0, 1], self.truth.texture, atol=1e-6)  # its v runs downwards
        strain = vtk_to_numpy(cloth.GetPointData().GetArray("_STRAIN"))
        self.assertEqual(strain.shape[0], self.truth.nodes)

    def test_without_obstacles_there_is_the_cloth_alone(self):
        reader = self.read(self.export("cloth.glb", "--no-obstacles"))
        reader.Update()
        self.assertEqual(len(leaves(reader.GetOutputDataObject(0))), 1)


class Sequences(Exports):
    def vtk_points(self, reader, path):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        reader.SetFileName(str(path))
        reader.Update()
        return vtk_to_numpy(reader.GetOutput().GetPoints().GetData()), reader.GetOutput()

    def test_obj_files_have_every_frame(self):
        import meshio
        from vtkmodules.vtkIOGeometry import vtkOBJReader

        self.export("show.obj")
        for k, position in enumerate(self.truth.position):
            path = self.folder / f"show_{k:04}.obj"
            mesh = meshio.read(path)
            np.testing.assert_array_equal(mesh.points[: self.truth.nodes], position)  # text of full precision
            np.testing.assert_array_equal(mesh.cells_dict["quad"], self.truth.quads)
            np.testing.assert_array_equal(mesh.point_data["obj:vt"][: self.truth.nodes], self.truth.texture)
            points, _ = self.vtk_points(vtkOBJReader(), path)
            np.testing.assert_allclose(points[: self.truth.nodes], position, atol=self.truth.single_precision)
        objects = [line.split()[1] for line in path.read_text().splitlines() if line.startswith("o ")]
        self.assertEqual(objects, ["cloth", *(name.replace(" ", "_") for name in BODIES)])

    def test_ply_files_have_every_frame_and_its_fields(self):
        import meshio
        from vtkmodules.vtkIOPLY import vtkPLYReader

        self.export("show.ply", "--frames", "::2")
        for k in range(0, len(self.truth.time), 2):
            path = self.folder / f"show_{k:04}.ply"
            mesh = meshio.read(path)
            np.testing.assert_allclose(mesh.points[: self.truth.nodes], self.truth.position[k], atol=self.truth.single_precision)
            np.testing.assert_array_equal(mesh.cells_dict["quad"], self.truth.quads)
            np.testing.assert_array_equal(np.unique(mesh.point_data["part"]), np.arange(1 + len(BODIES)))
            for name in ("strain", "curvature", "contact_pressure", "energy_density"):
                self.assertTrue(np.isfinite(mesh.point_data[name][: self.truth.nodes]).all())
            points, polygons = self.vtk_points(vtkPLYReader(), path)
            np.testing.assert_allclose(points[: self.truth.nodes], self.truth.position[k], atol=self.truth.single_precision)
            self.assertIsNotNone(polygons.GetPointData().GetNormals())
        self.assertFalse((self.folder / "show_0001.ply").exists())

    def test_one_frame_is_one_file_of_that_name(self):
        said = self.done("export", "out.h5", "-o", "last.obj", "--frames", "-1").stdout
        self.assertEqual(said, "wrote last.obj\n")
        self.assertTrue((self.folder / "last.obj").exists())

    def test_point_cache_fits_its_mesh(self):
        import meshio

        bytes_ = self.export("cloth.mdd", "--frames", "1:").read_bytes()
        frames, nodes = np.frombuffer(bytes_, ">i4", 2)
        self.assertEqual((frames, nodes), (len(self.truth.time) - 1, self.truth.nodes))
        numbers = np.frombuffer(bytes_, ">f4", offset=8)
        np.testing.assert_allclose(numbers[:frames], self.truth.time[1:] - self.truth.time[1], atol=1e-8)
        points = numbers[frames:].reshape(frames, nodes, 3)
        np.testing.assert_allclose(points, self.truth.position[1:], atol=self.truth.single_precision)
        base = meshio.read(self.folder / "cloth.obj")
        np.testing.assert_array_equal(base.points, self.truth.position[1])
        np.testing.assert_array_equal(base.cells_dict["quad"], self.truth.quads)


class Tables(Exports):
    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            header, *rows = csv.reader(file)
        return {name: np.array(column, dtype=float) for name, column in zip(header, zip(*rows))}

    def test_energies_forces_and_probes_have_their_units(self):
        self.export("show.csv")
        table = self.rows("show.csv")
        with h5py.File(self.result) as file:
            np.testing.assert_array_equal(table["time [s]"], self.truth.time)
            for name, values in file["frames/energy"].items():
                np.testing.assert_array_equal(table[f"energy.{name} [J]"], values)
            node = int(file["probes/corner"].attrs["node"])
            for k, axis in enumerate("xyz"):
                np.testing.assert_array_equal(table[f"probe.corner.{axis} [m]"], self.truth.position[:, node, k])
            probes, steps = self.rows("show-probes.csv"), self.rows("show-steps.csv")
            np.testing.assert_array_equal(probes["probe.corner.z [m]"], file["probes/corner/position"][:, 2])
            np.testing.assert_array_equal(probes["probe.corner.velocity.z [m/s]"], file["probes/corner/velocity"][:, 2])
            np.testing.assert_array_equal(steps["step_size [s]"], file["steps/step_size"])
            np.testing.assert_array_equal(steps["order [1]"], file["steps/order"])

    def test_only_the_frames_asked_for(self):
        self.export("some.csv", "--frames", "2:7:2")
        np.testing.assert_array_equal(self.rows("some.csv")["time [s]"], self.truth.time[2:7:2])


class Xdmf(Exports):
    def test_every_frame_has_its_grids(self):
        """Read by the rules of XDMF: each DataItem names a dataset of a file beside it."""
        path = self.export("show.xdmf")

        def data(item):
            file, dataset = item.text.split(":")
            with h5py.File(path.parent / file) as heavy:
                values = heavy[dataset][()]
            self.assertEqual(list(values.shape), [int(n) for n in item.get("Dimensions").split()])
            self.assertEqual(values.dtype.itemsize, int(item.get("Precision")))
            return values

        frames = ElementTree.parse(path).getroot().findall("Domain/Grid[@CollectionType='Temporal']/Grid")
        self.assertEqual([float(frame.find("Time").get("Value")) for frame in frames], list(self.truth.time))
        for k, frame in enumerate(frames):
            cloth, *bodies = frame.findall("Grid")
            self.assertEqual([body.get("Name") for body in bodies], BODIES)
            np.testing.assert_array_equal(data(cloth.find("Geometry/DataItem")), self.truth.position[k])
            np.testing.assert_array_equal(data(cloth.find("Topology/DataItem")), self.truth.quads)
            attributes = {a.get("Name"): data(a.find("DataItem")) for a in cloth.findall("Attribute")}
            self.assertEqual(len(attributes["strain"]), self.truth.nodes)
            for body in bodies:
                corners = data(body.find("Topology/DataItem"))
                self.assertEqual(corners.max() + 1, len(data(body.find("Geometry/DataItem"))))


class BadExports(Exports):
    def test_are_refused_with_what_would_do(self):
        for arguments, status, said in (
            (["-o", "x.stl"], 2, r"x\.stl: the name must end in one of \.csv, \.glb, \.mdd, \.obj, \.ply, \.vtkhdf, \.xdmf"),
            (["-o", "x.obj", "--frames", "5:5"], 2, '"5:5" picks none of the result\'s 9 frames'),
            (["-o", "x.obj", "--frames", "9"], 2, "there is no frame 9: the result has 9"),
            (["-o", "x.obj", "--frames", "a:b"], 2, "no range of frames: write first:end:step in whole numbers"),
            (["-o", "x.obj", "--frames", "1:2:0"], 2, "the step must be 1 or more"),
            (["-o", "nowhere/x.ply"], 3, "nowhere/x_0000.ply: cannot be created"),
            ([], 2, "--output is required"),
        ):
            done = self.sundrape("export", "out.h5", *arguments)
            self.assertEqual(done.returncode, status, arguments)
            self.assertRegex(done.stderr, said)
            self.assertEqual(done.stderr.count("\n"), 1)
        self.assertEqual(self.sundrape("export", "CASE.toml", "-o", "x.obj").returncode, 3)
        self.assertFalse(any(self.folder.glob("x*")))

    def test_a_failed_write_leaves_what_was_there(self):
        before = self.export("kept.glb").read_bytes()
        whole = self.sundrape("export", "out.h5", "-o", "kept.glb", "--frames", "99")
        self.assertEqual(whole.returncode, 2)
        self.assertEqual((self.folder / "kept.glb").read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
