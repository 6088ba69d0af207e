"""The sky by brute force: backward Monte Carlo in spherical shells, all orders, ground, with its standard error."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from skydome.air.bending import REFRACTIVITY
from skydome.ground.arrays import Array
from skydome.ground.compiled import shared
from skydome.ground.directions import checked_directions
from skydome.ground.extras import required
from skydome.ground.files.contents import digest_of
from skydome.ground.limits.ranges import SEED, Range
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.all_air.taught_air import is_earth, require_earth
from skydome.skies.path_tracing.first_order import bent_once, straight_once
from skydome.skies.path_tracing.guide import guide_for
from skydome.skies.path_tracing.tables import law_tables, shells
from skydome.skies.path_tracing.tracing import Tracing
from skydome.skies.physical.atmosphere_sky import AtmosphereSky

GUIDED_BELOW = 3.0
"""Elevation of the sun, degrees, below which paths are guided: from there on it is worth what it costs."""

ALL_ORDERS = 1000

PATHS_PER_PIECE = 64
"""That are worth a thread's while."""

REFRACTED_BELOW = 5.0
"""Elevation of the sun, degrees, below which the air bends light."""

PATHS = 3
"""Counted up whenever a seed comes to mean other paths, which are not to be mixed in one tracing."""


@dataclass(frozen=True, eq=False)
class TracingJob:
    """What is to be traced: a sky, directions (D, 3) and wavelengths (W,)."""

    sky: "PathTraced"
    directions: np.ndarray
    wavelengths: np.ndarray

    def start(self) -> Tracing:
        """A tracing without any pass."""
        nothing = np.zeros((len(self.directions), self.wavelengths.size))
        return Tracing(self, (), nothing, nothing)

    @property
    def sunlight(self) -> Array:
        """Irradiance above the air less what gases take, W m-2 nm-1, (W,) or (D, W)."""
        return self.sky.sunlight(self.directions, self.wavelengths)

    @cached_property
    def exact(self) -> Any:
        """The light scattered once, by quadrature, where the paths leave it out, sr-1, (D, W); else 0."""
        if not (self.sky.exact_first and self.sky.is_day):
            return 0.0
        air, sun = self.sky.atmosphere, np.asarray(self.sky.sun, dtype=np.float64)
        once = bent_once if self.sky.refractivity > 0 else straight_once
        return once(air, sun, self.directions, self.wavelengths)

    @cached_property
    def tables(self) -> tuple[Any, ...]:
        """The atmosphere, its phase laws and what guides the paths, as the kernel reads them."""
        air, sky = self.sky.atmosphere, self.sky
        geometry = shells(air, self.wavelengths, sky.refractivity)
        return geometry, law_tables(air, self.wavelengths), guide_for(geometry, float(sky.sun[2]), sky.guide_share)

    def one_pass(self, number: int) -> Array:
        """The mean of one pass's paths, sr-1, (D, W)."""
        from skydome.skies.path_tracing.loop_kernel import trace_views

        sky = self.sky
        if not sky.is_day:
            return np.zeros((len(self.directions), self.wavelengths.size))
        sun, views = np.asarray(sky.sun, dtype=np.float64), np.ascontiguousarray(self.directions, dtype=np.float64)
        paths = sky.paths_per_pass * self.wavelengths.size
        choices = sky.orders, sky.roulette, sky.exact_first, sky.seed, number, paths
        light = np.empty((len(views), self.tables[0].albedo.size))
        given = (views, sun, *self.tables, *choices, light)
        shared(trace_views, len(views), len(views) * paths, given, PATHS_PER_PIECE)
        return light[:, : self.wavelengths.size]

    def fingerprint(self) -> str:
        """A hash of everything that the result depends on but the passes."""
        sky = replace(self.sky, sun=np.asarray(self.sky.sun, dtype=np.float64))
        return digest_of(PATHS, sky, self.directions, self.wavelengths)


@dataclass(frozen=True, eq=False)
class PathTraced(AtmosphereSky):
    """The sky of an `atmosphere` by path tracing, to a `relative_error` (the median standard error) of each call.

    `orders` stops paths after so many scatterings; `exact_first` takes the first by quadrature. A share `guide` of the
    flights is guided to where light is scattered (None: 0.8 for suns below 3 degrees, else 0), which changes the noise
    and never the mean. `refraction`: whether the air bends sunlight and the eye's own rays, `sun` being where it stands
    without air (None: for suns below 5 degrees, on the earth). The same `seed` gives the same light whatever the
    threads. Errors: Monte Carlo's, given by `job(...)`; Kocifaj's columns, below 0.3 %. No polarisation. Needs the
    extra `fast` (numba).

    >>> import skydome as sd
    >>> sky = PathTraced(sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg), relative_error=0.02)
    >>> bool(abs(sky.radiance(sd.ZENITH, [450.0, 650.0])[0] / 0.065 - 1) < 0.05)
    True
    """

    relative_error: float = 0.01
    seed: int = 0
    orders: int = ALL_ORDERS
    exact_first: bool = True
    guide: float | None = None
    roulette: float = 0.2
    paths_per_pass: int = 8
    refraction: bool | None = None
    bounds: ClassVar = {
        "relative_error": Range(1e-6, 0.5),
        "seed": SEED,
        "orders": Range(1, ALL_ORDERS),
        "guide": Range(0, 0.95),
        "roulette": Range(0.0, 1.0),
        "paths_per_pass": Range(1, 1 << 20),
    }
    lowest_sun: ClassVar[float] = -12.0
    bends_light: ClassVar[bool] = True
    source: ClassVar[str] = "backward Monte Carlo, next-event estimation, spectral MIS (Wilkie et al. 2014)"
    quick_to_see: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.one_sun:
            raise ValueError(f"a path-traced sky has one sun of shape (3,), got {np.shape(self.sun)}")
        if self.refraction:
            require_earth(self.atmosphere)

    @property
    def refractivity(self) -> float:
        """Refractive index of the air less 1 at the ground; 0 where rays are straight."""
        low = float(self.sun[2]) < np.sin(np.radians(REFRACTED_BELOW)) and is_earth(self.atmosphere)
        return REFRACTIVITY if (low if self.refraction is None else self.refraction) else 0.0

    @property
    def seen_sun(self) -> Array:
        """The sun (3,) where it is seen, lifted by the air."""
        sun = np.asarray(self.sun, dtype=np.float64)
        return as_seen(ColumnTables.of(self.atmosphere), sun) if self.refractivity > 0 else sun

    def own_disc(self, angular_radius: Any) -> BentSun | None:
        """The sun's disc by bent rays; None where they are straight."""
        bent = self.refractivity > 0
        return BentSun.through(self.atmosphere, np.asarray(self.sun), angular_radius) if bent else None

    @property
    def guide_share(self) -> float:
        """Share of the flights that the guide samples."""
        if self.guide is not None:
            return self.guide
        return 0.8 if float(self.sun[2]) < np.sin(np.radians(GUIDED_BELOW)) else 0.0

    def job(self, directions: Array, wavelengths: Any) -> TracingJob:
        """The tracing of directions (D, 3) at wavelengths (W,), to be run, stored and merged by hand."""
        required("numba", "fast", "PathTraced")
        return TracingJob(self, np.asarray(directions, dtype=np.float64), checked_wavelengths(wavelengths))

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        self.tell_missing_bands(wavelengths)
        views = checked_directions(np.asarray(directions, dtype=np.float64))
        flat = views.reshape(-1, 3)
        up = flat[:, 2] >= 0
        light = np.zeros((len(flat), np.size(wavelengths)))
        if up.any():
            light[up] = self.job(flat[up], wavelengths).start().until(self.relative_error).radiance
        return light.reshape(*views.shape[:-1], light.shape[-1])
