"""Light on planes among obstructions: horizons, streets, meshes.

- obstruction  Light on a plane among obstructions: the sky through the visible intervals of bands, and the sun
- bands        The sky as bands: lunes between planes through one axis in the receiving plane
- intervals    What each band sees along its length: the intervals of sky, ground and faces
- horizon      The horizon as seen from one place: elevation by azimuth, from a table or from a model of the terrain
- canyon       An endless street between two walls of one height: the light on its floor and walls
- mesh         Light in a scene of triangles: what each point sees, by ray casting
- rays         Rays in a scene of triangles, cast by Embree
- radiosity    Light between diffuse faces: form factors in closed form, and what each sends to the others
- patch_view   What a place sees of the sky's patches, of the ground and of faces, for every hour of a year
- faces        Light between the faces of a scene for a year, per luminance of each patch and per sun
- light_kinds  In what light is counted on its way from sky to plane: lux, XYZ, RGB or wavelengths
- channels     Reflectances and light of several places in one kind of light: their channels, shapes and limits
"""
