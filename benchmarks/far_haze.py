"""Far haze over the horizon of its physical sky: `python benchmarks/far_haze.py`; rows for docs/aerial-perspective.md.

For each air and sun the light of an endless level ray over that of the sky at its horizon, least and most over six
azimuths and 450, 550, 650 nm: haze by its own scattering, haze that melts into the horizon, and land of half the sky's
brightness at 60 km. The ground's albedo is 0.2 in all.
"""

import numpy as np

import skydome as sd
from skydome.haze.horizon_light import HORIZON

WAVELENGTHS = [450.0, 550.0, 650.0]
TURNS = np.arange(6) * 60 * sd.deg
LEVEL, BEHIND = sd.direction(TURNS, 0.0), sd.direction(TURNS, HORIZON)
AIRS = {
    "aerosol .1": sd.clear_air(),
    "aerosol .3": sd.clear_air(aerosol_depth=0.3),
    "continental": sd.Atmosphere.continental(),
    "maritime": sd.Atmosphere.maritime(),
    "desert": sd.Atmosphere.desert(),
    "urban": sd.Atmosphere.urban(),
}


def cell(ratio: np.ndarray) -> str:
    """Least and most of a ratio."""
    return f"{ratio.min():.3f}-{ratio.max():.3f}"


def main() -> None:
    """Print the rows."""
    for name, air in AIRS.items():
        for elevation in (60.0, 20.0, 5.0, 0.0, -4.0):
            sky = sd.PhysicalSky(sd.direction(0.0, elevation * sd.deg), air)
            horizon, whole = sky.radiance(BEHIND, WAVELENGTHS), sky + sd.SunDisc.of(sky)
            own, melted = (
                sd.AirLight(whole, WAVELENGTHS, ground_albedo=0.2, meets_horizon=meets) for meets in (False, None)
            )
            far = melted.at(60e3, LEVEL).seen(horizon / 2) / horizon
            ratios = [light.at(1e8, LEVEL).inscattered / horizon for light in (own, melted)]
            print(f"| {name} | {elevation:g} | {' | '.join(map(cell, [*ratios, far]))} |", flush=True)


if __name__ == "__main__":
    main()
