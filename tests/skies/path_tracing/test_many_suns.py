"""Paths that hit one of many suns by chance agree with paths that are led to the sun at every vertex."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.skies.path_tracing.many_suns import many_suns, suns_with_room
from skydome.skies.path_tracing.sky import PathTraced

pytest.importorskip("numba")
AIR = Atmosphere.standard(aerosol_depth=0.1, asymmetry=0.6, albedo=0.5)


def test_as_many_suns_as_have_room():
    assert suns_with_room(0.0, np.radians(0.25)) == 720  # as Hosek and Wilkie 2012, section 3
    assert suns_with_room(np.sin(np.radians(60.0)), np.radians(0.25)) == pytest.approx(360, abs=1)
    assert suns_with_room(1.0, np.radians(0.25)) == 1


@pytest.mark.parametrize(("elevation", "radius"), [(10.0, 0.03), (35.0, 0.05)])
def test_many_suns_agree_with_next_event_estimation(elevation, radius):
    """Small discs: over one of 3 degrees at 2 degrees of elevation the light is no longer that of its centre."""
    sky = PathTraced(sd.direction(0.0, elevation * sd.deg), AIR, seed=4)
    rings = many_suns(sky, np.radians([12.0, 60.0]), [450.0], paths=1 << 19, radius=radius)
    azimuth, height = np.meshgrid(rings.azimuths, rings.elevations)
    views = sd.direction(azimuth, height).reshape(-1, 3)
    tracing = sky.job(views, [450.0]).start().until(0.02)
    expected, known = (v.reshape(rings.radiance.shape) for v in (tracing.radiance, tracing.standard_error))
    away = (rings.radiance - expected) / np.hypot(rings.standard_error, known)
    count = away.size
    assert rings.standard_error.max() < 0.25 * expected.max()
    assert (away**2).sum() < count + 4 * np.sqrt(2 * count)  # chi-square, 4 of its standard deviations
    assert (away**2).sum() > count - 4 * np.sqrt(2 * count)
    for k in range(2):  # a whole ring together
        error = np.sqrt((rings.standard_error[k] ** 2 + known[k] ** 2).sum())
        assert abs((rings.radiance[k] - expected[k]).sum()) < 3.5 * error
        assert error < 0.03 * expected[k].sum()


def test_nothing_scatters_in_empty_space_and_bad_discs_are_refused():
    from skydome.air.constituents import Molecules

    sky = PathTraced(sd.direction(0.0, 0.5), Atmosphere((Molecules(optical_depth=0.0),), 0.0))
    assert (many_suns(sky, 0.5, [550.0], paths=1000, radius=0.1).radiance == 0).all()
    with pytest.raises(ValueError, match=r"radius must lie in \[0.001, 0.2\] rad, got 0.5"):
        many_suns(sky, 0.5, [550.0], radius=0.5)
