"""What the commands print is what the library says."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg

INSTANT = "2026-06-21T15:00+02:00"
TURIN = sd.Place(45.07, 7.69, 240)


@pytest.fixture(scope="module")
def sun():
    return sd.sun_direction(TURIN, INSTANT)


def test_light_of_hosek_wilkie_is_the_librarys(facts, when, sun):
    told = facts("light", *when, "--model", "hosek-wilkie", "--turbidity", 4, "--albedo", 0.3, "--normal", "180,0")
    sky = sd.HosekWilkie(sun, turbidity=4.0, albedo=0.3)
    disc = sd.SunDisc.of(sky, angular_radius=float(sd.solar_radius(INSTANT)))
    light = told["illuminance_lx"]
    assert told["zenith_luminance_cd_m2"] == pytest.approx(float(sky.luminance(sd.ZENITH)), rel=1e-12)
    assert light["diffuse"] == pytest.approx(float(sd.illuminance(sky)), rel=1e-9)
    assert light["direct_normal"] == pytest.approx(float(disc.illuminance(sun)), rel=1e-12)
    assert light["global"] == pytest.approx(float(sd.illuminance(sky + disc)), rel=1e-9)
    assert light["plane"] == pytest.approx(float(sd.illuminance(sky + disc, sd.SOUTH)), rel=1e-12)
    kelvin = told["colour_temperature_K"]
    assert kelvin["zenith"] == pytest.approx(float(sd.colour_temperature(sky.xyz(sd.ZENITH))), rel=1e-12)
    assert 5000 < kelvin["global"] < 7000 < kelvin["diffuse"]


def test_sun_is_the_librarys(facts, when, sun):
    told = facts("sun", *when)
    place = sd.direction(told["spa"]["azimuth_deg"] * deg, told["spa"]["elevation_deg"] * deg)
    np.testing.assert_allclose(place, sun, atol=1e-12)
    assert told["refracted"]["elevation_deg"] > told["spa"]["elevation_deg"]
    assert 0 < told["preetham"]["difference_deg"] < 1.3
    events = sd.sun_events(TURIN, "2026-06-21", zone="Europe/Rome")
    assert told["events"]["sunrise"] == "2026-06-21T05:42:13+02:00"
    assert np.datetime64(events.sunrise, "s") == np.datetime64("2026-06-21T03:42:13")
    assert told["utc"] == "2026-06-21T13:00:00+00:00"


def test_a_zone_and_an_offset_mean_the_same(facts):
    zoned = facts("light", "--place", "45.07,7.69", "--time", "2026-06-21T15:00", "--zone", "Europe/Rome")
    assert zoned["sun"] == facts("light", "--place", "45.07,7.69", "--time", INSTANT)["sun"]
    assert zoned["time"] == "2026-06-21T15:00:00+02:00"


def test_sun_without_time_is_now_and_a_polar_day_has_no_sunset(facts, call):
    assert facts("sun", "--place", "-33.9,151.2")["time"]
    events = facts("sun", "--place", "78.2,15.6", "--time", INSTANT)["events"]
    assert events["sunrise"] is None
    assert "none to none" in call("sun", "--place", "78.2,15.6", "--time", INSTANT).stdout


def test_the_direction_of_the_sun_may_be_given(facts):
    told = facts("light", "--sun", "200,40")
    assert told["sun"] == pytest.approx({"azimuth_deg": 200, "elevation_deg": 40, "angular_radius_deg": 959.63 / 3600})
    assert "place" not in told


def test_refraction_lifts_a_sun_that_has_just_set(facts, refused):
    low = ("--place", "45.07,7.69", "--time", "2026-06-21T21:16+02:00", "--model", "hosek-wilkie")
    assert "--refraction" in refused("light", *low)
    assert 0 < facts("light", *low, "--refraction")["sun"]["elevation_deg"] < 0.6


def test_the_default_is_the_physical_sky_whose_air_bends_light_itself(facts, when):
    told = facts("light", *when, "--turbidity", 2.5, "--albedo", 0.3)
    sun = sd.sun_direction(TURIN, INSTANT)
    assert told["model"] == "physical"
    assert told["sun"] == facts("light", *when, "--refraction")["sun"]
    air = sd.Atmosphere.from_turbidity(2.5, albedo=0.3).at_altitude(TURIN.altitude)
    distance = float(sd.earth_sun_distance(INSTANT))
    wanted = sd.PhysicalSky(sun, air).luminance(sd.ZENITH) / distance**2
    assert told["zenith_luminance_cd_m2"] == pytest.approx(float(wanted), rel=1e-4)
    high = facts("light", *when, "--turbidity", 2.5, "--albedo", 0.3, "--altitude", 3000)
    wanted = sd.PhysicalSky(sun, sd.Atmosphere.from_turbidity(2.5, albedo=0.3).at_altitude(3000.0)).luminance(sd.ZENITH)
    assert high["zenith_luminance_cd_m2"] == pytest.approx(float(wanted) / distance**2, rel=1e-4)
    assert any("3000 m high, 701 hPa" in note for note in high["notes"])
    evening = facts("light", "--sun", "280,-4")["illuminance_lx"]
    assert evening["direct"] == 0
    assert 10 < evening["diffuse"] < 100


EXTRA = {
    "path-traced": ("--paths", 16),
    "overcast": ("--cloud-depth", 40),
    **dict.fromkeys(("perez-all-weather", "igawa", "asrc-cie"), ("--dni", 700, "--dhi", 100)),
    "perez": ("--letters", "-1,-0.32,10,-3,0.45", "--illuminance", 12000),
}
NAMES = [
    "physical", "hosek-wilkie", "hosek-wilkie-rgb", "preetham", "neural-preetham", "neural-hosek-wilkie",
    "neural-hosek-wilkie-compact", "neural-hosek-wilkie-deep", "neural-hosek-wilkie-spectral", "perez-all-weather",
    "igawa", "asrc-cie", "perez",
    *(f"cie-{kind}" for kind in range(1, 16)),
    "cie-clear", "cie-intermediate", "matsuura-iwata", "brunger-hooper", "harrison-coombes", "pokrowski",
    "overcast", "moon-spencer", "uniform",
    "discrete-ordinates", "klassen-1987", "nishita-1993", "nishita-1996", "precomputed", "hillaire",
    "path-traced",
]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_every_model_gives_the_light_of_a_day(facts, when, name):
    told = facts("light", *when, "--model", name, *EXTRA.get(name, ()))
    light = told["illuminance_lx"]
    assert 4000 < light["diffuse"] < 60000
    assert 500 < told["zenith_luminance_cd_m2"] < 15000
    assert light["global"] == pytest.approx(light["diffuse"] + light["direct"])
    overcast = name in ("moon-spencer", "uniform", *(f"cie-{kind}" for kind in range(1, 6)))
    assert (light["direct"] == 0) == (overcast or name == "perez")
    coloured = name.startswith(
        (
            "physical",
            "discrete",
            "klassen",
            "nishita",
            "precomputed",
            "hillaire",
            "path",
            "hosek",
            "preetham",
            "neural",
            "overcast",
        )
    )
    assert any("D65" in note for note in told["notes"]) != coloured


def test_models_lists_every_model(facts, call):
    told = {model["name"]: model for model in facts("models")}
    assert list(told) == NAMES
    ranges = {item["name"]: item.get("range") for item in told["hosek-wilkie"]["parameters"]}
    assert ranges["turbidity"] == [1, 10]
    assert told["hosek-wilkie"]["rung"] == "spectral"
    assert told["hosek-wilkie-rgb"]["rung"] == "colour"
    assert told["cie-12"]["rung"] == "luminance"
    assert all(model["source"] for model in told.values())
    listed = call("models").stdout
    rows = ["cie-1 ... cie-15", *(name for name in NAMES if not name.removeprefix("cie-").isdigit())]
    assert [name for name in rows if name not in listed] == []


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("neural-preetham", {"--sun", "--turbidity"}),  # its network is settled, and knows no albedo
        ("neural-hosek-wilkie-spectral", {"--sun", "--turbidity", "--albedo"}),
        ("cie-12", {"--sun", "--zenith-luminance", "--illuminance"}),  # its type is settled
        ("uniform", {"--zenith-luminance", "--illuminance"}),
        ("path-traced", {"--sun", "--turbidity", "--albedo", "--altitude", "--until", "--paths"}),
    ],
)
def test_models_list_what_a_user_gives(facts, name, options):
    told = next(model for model in facts("models") if model["name"] == name)
    assert {item["option"] for item in told["parameters"]} == options


@pytest.mark.parametrize("name", ["uniform", "moon-spencer", "cie-intermediate", "cie-clear", "cie-7", "perez"])
def test_an_illuminance_is_met(facts, when, name):
    more = ("--letters", "-1,-0.32,10,-3,0.45") if name == "perez" else ()
    told = facts("light", *when, "--model", name, "--illuminance", 12345, "--no-sun", *more)
    assert told["illuminance_lx"]["diffuse"] == pytest.approx(12345, rel=1e-4)
    assert told["illuminance_lx"]["direct"] == 0


def test_a_uniform_sky_of_a_given_level_needs_no_sun(facts):
    told = facts("light", "--model", "uniform", "--zenith-luminance", 1000)
    assert told["illuminance_lx"]["diffuse"] == pytest.approx(1000 * np.pi)
    assert "sun" not in told


def test_levels_that_were_chosen_are_told(facts, when, sun):
    told = facts("light", *when, "--model", "cie-3")
    assert told["zenith_luminance_cd_m2"] == pytest.approx(float(sd.overcast_zenith_luminance(sun)))
    assert any("usual overcast" in note for note in told["notes"])
    told = facts("light", *when, "--model", "cie-12", "--turbidity", 4)
    assert told["zenith_luminance_cd_m2"] == pytest.approx(float(sd.clear_zenith_luminance(sun, 4.0)))


def test_blending_dims_clear_sky_and_sun(facts, when, sun):
    clear, mixed = facts("light", *when), facts("light", *when, "--blend-overcast", 0.25)
    under = sd.OvercastSky(sun)
    overcast = float(sd.overcast_zenith_luminance(sun) * sd.illuminance(under) / under.luminance(sd.ZENITH))
    first, second = clear["illuminance_lx"], mixed["illuminance_lx"]
    assert second["diffuse"] == pytest.approx(0.75 * first["diffuse"] + 0.25 * overcast, rel=1e-3)
    assert second["direct_normal"] == pytest.approx(0.75 * first["direct_normal"])


def test_irradiance_sets_the_disc(facts, when, sun):
    told = facts("light", *when, "--dni", 800)
    disc = sd.SunDisc.from_irradiance(sun, 800.0)
    assert told["illuminance_lx"]["direct_normal"] == pytest.approx(float(disc.illuminance(sun)))
    perez = facts("light", *when, "--model", "perez-all-weather", "--dni", 800, "--dhi", 110)
    sky = sd.PerezAllWeather(sun, 800.0, 110.0, 1367 / sd.earth_sun_distance(INSTANT) ** 2)
    assert perez["illuminance_lx"]["direct_normal"] == pytest.approx(float(sky.direct_normal_illuminance))
    assert perez["illuminance_lx"]["diffuse"] == pytest.approx(float(sky.diffuse_illuminance), rel=1e-4)


def test_clamping_is_told(facts, when):
    assert facts("light", *when, "--turbidity", 12, "--check", "clamp")["valid"] is False
    assert facts("light", *when)["valid"] is True


def test_light_that_is_nan_when_asked_is_null(facts, call, when):
    asked = ("light", *when, "--model", "hosek-wilkie", "--turbidity", 12, "--check", "nan")
    told = facts(*asked)
    assert told["zenith_luminance_cd_m2"] is None
    assert {each["parameter"]: each["used"] for each in told["outside_ranges"]} == {"turbidity": None}
    assert "turbidity 12 is outside [1, 10]: no light (nan)" in " ".join(call(*asked).stdout.split())


def test_colours_beyond_every_black_body_are_null(facts, call, when):
    sky = ("--model", "uniform", "--chromaticity", "0.22,0.22")
    told = facts("light", *when, *sky)
    assert told["colour_temperature_K"]["zenith"] is None
    assert "bluer than any black body" in call("light", *when, *sky).stdout


def test_colour_by_a_named_rule(facts, refused):
    asked = ("light", "--sun", "180,30", "--model", "cie-12")
    plain = facts(*asked)
    for rule in ("luminance", "preetham"):
        told = facts(*asked, "--colour", rule)
        assert told["zenith_luminance_cd_m2"] == pytest.approx(plain["zenith_luminance_cd_m2"])
        assert told["colour_temperature_K"]["diffuse"] > 8000
        assert any(note.startswith("colour: ") for note in told["notes"])
    assert "knows its own colour" in refused("light", "--sun", "180,30", "--model", "preetham", "--colour", "luminance")
    assert "a model that knows colour" in refused(*asked, "--colour", "uniform")
    assert "one of them" in refused(*asked, "--colour", "luminance", "--chromaticity", "0.3,0.3")


def test_visibility_is_the_other_way_to_say_turbidity(facts, when, refused):
    """20 km are turbidity 3.3 by Preetham's Figure 3; both together, and more than clean air allows, are refused."""
    turbidity = 3.3005727891589816
    seen, hazed = (
        facts("light", *when, "--model", "preetham", *words)
        for words in (("--visibility", "20km"), ("--turbidity", turbidity))
    )
    assert seen["zenith_luminance_cd_m2"] == pytest.approx(hazed["zenith_luminance_cd_m2"], rel=1e-12)
    assert "haze: one sees 20 km, turbidity 3.3" in seen["notes"]
    for words, message in (
        (("--visibility", "20km", "--turbidity", "3"), "give one of them"),
        (("--visibility", "400km"), "--visibility must lie in"),
        (("--visibility", "far"), "for '--visibility': a visibility is a distance such as 20km"),
    ):
        assert message in refused("light", *when, "--model", "preetham", *words)
