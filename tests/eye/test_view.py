"""Views: where things lie in them, and how large a pixel is."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.eye.view import Camera, HalfSphere

FRAMES = [
    Camera(170 * deg, 20 * deg, 60 * deg, 100, 70),
    Camera(0.0, 90 * deg, 30 * deg, 40),
    HalfSphere(1.0, -0.4, 90),
]


@pytest.mark.parametrize("frame", FRAMES, ids=lambda frame: type(frame).__name__)
def test_places_and_directions_are_inverse(frame):
    rows, columns = frame.shape
    inside = frame.solid_angles() > 0
    row, column = frame.place(frame.directions())
    np.testing.assert_allclose(row[inside], np.broadcast_to(np.arange(rows)[:, None] + 0.5, inside.shape)[inside])
    np.testing.assert_allclose(column[inside], np.broadcast_to(np.arange(columns) + 0.5, inside.shape)[inside])
    np.testing.assert_allclose(np.linalg.norm(frame.directions(), axis=-1), 1, rtol=1e-12)


def test_compass_in_a_view():
    view = Camera(180 * deg, 0.0, 90 * deg, 100)
    row, column = view.place(np.stack([sd.direction(200 * deg, 0.0), sd.direction(180 * deg, 20 * deg)]))
    assert column[0] > 50  # facing south, west is on the right
    assert row[1] < 50  # and up is up
    assert np.isnan(view.place(sd.NORTH)[0])


def test_solid_angles():
    corner = 45 * deg
    view = Camera(0.0, 0.0, 2 * corner, 400)
    assert view.solid_angles().sum() == pytest.approx(4 * np.pi / 6, rel=1e-5)  # a face of the cube
    assert HalfSphere(0.0, 0.0, 500).solid_angles().sum() == pytest.approx(2 * np.pi, rel=1e-4)


def test_quick_look_up_is_the_map_s_own():
    random = np.random.default_rng(0)
    environment = sd.EnvironmentMap(random.random((16, 32, 3)), white_luminance=7.0)
    for frame in (HalfSphere(0.3, 1.2, 60), HalfSphere(3.1, -1.3, 60)):
        np.testing.assert_allclose(frame.seen(environment), environment.sample(frame.directions()) * 7, atol=1e-5)
    square = environment.resampled(sd.EqualAreaSquare(), 16)
    view = Camera(0.0, 0.5, 1.0, 20)
    np.testing.assert_allclose(view.seen(square), square.sample(view.directions()) * 7, rtol=1e-5)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 0.0, 0.0), r"the field of view must lie in \(0, 170\) degrees, got 0"),
        ((0.0, 0.0, 171 * deg), "field of view"),
        ((0.0, 91 * deg), r"elevation of a view must lie in \[-90, 90\] degrees, got 91"),
        ((float("nan"), 0.0), "azimuth"),
        ((0.0, 0.0, 1.0, 0), "width must lie in .1, 16384. pixels, got 0"),
        ((0.0, 0.0, 1.0, 8, 8, float("inf")), "east must lie in"),
        ((0.0, 0.0, 1.0, 8, 8, 0.0, 0.0, 0.0), "above_ground must lie in .1e-06, 100000. m, got 0"),
    ],
)
def test_cameras_that_cannot_be(arguments, message):
    with pytest.raises(ValueError, match=message):
        Camera(*arguments)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 0.0, 0.5 * deg), r"field of view of glare must lie in \[1, 150\] degrees, got 0.5"),
        ((0.0, 0.0, 151 * deg), "field of view"),
        ((0.0, 0.0, 1.0, 8), r"width of a view of glare must lie in \[16, 8192\] pixels, got 8"),
        ((0.0, 0.0, 1.0, 64, 9000), "height of a view of glare"),
    ],
)
def test_views_whose_glare_cannot_be_painted(arguments, message):
    environment = sd.EnvironmentMap(np.ones((16, 32, 3)))
    for beholder in (sd.Eye(), sd.LensFlare()):
        with pytest.raises(ValueError, match=message):
            beholder.look(environment, Camera(*arguments))


def test_a_pixel_s_solid_angle_in_any_direction():
    camera = Camera(0.3, 0.2, 60 * deg, 40, 30)
    np.testing.assert_allclose(camera.solid_angle_toward(camera.directions()), camera.solid_angles(), rtol=1e-12)
    assert camera.solid_angle_toward(-camera.forward) == 0
