"""Obstructed light in XYZ, RGB and wavelengths: the same as each channel run for itself, and as the open sky's."""

from dataclasses import dataclass

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.light.colour import rgb_from_xyz
from skydome.light.spectrum import Spectrum, xyz_weights
from skydome.skies.sky import Sky

SUN = sd.direction(200 * deg, 35 * deg)
SKY = sd.Preetham(SUN, turbidity=3.0)
WHOLE = SKY + sd.SunDisc.of(SKY)
HILLS = sd.Horizon(np.array([0, 90, 180, 270]) * deg, np.array([5, 10, 25, 20]) * deg)
GREY = sd.MoonSpencer(zenith_luminance=1000.0)
PLANE = sd.direction(180 * deg, 50 * deg)
WAVES = np.array([420.0, 550.0, 680.0])
BRICK = Spectrum([400.0, 500.0, 600.0, 700.0], [0.1, 0.15, 0.45, 0.6])


@dataclass(frozen=True, eq=False)
class Channel(Sky):
    """One channel of a sky's light, as if it were luminance."""

    inner: Sky
    kind: object
    index: int

    def luminance(self, directions):
        return self.kind.toward(self.inner, directions)[..., self.index]


KINDS = [sd.LightInXYZ(), sd.LightInRGB(), sd.LightInRGB(sd.REC2020), sd.LightInWavelengths(WAVES)]


@pytest.mark.parametrize("kind", KINDS)
def test_behind_hills_each_channel_is_as_if_alone(kind):
    view, albedo = sd.PlaneView.of(HILLS, PLANE, 32), np.array([0.1, 0.2, 0.4])
    received = view.receive(SKY, albedo=albedo, light=kind)
    assert received.total.shape == (3,)
    for c in range(3):
        alone = view.receive(Channel(SKY, kind, c), albedo=float(albedo[c]))
        assert received.sky[c] == pytest.approx(float(alone.sky), rel=1e-12)
        assert received.reflected[c] == pytest.approx(float(alone.reflected), rel=1e-12)
    faces = {0: np.array([1.0, 2.0, 3.0])}
    lit = view.receive(SKY, faces, light=kind).reflected
    np.testing.assert_allclose(lit, faces[0] * view.receive(SKY, {0: 1.0}).reflected, rtol=1e-12)


def test_y_is_the_illuminance_and_rgb_is_of_xyz():
    xyz, rgb, lux = (
        sd.obstructed_illuminance(WHOLE, HILLS, PLANE, albedo=0.2, light=kind)
        for kind in (sd.LightInXYZ(), sd.LightInRGB(), sd.LightInLux())
    )
    for name in ("sky", "sun", "reflected", "total"):
        assert getattr(xyz, name)[1] == pytest.approx(float(getattr(lux, name)), rel=1e-6)
        np.testing.assert_allclose(getattr(rgb, name), rgb_from_xyz(getattr(xyz, name)), rtol=1e-6)
    assert xyz.sun[1] > 10_000


def test_wavelengths_add_up_to_xyz():
    """10 nm; Preetham's spectra have their XYZ within the rounding of his A.5."""
    bands = np.arange(380.0, 781.0, 10.0)
    spectrum = sd.obstructed_illuminance(SKY, HILLS, PLANE, albedo=0.2, light=sd.LightInWavelengths(bands))
    xyz = sd.obstructed_illuminance(SKY, HILLS, PLANE, albedo=0.2, light=sd.LightInXYZ())
    np.testing.assert_allclose(spectrum.total @ xyz_weights(bands), xyz.total, rtol=2e-3)


def test_the_open_horizon_gives_the_open_skys_irradiance():
    grass = Spectrum([400.0, 700.0], [0.05, 0.4])
    for normal in (sd.ZENITH, sd.SOUTH, PLANE):
        received = sd.obstructed_illuminance(
            WHOLE, sd.Horizon.level(0.0), normal, albedo=grass, light=sd.LightInWavelengths(WAVES)
        )
        np.testing.assert_allclose(received.total, sd.irradiance(WHOLE, WAVES, normal, ground_albedo=grass), rtol=1e-3)


def test_bands_in_channels():
    bands = sd.Bands.of(PLANE, 8)
    for kind in KINDS:
        light = bands.illuminance(SKY, light=kind)
        assert light.shape == (bands.count, 3)
        alone = [bands.illuminance(Channel(SKY, kind, c)) for c in range(3)]
        np.testing.assert_allclose(light, np.stack(alone, axis=-1), rtol=1e-12)


def test_a_street_of_brick_by_wavelength():
    """Against a street of each wavelength's own reflectance, sun and all."""
    kind = sd.LightInWavelengths(WAVES)
    street = sd.StreetCanyon(8.0, 10.0, 0.4, floor_reflectance=0.2, wall_reflectance=BRICK, strips=4)
    lit = street.illuminance(SKY, [-2.0, 3.0], bands=16, light=kind)
    assert lit.total.shape == (2, 3)
    for c, share in enumerate(BRICK.at(WAVES)):
        grey = sd.StreetCanyon(8.0, 10.0, 0.4, 0.2, float(share), strips=4)
        alone = grey.illuminance(Channel(SKY, kind, c), [-2.0, 3.0], bands=16)
        for name in ("sky", "reflected"):
            np.testing.assert_allclose(getattr(lit, name)[:, c], getattr(alone, name), rtol=1e-9)
    warm = street.illuminance(WHOLE, [0.0], bands=16, light=kind)
    tint = (warm.reflected / warm.sky)[0]
    assert tint[2] > 3 * tint[0]


def test_a_day_of_colour_in_a_street():
    suns = sd.direction(np.linspace(1.8, 4.5, 3), np.linspace(0.2, 0.9, 3))[:, None, :]
    street = sd.StreetCanyon(10.0, 8.0, 0.0, 0.2, np.array([0.5, 0.4, 0.3]), 4)
    day = sd.Preetham(suns, turbidity=3.0)
    lit = street.illuminance(day + sd.SunDisc.of(day), [0.0, 1.0], bands=16, light=sd.LightInRGB())
    assert lit.total.shape == lit.sun.shape == lit.reflected.shape == (3, 2, 3)
    one = sd.Preetham(suns[1, 0], turbidity=3.0)
    alone = street.illuminance(one + sd.SunDisc.of(one), [0.0, 1.0], bands=16, light=sd.LightInRGB())
    np.testing.assert_allclose(lit.total[1], alone.total, rtol=1e-9)


def test_a_mesh_by_wavelength():
    pytest.importorskip("trimesh")
    pytest.importorskip("embreex")
    corners = [[-4, 3, 0], [4, 3, 0], [4, 3, 5], [-4, 3, 5], [-4, -3, 0], [4, -3, 0], [4, -3, 5], [-4, -3, 5]]
    faces = [[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]]
    kind, points = sd.LightInWavelengths(WAVES), [[0, 0, 0.0], [1, 1, 0.5]]
    each = np.linspace(0.1, 0.6, 12).reshape(4, 3)
    for reflectance in (BRICK, each, 0.4, Spectrum(WAVES, each)):
        lit = sd.MeshScene(corners, faces, reflectance, 0.2).illuminance(SKY, points, bands=16, light=kind)
        assert lit.total.shape == (2, 3)
        for c in range(3):
            if isinstance(reflectance, Spectrum):
                own = reflectance.at(WAVES)[..., c]
            else:
                own = np.broadcast_to(reflectance, (4, 3))[:, c]
            alone = sd.MeshScene(corners, faces, own, 0.2).illuminance(Channel(SKY, kind, c), points, bands=16)
            np.testing.assert_allclose(lit.total[:, c], alone.total, rtol=1e-9)
    fine = sd.MeshScene(corners, faces, Spectrum(WAVES, each), 0.2).finer(3.0)
    assert fine.reflectances(kind).shape == (len(fine.faces), 3)


def test_colour_in_torch_with_gradients():
    torch = pytest.importorskip("torch")
    turbidity = torch.tensor(3.0, dtype=torch.float64, requires_grad=True)
    sky = sd.Preetham(torch.as_tensor(SUN), turbidity)
    received = sd.obstructed_illuminance(sky, HILLS, PLANE, bands=16, albedo=0.2, light=sd.LightInRGB())
    expected = sd.obstructed_illuminance(SKY, HILLS, PLANE, bands=16, albedo=0.2, light=sd.LightInRGB())
    np.testing.assert_allclose(received.total.detach().numpy(), expected.total, rtol=1e-9)
    received.total.sum().backward()
    assert torch.isfinite(turbidity.grad)
    assert turbidity.grad != 0


@pytest.mark.parametrize(
    ("work", "error", "said"),
    [
        (lambda: sd.obstructed_illuminance(SKY, HILLS, albedo=BRICK), ValueError, "needs light=LightInWavelengths"),
        (
            lambda: sd.obstructed_illuminance(SKY, HILLS, albedo=[0.1, 0.2], light=sd.LightInRGB()),
            ValueError, r"one of the shapes \[\(\), \(3,\)\], got \(2,\)",
        ),
        (
            lambda: sd.obstructed_illuminance(GREY, HILLS, light=sd.LightInRGB()),
            TypeError, "knows luminance only",
        ),
        (
            lambda: sd.obstructed_illuminance(GREY, HILLS, light=sd.LightInWavelengths(WAVES)),
            TypeError, "knows no spectrum",
        ),
        (lambda: sd.LightInWavelengths([500.0, 400.0]), ValueError, "must increase"),
        (lambda: sd.StreetCanyon(1.0, 1.0, 0.0, [0.1, 1.0]), ValueError, r"floor_reflectance must lie in \[0, 1\)"),
        (lambda: sd.StreetCanyon(1.0, 1.0, 0.0, BRICK).illuminance(SKY, [0.0]), ValueError, "needs light="),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused(work, error, said):
    with pytest.raises(error, match=said):
        work()
