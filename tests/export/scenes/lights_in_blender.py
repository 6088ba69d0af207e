"""What Cycles makes of a scene: python lights_in_blender.py FILE OUT.json; needs the package bpy. Not a test.

FILE is a script of ours, a .usda or a .gltf. OUT.json has the floor's irradiance as linear RGB in the scene's unit,
the shadow's pixels of a ball one metre up (east, north), and the toward-vector and strength of the sun's lamp.
"""

import json
import os
import sys
import tempfile
from pathlib import Path

import numpy as np


def empty():
    """An empty scene for Cycles on one thread."""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="cycles")
    here = bpy.context.scene
    here.render.engine, here.cycles.device = "CYCLES", "CPU"
    here.cycles.use_denoising, here.cycles.use_adaptive_sampling, here.cycles.seed = False, False, 3
    here.cycles.max_bounces, here.render.threads_mode, here.render.threads = 0, "FIXED", 1
    here.render.image_settings.file_format, here.render.image_settings.color_depth = "OPEN_EXR", "32"
    here.view_settings.view_transform = "Raw"
    return here


def seen_from_above(here, half, pixels, samples):
    """Linear RGB (pixels, pixels, 3) of a square of the floor, north in the first row."""
    import bpy

    camera = bpy.data.cameras.new("camera")
    camera.type, camera.ortho_scale = "ORTHO", 2 * half
    here.camera = bpy.data.objects.new("camera", camera)
    here.camera.location = 0, 0, 9
    here.collection.objects.link(here.camera)
    here.render.resolution_x = here.render.resolution_y = pixels
    here.cycles.samples = samples
    with tempfile.TemporaryDirectory() as folder:
        here.render.filepath = os.path.join(folder, "seen.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(here.render.filepath)
        image.colorspace_settings.name = "Non-Color"
        values = np.empty(pixels * pixels * 4, np.float32)
        image.pixels.foreach_get(values)
    return values.reshape(pixels, pixels, 4)[::-1, :, :3].astype(float)


def grey(reflectance):
    """A diffuse material."""
    import bpy

    material = bpy.data.materials.new("grey")
    if bpy.app.version < (5, 0, 0):
        material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    diffuse, output = nodes.new("ShaderNodeBsdfDiffuse"), nodes.new("ShaderNodeOutputMaterial")
    diffuse.inputs["Color"].default_value = (reflectance,) * 3 + (1,)
    material.node_tree.links.new(diffuse.outputs[0], output.inputs[0])
    return material


def lit_by(path):
    """Bring the file's lights in."""
    import bpy

    if path.suffix == ".py":
        exec(compile(path.read_text(), str(path), "exec"), {"__file__": str(path), "__name__": "__main__"})
    elif path.suffix == ".usda":
        bpy.ops.wm.usd_import(filepath=str(path))
    else:
        bpy.ops.preferences.addon_enable(module="io_scene_gltf2")
        bpy.ops.import_scene.gltf(filepath=str(path), export_import_convert_lighting_mode="SPEC")


def main(path, out):
    """Measure and write."""
    import bpy

    here = empty()
    lit_by(path)
    bpy.context.view_layer.update()
    lamp = next(thing for thing in here.objects if thing.type == "LIGHT")
    told = {
        "toward": list(lamp.matrix_world.to_3x3().col[2].normalized()),
        "strength": lamp.data.energy,
        "color": list(lamp.data.color),
        "exposure": here.view_settings.exposure,
    }
    here.view_settings.exposure = 0.0
    bpy.ops.mesh.primitive_plane_add(size=100)
    bpy.context.object.data.materials.append(grey(0.5))
    floor = seen_from_above(here, 0.01, 4, 4096)
    told["irradiance"] = (floor.mean((0, 1)) * np.pi / 0.5).tolist()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=0.3, location=(0, 0, 1))
    bpy.context.object.data.materials.append(grey(0.5))
    told["shadow"] = seen_from_above(here, 2.0, 64, 64).sum(-1).tolist()
    out.write_text(json.dumps(told))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
