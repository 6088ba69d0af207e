"""glTF 2.0: the sun by KHR_lights_punctual (a directional light along its node's -z, in lux); the map is named beside.

glTF has no map of the surroundings among its ratified extensions: the viewer is given the file by itself.
"""

import json
from typing import Any

import numpy as np

from skydome.export.scenes.scene import SceneFormat, SkyScene
from skydome.export.scenes.sun_lamp import SunLamp

LIGHTS = "KHR_lights_punctual"


class GLTFScene(SceneFormat):
    """One node with the sun's light; the map's name and unit stand in the scene's `extras`."""

    name = "glTF"
    target_name = "three"
    suffix = ".gltf"

    def text(self, scene: SkyScene) -> str:
        """The asset, as JSON."""
        told = list(scene.lines(self))
        environment = {
            "uri": scene.map_name,
            "white_luminance_cd_m2": scene.white,
            "exposure_per_cd_m2": scene.exposure,
        }
        asset: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": told[0]},
            "scene": 0,
            "scenes": [{"name": "Sky", "extras": {"about": told[1:], "environment": environment}}],
        }
        if scene.lamp is not None:
            asset["scenes"][0]["nodes"] = [0]
            asset |= self.sun(scene.lamp)
        return json.dumps(asset, indent=2) + "\n"

    def sun(self, lamp: SunLamp) -> dict[str, Any]:
        """The light, its colour within 0..1, and the node that turns it."""
        rgb = lamp.rgb()
        light = {
            "name": "Sun",
            "type": "directional",
            "color": (rgb / rgb.max()).tolist(),
            "intensity": float(rgb.max()),
            "extras": {"angle_deg": lamp.width, "colour_temperature_K": lamp.colour_temperature},
        }
        node = {"name": "Sun", "rotation": quaternion(self.lamp_frame(lamp)), "extensions": {LIGHTS: {"light": 0}}}
        return {"extensionsUsed": [LIGHTS], "extensions": {LIGHTS: {"lights": [light]}}, "nodes": [node]}


def quaternion(rows: np.ndarray) -> list[float]:
    """x, y, z, w of the turn that brings the axes x, y, z to the rows (3, 3) of a right-handed frame.

    By the largest eigenvector of Bar-Itzhack's symmetric matrix (2000), which has no special cases.

    >>> np.round(quaternion(np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])), 6).tolist()
    [0.0, 0.0, 0.707107, 0.707107]
    """
    turn = rows.T
    skew = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    matrix = np.zeros((4, 4))
    matrix[:3, :3] = turn + turn.T - np.trace(turn) * np.eye(3)
    matrix[:3, 3] = matrix[3, :3] = skew
    matrix[3, 3] = np.trace(turn)
    found = np.linalg.eigh(matrix / 3)[1][:, -1]
    signed: list[float] = (found * np.sign(found[3] or 1.0)).tolist()
    return signed
