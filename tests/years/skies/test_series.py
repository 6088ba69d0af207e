"""A year as a Dataset: levels, true means, flags, the other programs' rules, colour and spectrum."""

import colour
import numpy as np
import pytest

import skydome as sd
from skydome.dome.patch_means import patch_means
from skydome.dome.patches import patches
from skydome.ground.units import RADIANCE_EFFICACY
from skydome.light.action_spectra import melanopic_edi, melanopic_sensitivity, photosynthetic_photons
from skydome.light.spectrum import xyz_weights
from skydome.years.gendaymtx import hours
from skydome.years.gendaymtx import matrix as gendaymtx
from skydome.years.skies.dome_means import PerezSkies, by_numpy, dome_means, samples_of
from skydome.years.skies.perez_year import perez_year
from skydome.years.skies.series import year
from skydome.years.skies.status import BITS, counts
from skydome.years.weather.reading import read_weather


@pytest.fixture(scope="session")
def plain(greensboro):
    return year(greensboro)


def test_irradiances_are_reproduced(plain, greensboro):
    direct, diffuse = greensboro.irradiances
    sky = perez_year(greensboro)
    given = (plain.luminance @ plain.horizontal_solid_angle).values[sky.lit]
    bright = diffuse[sky.lit] > 0
    assert (given[~bright] == 0).all()
    assert np.max(np.abs(given[bright] / sky.diffuse[bright] - 1)) < 1e-4
    shining = sky.direct > 0
    beam_efficacy = sky.direct[shining] / direct[sky.lit][shining]
    beam = plain.direct_normal_illuminance.values[sky.lit][shining] / beam_efficacy
    assert np.allclose(beam, direct[sky.lit][shining], rtol=1e-9)


@pytest.mark.parametrize("name", ["tregenza", "reinhart:4"])
def test_means_are_true_ones(greensboro, name):
    """Against the dome's adaptive means of the public sky, for 12 hours of all kinds; levels set equal."""
    sky = perez_year(greensboro)
    chosen = np.linspace(5, len(sky.lit) - 5, 12).astype(int)
    cut = patches(name)
    part = PerezSkies(sky.skies.letters[:, chosen], sky.skies.suns[chosen], sky.skies.floor)
    ours = dome_means(part, sky.diffuse[chosen], cut)
    for k, hour in enumerate(sky.lit[chosen]):
        public = sd.PerezAllWeather(
            sky.suns[hour], greensboro.direct_normal[hour], greensboro.diffuse_horizontal[hour],
            1367 / sd.earth_sun_distance(sky.times[hour]) ** 2, greensboro.dew_point[hour],
        )  # fmt: skip
        true = patch_means(public, cut, tolerance=1e-4)
        level = (true @ cut.horizontal_solid_angles) / sky.diffuse[chosen[k]]
        assert abs(level - 1) < (0.03 if name == "tregenza" else 0.002)
        difference = np.abs(ours[k] * level / np.maximum(true, 0.02 * true.mean()) - 1)[true > 0.02 * true.mean()]
        assert np.median(difference) < 4e-4
        assert np.max(difference) < 0.005


@pytest.mark.parametrize("centres", [True, False])
def test_the_kernel_is_the_formula(greensboro, centres):
    sky, cut = perez_year(greensboro), patches("tregenza")
    chosen = np.arange(0, len(sky.lit), 97)
    part = PerezSkies(sky.skies.letters[:, chosen], sky.skies.suns[chosen], sky.skies.floor)
    slow = np.zeros((len(chosen), cut.count), np.float32)
    weights, rows = cut.horizontal_solid_angles, np.arange(len(slow))
    by_numpy(part, sky.diffuse[chosen], samples_of(cut, centres), weights, rows, slow)
    quick = dome_means(part, sky.diffuse[chosen], cut, centres)
    assert np.allclose(quick, slow, rtol=2e-6, atol=1e-5 * slow.mean())


def test_the_kernel_at_centres_is_gendaymtx(files):
    tape = hours.tape_of(files["wea"])
    skies, cut = gendaymtx.skies_of(tape), patches("reinhart:2")
    suns = sd.direction(skies.azimuth, np.pi / 2 - skies.zenith)
    weights = np.sin(cut.elevations) * cut.solid_angles
    means = dome_means(PerezSkies(skies.letters, suns, 1e-6), skies.diffuse, cut, True, weights)
    expected = gendaymtx.matrix(tape, 2)[1:, skies.lit].T * RADIANCE_EFFICACY
    assert np.allclose(means, expected, rtol=2e-5, atol=1e-6 * expected.mean())


def test_gendaymtx_by_name(files):
    data = year(files["epw"], compat="gendaymtx", patches="reinhart:2")
    matrix = gendaymtx.matrix(hours.tape_from(read_weather(files["epw"])), 2)
    assert np.allclose(data.luminance.values.T, matrix[1:] * 179, rtol=1e-6)
    with pytest.raises(ValueError, match="needs Reinhart's patches"):
        year(files["epw"], compat="gendaymtx", patches="equal-area:1")


def test_choices_differ_and_keep_the_level(greensboro, plain):
    week = greensboro.rows(slice(4300, 4500))
    plain_week = year(week)
    assert np.allclose(plain_week.luminance, plain.luminance[4300:4500], rtol=1e-5)
    for choice in ({"compat": "gendaylit"}, {"smooth": True}):
        other = year(week, **choice)
        total = other.luminance @ other.horizontal_solid_angle
        assert np.allclose(total, other.diffuse_horizontal_illuminance, rtol=1e-5)
    assert not np.allclose(other.luminance, plain_week.luminance, rtol=0.05)


def test_smooth_has_no_jump_at_the_edge_of_a_bin(greensboro):
    import pandas as pd

    times = pd.date_range("2026-06-21T17:00", periods=1, freq="h", tz="UTC")

    def zenith_luminance(direct, smooth):
        frame = pd.DataFrame({"dni": direct, "dhi": 200.0}, index=times)
        return float(
            year(sd.Weather.from_frame(frame, greensboro.place, label="middle"), smooth=smooth).luminance[0, -1]
        )

    steps = np.linspace(50, 150, 41)
    rough, fine = (np.array([zenith_luminance(direct, smooth) for direct in steps]) for smooth in (False, True))
    jump = [np.max(np.abs(np.diff(values))) / values.mean() for values in (rough, fine)]
    assert jump[1] < 0.5 * jump[0]


def test_nothing_is_black_or_missing_in_silence(greensboro):
    day = greensboro.rows(slice(24 * 180, 24 * 181))
    direct, diffuse, dew = (np.array(getattr(day, n)) for n in ("direct_normal", "diffuse_horizontal", "dew_point"))
    direct[0], direct[10], direct[11], diffuse[12], dew[13] = 50, np.nan, -3, 0, np.nan
    from dataclasses import replace

    data = year(replace(day, direct_normal=direct, diffuse_horizontal=diffuse, dew_point=dew))
    assert data.status.values[0] == BITS["night"] | BITS["light_at_night"]
    assert data.status.values[10] == BITS["missing"]
    assert np.isnan(data.luminance[10]).all()
    assert data.status.values[11] & BITS["negative"]
    assert data.status.values[12] == BITS["no_diffuse"]
    assert data.status.values[13] & BITS["no_dew_point"]
    black = (data.luminance == 0).all("patch").values
    assert np.array_equal(black, (data.status.values & (BITS["night"] | BITS["no_diffuse"])) > 0)
    assert float(data.luminance.min()) >= 0
    assert counts(data.status.values)["night"] == (data.lit_share == 0).sum()
    assert set(data.status.attrs["flag_meanings"].split()) == set(BITS)


def test_a_leap_day_and_a_polar_night_pass(greensboro):
    import pandas as pd

    times = pd.date_range("2028-02-28", periods=72, freq="h", tz="UTC")
    frame = pd.DataFrame({"dni": 100.0, "dhi": 50.0}, index=times)
    with pytest.warns(UserWarning, match="while the sun is down"):
        data = year(sd.Weather.from_frame(frame, sd.Place(70.0, 20.0)))
    assert (data.status.values[data.sun_elevation.values < -2] & BITS["light_at_night"]).all()


@pytest.mark.parametrize("kind", ["preetham", "hosek-wilkie"])
def test_colour_and_spectrum_keep_the_luminance(greensboro, kind):
    noon = greensboro.rows(slice(24 * 180 + 8, 24 * 180 + 18))
    bands = np.arange(380.0, 721.0, 20.0)
    data = year(noon, colour=kind, wavelengths=bands)
    assert np.allclose(data.xyz[..., 1], data.luminance, rtol=1e-5)
    from_spectrum = data.radiance.values @ xyz_weights(bands)[:, 1]
    assert np.allclose(from_spectrum, data.luminance, rtol=0.03)
    assert (data.diffuse_colour_temperature > 6000).all()
    ratio = data.diffuse_melanopic_edi / data.diffuse_horizontal_illuminance
    assert ((ratio > 1.0) & (ratio < 1.6)).all()  # blue skies: D65 is 1, the bluest skies about 1.4
    photons = data.diffuse_photosynthetic_photons / data.diffuse_horizontal_illuminance
    assert ((photons > 0.0165) & (photons < 0.0215)).all()  # D65: 0.0181 micromol per lm


MELANOPIC_RATIOS = {"A": 0.4958, "FL2": 0.5699, "FL11": 0.5636, "LED-B3": 0.6326}
MELANOPIC_RATIOS_OF_DAYLIGHT = {4000: 0.7117, 5000: 0.8471, 6500: 0.9998, 7500: 1.0760, 10000: 1.2085, 25000: 1.4566}
"""Melanopic EDI over illuminance by the CIE's own table of 1 nm (CIE S 026), 380-780 nm."""


def melanopic_ratio(spectrum):
    even = spectrum.copy().interpolate(colour.SpectralShape(380, 780, 1))
    return melanopic_edi(even.values, even.wavelengths) / (even.values @ xyz_weights(even.wavelengths)[:, 1])


def test_melanopic_ratios_are_the_standards():
    for name, ratio in MELANOPIC_RATIOS.items():
        assert abs(melanopic_ratio(colour.SDS_ILLUMINANTS[name]) / ratio - 1) < 0.005
    for kelvin, ratio in MELANOPIC_RATIOS_OF_DAYLIGHT.items():
        daylight = colour.sd_CIE_illuminant_D_series(colour.temperature.CCT_to_xy_CIE_D(kelvin))
        assert abs(melanopic_ratio(daylight) / ratio - 1) < 0.002


def test_the_melanopic_curve_is_the_standards():
    """Values of the CIE's table; its curve is met within 2.8 % of the peak."""
    w = np.array([400.0, 425, 455, 480, 490, 510, 530, 550, 580, 600, 650])
    table = [0.01143, 0.18710, 0.62965, 0.96561, 1.0, 0.86289, 0.51931, 0.21572, 0.02687, 0.00507, 0.00009]
    difference = np.abs(melanopic_sensitivity(w) - table)
    assert difference.max() < 0.028
    assert np.sqrt(np.mean(difference**2)) < 0.015


def test_action_spectra_for_daylight():
    """1 lx of D65 has a melanopic EDI of 1 lx (CIE S 026), and its photons by the trapezoidal rule."""
    spectrum = colour.SDS_ILLUMINANTS["D65"].copy().interpolate(colour.SpectralShape(380, 780, 1))
    w, values = spectrum.wavelengths, spectrum.values
    lux = values @ xyz_weights(w)[:, 1]
    assert np.isclose(melanopic_edi(values / lux, w), 1.0, atol=5e-4)
    inside = (w >= 400) & (w <= 700)
    photons = np.trapezoid(values[inside] * w[inside], w[inside]) / 119.6266 / lux  # J nm per micromole
    assert np.isclose(photosynthetic_photons(values / lux, w), photons, rtol=1e-3)


@pytest.mark.parametrize(
    ("choice", "message"),
    [
        ({"compat": "gensky"}, "compat must be one of paper, gendaylit, gendaymtx"),
        ({"patches": "klems"}, "patches must be tregenza"),
        ({"colour": "blue"}, "colour must be one of physical, hosek-wilkie, preetham, got 'blue'"),
        ({"wavelengths": [400.0, 500.0]}, "wavelengths need a colour"),
    ],
)
def test_bad_choices(greensboro, choice, message):
    with pytest.raises(ValueError, match=message):
        year(greensboro.rows(slice(4330, 4340)), **choice)


def test_files_by_netcdf(plain, tmp_path):
    import xarray

    plain.isel(time=slice(0, 48)).to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
    with xarray.open_dataset(tmp_path / "a.nc", engine="h5netcdf") as again:
        assert np.array_equal(again.luminance, plain.luminance[:48])


def test_year_is_an_ordinary_function():
    import inspect

    import skydome as sd

    assert inspect.isfunction(sd.year)
    assert "compat" in inspect.signature(sd.year).parameters


def test_a_year_in_slices_is_the_same_year(greensboro, tmp_path):
    import xarray

    from skydome.years.stores.stores import write_year

    part, choices = greensboro.rows(slice(4300, 4420)), {"colour": "preetham", "wavelengths": [400.0, 550.0, 700.0]}
    write_year(part, tmp_path / "a.zarr", values_at_once=145 * 3 * 30, **choices)
    whole = year(part, **choices)
    with xarray.open_zarr(tmp_path / "a.zarr") as data:
        assert np.array_equal(data.time, whole.time)
        for name in ("radiance", "luminance", "status", "sun_azimuth", "solid_angle"):
            assert np.allclose(data[name], whole[name], rtol=1e-5)
    with pytest.raises(ValueError, match="is written whole"):
        write_year(part, tmp_path / "b.zarr", compat="gendaymtx")


def test_a_frame_is_taken_with_its_place():
    pd = pytest.importorskip("pandas")
    times = pd.date_range("2026-06-21T06:00", periods=6, freq="h", tz="UTC")
    frame = pd.DataFrame({"dni": 600.0, "dhi": 110.0}, index=times)
    place = sd.Place(45.07, 7.69)
    np.testing.assert_array_equal(
        year(frame, place=place).luminance, year(sd.Weather.from_frame(frame, place)).luminance
    )
    with pytest.raises(ValueError, match="tells of no place"):
        year(frame)


def test_dim_hours_are_not_black_above_the_horizon():
    """5 and 5 W m-2 under a sun of 14 degrees: 97 % of the patches were black, the others had 46,000 cd m-2."""
    import pandas as pd

    times = pd.date_range("2026-03-21T07:00", periods=9, freq="h", tz="UTC")
    for smooth in (False, True):
        data = year(pd.DataFrame({"dni": 5.0, "dhi": 5.0}, index=times), place=sd.Place(45.07, 7.69), smooth=smooth)
        lit = data.diffuse_horizontal_illuminance.values > 0
        assert (data.luminance.values[lit] > 0).mean(axis=1).min() > 0.7
        assert data.luminance.values[lit].max() < 4000
        assert counts(data.status.values)["dark_sky"] == 9
