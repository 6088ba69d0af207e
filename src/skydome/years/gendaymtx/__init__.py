"""A year by the rules of Radiance's gendaymtx, number by number.

- matrix      A year of Perez skies by the rules of Radiance's `gendaymtx`, to the rounding of its floats
- hours       What gendaymtx reads of a year, and where it puts the sun
- conditions  What gendaymtx makes of a tape's numbers, clearness, brightness
- rows        Many Perez skies on Reinhart's patches, row by row
- sun         The sun in gendaymtx's patches: spread over the four whose centres are nearest, or in one
- suns        One light source for each hour with the sun up, as `gendaymtx -D` writes them
- text        Radiance's matrix files: an ASCII header, then numbers as text or as raw floats
"""
