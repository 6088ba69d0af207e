"""Sky models for an air of one's own: simulate a grid, fit a formula to it.

- grid           A whole grid of simulated skies in a Zarr store: independent pieces, computed by Dask
- family         Skies of one kind of air under many suns: what whole sky models are fitted to
- refit          The nine numbers fitted to any spectral sky: one set for each sun and wavelength
- bezier_family  A sky model of one's own: the nine numbers as Bezier curves in the sun's elevation
- bezier_fit     One air and wavelength under all suns: how far Bezier curves of A, B, E and H are off
- preetham_fit   Preetham's form fitted to a family of skies: five letters linear in turbidity
- all_air/       The physical sky taught anew: its solver, lessons and training
- clouds/        The overcast sky taught anew: random layers of cloud, lessons and training
"""
