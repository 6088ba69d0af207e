import numpy as np

import skydome as sd


def test_rods_see_no_colour_and_cones_see_what_is_there():
    grey = np.ones((4, 8, 3))
    bright = sd.EnvironmentMap(grey * [300.0, 100.0, 50.0])
    np.testing.assert_allclose(sd.night_vision(bright).pixels, bright.pixels, rtol=1e-6)
    dim = sd.EnvironmentMap(grey * [1e-3, 1e-4, 1e-5])
    other = sd.EnvironmentMap(grey * [1e-5, 1e-4, 1e-3])
    colours = [sd.night_vision(each).pixels[0, 0] for each in (dim, other)]
    shares = [colour / colour.sum() for colour in colours]
    np.testing.assert_allclose(shares[0], shares[1], atol=1e-6)  # one hue, whatever the light's own
    assert colours[1][1] > 3 * colours[0][1]  # blue is brighter for rods than red (Purkinje)
    white = sd.night_vision(sd.EnvironmentMap(grey * 1e-4)).pixels[0, 0] @ sd.SRGB.to_xyz[1]
    np.testing.assert_allclose(white, 1.15e-4, rtol=0.1)
