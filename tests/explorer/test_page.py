"""The page in a browser: what hands do to it, its address, its files, and what hostile ones cannot do."""

import base64
import shlex

import numpy as np
import pytest

import skydome as sd
from skydome.air.cross_sections import solar_irradiance
from skydome.ground import exr
from skydome.light.spectrum import xyz_weights
from skydome.skies.catalogue import model_named
from skydome.skies.night.moon.lunar_light import BANDS, LunarLight

pytestmark = pytest.mark.slow

EXR = """async height => {
  const bytes = await document.getElementById("skydome-explorer").explorer.exr(height);
  let text = "";
  for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
  return btoa(text);
}"""
TURIN = "?v=1&place=45.07,7.69&zone=Europe/Rome&date=2026-06-21"
HOSTILE = (
    "<img src=x onerror=alert(1)>", "javascript:alert(1)", "' onmouseover='alert(1)", "%00", "NaN", "1e999", "-1", "",
    "//evil.example/a.epw", "https://evil.example/a.epw", "__proto__", "constructor", "9" * 2000, "2026-02-30", "99:99",
)  # fmt: skip


def from_command(page, folder, height):
    """The map that the page's own command line writes, and the page's file."""
    from skydome.cli.main import app

    words = shlex.split(page.ask("explorer.words")["command"])[1:]
    words[words.index("-o") + 1] = str(folder / "command.exr")
    with pytest.raises(SystemExit) as ended:
        app([*words, "--height", str(height)], prog_name="skydome")
    assert ended.value.code == 0
    (folder / "page.exr").write_bytes(base64.b64decode(page.page.evaluate(EXR, height)))
    return (sd.load(folder / f"{name}.exr") for name in ("command", "page"))


@pytest.mark.parametrize(
    "query",
    [
        f"{TURIN}&time=15:00&turbidity=3&target=blender",
        f"{TURIN}&time=20:50&model=preetham&turbidity=2.5",
        "?sun=120.5,33.25&model=neural-hosek-wilkie-spectral&albedo=0.4&target=skylibs",
        f"{TURIN}&time=09:10&model=perez-all-weather&dni=640&dhi=95&target=usd",
        f"{TURIN}&time=12:30&model=cie-12&turbidity=2.8",
        f"{TURIN}&time=10:30&model=perez&letters=-0.9,-0.2,6,-3.5,0.3&lux=15500&turbidity=2.4",
        f"{TURIN}&time=17:00&model=harrison-coombes&cloud=0.35",
        f"{TURIN}&time=17:00&model=uniform",
        f"{TURIN}&time=12:40&model=overcast&depth=14&particles=ice&albedo=0.3&target=blender",
    ],
)
def test_a_file_is_what_the_command_writes(opened, tmp_path, query):
    wanted, found = from_command(opened(query), tmp_path, 64)
    assert found.projection == wanted.projection
    assert {"latitude", "time"} <= set(found.metadata) or "sun=" in query
    scale = np.median(wanted.pixels[:32])
    np.testing.assert_allclose(found.pixels, wanted.pixels, rtol=1e-3, atol=1e-3 * scale)


def test_its_python_runs_and_is_the_same_sky(opened, tmp_path, monkeypatch):
    page = opened(f"{TURIN}&time=16:20&turbidity=2.2&albedo=0.3")
    monkeypatch.chdir(tmp_path)
    exec(page.ask("explorer.words")["python"].replace("height=1024", "height=64"), {})
    (tmp_path / "page.exr").write_bytes(base64.b64decode(page.page.evaluate(EXR, 64)))
    wanted, found = exr.read(tmp_path / "sky.exr")[0], exr.read(tmp_path / "page.exr")[0]
    np.testing.assert_allclose(found, wanted, rtol=1e-3)


def test_the_physical_skys_python_is_the_same_sky(opened, tmp_path, monkeypatch):
    page = opened(f"{TURIN}&time=16:00&model=physical&aerosol=desert&ozone=300&turbidity=4")
    monkeypatch.chdir(tmp_path)
    exec(page.ask("explorer.words")["python"].replace("height=1024", "height=32"), {})
    (tmp_path / "page.exr").write_bytes(base64.b64decode(page.page.evaluate(EXR, 32)))
    wanted, found = exr.read(tmp_path / "sky.exr")[0][:16], exr.read(tmp_path / "page.exr")[0][:16]
    assert np.quantile(np.abs(found / wanted - 1), 0.95) < 0.02


def test_a_nights_python_has_every_light_that_its_command_has(opened, tmp_path, monkeypatch):
    """Moon and stars too, not the twilight alone; what straddles two texels may lie in either."""
    page = opened(f"{TURIN}&time=22:30&model=physical")
    wanted = next(from_command(page, tmp_path, 16)).pixels
    monkeypatch.chdir(tmp_path)
    exec(page.ask("explorer.words")["python"].replace("height=1024", "height=16"), {})
    found = exr.read(tmp_path / "sky.exr")[0]
    assert np.quantile(np.abs(found / wanted - 1), 0.95) < 1e-4
    np.testing.assert_allclose(found.sum((0, 1)), wanted.sum((0, 1)), rtol=1e-3)


def test_its_clouds_are_the_commands_in_the_same_places(opened, tmp_path, monkeypatch):
    page = opened(f"{TURIN}&time=15:00&model=physical&clouds=cumulus&clouded=0.45&seed=7")
    page.wait_for("document.getElementById('skydome-explorer').explorer.clouds.took.length > 1")
    wanted, found = (each.pixels[:16] for each in from_command(page, tmp_path, 32))
    assert "--clouds cumulus --cover 0.45 --seed 7" in page.ask("explorer.words")["command"]
    error = np.abs(found / wanted - 1)
    told = np.median(error), np.quantile(error, 0.8), np.corrcoef(found[..., 1].ravel(), wanted[..., 1].ravel())[0, 1]
    print(f"page over command: median {told[0]:.3f}, four fifths within {told[1]:.3f}, correlation {told[2]:.3f}")
    assert told[0] < 0.01
    assert told[1] < 0.04  # edges of clouds, which the map blurs
    assert told[2] > 0.96
    monkeypatch.chdir(tmp_path)
    exec(page.ask("explorer.words")["python"].replace("height=1024", "height=32"), {})
    np.testing.assert_allclose(exr.read(tmp_path / "sky.exr")[0][:16], wanted, rtol=1e-3)


def test_its_clouds_have_the_commands_light_under_a_low_sun(opened, tmp_path):
    """Of the air below them too, where the sun comes through nowhere: by diffuse light alone."""
    page = opened("?v=1&sun=200,1.5&model=physical&clouds=cumulus&clouded=0.5&seed=11")
    page.wait_for("document.getElementById('skydome-explorer').explorer.clouds.took.length > 1")
    wanted, found = (each.pixels[:16, :, 1] for each in from_command(page, tmp_path, 32))
    rings = np.sin((np.arange(16) + 0.5) / 32 * np.pi)[:, None]
    told = [np.sum((found * rings)[rows]) / np.sum((wanted * rings)[rows]) for rows in (slice(8), slice(8, 16))]
    print(f"page over command: above 45 degrees {told[0]:.3f}, below {told[1]:.3f}")
    assert np.abs(np.array(told) - 1).max() < 0.02


def test_its_clouds_leave_the_suns_disc_what_the_librarys_do(opened):
    page = opened("?v=1&sun=200,15&model=physical&clouds=altocumulus&clouded=0.5&seed=2")
    page.wait_for("document.getElementById('skydome-explorer').explorer.clouds.took.length > 0")
    clear = model_named("physical").make(sd.direction(200 * sd.deg, 15 * sd.deg), {"turbidity": 3.0})
    wanted = sd.CloudySky(clear, sd.CloudField(sd.Altocumulus(), cover=0.5, seed=2)).sun_share
    assert page.ask("explorer.clouds.map.sun") == pytest.approx(wanted, rel=5e-3)


def test_its_lowest_sun_stands_behind_a_whole_cover(opened):
    page = opened(f"{TURIN}&model=physical&sun=180,0.1&clouds=stratocumulus&clouded=1&seed=7")
    page.wait_for("document.getElementById('skydome-explorer').explorer.clouds.took.length > 0")
    assert page.ask("explorer.numbers")[0]["direct"][1] < 1e-6


@pytest.mark.parametrize("model", ["hosek-wilkie", "preetham", "cie-4", "asrc-cie", "neural-hosek-wilkie-spectral"])
def test_its_shader_compiles(opened, model):
    page = opened(f"?model={model}&sun=200,40")
    code = """text => {
      const gl = document.createElement("canvas").getContext("webgl2");
      const shader = gl.createShader(gl.FRAGMENT_SHADER);
      gl.shaderSource(shader, "#version 300 es\\nprecision highp float;\\n" + text
        + "in vec3 d; out vec4 c; void main() { c = vec4(skydome_rgb(d), 1.0); }");
      gl.compileShader(shader);
      return gl.getShaderInfoLog(shader);
    }"""
    assert page.page.evaluate(code, page.ask("explorer.words")["shader"]).strip("\0") == ""


def test_the_physical_skys_shader_is_the_librarys(opened):
    page = opened("?model=physical&sun=200,40&turbidity=3.4&albedo=0.35", viewport={"width": 480, "height": 360})
    sky = model_named("physical").make(sd.direction(200 * sd.deg, 40 * sd.deg), {"turbidity": 3.4, "albedo": 0.35})
    words, wanted = page.ask("explorer.words"), sd.shader_numbers(sky)
    assert words["shader"] == sd.shader(sky, uniforms=True)
    found = np.array(words["numbers"], np.float32)
    np.testing.assert_allclose(found[:19], wanted[:19], rtol=1e-4, atol=1e-6)
    found, wanted = (numbers[19:].reshape(-1, 12) for numbers in (found, wanted))
    assert (np.abs(found - wanted).max(0) < 2e-2 * np.abs(wanted).max(0)).all()


def drag_sun(page, dx, dy):
    """Take hold of the sun and move it by so many pixels."""
    box = page.page.locator(".over").bounding_box()
    left, top, width, height = (box[name] for name in ("x", "y", "width", "height"))
    u, v = page.ask("explorer.sunPlace")
    x, y = left + u * width, top + v * height
    mouse = page.page.mouse
    mouse.move(x, y)
    mouse.down()
    for step in range(1, 6):
        mouse.move(x + dx * step / 5, y + dy * step / 5)
    mouse.up()
    page.page.wait_for_timeout(250)
    page.settle()


@pytest.mark.parametrize("view", ["dome", "panorama"])
def test_dragging_the_sun_changes_picture_and_numbers(opened, view):
    page = opened(f"{TURIN}&time=16:00&view={view}&look=250")
    before, sun, picture = page.ask("explorer.numbers[0].global[1]"), page.ask("explorer.sun"), page.page.screenshot()
    drag_sun(page, -60, 40)
    assert page.ask("explorer.sun") != sun
    assert abs(page.ask("explorer.numbers[0].global[1]") / before - 1) > 0.02
    assert page.page.screenshot() != picture
    assert "sun=" in page.page.url


def test_keys_are_heard_before_anything_is_clicked_and_once(opened):
    page = opened(f"{TURIN}&time=16:00")
    for key in (".", "d", "ArrowUp"):
        page.page.keyboard.press(key)
        page.settle()
    state = page.ask("explorer.state")
    assert (state["minutes"], state["view"]) == (1020, "panorama")
    found = state["sun"]
    page.page.locator(".over").focus()
    page.page.keyboard.press("ArrowUp")
    page.settle()
    assert page.ask("explorer.state.sun[1]") == pytest.approx(found[1] + 1)


def test_an_address_comes_back_as_it_was(opened):
    query = (
        "?v=1&model=preetham&beside=cie-12&place=-33.868,151.207&zone=Australia/Sydney&date=2027-01-05&time=07:42"
        "&turbidity=4.2&view=panorama&look=95&show=luminance&ev=12.5&bar=2.5,4.5&wipe=0.3&path=no&analemma=yes"
        "&target=three&theme=light&aerosol=desert&ozone=300&haze=visibility&moon=no&letters=-0.9,-0.2,6,-3.5,0.3&lux=9000"
        "&share=0.4&clearness=0.6&cloud=0.2&depth=14&cover=0.3&particles=ice&stars=no"
    )
    page = opened(query)
    state = page.ask("explorer.state")
    assert (state["model"], state["minutes"], state["bar"], state["wipe"]) == ("preetham", 462, [2.5, 4.5], 0.3)
    again = opened("?" + page.page.url.split("?")[1])
    assert again.ask("explorer.state") == state


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_addresses_change_nothing_else(opened, text):
    from urllib.parse import quote

    keys = ["model", "beside", "place", "zone", "name", "date", "time", "sun", "turbidity", "view", "ev", "bar", "url"]
    page = opened("?" + "&".join(f"{key}={quote(text)}" for key in [*keys, "nonsense"]))
    state = page.ask("explorer.state")
    assert state["model"] == "hosek-wilkie"
    assert state["turbidity"] == 3
    assert state["url"] == ""
    assert page.page.evaluate("document.querySelectorAll('img, script:not([src]), [onmouseover]').length") == 0
    assert np.isfinite(page.ask("explorer.numbers[0].global[1]"))


def test_a_lost_context_comes_back(opened):
    page = opened(f"{TURIN}&time=11:00")
    before = page.xyz(16)
    page.page.evaluate("""() => {
      const { gl } = document.getElementById("skydome-explorer").explorer.stage.renderer;
      window.lost = gl.getExtension("WEBGL_lose_context");
      window.lost.loseContext();
    }""")
    page.page.wait_for_timeout(100)
    page.change(turbidity=5)
    page.page.evaluate("window.lost.restoreContext()")
    page.page.wait_for_timeout(300)
    page.change(turbidity=3)
    np.testing.assert_array_equal(page.xyz(16), before)


def test_the_suns_place_is_the_librarys(opened):
    page = opened()
    rng = np.random.default_rng(5)
    for _ in range(12):
        latitude, longitude = float(rng.uniform(-80, 80)), float(rng.uniform(-180, 180))
        day, minutes = f"20{rng.integers(10, 60):02d}-{rng.integers(1, 13):02d}-15", int(rng.integers(0, 1440))
        page.change(latitude=latitude, longitude=longitude, zone="Etc/GMT", date=day, minutes=minutes, sun=None)
        expected = sd.sun_direction(sd.Place(latitude, longitude), f"{day}T{minutes // 60:02d}:{minutes % 60:02d}Z")
        found = np.array(page.ask("explorer.scene.sun"))
        assert float(sd.angle_between(found, expected)) < 3e-4 * sd.deg


def test_the_moon_is_the_librarys_and_so_is_its_light(opened):
    page = opened("?model=physical&turbidity=3.4&albedo=0.35", viewport={"width": 480, "height": 360})
    air = model_named("physical").air({"turbidity": 3.4, "albedo": 0.35})
    rng = np.random.default_rng(7)
    for _ in range(6):
        latitude, longitude = float(rng.uniform(-70, 70)), float(rng.uniform(-180, 180))
        day = f"20{rng.integers(10, 60):02d}-{rng.integers(1, 13):02d}-{rng.integers(1, 28):02d}"
        hour, place = int(rng.integers(24)), sd.Place(latitude, longitude)
        page.change(latitude=latitude, longitude=longitude, zone="Etc/GMT", date=day, minutes=60 * hour)
        found, phase = page.ask("explorer.scene.moon"), sd.moon_phase(place, f"{day}T{hour:02d}:00Z")
        assert float(sd.angle_between(np.array(found["toward"]), phase.direction)) < 0.02 * sd.deg
        assert found["lit"] == pytest.approx(float(phase.illuminated), abs=1e-3)
        assert found["waxing"] == bool(phase.waxing)
        lux = LunarLight.of(phase).illuminance / (solar_irradiance(BANDS) @ xyz_weights(BANDS))[1]
        assert found["light"][1] == pytest.approx(float(lux), rel=0.04), day
    page.change(latitude=50.0, longitude=8.0, date="2026-01-03", minutes=22 * 60)
    v, u = (np.arange(16) + 0.5) / 32 * np.pi, (np.arange(64) + 0.5) / 32 * np.pi
    toward = np.asarray(sd.direction(u[None, :], np.pi / 2 - v[:, None]))
    wanted = sd.Moonlight.over(sd.Place(50.0, 8.0), "2026-01-03T22:00Z", air).held().xyz(toward)
    assert np.abs(page.xyz(32)[:16] - wanted).max() < 0.02 * wanted.max()


HEAD = "LOCATION,{name},-,ITA,IWEC,160590,45.22,7.65,1.0,287.0\n" + "-\n" * 7


def epw(name="TORINO", hours=None):
    """A short weather file."""
    rows = hours or [
        f"1983,6,21,{hour},60,x,20.0,10.0,50,101000,0,0,0,{20 * hour},{30 * hour},{10 * hour}" for hour in range(1, 25)
    ]
    return HEAD.format(name=name) + "\n".join(rows)


def show(page, text):
    """Give the page a weather file, and what it says of it."""
    page.page.evaluate("text => document.getElementById('skydome-explorer').explorer.year.show(text, 'site.epw')", text)
    page.settle()
    return page.page.locator(".notice").text_content()


def test_an_hour_of_a_weather_file_is_shown(opened):
    page = opened()
    assert show(page, epw()) == ""
    state = page.ask("explorer.state")
    assert (state["model"], state["name"], state["dni"], state["dhi"]) == ("perez-all-weather", "TORINO, ITA", 450, 150)
    expected = sd.sun_direction(sd.Place(45.22, 7.65), f"{state['date'][:4]}-06-21T14:30+01:00")
    assert float(sd.angle_between(np.array(page.ask("explorer.scene.sun")), expected)) < 1e-3 * sd.deg
    assert page.page.locator(".year").is_visible()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "line 1: an .epw file begins with LOCATION"),
        ("<script>alert(1)</script>", "line 1"),
        (epw(hours=["1983,6,21,5,60,x,20.0,10.0"]), "line 9: an hour must have 16 fields or more, got 8"),
        (epw(hours=["1983,13,21,5,60,x,20,10,50,1,0,0,0,1,1,1"]), "line 9: the month must be a number in [1, 12]"),
        (epw(hours=["1983,2,30,5,60,x,20,10,50,1,0,0,0,1,1,1"]), "line 9: the day"),
        (epw(hours=["1983,6,21,5,60,x,20,10,50,1,0,0,0,1,<img src=x onerror=alert(1)>,1"]), "line 9: the direct"),
        (HEAD.format(name="x"), "no hours"),
    ],
)
def test_damaged_weather_files_are_told_by_line(opened, text, said):
    page = opened()
    assert said in show(page, text)
    assert page.ask("explorer.state.model") == "hosek-wilkie"
    assert page.page.evaluate("document.querySelectorAll('img, script:not([src])').length") == 0


def test_names_from_files_stay_text(opened):
    page = opened()
    assert show(page, epw(name="<img src=x onerror=alert(1)>")) == ""
    assert page.page.evaluate("document.querySelectorAll('img').length") == 0
    assert "<img" in page.page.locator(".year b").text_content()
