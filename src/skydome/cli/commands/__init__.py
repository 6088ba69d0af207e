"""One command a file; those that measure, simulate and learn are in `cli/learning`.

- render       `skydome render`, an environment map of the sky in a file
- light        `skydome light`: the numbers of the sky's light
- plot         `skydome plot`: the sky's luminance as a round picture, looking up
- sun          `skydome sun`: where the sun stands and when it rises, sets and leaves the sky dark
- list_models  `skydome models`: every model with its parameters, ranges, rung and source, as the classes tell them
- convert      `skydome convert`: a map from one renderer's layout and file format to another's
- shader       `skydome shader`: a sky as a function of direction in a shading language
- explore      `skydome explore`: the explorer in the browser, served from the package to this machine alone
- glare        `skydome glare`: what an eye, or a camera, makes of a map's sun, side by side with the bare view
- illuminance  `skydome illuminance`: the light on a plane, tilted or not, under an open or an obstructed sky
- planes_of_year  `skydome illuminance --weather`: the light on planes through a year
- weather      `skydome weather`: how good a weather file's light is, a picture of it, and its repair
- daylight     `skydome daylight`: daylight metrics of a room, from coefficients, or triangles and points
- year         `skydome year`: a weather file in, a year of skies out; or many sites on a cluster
- terrain      `skydome terrain`: a picture of real land under a sky, with the air in between
"""
