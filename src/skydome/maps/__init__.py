"""Environment maps: layouts, files, targets.

- environment_map    The environment map, light from every direction: asked, turned, laid out otherwise and saved
- pixels             What a map consists of: pixels with a layout, a colour space and a unit
- projection         What every map projection answers: where a texel looks, where a direction falls; half pixels
- projections        Every projection by name
- equirectangular    Equirectangular maps: azimuth along the row, elevation down the column
- sky_view           The sky-view map of games: latitude-longitude with its rows crowded at the horizon
- equal_area_square  The equal-area octahedral square of pbrt-v4: every texel has the same solid angle
- cube               Cube maps: six square faces in a vertical strip, in OpenGL's order and orientation
- fisheye            Circular maps looking up: fisheye lenses, the angular map and the mirror ball
- level_probe        Light probes: circular maps of the whole sphere whose middle looks level to the north
- targets            Where each renderer puts north: one small table of layouts and frames
- files              Maps to files: which layout, which scale, and what the header says about the light
- loading            Maps from files: pixels, unit, primaries, place, time and provenance back out of the header
- lookup             Values of a map toward any direction: the texel that is hit, or the four around it
- resample           A map in another layout or size, its light conserved: areas are averaged
- integrals          Light that a map sends onto surfaces: sums over its texels' solid angles
- by_rows/           Maps of which never more than some rows are at hand, and their light on its way into files
- showing/           How skies and maps show themselves to people: previews, tables, pictures in notebooks, plots
"""
