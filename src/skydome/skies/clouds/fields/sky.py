"""A sky of clouds: a field of cloud before the clear physical sky, lit by its sun, its light and the ground."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array, is_numpy
from skydome.ground.directions import checked_directions
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.incident import Incident
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.low_sun import seen_from
from skydome.skies.clouds.fields.shadows import sun_share
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.sky import SunlitSky
from skydome.skies.suns.sun_disc import SunDisc
from skydome.skies.validity import Check
from skydome.skies.wrapped.wrapped_sky import WrappedSky, WrappedSunlitSky

CHUNK = 1 << 16
"""Views at a time."""


@dataclass(frozen=True, eq=False)
class CloudySky(WrappedSky, SpectralSky):
    """The `clear` physical sky of one sun with a `field` of cloud in it: spectrum, colour, luminance.

    Light scattered once by the cloud with its particles' phase function by wavelength (corona, bow, glory), all higher
    orders by discrete ordinates in three dimensions; sunlight, skylight and the ground's light on the cloud by the
    clear sky's air, and that air between cloud and eye. Against paths traced: docs/clouds.md. `sky + SunDisc.of(sky)`
    has the sun as the cloud leaves it. Extinction is grey; the near infrared is absorbed. Needs Numba. ValueError for
    many suns or airs.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)
    >>> sky = CloudySky(sd.PhysicalSky(sun), CloudField(cover=0.0))
    >>> bool(abs(sky.luminance(sd.ZENITH) / sd.PhysicalSky(sun).luminance(sd.ZENITH) - 1) < 1e-3)
    True
    """

    clear: PhysicalSky
    field: CloudField
    kinds: ClassVar = {"clear": (PhysicalSky, "PhysicalSky(sun)"), "field": (CloudField, "CloudField(cover=0.4)")}
    source: ClassVar[str] = (
        "single scattering (TMS) and discrete ordinates in three dimensions through procedural cloud"
    )
    lowest_sun: ClassVar[float] = PhysicalSky.lowest_sun
    knows_energy: ClassVar[bool] = True

    def __post_init__(self) -> None:
        super().__post_init__()
        self.require_bounds()
        if not (self.clear.is_single and is_numpy(self.clear.toward)):
            raise ValueError("a sky of clouds has one sun of shape (3,) and one air, got many")

    @cached_property
    def lit(self) -> LitField:
        """The field under its sun."""
        return LitField.of(self.field, seen_from(self.clear, self.field.middle))

    def without_refusal(self, check: Check) -> Self:
        """The same with another `check`, the clear sky's too; its field is lit as it is, once."""
        held = replace(self, clear=self.clear.without_refusal(check), check=check)
        if self.field.cover > 0:
            vars(held)["lit"] = self.lit
        return held

    @property
    def nodes_of_energy(self) -> tuple[int, int, np.ndarray]:
        """What its energy is summed over: nodes that crowd at the sun, whose glow through a thin cloud is steep."""
        return self.nodes_about(self.clear.seen_sun)

    @staticmethod
    def nodes_about(sun: Array) -> tuple[int, int, np.ndarray]:
        """Of any field under a sun (3,), for `hemisphere`."""
        toward = np.asarray(sun, np.float64)
        return 24, 48, toward if toward[2] >= 0 else toward * [1.0, 1.0, 0.0] / np.hypot(toward[0], toward[1])

    @property
    def sunlit(self) -> "SunBehindClouds":
        """Who tells the sun, dimmed by the cloud before it."""
        return SunBehindClouds(np.asarray(self.clear.seen_sun), self)

    @property
    def wrapped(self) -> PhysicalSky:
        """The clear sky."""
        return self.clear

    @property
    def atmosphere(self) -> Atmosphere:
        """The clear sky's air."""
        return self.clear.atmosphere

    @property
    def toward(self) -> Array:
        """The sun, where it stands."""
        return self.clear.toward

    @cached_property
    def sun_share(self) -> float:
        """Share of the sun's disc's light that the cloud before it lets straight through, 0-1."""
        return float(sun_share(self.field, np.asarray(self.clear.seen_sun), np.zeros((1, 3)))[0])

    def parameters(self) -> dict[str, Any]:
        """Those of the clear sky and of the field."""
        field = {name: getattr(self.field, name) for name in ("cover", "base", "thickness", "extinction", "seed")}
        return self.clear.parameters() | {"clouds": type(self.field.kind).__name__} | field

    @cached_property
    def colours(self) -> Incident:
        """The light on the field in CIE XYZ."""
        return Incident.of_colours(self.clear, self.lit)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        clear = self.clear.for_maps
        return self.in_chunks(directions, self.colours, lambda views: np.asarray(clear.xyz(views)), 3)  # type: ignore[attr-defined]

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        w = checked_wavelengths(wavelengths)
        light = Incident.of_spectrum(self.clear, self.lit, w)
        return self.in_chunks(directions, light, lambda views: np.asarray(self.clear.radiance(views, w)), len(w))

    def on_its_nodes(self, nodes: Array, wavelengths: Any) -> Array:
        """The same toward the nodes (N, 3) of `nodes_of_energy`, the clear sky's second half as the first."""
        if self.field.cover <= 0 or not self.is_day:
            return self.radiance(nodes, wavelengths)
        half = np.asarray(self.clear.radiance(nodes[: len(nodes) // 2], wavelengths))
        lit = Incident.of_spectrum(self.clear, self.lit, wavelengths)
        return lit.behind(np.concatenate([half, half]), np.asarray(nodes, np.float64))

    def in_chunks(self, directions: Array, incident: Incident, clear: Any, width: int) -> Array:
        """The light of views, some at a time; none where the clear sky has none."""
        views = np.asarray(checked_directions(np.asarray(directions, np.float64)))
        flat = views.reshape(-1, 3)
        out = np.zeros((len(flat), width))
        for part in pieces(np.flatnonzero((flat[:, 2] >= 0) & bool(self.is_day))):
            out[part] = incident.behind(clear(flat[part]), flat[part]) if self.field.cover > 0 else clear(flat[part])
        return out.reshape(*views.shape[:-1], width)


def pieces(indices: np.ndarray) -> Iterator[np.ndarray]:
    """Some of the indices at a time."""
    for start in range(0, len(indices), CHUNK):
        yield indices[start : start + CHUNK]


@dataclass(frozen=True, eq=False)
class SunBehindClouds(WrappedSunlitSky):
    """What a sky of clouds tells of its sun."""

    sky: CloudySky
    lowest_sun: ClassVar[float] = PhysicalSky.lowest_sun

    def luminance(self, directions: Array) -> Array:
        """The sky's, cd m-2."""
        return self.sky.luminance(directions)

    @property
    def wrapped(self) -> PhysicalSky:
        """The clear sky."""
        return self.sky.clear

    @property
    def direct_normal_illuminance(self) -> Any:
        """Illuminance of the sun as the cloud leaves it, lx."""
        return self.sky.clear.direct_normal_illuminance * self.sky.sun_share

    def own_disc(self, angular_radius: Any) -> SunlitSky | None:
        """The clear air's disc, dimmed."""
        disc = self.sky.clear.own_disc(angular_radius)
        return None if disc is None else dimmed(disc, self.sky.sun_share)


def dimmed(disc: SunDisc, share: float) -> SunDisc:
    """A disc with a share of its light."""
    return replace(disc, direct_normal_illuminance=disc.normal_xyz[..., 1] * share)
