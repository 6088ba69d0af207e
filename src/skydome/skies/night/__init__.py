"""The light of the night: the moon's and the sky's under it.

- lunar_light  The moon's light above the air, by the ROLO model of its disc's reflectance
- moonlight    Moonlight: the physical sky with the moon as its light
- moon_disc    The moon's disc: limb, phase, tilt and maria, and the earth's light on its dark side
"""
