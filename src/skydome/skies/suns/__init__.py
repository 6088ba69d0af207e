"""The sun's disc, by its published tables or through a given air.

- held_sun        The sun's direction as a sky holds it: looked at once, and no more to be written to
- sun_disc        The sun's disc: Hosek and Wilkie's solar radiance, limb darkening, exact irradiance
- preetham_sun    The sun's disc through Preetham's clear air, physical in level and colour
- point_lights    Lights too small for any texel, such as stars
- gensky_sun      The sun that Radiance's gensky puts into its skies
- atmosphere_sun  The sun's disc through an `Atmosphere`: the direct light that belongs to a physical sky
"""
