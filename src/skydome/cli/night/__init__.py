"""What the commands say of the night.

Commands import it inside themselves, as all that the heavens need.

- moon_and_planets  `skydome sun --moon --planets`: where they stand, their phase and magnitude, when they rise and set
"""
