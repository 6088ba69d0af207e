"""The moon's light: its disc, the sky that it lights, and the earth's shadow over it.

- lunar_light    The moon's light above the air, by the ROLO model of its disc's reflectance
- earth_shadow   Sunlight in the earth's shadow: penumbra, umbra, and what the air bends into it
- lunar_eclipse  How deep the moon stands in the earth's shadow: magnitudes of eclipses
- moon_face      The moon's face: how its surface shines by phase, maria and shadow
- moonlight      Moonlight: the physical sky with the moon as its light
- moon_disc      The moon's disc in the sky, through the air that bends its light
"""
