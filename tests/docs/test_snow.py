"""The page on snow: what it says of grass and snow is what the skies give."""

import numpy as np
import pytest

import skydome as sd
from skydome.ground.quadrature import hemisphere


def test_snow_brightens_the_sky_as_the_page_says():
    views, _ = hemisphere(10, 24)
    sun = sd.direction(180 * sd.deg, 40 * sd.deg)
    for make, median, least, most, zenith in (
        (lambda a: sd.HosekWilkie(sun, 4.0, a), 1.44, 1.08, 1.98, 1.39),
        (lambda a: sd.PhysicalSky(sun, sd.Atmosphere.from_turbidity(4.0, albedo=a)), 1.48, 1.03, 3.55, 1.35),
    ):
        grass, snow = make(0.1), make(0.9)
        ratio = np.asarray(snow.luminance(views) / grass.luminance(views))
        assert (np.median(ratio), ratio.min(), ratio.max()) == pytest.approx((median, least, most), rel=0.01)
        assert float(snow.luminance(sd.ZENITH) / grass.luminance(sd.ZENITH)) == pytest.approx(zenith, rel=0.01)


def test_what_snow_adds_knows_no_sun():
    sun = sd.direction(180 * sd.deg, 40 * sd.deg)
    grass, snow = (sd.HosekWilkie(sun, 4.0, albedo) for albedo in (0.1, 0.9))
    around = sd.direction(np.array([0.0, 90.0, 180.0]) * sd.deg, 70 * sd.deg)
    added = np.asarray(snow.luminance(around) - grass.luminance(around))
    assert np.ptp(added) < 0.05 * added.mean()
    assert np.ptp(np.asarray(grass.luminance(around))) > 0.5 * float(grass.luminance(around).mean())
