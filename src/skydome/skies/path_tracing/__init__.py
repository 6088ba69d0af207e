"""The sky by brute force: paths of light through spherical shells of air.

- sky                  The sky by brute force, backward Monte Carlo in spherical shells, all orders, ground
- tracing              What paths have brought so far, with its error: merged, stored, taken up
- tables               What the kernels read: an atmosphere's geometry, depths and phase laws as plain arrays
- first_order          Light scattered once, by quadrature, along straight rays or bent ones
- guide                What guides paths in twilight: coarse tables of the light in the air
- many_suns            The other way to find the sun: by chance, with many suns in the sky at once
- loop_kernel          The path tracer's loops over directions, paths and events
- event_kernel         A path at a vertex, at all wavelengths: throughput and pdf, next event, the next direction
- flight_kernel        Straight segments: where they end, the columns on them, transmittance, free flights
- bent_kernel          Light that the air bends: sunlight at a place, and the eye's own ray
- air_kernel           Columns, densities and phase functions of the air
- guide_kernel         Path guiding in twilight: flights and directions sampled from coarse tables of the light
- guide_tables_kernel  The tables of `guide`, computed order by order
- many_suns_kernel     Paths that are followed until they leave the air, and counted where they hit one of many suns
"""
