"""The air about a field of cloud: what it lets through, and what it makes of the light.

- channels       What light is told in: one wavelength, colours, energy
- above          The air above a height, and the light of its sky on the field
- lower          The air below the field: what it makes of the light of cloud and ground
- exchange       Light to and fro between field, lower air and ground
- before         What the air before the cloud lets through, by elevation and height
- sunlight       The sun's light on cloud by its height and distance
- sunlight_kernel  What a ray to the sun meets, and how bright the sun is, for paths, compiled
- before_kernel  Cloud behind its air, put together, compiled
"""
