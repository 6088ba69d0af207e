"""Make src/skydome/ground/data/cloud_droplets.npz: how clouds of water scatter, by droplet size. Needs miepython.

Mie theory over Hansen's gamma distribution of an effective variance of 0.1 (Hansen 1971, J. Atmos. Sci. 28, 1400: fair
weather cumulus; the value of MODIS' and most other tables). Refractive index: Segelstein 1981, "The complex refractive
index of water", M.S. thesis, University of Missouri-Kansas City, as miepython carries the table.

Extinction over that at 550 nm, 1 - single scattering albedo and asymmetry by radius and wavelength; the logarithm of
the phase function by radius, wavelength and angle. 1500 radii a distribution. Two minutes of one core.
"""

import os
from importlib.resources import files
from pathlib import Path

os.environ["MIEPYTHON_USE_JIT"] = "1"

import numpy as np

from skydome.air.clouds.phases import Droplets
from skydome.air.mie import angular, coefficients
from skydome.air.series.legendre import legendre
from skydome.air.size_distributions import GammaSizes

TARGET = Path(__file__).parents[1] / "src" / "skydome" / "ground" / "data" / "cloud_droplets.npz"
RADII = np.array([4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0, 25.0])
"""Effective radii, um."""
VARIANCE = 0.1
WAVELENGTHS = np.concatenate(
    [np.arange(300, 700, 50), np.arange(700, 1300, 50), np.arange(1300, 1600, 25), np.arange(1600, 2501, 50)]
).astype(float)
PHASES = np.array([300, 400, 500, 600, 700, 850, 1050, 1300, 1450, 1650, 1850, 1950, 2200, 2500], dtype=float)
"""Wavelengths at which the phase function is kept, nm."""
COUNT = 1500


def water(wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Refractive index n and k at wavelengths (W,), nm: n linear, k in its logarithm."""
    text = (files("miepython") / "data" / "segelstein81_index.txt").read_text()
    rows = np.array([[float(cell) for cell in line.split()] for line in text.splitlines()[4:] if line.strip()])
    known, n, k = rows.T
    return np.interp(wavelengths / 1000, known, n), np.exp(np.interp(wavelengths / 1000, known, np.log(k)))


def seen(radius: float, wavelength: float, angles: np.ndarray | None) -> tuple[float, float, float, np.ndarray | None]:
    """Extinction (m2 a droplet), 1 - albedo, asymmetry, and the phase function at angles (M,), sr-1."""
    sizes, share = GammaSizes(radius * 1e-6, VARIANCE).nodes(COUNT)
    n, k = (part[0] for part in water(np.array([wavelength])))
    a, b = coefficients(complex(n, -k), 2 * np.pi * sizes / (wavelength * 1e-9))
    order = np.arange(1, a.shape[1] + 1)
    unit = (wavelength * 1e-9) ** 2 / (2 * np.pi)  # Bohren and Huffman 1983, eq. 4.61, 4.62
    extinction = unit * share @ ((a + b).real @ (2 * order + 1))
    scattering = unit * share @ ((np.abs(a) ** 2 + np.abs(b) ** 2) @ (2 * order + 1))
    return (
        extinction,
        1 - scattering / extinction,
        forward(a, b, share) * 2 * unit / scattering,
        phase(a, b, share, angles),
    )


def forward(a: np.ndarray, b: np.ndarray, share: np.ndarray) -> float:
    """Mean cosine times scattering (Bohren and Huffman 1983, section 4.5, `Asymmetry parameter`), over 2 units."""
    n = np.arange(1, a.shape[1] + 1)
    steps = (n * (n + 2) / (n + 1))[:-1]
    first = (a[:, :-1] * a[:, 1:].conj() + b[:, :-1] * b[:, 1:].conj()).real @ steps
    second = (a * b.conj()).real @ ((2 * n + 1) / (n * (n + 1)))
    return float(share @ (first + second))


def phase(a: np.ndarray, b: np.ndarray, share: np.ndarray, angles: np.ndarray | None) -> np.ndarray | None:
    """Phase function at angles (M,), in any unit."""
    if angles is None:
        return None
    cosine = np.cos(np.clip(angles, 1e-4, np.pi - 1e-4))
    pi, tau = angular(legendre(a.shape[1] + 2, cosine), cosine)
    order = np.arange(1, a.shape[1] + 1)
    factor = (2 * order + 1) / (order * (order + 1))
    total = np.zeros(angles.size)
    for k in range(0, len(share), 50):
        across = (a[k : k + 50] * factor) @ pi + (b[k : k + 50] * factor) @ tau
        along = (a[k : k + 50] * factor) @ tau + (b[k : k + 50] * factor) @ pi
        total += share[k : k + 50] @ (np.abs(across) ** 2 + np.abs(along) ** 2)
    return total


def main() -> None:
    """Work out every size and write the table."""
    together = np.union1d(WAVELENGTHS, np.union1d(PHASES, [550.0]))
    angles = np.radians(Droplets.angles.knots)
    numbers, phases = np.zeros((3, RADII.size, together.size)), np.zeros((RADII.size, PHASES.size, angles.size))
    for i, radius in enumerate(RADII):
        for j, wavelength in enumerate(together):
            kept = wavelength in PHASES
            *numbers[:, i, j], found = seen(radius, wavelength, angles if kept else None)
            if found is not None:
                phases[i, np.flatnonzero(wavelength == PHASES)[0]] = np.log(found)
        print(radius, numbers[2, i, :12].round(4), flush=True)
    numbers[0] /= numbers[0][:, together == 550.0]
    np.savez_compressed(
        TARGET,
        radius_um=RADII,
        wavelength_nm=together,
        extinction=numbers[0].astype(np.float32),
        log_coalbedo=np.log(np.maximum(numbers[1], 1e-9)).astype(np.float32),
        asymmetry=numbers[2].astype(np.float32),
        phase_wavelength_nm=PHASES,
        log_phase=phases.astype(np.float16),
    )
    print(TARGET, TARGET.stat().st_size)


if __name__ == "__main__":
    main()
