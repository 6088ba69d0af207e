"""What the commands ask of a layer of cloud, and of the particles of any cloud."""

from dataclasses import dataclass
from typing import Annotated

from typer import Option

CLOUD = "The cloud of an overcast sky, and what --clouds are of"

CloudKindWord = Annotated[
    str | None,
    Option(
        "--cloud-kind",
        metavar="water|ice|hexagonal",
        help="Of what it is; hexagonal ice has halos (--clouds). [default: water; of cirrus ice]",
        rich_help_panel=CLOUD,
    ),
]


@dataclass(frozen=True)
class LayerOptions:
    """A layer of cloud; its base and kind also those of a field. None: not given."""

    optical_depth: Annotated[
        float | None, Option("--cloud-depth", help="Its optical depth, 1-60. [default: 20]", rich_help_panel=CLOUD)
    ] = None
    base: Annotated[
        float | None,
        Option("--cloud-base", help="Height of the base, m. [default: 1000; --clouds: by kind]", rich_help_panel=CLOUD),
    ] = None
    kind: CloudKindWord = None
