"""`skydome illuminance --weather`: the light on planes through a year."""

import warnings
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Annotated, Any

from typer import Option

from skydome.cli.doors import progress, refuse_idle, require_output
from skydome.cli.many_sites.planes import planes_of_sites
from skydome.cli.many_sites.table import is_sites
from skydome.cli.options import SkyOptions, numbers
from skydome.cli.quantities import minutes
from skydome.cli.sums_of_planes import facts_of
from skydome.ground.extras import required

PANEL = "A year on planes, from a weather file"
ENDINGS = {".csv": "xarray", ".nc": "h5netcdf", ".zarr": "zarr"}
"""Endings of the file to write, and the library that each needs."""

STREET, SPOT = "10,12,45 (height,width in m,azimuth along it)", "0,1.5 (m across from its middle, m above its floor)"


@dataclass(frozen=True)
class YearOptions:
    """A year's weather, and what stands around the planes; None: not given."""

    weather: Annotated[
        Path | None, Option(help="EPW, WEA, TMY3, TM2, NSRDB, SAM or PVGIS file.", rich_help_panel=PANEL)
    ] = None
    output: Annotated[
        Path | None, Option("--output", "-o", help="Every hour: planes.csv, .nc or .zarr.", rich_help_panel=PANEL)
    ] = None
    transposition: Annotated[
        str,
        Option(
            metavar="NAME",
            help="perez-1993 (ours), isotropic, hay-davies, perez-1990, perez-driesse.",
            rich_help_panel=PANEL,
        ),
    ] = "perez-1993"
    patches: Annotated[
        str | None,
        Option(
            help="tregenza, reinhart:N or equal-area:N; else reinhart:4, of sites.csv tregenza.", rich_help_panel=PANEL
        ),
    ] = None
    shift: Annotated[
        str | None,
        Option(
            metavar="auto|MINUTES", help="Move the irradiances later, so that they fit the sun.", rich_help_panel=PANEL
        ),
    ] = None
    utc_offset: Annotated[
        float,
        Option(metavar="HOURS", help="Hours east of UTC, for a table that tells of no site.", rich_help_panel=PANEL),
    ] = 0.0
    canyon: Annotated[
        str | None,
        Option(metavar="H,W,AZ", help="A street's height and width, m, and azimuth.", rich_help_panel=PANEL),
    ] = None
    at: Annotated[
        str, Option(metavar="X,Z", help="Where in the street, m across from its middle and up.", rich_help_panel=PANEL)
    ] = "0,0"
    walls: Annotated[
        float, Option(help="Reflectance of the street's walls; its floor has --ground.", rich_help_panel=PANEL)
    ] = 0.3
    mesh: Annotated[Path | None, Option(help="Triangles around (OBJ, PLY, STL), m, z up.", rich_help_panel=PANEL)] = (
        None
    )
    point: Annotated[
        list[str] | None,
        Option(
            metavar="X,Y,Z", help="Where in the mesh, m; one for each plane, or one for all.", rich_help_panel=PANEL
        ),
    ] = None
    reflectance: Annotated[float, Option(help="Reflectance of the mesh.", rich_help_panel=PANEL)] = 0.3
    weather_folder: Annotated[
        Path | None, Option(help="Where the files of --weather sites.csv (name,file) lie.", rich_help_panel=PANEL)
    ] = None
    scheduler: Annotated[
        str | None, Option(metavar="ADDRESS", help="A Dask scheduler, for sites.csv.", rich_help_panel=PANEL)
    ] = None
    workers: Annotated[int, Option(help="Worker processes here, without a scheduler.", rich_help_panel=PANEL)] = 2
    target: Annotated[float, Option(help="lx that autonomies of sites.csv are of.", rich_help_panel=PANEL)] = 1e4


def year_on_planes(
    options: SkyOptions, asked: YearOptions, planes: list[str], horizon: Path | None, ground: float
) -> dict[str, Any]:
    """The facts of a year on planes; ValueError or OSError, before any work, for what cannot be."""
    import skydome as sd
    from skydome.years.planes.light import FINE
    from skydome.years.planes.table import write_table
    from skydome.years.stores.stores import write_dataset
    from skydome.years.weather.reading import read_weather

    refuse_a_moment(options)
    require_output(asked.output, "-o", tuple(ENDINGS), asked.weather)
    required("xarray", "year", "a year on planes")
    if asked.output is not None:
        required(ENDINGS[asked.output.suffix.lower()], "year", f"a year as {asked.output.suffix}")
    known = planes_of(asked, planes, horizon, ground)
    if refuse_other_kinds(asked, options):
        return planes_of_sites(asked, known, ground)
    shift: Any = minutes(asked.shift)
    place = None if options.place is None else sd.Place.parse(options.place)
    with warnings.catch_warnings(record=True) as caught, progress("a year on planes"):
        warnings.simplefilter("always", UserWarning)
        given = read_weather(asked.weather or "", shift=shift, place=place, utc_offset=asked.utc_offset)
        light = sd.on_planes(given, known, ground, asked.transposition, patches=asked.patches or FINE)
        if asked.output is not None:
            write = write_table if asked.output.suffix.lower() == ".csv" else write_dataset
            write(light, asked.output)
    notes = [str(warning.message) for warning in caught if warning.category is UserWarning]
    files = [] if asked.output is None else [str(asked.output)]
    return facts_of(light) | {"files": files, "notes": notes}


def refuse_a_moment(options: SkyOptions) -> None:
    """ValueError for options of a single moment beside a year's weather."""
    plain = SkyOptions()
    allowed = {"place", "albedo"}
    for item in fields(SkyOptions):
        if item.name not in allowed and getattr(options, item.name) != getattr(plain, item.name):
            name = item.name.replace("_", "-")
            raise ValueError(f"--{name} is for one moment's sky; a year takes its skies from --weather")


def refuse_other_kinds(asked: YearOptions, options: SkyOptions) -> bool:
    """True for a table of sites; ValueError for options of a street, a mesh or such a table where there is none."""
    sites = asked.weather is not None and is_sites(asked.weather)
    given, plain = asdict(asked) | {"place": options.place}, asdict(YearOptions()) | {"place": None}
    kinds = {
        "without --canyon": (asked.canyon is None, ("at", "walls")),
        "without --mesh": (asked.mesh is None, ("point", "reflectance")),
        "without a table of sites": (not sites, ("weather_folder", "scheduler", "workers", "target")),
        "for a table of sites": (sites, ("place", "shift", "utc_offset")),
    }
    for why, (idle, names) in kinds.items():
        refuse_idle({name: given[name] for name in names if idle}, plain, why)
    return sites


def tilt_and_azimuth(text: str) -> tuple[float, float]:
    """The two angles of --plane, degrees; ValueError for what is no plane.

    >>> tilt_and_azimuth("30,-90")
    (30.0, 270.0)
    """
    tilt, azimuth = numbers(text, 2, "--plane", "30,180 (tilt,azimuth in degrees)")
    if not 0 <= tilt <= 180:
        raise ValueError(f"the tilt of --plane must lie in [0, 180] degrees, got {tilt:g}")
    return tilt, azimuth % 360


def planes_of(asked: YearOptions, planes: list[str], horizon: Path | None, ground: float) -> list[Any]:
    """The planes among what stands around them; ValueError for two kinds of surroundings."""
    import skydome as sd

    given = [
        name for name, value in (("--horizon", horizon), ("--canyon", asked.canyon), ("--mesh", asked.mesh)) if value
    ]
    if len(given) > 1:
        raise ValueError(f"planes stand in one kind of surroundings, got {' and '.join(given)}")
    tilted = [(tilt * sd.deg, turn * sd.deg) for tilt, turn in map(tilt_and_azimuth, planes)]
    if asked.mesh is not None:
        return in_mesh(asked, tilted, ground)
    if horizon is not None:
        around = sd.Horizon.read(horizon)
        return [sd.Plane(tilt, turn, around) for tilt, turn in tilted]
    if asked.canyon is not None:
        height, width, along = numbers(asked.canyon, 3, "--canyon", STREET)
        street = sd.StreetCanyon(height, width, along % 360 * sd.deg, ground, asked.walls)
        spot = street.at(*numbers(asked.at, 2, "--at", SPOT))
        return [sd.Plane(tilt, turn, spot) for tilt, turn in tilted]
    return [sd.Plane(tilt, turn) for tilt, turn in tilted]


def in_mesh(asked: YearOptions, tilted: list[tuple[float, float]], ground: float) -> list[Any]:
    """Planes at points of a mesh: one point for all, or as many as planes; one plane may stand at many points."""
    import skydome as sd

    points = [numbers(text, 3, "--point", "1.5,2,0.85 (m)") for text in asked.point or []]
    if not points:
        raise ValueError("--mesh needs --point X,Y,Z, where the plane is")
    if len(tilted) == 1:
        tilted = tilted * len(points)
    if len(points) == 1:
        points = points * len(tilted)
    if len(points) != len(tilted):
        raise ValueError(f"give one --point for all planes or one for each, got {len(points)} for {len(tilted)} planes")
    scene = sd.MeshScene.read(asked.mesh or "", asked.reflectance, ground_albedo=ground)
    made = []
    for point, (tilt, turn) in zip(points, tilted, strict=True):
        normal = sd.direction(turn, 90 * sd.deg - tilt)
        name = f"{tilt / sd.deg:g},{turn / sd.deg:g} at {','.join(f'{value:g}' for value in point)}"
        made.append(sd.Plane(tilt, turn, scene.at(point, normal), name))
    return made
