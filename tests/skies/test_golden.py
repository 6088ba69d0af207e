"""Golden numbers, each with its source beside it."""

import json
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.skies.formula.perez_formula import evaluate
from skydome.skies.hosek_wilkie import band_weights, interpolated_coefficients
from skydome.skies.suns.sun_disc import PUBLISHED_RADIUS, limb_darkening

GOLDEN = Path(__file__).parent.parent / "golden"


@pytest.fixture(scope="module")
def hosek():
    """400 random conditions by the authors' program 1.4a, double precision (shared data, README there)."""
    return np.genfromtxt(GOLDEN / "hosek_reference_values.csv", delimiter=",", names=True)


def published_light(form, rows):
    coefficients = interpolated_coefficients(
        form, rows["turbidity"], rows["albedo"][:, None], rows["sun_elevation_rad"]
    )
    return evaluate(coefficients, np.cos(rows["view_zenith_rad"]), rows["sun_angle_rad"], 0.01)


@pytest.mark.parametrize("form", ["xyz", "rgb"])
def test_hosek_wilkie_channels(hosek, form):
    expected = np.stack([hosek[channel] for channel in form], axis=-1)
    np.testing.assert_allclose(published_light(form, hosek), expected, rtol=1e-11)


def test_hosek_wilkie_bands(hosek):
    weights = np.array([band_weights(w)[:, 0] for w in hosek["wavelength_nm"]])
    light = (published_light("spectral", hosek) * weights).sum(axis=-1)
    np.testing.assert_allclose(light, hosek["spectral_radiance"], rtol=1e-11)


def consistent_geometry(rows):
    """Sun and view vectors that have the row's three angles, for the rows whose angles fit on a sphere."""
    sun_zenith, view_zenith, angle = (
        np.pi / 2 - rows["sun_elevation_rad"],
        rows["view_zenith_rad"],
        rows["sun_angle_rad"],
    )
    cosine = (np.cos(angle) - np.cos(sun_zenith) * np.cos(view_zenith)) / (np.sin(sun_zenith) * np.sin(view_zenith))
    fits = np.abs(cosine) <= 1
    azimuth = np.arccos(cosine[fits])
    sun = sd.direction(np.zeros(fits.sum()), rows["sun_elevation_rad"][fits])
    return fits, sun, sd.direction(azimuth, np.pi / 2 - view_zenith[fits])


def test_hosek_wilkie_through_directions(hosek):
    fits, sun, view = consistent_geometry(hosek)
    assert fits.sum() > 100
    rows = hosek[fits]
    xyz = sd.HosekWilkie(sun, rows["turbidity"], rows["albedo"]).xyz(view)
    expected = 683 * np.stack([rows["x"], rows["y"], rows["z"]], axis=-1)
    near = np.minimum(rows["sun_angle_rad"], 1) > 1e-3  # arccos above loses digits nearer to the sun
    np.testing.assert_allclose(xyz[near], expected[near], rtol=1e-9)


def test_solar_radiance():
    """200 conditions of the sun's disc by the authors' program 1.4a."""
    rows = np.genfromtxt(GOLDEN / "hosek_solar_reference_values.csv", delimiter=",", names=True)
    assert (rows["direct_radiance"] > 0).sum() > 150
    for row in rows:
        sun = sd.direction(0.0, row["sun_elevation_rad"])
        disc = sd.SunDisc(sun, row["turbidity"], PUBLISHED_RADIUS)
        inside = row["sun_angle_rad"] <= PUBLISHED_RADIUS
        ratio = np.sin(row["sun_angle_rad"]) / np.sin(PUBLISHED_RADIUS)
        mu = np.asarray(np.sqrt(max(0.0, 1 - ratio**2)))
        wavelength = [row["wavelength_nm"]]
        light = (disc.centre_radiance(wavelength) * limb_darkening(mu, wavelength))[0] * inside
        assert light == pytest.approx(row["direct_radiance"], rel=1e-11, abs=1e-11)


def test_cie_values():
    """Values evaluated from the standard's table and formula by an independent program (note in the file)."""
    stored = json.loads((GOLDEN / "cie_s011_values.json").read_text())
    count = 0
    for entry in stored["values"]:
        sun = sd.direction(entry["sun_azimuth_deg"] * sd.deg, entry["sun_altitude_deg"] * sd.deg)
        sky = sd.CIE(sun, entry["type"], zenith_luminance=1.0)
        for name, expected in entry["relative_luminance_L_over_Lz"].items():
            altitude, azimuth = (float(part[3 if part[:3] == "alt" else 2 :]) for part in name.split("_"))
            view = sd.direction(azimuth * sd.deg, altitude * sd.deg)
            assert float(sky.luminance(view)) == pytest.approx(expected, rel=1e-6, abs=2e-8)
            count += 1
        total = entry["diffuse_horizontal_illuminance_over_Lz"]
        level = sd.CIE(sun, entry["type"], illuminance=total)
        assert float(level.luminance(sd.ZENITH)) == pytest.approx(1.0, rel=2e-5)
        assert float(sd.illuminance(sky)) == pytest.approx(total, rel=2e-5)
    assert count >= 15 * 3 * 10


def test_cie_values_of_colour_science():
    """Docstring values of colour-science's module (types 1 and 12)."""
    for kind, expected in ((1, 0.8325846), (12, 0.4544524)):
        sky = sd.CIE(sd.direction(0.0, 60 * sd.deg), kind, zenith_luminance=1.0)
        assert float(sky.luminance(sd.direction(np.pi, 45 * sd.deg))) == pytest.approx(expected, abs=1e-7)


def literal_preetham(turbidity, sun_zenith, view_zenith, angle):
    """Preetham 1999, A.2, line by line: Y in cd m-2, x, y."""
    T = turbidity
    ts = sun_zenith

    def F(letters, theta, gamma):
        A, B, C, D, E = letters
        return (1 + A * np.exp(B / np.cos(theta))) * (1 + C * np.exp(D * gamma) + E * np.cos(gamma) ** 2)

    Y = [0.1787 * T - 1.4630, -0.3554 * T + 0.4275, -0.0227 * T + 5.3251, 0.1206 * T - 2.5771, -0.0670 * T + 0.3703]
    x = [-0.0193 * T - 0.2592, -0.0665 * T + 0.0008, -0.0004 * T + 0.2125, -0.0641 * T - 0.8989, -0.0033 * T + 0.0452]
    y = [-0.0167 * T - 0.2608, -0.0950 * T + 0.0092, -0.0079 * T + 0.2102, -0.0441 * T - 1.6537, -0.0109 * T + 0.0529]
    chi = (4 / 9 - T / 120) * (np.pi - 2 * ts)
    Yz = (4.0453 * T - 4.9710) * np.tan(chi) - 0.2155 * T + 2.4192
    powers = np.array([ts**3, ts**2, ts, 1.0])
    Mx = [[0.0017, -0.0037, 0.0021, 0.000], [-0.0290, 0.0638, -0.0320, 0.0039], [0.1169, -0.2120, 0.0605, 0.2589]]
    My = [[0.0028, -0.0061, 0.0032, 0.000], [-0.0421, 0.0897, -0.0415, 0.0052], [0.1535, -0.2676, 0.0667, 0.2669]]
    xz = np.array([T * T, T, 1]) @ np.array(Mx) @ powers
    yz = np.array([T * T, T, 1]) @ np.array(My) @ powers
    return [
        scale * level * F(letters, view_zenith, angle) / F(letters, 0.0, ts)
        for scale, level, letters in ((1, xz, x), (1, yz, y), (1000, Yz, Y))
    ]


def test_preetham_equals_the_literal_paper():
    rng = np.random.default_rng(3)
    for _ in range(300):
        turbidity, elevation = rng.uniform(2, 6), rng.uniform(0.02, np.pi / 2)
        sun = sd.direction(rng.uniform(0, 7), elevation)
        view = sd.direction(rng.uniform(0, 7), rng.uniform(0.01, 1.57))
        angle = float(sd.angle_between(sun, view))
        zenith = np.arccos(view[2])
        expected = literal_preetham(turbidity, np.pi / 2 - elevation, zenith, angle)
        got = sd.Preetham(sun, turbidity).xyY(view)
        np.testing.assert_allclose(got, expected, rtol=1e-12)


def test_kittler_and_moon_spencer_formulas():
    """Preetham 1999, eq. 1 and 2, written out."""
    rng = np.random.default_rng(4)
    sun = sd.direction(1.0, 0.7)
    views = sd.direction(rng.uniform(0, 7, 50), rng.uniform(0.01, 1.57, 50))
    angle, cosine, ts = sd.angle_between(sun, views), views[:, 2], np.pi / 2 - 0.7
    expected = (0.91 + 10 * np.exp(-3 * angle) + 0.45 * np.cos(angle) ** 2) * (1 - np.exp(-0.32 / cosine))
    expected /= (0.91 + 10 * np.exp(-3 * ts) + 0.45 * np.cos(ts) ** 2) * (1 - np.exp(-0.32))
    np.testing.assert_allclose(sd.CIEClear(sun, zenith_luminance=1.0).luminance(views), expected, rtol=1e-12)
    overcast = sd.MoonSpencer(illuminance=7 * np.pi / 9 * 3000.0)
    np.testing.assert_allclose(overcast.luminance(views), 1000 * (1 + 2 * cosine), rtol=1e-12)
