"""Every number that a sky, a sun, an atmosphere, an eye or a map takes has a range, and is finite."""

import dataclasses
import inspect
from importlib import import_module
from pkgutil import walk_packages
from typing import Any, get_args, get_origin

import numpy as np
import pytest

import skydome as sd
from skydome.ground.limits.ranges import SHARE, Bounded, Range, inside, require

SUN = np.array([0.0, 0.6, 0.8])
NOT_NUMBERS = {"sun", "standing", "directions"}
"""Directions, which are looked at as such."""

BEYOND = [float("nan"), float("inf"), -float("inf"), 1e300, -1e300]


def everywhere(kind):
    """A class and all that come from it, wherever they are written."""
    for module in walk_packages(sd.__path__, "skydome."):
        if not module.name.endswith("__main__"):
            import_module(module.name)
    found, open_ones = set(), [kind]
    while open_ones:
        for child in open_ones.pop().__subclasses__():
            if child not in found:
                found.add(child)
                open_ones.append(child)
    return sorted(
        (child for child in found if child.__module__.startswith("skydome")), key=lambda child: child.__name__
    )


def is_numeric(annotation):
    """True for float, int, Any and what may be one of them."""
    if annotation in (float, int, Any):
        return True
    return get_origin(annotation) is not None and any(part in (float, int) for part in get_args(annotation))


def test_a_new_parameter_needs_a_range():
    lacking = {}
    for kind in everywhere(Bounded):
        if dataclasses.is_dataclass(kind) and not inspect.isabstract(kind):
            declared = {*kind.all_bounds(), *getattr(kind, "ranges", {}), *NOT_NUMBERS}
            named = {item.name for item in dataclasses.fields(kind) if item.init and is_numeric(item.type)}
            lacking |= {kind.__name__: missing} if (missing := named - declared) else {}
    assert lacking == {}


def examples():
    """One of each kind whose numbers can be tried."""
    from skydome.air.clouds.crystals.phase import Prisms
    from skydome.air.clouds.phases import Droplets
    from skydome.air.mie import MieParticles
    from skydome.air.phase_laws import CornetteShanks, Rayleigh
    from skydome.air.profiles import Exponential
    from skydome.air.size_distributions import GammaSizes, Junge, Lognormal
    from skydome.eye.eye import Eye
    from skydome.eye.lens_flare import LensFlare
    from skydome.eye.point_spread import CIETotal, Spencer, StilesHolladay
    from skydome.eye.streaks import Needles
    from skydome.eye.view import Camera
    from skydome.haze.aerial_perspective import AirLight
    from skydome.haze.published import AdaptiveQuadrature
    from skydome.land.elevation import Elevation
    from skydome.light.tone import Reinhard
    from skydome.maps.environment_map import EnvironmentMap
    from skydome.maps.projections import Fisheye
    from skydome.own_air.grid import Grid
    from skydome.surroundings.canyon import StreetCanyon

    air = sd.Atmosphere()
    yield from (air, sd.Molecules(), sd.Molecules(optical_depth=0.1), sd.Aerosol(), sd.Ozone(), Rayleigh())
    yield from (sd.Cloud(), Droplets(), sd.HexagonalIce(), Prisms(), sd.NitrogenDioxide())
    yield from (
        CornetteShanks(0.7),
        Exponential(8e3),
        Lognormal(1e-7, 2.0),
        Junge(3.0, 1e-7, 1e-5),
        GammaSizes(1e-6, 0.2),
    )
    yield from (
        MieParticles(Junge()),
        Eye(),
        Eye(pupil=3.0),
        LensFlare(),
        Spencer(),
        CIETotal(30.0),
        StilesHolladay(30.0),
    )
    yield from (Needles(), Reinhard(), AirLight(sd.Preetham(SUN, 3.0), None, 3.0, 0.2), AdaptiveQuadrature(), Grid())
    yield from (Elevation(np.zeros((4, 4)), 10.0, 10.0), Fisheye(), EnvironmentMap(np.ones((4, 8, 3))), Camera())
    yield from (
        sd.HosekWilkie(SUN, 3.0),
        sd.Preetham(SUN, 3.0),
        sd.PathTraced(SUN, air),
        sd.DiscreteOrdinates(SUN, air),
    )
    yield from (StreetCanyon(10.0, 10.0), sd.Nishita96(SUN, air), sd.CIE(SUN, 12, illuminance=1e4), sd.Uniform(1.0))
    yield from (sd.PerezAllWeather(SUN, 700.0, 100.0), sd.PerezAllWeather(SUN, 700.0, 100.0, illuminance=1e4))
    yield from (
        sd.Perez(SUN, -1.0, -0.3, 10.0, -3.0, 0.45, illuminance=1e4),
        sd.SunDisc(SUN, 3.0),
        sd.Place(45.0, 7.0, 9.0),
    )
    yield from (sd.SunDisc(SUN, 3.0, direct_normal_illuminance=1e5), sd.CIEIntermediate(SUN, zenith_luminance=9e3))
    yield from (sd.MoonSpencer(zenith_luminance=1.0), sd.MoonSpencer(illuminance=1.0))


ANGLES = {"azimuth", "azimuth_left", "east", "north"}
"""Finite, and as large as one likes."""


@pytest.mark.parametrize("example", list(examples()), ids=lambda example: type(example).__name__)
def test_a_number_beyond_its_range_is_refused(example):
    tried = 0
    for item in dataclasses.fields(example):
        value = getattr(example, item.name)
        if item.init and isinstance(value, int | float) and not isinstance(value, bool):
            for number in BEYOND[: 3 if item.name in ANGLES else None]:
                with pytest.raises(ValueError, match=r"."):
                    dataclasses.replace(example, **{item.name: number})
                tried += 1
    assert tried


@pytest.mark.parametrize("check", ["raise", "clamp", "nan"])
@pytest.mark.parametrize(
    ("made", "name"),
    [
        (lambda check: sd.SunDisc(SUN, 3.0, direct_normal_illuminance=-1e5, check=check), "direct_normal_illuminance"),
        (lambda check: sd.CIEIntermediate(SUN, zenith_luminance=-3543.0, check=check), "zenith_luminance"),
        (lambda check: sd.PathTraced(SUN, paths_per_pass=0, check=check), "paths_per_pass"),
        (lambda check: sd.PathTraced(SUN, sd.Atmosphere(sun_scale=-1.0), check=check), "sun_scale"),
        (lambda check: sd.Uniform(float("inf"), check=check), "value"),
    ],
)
def test_what_means_nothing_is_refused_whatever_check_says(made, name, check):
    with pytest.raises(ValueError, match=f"{name} must lie in"):
        made(check)


def test_what_is_no_number_is_not_clamped():
    with pytest.raises(ValueError, match="dew_point must lie in"):
        sd.PerezAllWeather(SUN, 700.0, 100.0, dew_point=float("nan"), check="clamp")
    kelvin, warm = (sd.PerezAllWeather(SUN, 700.0, 100.0, dew_point=t, check="clamp") for t in (284.0, 60.0))
    assert float(kelvin.diffuse_illuminance) == float(warm.diffuse_illuminance)
    assert not np.isfinite(sd.Preetham(SUN, float("nan"), check="nan").luminance(sd.ZENITH))


def test_ranges_are_finite_and_told():
    assert str(Range(0.0, float("inf"), "lx")) == "[0, inf) lx"
    assert inside(np.array([0.0, 1e300, np.inf, np.nan]), Range(0.0, float("inf"))).tolist() == [
        True,
        True,
        False,
        False,
    ]
    with pytest.raises(ValueError, match=r"albedo must lie in \[0, 1\], got 1.5"):
        require("albedo", sd.Spectrum([400.0, 500.0], [0.5, 1.5]), SHARE)
