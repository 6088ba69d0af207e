"""Preetham, Shirley and Smits's clear sky (1999): Perez's formula for luminance Y and chromaticities x and y.

deviation from the paper | here | why
one symbol F divides both x and y | x and y each by F(0, ts) of their own letters | the text of section 3.2
no limits given | turbidity 2-6 | those were fitted (section 3.2); below about 2 and for very low suns it goes wild
"""

import json
from dataclasses import asdict, dataclass
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, as_numpy, constant, floating, is_concrete, is_numpy, namespace
from skydome.ground.directions import elevation, zenith_angle
from skydome.ground.files.reading import decoding, json_in
from skydome.ground.limits.ranges import Range
from skydome.ground.writing import appearing
from skydome.light.daylight import daylight_spectrum, daylight_weights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.formula.formula_sky import ColourFormulaSky, Recipe
from skydome.skies.formula.perez_formula import evaluate, from_perez
from skydome.skies.formula.quantity import Quantity

# Rows A B C D E, columns slope in T and constant (Preetham 1999, A.2).
LETTERS_Y = ((0.1787, -1.4630), (-0.3554, 0.4275), (-0.0227, 5.3251), (0.1206, -2.5771), (-0.0670, 0.3703))
LETTERS_x = ((-0.0193, -0.2592), (-0.0665, 0.0008), (-0.0004, 0.2125), (-0.0641, -0.8989), (-0.0033, 0.0452))
LETTERS_y = ((-0.0167, -0.2608), (-0.0950, 0.0092), (-0.0079, 0.2102), (-0.0441, -1.6537), (-0.0109, 0.0529))
# Rows T^2, T, 1; columns ts^3, ts^2, ts, 1 (A.2), as printed, then with the five digits of the authors' own program.
ZENITH_x = ((0.0017, -0.0037, 0.0021, 0.000), (-0.0290, 0.0638, -0.0320, 0.0039), (0.1169, -0.2120, 0.0605, 0.2589))
ZENITH_y = ((0.0028, -0.0061, 0.0032, 0.000), (-0.0421, 0.0897, -0.0415, 0.0052), (0.1535, -0.2676, 0.0667, 0.2669))
AUTHORS_x = (
    (0.00166, -0.00375, 0.00209, 0.0), (-0.02903, 0.06377, -0.03202, 0.00394), (0.11693, -0.21196, 0.06052, 0.25886),
)  # fmt: skip
AUTHORS_y = (
    (0.00275, -0.00610, 0.00317, 0.0), (-0.04214, 0.08970, -0.04153, 0.00516), (0.15346, -0.26756, 0.06670, 0.26688),
)  # fmt: skip

# Slope and constant in T of what multiplies tan chi, and of what is added, kcd m-2 (A.2).
ZENITH_Y = (4.0453, -4.9710, -0.2155, 2.4192)
CHI = (-1 / 120, 4 / 9)  # slope in T and constant of chi over the sun's elevation times 2 (A.2)


SATURATED = float(np.radians(25.0))
"""Elevation of the sun, rad, above which no colour of the sky is beyond the daylight series; found up to 15 degrees."""


@dataclass(frozen=True)
class PreethamNumbers:
    """Every number of the model: letters A to E (5 rows: slope in T, constant) of Y, x and y, and their zenith values.

    `zenith_Y` (4): slope and constant in T of what multiplies tan chi and of what is added, kcd m-2, `chi` (2) those of
    chi; `zenith_x` and `zenith_y`: rows T^2, T, 1, columns cubic in the sun's zenith angle. `turbidity`: least, most.
    `PRINTED` are the paper's, `AUTHORS` those of its authors' program, with five digits in the zenith's chromaticity:
    what other programs compute.

    >>> [round(each.zenith_x[0][0], 5) for each in (PreethamNumbers.PRINTED, PreethamNumbers.AUTHORS)]
    [0.0017, 0.00166]
    """

    PRINTED: ClassVar["PreethamNumbers"]
    AUTHORS: ClassVar["PreethamNumbers"]

    letters_Y: tuple[tuple[float, ...], ...]
    letters_x: tuple[tuple[float, ...], ...]
    letters_y: tuple[tuple[float, ...], ...]
    zenith_Y: tuple[float, ...]
    zenith_x: tuple[tuple[float, ...], ...]
    zenith_y: tuple[tuple[float, ...], ...]
    chi: tuple[float, ...] = CHI
    turbidity: tuple[float, ...] = (2.0, 6.0)

    def __post_init__(self) -> None:
        wanted = ((5, 2), (5, 2), (5, 2), (4,), (3, 4), (3, 4), (2,), (2,))
        for (name, value), shape in zip(vars(self).items(), wanted, strict=True):
            array = np.asarray(value, dtype=np.float64)
            if array.shape != shape or not np.isfinite(array).all():
                raise ValueError(f"{name} must be {shape} finite numbers, got {np.shape(value)}")

    def save(self, path: str | PathLike[str]) -> None:
        """Write to a .json file, whole or not at all."""
        with appearing(path) as beside:
            beside.write_text(json.dumps(asdict(self), indent=1), "utf-8")

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "PreethamNumbers":
        """From a .json file; ValueError for one that holds something else."""
        held = json_in(path, "numbers of Preetham's model")
        with decoding(path, "numbers of Preetham's model"):
            return cls(**held)

    @classmethod
    def named(cls, name: str) -> "PreethamNumbers":
        """Those that a word names, `printed` or `authors`, or that a .json file holds; ValueError for anything else."""
        known = {"printed": cls.PRINTED, "authors": cls.AUTHORS}
        if name not in known and not name.endswith(".json"):
            raise ValueError(f"numbers must be printed, authors or a .json file of `skydome fit`, got {name!r}")
        return known[name] if name in known else cls.load(name)


PreethamNumbers.PRINTED = PreethamNumbers(LETTERS_Y, LETTERS_x, LETTERS_y, ZENITH_Y, ZENITH_x, ZENITH_y)
PreethamNumbers.AUTHORS = PreethamNumbers(LETTERS_Y, LETTERS_x, LETTERS_y, ZENITH_Y, AUTHORS_x, AUTHORS_y)


def zenith_chi(turbidity: Array, sun_zenith: Array, chi: tuple[float, ...] = CHI) -> Array:
    """The angle chi of the zenith's luminance, rad, shape (...,) (A.2)."""
    return (chi[0] * turbidity + chi[1]) * (np.pi - 2 * sun_zenith)


def zenith_luminance(
    turbidity: Array, sun_zenith: Array, numbers: tuple[float, ...] = ZENITH_Y, chi: tuple[float, ...] = CHI
) -> Array:
    """Luminance at the zenith, cd m-2, shape (...,) (A.2, printed in kcd m-2)."""
    xp = namespace(turbidity, sun_zenith)
    a, b, c, d = numbers
    return 1000 * ((a * turbidity + b) * xp.tan(zenith_chi(turbidity, sun_zenith, chi)) + c * turbidity + d)


def zenith_chromaticity(turbidity: Array, sun_zenith: Array, rows: tuple[tuple[float, ...], ...]) -> Array:
    """Chromaticity x or y at the zenith, shape (...,): cubic in the sun's zenith angle, quadratic in turbidity."""
    cubics = [((row[0] * sun_zenith + row[1]) * sun_zenith + row[2]) * sun_zenith + row[3] for row in rows]
    return (cubics[0] * turbidity + cubics[1]) * turbidity + cubics[2]


def letters(turbidity: Array, rows: tuple[tuple[float, ...], ...]) -> list[Array]:
    """The five letters A to E, each of the shape of turbidity (A.2)."""
    return [slope * turbidity + intercept for slope, intercept in rows]


@dataclass(frozen=True, eq=False)
class Preetham(ColourFormulaSky, SpectralSky):
    """The clear sky of Preetham, Shirley and Smits 1999, for turbidity 2-6.

    `numbers` are the paper's as printed (None); with `PreethamNumbers.AUTHORS` it is the sky of other programs (their
    zenith differs by up to 0.0115 in x, 0.0102 in y), with a fit (`skydome.own_air.preetham_fit`) that of another air.

    Known errors: too bright at low turbidity near a low sun, too little darkening toward the horizon, no ground
    albedo (docs/models/preetham.md gives figures). `radiance` is the paper's A.5: the CIE daylight series at the sky's
    chromaticity, 380-780 nm.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> sky = sd.Preetham(sun, turbidity=3.0)
    >>> round(float(sky.luminance(sd.ZENITH)))
    7320
    """

    turbidity: Any
    numbers: PreethamNumbers | None = None
    ranges: ClassVar = {"turbidity": Range(2.0, 6.0)}
    source: ClassVar[str] = "Preetham, Shirley and Smits 1999, A.2"

    @property
    def haze(self) -> Any:
        """The turbidity."""
        return self.turbidity

    @property
    def used(self) -> PreethamNumbers:
        """The model's numbers: those given, or those printed."""
        if self.numbers is None:
            return PreethamNumbers.PRINTED
        require_kind(self.numbers, PreethamNumbers, "numbers", "PreethamNumbers.AUTHORS")
        return self.numbers

    @property
    def limits(self) -> dict[str, Range]:
        """The turbidities that were fitted."""
        return {"turbidity": Range(self.used.turbidity[0], self.used.turbidity[1])}

    def coefficients(self) -> Array:
        """R A ... I of the channels x, y, Y, shape (..., 3, 10)."""
        numbers = self.used
        sun_zenith, turbidity = zenith_angle(self.sun), self.parameter("turbidity")
        xp = namespace(sun_zenith, turbidity)
        below = sun_zenith < np.pi / 2
        sun_zenith = xp.where(below, sun_zenith, xp.full_like(sun_zenith, np.pi / 2))
        zenith = (
            zenith_chromaticity(turbidity, sun_zenith, numbers.zenith_x),
            zenith_chromaticity(turbidity, sun_zenith, numbers.zenith_y),
            zenith_luminance(turbidity, sun_zenith, numbers.zenith_Y, numbers.chi),
        )
        channels = []
        for rows, value in zip((numbers.letters_x, numbers.letters_y, numbers.letters_Y), zenith, strict=True):
            relative = from_perez(constant(1.0, turbidity), *letters(turbidity, rows))
            at_zenith = evaluate(relative, xp.ones_like(sun_zenith), sun_zenith)[..., 0]
            channels.append(from_perez(value / at_zenith, *letters(turbidity, rows)))
        return xp.concat(channels, axis=-2)

    def xyY(self, directions: Array) -> Array:
        """Chromaticities x and y and luminance Y, cd m-2, shape (..., 3); all 0 below the horizon and at night."""
        return self.channels(directions)

    def xyz_recipe(self) -> Recipe:
        """The channels x, y, Y turned into X, Y, Z."""
        return self.coefficients(), Quantity(chromatic=True)

    def luminance_recipe(self) -> Recipe:
        """The one channel Y."""
        return self.coefficients()[..., 2:, :], Quantity()

    def radiance_recipe(self, wavelengths: Any) -> Recipe:
        """The CIE daylight series at the sky's chromaticity, levelled to its luminance."""
        matrix, balance = daylight_weights(wavelengths)
        return self.coefficients(), Quantity(matrix, chromatic=True, balance=balance)

    def radiance(self, directions: Array, wavelengths: Any, out: np.ndarray | None = None) -> Array:
        """Spectral radiance toward each direction at 380-780 nm, W m-2 sr-1 nm-1, shape (..., W) (A.5). See `light`.

        Near a low sun the sky's colours are too saturated for the daylight series: what is negative there is cut at 0,
        luminance kept (`daylight_spectrum`).
        """
        light = self.light(directions, self.radiance_recipe(wavelengths), out)
        if self.series_is_positive:
            return light
        positive = daylight_spectrum(self.xyz(directions), wavelengths)
        if not is_numpy(light):
            return positive
        light[...] = positive
        return light

    @property
    def series_is_positive(self) -> bool:
        """Whether the sun is known to stand too high for colours beyond the daylight series."""
        known = self.used in (PreethamNumbers.PRINTED, PreethamNumbers.AUTHORS) and self.check == "raise"
        return known and is_concrete(self.sun) and bool((as_numpy(elevation(floating(self.sun))) > SATURATED).all())
