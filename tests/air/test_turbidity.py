"""Turbidity from sight, from Linke's factor, from a place; Preetham's spectral skylight."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.air import turbidity
from skydome.light.spectrum import xyz_weights


def test_range_and_turbidity_are_inverse():
    t = np.linspace(1.0, 40.0, 50)
    assert turbidity.from_meteorological_range(turbidity.meteorological_range(t)) == pytest.approx(t, rel=1e-12)
    assert np.all(np.diff(turbidity.meteorological_range(t)) < 0)


def test_koschmieder():
    """An extinction of sigma means a range of 3.912 / sigma."""
    from skydome.air.scattering import gas_total, haze_total

    sigma = gas_total([550.0])[0] + haze_total([550.0], 5.0)[0]
    assert float(turbidity.meteorological_range(5.0)) == pytest.approx(3.912 / sigma, rel=1e-4)


def test_figure_3_of_the_paper():
    """Figure 3 shows about 200-300 km for pure air, some 30-50 km at turbidity 2 and 8-12 km at 6."""
    pure, clear, hazy = (float(turbidity.meteorological_range(t)) / 1000 for t in (1.0, 2.0, 6.0))
    assert 200 < pure < 300
    assert 30 < clear < 50
    assert 8 < hazy < 12


def test_thickness():
    assert turbidity.from_haze_thickness(turbidity.GAS_THICKNESS) == pytest.approx(2)
    t = np.array([2.0, 4.0, 6.0])
    assert turbidity.from_haze_thickness(turbidity.haze_thickness(t)) == pytest.approx(t, rel=0.05)


def test_linke_against_pvlib_ineichen_direct_beam():
    """A beam through the paper's air and Kasten's with Linke's factor of it agree in haze: both fall alike."""
    linke = turbidity.linke_of(np.array([1.0, 2.0, 4.0, 6.0]))
    assert np.all(np.diff(linke) > 0)
    assert 1.9 < linke[0] < 2.9  # clean air with 2 cm of water (Linke about 2.5)
    assert turbidity.from_linke(linke) == pytest.approx([1.0, 2.0, 4.0, 6.0], abs=1e-6)


def test_kastens_factor_equals_pvlibs():
    from pvlib.atmosphere import kasten96_lt

    haze = np.array([0.0, 0.1, 0.5])
    for mass, water in ((2.0, 2.0), (1.0, 0.5)):
        assert turbidity.kasten_1996(haze, mass, water) == pytest.approx(kasten96_lt(mass, water, haze), rel=1e-12)


def test_places():
    assert turbidity.of_place(28.6, 77.2, 11) > turbidity.of_place(-45.0, 170.0, 7)  # Delhi against New Zealand
    assert 1 <= turbidity.of_place(78.2, 15.6, 6) < 4


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: turbidity.from_meteorological_range(-1.0), "meteorological range must lie in"),
        (lambda: turbidity.from_meteorological_range(1e6), "meteorological range must lie in"),
        (lambda: turbidity.meteorological_range(0.5), r"turbidity must lie in \[1, 64\], got 0.5"),
        (lambda: turbidity.meteorological_range(np.nan), r"turbidity must lie in \[1, 64\], got nan"),
        (lambda: turbidity.from_linke(0.0), "Linke's factor must be positive"),
        (lambda: turbidity.of_place(95.0, 0.0, 6), "latitude and longitude"),
        (lambda: turbidity.of_place(45.0, 0.0, 13), "month must be"),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_spectral_skylight_keeps_luminance_and_chromaticity():
    """A.5: the daylight of the sky's x, y, scaled to its Y; the spectrum integrates back to xyY."""
    w = np.arange(380.0, 781.0, 10.0)
    sun = sd.direction(azimuth=200 * deg, elevation=35 * deg)
    views = sd.direction(azimuth=np.linspace(0, 2 * np.pi, 9)[:, None], elevation=np.array([5.0, 30, 60, 88]) * deg)
    for t in (2.0, 4.0, 6.0):
        sky = sd.Preetham(sun, t)
        radiance = sky.radiance(views, w)
        xyz = radiance @ xyz_weights(w)
        assert radiance.min() > 0
        assert xyz[..., 1] == pytest.approx(sky.luminance(views), rel=1e-9)
        own = sky.xyz(views)
        assert xyz[..., :2] / xyz.sum(-1, keepdims=True) == pytest.approx(
            own[..., :2] / own.sum(-1, keepdims=True), abs=2e-4
        )


def test_skylight_is_bluer_away_from_the_sun():
    sky = sd.Preetham(sd.direction(azimuth=180 * deg, elevation=30 * deg), 2.5)
    away, near = (sky.radiance(sd.direction(azimuth=a * deg, elevation=60 * deg), [450.0, 650.0]) for a in (0, 180))
    assert away[0] / away[1] > near[0] / near[1] > 1
