"""Levels hold: the sun without diffuse light, dark letters, high suns, the smooth sky, the sun's distance."""

import warnings

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.dome.bases.lobe_bases import spread_over_hemisphere
from skydome.skies.formula.perez_table import clearness_bin

SUN = sd.direction(azimuth=180 * deg, elevation=45 * deg)


@pytest.mark.parametrize("compat", ["paper", "gendaylit"])
def test_a_sun_without_diffuse_light_is_the_clearest_sky(compat):
    diffuse = np.array([0.0, 1e-6, 1e-3, 1.0])
    sky = sd.PerezAllWeather(SUN, 911.0, diffuse, compat=compat)
    assert (clearness_bin(sky.conditions()[0]) == 7).all()
    np.testing.assert_allclose(sky.direct_normal_illuminance, sky.direct_normal_illuminance[-1], rtol=2e-4)
    assert sky.valid.all()
    assert float(sd.illuminance(sd.PerezAllWeather(SUN, 911.0, 0.0))) == 0
    assert float(sd.SunDisc.of(sd.PerezAllWeather(SUN, 911.0, 0.0)).illuminance(SUN)) == pytest.approx(94_451, abs=1)


def test_no_light_at_all_is_not_valid_and_not_refused():
    sky = sd.PerezAllWeather(SUN, np.array([0.0, 0.0, 5.0]), np.array([0.0, 5.0, 0.0]))
    assert sky.valid.tolist() == [False, True, True]
    assert float(sky.luminance(sd.ZENITH)[0]) == 0


def test_a_dim_sky_has_its_light():
    sky = sd.PerezAllWeather(sd.direction(1.0, 5 * deg), 111.0, 15.9)
    assert bool(sky.valid)
    assert float(sky.diffuse_illuminance) == pytest.approx(2559, abs=1)
    assert float(sd.illuminance(sky)) == pytest.approx(float(sky.diffuse_illuminance), rel=1e-4)


BLACK = (-3.0, -0.01, 1.0, -1.0, 0.1)  # 1 + a exp(b / cos t) is negative wherever the second factor is positive


@pytest.mark.parametrize("level", [{"zenith_luminance": 3000.0}, {"zenith_luminance": np.array([0.0, 3000.0])}])
def test_black_skies_are_refused_or_not_valid(level):
    with pytest.raises(ValueError, match="Perez must give light at its level"):
        sd.Perez(SUN, *BLACK, **level)
    for check in ("clamp", "nan"):
        sky = sd.Perez(SUN, *BLACK, check=check, **level)
        assert np.ravel(sky.valid)[-1] == False  # noqa: E712
    assert np.isnan(np.ravel(sky.luminance(sd.ZENITH))[-1])


def test_every_valid_all_weather_sky_has_the_illuminance_that_it_tells():
    rng = np.random.default_rng(5)
    n = 300
    suns = sd.direction(np.full(n, 2.0), rng.uniform(0.6, 89.4, n) * deg)
    for smooth in (False, True):
        given = rng.uniform(0, 950, n), rng.uniform(1, 400, n)
        sky = sd.PerezAllWeather(suns, *given, smooth=smooth, check="clamp")
        told, held = sky.diffuse_illuminance, sky.valid
        light = np.array(
            [
                float(sd.illuminance(sd.PerezAllWeather(suns[k], given[0][k], given[1][k], smooth=smooth)))
                for k in np.flatnonzero(held)[:40]
            ]
        )
        np.testing.assert_allclose(light, told[held][:40], rtol=1e-3)
        assert held.mean() > 0.9
        if not held.all():
            with pytest.raises(ValueError, match="give light at its level"):
                sd.PerezAllWeather(suns, *given, smooth=smooth)


def test_smooth_takes_the_jump_away():
    """At clearness 1.065 the published sky toward the sun jumps from 1.2 to 4.1 times the mean."""
    sun = sd.direction(180 * deg, 40 * deg)

    def shape(direct, smooth):
        sky = sd.PerezAllWeather(sun, direct, 150.0, smooth=smooth)
        return float(np.pi * sky.luminance(sun) / sky.diffuse_illuminance)

    assert shape(16.5, False) / shape(16.0, False) > 3
    assert abs(shape(16.5, True) / shape(16.0, True) - 1) < 0.03


def test_smooth_is_the_year_s():
    from skydome.dome.patches import patches
    from skydome.skies.formula.perez_table import bins_about, guarded_letters
    from skydome.years.skies.dome_means import PerezSkies, dome_means

    cut = patches("reinhart:4")
    sky = sd.PerezAllWeather(SUN, 300.0, 150.0, smooth=True)
    epsilon, delta, zenith = (np.atleast_1d(part) for part in sky.conditions())
    low, high, weight = bins_about(epsilon)
    means = 0.0
    for centre, share in ((low, 1 - weight), (high, weight)):
        letters = np.stack(guarded_letters(centre, delta, zenith).letters)
        means = means + dome_means(PerezSkies(letters, SUN[None], sky.floor), sky.diffuse_illuminance * share, cut)
    np.testing.assert_allclose(sky.luminance(cut.directions), means[0], rtol=0.03)


@pytest.mark.parametrize("smooth", [False, True])
@pytest.mark.parametrize("case", [(15.0, 5.0, 5.0), (60.0, 20.0, 6.0), (59.6456, 11.112, 4.398), (10.0, 1.0, 2.0)])
def test_dim_perez_skies_are_not_black(case, smooth):
    """By the letters of the table all their light stood in a line at the horizon, 2e7 cd m-2, or was not there."""
    elevation, direct, diffuse = case
    sky = sd.PerezAllWeather(sd.direction(2.0, elevation * deg), direct, diffuse, smooth=smooth)
    assert bool(sky.valid)
    light = sky.luminance(spread_over_hemisphere(2000))
    assert (light > 0).mean() > 0.7
    assert light.max() < 60 * light.mean()
    assert float(sd.illuminance(sky)) == pytest.approx(float(sky.diffuse_illuminance), rel=1e-4)


def test_the_table_s_letters_hold_where_they_leave_light():
    from skydome.skies.formula.perez_table import distribution_letters, guarded_letters, is_dark

    elevation, direct, diffuse = (
        np.ravel(part)
        for part in np.meshgrid(np.arange(5.0, 86, 5), [0, 1, 5, 20, 50, 100, 400, 900], [1, 2, 5, 10, 20, 50, 100])
    )
    sky = sd.PerezAllWeather(sd.direction(0.0, elevation * deg), direct, diffuse)
    epsilon, delta, zenith = sky.conditions()
    table = distribution_letters(epsilon, delta, zenith)
    found = guarded_letters(epsilon, delta, zenith)
    assert not is_dark(*found.letters[:2]).any()
    assert sky.valid.all()
    assert 0.1 < found.dark.mean() < 0.3
    assert (delta[found.dark] < 0.2).all()
    lit = ~found.dark
    np.testing.assert_array_equal(np.stack(found.letters)[2:, lit], np.stack(table)[2:, lit])


def test_levels_given_to_the_all_weather_sky():
    by_light = sd.PerezAllWeather(SUN, 700.0, 120.0, illuminance=10_000.0)
    assert float(sd.illuminance(by_light)) == pytest.approx(10_000, rel=1e-4)
    for smooth in (False, True):
        by_zenith = sd.PerezAllWeather(SUN, 700.0, 120.0, zenith_luminance=3000.0, smooth=smooth)
        assert float(by_zenith.luminance(sd.ZENITH)) == pytest.approx(3000, rel=1e-12)
        assert float(by_zenith.diffuse_illuminance) == pytest.approx(float(sd.illuminance(by_zenith)), rel=1e-4)
    with pytest.raises(ValueError, match="got both"):
        sd.PerezAllWeather(SUN, 700.0, 120.0, zenith_luminance=3000.0, illuminance=1.0)


@pytest.mark.parametrize("elevation", [75.0, 80.0, 88.0, 90.0])
def test_a_clear_sky_under_a_high_sun_keeps_its_illuminance(elevation):
    sun = sd.direction(1.0, elevation * deg)
    sky = sd.CIEClear(sun, zenith_luminance=sd.clear_zenith_luminance(sun, 3.0))
    assert float(sd.illuminance(sky)) == pytest.approx(16_711, rel=2e-3)


def test_the_disc_is_as_large_as_the_sun_s_distance_says():
    air = sd.Atmosphere.mars()
    assert float(sd.SunDisc.of(sd.Nishita93(SUN, air)).angular_radius) == pytest.approx(
        np.arcsin(np.sin(sd.solar_radius("2026-06-21T12:00Z") * sd.earth_sun_distance("2026-06-21T12:00Z")) / 1.5237),
        rel=1e-3,
    )
    far = sd.PerezAllWeather(SUN, 700.0, 120.0, 1367 / 1.0166**2)
    assert float(sd.SunDisc.of(far).angular_radius) == pytest.approx(
        float(sd.solar_radius("2026-07-06T12:00Z")), rel=1e-4
    )
    far = sd.Atmosphere.standard(sun_scale=1.0166**-2)
    for sky in (sd.HosekWilkie(SUN, 3.0), sd.PhysicalSky(SUN), sd.Nishita93(SUN)):
        discs = [sd.SunDisc.of(sky), sd.SunDisc.of(sky, time="2026-07-06T12:00Z")]
        light = [float(disc.illuminance(SUN)) for disc in discs]
        assert light[1] / light[0] == pytest.approx(1.0166**-2, rel=1e-3)
    known = [sd.SunDisc.of(sd.PhysicalSky(SUN, far), time=day) for day in (None, "2026-07-06T12:00Z")]
    assert float(known[1].illuminance(SUN)) == pytest.approx(float(known[0].illuminance(SUN)), rel=1e-3)


@pytest.mark.parametrize("model", ["physical", "hosek-wilkie"])
def test_the_command_and_the_library_give_one_number(model):
    """README's sky, by library and command line, on the day's own distance from the sun."""
    import json
    import subprocess
    import sys

    turin, time = sd.Place(45.07, 7.69, 240), "2026-06-21T15:00+02:00"
    sun = sd.sun_direction(turin, time)
    air = sd.Atmosphere.from_turbidity(3.0, albedo=0.2, sun_scale=float(sd.earth_sun_distance(time)) ** -2)
    air = air.at_altitude(240.0)
    sky = sd.PhysicalSky(sun, air) if model == "physical" else sd.HosekWilkie(sun, turbidity=3.0, albedo=0.2)
    ours = float(sd.illuminance(sky + sd.SunDisc.of(sky, time=time)))
    command = [sys.executable, "-m", "skydome", "light", "--place", "45.07,7.69,240", "--time", time, "--model", model]
    told = json.loads(subprocess.run([*command, "--json"], capture_output=True, check=True, text=True).stdout)
    assert told["illuminance_lx"]["global"] == pytest.approx(ours, rel=1e-5)


@pytest.mark.parametrize("kind", ["x", "y"])
@pytest.mark.parametrize("turbidity", [2.0, 3.7, 6.0])
def test_the_authors_zenith_is_their_matrices(kind, turbidity):
    """A literal reference: (T^2, T, 1) M (s^3, s^2, s, 1), the five-digit matrices written out once more."""
    from skydome.skies.preetham import PreethamNumbers

    matrices = {
        "x": "0.00166 -0.00375 0.00209 0 -0.02903 0.06377 -0.03202 0.00394 0.11693 -0.21196 0.06052 0.25886",
        "y": "0.00275 -0.00610 0.00317 0 -0.04214 0.08970 -0.04153 0.00516 0.15346 -0.26756 0.06670 0.26688",
    }
    matrix = np.array(matrices[kind].split(), float).reshape(3, 4)
    for height in (1.0, 30.0, 80.0):
        s = np.radians(90 - height)
        wanted = np.array([turbidity**2, turbidity, 1]) @ matrix @ np.array([s**3, s**2, s, 1])
        sky = sd.Preetham(sd.direction(0.3, height * deg), turbidity, PreethamNumbers.AUTHORS)
        assert sky.xyY(sd.ZENITH)["xy".index(kind)] == pytest.approx(wanted, rel=1e-9)


def test_authors_numbers_move_the_zenith_s_colour():
    from skydome.skies.preetham import PreethamNumbers

    sun = sd.direction(0.0, 5 * deg)
    kelvin = [
        float(sd.colour_temperature(sd.Preetham(sun, 6.0, numbers).xyz(sd.ZENITH)))
        for numbers in (PreethamNumbers.PRINTED, PreethamNumbers.AUTHORS)
    ]
    assert kelvin == pytest.approx([7716, 8688], abs=1)


@pytest.mark.slow
@pytest.mark.parametrize(("zenith", "rms"), [(45, 0.001), (80, 0.0012), (85, 0.002), (88, 0.009)])
def test_what_the_layers_of_discrete_ordinates_cost(monkeypatch, zenith, rms):
    """Against layers cut in four each."""
    pytest.importorskip("nanodisort")
    from skydome.skies.physical import layers

    rng = np.random.default_rng(0)
    views = sd.direction(rng.uniform(0, 6.28, 300), np.arcsin(rng.uniform(0.02, 1, 300)))
    sky = sd.DiscreteOrdinates(sd.direction(1.0, (90 - zenith) * deg), sd.Atmosphere.standard(0.1))
    usual = sky.radiance(views, [400.0, 550.0, 680.0])
    fine = layers.LEVELS
    for _ in range(2):
        between = np.sqrt(fine[:-1] * fine[1:])
        between[-1] = fine[-2] / 2
        fine = np.sort(np.concatenate([fine, between]))[::-1]
    monkeypatch.setattr(layers, "LEVELS", fine)
    assert np.sqrt(np.mean((usual / sky.radiance(views, [400.0, 550.0, 680.0]) - 1) ** 2)) < rms


def test_gas_bands_that_the_air_lacks_are_told():
    from skydome.air.atmosphere import MissingBands

    sky = sd.Nishita93(SUN, sd.Atmosphere.of_aerosol(sd.Aerosol(0.1), gases=None))
    with pytest.warns(MissingBands, match="oxygen band at 761 nm, water band at 940 nm"):
        sky.radiance(sd.ZENITH, [550.0, 761.0, 940.0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sky.radiance(sd.ZENITH, [450.0, 550.0, 780.0])
        sky.xyz(sd.ZENITH)
        sd.Nishita93(SUN).radiance(sd.ZENITH, [761.0, 940.0, 2000.0])
        sd.Nishita93(SUN, sd.Atmosphere.mars()).radiance(sd.ZENITH, [761.0])


def test_the_ground_is_the_same_for_every_model():
    from skydome.skies.model import USUAL

    assert sd.HosekWilkie(SUN, 3.0).albedo == sd.Atmosphere.standard().albedo == USUAL["albedo"] == 0.2
    assert sd.Atmosphere().albedo == sd.Atmosphere.from_turbidity(3.0).albedo == 0.2
    assert sd.NeuralSpectralSky.load("hosek-wilkie-spectral", SUN).albedo == 0.2
    assert "albedo" not in sd.NeuralSky.load("hosek-wilkie", SUN).parameters()
