"""What a field of cloud leaves of the sun's light over land: its shadows, an image that repeats as the field does."""

from typing import NamedTuple

import numpy as np

from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.shadows import sun_share

PLACES = 512
"""Places of the image along the field's period."""
POINTS = 1
"""Points of the sun's disc, whose blur is finer than the image."""


class Shade(NamedTuple):
    """The sun's `share` (N, N) on a level at height `foot`, m, north and east of the camera, `spacing` m apart.

    What stands above that level is shaded as the place that its ray from the sun goes on to.
    """

    share: np.ndarray
    spacing: float
    foot: float


def shade_of(field: CloudField | None, sun: np.ndarray, foot: float) -> Shade:
    """The shadows of a field whose heights are above `foot`, as one who stands there has it; none without a field."""
    if field is None:
        return Shade(np.ones((1, 1)), 1.0, foot)
    spacing = field.kind.period / PLACES
    along = np.arange(PLACES) * spacing
    east, north = np.meshgrid(along, along)
    share = sun_share(field, sun, np.stack([east, north, 0 * east], axis=-1), POINTS)
    return Shade(np.ascontiguousarray(share), float(spacing), foot)
