"""The physical sky from heights against DISORT's light inside the air: `python benchmarks/heights.py`.

DISORT looks up from levels in 30 flat layers, its beam in round ones, with 48 streams and no forward peak cut off
(aerosol of one lobe, g .7). Rows for docs/models/physical.md: rms and mean over 12 views from 10 degrees up, a cell for
each wavelength. Half a CPU minute.
"""

from dataclasses import replace

import nanodisort
import numpy as np

import skydome as sd
from skydome.ground.arrays import Array
from skydome.skies.physical import layers

HEIGHTS, WAVELENGTHS = np.array([0.0, 3000.0, 10_000.0, 20_000.0]), np.array([450.0, 550.0, 700.0])
ELEVATIONS, AZIMUTHS = np.array([10.0, 20.0, 40.0, 70.0]), np.array([0.0, 60.0, 180.0])
BETWEEN = (0.0015, 0.0035, 0.0075, 0.015, 0.025, 0.035, 0.055, 0.07, 0.09, 0.115, 0.145, 0.18, 0.23)


def from_within(air: sd.Atmosphere, sine: float, streams: int = 48) -> Array:
    """Radiance for a sun of irradiance 1 at `HEIGHTS`, sr-1, (heights, elevations, azimuths, W)."""
    layers.LEVELS = np.unique([*layers.LEVELS, *BETWEEN])[::-1]
    cut = layers.layered(air, WAVELENGTHS, streams)
    edges = layers.LEVELS * air.height
    light = np.zeros((HEIGHTS.size, ELEVATIONS.size, AZIMUTHS.size, WAVELENGTHS.size))
    for w in range(WAVELENGTHS.size):
        state = nanodisort.DisortState()
        state.nstr, state.nlyr, state.nmom = streams, len(cut.depth), streams
        state.ntau, state.numu, state.nphi = HEIGHTS.size, ELEVATIONS.size, AZIMUTHS.size
        state.usrtau = state.usrang = state.lamber = state.quiet = state.spher = True
        state.intensity_correction = state.old_intensity_correction = True
        state.planck = state.onlyfl = False
        state.umu0, state.phi0, state.fbeam, state.albedo = sine, 0.0, 1.0, float(air.albedo_at(WAVELENGTHS)[w])
        state.allocate()
        state.radius, state.zd = cut.radii[-1] / 1000, (cut.radii - cut.radii[-1]) / 1000
        state.dtauc, state.ssalb = cut.depth[:, w].copy(), cut.scattered[:, w].copy()
        state.pmom = cut.moments[:, :, w].copy()
        above = np.append(0.0, np.cumsum(cut.depth[:, w]))
        state.utau = np.sort([above[np.argmin(np.abs(edges - height))] for height in HEIGHTS])
        state.umu, state.phi = -np.sin(np.radians(ELEVATIONS))[::-1], AZIMUTHS
        state.solve()
        light[..., w] = np.moveaxis(np.asarray(state.uu), 0, 1)[::-1, ::-1]
    return light


def main() -> None:
    """Print the rows."""
    views = sd.direction(*(part.T for part in np.meshgrid(np.radians(AZIMUTHS), np.radians(ELEVATIONS), indexing="xy")))
    views = np.moveaxis(views, 0, 1)
    for elevation, depth, ground in ((60, 0.1, 0.2), (25, 0.1, 0.2), (25, 0.3, 0.6), (10, 0.1, 0.2)):
        air = replace(sd.Atmosphere.standard(depth, 0.7, albedo=ground), gases=None)
        sun = sd.direction(0.0, elevation * sd.deg)
        peer = from_within(air, float(sun[2]))
        for height, seen in zip(HEIGHTS, peer, strict=True):
            sky = sd.PhysicalSky.from_height(sun, float(height), air)
            off = 100 * (np.asarray(sky.radiance(views, WAVELENGTHS)) / air.sun_at(WAVELENGTHS) / seen - 1)
            rms, mean = np.sqrt(np.mean(off**2, axis=(0, 1))), off.mean(axis=(0, 1))
            cells = " | ".join(f"{a:.1f} ({b:+.1f})" for a, b in zip(rms, mean, strict=True))
            print(f"| {elevation}, {depth}, {ground} | {height / 1000:g} | {cells} |", seen[2, 1].round(5).tolist())


if __name__ == "__main__":
    main()
