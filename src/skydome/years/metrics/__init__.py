"""The numbers that engineers sign: how much of a year has daylight enough, too much, glare, and what it does.

- occupancy          Which hours count: working hours, hours of daylight
- coefficients       Daylight coefficients of points, from Radiance's matrices or our own scenes
- autonomy           Daylight autonomy, useful illuminance, spatial daylight autonomy, annual sunlight exposure
- en_17037           Daylight provision, sunlight and glare by EN 17037
- glare              Daylight glare probability through a year, from the light at the eye and from the sun in view
- doses              What daylight does on planes: melanopic illuminance, photosynthetic photons, daily light integral
- spectral_mismatch  What a photovoltaic cell makes of daylight's spectrum, against the reference one
- signed             The metrics of a room together, from light through a year: what is written into a report
"""
