"""The sky by brute force: paths of light through spherical shells of air.

- sky               The sky by brute force, backward Monte Carlo in spherical shells, all orders, ground
- tables            What the path tracer's kernel reads, geometry
- guide             What leads the path tracer in twilight, a coarse picture of the light in the air
- many_suns         The path tracer's other way to find the sun: by chance, with many suns in the sky at once
- loop_kernel       The path tracer's loops over directions, paths and events, compiled by Numba
- event_kernel      What happens to a path where it arrives, at all wavelengths, weights, sunlight
- flight_kernel     Straight ways through the air, where they end, what lies on them, where a flight ends
- parts_kernel      Parts of the path tracer, compiled by Numba, random numbers, columns and densities
- guide_kernel      Where paths are led in twilight
- light_kernel      The coarse picture of the light in the air that paths are led by in twilight, compiled by Numba
- many_suns_kernel  Paths that are followed until they leave the air, and counted where they hit one of many suns
"""
