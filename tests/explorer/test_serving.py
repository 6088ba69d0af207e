"""`skydome explore` and its server: this machine alone, the page's files alone."""

import subprocess
import sys
from http.client import HTTPConnection
from urllib.request import urlopen

import pytest

import skydome as sd
from skydome.explorer.address import address_of
from skydome.explorer.serving import page_server

COMMAND = [sys.executable, "-c", "from skydome.cli.main import run; run()", "explore", "--no-browser"]


def test_the_command_serves_the_page_and_a_weather_file(tmp_path):
    (tmp_path / "site.epw").write_text("LOCATION,x")
    asked = ["--place", "45.07,7.69", "--time", "2026-06-21T15:00", "--zone", "Europe/Rome", "--model", "preetham"]
    with subprocess.Popen(
        [*COMMAND, *asked, "--weather", str(tmp_path / "site.epw")], stdout=subprocess.PIPE, text=True
    ) as process:
        address = process.stdout.readline().strip()
        try:
            assert address.endswith(
                "?v=1&place=45.07,7.69&zone=Europe/Rome&date=2026-06-21&time=15:00&model=preetham&url=weather.epw"
            )
            root = address.split("?")[0]
            with urlopen(root) as page, urlopen(root + "weather.epw") as weather:
                assert b"skydome-explorer" in page.read()
                assert weather.read() == b"LOCATION,x"
        finally:
            process.terminate()


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--model", "preethan"], "model must be one of"),
        (["--weather", "none.epw"], "none.epw"),
        (["--weather", "x.csv"], "the explorer reads .epw files"),
        (["--port", "70000"], "--port must lie in [0, 65535]"),
        (["--place", "95,7"], "latitude must lie in [-90, 90]"),
    ],
)
def test_bad_input_ends_in_one_line(options, said):
    done = subprocess.run([*COMMAND, *options], capture_output=True, text=True)
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("path", "host", "status"),
    [
        ("/", None, 200),
        ("/explorer.js", None, 200),
        ("/", "evil.example", 403),
        ("/../serving.py", None, 404),
        ("/%2e%2e/serving.py", None, 404),
        ("/weather.epw", None, 404),
    ],
)
def test_only_the_page_and_only_to_this_machine(path, host, status):
    with page_server() as server:
        connection = HTTPConnection("127.0.0.1", server.server.server_port)
        connection.request("GET", path, headers={"Host": host} if host else {})
        assert connection.getresponse().status == status
        connection.close()


def test_skies_have_addresses():
    sun = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)
    assert address_of(sd.CIE(sun, type=12, zenith_luminance=3000.0)) == "?v=1&model=cie-12&sun=200,40"
    sky = sd.HosekWilkie(sun, 3.0)
    assert address_of(sky + sd.SunDisc.of(sky)).startswith("?v=1&model=hosek-wilkie&sun=200,40&turbidity=3")
    air = sd.Atmosphere.urban(0.3, ozone=300.0, albedo=0.3)
    told = address_of(sd.PhysicalSky(sun, air))
    assert told.endswith("&albedo=0.3&turbidity=4.0907&aerosol=urban&ozone=300")
    letters = sd.Perez(sun, -0.9, -0.2, 6.0, -3.5, 0.3, illuminance=9000.0)
    assert address_of(letters).endswith("&letters=-0.9,-0.2,6,-3.5,0.3&lux=9000")
    cloudy = sd.CloudySky(sd.PhysicalSky(sun, air), sd.CloudField(sd.Cirrus(), cover=0.3, seed=7))
    assert address_of(cloudy + sd.SunDisc.of(cloudy)) == told + "&clouds=cirrus&clouded=0.3&seed=7"
    with pytest.raises(ValueError, match="got another field of Cumulus"):
        address_of(sd.CloudySky(sd.PhysicalSky(sun), sd.CloudField(base=900.0)))
    assert address_of(sd.OvercastSky(sun, 12.0, 0.3, kind=sd.Ice())) == (
        "?v=1&model=overcast&sun=200,40&albedo=0.3&depth=12&particles=ice"
    )
    with pytest.raises(TypeError, match="skydome models"):
        address_of(sd.blend(sky, sd.Uniform(1.0), 0.5))
