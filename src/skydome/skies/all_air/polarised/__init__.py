"""Polarisation of the physical sky: of light scattered once exactly, of the rest by a small network.

- stokes_sky  The rung of skies whose polarisation is known: Stokes parameters, degree and angle
- frame       The plane that Stokes parameters are told by, and how the sun stands to it
- network     What polarisation adds to the rest's intensity, and the rest's Q and U
- light       Polarised light of lit air over its intensity without polarisation
- files       That network in a file
"""
