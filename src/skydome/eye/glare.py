"""How much a sky glares: daylight glare probability, veiling luminance and illuminance at the eye.

Wienold and Christoffersen 2006, "Evaluation methods and development of a new glare prediction model for daylight
environments", with the position index of Guth (above the line of sight) and of Iwata and Tokura as CIE 2010 and
Kikuchi 2021 have it (below), and the rules of the program evalglare for what counts as one source of glare.
"""

from dataclasses import dataclass

import numpy as np

from skydome.eye.bright_source import BrightSource, without_sources
from skydome.eye.glow import Glow
from skydome.eye.linked_groups import linked_pixels
from skydome.eye.point_spread import AGES, stiles_holladay
from skydome.eye.view import HalfSphere
from skydome.ground.arguments import require_kind
from skydome.ground.directions import angle_between
from skydome.ground.extras import required
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.units import deg
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projection import texel_centre

THRESHOLD = 2000.0
"""Luminance, cd m-2, from which a pixel is a source of glare (Pierson 2018, evalglare's default since 2.05)."""

PEAK = 50_000.0
"""Luminance, cd m-2, from which pixels are a source of their own within a larger one."""

SEARCH = 0.1
"""Pixels this close, radians, belong to one source (half of evalglare's opening angle of 0.2)."""

MOST_INDEX = 16.0


@dataclass(frozen=True)
class GlareSource:
    """A source of glare: mean luminance, cd m-2; solid angle, sr; direction (3,); position index 1-16."""

    luminance: float
    solid_angle: float
    direction: tuple[float, float, float]
    position_index: float


@dataclass(frozen=True)
class Glare:
    """Daylight glare probability 0..1, illuminance at the eye, lx, veil over what is looked at, cd m-2, and sources."""

    probability: float
    illuminance: float
    veil: float
    sources: list[GlareSource]


def position_index(across: float, up: float, forward: float) -> float:
    """How much less a source disturbs off the line of sight, 1-16, by its direction in the eye's own axes.

    Above the line of sight Guth's index in Levin's form (IESNA Lighting Handbook); below it Iwata and Tokura's, their
    angle stretched by sqrt(1 + 0.3225 cos^2 tau) as Kikuchi 2021 writes it.

    >>> position_index(0.0, 0.0, 1.0)
    1.0
    """
    off = np.degrees(np.arctan2(np.hypot(across, up), forward))
    tilt = np.degrees(np.arctan2(abs(across), up))
    if up < 0:
        off = min(off, 89.9)
        stretched = np.degrees(np.arctan(np.tan(np.radians(off)) * np.sqrt(1 + 0.3225 * np.cos(np.radians(tilt)) ** 2)))
        exponent = 6.49e-3 * stretched + 2.1e-4 * stretched**2
    else:
        linear = 35.2 - 0.31889 * tilt - 1.22 * np.exp(-2 * tilt / 9)
        square = 21 + 0.26667 * tilt - 0.002963 * tilt**2
        exponent = linear * 1e-3 * off + square * 1e-5 * off**2
    return float(min(np.exp(exponent), MOST_INDEX))


def source_numbers(luminance: np.ndarray, frame: HalfSphere, threshold: float = THRESHOLD) -> np.ndarray:
    """Number 1, 2, ... of the source of glare that each pixel (H, W) belongs to, 0 for none.

    Pixels above the threshold are one source where steps of no more than SEARCH lead from one to the other; those of
    PEAK and more are then taken out of each source as sources of their own. A `threshold` of 100 or less is a factor
    on the mean luminance.
    """
    angles, directions = frame.solid_angles(), frame.directions()
    if threshold <= 100:
        threshold *= float(np.sum(luminance * angles) / angles.sum())
    numbers = linked_pixels((luminance > threshold) & (angles > 0), directions, SEARCH)
    peaks = (numbers > 0) & (luminance >= PEAK)
    result, next_number = np.where(peaks, 0, numbers), int(numbers.max(initial=0))
    for number in np.unique(numbers[peaks]):
        own = linked_pixels(peaks & (numbers == number), directions, SEARCH)
        result = np.where(own > 0, own + next_number, result)
        next_number += int(own.max())
    return result


def glare_sources(luminance: np.ndarray, frame: HalfSphere, threshold: float = THRESHOLD) -> list[GlareSource]:
    """The sources of glare in a round picture of luminance, cd m-2, (H, W); see `source_numbers`."""
    numbers = source_numbers(luminance, frame, threshold)
    row, column = np.nonzero(numbers)
    number = numbers[row, column]
    angle = frame.solid_angles()[row, column]
    light = luminance[row, column].astype(np.float64) * angle
    size, total = (np.bincount(number, weights=part) for part in (angle, light))
    down, right = (np.bincount(number, weights=light * texel_centre(place)) for place in (row, column))
    found = []
    for k in np.nonzero(size > 0)[0]:
        toward = frame.toward(down[k] / total[k], right[k] / total[k])
        index = position_index(*(frame.axes @ toward))
        found.append(GlareSource(float(total[k] / size[k]), float(size[k]), tuple(toward.tolist()), index))
    return found


def daylight_glare_probability(illuminance: float, sources: list[GlareSource]) -> float:
    """Daylight glare probability, 0..1, of an illuminance at the eye, lx, and sources of glare.

    DGP = 5.87e-5 E + 0.092 log10(1 + sum of L^2 w / (E^1.87 P^2)) + 0.159, at most 1: the constants of evalglare
    (the paper rounds them to 0.0918 and 0.16).

    >>> round(daylight_glare_probability(1000.0, []), 4)
    0.2177
    """
    if illuminance <= 0:
        return 0.159
    contrast = sum(s.luminance**2 * s.solid_angle / s.position_index**2 for s in sources) / illuminance**1.87
    return float(min(5.87e-5 * illuminance + 0.092 * np.log10(1 + contrast) + 0.159, 1.0))


def eye_illuminance(luminance: np.ndarray, frame: HalfSphere) -> float:
    """Illuminance on a plane across the line of sight, lx, of a round picture (H, W), cd m-2."""
    cosine = np.maximum(frame.directions() @ frame.forward, 0.0)
    return float(np.sum(luminance * cosine * frame.solid_angles()))


YEARS = Range(0.0, AGES[1], "years")


def veiling_luminance(luminance: np.ndarray, frame: HalfSphere, age: float = 0.0, nearest: float = 1 * deg) -> float:
    """Luminance that scattering in the eye lays over what is looked at, cd m-2 (Stiles and Holladay, with age).

    10 (1 + (age / 70)^4) times the sum of illuminance / angle^2 over a round picture (H, W) of luminance, cd m-2.
    The formula holds from 1 to 30 degrees: light nearer than `nearest` is what is looked at, light from beyond 30
    degrees, which adds little, goes by the same law.
    """
    require("age", age, YEARS)
    require_one("age", age)
    cosine = np.clip(frame.directions() @ frame.forward, 0.0, 1.0)
    angle = np.arccos(cosine)
    share = np.where(angle >= nearest, stiles_holladay(np.maximum(angle, nearest), age), 0.0)
    return float(np.sum(luminance * cosine * frame.solid_angles() * share))


def veil_of_source(
    source: BrightSource, frame: HalfSphere, illuminance: float, age: float, nearest: float = 1 * deg
) -> float:
    """The same for one source that gives `illuminance`, lx, on a plane that faces it: 0 nearer than `nearest`."""
    angle = float(angle_between(frame.forward, source.direction))
    if not nearest <= angle < np.pi / 2:
        return 0.0
    return float(illuminance * np.cos(angle) * stiles_holladay(angle, age))


SIDE_OF_VIEW = Range(100, 8192, "pixels")


def glare(environment: EnvironmentMap, azimuth: float, elevation: float, age: float = 0.0, side: int = 800) -> Glare:
    """The glare of a map for one who looks toward an azimuth and elevation, radians.

    Worked out on a round picture of `side` pixels in which suns are discs with their exact light.

    >>> import skydome as sd
    >>> grey = EnvironmentMap(np.full((32, 64, 3), 1000.0))
    >>> seen = glare(grey, 0.0, 0.0)
    >>> round(seen.illuminance), round(seen.probability, 3), len(seen.sources)
    (3142, 0.343, 0)
    """
    required("scipy", "eye", "glare")
    require("side of the round picture", side, SIDE_OF_VIEW)
    require_one("side of the round picture", side, whole=True)
    require_kind(environment, EnvironmentMap, "environment", "render(sky, height=1024) or load(file)")
    frame, weights = HalfSphere(azimuth, elevation, side), environment.space.to_xyz[1]
    calm, suns = without_sources(environment)
    luminance = frame.seen(calm) @ weights
    veil = veiling_luminance(luminance, frame, age)
    for sun in suns:
        luminance += Glow.plain(sun.radius).painted(frame.toward, frame.shape, sun) @ weights
        veil += veil_of_source(sun, frame, sun.illuminance(environment.space), age)
    sources, illuminance = glare_sources(luminance, frame), eye_illuminance(luminance, frame)
    return Glare(daylight_glare_probability(illuminance, sources), illuminance, veil, sources)
