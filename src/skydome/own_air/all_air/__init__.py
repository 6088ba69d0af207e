"""The physical sky taught anew: airs at random, all orders of scattering in round shells, networks of the rest.

- airs           Airs drawn at random, far wider than real ones
- shells         Round shells of air, and rays through them with nodes and columns
- sunlight       Sunlight along the rays: bent, thinned, blocked by the ground
- phases         Phase functions of many airs, as they are and cut to a few moments
- places         The grid of heights, views, suns and azimuths
- harmonics      From light to what the air gives off
- solver         Successive orders of scattering, many airs and all suns at once
- solver_kernel  The compiled steps of it
- lessons        Solved airs in a folder: a run goes on where it was stopped
- training       Shapes and networks from lessons
- polarised/     The same for polarisation
"""
