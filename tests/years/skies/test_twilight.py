"""A year coloured by the physical sky: clear light by day at Perez's luminance, and twilight by its own."""

import numpy as np

import skydome as sd
from skydome.dome.patches import tregenza
from skydome.sun.position import earth_sun_distance
from skydome.years.skies.series import year
from skydome.years.skies.status import BITS

DAY = slice(24 * 80, 24 * 81)


def test_the_physical_sky_lights_twilight(greensboro):
    data, other = (year(greensboro.rows(DAY), colour=kind) for kind in ("physical", "hosek-wilkie"))
    dusk = np.flatnonzero(data.status.values & BITS["twilight"])
    assert len(dusk) in (2, 3, 4)
    assert not (other.status.values & BITS["twilight"]).any()
    elevations = data.sun_elevation.values
    assert ((elevations[dusk] < 0) & (elevations[dusk] > -18)).all()
    for k in dusk:
        sun = sd.direction(data.sun_azimuth.values[k] * sd.deg, elevations[k] * sd.deg)
        sky = sd.PhysicalSky(sun, sd.Atmosphere.from_turbidity(3.0).at_altitude(greensboro.place.altitude))
        wanted = sky.luminance(tregenza().directions) / earth_sun_distance(data.sun_time.values[k]) ** 2
        np.testing.assert_allclose(data.luminance.values[k], wanted, rtol=1e-5)
    day = data.lit_share.values == 1
    np.testing.assert_array_equal(data.luminance.values[day], other.luminance.values[day])
    np.testing.assert_allclose(data.xyz.values[..., 1], data.luminance.values, rtol=1e-5)
    level = data.luminance.values @ data.horizontal_solid_angle.values
    np.testing.assert_allclose(level[dusk], data.diffuse_horizontal_illuminance.values[dusk], rtol=1e-5)
    assert (data.diffuse_colour_temperature.values[dusk] > 9000).all()


def test_many_turbidities_are_each_alone(greensboro):
    noon, hazes = greensboro.rows(slice(24 * 80 + 9, 24 * 80 + 13)), np.array([2.0, 3.0, 4.0, 6.0])
    both = year(noon, colour="physical", turbidity=hazes, clouds=0.0)
    one = year(noon, colour="physical", turbidity=4.0, clouds=0.0)
    np.testing.assert_allclose(both.xyz.values[2], one.xyz.values[2], rtol=1e-5)
    assert not np.allclose(both.xyz.values[3], one.xyz.values[3], rtol=1e-2)
