"""Where the sun stands, and when.

- times              Instants: every way to write a time, as UTC; a time without a zone is refused
- place              A place on the earth
- delta_t            How far the earth's turning lags behind even time: terrestrial minus universal time
- geocentric         The sun as seen from the earth's centre, in axes that turn with the earth
- refraction         The air lifts the sun: refraction by the formula of NREL's Solar Position Algorithm
- position           Where the sun stands over a place: from the earth's centre to the place, and lifted by the air
- day                Day and night: the one place where it is decided which of them it is
- events             The events of a day: sunrise, noon, sunset and the three twilights, as roots of SPA's elevation
- preetham_position  Where the sun stands by Preetham 1999, appendix A.6: short, and good to about a degree
"""
