"""Hourly weather made into minutes by a published method: seeded, with the energy of every hour kept.

- skartveit_olseth  How far and how fast the clear-sky index swings within an hour
- series            One series of minutes for each hour: drawn, put in order, joined to the hour before
- parts             Minutes of global light split into direct and diffuse light, the hour's own sums kept
- downscaled        The weather of an hourly record in steps of some minutes
- smooth           Light between the rows: smooth from row to row, the mean of each kept
"""
