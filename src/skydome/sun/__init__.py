"""Where the sun stands, and when.

- times              Instants: every way to write a time, as UTC; a time without a zone is refused
- place              A place on the earth
- delta_t            How far the earth's turning lags behind even time: terrestrial minus universal time
- geocentric         The sun as seen from the earth's centre, in axes that turn with the earth
- celestial          From the axes of the stars to those of a place: precession, nutation, turning, aberration
- refraction         The air lifts the sun: refraction by the formula of NREL's Solar Position Algorithm
- position           Where the sun stands over a place: from the earth's centre to the place, and lifted by the air
- day                Day and night: the one place where it is decided which of them it is
- track              The sun over some days for any place, interpolated from one look a day
- day_events         The events of one day as roots of SPA's elevation
- many_days          The events of many days at once, found on the interpolated course, then on SPA's elevation
- events             The events of a day or of many: sunrise, noon, sunset and the three twilights
- path               The sun's path through a day, to be drawn on a sky or read as a table
- preetham_position  Where the sun stands by Preetham 1999, appendix A.6: short, and good to about a degree
"""
