"""What a sky, a place and a time are called in the page's address."""

from datetime import datetime
from typing import Any
from urllib.parse import urlencode

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Ozone
from skydome.air.named_airs import KINDS, depth_of_turbidity
from skydome.ground.arrays import as_numpy
from skydome.ground.directions import azimuth, elevation
from skydome.ground.units import deg
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.all_air.taught_air import kinds
from skydome.skies.catalogue import CATALOGUE
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.kinds import Altocumulus, Cirrus, Cumulus, Stratocumulus
from skydome.skies.clouds.fields.sky import CloudySky
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.perez import Perez
from skydome.skies.sky import Sky
from skydome.skies.suns.sun_disc import SunDisc
from skydome.sun.place import Place

VERSION = 1
"""Of the meaning of the names in an address, as the page has it."""
SHOWN = (Cumulus, Stratocumulus, Altocumulus, Cirrus)
MOST_SEED = 999
"""Kinds of clouds in the page, and seeds."""
KEYS = {
    "turbidity": "turbidity",
    "albedo": "albedo",
    "direct_normal_irradiance": "dni",
    "diffuse_horizontal_irradiance": "dhi",
    "dew_point": "dew",
    "diffuse_share": "share",
    "clearness": "clearness",
    "cloud": "cloud",
    "optical_depth": "depth",
}
"""Parameters of skies and their names in the address."""


def address(**told: Any) -> str:
    """The query of an address that tells these values, None for what is not told.

    >>> address(model="preetham", turbidity=2.5, place=None)
    '?v=1&model=preetham&turbidity=2.5'
    """
    known = {name: value for name, value in told.items() if value is not None}
    return "?" + urlencode({"v": VERSION} | known, safe=",:/")


def moment(place: Place | None, time: datetime | None, zone: str | None = None) -> dict[str, str]:
    """A place and a time in the address's words; a time without a named zone is told in one of whole hours.

    >>> from datetime import timezone, timedelta
    >>> moment(Place(45.07, 7.69), datetime(2026, 6, 21, 15, tzinfo=timezone(timedelta(hours=2))))
    {'place': '45.07,7.69', 'zone': 'Etc/GMT-2', 'date': '2026-06-21', 'time': '15:00'}
    """
    told = {} if place is None else {"place": f"{place.latitude:g},{place.longitude:g}"}
    if time is None:
        return told
    offset = time.utcoffset()
    if offset is None:
        raise ValueError(f"time must have a UTC offset, got {time.isoformat()}")
    hours = round(offset.total_seconds() / 3600)
    local = time if zone else time - offset + hours * (offset.resolution * 3_600_000_000)
    named = zone or ("Etc/GMT" if hours == 0 else f"Etc/GMT{-hours:+d}")
    return told | {"zone": named, "date": f"{local:%Y-%m-%d}", "time": f"{local:%H:%M}"}


def address_of(sky: Sky) -> str:
    """The address at which the page shows a sky of the catalogue: its model, its sun and its air,
    with or without the sun's disc.

    TypeError for a sky that no row of the catalogue makes, ValueError for one of more than one condition.

    >>> import skydome as sd
    >>> address_of(sd.Preetham(sd.direction(azimuth=180 * sd.deg, elevation=30 * sd.deg), turbidity=2.5))
    '?v=1&model=preetham&sun=180,30&turbidity=2.5'
    """
    rest = [part.single[0] for part in sky.parts if not isinstance(part.single[0], SunDisc)]
    inner = rest[0] if len(rest) == 1 else sky
    clouds: dict[str, str] = {}
    if isinstance(inner, CloudySky):
        clouds, rest = clouds_in_words(inner.field), [inner.clear]
        inner = inner.clear
    lit = inner.sunlit if len(rest) == 1 else None
    if lit is not None:
        inner = lit
    told: dict[str, Any] = {"model": model_name(inner)}
    if lit is not None:
        sun = as_numpy(lit.sun)
        if sun.shape != (3,):
            raise ValueError(f"the explorer shows one sky: parameters must be single numbers, got suns of {sun.shape}")
        told["sun"] = f"{plain(azimuth(sun) / deg)},{plain(elevation(sun) / deg)}"
    for name, key in KEYS.items():
        value: Any = getattr(inner, name, None)
        if np.asarray(value).dtype.kind in "fiu" and np.ndim(value) == 0:
            told[key] = plain(value)
    if isinstance(inner, Perez) and inner.illuminance is not None:
        told["letters"] = ",".join(plain(letter) for letter in (inner.a, inner.b, inner.c, inner.d, inner.e))
        told["lux"] = plain(inner.illuminance)
    if isinstance(inner, PhysicalSky):
        told |= air_in_words(inner.atmosphere)
    if isinstance(inner, OvercastSky):
        told["particles"] = inner.kind.name
    return address(**told | clouds)


def clouds_in_words(field: CloudField) -> dict[str, str]:
    """Kind, cover and seed of a field of cloud by their names in the address; ValueError for other sizes than usual.

    >>> clouds_in_words(CloudField(cover=0.3, seed=7))
    {'clouds': 'cumulus', 'clouded': '0.3', 'seed': '7'}
    """
    usual = CloudField(type(field.kind)(), field.cover, seed=field.seed, wind=field.wind)
    if not isinstance(field.kind, SHOWN) or field != usual or field.seed > MOST_SEED:
        raise ValueError(
            f"the explorer shows {', '.join(kind.name for kind in SHOWN)} of usual sizes and particles from the place "
            f"(0, 0), seeds up to {MOST_SEED}, got another field of {type(field.kind).__name__}"
        )
    return {"clouds": field.kind.name, "clouded": plain(field.cover), "seed": str(field.seed)}


def air_in_words(air: Atmosphere) -> dict[str, str]:
    """Turbidity, kind of aerosol, ozone and ground of a physical sky's air, by their names in the address.

    >>> air_in_words(Atmosphere.desert(0.2, ozone=300.0, albedo=0.3))
    {'turbidity': '3.0605', 'aerosol': 'desert', 'ozone': '300', 'albedo': '0.3'}
    """
    _, ozone, low, high = kinds(air)
    depth = sum(float(part.depth(np.array([550.0]))[0]) for part in (*low, *high))
    told = {"turbidity": f"{1 + depth / depth_of_turbidity(2.0):.4f}"}
    laws = [part.phase for part in low if isinstance(part, Aerosol)]
    found = [name for name, kind in KINDS.items() if laws == [kind.phase]]
    told |= {"aerosol": found[0]} if found else {}
    column = sum(part.column for part in ozone if isinstance(part, Ozone))
    return told | {"ozone": plain(column), "albedo": plain(air.albedo)}


def model_name(sky: Sky) -> str:
    """The catalogue's name of a sky; TypeError where it has none."""
    for model in CATALOGUE:
        if type(sky) is model.kind and all(
            getattr(sky, name, value) == value for name, value in model.fixed.items() if name != "network"
        ):
            return model.name
    raise TypeError(f"the explorer shows the skies that `skydome models` lists, got {type(sky).__name__}")


def plain(value: Any) -> str:
    """A number with at most six digits after the point, without zeros at its end."""
    return f"{float(value):.6f}".rstrip("0").rstrip(".")
