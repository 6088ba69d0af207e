"""The night from the command line: moon and planets, a film of a day."""

import json
import sys

import numpy as np
import pytest

import skydome as sd
from skydome.cli.commands.plot import marked
from skydome.cli.night.film import film_of
from skydome.cli.options import SkyOptions
from skydome.cli.scene import scene_of
from skydome.figures.skies import sky_figure
from skydome.maps.showing.dome_axes import on_disc


def test_sun_tells_moon_and_planets(call):
    shown = call("sun", "--place", "50,8", "--time", "2026-04-19T20:00+02:00", "--moon", "--planets", "--json")
    facts = json.loads(shown.stdout)
    assert 0.06 < facts["moon"]["illuminated"] < 0.08
    assert facts["moon"]["waxing"]
    assert facts["moon"]["events"]["moonrise"].startswith("2026-04-19T06:53")
    assert [planet["name"] for planet in facts["planets"]][:2] == ["Mercury", "Venus"]
    assert facts["moon"]["eclipse_magnitude"] is None
    eclipsed = call("sun", "--place", "0,180", "--time", "2026-03-03T11:34Z", "--moon").stdout
    assert "magnitude 1.15, 2.18 penumbral" in " ".join(eclipsed.split())
    assert "bright limb" in call("sun", "--place", "50,8", "--time", "2026-04-19T20:00+02:00", "--moon").stdout


def test_a_film_of_a_day_is_taken_up_again(call, refused, tmp_path):
    film = ("animate", "--place", "50,8", "--date", "2026-01-18", "--step", "8h", "--height", "16", "-o", tmp_path)
    made = json.loads(call(*film, "--json").stdout)
    assert made["made"] == ["sky.0001.exr", "sky.0002.exr", "sky.0003.exr"]
    again = json.loads(call(*film, "--json").stdout)
    assert again["made"] == []
    assert len(again["there_before"]) == 3
    rest = json.loads(call(*film[:6], "9h", *film[7:-1], tmp_path / "rest", "--json").stdout)
    assert rest["made"] == ["sky.0001.exr", "sky.0002.exr", "sky.0003.exr"]  # 0, 9 and 18 h
    assert "--date must be a day such as" in refused(*film[:4], "2026-02-30", *film[5:-1], tmp_path / "none")
    assert not (tmp_path / "none").exists()
    assert "a day at most" in refused(*film[:6], "48h", *film[7:])
    assert "at most 100,000 frames, got 864,000" in refused(*film[:6], "0.1s", *film[7:-1], tmp_path / "new")
    assert not (tmp_path / "new").exists()
    assert "--place and --date" in refused("animate", "-o", tmp_path)
    assert "give --place and --date" in refused("animate", "--date", "2026-01-18", "-o", tmp_path)


def test_an_hour_that_comes_twice_is_told(call):
    asked = ("sun", "--place", "45,8", "--zone", "Europe/Rome", "--time")
    told = call(*asked, "2026-10-25T02:30").stderr
    assert "2026-10-25T02:30:00+02:00 is taken; the other is 2026-10-25T02:30:00+01:00" in told
    assert not any(call(*asked, time).stderr for time in ("2026-10-25T02:30+01:00", "2026-10-25T03:30"))


def test_frames_follow_the_clock_through_a_change(call, tmp_path):
    """Rome's clocks went from 2 to 3 on 29 March 2026 and from 3 to 2 on 25 October: days of 23 and 25 hours."""
    for day, hours, change in (("2026-03-29", 23, 2), ("2026-10-25", 25, 3)):
        frames = film_of(None, "45,8", day, "Europe/Rome", "1h", tmp_path, 16, None)
        offsets = [time.utcoffset().total_seconds() / 3600 for time in frames.times]
        before = 1.0 if hours == 23 else 2.0
        assert offsets == [before] * change + [3.0 - before] * (hours - change)
        orders = list(frames)
        assert [order.options.time for order in orders] == [time.isoformat() for time in frames.times]
        assert len({order.output for order in orders}) == hours
    hourly = ("render", "--place", "45,8", "--zone", "Europe/Rome", "--time", "2026-10-25T01:30", "--until",
              "2026-10-25T03:30", "--step", "1h", "--height", "8", "-o")  # fmt: skip
    assert "such as %z where clocks are put back" in call(*hourly, tmp_path / "n_%H%M.exr").stderr
    assert call(*hourly, tmp_path / "n_%H%M%z.exr").exit_code == 0
    assert {"n_0230+0200.exr", "n_0230+0100.exr"} <= {path.name for path in tmp_path.iterdir()}


def test_a_plot_of_a_night_has_its_stars_and_moon():
    scene = scene_of(SkyOptions(place="45,8", time="2026-01-03T22:00Z"), any_hour=True)
    figure = sky_figure(scene.sky, marked(scene))
    sky, bar = figure.axes
    assert sum(len(points.get_offsets()) for points in sky.collections) > 150
    assert bar.get_yticklabels()[0].get_text().startswith("0.0")
    moon = np.ravel(on_disc(scene.whole["moon"].sun))
    marked_at = [line.get_xydata().ravel() for line in sky.lines if line.get_marker() == "o"]
    np.testing.assert_allclose(marked_at, [moon], atol=1e-6)


def test_a_night_under_an_overcast(facts, refused):
    night = ("light", "--place", "45,8", "--time", "2026-01-03T22:00Z")
    under = facts(*night, "--model", "overcast", "--cloud-depth", "20")
    wanted = sd.sky_at(sd.Place(45.0, 8.0), "2026-01-03T22:00Z", clouds=20.0)
    assert under["illuminance_lx"]["global"] == pytest.approx(float(sd.illuminance(wanted)), rel=0.05)  # no haze
    assert under["zenith_luminance_cd_m2"] == pytest.approx(float(wanted.luminance(sd.ZENITH)), rel=0.05)
    assert wanted.luminance(sd.NORTH) < 0.7 * wanted.luminance(sd.ZENITH)
    shown = facts("light", "--place", "45,8", "--time", "2026-01-18T22:00Z")
    assert 21.2 < shown["zenith_v_mag_arcsec2"] < 21.6
    assert "zenith_v_mag_arcsec2" not in facts("light", "--sun", "180,30")
    assert "must lie in [5, 60], got 2" in refused(*night, "--model", "overcast", "--cloud-depth", "2")


def test_a_night_with_clouds_that_the_wind_moves(call, facts, refused, tmp_path):
    night = ("light", "--place", "45,8", "--time", "2026-01-18T22:00Z", "--clouds", "cumulus")
    shown = facts(*night, "--cover", "0.9")
    assert any(note.startswith("clouds: cumulus, cover 0.90") for note in shown["notes"])
    assert shown["illuminance_lx"]["global"] < 8e-4  # clear, it has .0012
    moved = facts(*night, "--cover", "0.9", "--wind", "7,2")
    assert moved["illuminance_lx"]["global"] != shown["illuminance_lx"]["global"]
    assert moved["illuminance_lx"]["global"] == pytest.approx(shown["illuminance_lx"]["global"], rel=0.2)
    assert "--dni needs the sun above the horizon" in refused(*night, "--dni", "400", "--dhi", "100")
    assert "--wind is of clouds" in refused(*night[:5], "--wind", "7,2")
    assert "clouds by the clock" in refused("light", "--sun", "180,30", "--clouds", "cumulus", "--wind", "7,2")
    film = (
        "animate",
        "--place",
        "45,8",
        "--date",
        "2026-01-18",
        "--step",
        "12h",
        "--height",
        "8",
        "-o",
        tmp_path / "f",
    )
    made = json.loads(call(*film, "--clouds", "cumulus", "--cover", "0.9", "--json").stdout)
    assert made["made"] == ["sky.0001.exr", "sky.0002.exr"]  # midnight and noon
    dull = json.loads(call(*film, "--model", "overcast", "--cloud-depth", "30", "--json").stdout)
    assert len(dull["made"]) == 2  # of another order
    for wrong, told in (
        (("--clouds", "fog"), "must be one of cumulus"),
        (("--model", "preetham"), "--model physical or overcast, got preetham"),
        (("--cover", "0.4"), "--cover is of clouds"),
        (("--wind", "6,2"), "--wind moves clouds"),
        (("--cloud-depth", "20"), "physical takes no --cloud-depth"),
        (("--clouds", "cumulus", "--model", "overcast"), "--clouds stand in the physical sky"),
    ):
        assert told in refused(*film[:-1], tmp_path / "none", *wrong)
    assert not (tmp_path / "none").exists()


def test_the_lamp_of_a_night_is_the_moon(call, tmp_path):
    night = ("--place", "45,8", "--time", "2026-01-03T23:00+01:00", "--height", "16")
    shown = call("render", *night, "--scene", tmp_path / "n.usda", "-o", tmp_path / "n.exr").stdout
    assert "the moon as a lamp" in " ".join(shown.split())
    assert "0.213 lx facing it" in " ".join(shown.split())
    assert "(0.213 lx facing the moon)" in " ".join(shown.split())


def test_no_disc_is_named_where_none_shines(call):
    assert "facing" not in call("light", "--place", "45,8", "--time", "2026-01-18T22:00Z").stdout
    assert "lx facing the sun)" in " ".join(call("light", "--sun", "180,30").stdout.split())


def test_north_turns_every_light_of_a_night():
    """Of an eclipsed moon too, whose shadow turns with it, and of an eclipsed sun."""
    for place, time in (("0,180", "2026-03-03T10:40Z"), ("43.37,-8.4", "2026-08-12T18:28:10Z")):
        options = SkyOptions(place=place, time=time)
        whole, plain = (scene_of(options, north, any_hour=True).whole for north in (90.0, 0.0))
        views = sd.direction(np.linspace(0.1, 6.0, 40), np.linspace(0.05, 1.5, 40))
        east_is_ahead = np.stack([-views[:, 1], views[:, 0], views[:, 2]], axis=-1)
        np.testing.assert_allclose(whole.xyz(east_is_ahead), plain.xyz(views), rtol=1e-6)
        assert float(sd.illuminance(whole)) == pytest.approx(float(sd.illuminance(plain)), rel=1e-3)
    moon, turned = (scene_of(SkyOptions(place="0,180", time="2026-03-03T10:40Z"), north, any_hour=True).whole["moon"]
                    for north in (0.0, 90.0))  # fmt: skip
    near = moon.sun + 0.5 * moon.angular_radius * sd.NORTH
    light = moon.xyz(near / np.linalg.norm(near))
    ahead = turned.sun + 0.5 * moon.angular_radius * np.array([-1.0, 0.0, 0.0])
    np.testing.assert_allclose(turned.xyz(ahead / np.linalg.norm(ahead)), light, rtol=1e-4)
    assert light[1] > 0


def test_the_eye_at_night_sees_no_colour(call, refused, tmp_path):
    night = ("render", "--place", "45,8", "--time", "2026-01-18T23:00+01:00", "--height", "16", "-o")
    assert "is of a picture, sky.png" in refused(*night, tmp_path / "n.exr", "--night-vision")
    assert call(*night, tmp_path / "n.png", "--night-vision").exit_code == 0
    assert call(*night, tmp_path / "plain.png").exit_code == 0
    assert (tmp_path / "n.png").read_bytes() != (tmp_path / "plain.png").read_bytes()


def test_a_film_needs_ffmpeg_and_tells_its_last_words(call, refused, tmp_path, monkeypatch):
    """Of a stand-in for ffmpeg that counts what it is sent, or fails."""
    day = ("animate", "--place", "50,8", "--date", "2026-01-18", "--step", "12h", "--height", "8", "-o", tmp_path)
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    assert "needs the program ffmpeg" in refused(*day, "--film", tmp_path / "n.mp4")
    assert not (tmp_path / "sky.0001.exr").exists()
    assert "give --film" in refused(*day, "--night-vision")
    program = tmp_path / "bin" / "ffmpeg"
    program.parent.mkdir()
    script = "#!{}\nimport sys\ndata = sys.stdin.buffer.read()\n{}\n"
    program.write_text(script.format(sys.executable, "open(sys.argv[-1], 'wb').write(str(len(data)).encode())"))
    program.chmod(0o755)
    assert "must end in .mp4" in refused(*day, "--film", tmp_path / "n.gif")
    facts = json.loads(call(*day, "--film", tmp_path / "n.mp4", "--json").stdout)
    assert facts["film_seconds"] == pytest.approx(2 / 24)
    assert (tmp_path / "n.mp4").read_text() == str(2 * 8 * 16 * 3)
    program.write_text(script.format(sys.executable, "sys.exit('no encoder for h264')"))
    assert "did not write n.mp4: no encoder for h264" in refused(*day, "--film", tmp_path / "n.mp4")


def test_exposures_of_a_film_follow_the_dusk():
    from skydome.cli.night.movie import calmed

    falling = -np.arange(20) * 1.8  # a sixth of the light each ten minutes
    np.testing.assert_allclose(np.log(calmed(falling, np.arange(20) * 600.0))[4:-4], falling[4:-4], atol=1e-4)
    assert np.log(calmed(np.array([0.0, 1.0, 0.0]), np.arange(3) * 3600.0))[1] > 0.99
