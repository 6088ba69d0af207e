"""Frames between captures, in files: read, train, write; each step is kept, so that it can be interrupted."""

import hashlib
import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from skydome.captures.animation import Animation, change, roughest
from skydome.captures.capture import Capture
from skydome.captures.capture_training import day_recipe, train_captures
from skydome.captures.captures import MASK, read_captures
from skydome.captures.sky_mask import write_mask
from skydome.ground.files.leftovers import sweep
from skydome.ground.writing import appearing, is_hidden_part, require_place
from skydome.maps.by_rows.light_in_file import half_white
from skydome.skies.neural.files import load_network, save_network
from skydome.skies.neural.network import Network
from skydome.sun.place import Place

Tell = Callable[[str, float], None]
"""Is told what is done, and which share of it, 0-1."""


@dataclass(frozen=True)
class Job:
    """What is to be animated, and where the frames go."""

    folder: Path
    output: Path
    frames: int
    layout: str
    place: Place | None
    zone: str | None
    horizon: float
    seed: int
    half: bool
    recipe: str = "maps"

    def digest(self) -> str:
        """A fingerprint of the settings and of the captures' files."""
        parts = [
            repr((self.frames, self.layout, self.place, self.zone, self.horizon, self.seed, self.half, self.recipe))
        ]
        for path in sorted(self.folder.iterdir()):
            if path.is_file() and not path.name.startswith("."):
                parts.append(f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}")
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    @property
    def note(self) -> Path:
        """The file that says what the frames are of."""
        return self.output / "animation.json"

    def frame_path(self, k: int) -> Path:
        """The file of a frame."""
        return self.output / f"frame_{k:05d}.exr"


def run(job: Job, tell: Tell) -> dict[str, Any]:
    """Write the frames that are not there yet; facts about the animation.

    ValueError or OSError, before any work, for a folder of frames that cannot be made or holds something else.
    """
    require_free_folder(job)
    captures = read_captures(job.folder, job.layout, job.place, job.zone, job.horizon, tell)
    begin(job)
    start = time.perf_counter()
    network = trained(job, captures, tell)
    learned = time.perf_counter()
    written, roughness = write_frames(job, Animation(captures, network), tell)
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


def require_free_folder(job: Job) -> None:
    """OSError where the folder cannot be made; ValueError where it holds frames of something else, or other things."""
    require_place(job.output, folder=True)
    sweep(job.output)
    if not job.output.exists() or all(is_hidden_part(path) for path in job.output.iterdir()):
        return
    if not job.note.exists():
        raise ValueError(f"the folder for the frames must be empty or of this animation, got {job.output}")
    try:
        known = json.loads(job.note.read_text()).get("digest")
    except (json.JSONDecodeError, AttributeError):
        known = None
    if known != job.digest():
        raise ValueError(f"{job.output} holds frames of other captures or settings; choose another folder")


def begin(job: Job) -> None:
    """Make the folder and note what its frames are."""
    job.output.mkdir(exist_ok=True)
    if not job.note.exists():
        with appearing(job.note) as beside:
            beside.write_text(json.dumps({"digest": job.digest(), "frames": job.frames}))


def trained(job: Job, captures: list[Capture], tell: Tell) -> Network:
    """The day's network: read where it was kept, else trained and kept."""
    path = job.output / "day.safetensors"
    if path.exists():
        return load_network(path)[0]
    network = train_captures(
        captures, day_recipe(job.recipe), job.seed, progress=lambda stage, error: tell(f"training, {stage}", 0.0)
    )
    save_network(
        path, network, {"captures": [capture.name for capture in captures], "seed": job.seed, "recipe": job.recipe}
    )
    return network


def write_frames(job: Job, animation: Any, tell: Tell) -> tuple[int, float | None]:
    """Write what is missing: how many frames that were, and the largest change over the median one of those made."""
    times = np.linspace(animation.times[0], animation.times[-1], job.frames)
    written, changes, before = 0, [], None
    white = half_white(animation.peak) if job.half else None
    for k, moment in enumerate(times):
        if job.frame_path(k).exists():
            before = None
            continue
        frame = animation.frame(moment)
        frame.save(job.frame_path(k), half=job.half, white_luminance=white)
        if before is not None:
            changes.append(change(before, frame.pixels))
        before, written = frame.pixels, written + 1
        tell(f"frame {k + 1} of {job.frames}", (k + 1) / job.frames)
    return written, round(roughest(changes), 3) if changes else None


def write_masks(job: Job, tell: Tell) -> dict[str, Any]:
    """Write a mask beside each capture that has none: white where sky was found."""
    captures = read_captures(job.folder, job.layout, job.place, job.zone, job.horizon, tell)
    written = []
    for capture in captures:
        path = job.folder / (Path(capture.name).stem + MASK)
        if not path.exists():
            write_mask(path, capture.sky)
            written.append(path.name)
    return {"masks": written, "folder": str(job.folder)}
