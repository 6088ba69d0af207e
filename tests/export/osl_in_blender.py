"""Compile OSL by Blender's own compiler and run it in Cycles: python osl_in_blender.py FOLDER; needs the package bpy.

Every FOLDER/*.osl, a shader with one output `Sky`, becomes the world's background; FOLDER/NAME.exr is what a panoramic
camera sees of it, 32-bit floats. Not a test: run by `test_osl.py` with an interpreter that has bpy.
"""

import sys
from pathlib import Path


def scene():
    """An empty scene: one sample a pixel, a camera that looks all around, 32-bit EXR."""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="cycles")
    here = bpy.context.scene
    here.render.engine, here.cycles.device, here.cycles.shading_system = "CYCLES", "CPU", True
    here.cycles.samples, here.cycles.use_denoising, here.cycles.seed = 1, False, 7
    here.cycles.use_adaptive_sampling, here.render.threads_mode, here.render.threads = False, "FIXED", 1
    here.render.resolution_x, here.render.resolution_y, here.render.resolution_percentage = 48, 24, 100
    here.render.image_settings.file_format, here.render.image_settings.color_depth = "OPEN_EXR", "32"
    camera = bpy.data.cameras.new("camera")
    camera.type, camera.panorama_type = "PANO", "EQUIRECTANGULAR"
    here.camera = bpy.data.objects.new("camera", camera)
    here.camera.rotation_euler = (1.5, 0.1, 0.3)
    here.collection.objects.link(here.camera)
    here.world = bpy.data.worlds.new("world")
    return here


def show(here, source):
    """The shader of a file as the world's light, rendered beside it."""
    import bpy

    sys.path += map(str, Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/*/site-packages"))  # has oslquery
    from cycles import osl

    messages = []
    nodes, links = here.world.node_tree.nodes, here.world.node_tree.links
    nodes.clear()
    script = nodes.new("ShaderNodeScript")
    script.mode, script.filepath = "EXTERNAL", str(source)
    osl.update_script_node(script, lambda kind, text: messages.append(f"{kind}: {text}"))
    if "Sky" not in script.outputs:
        raise SystemExit(f"{source.name} does not compile: {messages}")
    background, output = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
    links.new(script.outputs["Sky"], background.inputs["Color"])
    links.new(background.outputs["Background"], output.inputs["Surface"])
    here.render.filepath = str(source.with_suffix(".exr"))
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    stage = scene()
    for path in sorted(Path(sys.argv[1]).glob("*.osl")):
        show(stage, path)
