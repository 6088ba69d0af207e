"""The air: what it is made of, how it is spread over height, and what it does to light.

- atmosphere          An atmosphere: constituents in spherical shells over a ground, lit by a sun
- named_airs          Clear air of the earth by what people know of it
- constituents        What air is made of: molecules that scatter, aerosol that scatters and absorbs, ozone that absorbs
- profiles            How a constituent of the air is spread over height
- cross_sections      What a molecule of air or of ozone takes out of a beam; the sun above the air
- bending             How the air bends light: where it comes from, how low it has been, how it is thinned
- rays                Straight rays through spherical shells: where they end, how much of each constituent lies on them
- phase_functions     Phase functions: how much of the light that air and haze scatter goes which way, per steradian
- phase_laws          Phase functions as objects: their value, and their Legendre moments for solvers that want them
- series/             Phase functions by their Legendre moments, tabulated where they are long
- size_distributions  How large the particles of an aerosol are: lognormal, Junge, gamma
- mie                 Mie theory for particles of many sizes: extinction, albedo and phase function by wavelength
- turbidity           Turbidity from what people know: how far they see, Linke's factor, a place and a month
- optical_mass        How much air a ray from the sun crosses, in units of the vertical
- scattering          How strongly gas and haze at the ground scatter light, by wavelength and angle
- transmittance       Sunlight through clear air: what each constituent lets pass at each wavelength
- gases/              Gases whose bands of lines saturate: water vapour, oxygen, carbon dioxide
- clouds/             Clouds of water or ice: depth, absorption and phase functions by the size of their particles
- mars                The air of Mars: thin carbon dioxide and much dust, each number with its source
"""
