"""Measured irradiances of sun (direct normal, DNI) and sky (diffuse horizontal, DHI): their limits and the reasons.

what | here | why
above `GREATEST_IRRADIANCE` | refused | outside the air the sun gives 1,414 W m-2 at most; bright clouds add some
below `SENSOR_OFFSET` | refused | no sensor's offset, but a missing value's mark, another unit or a fault
`SENSOR_OFFSET` to 0 | counts as 0 | a radiometer that cools toward the night sky reads a little below 0
direct on the horizontal, low sun | as of `LEAST_ELEVATION` | a small number over a smaller one would tell of no sun

Weather files keep them all (`years/weather`). `PerezAllWeather`, made by hand, refuses what is below 0 too; its
`check="clamp"` holds a value at the limit. gendaymtx's own rules (no limit; night below 1e-4 W m-2) are its own:
`years/gendaymtx/matrix.py`.
"""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.units import deg

GREATEST_IRRADIANCE, SENSOR_OFFSET = 2000.0, -10.0
"""W m-2."""

LEAST_ELEVATION = 1 * deg


def require_irradiances(values: np.ndarray, name: str, where: str = "") -> None:
    """ValueError with the row of the first of the values (T,), W m-2, that cannot be; NaN is missing, and passes.

    >>> require_irradiances(np.array([700.0, -3.0, np.nan]), "direct_normal")
    >>> require_irradiances(np.array([700.0, 9999.0]), "direct_normal")
    Traceback (most recent call last):
    ...
    ValueError: direct_normal must lie in [-10, 2000] W m-2, got 9999 in row 2 of the data
    """
    wrong = np.flatnonzero((values < SENSOR_OFFSET) | (values > GREATEST_IRRADIANCE))
    if wrong.size:
        raise ValueError(
            f"{name} must lie in [{SENSOR_OFFSET:g}, {GREATEST_IRRADIANCE:g}] W m-2, got "
            f"{values[wrong[0]]:g} in row {wrong[0] + 1} of the data{where}"
        )


def without_offsets(values: np.ndarray) -> np.ndarray:
    """The values (T,), with 0 for what a sensor's offset puts below it."""
    held: np.ndarray = np.maximum(values, 0.0)
    return held


def normal_from_horizontal(direct: ArrayLike, sine: ArrayLike) -> np.ndarray:
    """Direct normal irradiance of the direct irradiance on the horizontal, W m-2, by the sine of the sun's elevation.

    >>> normal_from_horizontal(350.0, 0.5).item(), round(normal_from_horizontal(1.0, 0.0).item(), 1)
    (700.0, 57.3)
    """
    found: np.ndarray = direct / np.maximum(sine, np.sin(LEAST_ELEVATION))
    return found
