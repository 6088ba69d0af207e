"""Light on planes among obstructions: horizons, streets, meshes.

- obstruction  Light on a plane among obstructions: the sky through the visible intervals of bands, and the sun
- bands        The sky as bands: lunes between planes through one axis in the receiving plane
- intervals    What each band sees along its length: the intervals of sky, ground and faces
- horizon      The horizon as seen from one place: elevation by azimuth, from a table or from a model of the terrain
- canyon       An endless street between two walls of one height: the light on its floor and walls
- mesh         Light in a scene of triangles: what each point sees, by ray casting
- radiosity    Light between diffuse faces: form factors in closed form, and what each sends to the others
- light_kinds  In what light is counted on its way from sky to plane: lux, XYZ, RGB or wavelengths
"""
