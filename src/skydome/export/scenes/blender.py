"""Blender: a script that sets the world, the sun, the units and the exposure of the view.

Cycles: a sun lamp of strength E gives the irradiance E on a plane that faces it, whatever its angle; a background of
strength s shows the texture times s. Both are in W m-2 here, of 179 lm W-1, as Radiance counts.
"""

from skydome.export.scenes.scene import SceneFormat, SkyScene, listed, stops
from skydome.ground.units import RADIANCE_EFFICACY
from skydome.light.colour import ACESCG, REC2020, SRGB

COLOUR_SPACES = {SRGB: "Linear Rec.709", REC2020: "Linear Rec.2020", ACESCG: "ACEScg"}
"""Names in Blender's own colour configuration."""

SCRIPT = '''"""{about}

Run it in the Text Editor, or: blender scene.blend --python {{this file}}. One unit is a metre; x east, y north, z up.
Light is in W m-2 of {efficacy:g} lm W-1: a pixel of 1 is {efficacy:g} cd m-2.
"""

import os

import bpy
from mathutils import Vector

MAP = "{map_name}"
STRENGTH = {strength:.9g}
VIEW_EXPOSURE = {stops:.4f}


def beside(name):
    """The map beside this script, or beside the .blend file."""
    folders = [os.path.dirname(os.path.abspath(__file__)), bpy.path.abspath("//")]
    return next(path for path in (os.path.join(folder, name) for folder in folders) if os.path.exists(path))


scene = bpy.context.scene
scene.unit_settings.system, scene.unit_settings.scale_length = "METRIC", 1.0

world = bpy.data.worlds.new("Sky")
scene.world = world
if bpy.app.version < (5, 0, 0):
    world.use_nodes = True
nodes, links = world.node_tree.nodes, world.node_tree.links
nodes.clear()
texture = nodes.new("ShaderNodeTexEnvironment")
texture.image = bpy.data.images.load(beside(MAP))
texture.image.colorspace_settings.name = "{colours}"
texture.projection, texture.interpolation = "EQUIRECTANGULAR", "Linear"
background, output = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
background.inputs["Strength"].default_value = STRENGTH
links.new(texture.outputs["Color"], background.inputs["Color"])
links.new(background.outputs["Background"], output.inputs["Surface"])
texture.location, output.location = (-320, 0), (220, 0)
{sun}
scene.view_settings.exposure = VIEW_EXPOSURE
'''

SUN = """
sun = bpy.data.lights.new("Sun", "SUN")
sun.color = ({colour})
sun.energy = {energy:.9g}  # {lux:.6g} lx facing it, {kelvin:.0f} K
sun.angle = {angle:.9g}
lamp = bpy.data.objects.new("Sun", sun)
lamp.rotation_euler = Vector(({toward})).to_track_quat("Z", "Y").to_euler()
scene.collection.objects.link(lamp)
"""


class BlenderScene(SceneFormat):
    """A script for Blender 4 and 5."""

    name = "Blender"
    target_name = "blender"
    suffix = ".py"

    def text(self, scene: SkyScene) -> str:
        """The script."""
        return SCRIPT.format(
            about="\n".join(scene.lines(self)),
            efficacy=RADIANCE_EFFICACY,
            map_name=scene.map_name,
            strength=scene.white / RADIANCE_EFFICACY,
            stops=stops(scene.exposure, RADIANCE_EFFICACY),
            colours=COLOUR_SPACES.get(scene.space, "Linear Rec.709"),
            sun="" if scene.lamp is None else self.sun(scene),
        )

    def sun(self, scene: SkyScene) -> str:
        """The lamp: its colour within 0..1, its strength in W m-2."""
        lamp = scene.lamp
        assert lamp is not None
        rgb = lamp.rgb()
        return SUN.format(
            colour=listed(rgb / rgb.max(), ", "),
            energy=rgb.max() / RADIANCE_EFFICACY,
            lux=lamp.illuminance,
            kelvin=lamp.colour_temperature,
            angle=2 * lamp.angular_radius,
            toward=listed(self.toward(lamp.direction), ", "),
        )
