"""What is done with a whole dome of light: maps, integrals, patches, samples.

- render         Maps of skies: the sky above, the ground below, the sun's energy exact
- map_rows       The same told by blocks of rows, for maps of any size
- render_pixels  Maps of one sky or many in the library of their parameters, differentiable
- small_lights/  Lights smaller than the texels of a map: the sun, the moon, stars
- ground_light   The ground of a map, a Lambertian plane under its sky
- painting       The light of skies written into the pixels of a map, whole or some rows at a time
- sources        Skies ready to be painted, each kind by its rows or direction by direction
- sky_rows       Rows of an equirectangular map of one sky, each row's factors once
- network_rows   Rows of an equirectangular map of one neural sky, what a row shares goes into the biases
- held_rows      Rows of an equirectangular map of a sky held in a table
- dome_rows     The same of smooth skies on a grid of the dome, such as the glows of a night
- integrals      Integrals of the dome: what light falls on a plane
- energy/        Broadband irradiance, the UV index, photons for plants
- patches        The sky cut into patches, Tregenza's 145, Reinhart's finer ones, and patches of equal area
- patch_means    The mean light of each patch of the sky, to a stated error: finer where the sky is steep
- harmonics      Skies as spherical harmonics, smooth light in few numbers
- bases/         Skies as sums of few basis functions: harmonics, Legendre series, steerable lobes, Gaussians
- sampling       Random directions toward the light of a sky, with their probability densities
"""
