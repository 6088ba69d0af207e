"""The work of `skydome animate`: read, train, write frames; each step kept, so that it can be interrupted."""

import hashlib
import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.writing import appearing

if TYPE_CHECKING:
    from skydome.captures.captures import Capture
    from skydome.skies.neural.network import Network
    from skydome.sun.place import Place

Tell = Callable[[str, float], None]


@dataclass(frozen=True)
class Job:
    """What is to be animated, and where the frames go."""

    folder: Path
    output: Path
    frames: int
    layout: str
    place: "Place | None"
    zone: str | None
    horizon: float
    seed: int
    half: bool

    def digest(self) -> str:
        """A fingerprint of the settings and of the captures' files."""
        parts = [repr((self.frames, self.layout, self.place, self.zone, self.horizon, self.seed, self.half))]
        for path in sorted(self.folder.iterdir()):
            if path.is_file() and not path.name.startswith("."):
                parts.append(f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}")
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    def frame_path(self, k: int) -> Path:
        """The file of a frame."""
        return self.output / f"frame_{k:05d}.exr"


@contextmanager
def progress_bar() -> Iterator[Tell]:
    """A listener that shows stage and share on stderr, where that is a terminal."""
    from rich.console import Console
    from rich.progress import Progress

    console = Console(stderr=True)
    with Progress(console=console, disable=not console.is_terminal, transient=True) as bar:
        task = bar.add_task("", total=1.0)

        def tell(stage: str, share: float) -> None:
            bar.update(task, description=stage, completed=min(share, 1.0))

        yield tell


def run(job: Job) -> dict[str, Any]:
    """Write the frames that are not there yet; facts about the animation."""
    from skydome.captures.animation import Animation
    from skydome.captures.captures import read_captures

    with progress_bar() as tell:
        captures = read_captures(job.folder, job.layout, job.place, job.zone, job.horizon, tell)
        begin(job)
        start = time.perf_counter()
        network = trained(job, captures, tell)
        learned = time.perf_counter()
        animation = Animation(captures, network)
        written, roughness = write_frames(job, animation, tell)
    return {
        "frames": job.frames,
        "written": written,
        "folder": str(job.output),
        "captures": len(captures),
        "network": str(job.output / "day.safetensors"),
        "hidden_suns": [capture.name for capture in captures if not capture.visible],
        "negative_values_set_to_0": sum(capture.clipped for capture in captures),
        "largest_change_over_median": roughness,
        "training_s": round(learned - start, 2),
        "frames_s": round(time.perf_counter() - learned, 2),
    }


def begin(job: Job) -> None:
    """Make the folder and note what its frames are; ValueError where it holds frames of something else."""
    if not job.output.exists():
        if not job.output.absolute().parent.is_dir():
            raise FileNotFoundError(f"the folder to write to must exist, got {job.output.parent}")
        job.output.mkdir()
    note = job.output / "animation.json"
    if note.exists():
        try:
            known = json.loads(note.read_text()).get("digest")
        except (json.JSONDecodeError, AttributeError):
            known = None
        if known != job.digest():
            raise ValueError(f"{job.output} holds frames of other captures or settings; choose another folder")
        return
    if any(job.output.iterdir()):
        raise ValueError(f"the folder for the frames must be empty or of this animation, got {job.output}")
    with appearing(note) as beside:
        beside.write_text(json.dumps({"digest": job.digest(), "frames": job.frames}))


def trained(job: Job, captures: "list[Capture]", tell: Tell) -> "Network":
    """The day's network: read where it was kept, else trained and kept."""
    from skydome.captures.capture_training import train_captures
    from skydome.skies.neural.files import load_network, save_network

    path = job.output / "day.safetensors"
    if path.exists():
        return load_network(path)[0]
    network = train_captures(captures, seed=job.seed, progress=lambda stage, error: tell(f"training, {stage}", 0.0))
    save_network(path, network, {"captures": [capture.name for capture in captures], "seed": job.seed})
    return network


def write_frames(job: Job, animation: Any, tell: Tell) -> tuple[int, float | None]:
    """Write what is missing: how many frames that were, and the largest change over the median one of those made."""
    from skydome.captures.animation import change, roughest

    times = np.linspace(animation.times[0], animation.times[-1], job.frames)
    written, changes, before = 0, [], None
    for k, moment in enumerate(times):
        if job.frame_path(k).exists():
            before = None
            continue
        frame = animation.frame(moment)
        frame.save(job.frame_path(k), half=job.half)
        if before is not None:
            changes.append(change(before, frame.pixels))
        before, written = frame.pixels, written + 1
        tell(f"frame {k + 1} of {job.frames}", (k + 1) / job.frames)
    return written, round(roughest(changes), 3) if changes else None


def write_masks(job: Job) -> dict[str, Any]:
    """Write a mask beside each capture that has none: white where sky was found."""
    from skydome.captures.captures import MASK, read_captures
    from skydome.captures.sky_mask import write_mask

    with progress_bar() as tell:
        captures = read_captures(job.folder, job.layout, job.place, job.zone, job.horizon, tell)
    written = []
    for capture in captures:
        path = job.folder / (Path(capture.name).stem + MASK)
        if not path.exists():
            write_mask(path, capture.sky)
            written.append(path.name)
    return {"masks": written, "folder": str(job.folder)}
