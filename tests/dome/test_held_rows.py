"""Rows of maps of a held sky: against the sky direction by direction, compiled against NumPy, and on the horizontal."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import PREETHAM_HAZE
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.dome.held_rows import paint_held
from skydome.dome.integrals import projected
from skydome.ground.compiled import has_numba

HEIGHT = 48
MATRIX = np.asarray(sd.SRGB.from_xyz)


def painted(held, sun, kernel=None, dtype=np.float64):
    out = np.full((HEIGHT // 2, 2 * HEIGHT, 3), np.nan, dtype)
    paint_held(kernel, held.rows, sun, MATRIX, sd.Equirectangular(), HEIGHT, range(HEIGHT // 2), out)
    return out


@pytest.fixture(scope="module", params=["grid", "between", "twilight", "zenith", "haze", "two lobes"])
def sky(request):
    azimuth, elevation = {"grid": (180.0, 40.0), "twilight": (77.7, -3.0), "zenith": (0.0, 90.0)}.get(
        request.param, (123.4, 12.0)
    )
    sun = sd.direction(azimuth * sd.deg, elevation * sd.deg)
    if request.param == "haze":
        return sd.held(sd.Nishita93(sun, sd.Atmosphere.from_turbidity(3.0, PREETHAM_HAZE)))
    if request.param == "two lobes":
        law = HenyeyGreenstein((0.8, -0.2), (0.9, 0.1))
        return sd.held(sd.Nishita93(sun, sd.Atmosphere((sd.Molecules(), sd.Aerosol(0.2, phase=law)))))
    return sd.PhysicalSky(sun).held()


def test_rows_are_the_sky(sky):
    wanted = sky.seen(sd.Equirectangular().directions(HEIGHT, slice(0, HEIGHT // 2)).reshape(-1, 3)) @ MATRIX.T
    found = painted(sky, sky.sun).reshape(-1, 3)
    tolerance = 2e-5 if sky.rows.table.max() == 0 else 3e-4  # straight lines between 4096 chords
    np.testing.assert_allclose(found, wanted, atol=tolerance * np.abs(wanted).max(), rtol=tolerance)


@pytest.mark.skipif(not has_numba(), reason="needs Numba")
def test_compiled_rows(sky):
    from skydome.skies.physical import held_rows_kernel

    plain, fast = painted(sky, sky.sun), painted(sky, sky.sun, held_rows_kernel, np.float32)
    np.testing.assert_allclose(fast, plain, atol=1e-5 * np.abs(plain).max(), rtol=3e-4)


def test_light_on_the_level(sky):
    """Against the dome's own nodes; the zenith's sun has its peak between them."""
    nodes, weights = projected(sd.ZENITH, np.asarray(sd.ZENITH))
    np.testing.assert_allclose(sky.on_level, weights @ sky.seen(nodes), rtol=2e-4)
    np.testing.assert_allclose(sd.illuminance(0.5 * sky), 0.5 * sky.on_level[1], rtol=5e-4)
