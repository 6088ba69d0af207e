"""How skies and maps show themselves to people: in notebooks, and on Matplotlib's axes.

- preview    A map as a photographer would see it: exposed, tone-mapped, encoded for the screen
- page       A table with units and a picture as a notebook shows them; a map on axes
- shown      What every sky can do: a picture, a table with units, a plot
- dome_axes  The sky looking up on axes: the disc, luminance in false colour, the compass
"""
