"""What the commands ask of a layer of cloud."""

from dataclasses import dataclass
from typing import Annotated

from typer import Option

CLOUD = "The cloud of an overcast sky"


@dataclass(frozen=True)
class LayerOptions:
    """A layer of cloud. None: not given."""

    optical_depth: Annotated[
        float | None, Option("--cloud-depth", help="Its optical depth, 1-60. [default: 20]", rich_help_panel=CLOUD)
    ] = None
    base: Annotated[
        float | None, Option("--cloud-base", help="Height of its base, m. [default: 1000]", rich_help_panel=CLOUD)
    ] = None
    kind: Annotated[
        str | None,
        Option("--cloud-kind", metavar="water|ice", help="Of what it is. [default: water]", rich_help_panel=CLOUD),
    ] = None
