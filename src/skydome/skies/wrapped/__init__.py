"""Skies that change another sky: all that they do not tell is that sky's own.

- wrapped_sky    What they share: the other's day and ground, its sun, and the air that the sun shines through
- daylight_sky   Colour for skies that know luminance only, given on purpose
"""
