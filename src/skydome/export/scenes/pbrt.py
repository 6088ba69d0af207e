"""pbrt-v4: infinite and distant lights (lights.cpp: a distant light's L is scaled to 1 nit, then by `scale`)."""

from skydome.export.scenes.scene import SceneFormat, SkyScene, listed
from skydome.export.scenes.sun_lamp import SunLamp
from skydome.light.colour import REC2020, RGBSpace

SCENE = """{about}
# A distant light has no width: shadows are sharp. A film shows it well when its values are multiplied by {factor:.4g}.
AttributeBegin
  ColorSpace "{colours}"
  LightSource "infinite" "string filename" "{map_name}"
{sun}AttributeEnd
"""

SUN = """  LightSource "distant" "point3 from" [ {toward} ] "point3 to" [ 0 0 0 ]
    "rgb L" [ {tint} ] "float scale" {light:.9g}
"""


class PbrtScene(SceneFormat):
    """The lights alone, to be included between WorldBegin and the shapes: Include "sky.pbrt"."""

    name = "pbrt-v4"
    target_name = "pbrt"
    suffix = ".pbrt"

    def lamp_space(self, space: RGBSpace) -> RGBSpace:
        """The map's own: the file names it."""
        return space

    def text(self, scene: SkyScene) -> str:
        """The lights, in the unit of the map's file."""
        return SCENE.format(
            about="\n".join(f"# {line}" for line in scene.lines(self)),
            factor=scene.exposure * scene.white,
            colours="rec2020" if scene.space == REC2020 else "srgb",
            map_name=scene.map_name,
            sun="" if scene.lamp is None else self.sun(scene.lamp, scene),
        )

    def sun(self, lamp: SunLamp, scene: SkyScene) -> str:
        """The distant light: its colour has luminance 1, its `scale` is the illuminance."""
        return SUN.format(
            toward=listed(self.toward(lamp.direction)),
            tint=listed(lamp.tint(self.lamp_space(scene.space))),
            light=lamp.illuminance / scene.white,
        )
