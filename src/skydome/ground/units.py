"""Units as numbers to multiply with: angles are radians, lengths metres, wavelengths nanometres."""

import math

deg = math.pi / 180.0
"""One degree in radians: `30 * deg`."""

km = 1000.0
"""One kilometre in metres."""

LUMINOUS_EFFICACY = 683.0
"""Lumens per watt at the peak of V(lambda), lm W-1, as the published sky models use it (CIE: 683.002)."""

RADIANCE_EFFICACY = 179.0
"""Lumens per watt of white by which Radiance turns luminance into its radiance, lm W-1 (its src/common/color.h)."""

SOLAR_CONSTANT = 1367.0
"""Irradiance of the sun outside the air at 1 AU, W m-2, as Perez's tables, gendaylit and gendaymtx use it."""

EARTH_RADIUS = 6_371_000.0
"""Mean radius of the earth, m (IUGG: 6371.009 km)."""


def in_degrees(angle: float) -> str:
    """An angle, radians, in degrees for a message; with a hint where degrees were meant, as is likely beyond pi.

    >>> in_degrees(1.6), in_degrees(45)
    ('91.6732', '2578.31 (45 radians; degrees are written 45 * deg)')
    """
    hint = f" ({angle:g} radians; degrees are written {angle:g} * deg)" if abs(angle) > math.pi else ""
    return f"{angle / deg:g}{hint}"
