"""Weather in: files of every common kind become one record of a place and its hours.

- weather          Weather, a place, intervals of time and the irradiances measured in them
- frame            What a DataFrame with a timezone-aware index says of the weather
- splitting        Direct and diffuse irradiance found from the global one
- reading          Weather from a file, whichever of the common kinds it is: told by what it says
- text             The text of weather files as other programs write them, lines, cells, columns of numbers
- rows             What the rows of a file say, made into Weather: checked by line and column, split where global
- epw              EnergyPlus weather files: rows are labelled by the end of their interval, in standard time
- wea              Radiance's weather tapes, times at the middle of the interval
- tape             The text of Radiance's weather tapes, a header of six lines, then month, day, hour, direct
- tmy              Typical years of hours that are labelled by their end: TMY3 and TM2
- site_csv         Tables with titled columns: those of NSRDB and SAM, and bare ones
- pvgis            Files of PVGIS, a typical year, or a series of years on the horizontal
- calendar         Rows of weather on the calendar, years, local times, intervals, missing rows
- sun_of_interval  Intervals of time at a place, and where the sun stands for each
- plausibility     Does the sun of a place fit the irradiances given for it? A wrong sign shows at dawn and dusk
- closure          Do a file's solar columns fit the sun of its stamps? Their closure and their noon tell
"""
