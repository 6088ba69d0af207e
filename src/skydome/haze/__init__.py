"""The colour of distance: what the air between takes from far objects, and adds to them.

- aerial_perspective  The colour of distance: what air takes from the light of a far object, and what light it adds
- ground_air          The air at the ground, of a turbidity or of an atmosphere: how it thins out, takes and scatters
- light               The light that gas and haze at the ground scatter toward a viewer
- horizon_light       The light of the sky's own horizon as the limit of haze
- integrals           The integrals of aerial perspective, extinction along a ray
- channels            The channels in which aerial perspective is computed: wavelengths, or red, green and blue
- fast                The tables that the Numba kernel of aerial perspective reads
- kernel              Aerial perspective of RGB images in float32, the second form of `FewNodes(8)`
- published           The published closed form of aerial perspective, and quadrature to judge it by
- uniform_density     Air of one density, Hoffman and Preetham's closed form of games
- layered_fog         Fog in level layers, each of one density, Max's closed form
- ward_larson         Ward-Larson's fog, the older form of aerial perspective, as Preetham 1999
"""
