"""The nine numbers refitted to the physical sky: how close, between suns too, and stored."""

import numpy as np
import pytest

import skydome as sd
from skydome.evaluation.models import plain_air
from skydome.own_air.refit import Views, fitted, refitted
from skydome.skies.formula.perez_formula import evaluate, view_geometry
from skydome.skies.physical.refitted import OFFSET, Numbers, Refitted

pytest.importorskip("scipy")
pytest.importorskip("nanodisort")
AIR = plain_air(0.06, 0.76)
BANDS = np.array([400.0, 550.0, 700.0])


@pytest.fixture(scope="module")
def numbers():
    return refitted(AIR, np.radians([20.0, 26.0, 45.0, 70.0]), BANDS)


def test_a_sky_of_the_formula_is_found_again():
    truth = np.array([1.0, -1.1, -0.3, 0.6, 2.0, -3.0, 0.3, 0.05, 0.6, 0.2])
    views, sun = Views.half(), sd.direction(np.pi, 0.8)
    light = evaluate(truth[None, :], *view_geometry(views.directions, sun), OFFSET)[:, 0]
    found, error = fitted(views, sun, light)
    assert error < 1e-5
    np.testing.assert_allclose(
        evaluate(found[None, :], *view_geometry(views.directions, sun), OFFSET)[:, 0], light, rtol=1e-4
    )


def test_relative_errors_of_the_fits(numbers):
    assert np.median(numbers.error) <= 0.025
    assert numbers.error.max() <= 0.04


def test_between_two_suns_and_two_wavelengths_it_stays_close(numbers):
    views, sun, w = Views.half(), sd.direction(np.pi, np.radians(23.0)), [400.0, 550.0]
    away = Refitted(sun, numbers).radiance(views.directions, w)
    away = away / sd.DiscreteOrdinates(sun, AIR).radiance(views.directions, w) - 1
    assert np.sqrt((views.solid_angles @ away**2) / views.solid_angles.sum()).max() < 0.04


def test_half_the_sky_has_half_the_directions_and_all_the_solid_angle():
    assert Views.half(lowest=0.0).solid_angles.sum() == pytest.approx(2 * np.pi, rel=1e-9)


def test_stored_shapes_validity_and_bad_input(numbers, tmp_path):
    numbers.save(tmp_path / "n.npz")
    again = Numbers.load(tmp_path / "n.npz")
    suns = sd.direction(1.0, np.radians([-5.0, 10.0, 30.0]))[:, None, :]
    views = Views.half(3, 4).directions
    light = Refitted(suns, again).radiance(views, [450.0, 600.0])
    assert light.shape == (3, 12, 2)
    assert (light[0] == 0).all()
    np.testing.assert_array_equal(light[2], Refitted(suns[2, 0], numbers).radiance(views, [450.0, 600.0]))
    assert Refitted(suns, again).valid.ravel().tolist() == [False, False, True]
    with pytest.raises(ValueError, match=r"wavelengths must lie in \[400, 700\] nm, got 300"):
        Refitted(suns, again).radiance(views, [300.0])
    np.savez(tmp_path / "other.npz", a=1)
    with pytest.raises(ValueError, match="is not a refitted sky"):
        Numbers.load(tmp_path / "other.npz")
