"""Every compiled form against the one readable formula in float64."""

import numpy as np
import pytest

import skydome as sd
from skydome.dome.sky_rows import columns_from_sun
from skydome.ground.quadrature import hemisphere
from skydome.skies.formula import fast as fast_light
from skydome.skies.formula.fast import formula_light, odd_skies

pytest.importorskip("numba")

ELEVATIONS = [0.5, 1.0, 2.0, 4.9, 5.0, 12.0, 45.0, 80.0, 90.0]
BANDS_11 = np.arange(320.0, 721.0, 40.0)
WAVELENGTHS_60 = np.linspace(390.0, 710.0, 60)


@pytest.fixture
def always(monkeypatch):
    """Kernels for jobs of every size."""
    monkeypatch.setattr(fast_light, "LEAST_VALUES", 0)


def sun_at(elevation, azimuth=137.0):
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def views(sun):
    """Directions all over, at the horizon, at the sun and opposite, float64 rounded to float32 values."""
    random = np.random.default_rng(3)
    around = [sun, sun * [-1, -1, 1], *(sun + 0.01 * random.normal(size=(50, 3)))]
    around += list(sun * [-1, -1, 1] + 0.01 * random.normal(size=(50, 3)))
    level = sd.direction(np.linspace(0, 6.28, 60), np.repeat([0.0, 1e-4, 0.01], 20))
    every = np.concatenate([hemisphere(24, 48)[0], np.array(around), level, -hemisphere(3, 4)[0]])
    return sd.unit(every)


def tolerance(elevation):
    return 2e-6 if elevation >= 5 else 1e-5


def error(got, truth):
    """Largest error relative to the brightest channel of each direction."""
    scale = np.abs(truth).max(axis=-1, keepdims=True)
    return float((np.abs(got - truth) / np.where(scale > 0, scale, 1.0)).max())


MODELS = {
    "hosek-wilkie-rgb": lambda sun: sd.HosekWilkieRGB(sun, 3.2, 0.3),
    "hosek-wilkie-rgb-hazy": lambda sun: sd.HosekWilkieRGB(sun, 9.3, 0.7),
    "hosek-wilkie-rgb-clear": lambda sun: sd.HosekWilkieRGB(sun, 1.0, 0.0),
    "preetham": lambda sun: sd.Preetham(sun, 3.2),
    "cie-12": lambda sun: sd.Daylight(sd.CIE(sun, 12, zenith_luminance=3000.0)),
}


@pytest.mark.parametrize("elevation", ELEVATIONS)
@pytest.mark.parametrize("make", MODELS.values(), ids=MODELS.keys())
@pytest.mark.parametrize("azimuth", [0.0, 90.0, 137.0, 225.0 + 360 / 256], ids=["north", "east", "off", "edge"])
def test_maps(make, elevation, azimuth, always):
    height = 64
    sky = make(sun_at(elevation, azimuth))
    truth = sky.rgb(sd.Equirectangular().directions(height)[: height // 2])
    got = sd.render(sky, height).pixels
    assert got.dtype == np.float32
    assert error(got[: height // 2], truth) <= tolerance(elevation)
    assert np.ptp(got[height // 2 :], axis=(0, 1)).max() == 0
    structured = sd.render(sky, height, dtype=np.float64).pixels
    np.testing.assert_allclose(structured[: height // 2], truth, rtol=1e-9, atol=1e-9 * truth.max())


@pytest.mark.parametrize("elevation", ELEVATIONS)
@pytest.mark.parametrize("make", list(MODELS.values())[:4], ids=list(MODELS)[:4])
def test_directions(make, elevation, always):
    sun = sun_at(elevation)
    toward = views(sun)
    truth = make(sun).rgb(toward)
    got = make(sun).rgb(toward.astype(np.float32))
    assert got.dtype == np.float32
    assert error(got, truth) <= 3 * tolerance(elevation)  # directions themselves are rounded to float32 here


@pytest.mark.parametrize("elevation", [1.0, 20.0, 70.0])
def test_xyz_luminance_and_spectra(elevation, always):
    sun = sun_at(elevation)
    toward = views(sun)
    single = toward.astype(np.float32)
    for sky in (sd.HosekWilkie(sun, 3.2, 0.3), sd.Preetham(sun, 3.2)):
        assert error(sky.xyz(single), sky.xyz(toward)) <= 3 * tolerance(elevation)
        assert error(sky.luminance(single)[:, None], sky.luminance(toward)[:, None]) <= 3 * tolerance(elevation)
        assert error(sky.rgb(single, sd.ACESCG), sky.rgb(toward, sd.ACESCG)) <= 5 * tolerance(elevation)
        for wavelengths in (WAVELENGTHS_60, WAVELENGTHS_60[:11], [550.0]):
            truth = sky.radiance(toward, wavelengths)
            got = sky.radiance(single, wavelengths)
            assert got.shape == truth.shape
            assert error(got, truth) <= 3 * tolerance(elevation)
    bands = sd.HosekWilkie(sun, 3.2).radiance(single, BANDS_11)
    assert error(bands, sd.HosekWilkie(sun, 3.2).radiance(toward, BANDS_11)) <= 3 * tolerance(elevation)


def test_series_with_night_and_what_is_not_valid(always):
    suns = sun_at(np.array([-5.0, 0.0, 3.0, 30.0, 60.0]))[:, None]
    turbidity = np.array([[3.0], [3.0], [3.0], [9.0], [12.0]])
    toward = views(suns[3, 0])
    sky = sd.HosekWilkie(suns, turbidity, check="nan")
    got, truth = sd.luminance_series(sky, toward), sky.luminance(toward)
    assert (got[:2] == 0).all()
    assert np.isnan(got[4]).all()
    assert np.isnan(truth[4]).all()
    np.testing.assert_allclose(got[:4], truth[:4], rtol=1e-5)
    flat = sd.luminance_series(sd.HosekWilkie(suns[:, 0], turbidity[:, 0], check="nan"), toward)
    np.testing.assert_array_equal(flat, got)


def test_series_of_many_models_at_once(always):
    random = np.random.default_rng(0)
    suns = sd.direction(random.uniform(0, 6, 500), random.uniform(0.1, 1.5, 500))[:, None]
    letters = [random.uniform(low, high, (500, 1)) for low, high in
               [(-1.0, 0.5), (-1.0, 0.0), (0.0, 15.0), (-6.0, -0.5), (0.0, 0.6)]]  # fmt: skip
    sky = sd.Perez(suns, *letters, zenith_luminance=np.full((500, 1), 3000.0))
    toward = hemisphere(8, 16)[0]
    got, truth = sd.luminance_series(sky, toward), sky.luminance(toward)
    scale = np.maximum(truth, 1e-3 * truth.max(axis=1, keepdims=True) + 1e-9)
    assert (np.abs(got - truth) / scale).max() < 2e-5
    monthly = sky.flat_numbers(sky.luminance_recipe())
    np.testing.assert_allclose(formula_light(monthly, toward)[..., 0], truth, rtol=1e-12)


@pytest.mark.parametrize("count", [1, 31, 2047, 2048, 2049, 5000])
def test_blocks_of_every_length(count, always):
    sun = sun_at(30.0)
    toward = sd.unit(np.abs(np.random.default_rng(count).normal(size=(count, 3))))
    sky = sd.HosekWilkieRGB(sun, 3.0)
    assert error(sky.rgb(toward.astype(np.float32)), sky.rgb(toward)) < 6e-6


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("sun_column", [0.0, 0.5, 1.0, 7.5, 12.0, 31.5, 63.0, 63.5, 20.3])
def test_each_column_is_written_once(mirrored, sun_column):
    projection = sd.Equirectangular(azimuth_left=0.7, mirrored=mirrored)
    height, width = 32, 64
    sun = sd.direction(projection.azimuths(sun_column, height), 0.5)
    columns = columns_from_sun(projection, height, sun)
    written = np.zeros(width, int)
    for start, count, column, image in columns.segments:
        written[column : column + count] += 1
        if image >= 0:
            written[image : image + count] += 1
            mirrored_from = projection.azimuths(np.arange(image, image + count) + 0.5, height)[::-1]
            cosine = np.cos(mirrored_from - projection.azimuths(sun_column, height))
            np.testing.assert_allclose(cosine, 1 - columns.turn[0, start : start + count], atol=1e-12)
    assert (written == 1).all()
    assert len(columns.turn[0]) == (width if sun_column == 20.3 else width // 2 + (sun_column % 1 == 0.5))


def test_skies_beyond_the_kernels_come_from_the_formula(always, monkeypatch):
    usual = np.array([[[1.0, -1.0, -0.3, 1.0, 5.0, -3.0, 0.4, 0.0, 0.0, 0.0]]])
    assert not odd_skies(usual).any()
    for column, value in ((2, 0.1), (5, -100.0), (5, 20.0), (0, np.nan)):
        wrong = usual.copy()
        wrong[..., column] = value
        assert odd_skies(wrong).all()
    monkeypatch.setattr(fast_light, "MOST_ODD", 0.6)
    suns = sun_at(np.array([30.0, 50.0]))[:, None]
    sky = sd.Perez(suns, -1.0, -0.3, 5.0, np.array([[-3.0], [-100.0]]), 0.4, zenith_luminance=1000.0)
    toward = hemisphere(6, 12)[0]
    np.testing.assert_allclose(sd.luminance_series(sky, toward), sky.luminance(toward), rtol=2e-6)


def test_powers_and_angles():
    import numba

    from skydome.ground.elementary_kernel import power_less
    from skydome.skies.formula.nine_numbers_kernel import angle as small_and_large

    power = numba.njit(lambda x: power_less(x, np.float32(1.0)))
    angle_of = numba.njit(lambda u, w: small_and_large(u, w))
    x = np.concatenate([np.linspace(-125, 100, 2001), np.geomspace(1e-20, 1, 50), -np.geomspace(1e-20, 1, 50)])
    x = x.astype(np.float32)
    got = np.array([power(value) for value in x], dtype=np.float64)
    np.testing.assert_allclose(got, np.expm1(np.log(2) * x.astype(np.float64)), rtol=2.5e-7, atol=1e-30)
    angle = np.concatenate([np.geomspace(1e-6, 3, 500), np.pi - np.geomspace(1e-6, 1, 300)])
    u, w = 2 * np.sin(angle / 2) ** 2, 2 * np.cos(angle / 2) ** 2
    got = np.array([angle_of(np.float32(a), np.float32(b)) for a, b in zip(u, w, strict=True)], np.float64)
    np.testing.assert_allclose(got, angle, rtol=2.5e-7)
