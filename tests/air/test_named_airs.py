"""Air by what people know of it: kinds of aerosol, visibility, Linke's factor, measured depths, altitude."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.cross_sections import rayleigh_depth
from skydome.air.profiles import Exponential
from skydome.air.turbidity import from_linke, linke_of, meteorological_range

W = np.array([440.0, 550.0, 870.0])


def aerosols(air):
    """Depths of all aerosol at `W`."""
    return sum(part.depth(W) for part in air.constituents if isinstance(part, sd.Aerosol))


def test_kinds_have_opacs_numbers():
    """Hess, Koepke and Schult 1998: continental average, maritime clean, desert, urban."""
    kinds = {"continental": 0.151, "maritime": 0.096, "desert": 0.286, "urban": 0.643}
    for name, depth in kinds.items():
        air = getattr(sd.Atmosphere, name)()
        assert aerosols(air)[1] == pytest.approx(depth, rel=1e-12)
        assert aerosols(getattr(sd.Atmosphere, name)(0.2))[1] == pytest.approx(0.2, rel=1e-12)
    steep, flat = (aerosols(air)[0] / aerosols(air)[2] for air in (sd.Atmosphere.urban(), sd.Atmosphere.maritime()))
    assert steep > 2.2
    assert 1.0 < flat < 1.15
    assert sd.Atmosphere.urban().constituents[1].albedo < 0.82 < sd.Atmosphere.maritime().constituents[1].albedo


def test_the_stratosphere_has_its_part_of_the_depth():
    low, high = sd.Atmosphere.standard(0.1).constituents[1::2]
    assert (low.optical_depth + high.optical_depth, high.optical_depth) == pytest.approx((0.1, 0.006), rel=1e-12)
    assert sd.Atmosphere.standard(0.004).constituents[3].optical_depth == pytest.approx(0.004)
    assert len(sd.Atmosphere.standard(0.0).constituents) == 3
    many = sd.Atmosphere.standard(np.array([0.0, 0.1]))
    assert sum(part.depth([550.0])[..., 0] for part in many.constituents[1::2]).tolist() == [0.0, 0.1]


def test_visibility_and_linke_are_turbidities():
    seen = float(meteorological_range(np.asarray(3.0)))
    for air in (sd.Atmosphere.from_visibility(seen), sd.Atmosphere.from_linke(float(linke_of(3.0)))):
        assert aerosols(air)[1] == pytest.approx(2 * rayleigh_depth([550.0])[0], rel=1e-6)
    assert float(from_linke(linke_of(3.0))) == pytest.approx(3.0)


def test_measured_depths_come_back():
    depths = np.array([0.31, 0.22, 0.11])
    air = sd.Atmosphere.from_depths(W, depths, ozone=300.0)
    np.testing.assert_allclose(aerosols(air), depths, rtol=1e-3)
    far = sum(part.depth([1740.0]) for part in air.constituents if isinstance(part, sd.Aerosol))
    exponent = np.log(0.22 / 0.11) / np.log(870 / 550)
    np.testing.assert_allclose(far, 0.11 * 2.0**-exponent, rtol=2e-3)
    with pytest.raises(ValueError, match="wavelengths must increase"):
        sd.Atmosphere.from_depths([500.0, 400.0], [0.1, 0.1])
    with pytest.raises(ValueError, match=r"depths must be positive and finite, got \[0.1, 0.0\]"):
        sd.Atmosphere.from_depths([400.0, 500.0], [0.1, 0.0])


def test_altitude_lowers_the_pressure():
    place = sd.Place(latitude=-24.6, longitude=-70.4, altitude=2635.0)  # Paranal: 743 hPa
    molecules = sd.Atmosphere.standard(0.05).at_altitude(place.altitude).constituents[0]
    assert molecules.pressure == pytest.approx(74_300, rel=0.02)


def test_by_day_the_standard_air_is_what_it_was():
    """Against molecules that thin by e each 8 km and no high aerosol: 1.5 % in the mean, 3.5 % anywhere."""
    new_air = sd.Atmosphere.of_aerosol(sd.Aerosol(0.1), gases=None)
    old = sd.Atmosphere((sd.Molecules(profile=Exponential(8000.0)), sd.Aerosol(0.1), sd.Ozone()))
    views = sd.direction(*np.meshgrid(np.radians(np.arange(0, 181, 30)), np.radians([5.0, 20.0, 40.0, 60.0])))
    for elevation in (10.0, 45.0):
        sun = sd.direction(azimuth=0.0, elevation=elevation * sd.deg)
        new, before = (sd.Nishita93(sun, air).radiance(views, W) for air in (new_air, old))
        assert np.abs(new.mean(axis=(0, 1)) / before.mean(axis=(0, 1)) - 1).max() < 0.015
        assert np.abs(new / before - 1).max() < 0.035
