"""Scenes: the sun as a lamp beside a map of the sky without it, in the renderer's own language.

- saving    `save_scene`: a map without the sun, and beside it the scene that lights with both
- formats   Every kind of scene by the ending of its file
- scene     What a scene tells, whatever its language: the map, its unit, the sun's lamp, how bright to show it
- sun_lamp  The sun as a lamp: direction, colour, illuminance, width
- usd       USD: DomeLight_1 and DistantLight in nits
- blender   Blender: a script that sets the world, the sun, the units and the exposure of the view
- mitsuba   Mitsuba 3: envmap and directional emitters
- pbrt      pbrt-v4: infinite and distant lights
- three     three.js: a module that adds background, environment and sun
- three_environment  Its functions that make the environment's light exact on every side
- radiance  Radiance: a glowing sky that shows the picture, and a source in W m-2 sr-1
- gltf      glTF: the sun by KHR_lights_punctual
"""
