"""Light as numbers: spectra, colours and daylight.

- spectrum            Spectra and the CIE 1931 observer: from samples over wavelength to XYZ with Y in cd m-2
- colour              Colour: CIE xyY, XYZ and linear or encoded RGB of the spaces in which sky images are kept
- gamut               Colours that an RGB space cannot show, moved toward its white: luminance and hue kept
- colour_temperature  Colour temperature: Planck's law, the nearest black body to a colour, and the distance to it
- action_spectra      What a spectrum does: to body clocks, to plants, to skin
- irradiance          Measured irradiances of sun and sky: their limits and the reasons
- decomposition       Global irradiance split into diffuse and direct where it is all that was measured
- radiance_bands      Spectra as Radiance 6 has them: even bands, from long waves to short
- tone                From scene to screen: exposure, and curves that bring any brightness into 0..1, hue kept
- daylight            Daylight: the spectrum of the CIE D series that has a given colour and luminance
"""
