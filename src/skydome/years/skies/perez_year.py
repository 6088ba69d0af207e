"""Perez skies of every interval of a year, by the paper or with the limits of gendaylit: letters, levels and flags."""

from typing import NamedTuple

import numpy as np

from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.formula.perez_table import Compat, bins_about, guarded_letters
from skydome.skies.perez_all_weather import PerezAllWeather
from skydome.sun.day import is_day
from skydome.sun.track import SunTrack
from skydome.years.skies.dome_means import PerezSkies
from skydome.years.skies.status import status_of
from skydome.years.weather.sun_of_interval import lit_sun
from skydome.years.weather.tape import DEW_POINT
from skydome.years.weather.weather import Weather

BRIGHTEST = 0.6
"""Brightness up to which Perez's table was fitted, as gendaylit has it."""


class PerezYear(NamedTuple):
    """The sun and flags of T intervals; the K skies of the lit ones (indices `lit`) and their illuminances, lx.

    Lit are those with the sun up and light of any kind: where the sky sends none, its sun still shines.
    """

    lit: np.ndarray
    skies: PerezSkies
    diffuse: np.ndarray
    suns: np.ndarray
    times: np.ndarray
    share: np.ndarray
    direct: np.ndarray
    clearness: np.ndarray
    brightness: np.ndarray
    status: np.ndarray
    compat: Compat


def perez_year(weather: Weather, compat: Compat = "paper", track: SunTrack | None = None) -> PerezYear:
    """The year's skies; illuminances, clearness, brightness (K,) are of lit intervals with known irradiances."""
    sun = lit_sun(weather, track)
    direct, diffuse = weather.irradiances
    up = (sun.lit > 0) & is_day(sun.directions)
    lit = np.flatnonzero(up & ~weather.missing & (direct + diffuse > 0))
    dew_point = np.where(np.isnan(weather.dew_point), DEW_POINT, weather.dew_point)
    orbit = 1 / sun.distances**2
    sky = PerezAllWeather(
        sun.directions[lit],
        direct[lit],
        diffuse[lit],
        SOLAR_CONSTANT * orbit[lit],
        dew_point[lit],
        check="clamp",
        compat=compat,
    )
    clearness, brightness, zenith = sky.conditions()
    letters, bright, dark = guarded_letters(clearness, brightness, zenith, compat)
    marks = Marks(lit, at_limits(sky, clearness, brightness), bright, dark)
    status = flags_of(weather, up, sun.lit, marks)
    skies = PerezSkies(np.stack(letters), sky.formula_sun, sky.floor)
    beam, light = sky.direct_normal_illuminance, sky.diffuse_illuminance
    if weather.direct_illuminance is not None and weather.diffuse_illuminance is not None:
        beam, light = weather.direct_illuminance[lit], weather.diffuse_illuminance[lit]
    return PerezYear(
        lit, skies, light, sun.directions, sun.times, sun.lit, beam, clearness, brightness, status, compat
    )  # fmt: skip


class Marks(NamedTuple):
    """Which of the K lit intervals (indices `lit`) are held at a limit, bright overcast, dark."""

    lit: np.ndarray
    held: np.ndarray
    bright: np.ndarray
    dark: np.ndarray


def flags_of(weather: Weather, up: np.ndarray, share: np.ndarray, marks: Marks) -> np.ndarray:
    """The status of every interval, (T,)."""
    direct, diffuse = weather.irradiances
    return status_of(
        night=~up,
        missing=up & weather.missing,
        light_at_night=~up & (direct + diffuse > 0),
        negative=weather.negative,
        part_lit=up & (share < 1),
        no_diffuse=up & ~weather.missing & (diffuse <= 0),
        clamped=among(marks.lit, marks.held, weather.count),
        bright_overcast=among(marks.lit, marks.bright, weather.count),
        dark_sky=among(marks.lit, marks.dark, weather.count),
        no_dew_point=np.isnan(weather.dew_point),
    )


def at_limits(sky: PerezAllWeather, clearness: np.ndarray, brightness: np.ndarray) -> np.ndarray:
    """True where the limits of the table or of gendaylit are reached, (K,)."""
    if sky.compat == "paper":
        return brightness > BRIGHTEST
    free = PerezAllWeather(
        sky.sun,
        sky.direct_normal_irradiance,
        sky.diffuse_horizontal_irradiance,
        sky.extraterrestrial_irradiance,
        sky.dew_point,
        check="clamp",
    )
    before = free.conditions()
    held: np.ndarray = (before[0] != clearness) | (before[1] != brightness)
    return held


def among(rows: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    """Booleans (T,) with `values` at `rows` and False elsewhere."""
    every = np.zeros(count, bool)
    every[rows] = values
    return every


def neighbours(year: PerezYear, zenith: np.ndarray) -> tuple[PerezSkies, PerezSkies, np.ndarray]:
    """The skies with the letters of the bins below and above each clearness, and the weight (K,) of the upper ones.

    Ours, not the paper's: it takes away the jumps at the edges of the bins.
    """
    low, high, weight = bins_about(year.clearness)
    pair = []
    for centre in (low, high):
        letters = guarded_letters(centre, year.brightness, zenith, year.compat).letters
        pair.append(PerezSkies(np.stack(letters), year.skies.suns, year.skies.floor))
    return pair[0], pair[1], weight
