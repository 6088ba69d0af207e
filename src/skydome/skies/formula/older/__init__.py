"""Older skies that the papers name, each by its own formula.

- matsuura_iwata    Matsuura and Iwata's sky between clear and overcast, the third model of Radiance's gensky
- asrc_cie          The ASRC-CIE sky, between four standard skies by the weather, as daylight programs have it
- brunger_hooper    Brunger and Hooper's sky, three terms fitted to measured radiance, by clearness and diffuse share
- harrison_coombes  Harrison and Coombes' sky, radiance over irradiance of clear and of opaque cloud, by cloud cover
- pokrowski         Pokrowski's clear sky, Rayleigh scattering plus a constant, in the numbers of Grant et al.
- takagi            Takagi et al.'s colour: a colour temperature for each luminance, and the CIE's daylight of it
"""
