"""Skies as sums of few basis functions: any sky, in numbers that games and renderers carry.

- basis               What every basis answers: its functions, the fit of a sky, irradiance, rotation
- harmonic_bases      Spherical and hemispherical harmonics, and Dobashi's Legendre polynomials and cosines
- lobe_bases          Steerable powers of cosines as Nimeroff's, and spherical Gaussians
- sky_basis           A sky in a basis: a sky itself, with its errors, irradiance from its numbers, and rotation
- preetham_harmonics  Preetham's sky in spherical harmonics by polynomials of sun and turbidity (Habel et al. 2008)
"""
