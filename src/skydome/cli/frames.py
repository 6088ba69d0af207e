"""A sequence of maps: its times, the names of its files, and the record by which it is taken up again."""

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import Any

from skydome.cli.map_order import MapOrder
from skydome.cli.moment import aware_time, moment_of

UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}
MOST_FRAMES = 100_000


def duration(text: str) -> timedelta:
    """A length of time such as 10min; ValueError for anything else.

    >>> duration("10min"), duration("1.5h")
    (datetime.timedelta(seconds=600), datetime.timedelta(seconds=5400))
    """
    found = re.fullmatch(r"(\d+(?:\.\d+)?)\s*(s|min|h|d)", text.strip())
    seconds = float(found[1]) * UNITS[found[2]] if found else 0.0
    if not 1e-6 <= seconds < timedelta.max.total_seconds():
        raise ValueError(f"--step must be a length of time such as 10min, 30s, 1h or 1d, got {text!r}")
    return timedelta(seconds=seconds)


def day_named(text: str) -> date:
    """The day that `--date` names; ValueError for what names none.

    >>> day_named("2024-02-29")
    datetime.date(2024, 2, 29)
    """
    try:
        return date.fromisoformat(text)
    except ValueError:
        raise ValueError(f"--date must be a day such as 2026-06-21, got {text!r}") from None


def frame_times(first: datetime, last: datetime, step: timedelta) -> list[datetime]:
    """Every `step` from the first to the last, both in; ValueError for a last that lies before, or too many frames.

    Steps are of elapsed time: they go through a change of the clocks as through any other hour.
    """
    start, end = first.astimezone(UTC), last.astimezone(UTC)
    count = int((end - start) / step) + 1
    if end < start:
        raise ValueError(f"--until must be at or after --time, got {first.isoformat()} to {last.isoformat()}")
    if count > MOST_FRAMES:
        raise ValueError(f"--step must give at most {MOST_FRAMES:,} frames, got {count:,}")
    return [(start + k * step).astimezone(first.tzinfo) for k in range(count)]


def frame_name(pattern: Path, number: int, time: datetime) -> Path:
    """The file of a frame: #### is its number, %Y%m%d_%H%M%z and the like its local time; else .0001 before the ending.

    >>> noon = datetime(2026, 6, 21, 12)
    >>> [frame_name(Path(name), 7, noon).name for name in ("day.exr", "sky_###.exr", "sky_%H%M.exr")]
    ['day.0007.exr', 'sky_007.exr', 'sky_1200.exr']
    """
    name = pattern.name
    if "%" in name:
        name = time.strftime(name)
    elif "#" in name:
        name = re.sub(r"#+", lambda marks: f"{number:0{len(marks[0])}d}", name)
    else:
        name = f"{pattern.stem}.{number:04d}{pattern.suffix}"
    return pattern.with_name(name)


@dataclass(frozen=True)
class Frames:
    """The maps of an order at `times`, the first its own."""

    order: MapOrder
    times: tuple[datetime, ...]

    @classmethod
    def of(cls, order: MapOrder, step: str) -> "Frames":
        """The frames by --time, --until and --step; ValueError for what is missing, or names that do not differ."""
        options = order.options
        if options.until is None or options.time is None or options.place is None:
            raise ValueError(
                "--step makes a sequence and needs --place, --time (the first frame) and --until (the last)"
            )
        first, last = (aware_time(text, options.zone) for text in (options.time, options.until))
        if order.output.suffix.lower() == ".png" and order.file.exposure is None:
            raise ValueError("the frames of a sequence share one exposure: give --exposure, such as 14EV")
        order = replace(order, options=replace(options, until=None, zone=None, time=first.isoformat()))
        frames = cls(order, tuple(frame_times(first, last, duration(step))))
        names = [frame.output for frame in frames]
        if len(set(names)) != len(names):
            raise ValueError(
                f"frames of {order.output.name!r} would have the same names: more of the time must be in it, "
                "such as %z where clocks are put back"
            )
        return frames

    def __iter__(self) -> Iterator[MapOrder]:
        """The order of each frame."""
        for number, time in enumerate(self.times, 1):
            beside = self.order.beside
            yield replace(
                self.order,
                options=replace(self.order.options, time=time.isoformat()),
                output=frame_name(self.order.output, number, time),
                beside=None if beside is None else frame_name(beside, number, time),
            )

    @property
    def record(self) -> Path:
        """The file that tells which frames were made, and of what."""
        stem = re.sub(r"[#%]\w*", "", self.order.output.stem).strip("._- ") or "frames"
        return self.order.output.with_name(f"{stem}.frames.json")

    def asked(self) -> str:
        """A hash of all that makes a frame but its time."""
        from skydome import __version__
        from skydome.ground.files.contents import digest_of

        order = replace(self.order, options=replace(self.order.options, time=None))
        told = {name: repr(value) for name, value in vars(order).items()}
        return digest_of(__version__, told)

    def done(self) -> dict[str, Any]:
        """Frames by name that an earlier call of the same order made, and whose files are still there."""
        try:
            told = json.loads(self.record.read_text("utf-8"))
            frames = told["frames"] if told["asked"] == self.asked() else {}
            return {name: facts for name, facts in frames.items() if self.record.with_name(name).exists()}
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            return {}

    def keep(self, frames: dict[str, Any]) -> None:
        """Write the record."""
        from skydome.ground.writing import appearing

        with appearing(self.record) as hidden:
            hidden.write_text(json.dumps({"asked": self.asked(), "frames": frames}, indent=1), encoding="utf-8")


def is_dark(order: MapOrder) -> bool:
    """True where the sun has set and the model knows no light then."""
    from skydome.skies.catalogue import model_named
    from skydome.sun.day import is_day

    kind = model_named(order.options.model)
    lit = kind.kind.of_all_hours or is_day(moment_of(order.options).direction, kind.kind.lowest_sun)
    return kind.has_sun and not lit


def frame_facts(facts: dict[str, Any]) -> dict[str, Any]:
    """What the record keeps of a frame."""
    kept = ("time", "sun", "illuminance_lx", "zenith_luminance_cd_m2", "scene", "lamp", "light")
    return {name: facts[name] for name in kept if name in facts}
