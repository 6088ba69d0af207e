"""The colours of one overcast sky held in a table, for maps."""

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.skies.all_air.rest import RestNetwork, mixed
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.clouds.layer_light import once
from skydome.skies.clouds.layer_optics import LayerOptics
from skydome.skies.clouds.two_streams import features, light_of
from skydome.skies.physical.held import TERMS, HeldSky, mixture, node_cosines, series_of
from skydome.skies.physical.sky_colours import SkyColours
from skydome.skies.sky import SunlitSky


def held_overcast(
    sky: SunlitSky, sun: np.ndarray, air: Atmosphere, numbers: LayerOptics, network: RestNetwork
) -> HeldSky:
    """The table of one `sun` (3,) and of `air` whose last constituent is the cloud, its `numbers` at `NODES`: what the
    cloud scatters once apart, as that knows no azimuth.
    """
    cloud, laws = air.constituents[-1], tuple(part.phase_law for part in air.constituents)
    height, view = np.maximum(sun[2], 0.0), node_cosines(sun)[0][:, 0]
    shapes = network.at_nodes(np.cos(np.linspace(0, np.pi, TERMS + 1)))
    coefficients = network.coefficients(features(numbers, height), height)
    rest = light_of(mixed(coefficients, shapes.reshape(-1, shapes.shape[-1])), numbers, height)
    rest = rest.reshape(*shapes.shape[:2], -1)
    alike = np.repeat(once(numbers, cloud.profile.mean_height, view, height)[:, None], 2, axis=1)
    none = np.zeros((1, *alike.shape))  # molecules' and ozone's are in the rest
    single = np.concatenate([none, none, mixture(cloud.phase_law, NODES)[:, None, None] * alike])
    colours = SkyColours.of(air, bands_from_nodes().T).whole * float(sky.is_day)
    series = [series_of(fields @ colours) for fields in (single, rest[None])]
    return HeldSky(sun, sky, laws, np.concatenate(series, axis=2))
