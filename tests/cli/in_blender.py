"""Run by Blender: `blender --background --factory-startup --python in_blender.py -- FOLDER`.

Imports FOLDER/show.glb, and FOLDER/cloth.mdd on to FOLDER/cloth.obj, and saves where every vertex is in every frame as
glb.npy and mdd.npy, (F, N, 3) in metres, and the names of what was imported as names.txt."""
import pathlib
import sys

import bpy
import numpy as np

np.bool = bool  # which Debian's Blender 3.4 still asks Debian's NumPy for

folder = pathlib.Path(sys.argv[-1])
rate = 1000  # frames a second: those of the result fall on whole ones


def reset():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = rate


def shape(thing):
    """Vertices in the world, with shape keys at their values of now."""
    evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    points = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", points)
    matrix = np.array(evaluated.matrix_world)
    evaluated.to_mesh_clear()
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


def film(thing, frames):
    shapes = []
    for frame in frames:
        bpy.context.scene.frame_set(int(frame), subframe=float(frame - int(frame)))
        shapes.append(shape(thing))
    return np.array(shapes)


times = np.load(folder / "times.npy")  # (F,) [s]

reset()
bpy.ops.import_scene.gltf(filepath=str(folder / "show.glb"))
(folder / "names.txt").write_text("\n".join(sorted(o.name for o in bpy.data.objects if o.type == "MESH")))
np.save(folder / "glb.npy", film(bpy.data.objects["cloth"], times * rate))

reset()
bpy.ops.preferences.addon_enable(module="io_shape_mdd")
bpy.ops.wm.obj_import(filepath=str(folder / "cloth.obj"), forward_axis="Y", up_axis="Z")
cloth = bpy.context.selected_objects[0]
bpy.context.view_layer.objects.active = cloth
bpy.ops.import_shape.mdd(filepath=str(folder / "cloth.mdd"), frame_start=0, frame_step=1)
np.save(folder / "mdd.npy", film(cloth, np.arange(len(times))))
