"""Stars against skyfield, glows against published figures, the sum of all by the hour, eclipses."""

from dataclasses import replace
from importlib.resources import files

import numpy as np
import pytest

import skydome as sd
from skydome.air.cross_sections import solar_irradiance
from skydome.ground.units import deg
from skydome.light.spectrum import xyz_weights
from skydome.skies.night.airglow import van_rhijn
from skydome.skies.night.celestial import UNIT
from skydome.skies.night.clouds.layer_in_air import LayerInAir
from skydome.skies.night.clouds.overcast import BANDS as LAYER_BANDS
from skydome.skies.night.clouds.overcast import under
from skydome.skies.night.eclipse import Eclipse
from skydome.skies.night.held_dome import NODES
from skydome.skies.night.magnitudes import BANDS, illuminance_of, starlight_of, temperature_of
from skydome.skies.night.scattering import GlowScattering, at_bands, toward
from skydome.skies.night.skyglow import BORTLE
from skydome.skies.night.through_air import Air
from skydome.skies.night.zodiacal import filled
from skydome.stars.catalogue import EPOCH, hipparcos
from skydome.stars.directions import star_directions
from skydome.sun.geocentric import days_since_j2000

PLACE = sd.Place(50.0, 8.0)
MOONLESS, FULL = "2026-01-18T22:00Z", "2026-01-03T22:00Z"


@pytest.fixture(scope="module")
def sky():
    """DE421 and skyfield's time scale, by UT1 as ours."""
    from skyfield.api import load, load_file

    scale = load.timescale(builtin=True)
    ephemeris = load_file(str(files("skyfield_data") / "data" / "de421.bsp"))
    yield ephemeris, lambda times: scale.ut1_jd(2451545.0 + days_since_j2000(np.asarray(times, "datetime64[us]")))
    ephemeris.close()


@pytest.mark.parametrize("time", ["1950-03-01T22:00", "2026-01-15T22:00", "2050-09-09T22:00"])
def test_stars_stand_where_skyfield_has_them(sky, time):
    from skyfield.api import Star, wgs84

    ephemeris, scale = sky
    table = hipparcos(3.5)
    places, motion = (table.right_ascension, table.declination), (table.along, table.north)
    utc = np.datetime64(time, "us")
    ours = star_directions(PLACE, utc, *places, motion, table.parallax, EPOCH)
    stars = Star(
        ra_hours=places[0] * 12 / np.pi, dec_degrees=places[1] / deg, ra_mas_per_year=motion[0],
        dec_mas_per_year=motion[1], parallax_mas=table.parallax, epoch=2451545 + (EPOCH - 2000) * 365.25,
    )  # fmt: skip
    station = ephemeris["earth"] + wgs84.latlon(PLACE.latitude, PLACE.longitude)
    elevation, azimuth, _ = station.at(scale(utc)).observe(stars).apparent().altaz()
    off = sd.angle_between(ours, sd.direction(azimuth.radians, elevation.radians)) / deg
    assert {32349, 91262, 17702} <= set(table.number.astype(int))  # Sirius, Vega, Alcyone
    assert off.max() < 1e-4


def test_magnitudes_of_the_catalogue():
    table = hipparcos(6.5)
    known = {32349: -1.46, 91262: 0.03, 69673: -0.05, 27989: 0.45, 11767: 1.98, 17702: 2.87, 65474: 0.97, 80763: 1.06}
    found = {int(n): m for n, m in zip(table.number, table.magnitude, strict=True)}
    assert max(abs(found[number] - value) for number, value in known.items()) < 0.12  # Bright Star Catalogue
    assert 8500 < len(table.magnitude) < 9200


def test_energy_and_place_of_stars_on_maps():
    stars = sd.Stars.over(PLACE, MOONLESS)
    whole, mean = stars.carried.sum(axis=0)[1], stars.carried[:, 1] @ stars.directions
    for height in (256, 1024):
        picture = sd.render(stars, height, ground_albedo=0.0, dtype=np.float64)
        light = picture.pixels @ sd.SRGB.to_xyz[1] * picture.projection.solid_angles(height)
        np.testing.assert_allclose(light.sum(), whole, rtol=1e-9)
        views = picture.projection.directions(height)
        np.testing.assert_allclose(np.einsum("rc,rcd->d", light, views), mean, atol=2e-3 * whole)
    round_map = sd.render(stars, 200, projection=sd.Fisheye(), ground_albedo=0.0, dtype=np.float64)
    light = round_map.pixels @ sd.SRGB.to_xyz[1] * round_map.projection.solid_angles(200)
    np.testing.assert_allclose(light.sum(), whole, rtol=1e-9)
    outside = illuminance_of(hipparcos(6.5).magnitude)
    np.testing.assert_allclose(outside.sum(), 2.44e-4, rtol=0.01)


def test_a_star_that_moves_does_not_sparkle():
    light = sd.Stars.over(PLACE, MOONLESS).light
    peaks = []
    for step in range(5):
        toward = sd.direction(np.array([1.0 + step * 2e-3]), np.array([0.7]))
        one = type(sd.Stars.over(PLACE, MOONLESS))(toward, sd.Spectrum(light.wavelengths, light.values[:1]))
        picture = sd.render(one, 128, ground_albedo=0.0, dtype=np.float64)
        peaks.append((picture.pixels[..., 1] * picture.projection.solid_angles(128)).sum())
    np.testing.assert_allclose(peaks, peaks[0], rtol=1e-3)


def test_colours_of_stars():
    np.testing.assert_allclose(temperature_of([0.0, 0.65, 1.85]), [10125, 5770, 3250], rtol=0.03)
    light = starlight_of([0.0, 3.0], [0.0, 1.5]) @ xyz_weights(BANDS)
    np.testing.assert_allclose(light[:, 1], illuminance_of([0.0, 3.0]), rtol=1e-12)
    blue, red = (light[k, 2] / light[k, 0] for k in (0, 1))
    assert blue > 1.3 > 0.6 > red


def test_zodiacal_table_is_zodis():
    tables = pytest.importorskip("zodi.tables")
    longitudes, _, logarithm = filled()
    known = np.isfinite(tables.TABLE17_RAW)
    np.testing.assert_array_equal(longitudes, tables.LON_GRID_DEG)
    np.testing.assert_allclose(np.exp(logarithm)[known], tables.TABLE17_RAW[known])
    dust = sd.ZodiacalLight.over(PLACE, MOONLESS)
    np.testing.assert_allclose(dust.brightness(np.array([0.0, 1.0, 0.0])) / UNIT, 259.0)  # 90 degrees from the sun


def test_airglow_rises_toward_the_horizon_and_with_the_sun():
    np.testing.assert_allclose(van_rhijn(np.sin(np.array([90.0, 30.0]) * deg)), [1.0, 1.93], atol=0.02)
    quiet, active = (sd.Airglow(solar_flux=flux).luminance(sd.ZENITH) for flux in (80.0, 200.0))
    np.testing.assert_allclose(active / quiet, 275 / 145, rtol=1e-6)
    in_v = sd.v_magnitude(sd.Airglow(solar_flux=80.0), sd.ZENITH)
    np.testing.assert_allclose(in_v, 27.78 - 2.5 * np.log10(145), atol=0.005)


def test_even_light_stays_even_over_white_ground():
    """Air that takes nothing, over a ground that gives back all: whatever is scattered where, light is the same."""
    air = sd.Atmosphere((sd.Molecules(), sd.Aerosol(0.1, albedo=1.0)), albedo=1.0)
    views, bands = sd.direction(1.0, np.array([0.05, 2.0, 10.0, 45.0, 90.0]) * deg), np.array([420.0, 550.0, 650.0])
    field = GlowScattering.of(air).field(lambda toward: np.ones(toward.shape[:-1]))
    light = Air(air).transmittance(views[:, 2], bands) + toward(at_bands(field, bands), views)
    np.testing.assert_allclose(light, 1.0, atol=0.01)


def test_airglow_through_the_air_of_paranal_is_that_of_noll():
    """What depth it looks as if there were, Noll et al. 2012, eq. 24 and 25, 30 to 90 degrees."""
    glow = sd.Airglow(sd.clear_air(0.05, pressure=74_400.0))
    views, bands = sd.direction(0.0, np.array([30.0, 45.0, 90.0]) * deg), np.array([450.0, 550.0, 650.0])
    rise, air = van_rhijn(views[:, 2]), glow.air
    logarithm = np.log10(rise)[:, None]
    molecules, low, ozone, high = air.depths(bands)
    columns = (1.669 * logarithm - 0.146) * molecules + (1.732 * logarithm - 0.318) * (low + high) + ozone
    wanted = rise[:, None] * np.exp(-columns / views[:, 2:])
    found = glow.radiance(views, bands) / glow.spectrum(bands)
    print(f"airglow over Noll's: {(found / wanted).round(3).tolist()}")
    np.testing.assert_allclose(found, wanted, rtol=0.05)


def test_a_dark_sky_ends_without_a_black_line():
    """Along the horizon one sees what the air scatters, as bright as the sky above and not darker than the ground."""
    night = sd.render(sd.sky_at(PLACE, MOONLESS), 256).luminance()
    above, horizon, ground = (float(np.median(night[row])) for row in (100, 127, 128))
    assert 0.4 * above < horizon < above
    assert horizon > 2 * ground


def test_a_night_is_as_turbid_as_a_day_may_be():
    moment = (sd.Place(45, 7), "2026-11-29T23:00+00:00")
    clear, turbid = (sd.sky_at(*moment, air=sd.Atmosphere.from_turbidity(t)) for t in (8.0, 10.0))
    zenith = np.array([0.0, 0.0, 1.0])
    assert 0.9 < turbid.luminance(zenith) / clear.luminance(zenith) < 1.1
    with pytest.raises(ValueError, match="optical depth of aerosol"):  # refused as by day
        sd.sky_at(*moment, air=sd.Atmosphere.from_turbidity(12.0)).luminance(zenith)


def test_the_sun_in_v():
    """Willmer 2018."""
    from skydome.skies.night.magnitudes import V_BANDS, V_ZERO, v_weights

    sun = -2.5 * np.log10(solar_irradiance(V_BANDS) @ v_weights() / V_ZERO)
    assert sun == pytest.approx(-26.76, abs=0.01)


def test_colour_of_a_dark_zenith():
    """Between La Palma (.8, .9), Paranal (1.0, .7) and Mauna Kea (B - V .93: Krisciunas 1997); the sun has .65, .35."""
    high = sd.Place(30.0, 8.0)
    night = sd.sky_at(high, "2026-04-16T23:30Z", only=["airglow", "zodiacal light", "starlight"])
    steps = [np.arange(c - w / 2, c + w / 2 + 1, 5.0) for c, w in ((438, 90), (545, 85), (655, 140))]
    ratio = [night.radiance(sd.ZENITH, band).mean() / solar_irradiance(band).mean() for band in steps]
    blue, red = -2.5 * np.log10(ratio[0] / ratio[1]) + 0.65, -2.5 * np.log10(ratio[1] / ratio[2]) + 0.35
    print(f"B - V {blue:.2f}, V - R {red:.2f}")
    assert 0.8 < blue < 1.0
    assert 0.7 < red < 0.9


def test_skyglow_by_class_and_meter():
    for number, magnitude in enumerate(BORTLE, 1):
        glow = float(sd.SkyGlow.of_bortle(number).luminance(sd.ZENITH))
        natural = 1.711e-4
        np.testing.assert_allclose(sd.surface_magnitude(glow + natural), magnitude, atol=0.01)
    with pytest.raises(ValueError, match="class must lie in"):
        sd.SkyGlow.of_bortle(10)


@pytest.mark.parametrize(
    "glow", [sd.Airglow(), sd.Starlight.over(PLACE, MOONLESS), sd.ZodiacalLight.over(PLACE, MOONLESS)]
)
def test_held_domes_and_level_light(glow):
    views = np.random.default_rng(0).normal(size=(2000, 3))
    views[:, 2] = np.abs(views[:, 2]) + 0.02
    views /= np.linalg.norm(views, axis=1, keepdims=True)
    off = np.abs(glow.for_maps.luminance(views) / glow.luminance(views) - 1)
    assert np.percentile(off, 99) < 0.015
    np.testing.assert_allclose(glow.on_level[1], sd.illuminance(glow), rtol=5e-3)
    for projection in (sd.Equirectangular(), sd.Equirectangular(mirrored=True, azimuth_left=1.0)):
        picture = sd.render(glow + 2.0 * sd.Airglow(), 64, projection=projection)  # painted by rows, both as one
        seen = projection.directions(64)[:32]
        light = glow.for_maps.rgb(seen) + 2.0 * sd.Airglow().for_maps.rgb(seen)
        np.testing.assert_allclose(picture.pixels[:32], light, rtol=1e-4, atol=1e-9)
    assert NODES == (24, 48)


def test_a_dark_zenith_and_a_moonless_night():
    high = sd.Place(30.0, 8.0)
    night = sd.sky_at(high, "2026-04-16T23:30Z")  # new moon; zenith far from Milky Way and ecliptic
    zenith = float(sd.v_magnitude(night.without("moonlight"), sd.ZENITH))
    whole = float(sd.illuminance(sd.sky_at(PLACE, MOONLESS)))
    print(f"zenith {zenith:.2f} mag, moonless night {whole * 1e3:.2f} mlx")
    assert 21.6 < zenith < 22.1
    assert 6e-4 < whole < 2e-3


def test_parts_by_the_hour():
    assert sd.sky_at(PLACE, "2026-06-29T12:00Z").names == ("sky", "sun")
    dusk = sd.sky_at(PLACE, "2026-01-18T16:20Z")
    assert dusk.names == ("sky", "moonlight", "planets", "stars")
    night = sd.sky_at(PLACE, MOONLESS)
    assert night.names == ("planets", "stars", "starlight", "zodiacal light", "airglow")
    parts = [float(sd.illuminance(night[name])) for name in night.names]
    np.testing.assert_allclose(sum(parts), float(sd.illuminance(night)), rtol=1e-3)
    assert sd.sky_at(PLACE, MOONLESS, only=["airglow"]).names == ("airglow",)
    assert any("below -18" in note for note in night.notes)
    with pytest.raises(ValueError, match="light on the level through all of them"):
        sd.sky_at(PLACE, [MOONLESS, FULL])
    for wrong, words in ((["sun"], "gives light at that hour"), (["aurora"], "a part must be one of")):
        with pytest.raises(ValueError, match=words):
            sd.sky_at(PLACE, MOONLESS, only=wrong)


def test_light_falls_without_a_step_through_dusk():
    start = np.datetime64("2026-04-16T16:30")  # new moon
    light = sd.light_at(PLACE, start + np.arange(0, 270, 5) * np.timedelta64(1, "m"))
    jumps = np.abs(np.diff(np.log(light.total)))
    print(f"largest step of 5 minutes: {jumps.max():.3f}")
    assert jumps.max() < 1.1
    assert light.total[0] > 5e3
    assert 6e-4 < light.total[-1] < 2e-3


def test_obscuration_against_skyfield(sky):
    ephemeris, scale = sky
    from skyfield.api import wgs84

    for place, start in ((sd.Place(40.4, -3.7), "2026-08-12T17:40"), (sd.Place(25.7, 32.6), "2027-08-02T08:40")):
        times = np.datetime64(start, "us") + np.arange(0, 90, 3) * np.timedelta64(1, "m")
        at = (ephemeris["earth"] + wgs84.latlon(place.latitude, place.longitude)).at(scale(times))
        sun, moon = (at.observe(ephemeris[name]).apparent() for name in ("sun", "moon"))
        angle = sun.separation_from(moon).radians
        ours = Eclipse.over(place, times)
        away = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)
        axis = np.broadcast_to([1.0, 0.0, 0.0], away.shape)
        theirs = Eclipse(axis, away, ours.sun_radius, np.arcsin(1737.4 / moon.distance().km))
        print(f"obscuration within {np.abs(ours.obscuration - theirs.obscuration).max():.4f}")
        np.testing.assert_allclose(ours.obscuration, theirs.obscuration, atol=0.002)


def test_an_eclipse_dims_sun_and_sky():
    place = sd.Place(51.5, 0.0)
    before, deep = (sd.sky_at(place, f"2026-08-12T{time}Z") for time in ("16:30", "18:13"))
    eclipse = Eclipse.over(place, "2026-08-12T18:13Z")
    assert float(eclipse.obscuration) > 0.9
    ratio = float(deep["sun"].normal_xyz[1]) / float(before["sun"].normal_xyz[1])
    assert ratio < 0.1
    left = eclipse.left(np.array([400.0, 700.0]))
    assert left[0] < left[1]  # the limb that is left is redder
    assert any("eclipse" in note for note in deep.notes)
    assert any("no moon: it is before the sun" in note for note in deep.notes)
    np.testing.assert_allclose(Eclipse.over(place, "2026-01-01T12:00Z").left(np.array([500.0])), 1.0)


def test_without_the_catalogue_there_are_no_stars_and_a_note(monkeypatch):
    """The default install has no extra `night`; the command line ended with an error there."""
    from skydome.skies.night import hour

    monkeypatch.setattr(hour, "is_installed", lambda: False)
    night = sd.sky_at(sd.Place(50.0, 8.0), "2026-01-18T22:00Z")
    assert "planets" in night.names
    assert "stars" not in night.names
    assert any('pip install "skydome[night]"' in note for note in night.notes)


@pytest.mark.parametrize(("elevation", "depth", "albedo"), [(60.0, 20.0, 0.8), (6.0, 50.0, 0.2)])
def test_light_under_an_overcast_is_that_of_discrete_ordinates(elevation, depth, albedo):
    sun, air = sd.direction(0.0, elevation * deg), replace(sd.clear_air(), albedo=albedo)
    clouded = sd.Atmosphere((*air.constituents, sd.Cloud(depth)), albedo=albedo)
    truth, layer = sd.DiscreteOrdinates(sun, clouded, streams=16), LayerInAir(sd.Cloud(depth), air, LAYER_BANDS)
    sky = sd.PhysicalSky(sun, air)
    parts = [under(part, layer) for part in (sky, sd.SunDisc.of(sky))]
    found = sum(float(sd.illuminance(part)) for part in parts)
    assert found == pytest.approx(float(sd.illuminance(truth)), rel=0.03)
    views, w = (
        sd.direction(np.radians(np.arange(15.0, 180.0, 30.0)), np.radians([[4.0], [30.0], [80.0]])),
        [450.0, 650.0],
    )
    seen = sum(part.radiance(views, w) for part in parts)
    np.testing.assert_allclose(seen.mean(axis=1), truth.radiance(views, w).mean(axis=1), rtol=0.045)


def test_clouds_by_day_and_night():
    """An overcast night has about a third of a clear one's light, as measured on Lake Stechlin (Jechow et al. 2016)."""
    clear, clouded = (
        float(sd.illuminance(sd.sky_at(PLACE, MOONLESS, clouds=clouds))) for clouds in (None, sd.Cloud(25.0))
    )
    assert 0.25 < clouded / clear < 0.4
    night = sd.sky_at(PLACE, FULL, clouds=20.0)
    assert night.names[:3] == ("moonlight", "moon", "planets")
    assert any("overcast of optical depth 20" in note for note in night.notes)
    low = sd.direction(0.0, np.array([0.05, 0.3]))
    hazeless = sd.sky_at(PLACE, FULL, sd.Atmosphere((sd.Molecules(), sd.Ozone()), albedo=0.2), clouds=20.0)
    day = sd.OvercastSky(sd.direction(np.arange(0.0, 6.0, 0.5), 0.7)[:, None], 20.0)
    darker = (day.luminance(low) / day.luminance(sd.ZENITH)).mean(axis=0)  # the sun's azimuth taken out
    np.testing.assert_allclose(hazeless.luminance(low) / hazeless.luminance(sd.ZENITH), darker, rtol=0.01)
    evening = sd.light_at(PLACE, [MOONLESS, FULL], clouds=20.0)
    np.testing.assert_allclose(evening.total[1], float(sd.illuminance(night)), rtol=5e-3)
    for wrong, words in (
        (1.0, r"must lie in \[5"),
        (61.0, r"must lie in \[5, 60\]"),
        (-1.0, r"must lie in \[5"),
        ("thick", r"as sd.CloudField\(sd.Cumulus\(\)\), the optical depth 20.0"),
    ):
        with pytest.raises((ValueError, TypeError), match=words):
            sd.sky_at(PLACE, FULL, clouds=wrong)
    with pytest.raises(ValueError, match="must not be given together"):
        sd.sky_at(PLACE, FULL, clouds=20.0, glow=sd.SkyGlow())
    layered = sd.Atmosphere((*sd.clear_air().constituents, sd.Cloud(20.0)))
    for time in (MOONLESS, FULL):
        with pytest.raises(ValueError, match=r"takes no layers such as a Cloud in its air; .* sky_at\(clouds=...\) do"):
            sd.sky_at(PLACE, time, layered)
