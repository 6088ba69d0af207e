"""The frames of a day as one .mp4, each exposed for its content, by the program ffmpeg."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

    from skydome.maps.environment_map import EnvironmentMap

RATE = 24
"""Frames a second."""

CALM = 600.0
"""Seconds over which the exposure is evened out by a bell curve, so that it does not pump: more would miss the dusk."""


@dataclass(frozen=True)
class Movie:
    """A film in `output`: of one `exposure`, or each frame by its content; as the eye sees it at night, where asked."""

    output: Path
    exposure: float | None = None
    night_vision: bool = False

    def require(self) -> None:
        """ValueError or OSError, before any work, for a film that cannot be made."""
        from skydome.cli.doors import require_output

        encoder()
        require_output(self.output, "a film", (".mp4",))

    def made(self, frames: Sequence[Path], seconds: Sequence[float], report: Callable[..., None]) -> dict[str, Any]:
        """Write it of maps in files, at their `seconds` (N,): the facts."""
        exposures = self.exposures(frames, seconds, report)
        first = self.picture(frames[0], exposures[0])
        with Pipe(self.output, first.shape[1], first.shape[0]) as pipe:
            for number, (path, exposure) in enumerate(zip(frames, exposures, strict=True)):
                report(number, len(frames), f"encoding {path.name}")
                pipe.write(self.picture(path, exposure))
        return {"film": str(self.output), "film_seconds": len(frames) / RATE, "film_bytes": self.output.stat().st_size}

    def exposures(self, frames: Sequence[Path], seconds: Sequence[float], report: Callable[..., None]) -> list[float]:
        """The factor per cd m-2 of each."""
        import numpy as np

        from skydome.maps.showing.preview import usual_exposure

        if self.exposure is not None:
            return [self.exposure] * len(frames)
        wanted = []
        for number, path in enumerate(frames):
            report(number, len(frames), f"metering {path.name}")
            wanted.append(usual_exposure(self.seen(path)))
        return calmed(np.log(wanted), np.array(seconds))

    def seen(self, path: Path) -> "EnvironmentMap":
        """A map as it is shown."""
        from skydome.eye.night_vision import night_vision
        from skydome.maps.loading import load

        return night_vision(load(path)) if self.night_vision else load(path)

    def picture(self, path: Path, exposure: float) -> "np.ndarray":
        """sRGB bytes (H, W, 3)."""
        import numpy as np

        from skydome.maps.showing.preview import preview

        return (255 * preview(self.seen(path), exposure) + 0.5).astype(np.uint8)


def calmed(logarithms: "np.ndarray", seconds: "np.ndarray") -> list[float]:
    """Exposures (N,) of logarithms (N,) at `seconds` (N,), each evened out with its neighbours.

    >>> import numpy as np
    >>> calmed(np.zeros(4), np.arange(4) * 600.0)
    [1.0, 1.0, 1.0, 1.0]
    """
    import numpy as np

    weights = np.exp(-0.5 * ((seconds[:, None] - seconds) / CALM) ** 2)
    smooth = weights @ logarithms / weights.sum(axis=1)
    return [float(value) for value in np.exp(smooth)]


def encoder() -> str:
    """Where ffmpeg is; ValueError where it is not."""
    from shutil import which

    found = which("ffmpeg")
    if found is None:
        raise ValueError("--film needs the program ffmpeg, and none is on the PATH; without --film the frames are made")
    return found


class Pipe:
    """A running ffmpeg that takes pictures of one size and writes an .mp4, which appears when it is whole."""

    def __init__(self, output: Path, width: int, height: int) -> None:
        from contextlib import ExitStack

        self.stack, self.output, self.size = ExitStack(), output, f"{width}x{height}"

    def __enter__(self) -> "Pipe":
        from subprocess import PIPE, Popen

        from skydome.ground.writing import appearing

        hidden = self.stack.enter_context(appearing(self.output))
        taken = ("-f", "rawvideo", "-pix_fmt", "rgb24", "-s", self.size, "-r", str(RATE), "-i", "-")
        given = ("-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4")
        self.process = Popen(
            [encoder(), "-y", "-loglevel", "error", *taken, *given, str(hidden)], stdin=PIPE, stderr=PIPE
        )
        return self

    def write(self, picture: "np.ndarray") -> None:
        """Send one picture, bytes (H, W, 3)."""
        assert self.process.stdin is not None
        try:
            self.process.stdin.write(picture.tobytes())
        except BrokenPipeError:
            self.finish()

    def finish(self) -> None:
        """Wait for the end; ValueError with ffmpeg's last words where it failed."""
        _, said = self.process.communicate()
        if self.process.returncode:
            words = (said.decode(errors="replace").strip().splitlines() or ["no reason told"])[-1]
            raise ValueError(f"ffmpeg did not write {self.output.name}: {words}")

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        if kind is not None:
            self.process.kill()
            self.process.wait()
            self.stack.__exit__(kind, error, trace)
            return
        with self.stack:
            self.finish()
