"""Igawa's sky beside Perez's through a real year, by two sets of numbers that know nothing of each other; CIE types."""

import numpy as np
import pytest

import skydome as sd
from skydome.dome.patches import patches
from skydome.years.planes.light import suns_of
from skydome.years.skies.cie_of_year import cie_types
from skydome.years.skies.kinds_of_sky import KINDS, clear_sky_index, sky_kinds


@pytest.fixture(scope="module")
def days(greensboro):
    return sd.year(greensboro.rows(np.arange(greensboro.count) // 24 % 7 == 3))


def test_igawa_is_near_perez_through_a_year(days):
    """Median difference of the patches 7-8 %, correlation of the logarithms .96; no patch dark or negative."""
    chosen = (days.sun_elevation > 5).values & (days.diffuse_horizontal_irradiance > 5).values
    given = [days[f"{part}_irradiance"].values[chosen, None] for part in ("direct_normal", "diffuse_horizontal")]
    sky = sd.Igawa(suns_of(days)[chosen, None], *given, check="clamp")
    ours, perez = sky.luminance(patches("tregenza").directions), days.luminance.values[chosen]
    assert sky.valid.all()
    assert (ours > 0).all()
    assert np.median(np.abs(ours / perez - 1)) < 0.09
    assert np.corrcoef(np.log(ours).ravel(), np.log(np.maximum(perez, 1)).ravel())[0, 1] > 0.95


def test_igawa_has_its_level_and_no_steps():
    sun = sd.direction(2.0, 0.7)
    direct = np.linspace(0, 900, 200)[:, None]
    sky = sd.Igawa(sun, direct, 120.0)
    np.testing.assert_allclose(sd.illuminance(sky), sky.diffuse_illuminance[:, 0], rtol=1e-3)
    by_shape = sd.Igawa(sun, direct, 120.0, zenith_luminance=1.0).luminance(sd.direction(0.5, 0.5))[:, 0]
    assert np.abs(np.diff(by_shape)).max() < 0.05 * np.ptp(by_shape)
    with pytest.raises(ValueError, match="Igawa"):
        sd.Igawa(sun, 500.0, 100.0, zenith_luminance=1.0, illuminance=1.0)


def test_each_cie_sky_is_its_own_type(days):
    rows = np.flatnonzero((days.sun_elevation > 20).values)[::40][:15]
    some = days.isel(time=rows).copy(deep=True)
    kinds = np.arange(1, len(rows) + 1)
    centres = patches("tregenza").directions
    light = sd.CIE(suns_of(some)[:, None], kinds[:, None], illuminance=10_000.0).luminance(centres)
    some["luminance"] = (("time", "patch"), np.asarray(light))
    found, off = cie_types(some)
    assert found.tolist() == kinds.tolist()
    assert np.nanmax(off) < 1e-6


def test_overcast_hours_have_overcast_types(days):
    found, _ = cie_types(days)
    overcast = (days.clearness < 1.05).values & (days.sun_elevation > 10).values
    clear = (days.clearness > 4.5).values & (days.sun_elevation > 10).values
    assert (found[overcast] <= 6).mean() > 0.95
    assert (found[clear] >= 7).mean() > 0.95
    assert (found[(days.sun_elevation < 0).values] == 0).all()


def test_kinds_of_hours(days):
    found = sky_kinds(days)
    kind, elevation, clearness = found.kind.values, days.sun_elevation.values, days.clearness.values
    high = elevation > 10
    assert ((kind > 0) == (days.luminance.values.any(axis=1) & (elevation > 0))).all()
    assert (kind[high & (clearness < 1.05)] == KINDS.index("overcast")).mean() > 0.9
    assert (kind[high & (clearness > 6.2)] == KINDS.index("clear")).mean() > 0.9
    assert {"overcast", "partly cloudy", "clear"} == {KINDS[k] for k in np.unique(kind[high])}
    edges = np.array([1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2])  # Perez et al. 1990, Table 1
    lit = kind > 0
    assert (found.perez_category.values[lit] == np.searchsorted(edges, clearness[lit], side="right") + 1).all()
    assert (found.perez_category.values[~lit] == 0).all()


def test_variability_is_the_change_to_the_neighbours():
    """Two hours of one index are steady; one dark hour between changes as much to both sides."""
    import pandas as pd

    times = pd.date_range("2026-06-21T09:00", periods=5, freq="h", tz="UTC")
    place = sd.Place(45.07, 7.69)
    steady = sd.year(pd.DataFrame({"dni": 0.0, "dhi": 100.0}, index=times), place=place)
    index = clear_sky_index(steady)
    found = sky_kinds(steady).variability.values
    assert found[0] == pytest.approx(abs(index[1] - index[0]))
    assert found[2] == pytest.approx(np.sqrt(((index[2] - index[1]) ** 2 + (index[3] - index[2]) ** 2) / 2))
    gap = sd.year(pd.DataFrame({"dni": 0.0, "dhi": 100.0}, index=times[[0, 1, 4]]), place=place)
    assert np.isnan(sky_kinds(gap).variability.values).tolist() == [False, False, True]
