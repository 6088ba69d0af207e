"""What an eye or a lens makes of a bright sky: glow, needles, glare, flare.

- eye            The eye that looks at a sky: its age, its iris, its pupil, and what it makes of a map or a view
- point_spread   How the eye spreads a point of light: luminance seen per illuminance at the eye
- glow           The picture of one bright source in the eye, or as a plain disc
- streaks        The fine structure of glare: the needles of the ciliary corona
- view           What is seen in a direction: a camera's flat picture, or a round one of the half sphere in front
- view_blur      Scattering in the eye over a flat picture: a convolution by FFT
- sphere_blur    Scattering in the eye over the whole sphere: a product of zonal spherical harmonics
- bright_source  Suns and lamps in a map, found, taken out of the texels, and known by direction
- linked_groups  Directions in groups: two belong together where small steps lead from one to the other
- night_vision   The eye at night: rods see no colour, are quick for blue, and what they see looks bluish
- glare          How much a sky glares: daylight glare probability, veiling luminance and illuminance at the eye
- lens_flare     Ghosts of a camera's lens, reflections between its surfaces
"""
