"""Clouds in a coloured year: how much of an hour's light they send.

As in Radiance's genssky and gensdaymtx (2024), light is the average of a clear sky's and an overcast one's, weighted by
cloud cover; where these give overcast light 6415 K, it comes here through a layer of cloud (`overcast_light`). Where
these programs read the cover from the weather file, it is here one minus the share of the clear sky's direct light that
arrives: the sunshine fraction as Suehrcke (2000, Solar Energy 68, 417) takes it. So it is known wherever the
irradiances are. The average is of spectra of one luminance: Perez's luminance of each direction is kept.
"""

import numpy as np
from numpy.typing import ArrayLike

from skydome.skies.suns.preetham_sun import PreethamSun


def cloud_share(suns: np.ndarray, turbidity: ArrayLike, direct_illuminance: np.ndarray) -> np.ndarray:
    """Share of cloud, 0-1, (K,): 1 where nothing of the sun arrives, 0 where as much as through clear air or more.

    `suns` (K, 3) unit vectors, `turbidity` of the clear air, `direct_illuminance` (K,), lx, on a plane that faces the
    sun. The clear one is Preetham's (1999, A.1).

    >>> sun = np.array([[0.0, -0.5, 0.75**0.5]])
    >>> [round(float(cloud_share(sun, 3.0, np.array([light]))[0]), 2) for light in (0.0, 40e3, 100e3)]
    [1.0, 0.54, 0.0]
    """
    clear = np.asarray(PreethamSun(suns, turbidity, check="clamp").normal_xyz)[..., 1]
    share: np.ndarray = 1 - np.clip(direct_illuminance / np.maximum(clear, 1.0), 0.0, 1.0)
    return share
