"""The overcast sky: what comes through an even layer of cloud over the whole sky, as fast as a formula."""

from dataclasses import dataclass, field
from functools import cached_property, reduce
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import USUAL_ALBEDO, Atmosphere
from skydome.air.clouds.cloud import Cloud
from skydome.air.clouds.particles import CloudParticles, Water
from skydome.air.constituents import Molecules, Ozone
from skydome.air.cross_sections import STANDARD_PRESSURE
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import broadcast_shape
from skydome.ground.arrays import Array, at_least, constant, floating, is_numpy, limited, namespace
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import SHARE, Range, require
from skydome.light.spectrum import Spectrum, checked_wavelengths, xyz_weights
from skydome.skies.all_air.blocks import blocks, part_of
from skydome.skies.all_air.low_aerosol import same
from skydome.skies.all_air.rest import cosine_of_turn, mixed
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.clouds.held_overcast import held_overcast
from skydome.skies.clouds.layer_features import features
from skydome.skies.clouds.layer_light import beam, once
from skydome.skies.clouds.layer_optics import TAUGHT, LayerOptics, layer_optics, require_known, require_taught
from skydome.skies.clouds.overcast_files import load_overcast, shipped_overcast
from skydome.skies.clouds.overcast_network import OvercastNetwork
from skydome.skies.clouds.two_streams import light_of
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.physical.cosine_series import LEAST_COSINE
from skydome.skies.physical.sky_colours import SkyColours
from skydome.skies.sky import Sky, SunlitSky
from skydome.skies.validity import applied
from skydome.sun.day import is_day

WAVELENGTHS = Range(320.0, 1800.0, "nm")
FEW = 1 << 13
"""Directions at a time."""


@dataclass(frozen=True, eq=False)
class OvercastSky(SunlitSky, SpectralSky):
    """The sky under an even layer of cloud of `optical_depth` 1-60 at 550 nm, over a ground of `albedo`.

    The cloud as `Cloud` has it: `base`, `thickness` and `effective_radius` in m, `kind` `Water()` or `Ice()`; clear air
    of a surface `pressure`, Pa, and `ozone`, Dobson units, above and below it. Light that the cloud scatters once in
    closed form, the rest by a network (`network`: a file of one's own) that learned discrete ordinates. Sun, depth,
    albedo, pressure and ozone (...,) broadcast with the directions, in NumPy, torch or JAX, with gradients. No haze, no
    bands of water vapour; where the sun shows through a thin cloud its glow within 10 degrees is uncertain
    (docs/clouds.md).

    >>> import skydome as sd
    >>> sky = OvercastSky(sd.direction(azimuth=180 * sd.deg, elevation=40 * sd.deg), optical_depth=25.0)
    >>> low, high = sky.luminance(sd.direction(azimuth=0.0, elevation=[5 * sd.deg, 90 * sd.deg]))
    >>> bool(0.4 < low / high < 0.7)
    True
    """

    optical_depth: Any = 20.0
    albedo: Any = USUAL_ALBEDO
    base: float = 1000.0
    thickness: float = 500.0
    effective_radius: float | None = None
    kind: CloudParticles = field(default_factory=Water)
    pressure: Any = STANDARD_PRESSURE
    ozone: Any = 330.0
    sun_scale: float = 1.0
    network: str | PathLike[str] | None = None
    ranges: ClassVar = {
        "optical_depth": Range(1.0, 60.0),
        "albedo": SHARE,
        "pressure": Range(60_000.0, 105_000.0, "Pa"),
        "ozone": Range(0.0, 500.0, "Dobson units"),
    }
    bounds: ClassVar = {
        "base": Range(0.0, 12_000.0, "m"),
        "thickness": Range(50.0, 4000.0, "m"),
        "effective_radius": Cloud.bounds["effective_radius"],
        "sun_scale": Atmosphere.bounds["sun_scale"],
    }
    kinds: ClassVar = Cloud.kinds
    of_all_hours: ClassVar[bool] = True
    source: ClassVar[str] = "a network taught by discrete ordinates; single scattering by the cloud in closed form"

    def __post_init__(self) -> None:
        super().__post_init__()
        require_known(self.cloud.kind)
        if self.check == "raise":
            require_taught(self.optics(self.bands))

    @cached_property
    def toward(self) -> Array:
        """The sun in the library that the sky computes in: its own, or its parameters' where the sun is NumPy's."""
        sun, ground = floating(self.sun), self.albedo
        given = [self.optical_depth, self.pressure, self.ozone, *([] if isinstance(ground, Spectrum) else [ground])]
        other = next((value for value in given if not is_numpy(value)), None)
        return constant(sun, other) if is_numpy(sun) and other is not None else sun

    @cached_property
    def cloud(self) -> Cloud:
        """The layer."""
        return Cloud(self.held("optical_depth"), self.base, self.thickness, self.effective_radius, self.kind)

    @cached_property
    def atmosphere(self) -> Atmosphere:
        """The air with the layer in it."""
        parts = (Molecules(pressure=self.held("pressure")), Ozone(column=self.held("ozone")), self.cloud)
        ground = self.albedo if isinstance(self.albedo, Spectrum) else self.held("albedo")
        return Atmosphere(parts, ground, sun_scale=self.sun_scale)

    @cached_property
    def taught(self) -> OvercastNetwork:
        """The network of the rest."""
        return shipped_overcast() if self.network is None else load_overcast(self.network)

    @property
    def is_day(self) -> Array:
        """True where the sun stands above the horizon, boolean array (...,)."""
        return is_day(self.toward)

    @property
    def valid(self) -> Array:
        """True where every parameter lies in its range and the sun is up, boolean array of the parameters' shape."""
        return reduce(lambda a, b: a & b, [*self.checks(self.toward), self.is_day])

    def held(self, name: str) -> Array:
        """A parameter inside its range, in the sky's library."""
        return applied(getattr(self, name), self.ranges[name], self.check, like=self.toward)

    def optics(self, wavelengths: np.ndarray) -> LayerOptics:
        """The optical numbers at wavelengths (W,), each (..., W)."""
        molecules, ozone, _ = self.atmosphere.constituents
        ground = self.atmosphere.albedo_at(wavelengths)
        found = layer_optics(molecules, ozone, self.cloud, ground, wavelengths)
        return LayerOptics(*(same(number, self.toward) for number in found))

    def parameters(self) -> dict[str, Any]:
        """With the kind of cloud by its name."""
        return super().parameters() | {"kind": type(self.kind).__name__}

    @property
    def sun_distance(self) -> float:
        """Distance of the sun, AU, that `sun_scale` tells."""
        return float(self.sun_scale**-0.5)

    def held_optics(self, wavelengths: np.ndarray) -> LayerOptics:
        """The same held to what was taught, where `check` allows more."""
        numbers = self.optics(wavelengths)
        if self.check == "raise":
            return numbers
        return LayerOptics(*(limited(v, *TAUGHT[name][:2]) for name, v in numbers._asdict().items()))

    @cached_property
    def for_maps(self) -> Sky:
        """The colours of one sun and layer held in a table; the sky itself where those are many, or not NumPy's."""
        one = is_numpy(self.toward) and self.one_sun and np.shape(self.valid) == ()
        if not (one and bool(self.valid | (self.check != "nan"))):
            return self
        sun = np.asarray(self.toward, dtype=np.float64)
        return held_overcast(self, sun, self.atmosphere, self.held_optics(NODES), self.taught)

    @property
    def direct_normal_illuminance(self) -> Array:
        """Illuminance of the sun through cloud and air on a plane that faces it, lx, (...,); 0 when it has set."""
        w, xp = self.bands, namespace(self.toward)
        numbers, height = self.optics(w), self.toward[..., 2]
        whole = numbers._replace(above=numbers.above + numbers.below)
        light = beam(whole, height, numbers.cloud) * constant(self.atmosphere.sun_at(w), self.toward)
        level = (light @ constant(xyz_weights(w), light))[..., 1]
        return xp.where(self.is_day, level, xp.zeros_like(level))

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon.

        ValueError for wavelengths outside 320-1800 nm.
        """
        w, views = checked_wavelengths(wavelengths), self.views(directions)
        require("wavelengths", w, WAVELENGTHS)
        if wavelengths is not self.bands:
            self.atmosphere.tell_missing_bands(w)
        light = self.in_blocks(views, w)
        return self.blanked(light * constant(self.atmosphere.sun_at(w), light), views)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, (..., 3): by eleven wavelengths, as of clear sky."""
        views = self.views(directions)
        light = self.in_blocks(views, NODES)
        colours = SkyColours.of(self.atmosphere, bands_from_nodes().T)
        return self.blanked(light @ constant(colours.whole, light), views)

    def views(self, directions: Array) -> Array:
        """The directions (..., 3), checked, in the sky's library."""
        views = floating(directions)
        if is_numpy(floating(self.sun)):
            views = same(views, self.toward)
        namespace(views, self.toward)
        return checked_directions(views)

    def in_blocks(self, views: Array, wavelengths: np.ndarray) -> Array:
        """Light for a sun of irradiance 1, sr-1, (..., W): in NumPy some views at a time."""
        sun, numbers = self.toward, self.held_optics(wavelengths)
        if not is_numpy(sun):
            return self.light(sun, views, numbers, wavelengths)
        own = {name: np.shape(number)[:-1] for name, number in numbers._asdict().items()}
        shape = broadcast_shape(directions=views.shape[:-1], sun=sun.shape[:-1], **own)
        light = np.empty((*shape, wavelengths.size), np.result_type(sun, views))
        for block in blocks(shape, FEW):
            some = LayerOptics(*(part_of(number, block) for number in numbers))
            light[block] = self.light(part_of(sun, block), part_of(views, block), some, wavelengths)
        return light

    def light(
        self, sun: Array, views: Array, numbers: LayerOptics, wavelengths: np.ndarray, law: PhaseLaw | None = None
    ) -> Array:
        """Light for a sun of irradiance 1, sr-1, (..., W); the cloud's own phase `law`, or another."""
        xp, view, height = namespace(sun, views), views[..., 2], at_least(sun[..., 2], LEAST_COSINE)
        angle = limited(xp.sum(sun * views, axis=-1), -1.0, 1.0)
        shapes = self.taught.with_glow(self.taught.at(view, cosine_of_turn(sun, views)), angle)
        coefficients = self.taught.coefficients(features(numbers, height), height)
        rest = light_of(mixed(coefficients, shapes), numbers, height)
        phase = (law or self.cloud.phase_law).value(angle, wavelengths)
        return rest + once(numbers, view, height, angle) * phase
