"""How a sky shows itself to people: in notebooks, and on Matplotlib's axes.

- shown      What every sky can do: a picture, a table with units, a plot
- dome_axes  The sky looking up on axes: the disc, luminance in false colour, the compass
"""
