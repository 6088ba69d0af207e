"""Lights smaller than the texels of a map, or than its patches: their energy and their place kept.

- texels         Light that is added to single texels of a map
- sun_on_map     The sun's disc, or the moon's, on the texels of a map
- points_on_map  Points of light, such as stars, on the texels of a map
"""
