"""The Prague sky: a small file of its layout against the formula spelled out; the authors' own program, where given."""

import ctypes
import importlib.util
import os
import struct
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.skies.physical.prague.file import read_prague

spec = importlib.util.spec_from_file_location("catalogue", Path(__file__).parents[2] / "catalogue.py")
catalogue = importlib.util.module_from_spec(spec)
spec.loader.exec_module(catalogue)
SMALL = catalogue.PRAGUE
SUN = sd.direction(2.0, 30 * sd.deg)
WHEEL = os.environ.get("SKYDOME_PRAGUE")
real = pytest.mark.skipif(
    WHEEL is None, reason="needs SKYDOME_PRAGUE, a folder with the unpacked wheel of pyhelios3d (Linux)"
)


def test_the_lists_of_a_file():
    held = read_prague(str(SMALL))
    assert held.visibilities.tolist() == [20_000.0, 131_800.0]
    assert held.elevations.tolist() == [-4.0, 2.0, 30.0, 90.0]
    assert held.bands[0] == 360.0
    assert held.missing == ""
    assert held.transmittance is not None
    assert held.polarisation is not None


def test_radiance_is_the_sum_of_products_of_curves():
    """At a sky of the file, straight up, as the paper's formula has it, from the raw numbers."""
    sky = sd.Prague(SUN, SMALL, visibility=20_000.0, albedo=1.0, altitude=0.0)
    record = read_prague(str(SMALL)).radiance.table[0, 1, 0, 2, 4]
    view = sd.ZENITH
    to_sun = np.arccos(view @ SUN)
    terms = [
        np.interp(to_sun, np.linspace(0, np.pi, 13), term["sun"].astype(float))
        * np.interp(0.0, np.linspace(0, np.pi, 9), term["zenith"].astype(float) / term["scale"])
        for term in record["terms"]
    ]
    low, high = read_prague(str(SMALL)).radiance.table[0, 1, :, 2, 4]["emphasis"][:, 0].astype(float)
    ground = sum(terms) * low
    up = sd.Prague(SUN, SMALL, visibility=20_000.0, albedo=1.0, altitude=4950.0).radiance(view, [500.0])
    assert sky.radiance(view, [500.0])[0] == pytest.approx(ground * 0.99 + float(up[0]) * 0.01, rel=1e-9)
    assert high > 0


def test_between_skies_of_the_file_light_is_linear():
    views = sd.direction(np.arange(8.0), np.linspace(0.1, 1.5, 8))
    for name, low, high in (("visibility", 20_000.0, 131_800.0), ("albedo", 0.0, 1.0), ("altitude", 0.0, 4000.0)):
        ends = [sd.Prague(SUN, SMALL, **{name: value}) for value in (low, high)]
        middle = sd.Prague(SUN, SMALL, **{name: 0.25 * low + 0.75 * high}).radiance(views, [500.0])
        expected = 0.25 * ends[0].radiance(views, [500.0]) + 0.75 * ends[1].radiance(views, [500.0])
        np.testing.assert_allclose(middle, expected, rtol=0.3 if name == "altitude" else 1e-9)  # the angles change too


def test_bands_and_colour():
    sky = sd.Prague(SUN, SMALL)
    inside = sky.radiance(sd.ZENITH, [500.0, 539.0, 541.0])
    assert inside[0] == inside[1] != inside[2]
    fine = np.arange(360.0, 820.0, 0.25)
    from skydome.light.spectrum import xyz_weights

    np.testing.assert_allclose(sky.xyz(sd.ZENITH), sky.radiance(sd.ZENITH, fine) @ xyz_weights(fine), rtol=1e-2)
    with pytest.raises(ValueError, match=r"wavelengths must lie in \[340, 820\) nm, got 300 to 300"):
        sky.radiance(sd.ZENITH, [300.0])


def test_twilight_ends_where_the_file_does():
    assert sd.Prague(sd.direction(1.0, -3.9 * sd.deg), SMALL).luminance(sd.ZENITH) > 0
    assert sd.Prague(sd.direction(1.0, -4.1 * sd.deg), SMALL).luminance(sd.ZENITH) == 0


def test_from_a_height_the_sky_reaches_below_level():
    low = sd.direction(1.0, -1 * sd.deg)
    assert sd.Prague(SUN, SMALL).luminance(low) == 0
    assert sd.Prague(SUN, SMALL, altitude=4000.0).luminance(low) > 0


def test_transmittance_and_polarisation():
    sky = sd.Prague(SUN, SMALL)
    views = sd.direction(np.arange(5.0), np.linspace(-1.2, 1.5, 5))
    through = sky.transmittance(views, [450.0, 650.0], 1000.0)
    assert through.shape == (5, 2)
    assert ((through > 0) & (through < 1)).all()
    endless = sky.transmittance(views, [450.0], np.inf)
    np.testing.assert_allclose(endless, sky.transmittance(views, [450.0], 1e9), rtol=1e-12)
    polarised = sky.polarisation(VIEWS_UP, [450.0])
    assert polarised.shape == (6, 1)
    assert (np.abs(polarised) <= 1).all()


VIEWS_UP = sd.direction(np.arange(6.0), np.linspace(0.1, 1.5, 6))


@pytest.mark.parametrize("cut", [0, 3, 40, 300, 5000])
def test_a_file_that_is_none(tmp_path, cut):
    path = tmp_path / "cut.dat"
    path.write_bytes(SMALL.read_bytes()[:cut])
    with pytest.raises(ValueError, match=r"cut\.dat is not a file of the Prague sky model") as caught:
        sd.Prague(SUN, path)
    assert "\n" not in str(caught.value)


def test_a_block_of_the_wrong_size_is_refused_and_the_rest_read(tmp_path):
    path = tmp_path / "short.dat"
    path.write_bytes(SMALL.read_bytes()[:-5000])
    sky = sd.Prague(SUN, path)
    np.testing.assert_allclose(sky.luminance(VIEWS_UP), sd.Prague(SUN, SMALL).luminance(VIEWS_UP))
    with pytest.raises(ValueError, match=r"has no transmittance: .* wrong size"):
        sky.transmittance(sd.ZENITH, [500.0])
    with pytest.raises(ValueError, match="has no polarisation"):
        sky.polarisation(sd.ZENITH, [500.0])


def test_outside_the_file():
    with pytest.raises(ValueError, match=r"visibility must lie in \[20000, 131800\] m, got 5000"):
        sd.Prague(SUN, SMALL, visibility=5000.0)
    with pytest.raises(ValueError, match="distance must be 0 m or more"):
        sd.Prague(SUN, SMALL).transmittance(sd.ZENITH, [500.0], -1.0)


def authors_radiance(data, views, azimuth, elevation, visibility, wavelengths):
    """Radiance by the authors' own C++, compiled in the wheel's library, through its symbols."""
    library = ctypes.CDLL(str(next(Path(WHEEL).rglob("libhelios.so"))))
    number, pointer = ctypes.c_double, ctypes.c_void_p
    name = str(data).encode()
    text = ctypes.create_string_buffer(struct.pack("<QQq", len(name), len(name), 0) + name + b"\0")
    string, model = pointer(ctypes.addressof(text) + 24), ctypes.create_string_buffer(1 << 16)
    read = library._ZN14PragueSkyModel10initializeERKSsd
    read.argtypes, read.restype = [pointer, pointer, number], None
    read(model, ctypes.byref(string), 0.0)
    angles = library._ZNK14PragueSkyModel17computeParametersERKNS_7Vector3ES2_dddd
    angles.argtypes, angles.restype = [pointer] * 4 + [number] * 4, pointer
    light = library._ZNK14PragueSkyModel11skyRadianceERKNS_10ParametersEd
    light.argtypes, light.restype = [pointer, pointer, number], number
    found, parameters = [], (number * 8)()
    for view in views:
        at, toward = (number * 3)(), (number * 3)(*view)
        angles(parameters, model, at, toward, elevation, np.pi / 2 - azimuth, visibility, 1 / 3)
        found.append([light(model, parameters, w) for w in wavelengths])
    return np.array(found)


@real
def test_against_the_authors_program():
    """The reduced file of pyhelios3d 0.1.38, twelve suns: to 1e-7."""
    data = next(Path(WHEEL).rglob("PragueSkyModelReduced.dat"))
    rng, wavelengths = np.random.default_rng(0), [380.0, 450.0, 555.0, 700.0, 1300.0]
    for elevation in np.radians([-4.0, -2.0, -1.0, -0.3, 0.5, 3.0, 10.0, 25.0, 45.0, 60.0, 80.0, 89.0]):
        azimuth, visibility = rng.uniform(0, 6.28), rng.uniform(20, 131)
        views = sd.direction(rng.uniform(0, 6.28, 30), rng.uniform(0, 1.57, 30))
        own = sd.Prague(sd.direction(azimuth, elevation), data, visibility=visibility * 1000)
        expected = authors_radiance(data, views, azimuth, elevation, visibility, wavelengths)
        np.testing.assert_allclose(own.radiance(views, wavelengths), expected, rtol=1e-7)


@real
def test_the_reduced_file_lacks_its_transmittance():
    data = next(Path(WHEEL).rglob("PragueSkyModelReduced.dat"))
    sky = sd.Prague(SUN, data)
    assert sky.albedo == pytest.approx(1 / 3)
    with pytest.raises(ValueError, match="block of transmittance has the wrong size"):
        sky.transmittance(sd.ZENITH, [500.0])
    assert 0.8 < float(sd.illuminance(sky) / sd.illuminance(sd.PhysicalSky(SUN))) < 1.25
