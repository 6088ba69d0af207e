"""Light of skies by sasktran2 (MIT), an independent program, for tests: tests/golden/sasktran2.csv.

    pip install -c constraints.txt sasktran2
    python scripts/judge_sasktran2.py

Its discrete ordinates (16 streams, light scattered once exactly in round shells), with three Stokes parameters: suns by
day alone. The air is that of the row's numbers at one wavelength: `Optics`.
"""

import csv
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import skydome as sd
from skydome.own_air.all_air.shells import PROFILES, RADIUS, TOP
from skydome.skies.all_air.taught_air import Optics, optics

FILE = Path(__file__).parents[1] / "tests" / "golden" / "sasktran2.csv"
WAVELENGTHS = np.array([400.0, 600.0])
SKIES = (
    (70, 0.05, 0.2, 300, 0.7, 1.3),
    (60, 0.15, 0.0, 330, 0.76, 1.3),
    (50, 0.3, 0.5, 280, 0.65, 1.0),
    (45, 0.02, 0.1, 350, 0.76, 1.3),
    (35, 0.1, 0.8, 300, 0.7, 1.5),
    (30, 0.2, 0.2, 250, 0.8, 0.8),
    (22, 0.05, 0.2, 400, 0.7, 1.3),
    (16, 0.1, 0.3, 330, 0.76, 1.3),
    (11, 0.4, 0.1, 300, 0.7, 1.2),
    (8, 0.08, 0.2, 330, 0.76, 1.3),
    (5, 0.15, 0.5, 300, 0.6, 1.3),
    (3, 0.05, 0.2, 330, 0.76, 1.3),
)
"""Sun's elevation, degrees; depth of aerosol at 550 nm, albedo of the ground, ozone, g, Angstrom's exponent."""
DEPOLARISATION, HIGH_ASYMMETRY = 0.0279, 0.7


def air_of(row: Sequence[float]) -> sd.Atmosphere:
    """The air of a row of `SKIES`, without the gases that have no optical depth of their own."""
    _, depth, albedo, ozone, g, angstrom = row
    return replace(sd.clear_air(depth, asymmetry=g, ozone=ozone, albedo=albedo, angstrom=angstrom), gases=None)


def views_of(number: int) -> tuple[np.ndarray, np.ndarray]:
    """Elevations and azimuths from the sun, degrees, rounded, of 40 views evenly over the dome."""
    random = np.random.default_rng((1976, number))
    high = np.degrees(np.arcsin(random.uniform(0.03, 1, 40)))
    return high.round(2), random.uniform(0, 360, 40).round(1)


def judged(
    air: Optics, sun: float, elevations: np.ndarray, azimuths: np.ndarray, streams: int = 16, levels: int = 81
) -> np.ndarray:
    """I, Q, U for a sun of irradiance 1, (views, wavelengths, 3); sun and views in degrees, azimuths from the sun."""
    import sasktran2 as sk

    heights = TOP * np.expm1(4.5 * np.linspace(0, 1, levels)) / np.expm1(4.5)
    config, sine = sk.Config(), float(np.sin(np.radians(sun)))
    config.num_stokes, config.num_streams, config.num_threads = 3, streams, 1
    config.num_singlescatter_moments = 64
    config.multiple_scatter_source = sk.MultipleScatterSource.DiscreteOrdinates
    config.single_scatter_source, config.delta_m_scaling = sk.SingleScatterSource.Exact, True
    round_air = sk.Geometry1D(
        sine, 0.0, RADIUS, heights, sk.InterpolationMethod.LinearInterpolation, sk.GeometryType.Spherical
    )
    rays = sk.ViewingGeometry()
    for elevation, azimuth in zip(np.radians(elevations), np.radians(azimuths), strict=True):
        rays.add_ray(sk.SolarAnglesObserverLocation(sine, float(azimuth), float(np.sin(elevation)), 0.1))
    given = sk.Atmosphere(round_air, config, numwavel=len(air.molecules), calculate_derivatives=False)
    fill(given, air, heights)
    return np.asarray(sk.Engine(config, round_air, rays).calculate_radiance(given)["radiance"]).transpose(1, 0, 2)


def fill(given: Any, air: Optics, heights: np.ndarray, polarised: bool = True) -> None:
    """Extinction, albedos, ground, and moments of the scattering matrix, or of the phase function alone."""
    density = np.stack([part.density(heights) for part in PROFILES])
    density /= np.trapezoid(density, heights, axis=1)[:, None]
    depths = np.stack([air.molecules, air.aerosol, air.stratospheric, air.absorbers])
    scattered = np.stack([air.molecules, air.aerosol * air.aerosol_albedo, air.stratospheric])
    extinction, each = np.einsum("kh,kn->hn", density, depths), np.einsum("kh,kn->khn", density[:3], scattered)
    total = each.sum(axis=0)
    given.storage.total_extinction[:], given.storage.ssa[:] = extinction, np.clip(total / extinction, 0, 1)
    share, orders = each / np.maximum(total, 1e-300), np.arange(given.leg_coeff.a1.shape[0])
    low = (2 * orders[:, None] + 1) * air.asymmetry ** orders[:, None]
    high = ((2 * orders + 1) * HIGH_ASYMMETRY**orders)[:, None] + 0 * low
    purity, spin = (1 - DEPOLARISATION) / (1 + DEPOLARISATION / 2), (orders >= 2)[:, None]

    def mixed(molecules: np.ndarray, own: np.ndarray, above: np.ndarray) -> np.ndarray:
        return molecules[:, None, None] * share[0] + np.einsum("ln,hn->lhn", own, share[1]) + above[:, None] * share[2]

    second = (orders == 2) * purity
    given.leg_coeff.a1[:] = mixed((orders == 0) + second / 2, low, high)
    given.surface.albedo[:] = air.ground
    if polarised:
        given.leg_coeff.a2[:] = mixed(3 * second, low * spin, high * spin)
        given.leg_coeff.a3[:] = mixed(0 * second, low * spin, high * spin)
        given.leg_coeff.b1[:] = mixed(np.sqrt(6) / 2 * second, 0 * low, 0 * high)


def main() -> None:
    """Writes the file."""
    with FILE.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["sky", "nm", "elevation", "azimuth", "I", "Q", "U"])
        for number, row in enumerate(SKIES):
            elevations, azimuths = views_of(number)
            found = judged(optics(air_of(row), WAVELENGTHS, np.zeros(1)), row[0], elevations, azimuths)
            for n, view in enumerate(zip(elevations, azimuths, strict=True)):
                for w, wavelength in enumerate(WAVELENGTHS):
                    out.writerow([number, int(wavelength), *view, *(f"{v:.4e}" for v in found[n, w])])
            print(number, row, flush=True)


if __name__ == "__main__":
    main()
