"""Light on planes through a year, hour by hour: `on_planes("site.epw", Plane(30 * deg))`."""

from collections.abc import Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.dome.patches import patches as patches_named
from skydome.ground.arguments import require_kind
from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.ground.limits.ranges import SHARE, require, require_one
from skydome.ground.units import SOLAR_CONSTANT, deg
from skydome.sun.position import earth_sun_distance, radius_at
from skydome.surroundings.intervals import Open
from skydome.years.planes.coefficients import Coefficients
from skydome.years.planes.plane import Plane, labels_of
from skydome.years.planes.transposition import FromPatches, Hours, Transposition, transposition_named
from skydome.years.skies.series import year as year_of
from skydome.years.weather.weather import Weather

if TYPE_CHECKING:
    import pandas as pd
    import xarray

PARTS = {
    "sky": "from the sky",
    "sun": "from the sun",
    "reflected": "reflected by ground and faces",
    "": "in all",
}
QUANTITIES = {"illuminance": "lx", "irradiance": "W m-2"}
FINE = "reinhart:4"
"""Patches where a file is given: planes then have within 0.1 % of the continuous sky's light (Tregenza's: 0.5 %)."""


def on_planes(
    year: "xarray.Dataset | Weather | str | PathLike[str] | pd.DataFrame",
    planes: Plane | Sequence[Plane],
    albedo: float = 0.2,
    transposition: "str | Transposition" = "perez-1993",
    **reading: Any,
) -> "xarray.Dataset":
    """Light on planes through a year: illuminance, lx, and irradiance, W m-2, (time, plane), by part, and in all.

    `year` is a Dataset of `sd.year`, or what `sd.year` makes one of, with its own arguments (`place`, `shift`,
    `compat`, `patches` ...). `sky_`, `sun_` and `reflected_` before the name are the parts, `local_time` is a
    coordinate. Views of `planes` among their surroundings are found once. The ground, and what has no faces of
    its own, reflects `albedo` of the open horizontal light. Irradiance is the paper's (Perez et al. 1993): the same
    distribution with the level of the measured diffuse irradiance, and the direct irradiance measured. `transposition`
    takes the diffuse light of planes in the open from another model: "isotropic", "hay-davies", "perez-1990",
    "perez-driesse". Missing hours are NaN. ValueError for an albedo outside [0, 1], no planes, or a model that does not
    know obstructions where there are some.

    >>> import pandas as pd, skydome as sd
    >>> times = pd.date_range("2026-06-21T06:00", periods=12, freq="h", tz="UTC")
    >>> frame = pd.DataFrame({"dni": 600.0, "dhi": 110.0}, index=times)
    >>> light = on_planes(frame, [Plane(0.0), Plane(30 * deg)], place=sd.Place(45.07, 7.69))
    >>> light.irradiance.shape, bool(np.allclose(light.sky_irradiance[:, 0], 110.0, rtol=1e-5))
    ((12, 2), True)
    """
    required("xarray", "year", "a year on planes")
    require_kind(planes, Plane | list | tuple, "planes", "[Plane(30 * deg)]")
    planes = [planes] if isinstance(planes, Plane) else list(planes)
    model = transposition_named(transposition)
    check(planes, albedo, model)
    import xarray

    skies = year if isinstance(year, xarray.Dataset) else year_of(year, **({"patches": FINE} | reading))
    known = Coefficients.of(planes, patches_named(skies.attrs["patches"]), albedo)
    return on_known(skies, planes, known, albedo, model)


def check(planes: Sequence[Plane], albedo: float, model: Transposition) -> None:
    """ValueError or TypeError, before any work, for what cannot be."""
    if not planes:
        raise ValueError("planes must hold at least one Plane, got none")
    for plane in planes:
        if not isinstance(plane, Plane):
            raise TypeError(f"planes must be Plane(tilt, azimuth), got {type(plane).__name__}")
        if not model.obstructions and not isinstance(plane.surroundings, Open):
            raise ValueError(
                f"transposition {model.name!r} knows open planes only; use 'perez-1993' among obstructions"
            )
    require("albedo", albedo, SHARE)
    require_one("albedo", albedo)


def suns_of(skies: "xarray.Dataset") -> np.ndarray:
    """Unit vectors toward the sun, (T, 3)."""
    toward: np.ndarray = direction(skies["sun_azimuth"].values * deg, skies["sun_elevation"].values * deg)
    return toward


def distances_of(times: np.ndarray) -> np.ndarray:
    """Distance to the sun, AU, at the midnight before each time, (T,)."""
    days, which = np.unique(times.astype("datetime64[D]"), return_inverse=True)
    found: np.ndarray = np.asarray(earth_sun_distance(days))[which] if len(days) else np.zeros(0)
    return found


def on_known(
    skies: "xarray.Dataset", planes: Sequence[Plane], known: Coefficients, albedo: float, model: Transposition
) -> "xarray.Dataset":
    """The Dataset of the light on planes whose coefficients are known, of whichever site."""
    import xarray

    lit = np.flatnonzero((skies["lit_share"].values > 0) & np.isfinite(skies["diffuse_horizontal_irradiance"].values))
    suns, distance = suns_of(skies)[lit], distances_of(skies["time"].values[lit])
    series = {name: skies[name].values[lit] for name in SERIES}
    hours = Hours(
        suns,
        series["direct_normal_irradiance"],
        series["diffuse_horizontal_irradiance"],
        SOLAR_CONSTANT / distance**2,
        skies["luminance"].values[lit],
        series["diffuse_horizontal_illuminance"],
    )
    shares = shares_of(hours, known, model, planes, radius_at(distance))
    missing = ~np.isfinite(skies["diffuse_horizontal_irradiance"].values)
    variables: dict[str, Any] = {}
    for name, unit in QUANTITIES.items():
        direct, diffuse = (series[f"{part}_{name}"][:, None] for part in ("direct_normal", "diffuse_horizontal"))
        parts = received(direct, diffuse, shares, suns)
        for part, text in PARTS.items():
            values = sum(parts.values()) if not part else parts[part]
            every = np.zeros((skies.sizes["time"], len(planes)))
            every[lit], every[missing] = values, np.nan
            about = {"units": unit, "long_name": f"{name} {text}"}
            variables[f"{part}_{name}".lstrip("_")] = (("time", "plane"), every, about)
    variables["status"] = skies["status"].variable
    return xarray.Dataset(variables, coordinates(skies, planes, known), attributes(skies, albedo, model))


SERIES = tuple(f"{part}_{name}" for part in ("direct_normal", "diffuse_horizontal") for name in QUANTITIES)


def shares_of(
    hours: Hours, known: Coefficients, model: Transposition, planes: Sequence[Plane], radii: np.ndarray
) -> dict[str, np.ndarray]:
    """Light on the planes over horizontal diffuse light, or over direct normal light, by its way, (K, P) each."""
    normals = np.stack([plane.normal for plane in planes])
    by_faces = np.zeros((1, len(planes)))
    if known.scenes:
        by_faces = FromPatches().shares(hours, normals, known.reflected)
    direct, direct_by_faces = known.of_suns(hours.suns, radii)
    shares = {"sky": model.shares(hours, normals, known.weights), "sky by faces": by_faces}
    return shares | {"sun": direct, "sun by faces": direct_by_faces, "ground": known.ground[None, :]}


def received(
    direct: np.ndarray, diffuse: np.ndarray, shares: dict[str, np.ndarray], suns: np.ndarray
) -> dict[str, np.ndarray]:
    """The parts of the light (K, P) from direct normal and diffuse horizontal light (K, 1)."""
    everywhere = diffuse + direct * np.maximum(suns[:, 2:], 0)
    by_faces = shares["sky by faces"] * diffuse + shares["sun by faces"] * direct
    return {
        "sky": shares["sky"] * diffuse,
        "sun": shares["sun"] * direct,
        "reflected": by_faces + shares["ground"] * everywhere,
    }


def coordinates(skies: "xarray.Dataset", planes: Sequence[Plane], known: Coefficients) -> dict[str, Any]:
    """The times, and the planes by their labels."""
    shared = {name: skies.coords[name].variable for name in ("time", "local_time", "sun_time", "interval_hours")}
    of_plane = {
        "tilt": ([plane.tilt / deg for plane in planes], "degree", "tilt from level"),
        "surface_azimuth": ([plane.azimuth / deg for plane in planes], "degree", "azimuth it faces, from north"),
        "sky_view_factor": ([each.view.sky_view_factor for each in known.planes], "1", "share of a uniform sky"),
    }
    return (
        shared
        | {"plane": labels_of(planes)}
        | {
            name: ("plane", values, {"units": unit, "long_name": text})
            for name, (values, unit, text) in of_plane.items()
        }
    )


def attributes(skies: "xarray.Dataset", albedo: float, model: Transposition) -> dict[str, Any]:
    """What the year says of itself, and what was asked for."""
    kept = {name: value for name, value in skies.attrs.items() if name not in ("title", "frame", "model")}
    title = skies.attrs["title"].replace("A year of skies", "A year on planes")
    return {"title": title} | kept | {"albedo": albedo, "transposition": model.name}
