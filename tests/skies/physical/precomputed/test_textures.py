"""Textures that other programs read: their packing, and files read back."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.physical.precomputed.grid import SMALL
from skydome.skies.physical.precomputed.textures import BANDS, DEMO, DEMO_LOWEST_SUN, GEOSPATIAL, GEOSPATIAL_EXR

pytest.importorskip("numba")
AIR = sd.Atmosphere.bruneton2016()


@pytest.fixture(scope="module")
def tables():
    return sd.ScatteringTables.of(AIR, BANDS, 3, SMALL, DEMO_LOWEST_SUN)


@pytest.fixture(scope="module")
def textures(tables):
    return sd.ScatteringTextures.of(tables)


def test_texels_are_packed_as_the_shaders_unpack_them(tables, textures):
    i, j, k, n = 3, 18, 20, 5  # the x of a texel is angle x suns + sun
    _, views, suns, angles = tables.orders.nodes
    texel, sun = textures.scattering[i, j, n * SMALL.suns + k], AIR.sun_at(np.array(BANDS))
    spread = np.sqrt((1 - views[i, j] ** 2) * (1 - suns[k] ** 2))
    nu = min(max(angles[n], views[i, j] * suns[k] - spread), views[i, j] * suns[k] + spread)
    rayleigh = 3 / (16 * np.pi) * (1 + nu**2)
    plain = tables.once[0, i, j, k, n] * rayleigh + tables.multiple[i, j, k, n]
    np.testing.assert_allclose(texel[:3][::-1] * rayleigh, plain * sun, rtol=1e-5)
    assert texel[3] == pytest.approx(tables.once[1, i, j, k, n, 2] * sun[2], rel=1e-5)


def test_the_haze_comes_back_from_its_red(tables, textures):
    """The readers' extrapolation (red of haze over red of molecules) is near the table's own where haze is."""
    told, texel = textures.parameters, textures.scattering[0, 14, 2 * SMALL.suns + 22]
    ratio = np.array(told["mieScattering"]) / np.array(told["rayleighScattering"])
    haze = texel[:3] * texel[3] / texel[0] * ratio / ratio[0]
    own = tables.once[1, 0, 14, 22, 2, ::-1] * np.array(told["solarIrradiance"])
    np.testing.assert_allclose(haze, own, rtol=0.35)


@pytest.mark.parametrize(("form", "step"), [(DEMO, 0.0), (GEOSPATIAL, 1e-3), (GEOSPATIAL_EXR, 1e-3)])
def test_files_come_back(textures, form, step, tmp_path):
    if form is GEOSPATIAL_EXR:
        pytest.importorskip("OpenEXR")
    form.save(textures, tmp_path)
    back = form.load(tmp_path, SMALL)
    for name in ("transmittance", "scattering", "irradiance"):
        np.testing.assert_allclose(getattr(back, name), getattr(textures, name), rtol=step, atol=step * 1e-3)
    assert back.parameters == textures.parameters
    with pytest.raises(ValueError, match="must have"):
        form.load(tmp_path)


def test_raw_files_have_the_bytes_of_the_readers(textures, tmp_path):
    """Of the published sizes: 256 x 64, 256 x 128 x 32 and 64 x 16 texels of 16 bytes, or of 8."""
    from skydome.skies.physical.precomputed.grid import PUBLISHED
    from skydome.skies.physical.precomputed.textures import shapes

    texels = {name: int(np.prod(shape[:-1])) for name, shape in shapes(PUBLISHED).items()}
    assert texels == {"transmittance": 256 * 64, "scattering": 256 * 128 * 32, "irradiance": 64 * 16}
    DEMO.save(textures, tmp_path)
    first = np.frombuffer((tmp_path / "transmittance.dat").read_bytes(), "<f4")[:4]
    np.testing.assert_allclose(first, textures.transmittance[0, 0])
    assert first[3] == 1


def test_errors_in_one_line(tables):
    with pytest.raises(ValueError, match="textures need tables at three wavelengths, got 2"):
        sd.ScatteringTextures.of(sd.ScatteringTables.of(AIR, [450.0, 650.0], 1, SMALL))
