"""Pictures of numbers: domes and years.

- skies  Figures of skies: luminance in false colour, looking up
- weather  A picture of a weather record's light: what is wrong, its closure, clearness, turbidity
- years  Figures of a year of skies: hours by days, and the mean dome of each month
"""
