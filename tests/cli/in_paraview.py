"""Run by ParaView: `pvpython in_paraview.py FOLDER`.

Reads FOLDER/show.xdmf with both generations of XDMF readers, and FOLDER/frame_K.vtkhdf, and saves where the cloth is in
every frame as READER.npy, (F, N, 3) in metres, and the fields at its nodes in the last one as READER-fields.npz."""
import pathlib
import sys

import numpy as np
from paraview import servermanager
from paraview.simple import XDMFReader, Xdmf3ReaderS
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

folder = pathlib.Path(sys.argv[-1])
times = np.load(folder / "times.npy")
nodes = int(np.load(folder / "nodes.npy"))


def cloth(data):
    """The first mesh of a tree of blocks."""
    while not data.IsA("vtkPointSet"):
        data = data.GetPiece(0) if data.IsA("vtkMultiPieceDataSet") else data.GetBlock(0)
    return data


def save(name, shapes, last):
    np.save(folder / f"{name}.npy", np.array(shapes))
    data = last.GetPointData()
    fields = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k))[:nodes] for k in range(data.GetNumberOfArrays())}
    np.savez(folder / f"{name}-fields.npz", **fields)


def points(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())[:nodes].copy()


for name, reader in (
    ("xdmf2", XDMFReader(FileNames=[str(folder / "show.xdmf")])),
    ("xdmf3", Xdmf3ReaderS(FileName=[str(folder / "show.xdmf")])),
):
    reader.UpdatePipelineInformation()
    np.testing.assert_allclose(list(reader.TimestepValues), times, rtol=1e-12)
    shapes = []
    for time in reader.TimestepValues:
        reader.UpdatePipeline(time)
        mesh = cloth(servermanager.Fetch(reader))
        shapes.append(points(mesh))
    save(name, shapes, mesh)

shapes = []
for frame in range(len(times)):
    reader = vtkHDFReader()
    reader.SetFileName(str(folder / f"frame_{frame}.vtkhdf"))
    reader.Update()
    mesh = cloth(reader.GetOutputDataObject(0))
    shapes.append(points(mesh))
save("vtkhdf", shapes, mesh)
