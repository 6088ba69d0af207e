"""Preetham's model fitted anew: his own numbers from his own skies, physical skies, bad input."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.air.cross_sections import rayleigh_depth
from skydome.cli.main import app
from skydome.light.spectrum import xyz_weights
from skydome.own_air.family import SkyFamily
from skydome.own_air.grid import Grid, simulate
from skydome.own_air.preetham_fit import preetham_fit
from skydome.skies.preetham import PreethamNumbers

pytest.importorskip("scipy")
W = np.arange(380.0, 781.0, 5.0)
SUNS = np.radians([8.0, 15, 25, 40, 55, 70, 85])
T = (2.0, 3.0, 4.0, 5.0, 6.0)


def preetham(sun, turbidity, albedo):
    return sd.Preetham(sun, turbidity)


def physical(sun, turbidity, albedo):
    depth = (turbidity - 1) * float(rayleigh_depth([550.0])[0])
    return sd.DiscreteOrdinates(sun, sd.Atmosphere.standard(depth, albedo=albedo))


@pytest.fixture(scope="module")
def own():
    return preetham_fit(SkyFamily.of(preetham, T, (0.0,), W, SUNS))


def test_preethams_skies_give_back_his_numbers(own):
    """Luminance to the paper's digits; x and y as far as the daylight series' own chromaticity, 6e-5, allows."""
    np.testing.assert_allclose(own.letters_Y, PreethamNumbers.PRINTED.letters_Y, atol=5e-5)
    np.testing.assert_allclose(own.zenith_Y, PreethamNumbers.PRINTED.zenith_Y, atol=5e-5)
    for name in ("letters_x", "letters_y", "zenith_x", "zenith_y"):
        np.testing.assert_allclose(getattr(own, name), getattr(PreethamNumbers.PRINTED, name), atol=2e-3)
    assert own.turbidity == (2.0, 6.0)


def test_the_refitted_sky_is_the_sky(own):
    views, sun = sd.direction(np.arange(60) * 2.4 % 6.283, np.arcsin(np.linspace(0.02, 1, 60))), sd.direction(1.0, 0.6)
    away = sd.Preetham(sun, 3.4, own).xyY(views) - sd.Preetham(sun, 3.4).xyY(views)
    assert np.abs(away[:, :2]).max() < 3e-4
    np.testing.assert_allclose(
        sd.Preetham(sun, 3.4, own).luminance(views), sd.Preetham(sun, 3.4).luminance(views), rtol=1e-4
    )


def test_physical_skies_are_fitted_better_than_preetham_has_them():
    pytest.importorskip("nanodisort")
    family = SkyFamily.of(physical, (2.0, 3.0, 4.0), (0.1,), np.arange(380.0, 781.0, 80.0), SUNS)
    numbers = preetham_fit(family, 0.1)
    share = family.views.solid_angles / family.views.solid_angles.sum()

    def error(kind, *more):
        found = []
        for k, height in enumerate(SUNS):
            sun = sd.direction(np.pi, height)
            truth = (family.radiance[1, 0, k] @ xyz_weights(family.wavelengths))[:, 1]
            found.append(share @ (kind(sun, 3.0, *more).luminance(family.views.directions) / truth - 1) ** 2)
        return float(np.sqrt(np.mean(found)))

    assert error(sd.Preetham, numbers) < 0.2 < 0.5 < error(sd.Preetham)


def test_the_file_and_what_is_no_such_file(own, tmp_path):
    own.save(tmp_path / "own.json")
    again = PreethamNumbers.load(tmp_path / "own.json")
    sun = sd.direction(1.0, 0.6)
    assert sd.Preetham(sun, 3.0, again).luminance(sd.ZENITH) == sd.Preetham(sun, 3.0, own).luminance(sd.ZENITH)
    with pytest.raises(ValueError, match=r"turbidity must lie in \[2, 6\], got 7"):
        sd.Preetham(sun, 7.0, again)
    short = json.loads((tmp_path / "own.json").read_text()) | {"zenith_Y": [1, 2]}
    for text, message in (
        ("{", "damaged or not numbers of Preetham"),
        ('{"a": 1}', "unexpected keyword"),
        (json.dumps(short), r"zenith_Y must be \(4,\)"),
    ):
        (tmp_path / "bad.json").write_text(text)
        with pytest.raises(ValueError, match=message):
            PreethamNumbers.load(tmp_path / "bad.json")


def test_too_little_to_fit_is_refused():
    few = SkyFamily.of(preetham, (2.0, 3.0), (0.0,), W, SUNS)
    with pytest.raises(ValueError, match="three turbidities, four suns and 400-700 nm are needed, got 2 turbidities"):
        preetham_fit(few)


def test_the_command_fits_a_store(tmp_path):
    pytest.importorskip("nanodisort")
    pytest.importorskip("zarr")
    store, zenith = tmp_path / "store.zarr", tuple(range(4, 87, 12))
    suns = (6.0, 12.0, 25.0, 45.0, 60.0, 80.0)
    bands = tuple(float(w) for w in range(380, 741, 40))
    simulate(Grid((2.0, 3.0, 4.0), (0.0,), suns, bands, zenith, tuple(range(0, 181, 20))), store)
    run = CliRunner().invoke(app, ["fit", str(store), "--form", "preetham", "-o", str(tmp_path / "n.json"), "--json"])
    assert run.exit_code == 0, run.output
    numbers = PreethamNumbers.load(tmp_path / "n.json")
    sky = sd.Preetham(sd.direction(np.pi, 0.7), 3.0, numbers)
    air = sd.Atmosphere.standard(2 * float(rayleigh_depth([550.0])[0]), albedo=0.0, aerosol_albedo=1.0)
    views = sd.direction(np.arange(40) * 2.4 % 6.283, np.arcsin(np.linspace(0.2, 1, 40)))
    truth = sd.DiscreteOrdinates(sd.direction(np.pi, 0.7), air).luminance(views)
    assert np.sqrt(((sky.luminance(views) / truth - 1) ** 2).mean()) < 0.25
