"""Skies from first principles, and what makes them quick.

- atmosphere_sky      What the skies of an `Atmosphere` share: the air, its ground, and how bright its sun is
- sky_colours         From the light of a sky to its colours under the true sun, less what gases take
- choice              The default physical sky, discrete ordinates for a high sun
- discrete_ordinates  The physical sky by discrete ordinates, multiple scattering in layers of air
- layers              An atmosphere cut into layers, and the light that is scattered in them once, in closed form
- cosine_series       Light over half a sky as cubics in height and a cosine series in azimuth
- nishita             Nishita's skies: light scattered once or once and twice in spherical shells of air
- klassen             Klassen's sky, light scattered once in flat layers of one density each
- held                A physical sky's colours, computed once on a row of nodes and then known at every direction
- held_tracing        A traced sky held in a table
- held_fields         A held sky's table made fine, for many directions
- held_kernel         The same compiled
- held_rows           A held sky on rows and columns: maps, and the light on the horizontal
- held_rows_kernel    The same compiled
- refitted            A fast sky for an atmosphere of one's own, the nine numbers fitted to a slow sky
- prague/             The Prague sky model, fitted to path tracing, from the files that its authors publish
- precomputed/        Skies from tables of scattered light that all suns, views and heights share
"""
