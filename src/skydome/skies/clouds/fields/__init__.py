"""Fields of cloud: shapes in three dimensions, and the sky that they make of a clear one.

- noise            Noise of space, periodic: gradient noise and cellular noise from a hash of the lattice
- noise_kernel     The same compiled
- kinds            The kinds of cloud: where they float, how thick and dense they are, and their shape as noise
- thickening       Cloud made thicker or thinner along one ray: what stands before the sun
- field            A field of cloud: extinction at every place over the ground, repeating, drifting with the wind
- medium_kernel    Extinction at a place, means over coarse cells, depths along rays, compiled
- scattering       How cloud scatters: the particles' law, the same after many small turns, angles drawn from it
- low_sun          Low suns over and under a field: slopes, and how much of their light meets it
- transport/       Light scattered more than once: discrete ordinates through a coarse grid
- lit_field        A field under its lights: depths toward the sun, scattered light of sun, sky and ground
- march_kernel     Rays through a lit field, compiled
- air/             The air about a field: above, below, between eye and cloud
- incident         The light of a clear sky on a field, in channels, and the air before the cloud
- sky              A sky of clouds
- shadows          What a field lets straight through of the sun, over the ground: shadows as a map
- reference        A sky of clouds by brute force: paths of light through the field, with standard errors
- tracing_kernel   Those paths, compiled
"""
