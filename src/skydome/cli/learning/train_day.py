"""A network that learns a day, from captured maps or a scanner's samples, for `skydome train`."""

import time
from abc import ABC, abstractmethod
from pathlib import Path
from typing import TYPE_CHECKING, Any

from skydome.cli.doors import progress

if TYPE_CHECKING:
    from skydome.captures.capture_validation import DayErrors
    from skydome.captures.scans import Scan

SAMPLES_HELD = 2000
"""Directions of a held-out map."""


class Day(ABC):
    """What was captured, with a name for each capture."""

    names: list[str]

    @abstractmethod
    def scans(self, seed: int) -> "list[Scan]":
        """Samples to learn."""

    @abstractmethod
    def held(self, seed: int) -> "list[Scan]":
        """Samples of the same skies to be tested on."""


class MapsOfDay(Day):
    """A folder of captured maps."""

    def __init__(self, folder: Path, layout: str, place: str | None, zone: str | None) -> None:
        """Read the maps."""
        import skydome as sd
        from skydome.captures.captures import layout_named, read_captures

        layout_named(layout)
        where = None if place is None else sd.Place.parse(place)
        with progress("reading captures") as report:
            self.captures = read_captures(
                folder, layout, where, zone, 0.0, lambda name, share: report(share, 1.0, name)
            )
        self.names = [capture.name for capture in self.captures]

    def scans(self, seed: int) -> "list[Scan]":
        """Samples to learn."""
        from skydome.captures.capture_training import scans_of

        return scans_of(self.captures, seed=seed)

    def held(self, seed: int) -> "list[Scan]":
        """Other and more samples of the same skies, even in solid angle, to be tested on."""
        from skydome.captures.capture_training import scans_of

        return scans_of(self.captures, SAMPLES_HELD, seed + 1_000_000, about_sun=0.0)


class ScansOfDay(Day):
    """A file of a scanner's samples: netCDF with colours, or a table of luminance (.csv)."""

    def __init__(self, path: Path) -> None:
        """Read the scans."""
        from skydome.captures.luminance_scans import read_luminance_scans
        from skydome.captures.scans import read_scans

        self.read = read_luminance_scans(path) if path.suffix.lower() == ".csv" else read_scans(path)
        self.names = [f"{scan.time:.15g}" for scan in self.read]

    def scans(self, seed: int) -> "list[Scan]":
        """All samples."""
        del seed
        return self.read

    def held(self, seed: int) -> "list[Scan]":
        """All samples: a scanner has no others."""
        return self.scans(seed)


def train_day_network(
    output: Path, day: Day, recipe: str, seed: int, folds: int | None, validate: bool
) -> dict[str, Any]:
    """Train on every capture, write, and tell errors; with `validate`, those of captures held out in turn."""
    import skydome
    from skydome.captures.capture_training import day_recipe, train_day
    from skydome.captures.capture_validation import DayErrors, errors_of, light_at, validated_by_folds
    from skydome.skies.neural.files import save_network

    way, scans, held = day_recipe(recipe), day.scans(seed), day.held(seed)
    facts: dict[str, Any] = {"captures": day.names, "recipe": recipe, "seed": seed}
    if validate:
        with progress("validating") as report:
            found = validated_by_folds(
                scans, held, way, seed, folds, lambda fold, count: report(fold, count, f"fold {fold} of {count}")
            )
        facts["held_out"] = day_facts(found) | {"folds": folds or len(scans), "by_capture": capture_facts(found, day)}
    start = time.process_time()
    with progress("training") as report:
        network = train_day(scans, way, seed, lambda stage, loss: report(0, None, f"{stage}, error {loss:.5f}"))
    seconds = round(time.process_time() - start, 1)
    learned = DayErrors(tuple(errors_of(light_at(network, scan), scan, network.scale) for scan in held))
    facts |= {"bytes": network.bytes, "processor_seconds": seconds, "learned": day_facts(learned)}
    save_network(output, network, {"command": "skydome train", "skydome": skydome.__version__} | facts)
    return {"file": str(output)} | facts


def day_facts(errors: "DayErrors") -> dict[str, float]:
    """The measures of a day by name."""
    names = ("target", "relative", "irradiance", "irradiance_of_means")
    return {name: round(float(getattr(errors, name)), 6) for name in names}


def capture_facts(errors: "DayErrors", day: Day) -> list[dict[str, Any]]:
    """The measures of each capture."""
    return [
        {
            "capture": name,
            "target": round(found.target, 6),
            "relative": round(found.relative, 6),
            "illuminance_lx": round(found.illuminance, 1),
            "illuminance_learned_lx": round(found.learned, 1),
        }
        for name, found in zip(day.names, errors.scans, strict=True)
    ]
