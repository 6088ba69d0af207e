"""Phase functions by their Legendre moments: what Mie theory and solvers tell.

- legendre         Legendre polynomials and sums of them
- angle_table      A sum of many polynomials by its values at even angles, for very many directions
- legendre_series  The phase law of a series of moments at some wavelengths
"""
