"""What happened in each hour of a year, as flags: nothing is black, missing or held at a limit in silence."""

import numpy as np

FLAGS = {
    "night": "the sun is down through the interval: light 0",
    "missing": "an irradiance is missing: light NaN",
    "light_at_night": "irradiance while the sun is down: left out",
    "negative": "an irradiance just below 0 counts as 0",
    "part_lit": "the sun is up in part of the interval: taken at the middle of that part",
    "no_diffuse": "sun up without diffuse irradiance: the sky is black, the sun is kept",
    "clamped": "clearness or brightness beyond the model's limits",
    "bright_overcast": "b of the formula came out positive and is held at 0",
    "dark_sky": "the formula is negative on 30 % of the dome or more: brightness taken as 0.2, as gendaylit has it",
    "uniform": "the formula is negative all over even so: a uniform sky",
    "cut_off": "the formula is negative in part of the sky, which is 0 there",
    "no_dew_point": "dew point missing: 11 degrees C",
    "twilight": "the sun is less than 18 degrees down: the light of the clear sky that lends its colour",
}
"""Name and meaning, from the lowest bit up."""

BITS = {name: 1 << k for k, name in enumerate(FLAGS)}


def status_of(**conditions: np.ndarray) -> np.ndarray:
    """Flags (T,), uint16, of boolean arrays by name.

    >>> status_of(night=np.array([True, False]), negative=np.array([True, True])).tolist()
    [9, 8]
    """
    total = np.zeros(len(next(iter(conditions.values()))), np.uint16)
    for name, condition in conditions.items():
        total |= np.where(condition, np.uint16(BITS[name]), np.uint16(0))
    return total


def counts(status: np.ndarray) -> dict[str, int]:
    """How many hours have each flag, those that occur."""
    found = {name: int(((status & bit) > 0).sum()) for name, bit in BITS.items()}
    return {name: count for name, count in found.items() if count}


def attributes() -> dict[str, object]:
    """The flags as the CF conventions write them."""
    return {
        "long_name": "what happened in the interval",
        "flag_masks": np.array(list(BITS.values()), np.uint16),
        "flag_meanings": " ".join(FLAGS),
    }
