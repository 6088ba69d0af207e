"""Weather in: files of every common kind become one record of a place and its hours.

- weather          Weather, a place, intervals of time and the irradiances measured in them
- reading          Weather from a file, whichever of the common kinds it is
- epw              EnergyPlus weather files: rows are labelled by the end of their interval, in standard time
- wea              Radiance's weather tapes, times at the middle of the interval
- tape             The text of Radiance's weather tapes, a header of six lines, then month, day, hour, direct
- tmy              Typical years by pvlib's readers, and weather in any DataFrame
- calendar         Rows of weather on the calendar, the year they are laid in, their local times
- sun_of_interval  Where the sun stands for an interval of weather
- plausibility     Does the sun of a place fit the irradiances given for it? A wrong sign shows at dawn and dusk
"""
