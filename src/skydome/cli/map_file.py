"""The file of a map: what the options ask of it, its writing, and what is said of it."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

if TYPE_CHECKING:
    from skydome.maps.by_rows.map_rows import MapRows
    from skydome.maps.files import Written
    from skydome.maps.targets import Target

Half = Annotated[bool, Option("--half/--float", help="16 bit or 32 bit floats in OpenEXR.")]


def exposure_from(text: str) -> float:
    """A factor per cd m-2, as it is or by a photographer's exposure value at ISO 100: 1 / (1.2 x 2^EV).

    ValueError for anything else. Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 5.1.

    >>> exposure_from("2.5e-5"), round(exposure_from("15EV") * 1e5, 3)
    (2.5e-05, 2.543)
    """
    value = text.strip().lower()
    try:
        factor = 1 / (1.2 * 2.0 ** float(value[:-2])) if value.endswith("ev") else float(value)
    except (ValueError, OverflowError):
        raise ValueError(f"an exposure is a factor per cd m-2 such as 2.5e-5, or 15EV; got {text!r}") from None
    from skydome.ground.limits.ranges import inside
    from skydome.light.tone import EXPOSURE

    if not inside(factor, EXPOSURE):
        raise ValueError(f"an exposure must lie in {EXPOSURE}, which is {exposure_range()}, got {text}")
    return factor


def exposure_range() -> str:
    """What exposures may be, in a photographer's values."""
    from skydome.light.tone import EXPOSURE

    low, high = (exposure_value(end) for end in (EXPOSURE.high, EXPOSURE.low))
    return f"{low:.1f}EV to {high:.1f}EV"


def exposure_value(factor: float) -> float:
    """The exposure value at ISO 100 of a factor per cd m-2.

    >>> round(exposure_value(exposure_from("15EV")), 9)
    15.0
    """
    return -math.log2(1.2 * factor)


Exposure = Annotated[
    float | None,
    Option(
        parser=exposure_from,
        metavar="NUMBER|EV",
        help="Of a picture: a factor per cd m-2, or as 15EV. [default: by its content]",
    ),
]


@dataclass(frozen=True)
class FileOptions:
    """How a map is written. None: not given."""

    target: Annotated[str, Option(help="Renderer whose layout the map has.")] = "native"
    half: Half = False
    white_luminance: Annotated[
        float | None,
        Option(help="cd m-2 of RGB (1, 1, 1) in the file. [default: 1; 100000 in half floats; 179 in .hdr]"),
    ] = None
    scale: Annotated[
        float | None, Option(help="RGB per cd m-2 in the file: 1 / --white-luminance, the other way to say it.")
    ] = None
    exposure: Exposure = None
    night_vision: Annotated[
        bool, Option("--night-vision", help="Of a .png: dark places as the eye sees them, bluish and without colour.")
    ] = False
    gamut: Annotated[
        str,
        Option(
            metavar="white|none", help="Colours outside the RGB space: toward white, luminance kept, or as they are."
        ),
    ] = "white"

    @property
    def choices(self) -> dict[str, Any]:
        """As `EnvironmentMap.save` takes them."""
        asked = dict(vars(self), white_luminance=self.white)
        return {name: value for name, value in asked.items() if name not in ("scale", "night_vision")}

    def seen(self, picture: "MapRows") -> "MapRows":
        """The map as it is shown: by the eye at night where that is asked for."""
        from skydome.eye.night_vision import seen_by_night

        return seen_by_night(picture) if self.night_vision else picture

    @property
    def white(self) -> float | None:
        """cd m-2 of RGB (1, 1, 1), by --white-luminance or --scale; ValueError for both, or no scale."""
        if self.scale is None:
            return self.white_luminance
        if self.white_luminance is not None:
            raise ValueError("--scale is 1 / --white-luminance: give one of them")
        if not 0 < self.scale < float("inf"):
            raise ValueError(f"--scale must be finite and more than 0, got {self.scale:g}")
        return 1 / self.scale

    def layout(self, output: Path) -> "Target":
        """The target; ValueError or OSError, before any work, for what such a file cannot have."""
        from skydome.cli.doors import require_output
        from skydome.maps.files import FORMATS, require_choices
        from skydome.maps.targets import target

        require_output(output, "a map's file", FORMATS)
        if self.night_vision and output.suffix.lower() != ".png":
            raise ValueError(
                f"--night-vision is of a picture, sky.png, not of light to compute with; got {output.name}"
            )
        require_choices(output, self.half, self.white, self.exposure, self.gamut)
        return target(self.target)


def file_facts(
    path: Path, picture: "MapRows", layout: "Target", options: FileOptions, written: "Written"
) -> dict[str, Any]:
    """What was written: its size, where the renderer has north, its colours and unit, and notes on them."""
    from skydome.maps.files import file_white, space_in_file

    rows, columns = picture.size
    space, exposure = space_in_file(picture, path, layout), written.exposure
    return {
        "file": str(path),
        "bytes": path.stat().st_size,
        "height": rows,
        "width": columns,
        "target": layout.name,
        "orientation": layout.note,
        "space": space.name,
        "white_luminance_cd_m2": file_white(picture, path, layout, options.half, options.white),
        "exposure": options.exposure,
        **({} if exposure is None else {"exposure_ev": exposure_value(exposure)}),
        "notes": colour_notes(picture, space, options.gamut, written.outside) if exposure is None else [],
    }


def colour_notes(picture: "MapRows", space: Any, gamut: str, count: int) -> list[str]:
    """What became of the map's colours on their way into a file in that RGB space, `count` of them outside it."""
    notes = []
    if space != picture.space:
        notes.append(f"space: turned from {picture.space.name} into {space.name}, the one that the target reads")
    if count and gamut == "none":
        notes.append(f"gamut: {count:,} texels have negative parts, colours outside {space.name} (--gamut none)")
    elif count:
        notes.append(f"gamut: {count:,} texels outside {space.name} moved toward white, luminance kept (--gamut)")
    return notes


def file_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people, without the notes."""
    size = f"{facts['width']} x {facts['height']}, {facts['space']}, {facts['bytes'] / 1e6:.1f} MB"
    white = facts["white_luminance_cd_m2"]
    unit = {} if white is None else {"unit": f"RGB times {white:g} is cd m-2"}
    exposure = {} if facts["exposure"] is None else {"exposure": f"{facts['exposure']:g} per cd m-2"}
    if "exposure_ev" in facts:
        how = "by its content" if facts["exposure"] is None else exposure["exposure"]
        exposure = {"exposure": f"{facts['exposure_ev']:.1f} EV, {how}"}
    return {
        "file": facts["file"],
        "size": size,
        **unit,
        **exposure,
        "target": f"{facts['target']}: {facts['orientation']}",
    }
