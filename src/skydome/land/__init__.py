"""Pictures of real land under a sky.

- picture          Pictures of real land, an elevation model under a sky, with shadows, skylight on slopes
- terrain_picture  A finished picture of land: its light, its depth, and the files that hold them
- elevation        Elevation models: heights on a grid in metres, and how holes in them are filled
- reading          Elevation models from GeoTIFF, .npz and .hgt files
- texture          Reflectance of land from a photograph of it from above, laid onto the elevation model
- sky_light        The light of a sky on land and behind it
- cloud_shade      What clouds leave of the sun over the land
- rays_kernel      Rays over a heightfield by a maximum mipmap, the light on it, and whole pictures, compiled
- picture_kernel   Rows of a terrain picture: rays, sun and shadows, skylight, and the air before them, compiled
"""
