"""Air of PyTorch's numbers, and of many airs at once, in maps and on planes: NumPy's light of each air alone."""

import numpy as np
import pytest

import skydome as sd

SUN = sd.direction(azimuth=0.0, elevation=40 * sd.deg)


def full(depth: object) -> sd.Sky:
    """The physical sky in such air, and its sun."""
    sky = sd.PhysicalSky(SUN, sd.clear_air(aerosol_depth=depth))
    return sky + sd.SunDisc.of(sky)


def test_air_of_torch_is_painted_and_falls_on_planes_as_numpy_s():
    torch = pytest.importorskip("torch")
    depth = torch.tensor(0.2, dtype=torch.float64, requires_grad=True)
    light = sd.illuminance(full(depth), sd.ZENITH)
    more, less = (float(sd.illuminance(full(0.2 + step), sd.ZENITH)) for step in (0.01, -0.01))
    assert float(light.detach()) == pytest.approx(float(sd.illuminance(full(0.2))), rel=5e-4)
    light.backward()
    assert float(depth.grad) == pytest.approx((more - less) / 0.02, rel=0.01)
    painted, expected = (sd.render(full(one), height=16).pixels[:8] for one in (depth, 0.2))
    assert np.abs(painted.mean() / expected.mean() - 1) < 0.01
    with pytest.raises(ValueError, match="leading shapes must fit"):
        sd.render_pixels(sd.HosekWilkie(torch.as_tensor(SUN), torch.tensor([2.0, 3.0, 4.0])), height=8)


def test_many_airs_light_planes_as_each_alone():
    both = sd.illuminance(full(np.array([[0.1], [0.2]])), np.stack([sd.ZENITH, sd.NORTH]))
    alone = [sd.illuminance(full(depth), np.stack([sd.ZENITH, sd.NORTH])) for depth in (0.1, 0.2)]
    np.testing.assert_allclose(both, alone, rtol=1e-3)


@pytest.mark.parametrize("kind", [sd.PhysicalSky, sd.SunDisc, lambda sun: sd.SunDisc.of(sd.PhysicalSky(sun))])
def test_suns_that_do_not_fit_the_views_are_told_so(kind):
    suns = sd.direction(0.0, np.linspace(0.2, 0.8, 4))
    with pytest.raises(ValueError, match=r"got directions \(3,\), sun \(4,\); give many suns an axis of 1"):
        kind(suns).luminance(suns[:3])
