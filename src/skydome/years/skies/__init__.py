"""The skies of a year's hours on the dome's patches.

- series             A year of skies on the dome's patches, as an xarray Dataset: `year("site.epw")`
- perez_year         Perez skies of every interval of a year, by the paper or with the limits of gendaylit
- status             What happened in each hour of a year, as flags: nothing is black or held at a limit in silence
- dome_means         Means of many Perez skies over the dome's patches
- dome_means_kernel  The fast form of `dome_means`, compiled
- colour_year        Colour and spectrum for a year of measured skies, at Perez's luminance
- sun_spectra        The sun's spectrum in every hour of a coloured year: clear air's, at the direct light measured
- twilight           Twilight in a coloured year: hours without irradiance take the light of the clear sky itself
- cie_of_year        Which of the CIE's fifteen skies each hour of a year is nearest to
- kinds_of_sky       The kind of each hour's sky: overcast, partly cloudy or clear, and how unsteady its light is
- clouds             Clouds in a coloured year: how much of an hour's light they send
- overcast_light     Overcast light of a year: colour and spectrum of what comes through a layer of cloud
"""
