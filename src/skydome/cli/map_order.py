"""What one map is to be: its file, size, ground and north, the scene beside it; its making, and what is said of it."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING, Any

from skydome.cli.map_file import FileOptions, file_facts, file_rows
from skydome.cli.numbers_of_light import amount, light_facts, light_rows, lit_by, notes_row
from skydome.cli.options import SkyOptions
from skydome.cli.scene import scene_of

if TYPE_CHECKING:
    from skydome.cli.scene import Scene
    from skydome.dome.map_rows import SkyRows
    from skydome.maps.environment_map import EnvironmentMap
    from skydome.maps.files import Written
    from skydome.maps.targets import Target

SPACES = {"srgb": "SRGB", "rec2020": "REC2020", "acescg": "ACESCG"}
USUAL_TEXELS = 2 * 1024**2
HELD_TEXELS = 1 << 24
"""A map of at most so many is held in memory, 200 MB; of larger ones only some rows."""


@dataclass(frozen=True)
class MapOrder:
    """A map in `output` of the sky that the options ask for, and with `beside` the scene of a renderer.

    Azimuths of the map are from `north` degrees clockwise of true north.
    """

    options: SkyOptions
    file: FileOptions
    output: Path
    height: int | None = None
    space: str = "srgb"
    ground: str | None = None
    north: float = 0.0
    beside: Path | None = None

    def checked(self) -> "MapOrder":
        """The order, with the scene's target in it; ValueError or OSError, before any work, for what cannot be."""
        if not abs(self.north) <= 360:
            raise ValueError(f"--north must lie in [-360, 360] degrees, got {self.north:g}")
        order = self if self.beside is None else replace(self, file=self.file_for(self.beside))
        layout = order.layout
        layout.projection.shape(order.rows)  # refuses a height
        space_named(self.space, layout)
        ground_albedo(self.ground, self.options)
        return order

    def file_for(self, beside: Path) -> FileOptions:
        """The file's options as that scene needs them."""
        from skydome.export.scenes.formats import scene_format
        from skydome.export.scenes.saving import require_scene

        require_scene(beside, self.output, self.file.white, self.file.exposure)
        name = scene_format(beside).target_name
        if self.file.target not in ("native", name):
            raise ValueError(f"--scene {beside.name} needs --target {name}, got {self.file.target}")
        if self.file.half or self.options.no_sun:
            raise ValueError(
                "--scene takes the sun out of the map by itself, and chooses its floats: no --no-sun, --half"
            )
        return replace(self.file, target=name)

    @property
    def layout(self) -> "Target":
        """The target."""
        return (self.file if self.beside is None else replace(self.file, exposure=None)).layout(self.output)

    @property
    def rows(self) -> int:
        """Rows of the map."""
        return self.layout.projection.height_for(USUAL_TEXELS) if self.height is None else self.height

    def scene(self) -> "Scene":
        """The light."""
        return scene_of(self.options, self.north, any_hour=True)

    def made(
        self,
        report: Callable[..., None] = lambda *_: None,
        told: "Callable[[Scene], dict[str, Any]]" = light_facts,
    ) -> dict[str, Any]:
        """Make it: the facts of the light, those `told`, and of the file. `report` is called with the rows done and
        all rows.
        """
        from skydome.maps.files import save

        scene = self.scene()
        picture, more = self.map_rows(scene), dict[str, Any]()
        if self.beside is not None:
            written, more = self.with_scene(scene, picture.held(), self.beside)
        else:
            shown = self.file.seen(picture.held() if prod(picture.size) <= HELD_TEXELS else picture)
            written = save(shown, self.output, **self.file.choices, report=report)
        facts, file = told(scene), file_facts(self.output, picture, self.layout, self.file, written)
        turned = {"north_deg": self.north} if self.north else {}
        return facts | file | turned | more | {"notes": facts["notes"] + file["notes"]}

    def map_rows(self, scene: "Scene") -> "SkyRows":
        """The map, without the sun's disc where a scene has it as a lamp."""
        import skydome as sd

        metadata = {} if scene.moment is None else scene.moment.metadata
        metadata["software"] = f"skydome {sd.__version__}"
        if self.north:
            metadata["north"] = f"{self.north:g} degrees clockwise from true north"
        return sd.render_rows(
            scene.whole,
            self.rows,
            projection=self.layout.projection,
            space=space_named(self.space, self.layout),
            ground_albedo=ground_albedo(self.ground, self.options),
            disc=self.beside is None,
            metadata=metadata,
        )

    def with_scene(self, scene: "Scene", picture: "EnvironmentMap", beside: Path) -> "tuple[Written, dict[str, Any]]":
        """Write map and scene: what was seen of the map, and the sun's lamp in numbers, in the renderer's axes."""
        from skydome.export.scenes.formats import scene_format
        from skydome.export.scenes.saving import write_scene
        from skydome.light.gamut import count_outside
        from skydome.maps.files import Written, space_in_file

        space = space_in_file(picture, self.output, self.layout)
        seen = Written(count_outside(picture.pixels, picture.matrix_to(space)))
        choices = {name: self.file.choices[name] for name in ("exposure", "white_luminance", "gamut")}
        written = write_scene(scene.whole, picture, beside, self.output, **choices)
        kind, lamp = scene_format(beside), written.lamp
        facts: dict[str, Any] = {"scene": str(beside), "renderer": kind.name, "view_exposure": written.exposure}
        if lamp is not None:
            facts["lamp"] = {
                "toward": kind.toward(lamp.direction).tolist(),
                "rgb_lx": lamp.rgb(kind.lamp_space(written.space)).tolist(),
                "illuminance_lx": lamp.illuminance,
                "luminance_cd_m2": lamp.luminance,
                "angle_deg": lamp.width,
                "colour_temperature_K": lamp.colour_temperature,
            }
        return seen, facts


def order_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The facts of a map that was made, for people."""
    rows = light_rows(facts) | file_rows(facts)
    if "north_deg" in facts:
        rows["north"] = f"the map's north points {facts['north_deg']:g}° clockwise from true north"
    if "scene" in facts:
        rows["scene"] = f"{facts['scene']} ({facts['renderer']}), the {lit_by(facts)} as a lamp"
        rows["view exposure"] = f"{facts['view_exposure']:.3g} per cd m-2"
    if "lamp" in facts:
        lamp = facts["lamp"]
        toward = ", ".join(f"{value:.4f}" for value in lamp["toward"])
        rows["lamp"] = (
            f"toward ({toward}), {amount(lamp['illuminance_lx'])} lx facing it, {lamp['colour_temperature_K']:.0f} K, "
            f"{lamp['angle_deg']:.3f}° across"
        )
    return rows | notes_row(facts["notes"])


def space_named(name: str, layout: "Target") -> Any:
    """The RGB space by name; ValueError lists the names there are, and where the target would read it as another."""
    import skydome as sd

    if name not in SPACES:
        raise ValueError(f"space must be one of {', '.join(SPACES)}, got {name!r}")
    space = getattr(sd, SPACES[name])
    if not layout.takes(space):
        allowed = " or ".join(key for key, value in SPACES.items() if layout.takes(getattr(sd, value)))
        if not allowed:
            return layout.spaces[0]
        raise ValueError(
            f"--space for {layout.name}, which reads its numbers in no other, must be {allowed}, got {name}"
        )
    return space


def ground_albedo(ground: str | None, options: SkyOptions) -> float | None:
    """The ground's albedo: --ground, else --albedo, else None for the sky's own."""
    if ground is None or ground == "black":
        return options.albedo if ground is None else 0.0
    try:
        return float(ground)
    except ValueError:
        raise ValueError(f"ground must be black or an albedo in [0, 1], got {ground!r}") from None
