"""The colours of one overcast sky held in a table, for maps."""

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.skies.all_air.rest import mixed
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.clouds.layer_features import features
from skydome.skies.clouds.layer_light import once
from skydome.skies.clouds.layer_optics import LayerOptics
from skydome.skies.clouds.overcast_network import OvercastNetwork
from skydome.skies.clouds.two_streams import light_of
from skydome.skies.physical.cosine_series import LEAST_COSINE
from skydome.skies.physical.held import HeldSky, mixture, node_cosines, series_of
from skydome.skies.physical.sky_colours import SkyColours
from skydome.skies.sky import SunlitSky


def held_overcast(
    sky: SunlitSky, sun: np.ndarray, air: Atmosphere, numbers: LayerOptics, network: OvercastNetwork
) -> HeldSky:
    """The table of one `sun` (3,) and of `air` whose last constituent is the cloud, its `numbers` at `NODES`: what the
    cloud scatters once apart.
    """
    cloud, laws = air.constituents[-1], tuple(part.phase_law for part in air.constituents)
    height, (view, turn, angle) = np.maximum(sun[2], LEAST_COSINE), node_cosines(sun)
    shapes = network.with_glow(network.at_nodes(turn), angle)
    coefficients = network.coefficients(features(numbers, height), height)
    rest = light_of(mixed(coefficients, shapes.reshape(-1, shapes.shape[-1])), numbers, height)
    rest = rest.reshape(*shapes.shape[:2], -1)
    single = once(numbers, view, height, angle)
    none = np.zeros((1, *single.shape))  # molecules' and ozone's are in the rest
    fields = np.concatenate([none, none, mixture(cloud.phase_law, NODES)[:, None, None] * single, rest[None]])
    colours = SkyColours.of(air, bands_from_nodes().T).whole * float(sky.is_day)
    return HeldSky(sun, sky, laws, series_of(fields @ colours))
