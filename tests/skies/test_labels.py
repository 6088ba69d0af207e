"""Labelled in, labelled out: pandas and xarray at the door of skies, integrals and directions."""

from dataclasses import fields
from functools import partial

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import skydome as sd
from skydome.light.colour_temperature import colour_temperature

TURIN = sd.Place(45.07, 7.69)
HOURS = pd.date_range("2026-06-21T10:00", periods=3, freq="h", tz="Europe/Rome")
SUNS = sd.sun_direction(TURIN, HOURS)
VIEWS = sd.direction([0.0, 1.0, 2.0, 3.0], 0.5)
SUN = sd.direction(2.0, 0.7)


def same(labelled, plain, labels):
    """A labelled answer holds the plain one's numbers under the labels."""
    assert type(labelled).__name__ in ("Series", "DataFrame", "DataArray")
    np.testing.assert_array_equal(labelled.to_numpy(), plain)
    found = labelled.index if hasattr(labelled, "index") else labelled.indexes[labelled.dims[0]]
    assert found.equals(labels)


def test_hours_of_a_frame_give_its_hours():
    frame = pd.DataFrame({"dni": [700.0, 710.0, 600.0], "dhi": [110.0, 112.0, 100.0]}, index=HOURS)
    sky = sd.PerezAllWeather(SUNS, frame.dni, frame.dhi)
    plain = sd.PerezAllWeather(SUNS, *frame.to_numpy().T)
    same(sky.luminance(sd.ZENITH), plain.luminance(sd.ZENITH), HOURS)
    assert sky.luminance(sd.ZENITH).name == "luminance"
    dome = sd.PerezAllWeather(SUNS[:, None], *frame.to_numpy().T[..., None])
    by_hour = sd.PerezAllWeather(pd.DataFrame(SUNS, HOURS), frame.dni, frame.dhi)
    same(sd.illuminance(by_hour), sd.illuminance(dome), HOURS)
    walls = sd.illuminance(by_hour, [sd.EAST, sd.WEST])
    same(walls, sd.illuminance(dome, [sd.EAST, sd.WEST]), HOURS)
    assert walls.shape == (3, 2)


def test_answers_with_channels_and_wavelengths():
    kinds = pd.Series([2.0, 5.0], index=pd.Index(["clear", "hazy"], name="day"))
    sky, plain = sd.HosekWilkie(SUN, turbidity=kinds), sd.HosekWilkie(SUN, turbidity=[2.0, 5.0])
    same(sky.xyz(sd.NORTH), plain.xyz(sd.NORTH), kinds.index)
    assert list(sky.xyz(sd.NORTH).columns) == ["X", "Y", "Z"]
    assert list(sky.rgb(sd.NORTH).columns) == ["red", "green", "blue"]
    assert list(sky.radiance(sd.NORTH, [450, 550]).columns) == [450, 550]
    assert list(sd.irradiance(sky, wavelengths=[450.0, 550.0]).columns) == [450, 550]
    whole = sky + sd.SunDisc.of(sky)
    same(sd.illuminance(whole), sd.illuminance(sd.HosekWilkie(SUN, [[2.0], [5.0]]) * 1.0)
         + float(sd.illuminance(sd.SunDisc(SUN, 2.0))) * np.array([1.0, 0.0])
         + float(sd.illuminance(sd.SunDisc(SUN, 5.0))) * np.array([0.0, 1.0]), kinds.index)  # fmt: skip


def test_axes_of_xarray_pair_by_name():
    """Suns and views are two axes, however they are ordered; no axis of 1 is needed."""
    time, view = pd.Index(range(3), name="time"), pd.Index(list("nesw"), name="view")
    suns = xr.DataArray(SUNS, {"time": time}, ["time", "axis"])
    views = xr.DataArray(VIEWS, {"view": view}, ["view", "axis"])
    haze = xr.DataArray([2.0, 3.0, 4.0], {"time": time}, ["time"])
    plain = sd.Preetham(SUNS[:, None], np.array([[2.0], [3.0], [4.0]]))
    sky = sd.Preetham(suns, haze)
    light = sky.luminance(views)
    assert light.dims == ("time", "view")
    assert light.attrs == {"units": "cd m-2"}
    same(light, plain.luminance(VIEWS), time)
    assert sky.rgb(views).dims == ("time", "view", "channel")
    assert sd.illuminance(sky, views).dims == ("time", "view")
    same(sd.illuminance(sky, views), sd.illuminance(plain, VIEWS), time)
    assert sd.patch_means(sky).dims == ("time", "patch")
    assert float(light.sel(view="e").isel(time=0)) == float(plain.luminance(VIEWS)[0, 1])
    reordered = sd.Preetham(SUN, xr.DataArray([[2.0, 3.0]], dims=("b", "a"))).luminance(
        xr.DataArray(np.stack([VIEWS[:2]]), dims=("c", "a", "axis"))
    )
    assert reordered.dims == ("b", "a", "c")


def test_directions_suns_and_colours():
    hours = pd.Series(HOURS, index=["ten", "eleven", "noon"])
    toward = sd.sun_direction(TURIN, hours)
    same(toward, SUNS, hours.index)
    assert list(toward.columns) == ["x", "y", "z"]
    same(sd.elevation(toward), sd.elevation(SUNS), hours.index)
    same(sd.angle_between(toward, sd.ZENITH), sd.angle_between(SUNS, sd.ZENITH), hours.index)
    same(sd.direction(sd.azimuth(toward), sd.elevation(toward)), sd.direction(*angles(SUNS)), hours.index)
    assert [part.name for part in (sd.azimuth(toward), sd.elevation(toward))] == ["azimuth", "elevation"]
    xyz = sd.HosekWilkie(SUN, 3.0).xyz(pd.DataFrame(VIEWS, index=list("nesw")))
    same(colour_temperature(xyz), colour_temperature(xyz.to_numpy()), xyz.index)
    assert isinstance(sd.sun_direction(TURIN, HOURS), np.ndarray)  # an index holds times, and labels nothing


NUMBERS = pd.Series([3.0, 4.0, 5.0], index=["a", "b", "c"])
TIMES = pd.Series(HOURS, index=["ten", "eleven", "noon"])


@pytest.mark.parametrize(
    ("function", "given"),
    [
        (sd.solar_radius, TIMES),
        (partial(sd.lunar_radius, TURIN), TIMES),
        (partial(sd.preetham_sun_direction, TURIN), TIMES),
        (sd.surface_magnitude, NUMBERS),
        (sd.takagi_colour_temperature, NUMBERS),
        (sd.meteorological_range, NUMBERS),
    ],
)
def test_functions_of_numbers_and_times(function, given):
    light = function(given)
    same(light, function(HOURS if given is TIMES else given.to_numpy()), given.index)
    assert getattr(light, "name", None) in (None, getattr(function, "func", function).__name__)


def test_polarisation():
    """Toward labelled views, with wavelengths, and Stokes' three beyond what pandas can hold."""
    sky, frame = sd.PhysicalSky(SUN), pd.DataFrame(VIEWS, index=list("nesw"))
    views = xr.DataArray(VIEWS, {"view": list("nesw")}, ["view", "axis"])
    for method in (sky.degree_of_polarisation, sky.angle_of_polarisation):
        same(method(frame, [450.0, 550.0]), method(VIEWS, [450.0, 550.0]), frame.index)
        assert list(method(directions=frame, wavelengths=[450.0, 550.0]).columns) == [450.0, 550.0]
    plain, light = sky.stokes(VIEWS, [550.0]), sky.stokes(views, [550.0])
    assert light.dims == ("view", "wavelength", "stokes")
    np.testing.assert_array_equal(light.sel(stokes="Q"), plain[..., 1])
    np.testing.assert_array_equal(sky.stokes(frame, [550.0]), plain)


DAYS = pd.Series(["2026-06-21", "2026-06-22", "2026-12-21"], index=["a", "b", "c"])


def events_of(days):
    events = sd.sun_events(TURIN, days)
    return [*events.instants.values(), events.noon_elevation, events.daylight, *events.local.values()]


def moon_of(times):
    phase = sd.moon_phase(TURIN, times)
    parts = [getattr(phase, item.name) for item in fields(phase)]
    return [*parts, phase.illuminated, phase.elongation, phase.bright_limb, phase.axis]


def night_of(times):
    light = sd.light_at(TURIN, times)
    return [light.times, light.total, *light.parts.values()]


@pytest.mark.parametrize(
    ("parts_of", "given"),
    [
        (events_of, DAYS),
        (lambda days: [(events := sd.moon_events(TURIN, days)).rise, events.transit, events.set], DAYS),
        (moon_of, TIMES),
        (lambda times: [part for one in sd.planets(TURIN, times) for part in (one.direction, one.phase_angle)], TIMES),
        (night_of, TIMES),
    ],
)
def test_every_part_of_an_answer_has_the_labels(parts_of, given):
    plain = parts_of(HOURS if given is TIMES else list(given))
    for labelled, bare in zip(parts_of(given), plain, strict=True):
        same(labelled, bare, given.index)
    named = xr.DataArray(given.to_numpy() if given is DAYS else HOURS.tz_convert(None).values, {"k": [1, 2, 3]}, ["k"])
    for labelled, bare in zip(parts_of(named), plain, strict=True):
        assert labelled.dims[0] == "k"
        np.testing.assert_array_equal(labelled, bare)


def test_what_a_sky_knows_has_its_labels():
    frame = pd.DataFrame({"dni": [700.0, 710.0, 0.0], "dhi": [110.0, 112.0, 100.0]}, index=HOURS)
    sky = sd.PerezAllWeather(pd.DataFrame(SUNS, HOURS), frame.dni, frame.dhi)
    plain = sd.PerezAllWeather(SUNS, *frame.to_numpy().T)
    for name in ("valid", "is_day", "direct_normal_illuminance", "diffuse_illuminance"):
        same(getattr(sky, name), getattr(plain, name), HOURS)
    disc, bare = sd.SunDisc.of(sky), sd.SunDisc.of(plain)
    same(disc.illuminance(sd.ZENITH), bare.illuminance(sd.ZENITH), HOURS)
    same(disc.irradiance([450.0, 550.0]), bare.irradiance([450.0, 550.0]), HOURS)
    assert list(disc.normal_xyz.columns) == ["X", "Y", "Z"]
    dome = sd.PerezAllWeather(SUNS[:, None], *frame.to_numpy().T[..., None])
    same(sd.illuminance(sky + disc), sd.illuminance(dome + sd.SunDisc.of(dome)), HOURS)
    one_sun = sd.PerezAllWeather(SUN, frame.dni, frame.dhi)
    assert sd.illuminance(one_sun + sd.SunDisc.of(one_sun)).index.equals(HOURS)


def test_air_of_labelled_depths_and_what_light_does():
    depths, suns = pd.Series([0.05, 0.2, 0.4], index=list("abc")), sd.direction(0.0, np.radians([50.0, 10.0, 40.0]))
    sky = sd.PhysicalSky(pd.DataFrame(suns, depths.index), sd.clear_air(aerosol_depth=depths))
    plain = sd.PhysicalSky(suns, sd.clear_air(aerosol_depth=depths.to_numpy()))
    same(sky.luminance(sd.ZENITH), plain.luminance(sd.ZENITH), depths.index)
    same(sky.valid, plain.valid, depths.index)
    whole, bare = sky + sd.SunDisc.of(sky), plain + sd.SunDisc.of(plain)
    same(sd.uv_index(whole), sd.uv_index(bare), depths.index)
    assert sd.broadband(whole).global_horizontal.index.equals(depths.index)
    assert sd.illuminance(whole).index.equals(depths.index)
    assert sd.Atmosphere.standard(depths).transmittance(0.5, [550.0]).shape == (3, 1)


def test_discs_of_another_size_or_of_a_time_keep_labels():
    suns, times = pd.DataFrame(SUNS, HOURS), pd.Series(HOURS, index=HOURS)
    for sky, plain in (
        (sd.HosekWilkie(suns, 3.0), sd.HosekWilkie(SUNS, 3.0)),
        (sd.PhysicalSky(suns), sd.PhysicalSky(SUNS)),
    ):
        disc, bare = sd.SunDisc.of(sky), sd.SunDisc.of(plain)
        same(disc.of_size(0.05).illuminance(sd.ZENITH), bare.of_size(0.05).illuminance(sd.ZENITH), HOURS)
        np.testing.assert_allclose(disc.of_size(0.05).illuminance(sd.ZENITH), bare.illuminance(sd.ZENITH), rtol=1e-9)
        of_time, bare_time = sd.SunDisc.of(sky, time=times), sd.SunDisc.of(plain, time=HOURS)
        same(of_time.illuminance(sd.ZENITH), bare_time.illuminance(sd.ZENITH), HOURS)


@pytest.mark.parametrize(("name", "values"), [("ozone", [250.0, 400.0]), ("albedo", [0.1, 0.6]), ("water", [1.0, 4.0])])
def test_every_number_of_the_air_may_be_many(name, values):
    light = sd.illuminance(sd.PhysicalSky(SUN, sd.clear_air(**{name: pd.Series(values, index=["a", "b"])})))
    for label, value in zip("ab", values, strict=True):
        assert light[label] == pytest.approx(
            sd.illuminance(sd.PhysicalSky(SUN, sd.clear_air(**{name: value}))), rel=1e-4
        )


def test_a_labelled_day_alone_is_a_day():
    assert sd.sun_events(TURIN, xr.DataArray(np.datetime64("2026-06-21"))) == sd.sun_events(TURIN, "2026-06-21")


def angles(toward):
    return sd.azimuth(toward), sd.elevation(toward)


def test_labels_that_do_not_fit_are_refused():
    one, other = (pd.Series([2.0, 3.0, 4.0], index=index) for index in ([1, 2, 3], [2, 3, 4]))
    with pytest.raises(ValueError, match=r"must be the same along one axis, got .* 1 \.\.\. 3 and .* 2 \.\.\. 4"):
        sd.Preetham(pd.DataFrame(SUNS, other.index), one).luminance(sd.ZENITH)
    with pytest.raises(TypeError, match="labels of pandas and xarray cannot be mixed"):
        sd.Preetham(SUN, one).luminance(xr.DataArray(VIEWS[:3], dims=("view", "axis")))


def test_maps_take_one_labelled_condition():
    sky = sd.Preetham(pd.DataFrame(SUNS).iloc[0], xr.DataArray(3.0))
    np.testing.assert_array_equal(sd.render(sky, 16).pixels, sd.render(sd.Preetham(SUNS[0], 3.0), 16).pixels)


def test_a_sky_of_ones_own_keeps_labels_too():
    class Double(sd.Uniform):
        def luminance(self, directions):
            return 2 * super().luminance(directions)

    frame = pd.DataFrame(VIEWS, index=list("nesw"))
    same(Double(5.0).luminance(frame), np.full(4, 10.0), frame.index)


def test_what_a_sky_keeps_beside_its_parameters_is_not_walked():
    """The physical sky keeps the sky of its maps, which holds the sky itself."""
    sky = sd.PhysicalSky(sd.direction(1.0, 0.5))
    first = sky.for_maps.luminance(sd.ZENITH)
    assert float(sky.for_maps.luminance(sd.ZENITH)) == float(first) > 0


def test_series_densities_air_and_surroundings():
    """What takes many hours or rays at once: the hours' labels, then those of the rays, then channels."""
    kinds = pd.Series([2.0, 5.0], index=pd.Index(["clear", "hazy"], name="day"))
    views = pd.DataFrame(VIEWS, index=list("nesw"))
    sky, plain = sd.HosekWilkie(SUN, turbidity=kinds), sd.HosekWilkie(SUN, turbidity=np.array([[2.0], [5.0]]))
    series = sd.luminance_series(sky, views)
    same(series, sd.luminance_series(plain, VIEWS), kinds.index)
    assert list(series.columns) == list("nesw")
    same(sd.patch_means(sky), sd.patch_means(plain), kinds.index)
    same(sd.sample_density(plain_sky := sd.Preetham(SUN, 3.0), views), sd.sample_density(plain_sky, VIEWS), views.index)

    far = xr.DataArray([1e3, 5e3], {"range": [1, 5]}, ["range"])
    ways = xr.DataArray(VIEWS, {"view": list("nesw")}, ["view", "axis"])
    air = sd.aerial_perspective(plain_sky, far, ways)
    bare = sd.aerial_perspective(plain_sky, np.array([[1e3], [5e3]]), VIEWS)
    assert air.transmittance.dims == ("range", "view", "channel")
    assert list(air.inscattered.channel) == ["red", "green", "blue"]
    same(air.inscattered, bare.inscattered, pd.Index([1, 5]))
    at = sd.aerial_perspective(plain_sky, far, sd.EAST, wavelengths=[450.0, 550.0])
    assert list(at.transmittance.wavelength) == [450, 550]

    hills, street = sd.Horizon.level(30 * sd.deg), sd.StreetCanyon(10.0, 8.0, floor_reflectance=0.2)
    whole, bare_whole = sky + sd.SunDisc.of(sky), plain + sd.SunDisc.of(plain)
    received, expected = (sd.obstructed_illuminance(one, hills, albedo=0.2) for one in (whole, bare_whole))
    for part in ("sky", "sun", "reflected", "total"):
        same(getattr(received, part), getattr(expected, part), kinds.index)
    coloured = sd.obstructed_illuminance(sky, hills, light=sd.LightInRGB()).sky
    same(coloured, sd.obstructed_illuminance(plain, hills, light=sd.LightInRGB()).sky, kinds.index)
    assert list(coloured.columns) == ["red", "green", "blue"]
    same(street.illuminance(whole, [0.0, 2.0]).total, street.illuminance(bare_whole, [0.0, 2.0]).total, kinds.index)
