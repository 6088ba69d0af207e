"""Years of daylight: weather files in, skies of every hour, files out.

- weather/      Weather in: files of every common kind become one record of a place and its hours
- quality/      How good a weather file's light is: what is wrong with it, and its repair
- downscaling/  Hourly weather made into minutes: clouds that come and go within the hour
- skies/        The skies of a year's hours on the dome's patches
- planes/       Light on planes through a year: walls, desks, panels
- metrics/      The numbers that engineers sign: daylight autonomy, EN 17037, glare, doses
- gendaymtx/    A year by the rules of Radiance's gendaymtx, number by number
- heat_map      A year as a heat map: hours of the day against days, for weather and for years of skies
- stores/       A year out: stores and files that appear whole or not at all
"""
