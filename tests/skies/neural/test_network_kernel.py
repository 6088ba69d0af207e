"""The compiled networks, toward directions and on the rows of maps, against the readable float64 form."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import skydome as sd
from skydome.dome import network_rows
from skydome.export.network_shader import INPUTS as SHADER_INPUTS
from skydome.ground.quadrature import hemisphere
from skydome.skies.neural import fast as fast_network
from skydome.skies.neural.files import shipped_network
from skydome.skies.neural.folding import INPUTS, OF_THE_SKY, steadied
from skydome.skies.neural.network import FEATURES, OUTPUTS, Network
from skydome.skies.neural.sky import NeuralSpectralSky

pytest.importorskip("numba", reason="Numba is not installed")

SHIPPED = ("preetham", "hosek-wilkie", "hosek-wilkie-compact", "hosek-wilkie-deep", "hosek-wilkie-spectral")
HEIGHT = 64
VIEWS = np.concatenate([hemisphere(16, 48)[0], sd.ZENITH[None], -hemisphere(2, 4)[0]])


@pytest.fixture
def always(monkeypatch):
    """Kernels for jobs of every size."""
    monkeypatch.setattr(fast_network, "LEAST_DIRECTIONS", 0)
    monkeypatch.setattr(network_rows, "LEAST_DIRECTIONS", 0)


@pytest.fixture
def never(monkeypatch):
    """No kernel, as where Numba is missing."""
    monkeypatch.setattr(fast_network, "compiled_kernel", lambda network: None)
    monkeypatch.setattr(network_rows, "compiled_kernel", lambda network: None)


def odd_network(output, widths=(5, 7, 3), bands=(), seed=4):
    """A network of every input that there is, widths that are no whole fours."""
    names = tuple(FEATURES)
    rng = np.random.default_rng(seed)
    layers = tuple((rng.normal(size=(b, a)) / 3, rng.normal(size=b)) for a, b in pairwise((len(names), *widths)))
    return Network(names, layers, OUTPUTS[output], 2000.0, bands)


def sky_of(name, elevation=40.0, azimuth=137.0, turbidity=3.3):
    sun = sd.direction(azimuth * sd.deg, elevation * sd.deg)
    if name.startswith("odd-spectral"):
        return NeuralSpectralSky(
            sun, odd_network("exponential", (6, 5), (400.0, 500.0, 550.0, 600.0, 700.0)), turbidity
        )
    if name.startswith("odd"):
        return sd.NeuralSky(sun, odd_network(name[4:]), turbidity)
    kind = NeuralSpectralSky if "spectral" in name else sd.NeuralSky
    return kind.load(name, sun, turbidity)


def error(got, truth):
    """Largest error relative to the sky's brightest channel."""
    assert got.dtype == np.float32
    return float(np.abs(got - truth).max() / truth.max())


every_network = pytest.mark.parametrize("name", [*SHIPPED, "odd-rational", "odd-exponential", "odd-spectral"])
# Weights of opposite sign cancel to a few percent of their size, most of all in networks of 492 bytes under low suns.
suns = pytest.mark.parametrize(("elevation", "bound"), [(1.0, 2.5e-5), (15.0, 1e-5), (45.0, 1e-5), (90.0, 1e-5)])


@every_network
@suns
@pytest.mark.parametrize("azimuth", [0.0, 137.0, 180.0 + 180 / 128], ids=["seam", "off", "edge"])
def test_maps(name, elevation, bound, azimuth, always):
    sky = sky_of(name, elevation, azimuth)
    truth = sky.rgb(sd.Equirectangular().directions(HEIGHT)[: HEIGHT // 2])
    shown = sd.render(sky, HEIGHT).pixels
    assert error(shown[: HEIGHT // 2], truth) <= bound
    assert np.ptp(shown[HEIGHT // 2 :], axis=(0, 1)).max() == 0
    np.testing.assert_allclose(sd.render(sky, HEIGHT, dtype=np.float64).pixels[: HEIGHT // 2], truth, rtol=1e-9)


@every_network
@suns
def test_directions(name, elevation, bound, always):
    sky = sky_of(name, elevation)
    assert error(sky.rgb(VIEWS.astype(np.float32)), sky.rgb(VIEWS)) <= bound
    if sky.network.bands:
        middle = np.mean(sky.bands[1:3])
        truth = sky.radiance(VIEWS, [middle, sky.bands[-1]])
        assert error(sky.radiance(VIEWS.astype(np.float32), [middle, sky.bands[-1]]), truth) <= bound


@pytest.mark.parametrize("name", ["hosek-wilkie", "hosek-wilkie-deep", "hosek-wilkie-spectral"])
@pytest.mark.parametrize(
    "projection",
    [sd.Fisheye(), sd.Equirectangular(azimuth_left=1.1, mirrored=True), sd.EqualAreaSquare()],
    ids=["fisheye", "mirrored", "square"],
)
def test_projections_spaces_and_sums(name, projection, always):
    """Half a network plus a disc, in another colour space, on other layouts."""
    sky = sky_of(name)
    whole = 0.5 * sky + sd.SunDisc.of(sd.HosekWilkie(sky.sun, 3.3))
    shown = sd.render(whole, HEIGHT, projection=projection, space=sd.ACESCG, ground_albedo=0.0).pixels
    slow = sd.render(whole, HEIGHT, projection=projection, space=sd.ACESCG, ground_albedo=0.0, dtype=np.float64).pixels
    scale = np.median(slow[slow > 0])
    np.testing.assert_allclose(shown, slow, rtol=2e-5, atol=1e-4 * scale)
    two = sd.render(0.5 * sky + sd.Daylight(sd.Uniform(100.0)), HEIGHT, ground_albedo=0.0).pixels
    alone = sd.render(0.5 * sky, HEIGHT, ground_albedo=0.0).pixels + sd.render(
        sd.Daylight(sd.Uniform(100.0)), HEIGHT, ground_albedo=0.0
    ).pixels  # fmt: skip
    np.testing.assert_allclose(two, alone, rtol=0, atol=1e-5 * alone.max())


@every_network
@pytest.mark.parametrize("azimuth", [0.0, 137.0, 180.0 + 180 / 128], ids=["seam", "off", "edge"])
def test_maps_without_numba(name, azimuth, never):
    sky = sky_of(name, 45.0, azimuth)
    truth = sky.rgb(sd.Equirectangular().directions(HEIGHT)[: HEIGHT // 2])
    assert error(sd.render(sky, HEIGHT).pixels[: HEIGHT // 2], truth) <= 1e-5
    lens = sd.Fisheye()
    seen = lens.valid(HEIGHT) & (lens.directions(HEIGHT)[..., 2] >= 0)
    truth = sky.rgb(lens.directions(HEIGHT)[seen])
    assert error(sd.render(sky, HEIGHT, projection=lens).pixels[seen], truth) <= 2e-5


def test_night_and_what_is_not_valid_take_the_slow_form(always):
    night = sd.NeuralSky.load("hosek-wilkie", sd.direction(1.0, -0.2))
    assert (sd.render(night, 32).pixels == 0).all()
    unknown = sd.NeuralSky.load("hosek-wilkie", sd.direction(1.0, 0.5), 12.0, check="nan")
    assert np.isnan(sd.render(unknown, 32, ground_albedo=0.0).pixels[:16]).all()


@pytest.mark.parametrize(("height", "takes"), [(512, False), (1024, True)])
def test_large_maps_take_the_kernel_by_themselves(height, takes, monkeypatch):
    called = []
    real = network_rows.paint_by_kernel
    monkeypatch.setattr(network_rows, "paint_by_kernel", lambda *given: (called.append(1), real(*given)))
    sd.render(sky_of("hosek-wilkie"), height)
    assert bool(called) is takes


def test_every_input_is_known_to_the_fast_forms():
    """A new input must be added to the folding, the kernel and the shaders, or be one of the sky alone."""
    of_the_view = {"east", "north"} | set(FEATURES) - set(OF_THE_SKY) - {"view_x", "view_y"}
    assert set(INPUTS) == of_the_view
    assert set(fast_network.KERNEL_INPUTS) == of_the_view
    assert set(SHADER_INPUTS) == of_the_view


def test_networks_beyond_the_kernel_are_left_to_numpy():
    network, _ = shipped_network("hosek-wilkie")
    (weights, biases), last = network.layers
    huge = replace(network, layers=((1e5 * weights, biases), last))
    sun = sd.direction(1.0, 0.5)
    assert fast_network.compiled_kernel(sd.NeuralSky(sun, network).folded()) is not None
    assert fast_network.compiled_kernel(sd.NeuralSky(sun, huge).folded()) is None
    linear = Network(("distance",), ((np.ones((3, 1)), np.ones(3)),), OUTPUTS["rational"], 1.0)
    assert fast_network.compiled_kernel(sd.NeuralSky(sun, linear).folded()) is None
    got = sd.NeuralSky(sun, linear).rgb(VIEWS.astype(np.float32))
    np.testing.assert_allclose(got, sd.NeuralSky(sun, linear).rgb(VIEWS), rtol=1e-5)


def test_order_of_neurons_changes_nothing_but_rounding():
    network = sky_of("hosek-wilkie").folded()
    calm = steadied(network)
    ours, theirs = (np.sort(np.abs(each.layers[-1][0][0])) for each in (network, calm))
    np.testing.assert_array_equal(ours, theirs)
    views = VIEWS.astype(np.float32)
    np.testing.assert_allclose(
        fast_network.light_by_numpy(calm, views), fast_network.light_by_numpy(network, views), rtol=2e-4
    )
