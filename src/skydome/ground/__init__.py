"""The ground floor: arrays, directions, numbers and files, on which every room stands.

- arrays             One way to meet NumPy, PyTorch and JAX arrays: find the namespace, convert, guard the edges
- labels             Arrays with labels (pandas, xarray): plain ones go in, what comes out has the same labels
- units              Units as numbers to multiply with: angles are radians, lengths metres, wavelengths nanometres
- directions         Directions: unit vectors in the frame x east, y north, z up, that point toward the light
- quadrature         Quadrature over the upper hemisphere: nodes that crowd where skies are steep, weights in steradian
- compiled           The compiled floor: Numba's decorator with what it falls back to, and jobs shared among threads
- elementary_kernel  What kernels share: exponentials, the logarithm, random numbers
- interpolation      Linear weights, Lagrange's and Catmull and Rom's cubics, splines
- gauss_newton       A damped Gauss-Newton step, for networks and families of curves
- tables             Tables of measured and fitted figures: each a file in `data/` with its source written beside it
- png                PNG pictures: 8 bit sRGB
- hdr                Radiance pictures: RGB with a shared exponent, one byte each
- exr                OpenEXR files with their light's unit, place, time and provenance in the header
- arguments          What is asked of arguments before any work: kinds, files that are there, shapes
- extras             Libraries that not every user needs: each comes with an extra, and is asked for before any work
- writing            Files that appear whole or not at all: the one writer
- limits/            Ranges of numbers, sizes
- files/             Folders that appear whole, contents hashed
"""
