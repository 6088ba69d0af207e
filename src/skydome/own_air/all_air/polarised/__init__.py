"""The network of polarisation taught anew: orders of scattering of Stokes I, Q and U in the same round shells.

- spin_harmonics  From polarised light to what the air gives off
- solver          Successive orders of scattering of I, Q and U
- lessons         Solved airs in a folder
- training        Shapes and the network from lessons
"""
