"""The skies: one ladder, one file a model.

- sky                The first rung of the ladder, skies whose luminance is known; sums of skies, such as sky and sun
- colour_sky         The rungs above, skies whose colour is known, and their spectrum
- blend              Skies between clear and overcast
- validity           The parameters of a model: their ranges as data, what to do outside them, how they are told
- labelled           Light with labels (pandas, xarray): where a sky's parameters or the directions have them
- uniform            Skies without a sun: the uniform sky and Moon and Spencer's overcast sky
- cie                The CIE's skies: the fifteen of CIE S 011, the older clear sky, and the intermediate sky
- perez              The Perez sky from five letters
- perez_all_weather  Perez's all-weather sky: from direct and diffuse irradiance to a luminance distribution
- preetham           Preetham, Shirley and Smits's clear sky
- hosek_wilkie       Hosek and Wilkie's clear sky: nine numbers for each band or channel, fitted to a path tracer
- daylight_sky       Colour for skies that know luminance only, given on purpose
- captured           The sky of a photograph: an environment map that answers as every sky does
- catalogue          Every sky model by name, a row each: what the commands, fits, lessons and evaluations read
- model              The kinds of rows in it, and how each makes its sky
- series             Many skies at once toward fixed directions: the hours of a year, or a batch of conditions
- formula/           The nine numbers, the extended Perez formula (Hosek and Wilkie 2012, eq. 8)
- neural/            Neural skies: small networks from sun and view to light (Satilmis et al. 2017)
- all_air/           One sky for all air: light scattered once exactly, the rest by small networks
- physical/          Skies from first principles, and what makes them quick
- path_tracing/      The sky by brute force: paths of light through spherical shells of air
- suns/              The sun's disc, by its published tables or through a given air
"""
