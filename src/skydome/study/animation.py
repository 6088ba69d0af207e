"""Skies between captures: a day's maps, frame by frame, smooth in time."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from skydome.ground.directions import angle_between, azimuth, direction, elevation
from skydome.maps.environment_map import EnvironmentMap
from skydome.skies.network import Network
from skydome.study.captures import Capture
from skydome.study.interpolation import day_light

BLEND = 2.0 * np.pi / 180
"""Elevation over which the network's sky fades into the captures at the horizon, and a setting sun into nothing."""
SUN_WIDTH = 0.6
"""Standard deviation of the sun's spot, texels (at least its own radius)."""
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
    _parts: list[tuple[np.ndarray, np.ndarray]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Refuse captures that do not belong together; take the network's sky off each."""
        if len(self.captures) < 2:
            raise ValueError(f"an animation needs at least two captures, got {len(self.captures)}")
        shapes = {capture.picture.pixels.shape for capture in self.captures}
        layouts = {capture.picture.projection for capture in self.captures}
        if len(shapes) > 1 or len(layouts) > 1:
            raise ValueError(f"all captures must have one size and layout, got {sorted(shapes)} and {layouts}")
        sky = common_sky(self.captures, self.upper(), self.height)
        object.__setattr__(self, "_parts", [self.taken_apart(capture, sky) for capture in self.captures])

    @property
    def height(self) -> int:
        """Rows of the frames."""
        return self.captures[0].picture.height

    @property
    def times(self) -> np.ndarray:
        """Times of the captures, s after the first; 0, 1, 2 ... where they have none."""
        stamps = [capture.time for capture in self.captures]
        if stamps[0] is None:
            return np.arange(len(stamps), dtype=np.float64)
        return np.array([(stamp - stamps[0]) / np.timedelta64(1, "s") for stamp in stamps])

    def upper(self) -> np.ndarray:
        """Directions (r, W, 3) of the rows above the horizon, float32."""
        rows = slice(0, self.height // 2)
        return self.captures[0].picture.projection.directions(self.height, rows, np.float32)

    def taken_apart(self, capture: Capture, sky: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """How much of each texel is the network's (r, W, 1), and the log of the capture over that power of it."""
        toward = self.upper()
        fade = np.clip(elevation(toward) / np.float32(BLEND), 0, 1)
        network = (sky * fade)[..., None].astype(np.float32)
        light = np.log(np.maximum(capture.calm.pixels * np.float32(capture.picture.white_luminance), LEAST))
        rest = light.astype(np.float32)
        rest[: len(toward)] -= network * self.log_network(toward, capture.sun)
        return network, rest

    def log_network(self, toward: np.ndarray, sun: np.ndarray) -> np.ndarray:
        """Log of the network's light (r, W, 3), float32."""
        above = sun if sun[2] > 0 else direction(azimuth(sun), 1e-3)
        light = day_light(self.network.stored_as(np.float32), toward, above.astype(np.float32))
        return np.asarray(np.log(np.hypot(light, np.float32(FLOOR * self.network.scale))))

    def sun_at(self, time: float) -> np.ndarray:
        """The sun (3,) at a time, s after the first capture: smooth in azimuth and elevation through the captures'."""
        from scipy.interpolate import PchipInterpolator

        suns = np.array([capture.sun for capture in self.captures])
        angles = np.stack([np.unwrap(azimuth(suns)), elevation(suns)], axis=-1)
        turned, height = PchipInterpolator(self.times, angles)(time)
        return np.asarray(direction(turned, height))

    def frame(self, time: float) -> EnvironmentMap:
        """The map at a time, s after the first capture; ValueError outside the captures' span."""
        times = self.times
        if not times[0] <= time <= times[-1]:
            raise ValueError(f"time must lie in [{times[0]:g}, {times[-1]:g}] s after the first capture, got {time:g}")
        later = int(np.clip(np.searchsorted(times, time), 1, len(times) - 1))
        share = np.float32((time - times[later - 1]) / (times[later] - times[later - 1]))
        (network_a, rest_a), (network_b, rest_b) = self._parts[later - 1], self._parts[later]
        sun, toward = self.sun_at(time), self.upper()
        light = rest_a + share * (rest_b - rest_a)
        light[: len(toward)] += (network_a + share * (network_b - network_a)) * self.log_network(toward, sun)
        pixels = np.exp(light, out=light)
        before, after = self.captures[later - 1], self.captures[later]
        self.lay_sun(pixels, sun, (1 - share) * before.sunlight + share * after.sunlight)
        notes: dict[str, Any] = {"model": "skydome animation between captures", "seconds": float(time)}
        if before.time is not None:
            stamp = self.captures[0].time + np.timedelta64(round(time * 1e6), "us")  # type: ignore[operator]
            notes["time"] = stamp
        return EnvironmentMap(pixels, before.picture.projection, before.picture.space, notes)

    def lay_sun(self, pixels: np.ndarray, sun: np.ndarray, sunlight: np.ndarray) -> None:
        """Add the sun's light (3,), cd m-2 sr, as a round spot about the sun, its energy exact; in place."""
        projection = self.captures[0].picture.projection
        texel = np.pi / self.height
        width = max(SUN_WIDTH * texel, 0.00465)
        row, column, _ = projection.pixels(sun, self.height)
        rows, columns = pixels.shape[:2]
        reach = int(np.ceil(5 * width / texel))
        i = np.arange(max(0, int(row) - reach), min(rows // 2, int(row) + reach + 1))
        across = min(columns // 2, int(np.ceil(reach / max(np.sin((row / rows) * np.pi), 1e-3))) + 1)
        j = (int(column) + np.arange(-across, across)) % columns
        if not i.size or sun[2] <= 0:
            return
        toward = projection.toward(i[:, None] + 0.5, j[None, :] + 0.5, self.height)
        spot = np.exp(-((angle_between(toward, sun) / width) ** 2) / 2)
        flux = spot * np.broadcast_to(projection.solid_angles(self.height), (rows, columns))[i[:, None], j]
        risen = float(np.clip(elevation(sun) / BLEND, 0, 1))
        total = flux.sum()
        if total > 0:
            pixels[i[:, None], j] += (spot / total)[..., None] * (sunlight * risen)


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


def change(before: np.ndarray, after: np.ndarray) -> float:
    """How much a frame differs from the one before: mean |difference| of pixels over their mean."""
    return float(np.abs(after - before).mean() / max(float(before.mean()), LEAST))


def roughest(changes: Sequence[float]) -> float:
    """The largest frame-to-frame change over the median one; 1 is even."""
    middle = float(np.median(changes)) if len(changes) else 0.0
    return float(np.max(changes)) / middle if middle > 0 else 1.0
