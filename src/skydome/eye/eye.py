"""The eye that looks at a sky: its age, its iris, its pupil, and what it makes of a map or a view."""

from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np

from skydome.eye.bright_source import BrightSource, without_sources
from skydome.eye.glow import Glow, disc_glow
from skydome.eye.point_spread import AGES, PIGMENTS, CIETotal, PointSpread, StilesHolladay
from skydome.eye.sphere_blur import blurred_map
from skydome.eye.streaks import Needles
from skydome.eye.view import Camera, Frame, require_view_of_glare
from skydome.eye.view_blur import blurred
from skydome.ground.arguments import require_kind, require_word
from skydome.ground.limits.ranges import Bounded, Range
from skydome.light.colour import RGBSpace
from skydome.maps.environment_map import EnvironmentMap

NARROWEST, WIDEST = 1.9, 4.9
"""Pupils, mm, of Spencer's photopic and scotopic states: between them the halo's share grows from 0 to HALO."""

HALO = 0.033


def pupil_diameter(luminance: float) -> float:
    """Diameter of the pupil, mm, in a field of that luminance, cd m-2: 4.9 - 3 tanh(0.4 log10 L).

    Moon and Spencer 1944, "On the Stiles-Crawford effect", as Watson and Yellott 2012 quote it; 1.9-7.9 mm.

    >>> round(pupil_diameter(4000.0), 2), round(pupil_diameter(1.0), 2)
    (2.22, 4.9)
    """
    return float(4.9 - 3 * np.tanh(0.4 * np.log10(max(luminance, 1e-9))))


def halo_share(pupil: float) -> float:
    """Share of the light in the lenticular halo, 0-0.033: it shows as the pupil uncovers the lens's outer fibres.

    Spencer et al. 1995 give 0 by day and 0.033 by night; linear in the diameter, mm, between them.

    >>> round(halo_share(2.2), 4)
    0.0033
    """
    return HALO * float(np.clip((pupil - NARROWEST) / (WIDEST - NARROWEST), 0.0, 1.0))


@dataclass(frozen=True, eq=False)
class Seen:
    """A picture without and with scattering in the eye: linear RGB (H, W, 3), (1, 1, 1) being 1 cd m-2."""

    plain: np.ndarray
    eye: np.ndarray
    sources: list[BrightSource]
    space: RGBSpace


@dataclass(frozen=True)
class Eye(Bounded):
    """An eye by `age`, years, 5-100, and perhaps `iris`: black, brown, green, blue. `pupil` in mm; None: by the light.

    Its spread is `StilesHolladay`, the standard veil at that age, which knows no iris; where an iris is given, CIE
    135/1, which does. `spread` replaces both, such as `PHOTOPIC` (Spencer et al.); `needles` may be None.

    >>> Eye(age=60).own_spread, Eye(age=60, iris="blue").own_spread
    (StilesHolladay(age=60), CIETotal(age=60, pigment=1.2))
    """

    age: float = 35.0
    iris: str | None = None
    pupil: float | None = None
    spread: PointSpread | None = None
    needles: Needles | None = field(default_factory=Needles)
    bounds: ClassVar = {"age": Range(*AGES, "years"), "pupil": Range(1.0, 9.0, "mm")}
    kinds: ClassVar = {"spread": (PointSpread | None, "PHOTOPIC"), "needles": (Needles | None, "Needles()")}

    def __post_init__(self) -> None:
        if self.iris is not None:
            require_word(self.iris, PIGMENTS, "iris")
        self.require_bounds()
        if self.iris is not None and self.spread is not None:
            raise ValueError(f"give an eye an iris or a spread, not both, got {self.iris!r} and {self.spread}")

    @property
    def own_spread(self) -> PointSpread:
        """The spread of light in this eye."""
        if self.spread is not None:
            return self.spread
        return StilesHolladay(self.age) if self.iris is None else CIETotal(self.age, PIGMENTS[self.iris])

    def glow(self, radius: float, luminance: float, space: RGBSpace) -> Glow:
        """How a disc of angular `radius`, radians, looks in a field of that luminance, cd m-2."""
        share = halo_share(pupil_diameter(luminance) if self.pupil is None else self.pupil)
        needles = None if self.needles is None else replace(self.needles, radius=radius)
        angle, value = disc_glow(self.own_spread, radius, share, space)
        return Glow(angle, value, radius, needles)

    def look(self, environment: EnvironmentMap, view: Camera, sources: list[BrightSource] | None = None) -> Seen:
        """The map as seen in a view, without and with scattering; suns in the map are found unless given.

        `sources` are added to the map: give them for a map that does not hold its sun.
        """
        require_kind(environment, EnvironmentMap, "environment", "render(sky, height=1024) or load(file)")
        require_view_of_glare(view)
        require_kind(sources, list | None, "sources", "[BrightSource(...)]")
        for source in sources or ():
            require_kind(source, BrightSource, "each source", "BrightSource(...)")
        if sources is None:
            environment, sources = without_sources(environment)
        scene = view.seen(environment)
        plain, eye = scene.copy(), blurred(scene, view.pixel, self.own_spread)
        luminance = float(np.mean(scene @ environment.space.to_xyz[1].astype(np.float32)))
        for source in sources:
            plain += Glow.plain(source.radius).painted(view.toward, view.shape, source)
            eye += self.glow(source.radius, luminance, environment.space).painted(view.toward, view.shape, source)
        return Seen(plain, np.maximum(eye, 0.0), sources, environment.space)

    def on_sphere(self, environment: EnvironmentMap) -> EnvironmentMap:
        """The map with its light scattered as in an eye that looks everywhere: each texel is what is seen there."""
        require_kind(environment, EnvironmentMap, "environment", "render(sky, height=1024) or load(file)")
        calm, sources = without_sources(environment)
        result = blurred_map(calm, self.own_spread)
        pixels = result.pixels.astype(np.float32)
        luminance = float(np.mean(calm.luminance()))
        for source in sources:
            glow = self.glow(source.radius, luminance, environment.space)
            shape = (pixels.shape[0], pixels.shape[1])
            light: Any = glow.painted(on_map(environment), shape, source)
            pixels += light / np.float32(environment.white_luminance)
        return replace(environment, pixels=pixels)


def on_map(environment: EnvironmentMap) -> Any:
    """Directions of the map's continuous texel coordinates."""
    return lambda row, column: environment.projection.toward(row, column, environment.height)


def plainly_seen(environment: EnvironmentMap, frame: Frame) -> np.ndarray:
    """The map in a view or round picture without scattering, (H, W, 3): suns are drawn as discs, their light exact."""
    calm, sources = without_sources(environment)
    picture = frame.seen(calm)
    for source in sources:
        picture += Glow.plain(source.radius).painted(frame.toward, frame.shape, source)
    return picture
