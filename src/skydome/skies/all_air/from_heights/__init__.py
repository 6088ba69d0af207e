"""The sky, the haze below and the ground, seen from a height above the ground.

- harmonics      Legendre's associated functions
- blunted        Air whose phase functions are few moments, the sharp forward peak taken off
- layers         Flat layers: how what is given off at all heights comes to each
- views          What the air gives off along views of the light that comes from all sides
- views_kernel   Its compiled form
- diffuse_field  The light inside the air at all heights under all suns, one linear equation a wave in the azimuth
- sky            The sky from a height, by that field
"""
