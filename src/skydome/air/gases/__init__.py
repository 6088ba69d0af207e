"""Gases whose absorption is made of lines that saturate: water vapour, oxygen, carbon dioxide.

- bands     How much of a beam bands of lines let pass, and how strong they are by wavelength
- gases     The gases of an air: what they leave of a beam
- skylight  What they leave of the light of the sky, which has come by many ways
- missing   The notice that light is asked for where real air absorbs by gases that an air lacks
"""
