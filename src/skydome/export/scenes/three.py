"""three.js: a module that adds background, environment and sun (release 165 and later: lights in physical units)."""

import json

from skydome.export.scenes.scene import SceneFormat, SkyScene, listed
from skydome.export.scenes.three_environment import ENVIRONMENT

MODULE = """{about}
//
//   import {{ addSky }} from "./{{this file}}";
//   const {{ sky, sun }} = await addSky(scene, renderer);   // sun casts shadows; null where none shines

import * as THREE from "three";
import {{ EXRLoader }} from "three/addons/loaders/EXRLoader.js";
import {{ LightProbeGenerator }} from "three/addons/lights/LightProbeGenerator.js";

export const unit = {white:.9g};            // cd m-2 of RGB (1, 1, 1)
export const exposure = {exposure:.6g};     // per cd m-2, as a photograph would show it
export const lamp = {lamp};

export async function addSky(scene, renderer) {{
  const sky = await new EXRLoader().loadAsync(new URL({map_name}, import.meta.url).href);
  sky.mapping = THREE.EquirectangularReflectionMapping;
  scene.background = sky;
  scene.environment = environmentOf(sky, renderer);   // light of the sky and of the map's ground
  renderer.toneMapping = THREE.ACESFilmicToneMapping;
  renderer.toneMappingExposure = unit * exposure;
  if (lamp === null) return {{ sky, sun: null }};
  const sun = new THREE.DirectionalLight(new THREE.Color(...lamp.color), lamp.intensity);
  sun.position.set(...lamp.toward);      // toward the sun; move it and its target together
  sun.castShadow = true;
  scene.add(sun, sun.target);
  return {{ sky, sun }};
}}

// For materials that know no environment (Lambert, Phong, Toon): scene.add(await probeOf(sky, renderer)). Nine
// harmonics: under a low sun up to 24 % off on the side away from it. Physical materials would have the light twice.
export async function probeOf(sky, renderer) {{
  const cube = new THREE.WebGLCubeRenderTarget(128, {{ type: THREE.HalfFloatType }});
  cube.fromEquirectangularTexture(renderer, sky);
  const probe = await LightProbeGenerator.fromCubeRenderTarget(renderer, cube);
  cube.dispose();
  return probe;
}}
"""

LAMP = """{{
  toward: [{toward}],
  color: [{tint}],         // linear, of luminance 1
  intensity: {intensity:.9g},            // {lux:.6g} lx over the unit
}}"""


class ThreeScene(SceneFormat):
    """An ES module with one function, `addSky`."""

    name = "three.js"
    target_name = "three"
    suffix = ".js"

    def text(self, scene: SkyScene) -> str:
        """The module."""
        head = MODULE.format(
            about="\n".join(f"// {line}" for line in scene.lines(self)),
            white=scene.white,
            exposure=scene.exposure,
            lamp=self.lamp(scene),
            map_name=json.dumps(f"./{scene.map_name}"),
        )
        return head + ENVIRONMENT

    def lamp(self, scene: SkyScene) -> str:
        """The sun's numbers as an object; null without a sun."""
        lamp = scene.lamp
        if lamp is None:
            return "null"
        return LAMP.format(
            toward=listed(self.toward(lamp.direction), ", "),
            tint=listed(lamp.tint(), ", "),
            intensity=lamp.illuminance / scene.white,
            lux=lamp.illuminance,
        )
