"""The kinds of cloud by name."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skydome.skies.clouds.fields.kinds import CloudKind

NAMES = ("cumulus", "stratocumulus", "altocumulus", "cirrus")


def kind_named(name: str) -> "CloudKind":
    """The kind of cloud; ValueError lists those that there are."""
    from skydome.skies.clouds.fields.kinds import Altocumulus, Cirrus, Cumulus, Stratocumulus

    if name not in NAMES:
        raise ValueError(f"--clouds must be one of {', '.join(NAMES)}, got {name!r}")
    made: tuple[CloudKind, ...] = (Cumulus(), Stratocumulus(), Altocumulus(), Cirrus())
    return next(kind for kind in made if kind.name == name)
