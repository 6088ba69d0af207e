"""Many skies at once toward fixed directions: the hours of a year, or a batch of conditions."""

import numpy as np

from skydome.ground.arguments import numbers, require_kind
from skydome.ground.arrays import Array, as_numpy
from skydome.ground.directions import checked_directions
from skydome.skies.formula.fast import PRICE_OF_DIRECTIONS, checked_out, chosen, formula_light, many_skies
from skydome.skies.formula.formula_sky import FormulaSky, Recipe
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky

VALUES_AT_A_TIME = 1 << 18


def light_series(sky: FormulaSky, recipe: Recipe, directions: Array, out: np.ndarray | None = None) -> np.ndarray:
    """The light of a recipe of T skies toward directions (D, 3), float32 (T, D, K), written into `out` if given."""
    directions = np.asarray(as_numpy(directions))
    if directions.ndim != 2:
        raise ValueError(f"directions must have shape (D, 3), got {directions.shape}")
    light = sky.flat_numbers((as_numpy(recipe[0]), recipe[1]))
    shape = (len(light.states), len(directions), light.size)
    out = np.empty(shape, np.float32) if out is None else checked_out(out, shape)
    plain = out.dtype == np.float32 and out.flags.c_contiguous
    kernel = chosen(PRICE_OF_DIRECTIONS * out.size, light.coefficients) if plain else None
    if kernel is not None:
        many_skies(kernel, light, directions, out)
        return out
    directions = checked_directions(directions)
    step = max(1, VALUES_AT_A_TIME // max(1, len(directions) * light.size))
    for start in range(0, len(out), step):
        part = slice(start, start + step)
        out[part] = formula_light(light.part(part), directions)
    return out


@outer_labels("cd m-2", directions="directions")
def luminance_series(sky: Sky, directions: Array, out: np.ndarray | None = None) -> np.ndarray:
    """Luminance of T skies toward directions (D, 3), cd m-2, float32 (T, D), written into `out` if given.

    The sky's parameters have shape (T,) or (T, 1), with suns (T, 3) or (T, 1, 3). Skies of the nine-number formula take
    compiled kernels where the job is large and Numba is installed, else the formula in pieces of 2 MB; others their own
    `luminance`, which holds the whole result in float64 once more. Error against the float64 formula: 2e-6 of the
    light for suns above 5 degrees. Night is 0, what is not valid NaN (check="nan").

    >>> import skydome as sd
    >>> suns = sd.direction(azimuth=3.0, elevation=np.radians([-5.0, 10.0, 40.0]))
    >>> sky = sd.HosekWilkie(suns[:, None, :], turbidity=3.0)
    >>> luminance_series(sky, [sd.ZENITH, sd.NORTH]).shape
    (3, 2)
    """
    require_kind(sky, Sky, "sky", "Preetham(sun, turbidity=3.0)")
    if not isinstance(sky, FormulaSky):
        light = as_numpy(sky.luminance(numbers(as_numpy(directions), "directions")))
        if out is None:
            return np.asarray(light, dtype=np.float32)
        checked_out(out, light.shape)[...] = light
        return out
    recipe = sky.luminance_recipe()
    if out is not None:
        count = int(np.prod(sky.own_shape(as_numpy(recipe[0]))))
        out = checked_out(out, (count, len(directions)))[..., None]
    return light_series(sky, recipe, directions, out)[..., 0]
