"""Crystals of ice: sunlight through hexagonal prisms.

- hexagonal_ice  The kind of particles: shape, roughness, what they do to light by their size
- phase          Their phase function: rays and diffraction together
- mixture        Traced light of a mixture of prisms, read from the table
- diffraction    The peak of light that goes around a prism, and how diffraction spreads what comes through
- halos          Where halos stand, and angles drawn out such that they stand at the same ones
- prism          A hexagonal prism, and rays that meet it
- fresnel        A ray at a face: mirrored, refracted, polarised
- tracing        Rays through prisms, counted: what the table is made of
"""
