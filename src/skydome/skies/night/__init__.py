"""The light of the night: moon, stars, the glow of dust and air, and all of it together.

- magnitudes    Magnitudes, colours and surface brightness of the heavens as light
- through_air   What the air does to the light of the heavens
- moon/         The moon: its disc, the sky that it lights, eclipses in the earth's shadow
- stars         Stars and planets as points of light through the air
- scattering    Light that glows all over the sky, as the physical sky scatters it
- held_dome     A smooth sky's colours on a fine grid of the dome, for maps
- celestial     Light from beyond the air that glows all over the sky: what its kinds share
- zodiacal      Zodiacal light: sunlight on the dust between the planets
- starlight     Starlight of what is too faint to be a point: the Milky Way
- airglow       Airglow: the upper air's own light, lines and a continuum
- skyglow       Skyglow: the light of towns that the air sends back
- eclipse       Eclipses of the sun: how much of it the moon covers, and what is left of its light
- clouds/       What clouds over the place make of each light: an overcast, a field
- turned        The parts as a scene sees them whose own north is another
- hour          A place and an hour: which lights matter there then, and what was left out
- sky_at        The whole sky of a place and a time, day or night, as a sum of skies
- through_time  The light on the level through many times, each part by itself
"""
