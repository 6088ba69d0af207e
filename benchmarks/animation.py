"""Time of 240 frames of 512 x 256 from 12 captures, stage by stage: python benchmarks/animation.py."""

import tempfile
import time
from pathlib import Path

import numpy as np

import skydome as sd
from skydome.captures.frames import Job, run

PLACE = sd.Place(45.07, 7.69, 240)


def captures(folder):
    for k in range(12):
        moment = f"{np.datetime64('2026-06-21T04:30') + np.timedelta64(80 * k, 'm')}:00+00:00"
        sky = sd.HosekWilkie(sd.sun_direction(PLACE, moment), 3.0)
        sd.render(sky + sd.SunDisc.of(sky), 256, metadata={"time": moment}).save(folder / f"{k:02d}.exr")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "captures"
        folder.mkdir()
        captures(folder)
        wall, cpu = time.perf_counter(), time.process_time()
        facts = run(
            Job(folder, Path(name) / "frames", 240, "latlong", None, None, 0.0, 0, True), lambda stage, share: None
        )
        print(f"whole command {time.perf_counter() - wall:.1f} s (processor {time.process_time() - cpu:.1f} s)")
        print({key: facts[key] for key in ("training_s", "frames_s", "largest_change_over_median")})


if __name__ == "__main__":
    main()
