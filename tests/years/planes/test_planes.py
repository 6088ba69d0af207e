"""A year on planes: closed forms, pvlib's models, the library's own light at one moment, views among obstructions."""

import numpy as np
import pvlib
import pytest

import skydome as sd
from skydome import deg
from skydome.air.optical_mass import kasten_1966
from skydome.dome.patches import patches
from skydome.ground.units import SOLAR_CONSTANT
from skydome.sun.position import earth_sun_distance
from skydome.surroundings.faces import FaceLight
from skydome.surroundings.intervals import Open
from skydome.surroundings.patch_view import PatchView, looks_into
from skydome.years.planes.light import suns_of

TILTS = ((0, 180), (30, 180), (35, 90), (90, 0), (90, 180), (60, 270))
PLANES = [sd.Plane(tilt * deg, turn * deg) for tilt, turn in TILTS]
SITES = {"Greensboro": (36.1, -79.95), "Quito": (-0.2, -78.5), "Tromso": (69.65, 18.95), "Sydney": (-33.9, 151.2)}
SITES["Riyadh"] = (24.7, 46.7)


@pytest.fixture(scope="module")
def fine(greensboro):
    return sd.year(greensboro, patches="reinhart:4")


@pytest.fixture(scope="module")
def every_third(greensboro):
    """One day in eleven, so that the sun crosses every season."""
    day = np.arange(greensboro.count) // 24
    return sd.year(greensboro.rows(day % 11 == 3), patches="tregenza")


@pytest.mark.parametrize(("tilt", "turn"), TILTS)
def test_open_planes_see_what_the_closed_form_says(tilt, turn):
    plane = sd.Plane(tilt * deg, turn * deg)
    view = PatchView.of(Open(), plane.normal, looks_into(patches("tregenza"), 20_000))
    assert view.sky_view_factor == pytest.approx((1 + np.cos(tilt * deg)) / 2, abs=1e-12)
    assert view.factors.sum() == pytest.approx(np.pi * (1 - np.cos(tilt * deg)) / 2, abs=1e-12)


def test_the_level_plane_is_the_weathers(fine):
    light = sd.on_planes(fine, sd.Plane(0.0))
    for name in ("illuminance", "irradiance"):
        given = fine[f"diffuse_horizontal_{name}"].where(fine.lit_share > 0, 0.0).values
        np.testing.assert_allclose(light[f"sky_{name}"].values[:, 0], given, rtol=1e-5, atol=1e-6)
    assert float(light.reflected_irradiance.max()) == 0


def pvlib_sky(skies, model, plane):
    """The diffuse irradiance by pvlib's function of that name, at the year's own suns."""
    distance = earth_sun_distance(skies.time.values.astype("datetime64[D]"))
    zenith = np.radians(90 - skies.sun_elevation.values)
    given = {
        "surface_tilt": plane.tilt / deg,
        "surface_azimuth": plane.azimuth / deg,
        "dhi": skies.diffuse_horizontal_irradiance.values,
    }
    sun = {"solar_zenith": zenith / deg, "solar_azimuth": skies.sun_azimuth.values}
    beam = {"dni": skies.direct_normal_irradiance.values, "dni_extra": SOLAR_CONSTANT / distance**2}
    if model == "isotropic":
        return pvlib.irradiance.isotropic(given["surface_tilt"], given["dhi"])
    if model == "haydavies":
        return pvlib.irradiance.haydavies(**given, **beam, **sun)
    return getattr(pvlib.irradiance, model)(**given, **beam, **sun, airmass=kasten_1966(zenith))


@pytest.mark.parametrize("name", ["isotropic", "hay-davies", "perez-1990", "perez-driesse"])
def test_each_transposition_is_pvlibs(every_third, name):
    light = sd.on_planes(every_third, PLANES, transposition=name).sky_irradiance.values
    lit = (every_third.lit_share > 0).values & (every_third.diffuse_horizontal_irradiance > 0).values
    for k, plane in enumerate(PLANES):
        theirs = pvlib_sky(
            every_third, {"hay-davies": "haydavies"}.get(name, name.replace("-1990", "").replace("-", "_")), plane
        )
        np.testing.assert_allclose(light[lit, k], theirs[lit], rtol=1e-7, atol=1e-6)


def made_weather(place):
    """Clear and cloudy days by turns, in kinds of light that close, from Ineichen's clear sky."""
    import pandas as pd

    times = pd.date_range("2023-01-01T00:30", periods=8760, freq="h", tz="UTC")
    site = pvlib.location.Location(*place, "UTC", 100)
    clear = site.get_clearsky(times, linke_turbidity=3.0)
    cloud = np.where(times.day_of_year % 3 == 0, 0.0, np.where(times.day_of_year % 3 == 1, 0.5, 1.0))
    frame = pd.DataFrame({"dni": clear.dni * cloud, "dhi": clear.dhi * (2 - cloud)}, index=times)
    return site, frame, sd.Place(*place, 100)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:DatetimeIndex.dayofyear")  # pvlib 0.16 with pandas 3.1
@pytest.mark.parametrize("name", SITES)
def test_irradiation_is_pvlibs_with_its_own_suns(name):
    """The whole chain on both sides: sun, transposition, ground; 5 sites by 6 planes within 2 %."""
    site, frame, place = made_weather(SITES[name])
    light = sd.on_planes(frame, PLANES, place=place, label="middle", transposition="perez-1990", patches="tregenza")
    ours = sd.monthly_sums(light).irradiation.sum("month").values
    sun = site.get_solarposition(frame.index)
    ghi = frame.dhi + frame.dni * np.cos(np.radians(sun.zenith)).clip(lower=0)
    for k, plane in enumerate(PLANES):
        theirs = pvlib.irradiance.get_total_irradiance(
            plane.tilt / deg, plane.azimuth / deg, sun.apparent_zenith, sun.azimuth, frame.dni, ghi, frame.dhi,
            dni_extra=pvlib.irradiance.get_extra_radiation(frame.index), albedo=0.2, model="perez",
        )  # fmt: skip
        assert ours[k] == pytest.approx(theirs.poa_global.sum() / 1000, rel=0.02)


def test_our_sky_is_near_perez_1990_through_a_year(fine):
    """Two models by one author: 1993 gives every direction, 1990 three parts; figures of docs/daylight.md."""
    sums = [
        sd.monthly_sums(sd.on_planes(fine, PLANES, transposition=t)).sum("month") for t in ("perez-1993", "perez-1990")
    ]
    ratio = (sums[0].irradiation / sums[1].irradiation).values
    assert np.abs(ratio - 1).max() < 0.03


def test_views_among_hills_are_those_of_bands(fine):
    hills = sd.Horizon(np.arange(0, 360, 30) * deg, np.array([0, 5, 20, 35, 10, 0, 0, 15, 30, 25, 10, 5]) * deg)
    planes = [sd.Plane(tilt * deg, turn * deg, hills) for tilt, turn in TILTS]
    light = sd.on_planes(fine, planes)
    for k, plane in enumerate(planes):
        exact = sd.PlaneView.of(hills, plane.normal)
        assert float(light.sky_view_factor[k]) == pytest.approx(exact.sky_view_factor, abs=1.5e-3)
    assert (light.sun_irradiance.sum("time") <= sd.on_planes(fine, PLANES).sun_irradiance.sum("time") + 1e-6).all()


def moment(skies):
    """The sky and the sun's disc of a Dataset of one hour, with its illuminances."""
    sun = suns_of(skies)
    distance = float(earth_sun_distance(skies.time.values.astype("datetime64[D]")))
    beam = float(skies.direct_normal_illuminance)
    sky = sd.PerezAllWeather(
        sun, float(skies.direct_normal_irradiance), float(skies.diffuse_horizontal_irradiance),
        SOLAR_CONSTANT / distance**2, illuminance=float(skies.diffuse_horizontal_illuminance),
    )  # fmt: skip
    disc = sd.SunDisc.from_irradiance(sun, 500.0)
    return sky, (beam / float(disc.normal_xyz[1])) * disc


def test_a_plane_of_the_year_is_the_plane_of_the_moment(fine):
    """Patches by weights against the continuous sky of one hour, sun and ground, in lux."""
    hour = int(np.argmax(fine.direct_normal_illuminance.values))
    light = sd.on_planes(fine.isel(time=[hour]), PLANES)
    sky, disc = moment(fine.isel(time=hour))
    for k, plane in enumerate(PLANES):
        assert light.sky_illuminance.values[0, k] == pytest.approx(float(sd.illuminance(sky, plane.normal)), rel=3e-3)
        whole = float(sd.illuminance(sky + disc, plane.normal, ground_albedo=0.2))
        assert light.illuminance.values[0, k] == pytest.approx(whole, rel=2e-3)


def test_a_street_gives_what_it_gives_at_one_moment(fine):
    """Sky, sun and reflected light of a canyon against the canyon's own, hours with high and low sun."""
    street = sd.StreetCanyon(9.0, 12.0, 40 * deg, 0.2, 0.4, strips=6)
    places = [(1.0, 0.0, sd.ZENITH), (-6.0, 2.0, street.right)]
    planes = [sd.Plane.facing(normal, street.at(x, z)) for x, z, normal in places]
    hours = [int(np.argmax(fine.direct_normal_illuminance.values)), 4093, 300]
    light = sd.on_planes(fine.isel(time=hours), planes)
    for row, hour in enumerate(hours):
        sky, disc = moment(fine.isel(time=hour))
        for k, (x, z, normal) in enumerate(places):
            exact = street.illuminance(sky + disc, [x], z, normal)
            for part in ("sky", "sun", "reflected"):
                own, whole = float(getattr(exact, part)[0]), float(exact.total[0])
                assert light[f"{part}_illuminance"].values[row, k] == pytest.approx(own, rel=0.01, abs=0.004 * whole)


def test_faces_of_a_mesh_light_each_other_as_the_scene_says():
    yard = sd.MeshScene(
        [[0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 0], [0, 6, 3], [6, 6, 3]],
        [[0, 1, 2], [0, 2, 3], [3, 2, 5], [3, 5, 4]], 0.5, 0.2,
    )  # fmt: skip
    light = FaceLight.of(yard.lit_faces(), patches("tregenza"))
    expected = yard.lit(sd.Uniform(1000.0))
    np.testing.assert_allclose(light.sky.sum(axis=1) * 1000 + light.ground * 0.2 * 1000, expected, rtol=3e-3)


def test_a_cumulative_sky_is_gendaymtxs_mean(greensboro, files, run_radiance):
    """The year added up, sky without sun, against `gendaymtx -A -s -O1` times the hours, patch by patch."""
    skies = sd.year(files["wea"], compat="gendaymtx")
    total = sd.cumulative_sky(skies)
    text = run_radiance("gendaymtx", "-A", "-s", "-O1", "-m", "1", files["wea"]).stdout.decode().split("\n\n", 1)[1]
    theirs = np.array([float(line.split()[1]) for line in text.split("\n") if line])[1:] * greensboro.count / 1000
    ours = total.sky_radiant_exposure.values
    assert float((ours * total.horizontal_solid_angle).sum()) == pytest.approx(
        (theirs * total.horizontal_solid_angle.values).sum(), rel=0.01
    )
    assert np.median(np.abs(ours / theirs - 1)) < 0.03


def test_a_cumulative_sky_lights_a_plane_as_its_hours_do(fine):
    working = (fine.local_time.dt.hour >= 8) & (fine.local_time.dt.hour < 18)
    total = sd.cumulative_sky(fine, working.values)
    view = PatchView.of(Open(), PLANES[1].normal, looks_into(patches("reinhart:4")))
    chosen = sd.on_planes(fine.isel(time=np.flatnonzero(working.values)), PLANES[1])
    assert float(total.sky_radiant_exposure.values @ view.weights) == pytest.approx(
        float(sd.monthly_sums(chosen).sky_irradiation.sum()), rel=1e-5
    )
    assert float(total.sun_radiant_exposure.values @ view.weights) == pytest.approx(
        float(sd.monthly_sums(chosen).sun_irradiation.sum()), rel=0.01
    )


def test_what_cannot_be_is_refused(fine):
    hills = sd.Horizon.level(0.1)
    for message, call in (
        ("at least one Plane", lambda: sd.on_planes(fine, [])),
        ("albedo must lie", lambda: sd.on_planes(fine, sd.Plane(), albedo=1.5)),
        ("open planes only", lambda: sd.on_planes(fine, sd.Plane(0.0, 0.0, hills), transposition="perez-1990")),
        ("transposition must be one of", lambda: sd.on_planes(fine, sd.Plane(), transposition="klucher")),
        ("the tilt of a plane", lambda: sd.Plane(4.0)),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(TypeError, match="planes must be Plane"):
        sd.on_planes(fine, [(0.0, 0.0)])


def test_missing_hours_are_missing_on_planes(greensboro):
    gone = np.where(np.arange(greensboro.count) == 12, np.nan, greensboro.direct_normal)
    from dataclasses import replace

    skies = sd.year(replace(greensboro, direct_normal=gone).rows(slice(0, 24)))
    light = sd.on_planes(skies, sd.Plane())
    assert np.isnan(light.irradiance.values[12, 0])
    assert np.isfinite(light.irradiance.values[11, 0])
    assert float(sd.monthly_sums(light).missing_hours.sum()) == 1
