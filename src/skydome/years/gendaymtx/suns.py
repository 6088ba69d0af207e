"""One light source for each hour with the sun up, as `gendaymtx -D` writes them, and their modifiers (`-M`)."""

from collections.abc import Iterator

import numpy as np

from skydome.ground.units import RADIANCE_EFFICACY
from skydome.years.gendaymtx.hours import SUN_RADIUS, Tape, in_the_sky, sun_of
from skydome.years.gendaymtx.matrix import Choices, skies_of
from skydome.years.gendaymtx.sun import unit_vectors

DIAMETER, SIZE = 2 * np.degrees(SUN_RADIUS), np.pi * SUN_RADIUS**2
"""Degrees and steradians."""


def sources(tape: Tape, choices: Choices) -> Iterator[tuple[str, str]]:
    """The source of each hour with the sun's disc in the sky, as text, and the name of its modifier.

    Hours without light have a black one. A source's number is the minute of the year.
    """
    altitude, azimuth = sun_of(tape, choices.minutes)
    skies = skies_of(tape, choices.solar, choices.minutes)
    beam = np.zeros(tape.hour.size)
    beam[skies.lit] = skies.beam if choices.sun is not None else 0.0
    minutes = 1440 * (tape.day_of_year - 1) + np.floor(tape.hour * 60 + 0.5).astype(np.int64)
    toward = unit_vectors(altitude, azimuth - np.radians(choices.rotation))
    for hour in np.flatnonzero(in_the_sky(altitude)):
        number, light = minutes[hour], f"{beam[hour] / (RADIANCE_EFFICACY * SIZE):.3e}"
        x, y, z = toward[hour]
        yield (
            f"\nvoid light solar{number}\n0\n0\n3 {light} {light} {light}\n"
            f"\nsolar{number} source sun{number}\n0\n0\n4 {x:.6f} {y:.6f} {z:.6f} {DIAMETER:.4f}\n",
            f"solar{number}\n",
        )
