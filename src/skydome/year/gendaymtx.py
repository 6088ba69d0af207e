"""A year of Perez skies by the rules of Radiance's `gendaymtx` (as in pyradiance 1.3.1), to the rounding of its floats.

`year.series` has the paper's own rules; this is the second form, for people who must match that program, and it is
quick from start to end: NumPy alone. Tested against gendaymtx itself. Its rules, where they differ from the paper:

paper | gendaymtx
true sun (SPA) | declination 0.4093 sin(2 pi (J - 81) / 365), printed hour, day of the year without leap days
sun anywhere | zenith angle in the formula from 3 to 90 degrees; the sun lights patches from below the horizon too
clearness, brightness as they come | held in 1-11.9 and 0.01-0.6; brightness at least 0.2 for clearness 1.065-2.8
mean over each patch | value at its centre, angles rounded to float32
black sky | uniform one
night: sun down | night: direct plus diffuse at most 1e-4 W m-2
dew point of the hour | of an EPW the mean of that hour and the two before; of a tape 11 degrees C
"""

import os
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from skydome.year.perez_rows import BLOCK, Skies, horizontal_sums, patch_rows

WHITE_EFFICACY = 179.0
"""Lumens per watt by which Radiance turns luminance into its radiance."""

SKY_COLOUR = (0.960, 1.004, 1.118)
GROUND_REFLECTANCE = 0.2
SOLAR_CONSTANT = 1367.0
DAYS_BEFORE = np.array([0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334])
FOLDER = os.path.join(os.path.dirname(os.path.dirname(__file__)), "ground", "data")


class Tape(NamedTuple):
    """What gendaymtx reads of a year: date, standard time, direct normal and diffuse irradiance, dew point, each (T,).

    Latitude and longitude in degrees, north and east positive; hours east of UTC.
    """

    month: np.ndarray
    day: np.ndarray
    hour: np.ndarray
    direct: np.ndarray
    diffuse: np.ndarray
    dew_point: Any
    latitude: float
    longitude: float
    utc_offset: float


def table(name: str) -> np.ndarray:
    """The numbers of a table of `ground/data`, (rows, columns)."""
    with open(os.path.join(FOLDER, f"{name}.csv"), encoding="utf-8") as file:
        lines = [line for line in file if line[0] not in "#\n"]
    return np.array([line.split(",") for line in lines[1:]], dtype=np.float64)


def sun_of(tape: Tape) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Altitude and azimuth (clockwise from north), radians, and the day of the year, each (T,)."""
    day = DAYS_BEFORE[tape.month.astype(np.int64) - 1] + tape.day
    latitude = np.radians(tape.latitude)
    correction = 0.170 * np.sin(4 * np.pi / 373 * (day - 80)) - 0.129 * np.sin(2 * np.pi / 355 * (day - 8))
    hour = tape.hour + correction + 12 / 180 * (tape.longitude - 15 * tape.utc_offset)
    declination = 0.4093 * np.sin(2 * np.pi / 365 * (day - 81))
    turn = hour * (np.pi / 12)
    level, rise = np.cos(declination), np.sin(declination)
    sine = np.sin(latitude) * rise - np.cos(latitude) * level * np.cos(turn)
    south = -np.cos(latitude) * rise - np.sin(latitude) * level * np.cos(turn)
    return np.arcsin(np.clip(sine, -1, 1)), np.pi - np.arctan2(level * np.sin(turn), south), day


def skies_of(tape: Tape) -> Skies:
    """The skies of the lit hours."""
    lit = np.flatnonzero(tape.direct + tape.diffuse > 1e-4)
    dew_point = np.broadcast_to(tape.dew_point, tape.hour.shape)[lit]
    columns = {name: getattr(tape, name)[lit] for name in ("month", "day", "hour", "direct", "diffuse")}
    tape = tape._replace(dew_point=dew_point, **columns)
    altitude, azimuth, day = sun_of(tape)
    direct, diffuse = (value.astype(np.float32).astype(np.float64) for value in (tape.direct, tape.diffuse))
    zenith = np.clip(np.pi / 2 - altitude, np.radians(3), np.pi / 2)
    clearness, brightness = conditions(direct, diffuse, zenith, day)
    index = np.searchsorted(table("perez_1993")[:, 0], clearness, side="right") - 1
    letters = letters_of(index, zenith, clearness, brightness)
    efficacy = table("perez_1990_efficacy")[index].T
    water = np.exp(0.07 * dew_point - 0.075)
    a, b, c, d = efficacy[4:8]
    diffuse_light = diffuse * (a + b * water + c * np.cos(zenith) + d * np.log(brightness))
    a, b, c, d = efficacy[8:12]
    beam = direct * np.maximum(a + b * water + c * np.exp(5.73 * zenith - 5) + d * brightness, 0)
    on_ground = diffuse_light + beam * np.maximum(np.sin(altitude), 0)
    return Skies(lit, letters, zenith, azimuth, diffuse_light, on_ground)


def conditions(
    direct: np.ndarray, diffuse: np.ndarray, zenith: np.ndarray, day: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Clearness and brightness within the program's limits, each (K,) (Perez 1990, eq. 1-2; orbit by Spencer 1971)."""
    turn = (day - 1) * (2 * np.pi / 365)
    orbit = 1.00011 + 0.034221 * np.cos(turn) + 0.00128 * np.sin(turn)
    orbit += 0.000719 * np.cos(2 * turn) + 0.000077 * np.sin(2 * turn)
    mass = 1 / (np.cos(zenith) + 0.15 * (93.885 - np.degrees(zenith)) ** -1.253)
    cube = 1.041 * zenith**3
    ratio = np.divide(direct, diffuse, out=np.full_like(direct, 1e9), where=diffuse > 0)
    return np.clip((1 + ratio + cube) / (1 + cube), 1, 11.9), np.clip(
        diffuse * mass / (SOLAR_CONSTANT * orbit), 0.01, 0.6
    )


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


def radiances(tape: Tape, division: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Indices (K,) of the lit hours and their radiances (J, K), W m-2 sr-1 of white: the ground, then the patches.

    The array is used again for the next patches.
    """
    skies = skies_of(tape)
    yield skies.lit, (GROUND_REFLECTANCE / np.pi / WHITE_EFFICACY * skies.on_ground)[None].astype(np.float32)
    total = horizontal_sums(skies, division)
    black = np.flatnonzero(total == 0)
    uniform = (skies.diffuse[black] / (WHITE_EFFICACY * np.pi)).astype(np.float32)
    level = np.divide(skies.diffuse, WHITE_EFFICACY * total, out=np.zeros_like(total), where=total > 0)
    for light, _, _ in patch_rows(skies, division, level):
        if black.size:
            light[:, black] = uniform
        yield skies.lit, light


def matrix(tape: Tape, division: int = 1) -> np.ndarray:
    """Radiances (144 n^2 + 2, T), float32, W m-2 sr-1 of white: the ground, then Reinhart's patches MF:n.

    What `gendaymtx -s -m n -c 1 1 1` makes, within 1e-5 of each value (its ground apart from the colour).
    """
    rows = np.zeros((144 * division**2 + 2, tape.hour.size), np.float32)
    first = 0
    for lit, light in radiances(tape, division):
        rows[first : first + len(light), lit] = light
        first += len(light)
    return rows


def coloured(tape: Tape, division: int, colour: tuple[float, float, float] = SKY_COLOUR) -> Iterator[np.ndarray]:
    """The same in Radiance's R, G, B, some patches at a time: (J, T, 3), float32, used again for the next."""
    for k, (lit, light) in enumerate(radiances(tape, division)):
        if k < 2:
            count = tape.hour.size
            index = np.full(count, lit.size)
            index[lit] = np.arange(lit.size)
            narrow = np.zeros((BLOCK // max(lit.size, 1) + 1, lit.size + 1, 3), np.float32)
            wide = np.empty((len(narrow), count, 3), np.float32)
            whole, pixels = wide.view("V12")[..., 0], narrow.view("V12")[..., 0]
        for channel in range(3):
            np.multiply(light, np.float32(1 if k == 0 else colour[channel]), out=narrow[: len(light), :-1, channel])
        for row in range(len(light)):
            np.take(pixels[row], index, out=whole[row], mode="clip")
        yield wide[: len(light)]


def tape_of(path: Any) -> Tape:
    """The tape in a WEA file, as gendaymtx reads it."""
    from skydome.year.tape import DEW_POINT, FIRST_LINE, RADIOMETRIC, read_tape

    head, rows = read_tape(path)
    month, day, hour, direct, diffuse = np.ascontiguousarray(rows.T)
    wrong = np.flatnonzero((month < 1) | (month > 12) | (day < 1) | (day > 31))
    if wrong.size:
        k = wrong[0]
        raise ValueError(f"{path}, line {FIRST_LINE + k}: no such date as month {month[k]:g}, day {day[k]:g}")
    place = (head["latitude"], -head["longitude"], -head["time_zone"] / 15)
    tape = Tape(month, day, hour, direct, diffuse, DEW_POINT, *place)
    if head["weather_data_file_units"] == RADIOMETRIC:
        return tape
    sine = np.sin(sun_of(tape)[0])
    return tape._replace(direct=np.where(sine > 0, direct / np.maximum(sine, 1e-9), direct))


def tape_from(weather: Any) -> Tape:
    """The tape that gendaymtx makes of a `Weather`: of an EPW with the mean dew point of three hours, else its own."""
    from skydome.year.calendar import month_day_hour

    direct, diffuse = weather.irradiances
    dew_point = np.where(np.isnan(weather.dew_point), 11.0, weather.dew_point)
    if weather.label == "end":
        dew_point = (dew_point + np.roll(dew_point, 1) + np.roll(dew_point, 2)) / 3
    place = weather.place
    return Tape(
        *month_day_hour(weather.local), direct, diffuse, dew_point, place.latitude, place.longitude, weather.utc_offset
    )
