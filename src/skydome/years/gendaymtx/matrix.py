"""A year of Perez skies by the rules of Radiance's `gendaymtx` (as in pyradiance 1.3.1), to the rounding of its floats.

`years.skies.series` has the paper's own rules; this is the second form, for who must match that program, and it is
quick from start to end: NumPy alone. Tested against gendaymtx itself. Its rules, where they differ from the paper:

paper | gendaymtx
true sun (SPA) | declination 0.4093 sin(2 pi (J - 81) / 365), printed hour, J with the leap days that the tape has
sun anywhere | zenith angle in the formula from 3 to 90 degrees; the sun lights patches from below the horizon too
clearness, brightness as they come | held in 1-11.9 and 0.01-0.6; brightness at least 0.2 for clearness 1.065-2.8
mean over each patch | value at its centre, angles rounded to float32
black sky | uniform one
night: sun down | night: direct plus diffuse at most 1e-4 W m-2
dew point of the hour | of an EPW the mean of that hour and the two before; of a tape 11 degrees C
the sun apart | its light over the four nearest patches (`gendaymtx_sun`), or in one, or left out
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from skydome.ground.units import RADIANCE_EFFICACY
from skydome.years.gendaymtx.conditions import category, conditions, efficacies, irradiances_of, table
from skydome.years.gendaymtx.hours import Tape, sun_of
from skydome.years.gendaymtx.rows import BLOCK, Skies, horizontal_sums, patch_rows
from skydome.years.gendaymtx.sun import Sun, sun_light

SKY_COLOUR = (0.960, 1.004, 1.118)
GROUND_REFLECTANCE = 0.2


def skies_of(tape: Tape, solar: bool = False, minutes: float = 0.0) -> Skies:
    """The skies of the lit hours; with `solar` their light is all radiation, 179 lm for every watt (`-O1`).

    `minutes` are those of an interval (`-i`), for the sun of hours in which it rises or sets.
    """
    lit = np.flatnonzero(tape.direct + tape.diffuse > 1e-4)
    tape = tape.rows(lit)
    altitude, azimuth = sun_of(tape, minutes)
    day, dew_point = tape.day_of_year, tape.dew_point
    direct, diffuse = (value.astype(np.float32).astype(np.float64) for value in (tape.direct, tape.diffuse))
    zenith = np.clip(np.pi / 2 - altitude, np.radians(3), np.pi / 2)
    given = (direct, diffuse)
    if tape.photometric:
        direct, diffuse = irradiances_of(direct, diffuse, zenith, day, dew_point)
    clearness, brightness = conditions(direct, diffuse, zenith, day)
    row = category(clearness)
    letters = letters_of(row, zenith, clearness, brightness)
    if solar:
        beam, light = direct * RADIANCE_EFFICACY, diffuse * RADIANCE_EFFICACY
    elif tape.photometric:
        beam, light = given
    else:
        beam, light = (a * b for a, b in zip(efficacies(row, zenith, brightness, dew_point), given, strict=True))
    on_ground = light + beam * np.maximum(np.sin(altitude), 0)
    return Skies(lit, letters, zenith, azimuth, altitude, light, beam, on_ground)


def letters_of(index: np.ndarray, zenith: np.ndarray, clearness: np.ndarray, brightness: np.ndarray) -> np.ndarray:
    """The letters a ... e, (5, K): `skies.perez_all_weather.distribution_letters` with the limit on dark skies."""
    x = table("perez_1993")[index, 1:].T.reshape(5, 4, -1)
    delta = np.where((clearness > 1.065) & (clearness < 2.8), np.maximum(brightness, 0.2), brightness)
    letters: np.ndarray = x[:, 0] + x[:, 1] * zenith + delta * (x[:, 2] + x[:, 3] * zenith)
    first = np.flatnonzero(index == 0)
    if first.size:
        x, delta, zenith = x[..., first], delta[first], zenith[first]
        power = np.maximum(delta * (x[2, 0] + x[2, 1] * zenith), 0) ** x[2, 2]
        letters[2, first] = np.exp(power) - x[2, 3]
        letters[3, first] = -np.exp(delta * (x[3, 0] + x[3, 1] * zenith)) + x[3, 2] + delta * x[3, 3]
    return letters


def radiances(skies: Skies, division: int) -> Iterator[np.ndarray]:
    """Radiances of the sky (J, K) of some patches, W m-2 sr-1 of white, of the lit hours: the ground, then the patches.

    The array is used again for the next patches.
    """
    yield lit_ground(skies)
    total, rows = horizontal_sums(skies, division)
    black = np.flatnonzero(total == 0)
    uniform = (skies.diffuse[black] / (RADIANCE_EFFICACY * np.pi)).astype(np.float32)
    level = np.divide(skies.diffuse, RADIANCE_EFFICACY * total, out=np.zeros_like(total), where=total > 0)
    for light in levelled(rows, level) if rows else (light for light, _, _ in patch_rows(skies, division, level)):
        if black.size:
            light[:, black] = uniform
        yield light


def levelled(rows: list[np.ndarray], level: np.ndarray) -> Iterator[np.ndarray]:
    """Relative luminances (J, K), some patches at a time, times `level` (K,), in place."""
    factor = level.astype(np.float32)
    for light in rows:
        light *= factor
        yield light


def lit_ground(skies: Skies) -> np.ndarray:
    """Radiance (1, K) of a ground that reflects all, W m-2 sr-1 of white."""
    ground: np.ndarray = (skies.on_ground / (np.pi * RADIANCE_EFFICACY))[None].astype(np.float32)
    return ground


def matrix(tape: Tape, division: int = 1, sun: Sun | None = None) -> np.ndarray:
    """Radiances (144 n^2 + 2, T), float32, W m-2 sr-1 of white: the ground, then Reinhart's patches MF:n.

    What `gendaymtx -m n -c 1 1 1` makes with `sun` Sun(), and with `-s` where it is None; within 1e-5 of each value.
    """
    rows = np.zeros((144 * division**2 + 2, tape.hour.size), np.float32)
    skies = skies_of(tape)
    beams = None if sun is None else sun_light(skies, division, sun)
    first = 0
    for light in radiances(skies, division):
        if first == 0:
            light *= np.float32(GROUND_REFLECTANCE)
        elif beams is not None:
            beams.add_to(light, first - 1, 1 / RADIANCE_EFFICACY)
        rows[first : first + len(light), skies.lit] = light
        first += len(light)
    return rows


Colour = tuple[float, float, float]


class Choices(NamedTuple):
    """What gendaymtx's options choose: colours of sky (None: no sky, `-d`) and ground, the sun, all radiation (`-O1`).

    `rotation`, degrees, turns the sky anticlockwise as seen from above; `minutes` are those of an interval (`-i`).
    """

    colour: Colour | None = SKY_COLOUR
    ground: Colour = (GROUND_REFLECTANCE, GROUND_REFLECTANCE, GROUND_REFLECTANCE)
    sun: Sun | None = Sun()
    solar: bool = False
    rotation: float = 0.0
    minutes: float = 0.0


def coloured(tape: Tape, division: int, choices: Choices) -> Iterator[np.ndarray]:
    """The same in Radiance's R, G, B, some patches at a time: (J, T, 3), float32, used again for the next."""
    skies = skies_of(tape, choices.solar, choices.minutes)
    skies = skies._replace(azimuth=skies.azimuth - np.radians(choices.rotation))
    beams = None if choices.sun is None else sun_light(skies, division, choices.sun)
    count, hours = tape.hour.size, skies.lit.size
    index = np.full(count, hours)
    index[skies.lit] = np.arange(hours)
    narrow = np.zeros((BLOCK // max(hours, 1) + 1, hours + 1, 3), np.float32)
    wide = np.empty((len(narrow), count, 3), np.float32)
    whole, pixels = wide.view("V12")[..., 0], narrow.view("V12")[..., 0]
    first = -1
    for light in radiances(skies, division) if choices.colour else ground_alone(skies, division, len(narrow)):
        colour = choices.ground if first < 0 else choices.colour or (0.0, 0.0, 0.0)
        part = narrow[: len(light)]
        for channel in range(3):
            np.multiply(light, np.float32(colour[channel]), out=part[:, :-1, channel])
        if beams is not None and first >= 0:
            beams.add_to(part, first, 1 / RADIANCE_EFFICACY)
        for row in range(len(light)):
            np.take(pixels[row], index, out=whole[row], mode="clip")
        first += len(light)
        yield wide[: len(light)]


def ground_alone(skies: Skies, division: int, at_once: int) -> Iterator[np.ndarray]:
    """The ground's radiance (1, K), then none of the patches (J, K), some at a time."""
    count = 144 * division**2 + 1
    yield lit_ground(skies)
    for k in range(0, count, at_once):
        yield np.zeros((min(at_once, count - k), skies.lit.size), np.float32)
