"""Colours from eleven wavelengths against the whole spectrum, in random air; work in blocks against work at once."""

import numpy as np

import skydome as sd
from skydome.skies.all_air import many_suns
from skydome.skies.colour_sky import SpectralSky


def test_eleven_wavelengths_are_the_spectrum():
    random, errors = np.random.default_rng(5), []
    views = sd.direction(random.uniform(0, 2 * np.pi, 20), np.arcsin(random.uniform(0.02, 1, 20)))
    for elevation in (-12.0, -5.0, -1.0, 3.0, 15.0, 60.0):
        ozone, albedo, angstrom = random.uniform(200, 450), random.uniform(0, 0.8), random.uniform(0.3, 1.8)
        air = sd.clear_air(random.uniform(0.02, 0.6), ozone=ozone, albedo=albedo, angstrom=angstrom)
        sky = sd.PhysicalSky(sd.direction(1.0, elevation * sd.deg), air)
        wanted = SpectralSky.xyz(sky, views)
        errors.append((sky.xyz(views) - wanted) / wanted)
    rms = np.sqrt(np.mean(np.square(errors), axis=(0, 1)))
    assert (rms < [3e-4, 8e-4, 3e-4]).all()
    assert np.abs(errors).max() < 4e-3


def test_blocks_are_the_whole(monkeypatch):
    suns = sd.direction(0.5, np.radians([-20.0, -5.0, 2.0, 40.0]))[:, None, :]
    views = sd.direction(np.linspace(0, 6, 7), np.linspace(0.1, 1.5, 7))
    sky = sd.PhysicalSky(suns, sd.clear_air(np.array([[0.1], [0.2], [0.3], [0.05]])))
    whole = sky.xyz(views)
    monkeypatch.setattr(many_suns, "FEW", 5)
    np.testing.assert_allclose(sky.xyz(views), whole, rtol=1e-12)
    assert (whole[0] == 0).all()
    assert (whole[1:] > 0).all()
