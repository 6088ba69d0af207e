"""Light on planes through a year: walls, desks, panels.

- plane          A plane that light falls on: its tilt, where it faces, and what stands around it
- coefficients   What a plane receives per unit of each light of a year
- transposition  Models of diffuse light on tilted planes in the open, beside our own skies
- light          Light on planes through a year, hour by hour: `on_planes("site.epw", Plane(30 * deg))`
- sums           Sums of a year's light by month, and the sky of a period added up
- table          Light on planes as a table for spreadsheets
- portfolio      Many sites by many planes: monthly sums and autonomies, computed by Dask
"""
