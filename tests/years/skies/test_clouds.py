"""Colour of cloudy hours: near neutral when overcast, the clear sky's when the sun shines, continuous in between."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pvlib
import pytest

import skydome as sd
from skydome.light.colour_temperature import colour_temperature
from skydome.light.spectrum import xyz_weights
from skydome.years.skies.overcast_light import USUAL_DEPTH, overcast_spectra, overcast_xyz
from skydome.years.skies.series import year
from skydome.years.stores.stores import write_year

OVERCAST = (5900, 9500)
DAY = slice(24 * 180 + 5, 24 * 180 + 20)


def with_direct(weather, value):
    return replace(weather, direct_normal=np.broadcast_to(np.asarray(value, float), weather.count).copy())


@pytest.mark.parametrize("kind", ["preetham", "hosek-wilkie"])
def test_overcast_hours_are_near_neutral(greensboro, kind):
    data = year(with_direct(greensboro.rows(DAY), 0.0), colour=kind, wavelengths=np.arange(380.0, 721.0, 20.0))
    lit = data.luminance.max("patch").values > 0
    assert lit.sum() > 10
    kelvin = data.diffuse_colour_temperature.values[lit]
    assert ((kelvin > OVERCAST[0]) & (kelvin < OVERCAST[1])).all()
    patches = colour_temperature(data.xyz.values[lit].astype(float))
    assert np.ptp(patches, axis=1).max() < 5  # one colour for all directions
    high = data.sun_elevation.values[lit] > 25
    assert ((kelvin[high] > 5900) & (kelvin[high] < 6300)).all()
    ratio = (data.diffuse_melanopic_edi / data.diffuse_horizontal_illuminance).values[lit]
    assert np.allclose(ratio[high], 0.97, atol=0.02)  # D65: 1


@pytest.mark.parametrize("kind", ["preetham", "hosek-wilkie"])
def test_sunny_hours_keep_the_clear_skys_colour(greensboro, kind):
    sunny = with_direct(greensboro.rows(DAY), 1100.0)
    waves = [400.0, 500.0, 700.0]
    data, clear = (year(sunny, colour=kind, wavelengths=waves, clouds=clouds) for clouds in (None, 0.0))
    assert float(data.cloud_share.max()) == 0
    assert np.array_equal(data.xyz, clear.xyz)
    assert np.array_equal(data.radiance, clear.radiance)
    noon = int(data.sun_elevation.values.argmax())
    assert colour_temperature(data.xyz[noon, -1].values.astype(float)) > 10000


@pytest.mark.parametrize("clouds", [None, 0.0, 0.4, 1.0])
def test_the_luminance_is_kept_whatever_the_clouds(greensboro, clouds):
    bands = np.arange(380.0, 721.0, 10.0)
    data = year(greensboro.rows(DAY), colour="hosek-wilkie", wavelengths=bands, clouds=clouds)
    assert np.allclose(data.xyz[..., 1], data.luminance, rtol=1e-5)
    assert np.allclose(data.radiance.values @ xyz_weights(bands)[:, 1], data.luminance, rtol=2e-3)
    total = data.xyz.values[..., 1] @ data.horizontal_solid_angle.values
    assert np.allclose(total, data.diffuse_horizontal_illuminance, rtol=1e-5)


def test_colour_goes_continuously_from_grey_to_blue(greensboro):
    """In 41 steps of direct light, with the Perez luminances of each: the reciprocal colour temperature never jumps."""
    one = greensboro.rows(slice(24 * 180 + 12, 24 * 180 + 13))
    steps = [year(with_direct(one, value), colour="preetham") for value in np.linspace(0, 1000, 41)]
    mired = np.array([1e6 / float(step.diffuse_colour_temperature[0]) for step in steps])
    share = np.array([float(step.cloud_share[0]) for step in steps])
    assert share[0] == 1
    assert share[-1] == 0
    assert (np.diff(share) <= 0).all()
    assert mired[0] - mired[-1] > 50
    assert np.max(np.abs(np.diff(mired))) < 0.1 * (mired[0] - mired[-1])


def test_the_share_follows_the_observed_cloud_cover(greensboro):
    """Greensboro's file has cloud cover seen by eye, in tenths, which the estimate does not read: 4,611 lit hours."""
    frame, _ = pvlib.iotools.read_tmy3(Path(pvlib.__file__).parent / "data" / "723170TYA.CSV", coerce_year=None)
    seen = frame["TotCld (tenths)"].to_numpy() / 10
    data = year(greensboro, colour="preetham")
    lit = data.luminance.max("patch").values > 0
    share, seen = data.cloud_share.values[lit], seen[lit]
    assert np.corrcoef(share, seen)[0, 1] > 0.75
    assert abs(share.mean() - seen.mean()) < 0.07
    assert np.mean(share[seen == 0]) < 0.15
    assert np.mean(share[seen == 1]) > 0.88
    middle = [share[seen == tenths / 10].mean() for tenths in range(11)]
    assert (np.diff(middle) > 0).all()


def test_overcast_light_comes_through_a_layer_of_cloud():
    """Chromaticity against discrete ordinates under the same cloud, at the zenith and on the whole: within 0.003."""
    sun = sd.direction(0.0, np.radians([[20.0], [45.0]]))[:, 0]
    xyz = overcast_xyz(sun)
    assert np.allclose(xyz[:, 1], 1.0, rtol=1e-3)
    w = np.arange(380.0, 781.0, 10.0)
    assert np.allclose(overcast_spectra(sun, w) @ xyz_weights(w)[:, 1], 1.0, rtol=1e-3)
    air = sd.Atmosphere((sd.Molecules(), sd.Ozone(), sd.Cloud(USUAL_DEPTH)))
    for one, found in zip(sun, xyz, strict=True):
        seen = sd.DiscreteOrdinates(one, air, streams=16).xyz(sd.direction(0.0, 0.7))
        assert np.allclose(found[:2] / found.sum(), seen[:2] / seen.sum(), atol=0.003)


def test_given_clouds_are_checked_and_sliced(greensboro, tmp_path):
    import xarray

    week, clouds = greensboro.rows(slice(4300, 4400)), np.linspace(0, 1, 100)
    with pytest.raises(ValueError, match=r"clouds must lie in \[0, 1\], got 1.5"):
        year(week, colour="preetham", clouds=1.5)
    write_year(week, tmp_path / "a.zarr", values_at_once=145 * 3 * 30, colour="preetham", clouds=clouds)
    with xarray.open_zarr(tmp_path / "a.zarr") as data:
        whole = year(week, colour="preetham", clouds=clouds)
        assert np.allclose(data.xyz, whole.xyz, rtol=1e-5)
        assert np.array_equal(data.cloud_share, whole.cloud_share)
