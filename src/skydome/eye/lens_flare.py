"""Ghosts of a camera's lens: reflections between its surfaces, as many-sided spots on the line from sun to centre."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from skydome.eye.bright_source import BrightSource, without_sources
from skydome.eye.eye import Seen
from skydome.eye.glow import Glow
from skydome.eye.view import Camera, require_view_of_glare
from skydome.ground.arguments import require_kind
from skydome.ground.limits.ranges import SEED, SHARE, Bounded, Range
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projection import texel_centre

SOFT = 3.0  # pixels over which a ghost's edge falls


@dataclass(frozen=True)
class LensFlare(Bounded):
    """A simple lens of `ghosts` reflections, seen through an aperture of `blades`; seeded.

    `strength` is the share of a source's light that the ghosts take, `haze` what is spread over the whole picture.
    Not a ray-traced lens: places, sizes and tints are drawn at random as in common lenses (Hullin et al. 2011 show
    them); the light adds up: what ghosts and haze have, the source's own image lacks.

    >>> import skydome as sd
    >>> sky = sd.Daylight(sd.Uniform(1000.0)) + sd.SunDisc(sd.direction(0.0, 5 * sd.deg), 3.0)
    >>> LensFlare(ghosts=5).look(sd.render(sky, height=64), sd.Camera(width=40, height=30)).plain.shape
    (30, 40, 3)
    """

    ghosts: int = 9
    blades: int = 6
    strength: float = 1e-3
    haze: float = 2e-3
    seed: int = 0
    bounds: ClassVar = {
        "ghosts": Range(1, 1000),
        "blades": Range(3, 100),
        "strength": SHARE,
        "haze": SHARE,
        "seed": SEED,
    }

    def __post_init__(self) -> None:
        self.require_bounds()
        if self.strength + self.haze > 1:
            raise ValueError(f"strength and haze must be shares of the light, got {self.strength:g} and {self.haze:g}")

    def look(self, environment: EnvironmentMap, view: Camera) -> Seen:
        """The map as a camera sees it in a view, without and with the flare of its suns."""
        require_view_of_glare(view)
        require_kind(environment, EnvironmentMap, "environment", "render(sky, height=1024) or load(file)")
        calm, sources = without_sources(environment)
        scene = view.seen(calm)
        plain, flared = scene.copy(), scene
        for source in sources:
            disc = Glow.plain(source.radius).painted(view.toward, view.shape, source)
            spots, share = self.spots(source, view)
            plain += disc
            flared += np.float32(1 - share) * disc + spots
        return Seen(plain, flared, sources, environment.space)

    def spots(self, source: BrightSource, view: Camera) -> tuple[np.ndarray, float]:
        """Ghosts and haze of one source in a view, (H, W, 3) float32, and the share of its light they were given.

        They fade as the source leaves the picture, and are gone where it is a whole width outside.
        """
        rows, columns = view.shape
        picture = np.zeros((rows, columns, 3), dtype=np.float32)
        row, column = (float(place) for place in view.place(source.direction))
        if not np.isfinite(row):
            return picture, 0.0
        outside = max(abs(row - rows / 2) / rows, abs(column - columns / 2) / columns) - 0.5
        fade = float(np.clip(1 - outside, 0.0, 1.0) ** 2)
        weight = source.light * fade
        picture += (weight * self.haze / view.solid_angles().sum()).astype(np.float32)
        random = np.random.default_rng(self.seed)
        share = random.dirichlet(np.ones(self.ghosts))[:, None] * random.dirichlet((4.0, 4.0, 4.0), self.ghosts)
        share *= self.strength / share.sum(axis=0)  # (ghosts, 3): tints that add up to white
        for part in share:
            along, size = random.uniform(-1.3, 0.8), view.width * random.uniform(0.012, 0.07)
            centre = rows / 2 + along * (row - rows / 2), columns / 2 + along * (column - columns / 2)
            for channel in range(3):
                spot = self.aperture(view, centre, size * (1 + 0.03 * (1 - channel)))
                picture[..., channel] += spot * np.float32(weight[channel] * part[channel])
        return picture, fade * (self.strength + self.haze)

    def aperture(self, view: Camera, centre: tuple[float, float], size: float) -> np.ndarray:
        """A soft polygon (H, W) float32 about a place, of circumradius `size` in pixels, that integrates to 1 sr^-1."""
        rows, columns = view.shape
        down = np.arange(rows, dtype=np.float32)[:, None] + np.float32(texel_centre(0) - centre[0])
        right = np.arange(columns, dtype=np.float32)[None, :] + np.float32(texel_centre(0) - centre[1])
        sector = 2 * np.pi / self.blades
        turn = np.mod(np.arctan2(down, right), sector) - sector / 2
        reach = np.hypot(down, right) * np.cos(turn)  # distance along the middle of the polygon's side
        edge = size * np.cos(sector / 2)
        spot = np.clip((edge - reach) / SOFT + 0.5, 0.0, 1.0) * (0.6 + 0.4 * np.clip(reach / edge, 0, 1))
        area = self.blades / 2 * np.sin(sector) * size**2 * view.pixel**2
        return np.asarray(spot / (area * 0.867), dtype=np.float32)  # 0.6 + 0.4 x 2/3, the mean of the spot's profile
