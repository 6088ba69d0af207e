"""A physical sky's colours, computed once on a row of nodes and then known at every direction: for maps.

What is sharp is the phase functions: the light scattered once is kept as one smooth factor for each constituent, and
its phase function is put in at every direction. The rest, of higher orders, is smooth.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from skydome.air.phase_laws import PhaseLaw
from skydome.air.rays import ColumnTable, rays
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.ground.compiled import has_numba
from skydome.ground.directions import checked_directions, direction, zenith_angle
from skydome.ground.interpolation import weights
from skydome.light.colour import SRGB, RGBSpace
from skydome.skies.colour_sky import ColourSky, SpectralSky
from skydome.skies.physical.atmosphere_sky import AtmosphereSky
from skydome.skies.physical.cosine_series import cosine_transform, geometry, interpolated, view_nodes
from skydome.skies.physical.held_fields import LEAST_DIRECTIONS, MANY, HeldFields
from skydome.skies.physical.held_rows import HeldRows
from skydome.skies.physical.nishita import lit_columns
from skydome.skies.physical.sky_colours import SkyColours
from skydome.skies.sky import SunlitSky
from skydome.skies.wrapped.wrapped_sky import WrappedSunlitSky

TERMS = 24
CHUNK = 8192
PIVOTS = np.arange(360.0, 841.0, 60.0)
"""Wavelengths whose phase functions make up those of all others, where they change with wavelength, nm."""


@dataclass(frozen=True, eq=False)
class HeldSky(WrappedSunlitSky, ColourSky):
    """The colours of a physical sky (`held` makes it), as a table: a million directions in seconds.

    Errors against the sky itself: below 0.3 % for suns over 5 degrees; lower, 3 % of the brightest (both tested),
    besides its own noise where it is path traced.
    """

    sky: SunlitSky
    laws: tuple[PhaseLaw, ...]
    """Phase laws of what the light scattered once is kept of."""
    series: np.ndarray
    """Coefficients of cos(m x relative azimuth): (nodes, terms, shapes + 1, 3), the last of higher orders.

    A shape is a phase function: one for each constituent, or `PIVOTS` for one whose changes with wavelength.
    """
    source: ClassVar[str] = "Nakajima and Tanaka 1988: single scattering apart"

    @property
    def wrapped(self) -> SunlitSky:
        """The sky that is held."""
        return self.sky

    def parameters(self) -> dict[str, Any]:
        """Those of the sky that is held."""
        return self.sky.parameters()

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        directions = checked_directions(np.asarray(directions, dtype=np.float64))
        views = directions.reshape(-1, 3)
        light = np.zeros((len(views), 3))
        up = np.flatnonzero(views[:, 2] >= 0)
        toward = self.fields.light if len(up) >= MANY else self.seen
        for start in range(0, len(up), CHUNK):
            part = up[start : start + CHUNK]
            light[part] = toward(views[part])
        return light.reshape(directions.shape)

    def rgb(self, directions: Array, space: RGBSpace = SRGB) -> Array:
        """Linear RGB toward each direction (..., 3), shape (..., 3): of many directions compiled, in float32."""
        if np.size(directions) < 3 * LEAST_DIRECTIONS or not has_numba():
            return super().rgb(directions, space)
        views = np.ascontiguousarray(directions, np.float32).reshape(-1, 3)
        return self.fields.light_in_single(views, np.asarray(space.from_xyz)).reshape(np.shape(directions))

    @cached_property
    def fields(self) -> HeldFields:
        """The table made fine, for many directions."""
        return HeldFields.of(np.asarray(self.sun, np.float64), self.series, lambda c: shapes_of(self.laws, c))

    @cached_property
    def rows(self) -> HeldRows:
        """The table for rows and columns."""
        return HeldRows.of(float(zenith_angle(self.sun)), self.series, self.laws, [pivots(law) for law in self.laws])

    @cached_property
    def on_level(self) -> np.ndarray:
        """XYZ of the light on the horizontal, Y in lx, (3,)."""
        return self.rows.on_level()

    def seen(self, views: np.ndarray) -> Array:
        """CIE XYZ toward views (D, 3) above the horizon, (D, 3)."""
        cosine, relative, angle = geometry(views, np.asarray(self.sun))
        fields = interpolated(self.series, cosine, relative)
        phases = shapes_of(self.laws, angle)
        light: np.ndarray = fields[:, -1] + np.einsum("kd,dkc->dc", phases, fields[:, :-1])
        return np.maximum(light, 0.0)


def node_directions(sun: np.ndarray) -> np.ndarray:
    """Directions (nodes x azimuths, 3) whose light `held` asks for: half the sky, which is symmetric about the sun."""
    cosines, azimuths = view_nodes(TERMS), np.linspace(0, np.pi, TERMS + 1)
    mu, relative = (v.ravel() for v in np.meshgrid(cosines, azimuths, indexing="ij"))
    return np.asarray(direction(np.arctan2(sun[0], sun[1]) + relative, np.arcsin(mu)))


def node_cosines(sun: np.ndarray, terms: int = TERMS) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cosines of the nodes' views to the vertical (nodes, 1), of terms + 1 even azimuths from the sun (azimuths,), and
    of the angle to the sun (nodes, azimuths).
    """
    view, turn = np.asarray(view_nodes(TERMS))[:, None], np.cos(np.linspace(0, np.pi, terms + 1))
    level = np.sqrt(np.maximum((1 - view * view) * (1 - sun[2] * sun[2]), 0.0))
    return view, turn, view * sun[2] + level * turn


def held(sky: AtmosphereSky, bands: np.ndarray | None = None, light: np.ndarray | None = None) -> HeldSky:
    """The colours of a physical `sky` (one sun) held in a table.

    `light` (nodes, W) may give the radiance at `node_directions` and `bands` (W,) where it is known already, as from
    a tracing. ValueError for many suns.

    >>> import skydome as sd
    >>> sky = sd.Nishita93(sd.direction(azimuth=0.0, elevation=0.8))
    >>> bool(abs(held(sky).luminance(sd.ZENITH) / sky.luminance(sd.ZENITH) - 1) < 0.002)
    True
    """
    require_kind(sky, AtmosphereSky, "sky", "DiscreteOrdinates(sun, Atmosphere.standard())")
    air, sun = sky.atmosphere, np.asarray(sky.sun, dtype=np.float64)
    if sun.shape != (3,):
        raise ValueError(f"one sun of shape (3,) can be held at a time, got {sun.shape}")
    w, views = SpectralSky.bands if bands is None else bands, node_directions(sun)
    whole = (sky.radiance(views, w) if light is None else light) / sky.sunlight(views, w)
    seen = np.asarray(sky.seen_sun, dtype=np.float64)
    shapes = shapes_of(sky.held_laws, views @ seen)
    once = strengths(sky, views, seen, w) * bool(sky.is_day)
    once = np.concatenate([once, np.zeros((len(shapes) - len(once), *once.shape[1:]))])
    rest = whole - np.einsum("kd,kdw->dw", shapes, once)
    colours = SkyColours.of(air, weights(w, np.clip(SpectralSky.bands, w[0], w[-1])).T)
    fields = colours.of_light(np.concatenate([once, rest[None]]), air.gases, sun[2], views[:, 2])
    return HeldSky(seen, sky, tuple(sky.held_laws), series_of(fields.reshape(len(fields), -1, TERMS + 1, 3)))


def series_of(fields: np.ndarray) -> np.ndarray:
    """Coefficients (nodes, TERMS + 1, fields, 3) of fields (fields, nodes, azimuths, 3), 0 beyond those azimuths."""
    fields[:, -1] = fields[:, -1].mean(axis=1, keepdims=True)  # at the zenith all azimuths are one
    count = fields.shape[2]
    series = np.zeros((fields.shape[1], TERMS + 1, len(fields), 3))
    series[:, :count] = np.moveaxis(np.tensordot(cosine_transform(count - 1), fields, axes=(1, 2)), 2, 0)
    return series


def shapes_of(laws: Sequence[PhaseLaw], cosine: np.ndarray) -> np.ndarray:
    """Phase functions of some laws, at `PIVOTS` where they change, at cosines (D,), sr-1, (shapes, D)."""
    c = np.clip(cosine, -1.0, 1.0)
    return np.concatenate([law.value(c, pivots(law)).T for law in laws])


def pivots(law: PhaseLaw) -> np.ndarray:
    """Wavelengths at which a phase law is kept: its own, where it is known by few."""
    if law.wavelengths_alike:
        return PIVOTS[:1]
    own = law.straight_between
    return own if own is not None and len(own) <= len(PIVOTS) else PIVOTS


def mixture(law: PhaseLaw, wavelengths: np.ndarray) -> np.ndarray:
    """How much of each kept phase function makes up that of wavelengths (W,), (shapes, W): least squares, relative."""
    if law.wavelengths_alike:
        return np.ones((1, len(wavelengths)))
    c = np.cos(np.linspace(0, np.pi, 721))
    wanted, kept = law.value(c, wavelengths), law.value(c, pivots(law))
    scale = 1 / kept.mean(axis=1, keepdims=True)
    mixed: np.ndarray = np.linalg.lstsq(kept * scale, wanted * scale, rcond=None)[0]
    return mixed


def strengths(sky: AtmosphereSky, views: np.ndarray, sun: np.ndarray, wavelengths: np.ndarray) -> Array:
    """What each constituent scatters once toward the ground along views (D, 3), per phase function, (shapes, D, W)."""
    air = sky.atmosphere
    found = sky.once_per_phase(views, wavelengths)
    if found is None:
        table = ColumnTable.of(air)
        radius = np.full(len(views), air.radius)
        path = rays(air, radius, np.maximum(views[:, 2], 0.0))
        depths = np.stack([part.depth(wavelengths) for part in air.constituents])
        scattering = depths * np.stack([part.scattered(wavelengths) for part in air.constituents])
        found = np.moveaxis(lit_columns(table, path, radius, sun[2], views @ sun, depths) * scattering, 1, 0)
    laws = [part.phase_law for part in air.constituents]
    return np.concatenate([mixture(law, wavelengths)[:, None, :] * one for law, one in zip(laws, found, strict=True)])
