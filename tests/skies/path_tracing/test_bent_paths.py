"""Paths through air that bends light: the kernels against the tables, straight rays as a limit, order one by both."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import arcs, view_rays
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.path_tracing.tables import shells

pytest.importorskip("numba")
W = np.array([450.0, 650.0])
AIR = sd.Atmosphere.standard(aerosol_depth=0.1)
TABLES = ColumnTables.of(AIR)
SHELLS = shells(AIR, W, TABLES.refractivity)
VIEWS = sd.direction(np.radians([180.0, 180, 0, 90, 0]), np.radians([4.0, 20, 30, 50, 90]))


def sun_at(elevation):
    return sd.direction(np.pi, elevation * sd.deg)


def test_sunlight_through_bent_air_is_that_of_the_tables():
    from skydome.skies.path_tracing.bent_kernel import SHADOW, bent_sunlight

    depths, light = np.stack([part.depth(W) for part in AIR.constituents]), np.empty(SHELLS.albedo.size)
    for height in (0.0, 900.0, 12_000.0, 50_000.0):
        for elevation in np.radians([-8.0, -1.5, -0.4, 0.0, 3.0, 40.0]):
            at, true = np.array([height]), np.array([elevation])
            seen, share = (float(part[0]) for part in TABLES.seen(at, true))
            found = bent_sunlight(height, np.sin(elevation), SHELLS, light)
            assert (found == SHADOW) == (share == 0)
            if share > 0:
                assert found == pytest.approx(np.sin(seen), abs=1e-9)
                left = share * np.exp(-TABLES.toward(at, np.sin([seen]))[0] @ depths)
                np.testing.assert_allclose(light[:2], left, rtol=1e-6)


@pytest.mark.parametrize("elevation", [0.3, 2.0, 30.0])
def test_the_eyes_ray_is_bent_as_by_the_tables(elevation):
    from skydome.skies.path_tracing.air_kernel import densities_at
    from skydome.skies.path_tracing.bent_kernel import bend_view
    from skydome.skies.path_tracing.event_kernel import path_state

    view, cosine = sd.direction(1.0, elevation * sd.deg), np.sin(elevation * sd.deg)
    ray = view_rays(TABLES, np.array([cosine]), np.array([0.5]), np.array([0.5]))
    for node in (5, 20, 40):
        height, state = float(ray.heights[0, node]), path_state(len(AIR.constituents), SHELLS.albedo.size, 1)
        state.d[:], state.throughput[:] = view, 1.0
        densities_at(height, SHELLS, state.fade, state.density)
        bend_view(AIR.radius + height, cosine, SHELLS, state)
        assert np.linalg.norm(state.x) == pytest.approx(AIR.radius + height, rel=1e-12)
        arc = np.arctan2(state.x[:2] @ view[:2] / np.linalg.norm(view[:2]), state.x[2])
        assert arc == pytest.approx(float(arcs(TABLES, np.array([cosine]), ray)[0, node]), abs=1e-6)
        assert state.d @ state.x / np.linalg.norm(state.x) == pytest.approx(float(ray.local[0, node]), abs=1e-7)
        assert np.linalg.norm(state.d) == pytest.approx(1, rel=1e-12)


def test_air_that_hardly_bends_light_is_as_straight():
    class Hardly(PathTraced):
        refractivity = 1e-12

    light = [
        kind(sun_at(2.0), AIR, refraction=False, exact_first=False).job(VIEWS, W).start().more(4).radiance
        for kind in (PathTraced, Hardly)
    ]
    np.testing.assert_allclose(light[1], light[0], rtol=5e-3)


@pytest.mark.parametrize("elevation", [2.0, -0.3])
def test_light_scattered_once_by_bent_paths_is_that_by_quadrature(elevation):
    skies = (PathTraced(sun_at(elevation), AIR, orders=1, exact_first=e, paths_per_pass=128) for e in (False, True))
    drawn, exact = (sky.job(VIEWS, W).start().more(8) for sky in skies)
    assert drawn.job.sky.refractivity > 0
    off = np.abs(drawn.radiance - exact.radiance) - 4 * drawn.standard_error
    assert (off < 0.02 * exact.radiance).all()


def test_bending_is_for_low_suns_of_the_earth():
    assert PathTraced(sun_at(5.1), AIR).refractivity == 0
    assert PathTraced(sun_at(4.9), AIR).refractivity > 0
    assert PathTraced(sun_at(4.9), AIR, refraction=False).refractivity == 0
    assert PathTraced(sun_at(4.9), sd.Atmosphere.mars()).refractivity == 0
    assert isinstance(sd.SunDisc.of(PathTraced(sun_at(-0.3), AIR)), BentSun)
    with pytest.raises(ValueError, match="earth's atmosphere"):
        PathTraced(sun_at(4.9), sd.Atmosphere.mars(), refraction=True)
