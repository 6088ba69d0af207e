"""Skies between captures: a day's maps, frame by frame, smooth in time."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from skydome.captures.capture import Capture, seconds_of
from skydome.captures.interpolation import day_light
from skydome.ground.directions import angle_between, azimuth, direction, elevation
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projection import texel_centre
from skydome.skies.neural.network import Network
from skydome.sun.day import is_day

BLEND = np.radians(8.0)
"""Elevation below which the network's sky gives way to the captures' own: it has seen little of the horizon's haze."""
SETTING = np.radians(1.0)
"""Elevation over which a setting sun's disc fades."""
SUN_WIDTH = 1.2
"""Radius of the sun's spot, texels (at least its own): beyond it there is none, for a millionth of the sun shows."""
MOST_MOVED = 0.7
"""Log: the most by which the network may change a texel against the fade of its captures."""
SMOOTH = np.radians(1.5)
"""Standard deviation to which the network's change is smoothed: its neurons may be sharper than any glow."""
LEAST = 1e-6
FLOOR = 0.01
"""Share of the day's mean light below which the network has no say: there captures are faded as they are."""


@dataclass(frozen=True, eq=False)
class Animation:
    """Frames between captures: the network's sky times each capture's own residual, faded in the logarithm.

    What is no sky (ground, houses) is faded from capture to capture where it stands. The sun is taken out of the
    captures and laid back where it stands at the frame's time, with the captures' own light, faded.
    """

    captures: Sequence[Capture]
    network: Network
    _grid: np.ndarray = field(init=False, repr=False)
    _say: np.ndarray = field(init=False, repr=False)
    _parts: list[tuple[np.ndarray, np.ndarray]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Refuse captures that do not belong together; take the network's sky off each."""
        if len(self.captures) < 2:
            raise ValueError(f"an animation needs at least two captures, got {len(self.captures)}")
        shapes = {capture.picture.pixels.shape for capture in self.captures}
        layouts = {capture.picture.projection for capture in self.captures}
        if len(shapes) > 1 or len(layouts) > 1:
            raise ValueError(f"all captures must have one size and layout, got {sorted(shapes)} and {layouts}")
        fade = np.clip(elevation(self.upper()) / np.float32(BLEND), 0, 1)
        say = (common_sky(self.captures, self.upper(), self.height) * fade)[..., None].astype(np.float32)
        object.__setattr__(self, "_say", say)
        coarse = self.height // self.step
        grid = self.captures[0].picture.projection.directions(coarse, slice(0, coarse // 2), np.float32)
        object.__setattr__(self, "_grid", grid)
        object.__setattr__(self, "_parts", [self.taken_apart(capture) for capture in self.captures])

    @property
    def height(self) -> int:
        """Rows of the frames."""
        return self.captures[0].picture.height

    @property
    def times(self) -> np.ndarray:
        """Times of the captures, s after the first; 0, 1, 2 ... where they have none."""
        return seconds_of(self.captures)

    def upper(self) -> np.ndarray:
        """Directions (r, W, 3) of the rows above the horizon, float32."""
        rows = slice(0, self.height // 2)
        return self.captures[0].picture.projection.directions(self.height, rows, np.float32)

    def taken_apart(self, capture: Capture) -> tuple[np.ndarray, np.ndarray]:
        """Logs of the network's light at the capture's sun, on its grid, and of the capture (H, W, 3)."""
        light = np.log(np.maximum(capture.calm.pixels * np.float32(capture.picture.white_luminance), LEAST))
        return self.log_network(capture.sun), light.astype(np.float32)

    @property
    def step(self) -> int:
        """Texels to a point of the network's grid: 2 for maps of 128 rows and more, where halves are even."""
        return 2 if self.height >= 128 and self.height % 4 == 0 else 1

    def log_network(self, sun: np.ndarray) -> np.ndarray:
        """Log of the network's light above the horizon on its grid (r, w, 3), float32."""
        above = sun if is_day(sun) else direction(azimuth(sun), 1e-3)
        light = day_light(self.network.stored_as(np.float32), self._grid, above.astype(np.float32))
        return np.asarray(np.log(np.hypot(light, np.float32(FLOOR * self.network.scale))))

    def sun_at(self, time: float) -> np.ndarray:
        """The sun (3,) at a time, s after the first capture: smooth in azimuth and elevation through the captures'."""
        from scipy.interpolate import PchipInterpolator

        suns = np.array([capture.sun for capture in self.captures])
        angles = np.stack([np.unwrap(azimuth(suns)), elevation(suns)], axis=-1)
        turned, height = PchipInterpolator(self.times, angles)(time)
        return np.asarray(direction(turned, height))

    @property
    def peak(self) -> float:
        """More than any value of a frame: for a scale that all frames share."""
        spot = np.pi * self.sun_width**2 / 3  # sr, of the spot's profile
        suns = max(float(capture.sunlight.max()) for capture in self.captures) / spot
        return 4 * max(suns, *(float(capture.calm.pixels.max()) for capture in self.captures))

    @property
    def sun_width(self) -> float:
        """Radius of the round spot of the sun, rad."""
        return float(max(SUN_WIDTH * np.pi / self.height, np.radians(0.27)))

    def frame(self, time: float) -> EnvironmentMap:
        """The map at a time, s after the first capture; ValueError outside the captures' span."""
        times = self.times
        if not times[0] <= time <= times[-1]:
            raise ValueError(f"time must lie in [{times[0]:g}, {times[-1]:g}] s after the first capture, got {time:g}")
        later = int(np.clip(np.searchsorted(times, time), 1, len(times) - 1))
        share = np.float32((time - times[later - 1]) / (times[later] - times[later - 1]))
        (network_a, light_a), (network_b, light_b) = self._parts[later - 1], self._parts[later]
        sun = self.sun_at(time)
        light = light_a + share * (light_b - light_a)
        light[: self.height // 2] += self._say * self.moved(sun, network_a + share * (network_b - network_a))
        pixels = np.exp(light, out=light)
        before, after = self.captures[later - 1], self.captures[later]
        self.lay_sun(pixels, sun, (1 - share) * before.sunlight + share * after.sunlight)
        notes: dict[str, Any] = {"model": "skydome animation between captures", "seconds": float(time)}
        if before.time is not None:
            stamp = self.captures[0].time + np.timedelta64(round(time * 1e6), "us")  # type: ignore[operator]
            notes["time"] = stamp
        return EnvironmentMap(pixels, before.picture.projection, before.picture.space, notes)

    def moved(self, sun: np.ndarray, faded: np.ndarray) -> np.ndarray:
        """What the sun's motion changes, log (r, W, 3): the network now over its own fade, held and made smooth."""
        from scipy.ndimage import gaussian_filter

        change = np.float32(MOST_MOVED) * np.tanh((self.log_network(sun) - faded) / np.float32(MOST_MOVED))
        width = SMOOTH / np.pi * self.height / self.step
        smooth = gaussian_filter(change, (width, width, 0), mode=("nearest", "wrap", "nearest"), truncate=2.5)
        return smooth if self.step == 1 else doubled(smooth)

    def lay_sun(self, pixels: np.ndarray, sun: np.ndarray, sunlight: np.ndarray) -> None:
        """Add the sun's light (3,), cd m-2 sr, as a round spot about the sun, its energy exact; in place."""
        projection = self.captures[0].picture.projection
        texel = np.pi / self.height
        width = self.sun_width
        row, column, _ = projection.pixels(sun, self.height)
        rows, columns = pixels.shape[:2]
        reach = int(np.ceil(width / texel)) + 1
        i = np.arange(max(0, int(row) - reach), min(rows // 2, int(row) + reach + 1))
        across = min(columns // 2, int(np.ceil(reach / max(np.sin((row / rows) * np.pi), 1e-3))) + 1)
        j = (int(column) + np.arange(-across, across)) % columns
        if not i.size or not is_day(sun):
            return
        toward = projection.toward(texel_centre(i[:, None]), texel_centre(j[None, :]), self.height)
        spot = np.maximum(1 - (angle_between(toward, sun) / width) ** 2, 0) ** 2
        flux = spot * np.broadcast_to(projection.solid_angles(self.height), (rows, columns))[i[:, None], j]
        risen = float(np.clip(elevation(sun) / SETTING, 0, 1))
        total = flux.sum()
        if total > 0:
            open_sky = self._say[i[:, None], j] > 0  # a house hides the sun
            pixels[i[:, None], j] += (spot / total)[..., None] * (sunlight * risen) * open_sky


def common_sky(captures: Sequence[Capture], upper: np.ndarray, height: int) -> np.ndarray:
    """True where most captures show sky, (r, W): the camera stands, and one capture's slip must not move a house.

    About its own sun (5 degrees) a capture has no say; where none has, it is sky.
    """
    votes = np.zeros(upper.shape[:2])
    voters = np.zeros(upper.shape[:2])
    for capture in captures:
        says = angle_between(upper, capture.sun.astype(np.float32)) > np.radians(5.0)
        votes += says & capture.sky[: height // 2]
        voters += says
    sky: np.ndarray = 2 * votes >= voters
    return sky


def doubled(values: np.ndarray) -> np.ndarray:
    """Values (r, w, C) at twice the rows and columns, blended between texel centres, around the seam."""
    up, down = np.concatenate([values[:1], values[:-1]]), np.concatenate([values[1:], values[-1:]])
    tall = np.stack([0.75 * values + 0.25 * up, 0.75 * values + 0.25 * down], axis=1).reshape(-1, *values.shape[1:])
    left, right = np.roll(tall, 1, axis=1), np.roll(tall, -1, axis=1)
    wide = np.stack([0.75 * tall + 0.25 * left, 0.75 * tall + 0.25 * right], axis=2)
    return wide.reshape(tall.shape[0], -1, values.shape[-1])


def change(before: np.ndarray, after: np.ndarray) -> float:
    """How much a frame differs from the one before: mean |difference| of pixels over their mean."""
    return float(np.abs(after - before).mean() / max(float(before.mean()), LEAST))


def roughest(changes: Sequence[float]) -> float:
    """The largest frame-to-frame change over the median one; 1 is even."""
    middle = float(np.median(changes)) if len(changes) else 0.0
    return float(np.max(changes)) / middle if middle > 0 else 1.0
