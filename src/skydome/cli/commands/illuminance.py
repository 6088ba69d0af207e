"""`skydome illuminance`: the light on a plane, tilted or not, under an open or an obstructed sky."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from typer import Option

from skydome.cli.commands.planes_of_year import YearOptions, tilt_and_azimuth, year_on_planes
from skydome.cli.doors import progress, refuse_idle
from skydome.cli.numbers_of_light import amount, lit_by, moment_facts, notes_row, outside_ranges, sky_rows
from skydome.cli.options import AsJson, SkyOptions, taking
from skydome.cli.printing import show
from skydome.cli.scene import Scene, scene_of
from skydome.cli.sums_of_planes import year_rows

Planes = Annotated[
    list[str] | None,
    Option(
        "--plane",
        metavar="TILT,AZ",
        help="Tilt from level, 0-180, and azimuth it faces, degrees: 90,180 is a south wall; many with --weather. "
        "[default: 0,180]",
    ),
]
Profile = Annotated[
    Path | None, Option(metavar="FILE.csv", help="The horizon: rows of azimuth,elevation in degrees, north 0, east 90.")
]
Ground = Annotated[float | None, Option(help="Reflectance of ground and hills, 0-1. [default: --albedo, or 0.2]")]
InColour = Annotated[
    str | None,
    Option("--light", metavar="xyz|rgb|NM,NM", help="Tell the light in colour too, or at these wavelengths, nm."),
]
Bands = Annotated[int, Option(help="Bands to cut the sky into, at least; more are laid where the horizon asks.")]
LEAST_BANDS = 64


@taking(SkyOptions, YearOptions)
def illuminance(
    options: SkyOptions,
    of_year: YearOptions,
    plane: Planes = None,
    horizon: Profile = None,
    ground: Ground = None,
    bands: Bands = LEAST_BANDS,
    light: InColour = None,
    as_json: AsJson = False,
) -> None:
    """Print the illuminance on a plane: from sky, sun and ground; or that of a year on planes."""
    planes = plane or ["0,180"]
    if of_year.weather is not None:
        refuse_idle({"bands": bands, "light": light}, {"bands": LEAST_BANDS, "light": None}, "of a year of --weather")
        facts = year_on_planes(options, of_year, planes, horizon, ground_of(ground, options))
        show(facts, year_rows(facts), as_json)
        if facts.get("failed"):
            raise ValueError(f"{facts['failed']} of the sites could not be done; see the notes")
        return
    if of_year != YearOptions() or len(planes) > 1:
        raise ValueError("more than one plane, and options of a year, need --weather FILE")
    asked = Asked.of(planes[0], horizon, ground, bands, light, options)
    with progress("adding up the light"):
        facts = plane_facts(scene_of(options, any_hour=True), asked)
    show(facts, plane_rows(facts), as_json)


def ground_of(ground: float | None, options: SkyOptions) -> float:
    """The reflectance of the ground; ValueError outside [0, 1]."""
    albedo = next((value for value in (ground, options.albedo) if value is not None), 0.2)
    if not 0 <= albedo <= 1:
        raise ValueError(f"--ground must lie in [0, 1], got {albedo:g}")
    return albedo


@dataclass(frozen=True)
class Asked:
    """The plane and what stands around it: tilt and azimuth in degrees, the surroundings, the ground's albedo."""

    tilt: float
    azimuth: float
    surroundings: Any
    profile: str | None
    albedo: float
    bands: int
    light: "InKind | None"

    @classmethod
    def of(
        cls, plane: str, profile: Path | None, ground: float | None, bands: int, light: str | None, options: SkyOptions
    ) -> "Asked":
        """The options read; ValueError or OSError, before any work, for what cannot be."""
        from skydome.surroundings.horizon import Horizon
        from skydome.surroundings.intervals import Open

        tilt, azimuth = tilt_and_azimuth(plane)
        if not 1 <= bands <= 4096:
            raise ValueError(f"--bands must lie in [1, 4096], got {bands}")
        albedo = ground_of(ground, options)
        around = Open() if profile is None else Horizon.read(profile)
        name = None if profile is None else str(profile)
        kind = None if light is None else InKind.of(light)
        return cls(tilt, azimuth, around, name, albedo, bands, kind)

    @property
    def normal(self) -> Any:
        """The plane's normal, (3,)."""
        import skydome as sd

        return sd.direction(azimuth=self.azimuth % 360 * sd.deg, elevation=(90 - self.tilt) * sd.deg)


@dataclass(frozen=True)
class InKind:
    """What --light asks for: the kind of light, its fact's name with the unit, and its channels' names."""

    kind: Any
    fact: str
    channels: list[str]

    @classmethod
    def of(cls, text: str) -> "InKind":
        """The words xyz or rgb, or wavelengths; ValueError for anything else."""
        import skydome as sd

        if text in ("xyz", "rgb"):
            kind = sd.LightInXYZ() if text == "xyz" else sd.LightInRGB()
            return cls(kind, f"{text}_lx", list(text))
        try:
            waves = [float(word) for word in text.split(",")]
        except ValueError:
            raise ValueError(f"--light must be xyz, rgb or wavelengths such as 450,550,650, got {text!r}") from None
        return cls(sd.LightInWavelengths(waves), "irradiance_w_m2_nm", [f"{wave:g} nm" for wave in waves])

    def facts(self, received: Any) -> dict[str, Any]:
        """The parts of the light by channel."""
        import numpy as np

        parts = {name: getattr(received, name) for name in ("sky", "sun", "reflected", "total")}
        lists = {name: [float(value) for value in np.asarray(part)] for name, part in parts.items()}
        return {self.fact: lists | {"channels": self.channels}}


def plane_facts(scene: Scene, asked: Asked) -> dict[str, Any]:
    """The light on the plane with its unit in the name; numbers, lists and strings only."""
    import skydome as sd

    view = sd.PlaneView.of(asked.surroundings, asked.normal, asked.bands)
    light = view.receive(scene.whole, albedo=asked.albedo)
    parts = {"sky": light.sky, "sun": light.sun, "reflected": light.reflected, "total": light.total}
    coloured = {}
    if asked.light is not None:
        coloured = asked.light.facts(view.receive(scene.whole, albedo=asked.albedo, light=asked.light.kind))
    return {
        **moment_facts(scene),
        "model": scene.name,
        "parameters": scene.whole.parameters(),
        "valid": bool(scene.sky.valid),
        "outside_ranges": outside_ranges(scene.whole),
        "plane": {"tilt_deg": asked.tilt, "azimuth_deg": asked.azimuth},
        "horizon": asked.profile,
        "ground_albedo": asked.albedo,
        "sky_view_factor": view.sky_view_factor,
        "illuminance_lx": {name: float(value) for name, value in parts.items()},
        **coloured,
        "unobstructed_lx": float(sd.illuminance(scene.whole, asked.normal, ground_albedo=asked.albedo)),
        "notes": list(scene.notes),
    }


def plane_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    light, plane = facts["illuminance_lx"], facts["plane"]
    rows = sky_rows(facts) | {
        "plane": f"tilt {plane['tilt_deg']:g}°, facing {plane['azimuth_deg']:g}°",
        "sky view factor": f"{facts['sky_view_factor']:.4f}",
        "from the sky": f"{amount(light['sky'])} lx",
        f"from the {lit_by(facts)}": f"{amount(light['sun'])} lx",
        "reflected": f"{amount(light['reflected'])} lx (albedo {facts['ground_albedo']:g})",
        "total": f"{amount(light['total'])} lx",
    }
    for name in ("xyz_lx", "rgb_lx", "irradiance_w_m2_nm"):
        if name in facts:
            pairs = zip(facts[name]["channels"], facts[name]["total"], strict=True)
            rows["total by channel"] = ", ".join(f"{channel} {value:.5g}" for channel, value in pairs)
    if facts["horizon"] is not None:
        rows["without the horizon"] = f"{amount(facts['unobstructed_lx'])} lx"
    return rows | notes_row(facts["notes"])
