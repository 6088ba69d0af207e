"""Kepler's orbits of the planets for the explorer's page, fitted to ERFA's `plan94` over the years of the page.

Six elements and their rates: half axis, AU; e cos and e sin of the perihelion's longitude; sin i cos and sin i sin of
the node's; mean longitude, radians; a century, in the ecliptic of J2000.
"""

import numpy as np
from scipy.optimize import least_squares

from skydome.stars.planets import NUMBERS
from skydome.sun.geocentric import JULIAN_DAY_J2000

YEARS = np.arange(1950.0, 2060.0, 0.02)
OBLIQUITY = np.radians(84381.406 / 3600)


def place(elements: np.ndarray, centuries: np.ndarray) -> np.ndarray:
    """From the sun, AU, (N, 3), in the ecliptic of J2000."""
    a, k, h, q, p, longitude = (elements[:6, None] + elements[6:, None] * centuries)[:6]
    anomaly = longitude.copy()  # of the eccentric orbit, counted from the equinox
    for _ in range(12):
        anomaly = longitude + k * np.sin(anomaly) - h * np.cos(anomaly)
    root = 1 / (1 + np.sqrt(1 - k * k - h * h))
    x = a * ((1 - h * h * root) * np.cos(anomaly) + h * k * root * np.sin(anomaly) - k)
    y = a * ((1 - k * k * root) * np.sin(anomaly) + h * k * root * np.cos(anomaly) - h)
    turn = np.sqrt(np.maximum(1 - q * q - p * p, 0.0))
    out = p * x - q * y
    return np.stack([x - p * out / (1 + turn), y + q * out / (1 + turn), -out], axis=-1)


def known(name: str) -> np.ndarray:
    """The same by ERFA."""
    from erfa.ufunc import plan94

    vectors = plan94(JULIAN_DAY_J2000, (YEARS - 2000) * 365.25, NUMBERS[name])[0]["p"]
    c, s = np.cos(OBLIQUITY), np.sin(OBLIQUITY)
    return np.asarray(vectors @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]]).T)


def start(vectors: np.ndarray) -> np.ndarray:
    """Rough elements: a circle."""
    far = np.linalg.norm(vectors, axis=1).mean()
    turned = np.unwrap(np.arctan2(vectors[:, 1], vectors[:, 0]))
    rate, first = np.polyfit((YEARS - 2000) / 100, turned, 1)
    return np.array([far, 0, 0, 0, 0, first, 0, 0, 0, 0, 0, rate])


def orbit(name: str) -> tuple[np.ndarray, float]:
    """The elements and rates (12,) of a planet, and the greatest error of its direction from the sun, radians."""
    vectors, centuries = known(name), (YEARS - 2000) / 100
    size = np.linalg.norm(vectors, axis=1, keepdims=True)
    found = least_squares(lambda e: ((place(e, centuries) - vectors) / size).ravel(), start(vectors), x_scale="jac").x
    angle = np.linalg.norm(place(found, centuries) / size - vectors / size, axis=1)
    return found, float(angle.max())


if __name__ == "__main__":
    for planet in list(NUMBERS)[:6]:
        elements, error = orbit(planet)
        print(planet, elements.round(6).tolist(), f"{np.degrees(error):.4f} degrees")
