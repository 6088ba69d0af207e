"""What is asked of arguments: sentences that say what, got and allowed."""

import numpy as np
import pytest

import skydome as sd

SUN = sd.direction(3.0, 0.7)
SKY = sd.Preetham(SUN, 3.0)
TIME = "2026-06-21T15:00+02:00"
PAIR = (45.07, 7.69)
LAND = sd.Elevation(np.zeros((9, 9)), 30.0, 30.0)

KINDS = {
    "sun": (
        lambda: sd.sun_direction(PAIR, TIME),
        r"place must be of kind Place, as Place\(.*got tuple \(45.07, 7.69\)",
    ),
    "angles": (lambda: sd.sun_angles(PAIR, TIME), "place must be of kind Place"),
    "events": (lambda: sd.sun_events(PAIR, "2026-06-21"), "place must be of kind Place"),
    "printed sun": (lambda: sd.preetham_sun_direction(PAIR, TIME), "place must be of kind Place"),
    "no sky": (lambda: sd.illuminance(None), "sky must be of kind Sky, as Preetham.*got None"),
    "skies": (lambda: sd.illuminance((SKY, SKY)), "sky must be of kind Sky, .*got tuple"),
    "no map": (lambda: sd.render("hosek-wilkie"), "sky must be of kind Sky, .*got str"),
    "street": (lambda: sd.obstructed_illuminance(SKY, (0, 0)), "surroundings must be of kind Surroundings.*got tuple"),
    "air": (lambda: sd.AirLight("clear"), "sky must be of kind Sky, .*got str 'clear'"),
    "heights": (lambda: sd.render_terrain(np.zeros((9, 9)), sd.Camera(), SKY), "elevation must be of kind Elevation"),
    "camera": (lambda: sd.render_terrain(LAND, (0, 0), SKY), r"camera must be of kind Camera.*got tuple \(0, 0\)"),
    "grid": (lambda: sd.Elevation([[0.0, 1.0], [2.0, 3.0]], 30.0, 30.0), "heights must be of kind ndarray.*got list"),
    "map": (lambda: sd.glare(SKY, 0.0, 0.0), "environment must be of kind EnvironmentMap"),
}


@pytest.mark.parametrize(("call", "message"), KINDS.values(), ids=KINDS)
def test_what_is_of_another_kind_is_named_with_what_is_allowed(call, message):
    with pytest.raises(TypeError, match=message):
        call()


FILES = {
    "map": lambda: sd.load("none.exr"),
    "weather": lambda: sd.read_weather("none.epw"),
    "picture": lambda: sd.load("none.hdr"),
    "horizon": lambda: sd.Horizon.read("none.csv"),
    "land": lambda: sd.read_elevation("none.tif"),
    "mesh": lambda: sd.MeshScene.read("none.obj"),
}


@pytest.mark.parametrize("call", FILES.values(), ids=FILES)
def test_files_that_are_not_there_are_told_in_a_sentence(call):
    with pytest.raises(FileNotFoundError, match=r"^an? .*must be a file that exists, got none\.[a-z]+$"):
        call()
    with pytest.raises(IsADirectoryError, match="must be a file, got the folder"):
        sd.Horizon.read(".")


@pytest.mark.parametrize("shape", [(3,), (4, 2)])
def test_shapes_that_do_not_go_together_are_named(shape):
    views = sd.direction(np.linspace(0, 6, 18432), 0.5)
    sky = sd.Preetham(sd.direction(np.zeros(shape), 0.7), 3.0)
    with pytest.raises(ValueError, match=r"must fit, got directions \(18432,\), sun \(.*an axis of 1"):
        sky.luminance(views)
