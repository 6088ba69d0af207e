"""A camera's lens: its ghosts lie on the line through the centre, and their light adds up."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.eye.bright_source import BrightSource
from skydome.eye.lens_flare import LensFlare
from skydome.eye.view import Camera

VIEW = Camera(180 * deg, 20 * deg, 40 * deg, 256)


def source(azimuth, elevation):
    return BrightSource(sd.direction(azimuth * deg, elevation * deg), np.array([1e5, 9e4, 8e4]))


def test_ghosts_and_haze_have_their_share_of_the_light():
    lens = LensFlare(haze=0.0)
    near = source(177, 22)  # near the middle: every ghost is in the picture
    spots, share = lens.spots(near, VIEW)
    assert share == lens.strength
    np.testing.assert_allclose(spots.sum(axis=(0, 1)) * VIEW.pixel**2, near.light * lens.strength, rtol=0.02)
    only_haze, share = LensFlare(strength=0.0, haze=0.01).spots(near, VIEW)
    got = np.einsum("ijc,ij->c", only_haze, VIEW.solid_angles())
    np.testing.assert_allclose(got, near.light * 0.01, rtol=1e-4)
    assert share == 0.01


def test_ghosts_lie_on_the_line_from_sun_to_centre():
    spots, _ = LensFlare(haze=0.0, ghosts=30).spots(source(170, 20 + 1e-9), VIEW)
    row, column = VIEW.place(sd.direction(170 * deg, 20 * deg))
    rows = np.arange(256) + 0.5
    middle = np.sum(spots.sum(axis=(1, 2)) * rows) / spots.sum()
    assert middle == pytest.approx(128 + (row - 128) * 0.1, abs=2)
    assert column < 128


def test_flare_goes_with_the_sun():
    lens = LensFlare()
    totals = [lens.spots(source(180 + off, 20), VIEW)[0].sum() for off in (0, 30, 50, 170)]
    assert totals[0] > totals[1] > totals[3] == 0
    assert np.array_equal(lens.spots(source(175, 25), VIEW)[0], LensFlare().spots(source(175, 25), VIEW)[0])
    assert not np.array_equal(lens.spots(source(175, 25), VIEW)[0], LensFlare(seed=1).spots(source(175, 25), VIEW)[0])


def test_picture_without_and_with_have_about_the_same_light():
    sky = sd.HosekWilkie(sd.direction(177 * deg, 22 * deg), turbidity=3.0)
    seen = LensFlare().look(sd.render(sky + sd.SunDisc.of(sky), height=256), VIEW)
    plain, flared = (np.einsum("ijc,ij->c", picture, VIEW.solid_angles()) for picture in (seen.plain, seen.eye))
    np.testing.assert_allclose(flared, plain, rtol=1e-3)


@pytest.mark.parametrize("choices", [{"blades": 2}, {"ghosts": 0}, {"strength": -1.0}, {"strength": 0.9, "haze": 0.2}])
def test_lenses_that_there_are_not(choices):
    with pytest.raises(ValueError, match=r"must lie in|shares"):
        LensFlare(**choices)
