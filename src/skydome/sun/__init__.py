"""Where the sun stands, and when.

- times              Instants: every way to write a time, as UTC; a time without a zone is refused
- place              A place on the earth
- spa                NREL's Solar Position Algorithm as pvlib carries it, without the rest of pvlib
- position           Where the sun stands: NREL's Solar Position Algorithm, as pvlib carries it
- events             The events of a day: sunrise, noon, sunset and the three twilights, as roots of SPA's elevation
- preetham_position  Where the sun stands by Preetham 1999, appendix A.6: short, and good to about a degree
"""
