"""`skydome daylight`: daylight metrics of a room, from a weather file and coefficients, or triangles and points."""

import warnings
from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.doors import progress, refuse_idle, require_output
from skydome.cli.options import AsJson, numbers
from skydome.cli.printing import show
from skydome.cli.quantities import minutes
from skydome.ground.extras import required


def daylight(
    weather: Annotated[Path, Argument(help="EPW, WEA, TMY3, TM2, NSRDB, SAM or PVGIS file.")],
    coefficients: Annotated[Path | None, Option(help="Daylight coefficients of points (rfluxmtx, .mtx).")] = None,
    direct: Annotated[Path | None, Option(help="The same without reflections: with --suns, five phases.")] = None,
    suns: Annotated[Path | None, Option(help="Coefficients of suns in a finer sky's patches.")] = None,
    mesh: Annotated[Path | None, Option(help="The room's triangles (OBJ, PLY, STL), m, z up, fronts inside.")] = None,
    points: Annotated[Path | None, Option(help="Sensors in it: lines x y z nx ny nz.")] = None,
    reflectance: Annotated[float, Option(help="Of the triangles.")] = 0.5,
    transmittance: Annotated[float, Option(help="Of the glazing, by which all light of --mesh is multiplied.")] = 1.0,
    ground: Annotated[float, Option(help="Reflectance of the ground outside.")] = 0.2,
    target: Annotated[float, Option(help="lx, of daylight autonomy.")] = 300.0,
    hours: Annotated[str, Option(metavar="FROM,TO", help="Working hours, local standard time.")] = "8,18",
    shift: Annotated[
        str | None, Option(metavar="auto|MINUTES", help="Move the irradiances later, so that they fit the sun.")
    ] = None,
    output: Annotated[Path | None, Option("--output", "-o", help="Metrics by point: points.csv.")] = None,
    as_json: AsJson = False,
) -> None:
    """Print daylight autonomy, useful illuminance, sDA, ASE and EN 17037's provision of points in a room."""
    from skydome.years.metrics.signed import metrics_of, write_points
    from skydome.years.weather.reading import read_weather

    of_mesh = {"points": points, "reflectance": reflectance, "transmittance": transmittance}
    require_one_way(coefficients, {"direct": direct, "suns": suns}, mesh, of_mesh)
    if not 0 < transmittance <= 1 or not 0 <= ground <= 1 or not target > 0:
        raise ValueError(
            "--transmittance must lie in (0, 1], --ground in [0, 1], --target above 0, "
            f"got {transmittance:g}, {ground:g} and {target:g}"
        )
    first, last = numbers(hours, 2, "--hours", "8,18")
    require_output(output, "-o", (".csv",), weather)
    required("xarray", "year", "a year of daylight")
    moved: Any = minutes(shift)
    with warnings.catch_warnings(record=True) as caught, progress("a year of daylight"):
        warnings.simplefilter("always", UserWarning)
        record = read_weather(weather, shift=moved)
        if coefficients is not None:
            light, skies = from_coefficients(record, coefficients, direct, suns, ground)
        else:
            light, skies = from_mesh(record, mesh, points, reflectance, ground, transmittance)
        facts = {"site": record.name, **metrics_of(light, skies, target, first, last)}
    if output is not None:
        write_points(facts, output)
    facts["files"] = [] if output is None else [str(output)]
    facts["notes"] = [str(warning.message) for warning in caught if warning.category is UserWarning]
    show(facts, rows_of(facts), as_json)


def require_one_way(
    coefficients: Path | None, with_them: dict[str, Any], mesh: Path | None, with_it: dict[str, Any]
) -> None:
    """ValueError unless the room is told in one way, by coefficients or by a mesh, and by the options of that way."""
    if (coefficients is None) == (mesh is None):
        raise ValueError("give either --coefficients total.mtx or --mesh room.obj --points desks.pts")
    if mesh is None:
        refuse_idle(with_it, {"points": None, "reflectance": 0.5, "transmittance": 1.0}, "without --mesh")
    else:
        refuse_idle(with_them, {"direct": None, "suns": None}, "without --coefficients")


def from_coefficients(
    record: Any, total: Path, direct: Path | None, suns: Path | None, ground: float
) -> tuple[Any, Any]:
    """The light of Radiance's coefficients, and the skies."""
    import skydome as sd
    from skydome.years.metrics.coefficients import DaylightCoefficients
    from skydome.years.metrics.signed import RoomLight

    known = DaylightCoefficients.read(total, direct, suns)
    skies = sd.year(record, patches=known.patches)
    sun = None if known.suns is None else known.sunlight(skies)
    return RoomLight(known.illuminance(skies, ground), sun), skies


def from_mesh(
    record: Any, mesh: Path | None, points: Path | None, reflectance: float, ground: float, transmittance: float
) -> tuple[Any, Any]:
    """The light of points in a scene of triangles, and the skies."""
    import skydome as sd
    from skydome.years.metrics.signed import RoomLight, read_points

    if points is None:
        raise ValueError("--mesh needs --points, a file of lines x y z nx ny nz")
    sensors = read_points(points)
    room = sd.MeshScene.read(mesh or "", reflectance, ground_albedo=ground)
    planes = [sd.Plane.facing(row[3:], room.at(row[:3], row[3:])) for row in sensors]
    skies = sd.year(record, patches="reinhart:2")
    light = sd.on_planes(skies, planes, ground)
    parts = (light["illuminance"].values, light["sun_illuminance"].values)
    return RoomLight(*(transmittance * part for part in parts)), skies


def rows_of(facts: dict[str, Any]) -> dict[str, str]:
    """The metrics for people."""
    of_point, code = facts["by_point"], facts["en_17037"]

    def mean(name: str) -> float:
        values: list[float] = of_point[name]
        return sum(values) / len(values)

    rows = {
        "site": facts["site"],
        "points, hours": f"{facts['points']:,}, {facts['working_hours']:,.0f}",
        f"autonomy, {facts['target_lx']:g} lx": f"{mean('daylight_autonomy'):.1%} of the hours, mean of points",
        "continuous": f"{mean('continuous_autonomy'):.1%}",
        "useful illuminance": ", ".join(
            f"{text} {mean(f'useful_{name}'):.1%}"
            for name, text in (
                ("below", "< 100 lx"),
                ("supplementary", "< 300"),
                ("autonomous", "< 3000"),
                ("above", "above"),
            )
        ),
        "sDA300/50%": f"{facts['spatial_daylight_autonomy']:.1%} of the points (IES LM-83; blinds as in the scene)",
    }
    if "annual_sunlight_exposure" in facts:
        rows["ASE1000,250h"] = f"{facts['annual_sunlight_exposure']:.1%} of the points"
    rows["EN 17037"] = (
        f"{code['daylight_provision']}: {code['target_lx']:,.0f} lx on half of the points, "
        f"{code['minimum_lx']:,.0f} lx on 95 %"
    )
    texts = {"files": ", ".join(facts["files"]), "notes": "\n".join(facts["notes"])}
    return rows | {name: text for name, text in texts.items() if text}
