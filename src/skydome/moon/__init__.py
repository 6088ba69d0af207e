"""Where the moon stands, and how it looks from there.

- geocentric  The moon as seen from the earth's centre, by ERFA
- position    Where the moon stands over a place, how far away and how large
- libration   Which side of itself the moon turns to whom: the selenographic places of the earth and of the sun
- phase       The moon's phase: its illuminated share, and which way its bright limb points
- events      The moon's day: when it rises, crosses the meridian and sets
"""
