"""The kinds of cloud by name, and what they are made of by a word and sizes."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skydome.air.clouds.particles import CloudParticles
    from skydome.skies.clouds.fields.kinds import CloudKind

NAMES = ("cumulus", "stratocumulus", "altocumulus", "cirrus")
USUAL: Mapping[str, float] = {}
"""No sizes of one's own."""
CLOUDS = "--clouds"


def with_usual_kind(words: list[str]) -> list[str]:
    """The words of a command, with the usual kind of cloud after a `--clouds` that names none.

    >>> with_usual_kind(["--clouds", "--cover", "0.5"])
    ['--clouds', 'cumulus', '--cover', '0.5']
    """
    named = list(words)
    if CLOUDS in named:
        after = named.index(CLOUDS) + 1
        if after == len(named) or named[after].startswith("-"):
            named.insert(after, NAMES[0])
    return named


def kind_named(name: str, particles: str | None = None, sizes: Mapping[str, float] = USUAL) -> "CloudKind":
    """The kind of cloud, of particles by their word and of `sizes` by name; ValueError lists those that there are."""
    from skydome.skies.clouds.fields.kinds import Altocumulus, Cirrus, Cumulus, Stratocumulus

    if name not in NAMES:
        raise ValueError(f"--clouds must be one of {', '.join(NAMES)}, got {name!r}")
    made: tuple[CloudKind, ...] = (Cumulus(), Stratocumulus(), Altocumulus(), Cirrus())
    kind, shape = next(kind for kind in made if kind.name == name), dict(sizes)
    radius = shape.pop("effective_radius", None)
    return type(kind)(particles_named(particles, kind.particles, shape), radius)


def particles_named(word: str | None, usual: "CloudParticles", shape: Mapping[str, float]) -> "CloudParticles":
    """The particles of a word, of a crystal's `shape`; ValueError for other words, and a shape where none is known."""
    from skydome.air.clouds.crystals.hexagonal_ice import HexagonalIce
    from skydome.air.clouds.named import PARTICLES
    from skydome.ground.arguments import require_word

    found = usual if word is None else PARTICLES[require_word(word, PARTICLES, "--cloud-kind")]
    if not shape:
        return found
    if not isinstance(found, HexagonalIce):
        raise ValueError(f"--set {next(iter(shape))} is of hexagonal ice: give --cloud-kind hexagonal too")
    return replace(found, **shape)
