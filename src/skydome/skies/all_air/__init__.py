"""One sky for all air: light scattered once exactly, the rest by small networks.

- sky                 The physical sky, from noon to the end of twilight
- lit_air             An atmosphere at some wavelengths, whole or of some suns and airs
- taught_air          The optical numbers that the rest depends on, and the ranges that were taught
- low_aerosol         Low aerosols of any phase law as the one lobe that was taught, and what lies beyond it
- deep_ozone          Ozone deeper than was taught, in the ultraviolet
- single_scattering   Light scattered once in round shells, in arrays of any library, with gradients
- column_tables       Densities and columns of constituents as tables that any library looks up
- spectral_nodes      Eleven wavelengths that stand for the spectrum in colours
- fast                That light of many rays, compiled or in arrays
- single_kernel       Its compiled form
- many_suns           Suns of a kind together: night costs nothing, only twilight pays for twilight
- blocks              Work on arrays that broadcast, some of it at a time
- bent_sun            The sun's disc through that air: lifted, flattened, reddened
- rest                What is scattered more than once, by networks over shapes of the dome
- rest_files          Those networks in a file
- polarised/          Polarisation: Stokes parameters, and the network of their rest
- from_heights/       The sky, the haze below and the ground, seen from a height
"""
