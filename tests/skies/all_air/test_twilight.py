"""What makes the physical sky's twilight: ozone, and light scattered more than once."""

import skydome as sd

SUN = sd.direction(0.0, -4.0 * sd.deg)


def test_twilight_needs_ozone_and_all_orders():
    air = sd.clear_air(0.1)
    whole, bare = (sd.PhysicalSky(SUN, one).xyz(sd.ZENITH) for one in (air, sd.clear_air(0.1, ozone=0.0)))
    once = sd.Nishita93(SUN, air).luminance(sd.ZENITH)
    assert 1.8 < bare[1] / whole[1] < 2.6
    assert 0.4 < once / whole[1] < 0.6
    assert sd.colour_temperature(whole) > 15_000 > 7_000 > sd.colour_temperature(bare)
