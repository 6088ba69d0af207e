"""Discrete ordinates through cells of cloud: what they end at, and how many steps it takes."""

import numpy as np
import pytest

from skydome.skies.clouds.fields.transport import ordinates
from skydome.skies.clouds.fields.transport.ordinates import Ordinates

pytest.importorskip("numba")
SUN = np.array([0.0, -0.6, 0.8])


def cells(greatest, side=32, levels=16):
    """Heaps of cloud of up to so much extinction, m-1, in cells of 125 x 125 x 40 m."""
    along = np.arange(side) * (4 * np.pi / side)
    heaps = np.sin(along)[:, None, None] * np.cos(along)[:, None] + np.sin(np.linspace(0, np.pi, levels)) - 0.6
    return Ordinates(np.float32(greatest) * np.clip(heaps, 0, 1).astype(np.float32), (125.0, 40.0), 0.46)


def level(greatest):
    """The same everywhere."""
    return Ordinates(np.full((16, 16, 32), greatest, np.float32), (125.0, 40.0), 0.46)


@pytest.mark.parametrize("greatest", [0.01, 0.1, 0.5, 2.0])
def test_no_light_is_lost(greatest):
    """In heaps from thin to the densest, cells of a depth of 80, what goes in comes out below and above."""
    o = cells(greatest)
    light, out = o.found(None, 1.0, 0.0)
    assert sum(out) == pytest.approx(1.0, abs=0.01)
    assert light[..., 0].max() < 4.02


def test_hastening_is_steady_in_dense_cells():
    """Cells of an optical depth of 10 in a cover as thick as dark rain: light falls evenly from top to bottom."""
    o = level(0.25)
    light, (down, up) = o.found(None, 1.0, 0.0)
    fall, turned = np.diff(light[..., 0].mean(axis=(0, 1))), 0.25 * 40 * (1 - 0.46)
    known = 4 / 3 / (32 * turned + 1.4209)  # Milne's problem on either side
    assert fall[1:-1] / (3 * turned) == pytest.approx(np.full(29, known), rel=0.03)
    assert down == pytest.approx(known, rel=0.2)
    assert down + up == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("greatest", [0.03, 0.3])
def test_light_is_found_near_to_where_many_steps_end(monkeypatch, greatest):
    """Within 1 % of the mean, in seven steps by the finest cells for sun and sky together."""
    o, steps = cells(greatest), []
    first = o.beam(np.exp(-0.1 * np.cumsum(o.extinction[..., ::-1], axis=2)[..., ::-1] * 40.0 / 0.8), SUN)
    swept = Ordinates.swept

    def counted(self, *given):
        steps.append(len(self.extinction))
        return swept(self, *given)

    with monkeypatch.context() as now:
        now.setattr(Ordinates, "swept", counted)
        found = [o.found(first, 0.0, 0.0)[0][..., 0], o.found(None, 1.0, 0.0)[0][..., 0]]
    assert steps.count(32) <= 7
    for name in ("CHANGE", "WIDE_CHANGE"):
        monkeypatch.setattr(ordinates, name, 1e-5)
    known = [o.found(first, 0.0, 0.0)[0][..., 0], o.found(None, 1.0, 0.0)[0][..., 0]]
    for ours, best in zip(found, known, strict=True):
        assert np.abs(ours - best).mean() < 0.01 * best.mean()


def test_light_goes_a_way_as_well_as_back():
    """What comes down of sun and sky, told by a light from below, is what comes down by each of them."""
    o = cells(0.05)
    first = o.beam(np.ones_like(o.extinction), SUN)
    of_sun, of_sky, _ = o.coming_down(first)
    assert of_sun == pytest.approx(o.found(first, 0.0, 0.0)[1][0], rel=0.02)
    assert of_sky == pytest.approx(o.found(None, 1.0, 0.0)[1][0], rel=0.01)
