"""Skies with clouds; heights in metres above the ground, extinction in inverse metres.

- overcast        The overcast sky: an even layer of cloud over the whole sky, at formula speed
- layer_optics    The optical numbers that its light depends on, and the ranges that were taught
- two_streams     What two streams of light make of a layer: the network's unit of light
- layer_features  What the network reads
- overcast_network  The network, with a glow about the sun beside its shapes
- layer_light     What the cloud scatters once, in closed form
- held_overcast   Its colours in a table, for maps
- doubling        What an even layer makes of light, all azimuths alike, exactly
- passing         What the layer alone makes of light from any height, for the lights of the night
- overcast_files  Its network in a file
- blend           Skies between clear and overcast
- model           Rows of the catalogue
- fields/         Fields of cloud in three dimensions before the clear sky: cumulus, stratocumulus, altocumulus, cirrus
"""
