"""What the commands say of the night.

Commands import it inside themselves, as all that the heavens need.

- whole_scene       The light of a place at any hour: what the commands show when the sun has set
- eclipse           What the moon leaves of the sun by day
- film              A film of one day at a place, a map every so many minutes
- movie             The frames of a day as one .mp4, by ffmpeg
- moon_and_planets  `skydome sun --moon --planets`: where they stand, their phase and magnitude, when they rise and set
"""
