"""Make src/skydome/ground/data/mars_dust.npz: how the dust of Mars scatters, by wavelength. Needs miepython.

Extinction, scattering and asymmetry: `preprocessing/planets/mars/aux/dust.csv` of the program pyRT_DISORT (K. Connour),
which has its dust from M. J. Wolff (Wolff et al. 2009, "Wavelength dependence of dust aerosol single scattering albedo
as observed by the Compact Reconnaissance Imaging Spectrometer", J. Geophys. Res. 114, E00D04). The file does not state
the particles' size; the ratios of its extinctions fit an effective radius of 1.5 um (`tests/air/test_mars.py`).

Phase functions: Mie theory, effective radius 1.5 um (Lemmon et al. 2004, Science 306, 1753: 1.47 and 1.52), effective
variance 0.25 (Markiewicz et al. 1999, J. Geophys. Res. 104, 9009), refractive index 1.5 (Ehlers et al. 2014, Appl. Opt.
53, 1808, as Schneegans et al. 2024 have it), absorption index such that the single scattering albedo is Wolff's.
"""

from pathlib import Path

import numpy as np

from skydome.air.mie import MieParticles
from skydome.air.size_distributions import GammaSizes

TARGET = Path(__file__).parents[1] / "src" / "skydome" / "ground" / "data" / "mars_dust.npz"
WOLFF = np.array(
    [
        # nm, extinction, scattering (um2), asymmetry
        [321, 4.303, 2.909, 0.8375],
        [440, 4.404, 3.491, 0.7687],
        [460, 4.423, 3.576, 0.7620],
        [480, 4.436, 3.678, 0.7498],
        [500, 4.466, 3.798, 0.7404],
        [525, 4.468, 3.927, 0.7279],
        [550, 4.506, 4.080, 0.7133],
        [575, 4.515, 4.201, 0.7065],
        [600, 4.542, 4.326, 0.6929],
        [630, 4.583, 4.425, 0.6876],
        [700, 4.619, 4.510, 0.6806],
        [750, 4.663, 4.558, 0.6782],
        [800, 4.711, 4.603, 0.6770],
    ]
)
SIZES, INDEX = GammaSizes(1.5e-6, 0.25), 1.5


def absorption_index(wavelength: float, albedo: float) -> float:
    """The k that gives spheres of these sizes a single scattering albedo, by bisection in its logarithm."""
    low, high = 1e-5, 0.1
    for _ in range(20):
        middle = float(np.sqrt(low * high))
        too_clear = MieParticles(SIZES, INDEX, middle).optics([wavelength]).albedo[0] > albedo
        low, high = (middle, high) if too_clear else (low, middle)
    return low


def main() -> None:
    """Find k at each wavelength and write the table."""
    wavelengths, extinction, scattering, asymmetry = WOLFF.T
    albedo = scattering / extinction
    index = np.array([absorption_index(w, a) for w, a in zip(wavelengths, albedo, strict=True)])
    seen = [MieParticles(SIZES, INDEX, k, 1500).optics([w]) for w, k in zip(wavelengths, index, strict=True)]
    longest = max(len(one.moments) for one in seen)
    moments = np.stack([np.pad(one.moments[:, 0], (0, longest - len(one.moments))) for one in seen], axis=-1)
    np.savez_compressed(
        TARGET,
        wavelength_nm=wavelengths,
        extinction=extinction / extinction[wavelengths == 550],
        albedo=albedo,
        asymmetry=asymmetry,
        absorption_index=index,
        moments=moments.astype(np.float32),
    )
    print(TARGET, TARGET.stat().st_size, moments.shape, index.round(5).tolist())


if __name__ == "__main__":
    main()
