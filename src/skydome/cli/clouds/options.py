"""What the commands ask for about clouds.

Only typer is imported here, so that help is quick.
"""

from dataclasses import dataclass
from typing import Annotated

from typer import Option

PANEL = "Clouds"


@dataclass(frozen=True)
class CloudOptions:
    """A field of cloud in the physical sky. None: not given."""

    clouds: Annotated[
        str | None,
        Option(
            metavar="KIND",
            help="cumulus (the usual), stratocumulus, altocumulus or cirrus; they carry the light of --dni and --dhi.",
            rich_help_panel=PANEL,
        ),
    ] = None
    cover: Annotated[
        float | None, Option(help="Share of the sky with cloud, 0-1. [default: 0.4]", rich_help_panel=PANEL)
    ] = None
    cloud_seed: Annotated[
        int | None, Option("--seed", help="Other clouds of the same kind. [default: 0]", rich_help_panel=PANEL)
    ] = None
    wind: Annotated[
        str | None,
        Option(metavar="EAST,NORTH", help="How they drift with --time, m/s. [default: 0,0]", rich_help_panel=PANEL),
    ] = None
