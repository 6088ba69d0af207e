"""Measured and photographed skies: reading them, finding sun and sky, and the time between them.

- captures            Captured skies from a folder: HDR maps with their time, sun and sky, in one layout and frame
- stored_layout       What a map's file says about its shape and layout, without reading its pixels
- high_dynamic_range  Whether the picture in an HDR file is one, and not an LDR picture stored as one
- level_probe         Light probes, circular maps of the whole sphere whose middle looks level to the north
- sky_mask            Which texels of a capture show sky
- sky_glow            Where a sky glows: the sun behind cloud, roofs or the horizon
- sun_finding         Where the sun stands in a captured map: its disc where it is seen, else its glow
- scans               Measured skies on a scanner's rings of equal height
- scanned_sky         A sky measured by a scanner, as a sky: bicubic on the sphere, cubic in time
- interpolation       Ways from one measured sky to the next: cross-fades, a cubic through four
- capture_training    A neural sky for one day: the published network trained on captures turned to a common azimuth
- animation           Skies between captures: a day's maps, frame by frame, smooth in time
- frames              The frames of `animation` in files; each step is kept, so that it can be interrupted
"""
