"""Preetham's model fitted to a family of skies: five letters linear in turbidity, and values at the zenith.

For Y, x and y alike: the letters A to E, each a slope and a constant, are searched for (Levenberg-Marquardt) while the
level of every sky follows (variable projection); the levels then give the zenith values, linear in A.2's numbers but
for those of chi.
"""

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.light.spectrum import xyz_weights
from skydome.own_air.family import SkyFamily
from skydome.skies.formula.perez_formula import evaluate, from_perez, view_geometry
from skydome.skies.formula.sky_tables import held_weights
from skydome.skies.preetham import PreethamNumbers, letters, zenith_chi

Numbers = tuple[float, ...]
STARTS = {
    "Y": ((-1.0, -0.3, 10.0, -3.0, 0.45), (-1.0, -0.6, 4.0, -2.5, 0.2)),
    "x": ((-0.2, -0.2, 0.2, -1.0, 0.0), (-0.2, -0.2, -0.1, -1.0, 0.0)),
    "y": ((-0.2, -0.2, 0.2, -1.0, 0.0), (-0.2, -0.2, -0.1, -1.0, 0.0)),
}
"""Letters in the middle of the turbidities, the same at all of them, to start from."""
LOW, HIGH = (-10.0, -10.0, -100.0, -30.0, -10.0), (10.0, -1e-3, 100.0, -1e-2, 10.0)


def preetham_fit(family: SkyFamily, albedo: float = 0.0) -> PreethamNumbers:
    """Preetham's numbers fitted to a family of skies over ground of an albedo, for `Preetham(sun, turbidity, numbers)`.

    Differences are relative, weighted by solid angle, alike for all skies. ValueError for fewer than three turbidities
    or four suns, for a spectrum without all of 400-700 nm, and for light that is not positive.
    """
    required("scipy", "fit", "the fit of Preetham's numbers")
    t, e, w = family.turbidities, family.elevations, family.wavelengths
    if t.size < 3 or e.size < 4 or w[0] > 400 or w[-1] < 700:
        raise ValueError(f"three turbidities, four suns and 400-700 nm are needed, got {t.size} turbidities, {e.size} "
                         f"suns and {w[0]:g}-{w[-1]:g} nm")  # fmt: skip
    share = held_weights(family.albedos, np.asarray(albedo, dtype=np.float64))
    xyz = np.einsum("a,taedw->tedw", share, family.radiance) @ xyz_weights(w)
    if not (xyz > 0).all():
        raise ValueError(f"the skies' X, Y and Z must be positive, got a least of {xyz.min():g}")
    chroma = xyz[..., :2] / xyz.sum(axis=-1, keepdims=True)
    found = {
        name: Channel.of(family, light).fitted(STARTS[name])
        for name, light in (("Y", xyz[..., 1]), ("x", chroma[..., 0]), ("y", chroma[..., 1]))
    }
    sun_zenith, turbidity = np.pi / 2 - e, t[:, None]
    chi, numbers = luminance_numbers(turbidity, sun_zenith, found["Y"][1])
    return PreethamNumbers(
        letters_Y=rows(found["Y"][0]),
        letters_x=rows(found["x"][0]),
        letters_y=rows(found["y"][0]),
        zenith_Y=numbers,
        zenith_x=chromaticity_numbers(turbidity, sun_zenith, found["x"][1]),
        zenith_y=chromaticity_numbers(turbidity, sun_zenith, found["y"][1]),
        chi=chi,
        turbidity=(float(t[0]), float(t[-1])),
    )


@dataclass(frozen=True, eq=False)
class Channel:
    """One of Y, x, y: values (T, E, D) and their geometry (E, D)."""

    turbidities: np.ndarray
    values: np.ndarray
    cosine: np.ndarray
    angle: np.ndarray
    sun_zenith: np.ndarray
    share: np.ndarray

    @classmethod
    def of(cls, family: SkyFamily, values: np.ndarray) -> "Channel":
        """The channel of a family."""
        geometry = [view_geometry(family.views.directions, direction(np.pi, h)) for h in family.elevations]
        cosine, angle = (np.stack([part[k] for part in geometry]) for k in range(2))
        share = np.sqrt(family.views.solid_angles / family.views.solid_angles.sum())
        return cls(family.turbidities, values, cosine, angle, np.pi / 2 - family.elevations, share)

    def fitted(self, starts: tuple[tuple[float, ...], ...]) -> tuple[Array, Array]:
        """Slope in T and constant of each letter, (5, 2), and the values at the zenith, (T, E)."""
        from scipy.optimize import least_squares

        low, high = (np.concatenate([limit, limit]) for limit in (LOW, HIGH))
        found = [
            least_squares(lambda x: self.differences(x)[0], np.tile(start, 2), bounds=(low, high), x_scale=np.tile(
                np.abs(start) + 0.1, 2), max_nfev=200) for start in starts
        ]  # fmt: skip
        best = min(found, key=lambda answer: float(answer.cost)).x
        at_zenith = self.relative(best, np.ones((self.sun_zenith.size, 1)), self.sun_zenith[:, None])[..., 0]
        low_end, high_end = best.reshape(2, 5)
        slope = (high_end - low_end) / (self.turbidities[-1] - self.turbidities[0])
        return np.stack([slope, low_end - slope * self.turbidities[0]], axis=-1), self.differences(best)[1] * at_zenith

    def differences(self, x: np.ndarray) -> tuple[Array, Array]:
        """Weighted relative differences, flat, and the levels (T, E) that make them least; x: letters at both ends."""
        ratio = self.relative(x, self.cosine, self.angle) / self.values * self.share
        level = (ratio @ self.share) / np.maximum((ratio**2).sum(axis=-1), 1e-30)
        return (level[..., None] * ratio - self.share).ravel(), level

    def relative(self, x: np.ndarray, cosine: np.ndarray, angle: np.ndarray) -> Array:
        """Perez's formula of letters that go linearly from the lowest turbidity's to the highest's, (T, E, D)."""
        part = (self.turbidities - self.turbidities[0]) / (self.turbidities[-1] - self.turbidities[0])
        first, last = x.reshape(2, 5)
        own = letters(part[:, None, None], tuple(zip(last - first, first, strict=True)))
        return evaluate(from_perez(np.array(1.0), *own), cosine, angle)[..., 0]


def luminance_numbers(turbidity: Array, sun_zenith: Array, zenith: Array) -> tuple[Numbers, Numbers]:
    """The two numbers of chi, searched for, and the four of the zenith's luminance (T, E), cd m-2."""
    from scipy.optimize import least_squares

    last = float(turbidity.max())

    def parts(x: np.ndarray) -> list[Any]:
        tangent = np.tan(zenith_chi(turbidity, sun_zenith, chi_of(x)))
        return [turbidity * tangent, tangent, turbidity + 0 * tangent, np.ones_like(tangent)]

    def chi_of(x: np.ndarray) -> tuple[float, float]:
        """From chi at turbidity 0 and at the last, over twice the sun's elevation."""
        return float(x[1] - x[0]) / last, float(x[0])

    def differences(x: np.ndarray) -> Array:
        made = sum(factor * part for factor, part in zip(solved(parts(x), zenith), parts(x), strict=True))
        return (made / zenith - 1).ravel()

    tried = [least_squares(differences, (a, b), bounds=(0.05, 0.4999)) for a, b in product((0.3, 0.45, 0.49), repeat=2)]
    best = min(tried, key=lambda answer: float(answer.cost)).x
    return chi_of(best), tuple(float(number) for number in solved(parts(best), zenith) / 1000)


def chromaticity_numbers(turbidity: Array, sun_zenith: Array, zenith: Array) -> tuple[Numbers, ...]:
    """The 3 x 4 numbers of the zenith's chromaticity (T, E), by relative least squares."""
    powers = product((2, 1, 0), (3, 2, 1, 0))
    return rows(solved([turbidity**p * sun_zenith**q for p, q in powers], zenith).reshape(3, 4))


def solved(parts: list[Any], values: np.ndarray) -> Array:
    """Factors of parts (each (T, E)) whose sum is relatively nearest to values (T, E)."""
    matrix = np.stack([(part / values).ravel() for part in parts], axis=-1)
    answer: np.ndarray = np.linalg.lstsq(matrix, np.ones(values.size), rcond=None)[0]
    return answer


def rows(table: np.ndarray) -> tuple[Numbers, ...]:
    """A table as nested tuples."""
    return tuple(tuple(float(value) for value in row) for row in table)
