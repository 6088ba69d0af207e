"""What stands over the place: nothing, an overcast, a field of cloud."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

from skydome.air.atmosphere import Atmosphere
from skydome.air.clouds.cloud import Cloud
from skydome.ground.directions import ZENITH
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.night.clouds.behind_field import behind, lit_by
from skydome.skies.night.clouds.layer_in_air import LayerInAir
from skydome.skies.night.clouds.overcast import BANDS, cloud_of, under
from skydome.skies.night.clouds.remembered import RememberedField

Parts = dict[str, Any]
"""Skies by name."""
BEAMS = ("moonlight", "sky")
"""Those of a light that casts shadows, the one first whose rays the others share."""


class Over(ABC):
    """What stands over the place."""

    words: str | None = None
    """What it is; None for nothing."""

    @abstractmethod
    def before(self, parts: Parts, air: Atmosphere) -> Parts:
        """The parts of an hour as they are seen from below it."""


@dataclass(frozen=True)
class ClearAbove(Over):
    """Nothing."""

    def before(self, parts: Parts, air: Atmosphere) -> Parts:
        """The parts as they are."""
        return parts


@dataclass(frozen=True)
class OvercastAbove(Over):
    """An even layer."""

    cloud: Cloud

    @property
    def words(self) -> str:  # type: ignore[override]
        """How thick it is."""
        return f"an overcast of optical depth {float(self.cloud.optical_depth):g}; no disc and no star is seen"

    def before(self, parts: Parts, air: Atmosphere) -> Parts:
        """Each part's light spread."""
        layer = LayerInAir(self.cloud, air, BANDS)
        return {name: under(sky, layer) for name, sky in parts.items()}


@dataclass(frozen=True)
class FieldAbove(Over):
    """A field of cloud."""

    field: CloudField

    @property
    def words(self) -> str:  # type: ignore[override]
        """What it is."""
        return self.field.words

    def before(self, parts: Parts, air: Atmosphere) -> Parts:
        """Each part behind the field; those without a beam share its rays with the moon's, or the sun's."""
        if self.field.cover <= 0:
            return parts
        lit: dict[str, RememberedField] = {}
        for name in BEAMS:
            if name in parts and (field := lit_by(parts[name], self.field)) is not None:
                lit[name] = field
        shared = next(iter(lit.values())) if lit else RememberedField.of(self.field, ZENITH)
        return {name: behind(sky, lit.get(name, shared)) for name, sky in parts.items()}


def clouds_over(given: Any) -> Over:
    """What `clouds` says: None, a field, a layer or its optical depth; an error in a sentence for anything else."""
    if isinstance(given, CloudField):
        return FieldAbove(given)
    cloud = cloud_of(given)
    return ClearAbove() if cloud is None else OvercastAbove(cloud)
