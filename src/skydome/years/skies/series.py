"""A year of skies on the dome's patches, as an xarray Dataset: `year("site.epw")`."""

from os import PathLike
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.patches import Patches
from skydome.dome.patches import patches as patches_named
from skydome.ground.arguments import require_word
from skydome.ground.directions import azimuth, zenith_angle
from skydome.ground.extras import required
from skydome.ground.limits.sizes import require_memory
from skydome.ground.units import RADIANCE_EFFICACY, deg
from skydome.sun.place import Place
from skydome.sun.track import SunTrack
from skydome.years.heat_map import register_plot
from skydome.years.skies import status as flags
from skydome.years.skies.colour_year import Weathered, add_colour, add_spectrum
from skydome.years.skies.dome_means import dome_means
from skydome.years.skies.perez_year import PerezYear, neighbours, perez_year
from skydome.years.skies.twilight import with_twilight
from skydome.years.weather.calendar import Label
from skydome.years.weather.closure import aligned, facts_of
from skydome.years.weather.frame import is_frame
from skydome.years.weather.plausibility import warn_of_wrong_place
from skydome.years.weather.reading import as_written
from skydome.years.weather.weather import Weather

if TYPE_CHECKING:
    import pandas as pd
    import xarray

Compat = Literal["paper", "gendaylit", "gendaymtx"]
COMPATS = ("paper", "gendaylit", "gendaymtx")
LOCAL = "middle of the interval, standard time of the site, {:+g} h from UTC"


def year(
    weather: "Weather | str | PathLike[str] | pd.DataFrame",
    patches: "str | Patches" = "tregenza",
    compat: Compat = "paper",
    smooth: bool = False,
    colour: str | None = None,
    wavelengths: ArrayLike | None = None,
    turbidity: ArrayLike = 3.0,
    clouds: ArrayLike | None = None,
    calendar_year: int | None = None,
    track: SunTrack | None = None,
    label: Label | None = None,
    shift: "float | Literal['auto'] | None" = None,
    place: Place | None = None,
) -> "xarray.Dataset":
    """The skies of a year: luminance (time, patch), cd m-2, float32, with sun, illuminances and status by the interval.

    `weather` is a file that `read_weather` knows, a `Weather`, or a DataFrame of a `place` as `Weather.from_frame`
    takes it; `label`, `shift` and `place` are as there. `time` is UTC, `local_time` the site's standard time:
    `skies.groupby("local_time.month")`. Patches hold true means, levelled so that together they give the diffuse
    illuminance: `luminance @ horizontal_solid_angle`. The sun is not in them: it is `direct_normal_illuminance`
    from the sun's direction, in patch `sun_patch`. `compat`: "paper" (Perez 1990 and 1993, true sun), "gendaylit"
    (its limits), "gendaymtx" (all of its rules; Reinhart's patches). `smooth` blends neighbouring clearness bins
    (ours). `colour` (a clear spectral model by name, for `turbidity`) adds `xyz` (time, patch, channel) and the
    diffuse colour temperature; with `wavelengths` (W,), nm, also `radiance` (time, patch, wavelength), melanopic
    EDI and PAR of the diffuse horizontal light: the chromaticity or spectrum of that clear sky and of overcast
    light, mixed by the share of `clouds` (estimated from the direct light if None; 0-1), at Perez's luminance. The
    colour "physical" also lights twilight, down to a sun of -18 degrees, by its own luminance (flagged "twilight").

    >>> import pandas as pd, skydome as sd
    >>> times = pd.date_range("2026-06-21T06:00", periods=12, freq="h", tz="UTC")
    >>> frame = pd.DataFrame({"dni": 600.0, "dhi": 110.0}, index=times)
    >>> skies = year(frame, place=sd.Place(45.07, 7.69))
    >>> skies.luminance.shape
    (12, 145)
    >>> bool(np.allclose(skies.luminance @ skies.horizontal_solid_angle, skies.diffuse_horizontal_illuminance))
    True
    """
    required("xarray", "year", "a year of skies")
    require_word(compat, COMPATS, "compat")
    weather, track = under_its_sun(weather, calendar_year, track, label, shift, place)
    cut = patches_named(patches)
    each = 8 + 16 * (colour is not None) + 8 * (0 if wavelengths is None else np.size(wavelengths))
    require_memory(float(weather.count) * cut.count * each, f"a year of {weather.count} hours, {cut.count} patches")
    sky = perez_year(weather, "gendaylit" if compat == "gendaylit" else "paper", track)
    warn_of_wrong_place(weather, sky.share)
    luminance = luminance_of(weather, sky, cut, compat, smooth)
    data = dataset(weather, sky, cut, luminance)
    data.attrs |= facts_of(weather, track)
    data.attrs |= {"compat": compat, "smooth": int(smooth), "model": "Perez all-weather 1993"}
    if compat == "gendaymtx":
        data["diffuse_horizontal_illuminance"].values[:] = luminance @ cut.horizontal_solid_angles
    if colour is not None:
        air = Weathered.of(sky, weather.count, turbidity, clouds)
        sky, air = with_twilight(data, sky, cut, colour, air, turbidity)
        add_colour(data, sky, cut, colour, air)
        if wavelengths is not None:
            add_spectrum(data, sky, cut, colour, air, wavelengths)
    elif wavelengths is not None:
        raise ValueError('wavelengths need a colour, such as "preetham" or "hosek-wilkie"')
    return data


def under_its_sun(
    weather: "Weather | str | PathLike[str] | pd.DataFrame",
    calendar_year: int | None,
    track: SunTrack | None,
    label: Label | None,
    shift: "float | Literal['auto'] | None",
    place: Place | None,
) -> tuple[Weather, SunTrack]:
    """The weather of a file or a DataFrame, or as given, moved as `shift` says, and the sun's track."""
    if isinstance(weather, Weather):
        weather = weather if label is None else weather.labelled(label)
        track = track or SunTrack.over(weather.start[0], weather.end[-1])
        return (weather if shift is None else aligned(weather, shift, track)), track
    weather = read(weather, calendar_year, label, place)
    track = track or SunTrack.over(weather.start[0], weather.end[-1])
    return aligned(weather, shift, track), track


def luminance_of(weather: Weather, sky: PerezYear, cut: Patches, compat: Compat, smooth: bool) -> np.ndarray:
    """Luminance (T, N), cd m-2, float32, by the rules asked for; a black sky that sends light is uniform, and told."""
    luminance = np.zeros((weather.count, cut.count), np.float32)
    if compat == "gendaymtx":
        luminance = gendaymtx_luminance(weather, cut)
    elif smooth:
        smooth_luminance(sky, cut, luminance)
    else:
        dome_means(sky.skies, sky.diffuse, cut, rows=sky.lit, out=luminance)
    black = sky.lit[~luminance[sky.lit].any(axis=1) & (sky.diffuse > 0)]
    luminance[black] = sky.diffuse[np.searchsorted(sky.lit, black), None] / np.pi
    sky.status[black] |= flags.BITS["uniform"]
    luminance[weather.missing] = np.nan
    return luminance


def read(
    source: "str | PathLike[str] | pd.DataFrame", calendar_year: int | None, label: Label | None, place: Place | None
) -> Weather:
    """The weather of a file or a DataFrame; ValueError for a DataFrame of no place."""
    if not is_frame(source):
        return as_written(source, calendar_year, label, place)
    if place is None:
        raise ValueError("a DataFrame tells of no place: give place=sd.Place(latitude, longitude, altitude)")
    return Weather.from_frame(source, place, label=label or "end")


def smooth_luminance(sky: PerezYear, cut: Patches, out: np.ndarray) -> None:
    """Write the blend of the skies of the neighbouring bins, each levelled, into `out` (T, N)."""
    low, high, weight = neighbours(sky, zenith_angle(sky.skies.suns))
    below = dome_means(low, sky.diffuse * (1 - weight), cut)
    out[sky.lit] = below + dome_means(high, sky.diffuse * weight, cut)


def gendaymtx_luminance(weather: Weather, cut: Patches) -> np.ndarray:
    """Luminance (T, N) by gendaymtx's rules; ValueError for patches that it does not know."""
    from skydome.years.gendaymtx.hours import tape_from
    from skydome.years.gendaymtx.matrix import matrix

    division = round(((cut.count - 1) / 144) ** 0.5)
    if cut.name not in ("tregenza", f"reinhart:{division}"):
        raise ValueError(f'compat="gendaymtx" needs Reinhart\'s patches, got {cut.name}')
    return np.ascontiguousarray(matrix(tape_from(weather), division)[1:].T) * np.float32(RADIANCE_EFFICACY)


def dataset(weather: Weather, sky: PerezYear, cut: Patches, luminance: np.ndarray) -> "xarray.Dataset":
    """The Dataset of luminances with its coordinates, the sun, the illuminances and the flags."""
    import xarray

    state = sky.status.copy()
    cut_off = (luminance[sky.lit] == 0).any(axis=1) & (sky.diffuse > 0)
    state[sky.lit[cut_off]] |= flags.BITS["cut_off"]
    variables: dict[str, Any] = {
        name: (("time", "patch") if value.ndim == 2 else ("time",), value, {"units": unit, "long_name": text})
        for name, (value, unit, text) in columns_of(weather, sky, cut, luminance).items()
    }
    variables["status"] = (("time",), state, flags.attributes())
    place = weather.place
    about = {
        "title": f"A year of skies{weather.where}",
        "latitude": place.latitude,
        "longitude": place.longitude,
        "altitude": place.altitude,
        "utc_offset": weather.utc_offset,
        "patches": cut.name,
        "frame": "azimuth clockwise from north; patches in Radiance's order without the ground",
    }
    register_plot()
    return xarray.Dataset(variables, coordinates(weather, sky, cut), about)


def columns_of(
    weather: Weather, sky: PerezYear, cut: Patches, luminance: np.ndarray
) -> dict[str, tuple[np.ndarray, str, str]]:
    """The Dataset's variables: values (T,) or (T, N), unit, and what they are."""

    def at_lit(values: np.ndarray) -> np.ndarray:
        every = np.zeros(weather.count)
        every[sky.lit] = values
        return np.where(weather.missing, np.nan, every)

    direct, diffuse = (np.where(weather.missing, np.nan, value) for value in weather.irradiances)
    turn = azimuth(sky.suns) / deg
    return {
        "luminance": (luminance, "cd m-2", "mean luminance of the patch, without the sun's disc"),
        "sun_azimuth": (turn, "degree", "azimuth of the sun, clockwise from north"),
        "sun_elevation": (90 - zenith_angle(sky.suns) / deg, "degree", "true elevation of the sun"),
        "sun_patch": (cut.index(sky.suns).astype(np.int32), "1", "patch in which the sun stands, -1 below the horizon"),
        "lit_share": (sky.share, "1", "share of the interval in which the sun is up"),
        "direct_normal_irradiance": (direct, "W m-2", "direct normal irradiance, given or found from light"),
        "diffuse_horizontal_irradiance": (diffuse, "W m-2", "diffuse horizontal irradiance, given or found from light"),
        "direct_normal_illuminance": (at_lit(sky.direct), "lx", "illuminance of the sun on a plane facing it"),
        "diffuse_horizontal_illuminance": (at_lit(sky.diffuse), "lx", "diffuse horizontal illuminance"),
        "clearness": (at_lit(sky.clearness), "1", "Perez's sky clearness"),
        "brightness": (at_lit(sky.brightness), "1", "Perez's sky brightness"),
    }


def coordinates(weather: Weather, sky: PerezYear, cut: Patches) -> dict[str, Any]:
    """The middle of each interval (UTC) and the instant the sun is taken at; the patches' places and sizes."""

    def of_patch(values: np.ndarray, unit: str, text: str) -> tuple[str, np.ndarray, dict[str, str]]:
        return "patch", values, {"units": unit, "long_name": text}

    length = (weather.end - weather.start).astype(np.float64) / 3600
    return {
        "time": ("time", weather.middle.astype("datetime64[ns]"), {"long_name": "middle of the interval, UTC"}),
        "local_time": ("time", weather.local.astype("datetime64[ns]"), {"long_name": LOCAL.format(weather.utc_offset)}),
        "interval_hours": ("time", length, {"units": "h", "long_name": "length of the interval"}),
        "sun_time": ("time", sky.times.astype("datetime64[ns]"), {"long_name": "instant of the sun's place, UTC"}),
        "patch": ("patch", np.arange(cut.count, dtype=np.int32)),
        "patch_azimuth": of_patch(cut.azimuths / deg, "degree", "azimuth of the centre"),
        "patch_elevation": of_patch(cut.elevations / deg, "degree", "elevation of the centre"),
        "solid_angle": of_patch(cut.solid_angles, "sr", "solid angle"),
        "horizontal_solid_angle": of_patch(cut.horizontal_solid_angles, "sr", "integral of the sine of elevation"),
    }
