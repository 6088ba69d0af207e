"""Clouds at the command line.

- options        What the commands ask for about fields of cloud
- layer_options  What they ask of a layer over the whole sky, the model `overcast`
- kinds          The kinds of cloud by name
- scene          The sky with clouds that the options ask for
- day            A day of a weather file: its rows with light, and the light between them
- film           A film of a day of a weather file, every frame with its light

`--clouds cumulus` with a cover, or with the light that was measured.
"""
