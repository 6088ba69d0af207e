"""Fits what ERFA's `moon98` lacks beside DE421 in 1950-2050: `src/skydome/ground/data/moon_corrections.csv`.

Needs skyfield and skyfield-data. Terms are taken six at a time, those that explain most of what is left.
"""

import itertools
from importlib.resources import files

import erfa
import numpy as np
from skyfield.api import load, load_file

from skydome.moon.geocentric import ARGUMENTS

INSTANTS, ROUNDS, J2000 = 6000, (22, 12), 2451545.0
RATIOS = (
    (18, -16), (10, -3), (1, -1), (2, -2), (3, -3), (3, -2), (8, -13), (5, -5), (4, -4), (2, -1), (3, -4), (5, -8),
    (8, -12), (2, -3), (18, -17), (18, -18), (20, -20), (21, -20), (10, -16),
)  # fmt: skip
JUPITER, MARS = (
    ((1, -1), (2, -2), (0, 1), (0, 2), (2, -3), (1, -2), (3, -3)),
    ((1, -2), (2, -2), (1, -1), (4, -8), (2, -4)),
)
BASES = (
    (0, 0, 0, 0), (0, 0, 1, 0), (0, 0, -1, 0), (2, 0, -1, 0), (2, 0, 0, 0), (0, 0, 1, 1), (0, 0, 0, 1), (1, 0, 0, 0),
    (2, 0, -2, 0), (0, 0, 2, 0),
)  # fmt: skip


def candidates():
    """Terms that may be taken, each by its eight whole numbers."""
    ranges = (range(7), range(-2, 3), range(-5, 6), range(-4, 5))
    own = [c for c in itertools.product(*ranges) if sum(map(abs, c)) <= 9 and c > (0, 0, 0, 0)]
    planets = [(v, e, 0, 0) for v, e in RATIOS] + [(0, e, j, 0) for e, j in JUPITER] + [(0, e, 0, m) for e, m in MARS]
    return np.array([(*c, 0, 0, 0, 0) for c in own] + [(*base, *p) for base in BASES for p in planets])


def lacking(days):
    """DE421 less `moon98` along the ecliptic and in latitude, arcsec, (2, N)."""
    ephemeris = load_file(str(files("skyfield_data") / "data" / "de421.bsp"))
    at = load.timescale(builtin=True).tt_jd(J2000 + days)
    true, series = (ephemeris["moon"] - ephemeris["earth"]).at(at).position.au.T, erfa.moon98(J2000, days)["p"]
    axes = erfa.ecm06(J2000, days)
    (a, b), (c, d) = (angles(np.einsum("nij,nj->ni", axes, v)) for v in (true, series))
    return np.stack([((a - c + np.pi) % (2 * np.pi) - np.pi) * np.cos(b), b - d]) * 648_000 / np.pi


def angles(v):
    """Longitude and latitude of vectors."""
    return np.arctan2(v[:, 1], v[:, 0]), np.arctan2(v[:, 2], np.hypot(v[:, 0], v[:, 1]))


def main():
    days = np.sort(np.random.default_rng(1).uniform(-18_200, 18_262, INSTANTS))
    names = ("fad03", "falp03", "fal03", "faf03", "fave03", "fae03", "faju03", "fama03")
    phases = candidates() @ np.stack([getattr(erfa, name)(days / 36525) for name in names])
    cosines, sines = np.cos(phases), np.sin(phases)
    print("quantity", *ARGUMENTS, "cosine", "sine", sep=",")
    for quantity, (wanted, rounds) in enumerate(zip(lacking(days), ROUNDS, strict=True)):
        rest, chosen = wanted.copy(), []
        for _ in range(rounds):
            power = (cosines @ rest) ** 2 + (sines @ rest) ** 2
            power[chosen] = 0
            chosen += np.argsort(power)[::-1][:6].tolist()
            terms = np.concatenate([cosines[chosen], sines[chosen], np.ones((1, days.size))]).T
            found = np.linalg.lstsq(terms, wanted, rcond=1e-6)[0]
            rest = wanted - terms @ found
        print(quantity, *[0] * 8, f"{found[-1]:.4f}", 0, sep=",")
        for k, term in enumerate(candidates()[chosen]):
            print(quantity, *term, f"{found[k]:.4f}", f"{found[len(chosen) + k]:.4f}", sep=",")


if __name__ == "__main__":
    main()
