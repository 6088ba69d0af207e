"""Older skies against what was published: gensky's formula, and Brunger and Hooper's own integral."""

import numpy as np
import pytest

import skydome as sd
from skydome.ground.quadrature import half_hemisphere_about
from skydome.ground.tables import columns

VIEWS = sd.direction(np.arange(12.0), np.linspace(0.02, 1.5, 12))


def test_gensky_of_option_i():
    """Radiance's skybright.cal, spelled out, relative to the zenith."""
    sun = sd.direction(1.0, 40 * sd.deg)
    sky = sd.MatsuuraIwata(sun, zenith_luminance=1000.0)
    eta, zt, gamma = np.arccos(VIEWS[:, 2]), np.pi / 2 - 40 * sd.deg, np.arccos(VIEWS @ sun)

    def formula(eta, gamma):
        first = (1.35 * np.sin(5.631 - 3.59 * eta) + 3.12) * np.sin(4.396 - 2.6 * zt) + 6.37 - eta
        return first / 2.326 * np.exp(gamma * -0.563 * ((2.629 - eta) * (1.562 - zt) + 0.812))

    np.testing.assert_allclose(sky.luminance(VIEWS), 1000 * formula(eta, gamma) / formula(0.0, zt), rtol=1e-9)
    assert (sd.CIEIntermediate(sun, 1000.0).luminance(VIEWS) == sky.luminance(VIEWS)).all()


@pytest.mark.parametrize("kind", [sd.MatsuuraIwata, sd.CIEIntermediate, sd.BrungerHooper])
def test_level_by_illuminance(kind):
    for elevation in (0.01, 0.3, 1.0, 1.57):
        sky = kind(sd.direction(1.0, elevation), illuminance=10_000.0)
        assert float(sd.illuminance(sky)) == pytest.approx(10_000.0, rel=2e-3)


def test_brunger_hoopers_integral_is_that_of_their_paper():
    """The numbers of all 48 kinds fit the closed form that the paper normalises by, within .8 %."""
    table = columns("brunger_hooper_1993")
    a0, a1, a2, a3 = (table[name][:, None] for name in ("a0", "a1", "a2", "a3"))
    assert len(a0) == 48
    for zenith in np.radians([0.01, 20.0, 45.0, 70.0, 89.0]):
        cosine, angle, weight = half_hemisphere_about(np.array(zenith), 32, 32)
        integral = ((a0 + a1 * cosine + a2 * np.exp(-a3 * angle)) * weight * cosine).sum(axis=1)
        b0, b1, b2, b3 = (part[:, 0] for part in (a0, a1, a2, a3))
        first = (1 + np.exp(-b3 * np.pi / 2)) / (b3**2 + 4)
        second = 1 - 2 * (1 - np.exp(-b3 * np.pi)) / (np.pi * b3 * (1 + np.exp(-b3 * np.pi / 2)))
        third = 2 * zenith * np.sin(zenith) - 0.02 * np.pi * np.sin(2 * zenith)
        published = np.pi * (b0 + 2 * b1 / 3) + 2 * b2 * first * (np.pi - second * third)
        np.testing.assert_allclose(published, integral, rtol=8e-3)


def test_brunger_hooper_takes_the_nearest_kind_sky_by_sky():
    suns = sd.direction(1.0, np.array([0.3, 0.6]))[:, None, :]
    day = sd.BrungerHooper(suns, diffuse_share=np.array([[0.9], [0.16]]), clearness=0.74, illuminance=1e4)
    one = sd.BrungerHooper(suns[1, 0], diffuse_share=0.15, clearness=0.75, illuminance=1e4)
    np.testing.assert_allclose(day.luminance(VIEWS)[1], one.luminance(VIEWS), rtol=1e-10)
    with pytest.raises(ValueError, match=r"clearness must lie in \[0, 1\], got 1.4"):
        sd.BrungerHooper(suns[1, 0], clearness=1.4, illuminance=1.0)
    with pytest.raises(ValueError, match="BrungerHooper takes either zenith_luminance"):
        sd.BrungerHooper(suns[1, 0])
