"""The sky of Mars by two methods: dust's Mie phase functions, sharp and changing with wavelength, in both."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd

pytest.importorskip("nanodisort")
WAVELENGTHS = [450.0, 650.0]
SUN = sd.direction(180 * sd.deg, 30 * sd.deg)
VIEWS = sd.direction(np.array([180, 180, 180, 90, 0]) * sd.deg, np.array([31, 35, 50, 30, 20]) * sd.deg)


@pytest.mark.slow
def test_path_tracer_and_discrete_ordinates_agree_in_the_flat_limit():
    air = sd.Atmosphere.mars()
    flat = replace(air, radius=air.radius * 1000)
    solved = sd.DiscreteOrdinates(SUN, air, streams=64).radiance(VIEWS, WAVELENGTHS)
    traced = sd.PathTraced(SUN, flat, relative_error=0.01).radiance(VIEWS, WAVELENGTHS)
    np.testing.assert_allclose(traced, solved, rtol=0.05)
    np.testing.assert_allclose(np.mean(traced / solved), 1, atol=0.015)


def test_one_bounce_is_single_scattering():
    air = sd.Atmosphere.mars()
    traced = sd.PathTraced(SUN, air, relative_error=0.01, orders=1).radiance(VIEWS, WAVELENGTHS)
    np.testing.assert_allclose(traced, sd.Nishita93(SUN, air).radiance(VIEWS, WAVELENGTHS), rtol=5e-3)


def test_held_it_keeps_its_colours():
    sky = sd.Nishita96(SUN, sd.Atmosphere.mars())
    np.testing.assert_allclose(sd.held(sky).xyz(VIEWS), sky.xyz(VIEWS), rtol=0.02)
