"""Where the sun stands in a captured map: its disc where it is seen, its glow where it is hidden or burnt out."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from skydome.captures.sky_glow import DOUBT, LEAST_SHARE, LEAST_STRENGTH, glow_centre
from skydome.ground.directions import angle_between, elevation, unit
from skydome.ground.units import deg
from skydome.maps.environment_map import EnvironmentMap

LOWEST = -1.0 * deg
AUREOLE = (2 * deg, 8 * deg)
CANDIDATES = 24
CLEAR_DISC, BURNT_DISC = 8.0, 1.25
"""How far a disc outshines its aureole: anywhere, and burnt out where the whole sky's glow points (within NEAR)."""
NEAR = 20 * deg
RING, BRIGHT_SHARE, ABOVE_RING = (2 * deg, 4 * deg), 90.0, 1.25
"""A disc also outshines the brightest tenth of the ring close by; glow along a ridge does not."""
STARK, SMALL_PART, TWILIGHT_DOUBT = 4.0, 0.01, 15 * deg
"""A sky whose brightest hundredth outshines its median so far has its sun there, if but below the horizon."""
EQUAL = 0.7
"""Blobs this near to the brightest are judged by their aureoles."""


@dataclass(frozen=True)
class FoundSun:
    """The sun's `direction` (3,), whether its disc is `visible`, and how bright it is against the sky's median.

    `burnt_out`: several texels share the largest value, so that its light is not known. `doubt`: radians within which
    the direction is expected to be right: a texel for a disc, several degrees for the glow of a hidden sun.
    """

    direction: np.ndarray
    visible: bool
    burnt_out: bool
    contrast: float
    doubt: float


def find_sun(picture: EnvironmentMap, sky: np.ndarray | None = None) -> FoundSun:
    """The sun of a map in any layout: the centre of its brightest blob, below a texel; ValueError where there is none.

    `sky` (H, W): True where the map shows sky (default: all above the horizon), where the glow is looked at; a disc is
    looked for everywhere above the horizon. A blob is a sun only if it has an
    aureole: single hot pixels and lamps stand in an ordinary sky and are passed over. Where no disc outshines its
    aureole (clouds, roofs) the centre of the glow is given, with several degrees of doubt; where that is not where the
    sky is by far brightest (a sun just set), the centre of the brightest part, with more.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=2.0, elevation=0.7)
    >>> sky = sd.HosekWilkie(sun, turbidity=3.0)
    >>> found = find_sun(sd.render(sky + sd.SunDisc.of(sky), height=128))
    >>> found.visible, bool(angle_between(found.direction, sun) < 0.3 * deg)
    (True, True)
    """
    toward = picture.projection.directions(picture.height)
    seen = picture.projection.valid(picture.height) & (elevation(toward) > LOWEST)
    light = np.where(seen, np.maximum(picture.luminance(), 0.0), 0.0).astype(np.float64)
    if not np.isfinite(light).all():
        raise ValueError("pixels must be finite to look for the sun, got NaN or infinity")
    if not light.any():
        raise ValueError("no sun found: the map's sky is black; give the sun by place and time, or its direction")
    sizes = np.broadcast_to(picture.projection.solid_angles(picture.height), light.shape)
    clear = seen if sky is None or not (seen & sky).any() else seen & sky
    glow = glow_centre(light, clear, toward, sizes)
    found = visible_sun(light, seen, toward, sizes, glow.direction)
    if found is not None:
        return found
    trusted = glow.share >= LEAST_SHARE and glow.strength >= LEAST_STRENGTH
    brightest, contrast = brightest_part(light, clear, toward, sizes)
    if contrast > STARK and (not trusted or angle_between(glow.direction, brightest) > NEAR):
        return FoundSun(brightest, False, False, contrast, float(TWILIGHT_DOUBT))
    if not trusted:
        raise ValueError(
            f"no sun found: no disc is seen, and a glow explains {max(glow.share, 0):.0%} of the pattern with a rise "
            f"of {glow.strength:.2f} in its logarithm (at least {LEAST_SHARE:.0%} and {LEAST_STRENGTH} are needed); "
            "give the sun by place and time, or its direction"
        )
    return FoundSun(glow.direction, False, False, float(np.exp(glow.strength)), DOUBT)


def visible_sun(
    light: np.ndarray, seen: np.ndarray, toward: np.ndarray, sizes: np.ndarray, glow: np.ndarray
) -> FoundSun | None:
    """The disc: the brightest blob that outshines an aureole of its own (of equals the one with most); else None."""
    usual = float(np.median(light[seen]))
    left = np.where(seen, light, 0.0)
    best: tuple[float, float, np.ndarray] | None = None
    for _ in range(CANDIDATES):
        peak = np.unravel_index(int(np.argmax(left)), left.shape)
        top = float(light[peak])
        if top <= usual or (best is not None and top < EQUAL * best[1]):
            break
        angle = angle_between(toward, toward[peak])
        around = seen & (angle > AUREOLE[0]) & (angle < AUREOLE[1])
        aureole = float(np.median(light[around])) if around.any() else 0.0
        pointed = angle_between(toward[peak], glow) < NEAR
        outshines = top > (BURNT_DISC if pointed else CLEAR_DISC) * aureole > 0 and stands_alone(
            top, light[seen & (light > usual)], angle[seen & (light > usual)]
        )
        if outshines and (pointed or aureole > 1.3 * usual) and (best is None or aureole > best[0]):
            best = (aureole, top, toward[peak])
        left = np.where(angle < AUREOLE[0], 0.0, left)
    if best is None:
        return None
    aureole, top, start = best
    centre = disc_centre(light * seen, toward, sizes, start, min(1.5 * aureole, (aureole + top) / 2))
    same = seen & (angle_between(toward, start) < AUREOLE[0]) & (light >= 0.999 * top)
    return FoundSun(centre, True, int(np.count_nonzero(same)) > 1, top / usual, float(np.sqrt(sizes.max())))


def brightest_part(
    light: np.ndarray, seen: np.ndarray, toward: np.ndarray, sizes: np.ndarray
) -> tuple[np.ndarray, float]:
    """Centre (3,) of the brightest hundredth of the seen sky, by solid angle, and its least light over the median."""
    values, angles = light[seen], sizes[seen]
    order = np.argsort(values)[::-1]
    share = np.cumsum(angles[order]) / angles.sum()
    edge, usual = values[order][np.searchsorted(share, [SMALL_PART, 0.5])]
    bright = seen & (light >= edge)
    centre = unit(np.einsum("i,ij->j", (light * sizes)[bright], toward[bright]))
    return np.asarray(centre), float(edge / usual) if usual > 0 else np.inf


def stands_alone(top: float, light: np.ndarray, angle: np.ndarray) -> bool:
    """Whether a peak of light `top` outshines the brightest part of the ring about it (`angle` from the peak, (n,))."""
    ring = light[(angle > RING[0]) & (angle < RING[1])]
    return ring.size == 0 or top > ABOVE_RING * float(np.percentile(ring, BRIGHT_SHARE))


def disc_centre(
    light: np.ndarray, toward: np.ndarray, sizes: np.ndarray, start: np.ndarray, floor: float
) -> np.ndarray:
    """Centre of the light above `floor` about `start` (3,), a unit vector; texels weigh by light x solid angle."""
    centre = start
    for _ in range(4):
        near = angle_between(toward, centre) < AUREOLE[0]
        excess = np.where(near, np.maximum(light - floor, 0.0), 0.0) * sizes
        total = np.einsum("ij,ijk->k", excess, toward)
        if not total.any():
            break
        centre = np.asarray(unit(total))
    return centre


def sun_pixels(picture: EnvironmentMap, sun: ArrayLike, threshold: float | None = None) -> np.ndarray:
    """True for texels (H, W) that show the sun: within 5 degrees of it and brighter than `threshold`, cd m-2.

    Default threshold: 4 times the median of the ring 5 to 8 degrees from the sun, which leaves a clear sky's aureole.
    """
    toward = picture.projection.directions(picture.height)
    angle, light = angle_between(toward, np.asarray(sun)), picture.luminance()
    if threshold is None:
        ring = (angle > 5 * deg) & (angle < 8 * deg) & (elevation(toward) > 0)
        threshold = 4 * float(np.median(light[ring])) if ring.any() else np.inf
    near: np.ndarray = (angle < 5 * deg) & (light > threshold)
    return near
