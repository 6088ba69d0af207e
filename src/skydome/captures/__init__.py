"""Measured and photographed skies: reading them, finding sun and sky, and the time between them.

- capture             One captured sky: its map, its sun, and where it shows sky
- captures            Captured skies from a folder: HDR maps in one layout and frame, in the order of time
- stored_layout       What a map's file says about its shape and layout, without reading its pixels
- high_dynamic_range  Whether the picture in an HDR file is one, and not an LDR picture stored as one
- sky_mask            Which texels of a capture show sky
- sky_glow            Where a sky glows: the sun behind cloud, roofs or the horizon
- sun_finding         Where the sun stands in a captured map: its disc where it is seen, else its glow
- scans               Measured skies on a scanner's rings of equal height
- luminance_scans     Scans of a sky scanner that measures luminance alone, from a CSV file
- scanned_sky         A sky measured by a scanner, as a sky: bicubic on the sphere, cubic in time
- interpolation       Ways from one measured sky to the next: cross-fades, a cubic through four
- capture_training    A neural sky for one day: the published network trained on captures turned to a common azimuth
- capture_validation  How wrong a day's network is at a capture that it has not seen: k-fold, by whole captures
- animation           Skies between captures: a day's maps, frame by frame, smooth in time
- frames              The frames of `animation` in files; each step is kept, so that it can be interrupted
"""
