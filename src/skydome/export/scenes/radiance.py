"""Radiance: a glowing sky that shows the picture, and a source in W m-2 sr-1 (ray reference manual)."""

from skydome.export.scenes.scene import SceneFormat, SkyScene, listed
from skydome.export.scenes.sun_lamp import SunLamp
from skydome.light.colour import RADIANCE, RGBSpace

SCENE = """{about}
# Values are W m-2 sr-1 per channel: times {white:g} they are cd m-2.

void colorpict sky_picture
7 red green blue "{map_name}" . if(Dx,atan2(Dx,Dy),atan2(Dx,Dy)+2*PI)/PI 1-Acos(Dz)/PI
0
0

sky_picture glow sky_glow
0
0
4 1 1 1 0

sky_glow source sky
0
0
4 0 0 1 360
{sun}"""

SUN = """
void light sun_light
0
0
3 {light}

sun_light source sun
0
0
4 {toward} {width:.9g}
"""


class RadianceScene(SceneFormat):
    """Sky and sun for oconv; the picture must lie where Radiance runs, or on RAYPATH."""

    name = "Radiance"
    target_name = "radiance"
    suffix = ".rad"
    map_suffix = ".hdr"

    def lamp_space(self, space: RGBSpace) -> RGBSpace:
        """Radiance's own."""
        return RADIANCE

    def text(self, scene: SkyScene) -> str:
        """The scene description: a pattern on a glow all round, and a light of the sun's width."""
        return SCENE.format(
            about="\n".join(f"# {line}" for line in scene.lines(self)),
            white=scene.white,
            map_name=scene.map_name,
            sun="" if scene.lamp is None else self.sun(scene.lamp, scene.white),
        )

    def sun(self, lamp: SunLamp, white: float) -> str:
        """The light and its source; radiance is the irradiance over the disc's projected solid angle."""
        mean = lamp.rgb(RADIANCE) / lamp.illuminance * lamp.luminance / white
        return SUN.format(light=listed(mean), toward=listed(self.toward(lamp.direction)), width=lamp.width)
