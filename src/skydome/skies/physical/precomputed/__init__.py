"""Skies from tables of scattered light: worked out once for an atmosphere, then looked up.

- grid           The grid of the tables: Bruneton's maps between heights, views, suns and places in a table
- medium         An atmosphere as the kernels read it
- lookup_kernel  Places in the tables and what stands there, compiled
- convolution    From light that arrives from all sides to what the air gives off
- orders_kernel  The orders of scattering over the tables, compiled
- orders         The orders of scattering one after the other
- tables         The tables, shared by all skies of an atmosphere
- observer       Where an observer's views go through the air: from the ground, from within it, or from space
- along          Light along those views: scattered once, and thrown back by the ground
- tabled_sky     What skies by such tables share: views from any height, spectra and colours
- sky            The sky by the tables
- hillaire       Hillaire's sky, a small table for all that is scattered more than once
- textures       The tables as textures that other programs read, and files of them
- models         Rows of the catalogue for them
"""
