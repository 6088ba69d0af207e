"""USD: DomeLight_1 and DistantLight in nits (usdLux schema: without `normalize` a light's intensity is luminance)."""

import numpy as np

from skydome.export.scenes.scene import SceneFormat, SkyScene, listed
from skydome.export.scenes.sun_lamp import SunLamp
from skydome.light.colour import ACESCG, REC2020, SRGB

COLOUR_SPACES = {SRGB: "lin_rec709_scene", REC2020: "lin_rec2020_scene", ACESCG: "lin_ap1_scene"}
"""Names by GfColorSpaceNames."""

HEAD = """#usda 1.0
(
    defaultPrim = "Sky"
    doc = \"\"\"{about}\"\"\"
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "Sky"
{{
    def DomeLight_1 "Dome"
    {{
        uniform token poleAxis = "Y"
        float inputs:intensity = {white:.9g}
        color3f inputs:color = (1, 1, 1)
        asset inputs:texture:file = @./{map_name}@ (
            colorSpace = "{colours}"
        )
        token inputs:texture:format = "latlong"
    }}
{sun}}}
"""

SUN = """
    def DistantLight "Sun"
    {{
        float inputs:angle = {width:.9g}
        color3f inputs:color = ({tint})
        float inputs:colorTemperature = {kelvin:.0f}
        bool inputs:enableColorTemperature = 0
        float inputs:intensity = {luminance:.9g}
        bool inputs:normalize = 0
        matrix4d xformOp:transform = ( {matrix} )
        uniform token[] xformOpOrder = ["xformOp:transform"]
    }}
"""


class USDScene(SceneFormat):
    """A stage with y up in metres: DomeLight_1 whose texture and DistantLight whose disc are in cd m-2."""

    name = "USD"
    target_name = "usd"
    suffix = ".usda"

    def text(self, scene: SkyScene) -> str:
        """The stage, as text."""
        return HEAD.format(
            about="\n".join(scene.lines(self)),
            white=scene.white,
            map_name=scene.map_name,
            colours=COLOUR_SPACES.get(scene.space, "auto"),
            sun="" if scene.lamp is None else self.sun(scene.lamp),
        )

    def sun(self, lamp: SunLamp) -> str:
        """The DistantLight, which shines along its own -z; colour of luminance 1, intensity in nits."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.lamp_frame(lamp)
        return SUN.format(
            width=lamp.width,
            tint=listed(lamp.tint(), ", "),
            kelvin=lamp.colour_temperature,
            luminance=lamp.luminance,
            matrix=", ".join(f"({listed(row, ', ')})" for row in matrix),
        )
