"""Mitsuba 3: envmap and directional emitters (its documentation's units: radiance, and irradiance facing the sun)."""

from skydome.export.scenes.scene import SceneFormat, SkyScene, listed
from skydome.export.scenes.sun_lamp import SunLamp

SCENE = """<scene version="3.0.0">
    <!--
    {about}
    `directional` has no width: shadows are sharp. A film shows it well when its values are multiplied by {factor:.4g}.
    -->
    <emitter type="envmap" id="sky">
        <string name="filename" value="{map_name}"/>
    </emitter>
{sun}</scene>
"""

SUN = """    <emitter type="directional" id="sun">
        <vector name="direction" value="{travels}"/>
        <rgb name="irradiance" value="{light}"/>
    </emitter>
"""


class MitsubaScene(SceneFormat):
    """The emitters alone, to be included in a scene: <include filename="sky.xml"/>."""

    name = "Mitsuba 3"
    target_name = "mitsuba"
    suffix = ".xml"

    def text(self, scene: SkyScene) -> str:
        """The emitters, in the unit of the map's file."""
        return SCENE.format(
            about="\n    ".join(line.replace("--", "- -") for line in scene.lines(self)),
            factor=scene.exposure * scene.white,
            map_name=scene.map_name,
            sun="" if scene.lamp is None else self.sun(scene.lamp, scene.white),
        )

    def sun(self, lamp: SunLamp, white: float) -> str:
        """The directional emitter: where its light travels, and its irradiance."""
        return SUN.format(travels=listed(-self.toward(lamp.direction), ", "), light=listed(lamp.rgb() / white, ", "))
