"""Skies as source code for renderers, and the scenes that light with them.

- shaders           `shader`: a sky as one function from a direction to linear RGB, in GLSL, WGSL, HLSL, OSL or C
- shader_languages  How each of those languages spells a function, a vector and a constant
- sky_numbers       A sky's numbers as constants in its code, or read from an array
- formula_shader    The nine-number formula as shader code: one sky's coefficients as constants
- basis_shader      A sky in a basis as shader code: its functions written out, its coefficients as constants
- network_shader    A neural sky as shader code: the network under one sky, its weights as constants
- free_network_shader  A neural sky as a function of direction, sun and turbidity, its weights the only numbers
- disc_shader       The sun's disc added to a sky's code
- held_shader       A physical sky as shader code: its table read, its phase functions in closed form
- spectral_pictures  Maps of spectra: Radiance 6's .hsr, and OpenEXR in the spectral layout of Fichet et al.
- scenes/           The sun as a lamp beside a map of the sky without it, in each renderer's own language
"""
