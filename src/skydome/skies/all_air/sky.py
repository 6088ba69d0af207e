"""The physical sky: one sky for all air, from noon to the end of twilight, as fast as a formula."""

from dataclasses import dataclass, field
from functools import cached_property
from os import PathLike
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arrays import Array, constant, floating, is_numpy, safe_divide
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.all_air.bent_sun import BentSun, centre_illuminance
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.deep_ozone import dimming
from skydome.skies.all_air.fast import Once, in_arrays
from skydome.skies.all_air.lit_air import LitAir
from skydome.skies.all_air.low_aerosol import FoldedLaw, lone, same
from skydome.skies.all_air.many_suns import LOWEST_SUN, light_of_many
from skydome.skies.all_air.polarised.files import load_polarisation, shipped_polarisation
from skydome.skies.all_air.polarised.light import in_blocks, stokes_shares
from skydome.skies.all_air.polarised.network import PolarisedRest, with_polarisation
from skydome.skies.all_air.polarised.stokes_sky import StokesSky
from skydome.skies.all_air.rest import Rest, cosine_of_turn
from skydome.skies.all_air.rest_files import Networks, load_rest, shipped_rest
from skydome.skies.all_air.single_scattering import as_seen, cosines
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.all_air.taught_air import NUMBERS, clear_air, foreign, optics, require_earth, require_taught
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.physical.held import TERMS, HeldSky, mixture, node_cosines, series_of
from skydome.skies.physical.sky_colours import SkyColours, SkySpectrum
from skydome.skies.sky import Sky
from skydome.skies.suns.sun_disc import MEAN_RADIUS
from skydome.sun.day import is_day

WAVELENGTHS = Range(300.0, 2500.0, "nm")
SMOOTH, SMOOTHER = 8, 4
"""Terms in the azimuth that tell the light scattered once, without its phase functions: under a low sun, a high one."""
LOW_SUN = 0.05
"""Sine of the elevation up to which the sun is low."""


@dataclass(frozen=True, eq=False)
class PhysicalSky(StokesSky):
    """The sky of any `atmosphere` for suns from -18 to 90 degrees: light scattered once exactly, the rest by a network.

    One sun or many, one air or many: `sun` (..., 3) and the numbers in `atmosphere` (...,) broadcast with the
    directions, in NumPy, torch or JAX, with gradients. `clear_air` is the air by default. `networks`: those of
    the package, smaller ones (`Networks.SMALL`), or a file of one's own. `valid` tells whether the air was taught, at
    380-780 nm. The air bends sun and view (`air.bending`): `sun` is where it stands. `vector`: polarisation counts in
    all light; a file of one's own for it is `polarisation`. From above the ground: `SkyFromHeight`.
    docs/models/physical.md, docs/models/polarisation.md.

    >>> import skydome as sd
    >>> sky = PhysicalSky(sd.direction(azimuth=180 * sd.deg, elevation=np.array([[45.0], [-4.0]]) * sd.deg))
    >>> sky.radiance(sd.ZENITH, [450.0, 650.0]).shape
    (2, 1, 2)
    """

    atmosphere: Atmosphere = field(default_factory=clear_air)
    networks: str | PathLike[str] | Networks = Networks.FULL
    vector: bool = False
    polarisation: str | PathLike[str] | None = None
    lowest_sun: ClassVar[float] = LOWEST_SUN
    bends_light: ClassVar[bool] = True
    knows_energy: ClassVar[bool] = True
    of_all_hours: ClassVar[bool] = True
    takes_many_airs: ClassVar[bool] = True
    numbers_of_air: ClassVar = NUMBERS
    nodes_of_energy: ClassVar = (16, 32)  # rings and columns of the dome that its energy is summed over
    source: ClassVar[str] = "single scattering by quadrature, higher orders by networks taught in round shells"

    def __post_init__(self) -> None:
        super().__post_init__()
        require_earth(self.atmosphere)
        if self.check == "raise":
            require_taught(optics(self.atmosphere, SpectralSky.bands, self.toward))

    @classmethod
    def from_numbers(cls, **parameters: Any) -> Self:
        """The sky in `clear_air` of the numbers given of it."""
        air = {name: parameters.pop(name) for name in cls.numbers_of_air if name in parameters}
        return cls(**(parameters | ({"atmosphere": clear_air(**air)} if air else {})))

    @cached_property
    def rest(self) -> Rest:
        """The networks of the light scattered more than once."""
        return with_polarisation(self.plain_rest, self.polarised) if self.vector else self.plain_rest

    @cached_property
    def plain_rest(self) -> Rest:
        """Those of light without polarisation."""
        return shipped_rest(self.networks) if isinstance(self.networks, Networks) else load_rest(self.networks)

    @cached_property
    def polarised(self) -> PolarisedRest:
        """The network of polarisation."""
        return shipped_polarisation() if self.polarisation is None else load_polarisation(self.polarisation)

    @cached_property
    def toward(self) -> Array:
        """The sun in the library that the sky computes in: its own, or the air's where the sun is NumPy's."""
        sun = floating(self.sun)
        other = foreign(self.atmosphere) if is_numpy(sun) else None
        return sun if other is None else constant(sun, other)

    @property
    def tables(self) -> ColumnTables:
        """Densities and columns of the air."""
        return ColumnTables.of(self.atmosphere)

    @property
    def seen_sun(self) -> Array:
        """The sun (..., 3) where it is seen, lifted by the air: the middle of its glow."""
        return as_seen(self.tables, self.toward)

    def own_disc(self, angular_radius: Any) -> BentSun | None:
        """The sun's disc through the same air; None in other libraries than NumPy."""
        return BentSun.through(self.atmosphere, self.sun, angular_radius) if is_numpy(self.toward) else None

    @property
    def direct_normal_illuminance(self) -> Array | float:
        """Illuminance of the sun through this air on a plane that faces it, lx, shape (...,); 0 when it has set."""
        disc = self.own_disc(MEAN_RADIUS / self.sun_distance)
        return centre_illuminance(self.atmosphere, self.toward) if disc is None else disc.normal_xyz[..., 1]

    @property
    def is_day(self) -> Array:
        """True where the sky has light of the sun: down to 18 degrees below the horizon, boolean array (...,)."""
        return is_day(self.toward, self.lowest_sun)

    @property
    def valid(self) -> Array:
        """True where the air was taught, at 380-780 nm, and the sun stands above -18 degrees, boolean array (...,)."""
        return optics(self.atmosphere, SpectralSky.bands, self.toward).allowed & self.is_day

    def at(self, wavelengths: np.ndarray) -> LitAir:
        """The air at wavelengths (W,); ValueError in one line where `check` is "raise" and the air was not taught."""
        numbers = optics(self.atmosphere, wavelengths, self.toward)
        if self.check == "raise":
            require_taught(numbers)
        return LitAir.of(self.atmosphere, wavelengths, self.toward, numbers)

    def on_its_nodes(self, nodes: Array, wavelengths: Any) -> Array:
        """Radiance (N, W) toward the nodes (N, 3) of `nodes_of_energy`."""
        return self.radiance(nodes, wavelengths)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon.

        ValueError for wavelengths outside 300-2500 nm, or at which the air was not taught.
        """
        w, views = checked_wavelengths(wavelengths), self.views(directions)
        if w[0] < WAVELENGTHS.low or w[-1] > WAVELENGTHS.high:
            raise ValueError(f"wavelengths must lie in {WAVELENGTHS}, got {w[0]:g} to {w[-1]:g}")
        self.tell_missing_bands(w)
        return self.blanked(self.in_blocks(views, self.at(w), SkySpectrum(w, self.atmosphere.sun_at(w))), views)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3): the air's part of the spectrum follows
        from eleven wavelengths (`spectral_nodes`), the sun's is linear between `bands`.
        """
        views = self.views(directions)
        return self.blanked(self.in_blocks(views, self.at(NODES), self.colours()), views)

    def views(self, directions: Array) -> Array:
        """The directions (..., 3), checked, in the sky's library."""
        return checked_directions(same(floating(directions), self.toward))

    def colours(self) -> SkyColours:
        """From light at `NODES` for a sun of irradiance 1 to CIE XYZ under the true sun."""
        return SkyColours.of(self.atmosphere, bands_from_nodes().T)

    def stokes(self, directions: Array, wavelengths: Any) -> Array:
        """Stokes I, Q, U toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W, 3); 0 below the horizon.

        I is that of polarised light whatever `vector`; ValueError as of `radiance`.
        """
        light, lit = self.radiance(directions, wavelengths), self.at(checked_wavelengths(wavelengths))
        return light[..., None] * in_blocks(self.shares, self.toward, self.views(directions), lit)

    def shares(self, sun: Array, views: Array, lit: LitAir) -> Array:
        """Stokes I, Q and U over `radiance`, (..., W, 3)."""
        rest, seen = self.rest_of(self.plain_rest, sun, views, lit), as_seen(self.tables, sun)
        orders = lit.orders(self.tables, cosines(sun, views), cosines(seen, views)[2], self.laws, in_arrays)
        light = stokes_shares(self.polarised, self.laws, rest + orders.beyond, orders.once, lit, sun, seen, views)
        return safe_divide(light, light[..., :1]) if self.vector else light

    def in_blocks(self, views: Array, lit: LitAir, ending: SkyColours | SkySpectrum) -> Array:
        """Light as `ending` makes it of light at the air's wavelengths: in NumPy some views of some suns at a time."""
        sun = self.toward
        if is_numpy(sun) and all(np.ndim(law.mean_cosine(NODES[:1])) < 2 for law in self.laws):
            return light_of_many(self.light, sun, views, lit, ending)
        return ending.of_light(self.light(sun, views, lit), lit.gases, sun[..., 2], views[..., 2])

    @property
    def held_laws(self) -> list[PhaseLaw]:
        """The constituents', and that of light scattered twice where the low aerosols are not one lobe."""
        return self.laws if lone(self.atmosphere) else [*self.laws, FoldedLaw(self.atmosphere)]

    def light(self, sun: Array, views: Array, lit: LitAir, once: Once = in_arrays) -> Array:
        """Light for a sun of irradiance 1, sr-1, (..., W)."""
        total, glow = self.rest_of(self.rest, sun, views, lit), cosines(as_seen(self.tables, sun), views)[2]
        orders = lit.orders(self.tables, cosines(sun, views), glow, self.laws, once)
        for law, strength in zip(self.laws, orders.once, strict=True):
            total = total + strength * same(law.value(glow, lit.wavelengths), total)
        return total + orders.beyond

    def rest_of(self, rest: Rest, sun: Array, views: Array, lit: LitAir) -> Array:
        """What is scattered more than once, sr-1, (..., W)."""
        turn, height = cosine_of_turn(sun, views), sun[..., 2]
        light = rest.radiance(lit.numbers, height, lambda network: network.at(views[..., 2], turn))
        return light if lit.held is None else light * dimming(self.tables, height, lit.depths, lit.held, lit.shares)

    @cached_property
    def for_maps(self) -> Sky:
        """The colours of one sun and air held in a table; the sky itself where those are many, or not NumPy's."""
        return self.held() if self.is_single and is_numpy(self.toward) else self

    def held(self) -> HeldSky:
        """The colours of one sun held in a table, for maps: ValueError for many suns."""
        sun = np.asarray(self.sun, dtype=np.float64)
        if sun.shape != (3,):
            raise ValueError(f"one sun of shape (3,) can be held at a time, got {sun.shape}")
        lit, height = self.at(NODES).single(), np.float32(sun[2])
        terms = TERMS if lit.low else SMOOTHER if sun[2] > LOW_SUN else SMOOTH
        view, _, between = (part.astype(np.float32) for part in node_cosines(sun, terms))
        turns = np.cos(np.linspace(0, np.pi, TERMS + 1, dtype=np.float32))
        glow = node_cosines(np.asarray(self.seen_sun), terms)[2] if lit.low else between
        orders = lit.orders(self.tables, (view, height, between), glow, self.laws, in_arrays)
        lights = zip(self.held_laws, [*orders.once, orders.twice], strict=False)
        shapes = [mixture(law, NODES)[:, None, None, :] * one for law, one in lights]
        rest = self.rest.radiance(lit.numbers, height, lambda network: network.at_nodes(turns)) + orders.smooth
        colours = self.colours().at_heights(lit.gases, height, view[:, 0]) * np.float32(self.is_day)
        series = [series_of(fields @ colours) for fields in (np.concatenate(shapes), rest[None])]
        return HeldSky(self.seen_sun, self, tuple(self.held_laws), np.concatenate(series, axis=2))
