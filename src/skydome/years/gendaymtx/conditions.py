"""What gendaymtx makes of a tape's numbers: clearness, brightness, and light from irradiance or irradiance from light.

A second form of `skies.perez_all_weather` by that program's rules and limits (see `matrix`), with NumPy alone.
"""

import numpy as np

from skydome.ground.tables import columns
from skydome.ground.units import SOLAR_CONSTANT

SOLAR_LIGHT_CONSTANT = 127_500.0
"""Extraterrestrial illuminance, lx, as gendaymtx has it."""

LONGEST_STEP, MOST_STEPS = 10.0, 5
"""Irradiances are taken as found when they move by no more than 10 W m-2, or after 5 steps."""


def table(name: str) -> np.ndarray:
    """The numbers of a table of `ground/data`, (rows, columns)."""
    return np.stack(list(columns(name).values()), axis=-1)


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


def category(clearness: np.ndarray) -> np.ndarray:
    """Row of Perez's tables for each clearness, (K,)."""
    row: np.ndarray = np.searchsorted(table("perez_1993")[:, 0], clearness, side="right") - 1
    return row


def efficacies(
    row: np.ndarray, zenith: np.ndarray, brightness: np.ndarray, dew_point: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Luminous efficacy of direct and of diffuse light, lm W-1, each (K,) (Perez 1990, eq. 8 and 7)."""
    efficacy, water = table("perez_1990_efficacy")[row].T, np.exp(0.07 * dew_point - 0.075)
    a, b, c, d = efficacy[4:8]
    diffuse = a + b * water + c * np.cos(zenith) + d * np.log(brightness)
    a, b, c, d = efficacy[8:12]
    return np.maximum(a + b * water + c * np.exp(5.73 * zenith - 5) + d * brightness, 0), diffuse


def irradiances_of(
    direct_light: np.ndarray,
    diffuse_light: np.ndarray,
    zenith: np.ndarray,
    day: np.ndarray,
    dew_point: np.ndarray,
    longest: float = LONGEST_STEP,
    steps: int = MOST_STEPS,
) -> tuple[np.ndarray, np.ndarray]:
    """Direct and diffuse irradiance, W m-2, each (K,), that have these illuminances, lx, as gendaymtx finds them.

    From 93 lm W-1 it steps at most five times: efficacies of the irradiances before, irradiances by these efficacies.
    An hour stands still once both moved by 10 W m-2 or less; other limits are `longest` and `steps`. Direct efficacies
    up to 0.1 stand for the irradiance.
    """
    direct, diffuse = (light * (SOLAR_CONSTANT / SOLAR_LIGHT_CONSTANT) for light in (direct_light, diffuse_light))
    before = np.full((2, direct.size), 0.1)
    for _ in range(steps):
        k = np.flatnonzero((np.abs(np.stack([direct, diffuse]) - before) > longest).any(axis=0))
        if not k.size:
            break
        before[:, k] = direct[k], diffuse[k]
        clearness, brightness = conditions(direct[k], diffuse[k], zenith[k], day[k])
        beam, sky = efficacies(category(clearness), zenith[k], brightness, dew_point[k])
        diffuse[k] = diffuse_light[k] / sky
        direct[k] = np.where(beam > 0.1, direct_light[k] / np.maximum(beam, 0.1), beam)
    return direct, diffuse
