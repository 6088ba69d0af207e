"""`out=`, precision, shapes and bad input of the fast paths; and the package without Numba."""

import sys

import numpy as np
import pytest

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.skies.formula import fast as fast_light

SUN = sd.direction(2.0, 0.6)
VIEWS = hemisphere(12, 24)[0]
SINGLE = VIEWS.astype(np.float32)
SKY = sd.HosekWilkie(SUN, 3.0)
HOURS = sd.HosekWilkie(sd.direction(2.0, np.array([-0.2, 0.3, 0.9]))[:, None], 3.0)


@pytest.fixture(params=["formula", "kernels"])
def path(request, monkeypatch):
    if request.param == "kernels":
        pytest.importorskip("numba")
        monkeypatch.setattr(fast_light, "LEAST_VALUES", 0)
    return request.param


@pytest.fixture
def without_numba(monkeypatch):
    monkeypatch.setattr(fast_light, "LEAST_VALUES", 0)
    monkeypatch.setitem(sys.modules, "numba", None)


def test_precision_follows_the_directions_or_out(path):
    for sky in (SKY, sd.Preetham(SUN, 3.0), sd.HosekWilkieRGB(SUN, 3.0)):
        assert sky.rgb(SINGLE).dtype == np.float32
        assert sky.rgb(VIEWS).dtype == np.float64
        out = np.empty(VIEWS.shape, np.float32)
        assert sky.rgb(VIEWS, out=out) is out
        np.testing.assert_allclose(out, sky.rgb(VIEWS), rtol=2e-5, atol=1e-5 * out.max())
    double = np.empty(VIEWS.shape)
    np.testing.assert_array_equal(SKY.xyz(VIEWS, out=double), SKY.xyz(VIEWS))


def test_every_method_writes_into_out(path):
    wavelengths = [450.0, 550.0, 650.0]
    out = np.empty((*VIEWS.shape[:-1], 3), np.float32)
    np.testing.assert_array_equal(SKY.radiance(SINGLE, wavelengths, out=out), SKY.radiance(SINGLE, wavelengths))
    one = np.empty(len(VIEWS), np.float32)
    SKY.luminance(SINGLE, out=one)
    np.testing.assert_array_equal(one, SKY.luminance(SINGLE))
    strided = np.zeros((len(VIEWS), 2), np.float32)
    SKY.luminance(SINGLE, out=strided[:, 0])
    np.testing.assert_array_equal(strided[:, 0], one)
    assert (strided[:, 1] == 0).all()
    series = np.empty((3, len(VIEWS)), np.float32)
    assert sd.luminance_series(HOURS, VIEWS, out=series).base is series
    np.testing.assert_allclose(series, HOURS.luminance(VIEWS), rtol=1e-5)


def test_maps_are_made_in_place(path):
    out = np.empty((32, 64, 3), np.float32)
    shown = sd.render(SKY, 32, out=out)
    assert shown.pixels is out
    np.testing.assert_array_equal(out, sd.render(SKY, 32).pixels)
    sd.render(SKY + sd.SunDisc.of(SKY), 32, out=out)
    first = out.copy()
    sd.render(SKY + sd.SunDisc.of(SKY), 32, out=out)
    np.testing.assert_array_equal(out, first)


@pytest.mark.parametrize(
    "projection", [sd.Fisheye(), sd.CubeMap(), sd.EqualAreaSquare()], ids=["fisheye", "cube", "square"]
)
def test_other_layouts_and_sums(projection, path):
    blend = sd.blend(SKY, sd.Daylight(sd.MoonSpencer(zenith_luminance=5000.0)), 0.3)
    height = 36 if isinstance(projection, sd.CubeMap) else 32
    for sky in (SKY, SKY * 2.0, blend, sd.Daylight(sd.CIE(SUN, 12, zenith_luminance=3000.0))):
        single = sd.render(sky, height, projection=projection).pixels
        double = sd.render(sky, height, projection=projection, dtype=np.float64).pixels
        np.testing.assert_allclose(single, double, rtol=2e-5, atol=1e-5 * double.max())


def test_sums_of_formula_skies_in_rows(path):
    both = sd.HosekWilkie(SUN, 3.0) + 0.5 * sd.Preetham(SUN, 3.0)
    directions = sd.Equirectangular().directions(32)[:16]
    np.testing.assert_allclose(sd.render(both, 32).pixels[:16], both.rgb(directions), rtol=1e-5, atol=1e-2)


def test_works_without_numba(without_numba):
    assert fast_light.kernels() is None
    np.testing.assert_allclose(SKY.rgb(SINGLE), SKY.rgb(VIEWS), rtol=1e-5, atol=1e-2)
    assert sd.render(SKY, 32).pixels.dtype == np.float32
    np.testing.assert_allclose(sd.luminance_series(HOURS, VIEWS), HOURS.luminance(VIEWS), rtol=1e-5)


def read_only(shape):
    array = np.zeros(shape, np.float32)
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    ("out", "error", "message"),
    [
        (np.zeros((5, 3), np.float32), ValueError, r"out must have shape \(\d+, 3\), got \(5, 3\)"),
        (np.zeros(VIEWS.shape, np.int32), TypeError, "out must be a NumPy array of float32 or float64, got int32"),
        (np.zeros(VIEWS.shape, np.float16), TypeError, "out must be .* got float16"),
        ([0.0], TypeError, "out must be .* got list"),
        (read_only(VIEWS.shape), ValueError, "out must be writable, got a read-only array"),
    ],
)
def test_unusable_out(out, error, message, path):
    with pytest.raises(error, match=message) as caught:
        SKY.rgb(SINGLE, out=out)
    assert "\n" not in str(caught.value)


def test_bad_directions(path):
    wrong = SINGLE.copy()
    wrong[-1, 0] = np.nan
    for bad in (wrong, SINGLE * 2):
        with pytest.raises(ValueError, match="directions must be finite unit vectors"):
            SKY.rgb(bad)
        with pytest.raises(ValueError, match="directions must be finite unit vectors"):
            sd.luminance_series(HOURS, bad)
    with pytest.raises(ValueError, match=r"directions must have shape \(..., 3\), got \(4,\)"):
        SKY.rgb(np.zeros(4, np.float32))
    with pytest.raises(ValueError, match=r"directions must have shape \(D, 3\), got \(3,\)"):
        sd.luminance_series(HOURS, sd.ZENITH)
    with pytest.raises(ValueError, match="out must have shape"):
        sd.luminance_series(HOURS, VIEWS, out=np.zeros((2, 2), np.float32))


def test_whole_numbers_and_nothing_at_all(path):
    assert SKY.rgb(np.array([[0, 0, 1]])).dtype == np.float64
    assert SKY.rgb(np.zeros((0, 3), np.float32)).shape == (0, 3)
    assert SKY.luminance(np.zeros((4, 0, 3), np.float32)).shape == (4, 0)
    assert sd.luminance_series(HOURS, np.zeros((0, 3))).shape == (3, 0)


def test_paired_suns_and_directions_do_not_mix(path):
    suns = sd.direction(2.0, np.linspace(0.1, 1.0, 5))
    views = SINGLE[:5]
    np.testing.assert_allclose(
        sd.HosekWilkie(suns, 3.0).luminance(views), sd.HosekWilkie(suns, 3.0).luminance(VIEWS[:5]), rtol=1e-5
    )
    grid = SINGLE.reshape(2, -1, 1, 1, 3)  # directions lead, hours follow: no kernel, the same light
    np.testing.assert_allclose(
        HOURS.luminance(grid)[1, 5, :, 0], HOURS.luminance(VIEWS)[:, len(VIEWS) // 2 + 5], rtol=1e-5
    )
