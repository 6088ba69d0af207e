"""Sites by planes: N different weather files by 20 planes, `python benchmarks/portfolio.py FILE [SITES] [epw]`.

Each site is the file with its own seed: another place, up to 5 degrees north or south, and irradiances that clouds of
its own dim by up to a half, by hours and by days. So no two files, years or suns are alike. Tapes are written, or EPW
files, before the clock starts. Reports wall time and the CPU seconds of all processes, which do not depend on what else
runs, less those of writing.
"""

import os
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

import skydome as sd
from skydome import deg
from skydome.years.planes.portfolio import portfolio
from skydome.years.stores.sites_store import Site
from skydome.years.weather.calendar import month_day_hour
from skydome.years.weather.wea import write_wea

HEAD = """LOCATION,{name},-,-,made,000000,{latitude},{longitude},{offset},{altitude}
DESIGN CONDITIONS,0
TYPICAL/EXTREME PERIODS,0
GROUND TEMPERATURES,0
HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0
COMMENTS 1,made for a benchmark
COMMENTS 2,-
DATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31
"""


def perturbed(weather, seed):
    """The weather of a site of that seed."""
    random = np.random.default_rng(seed)
    direct, diffuse = weather.irradiances
    days = np.repeat(random.uniform(0.5, 1.0, weather.count // 24 + 1), 24)[: weather.count]
    direct = direct * np.clip(days * random.normal(1.0, 0.2, weather.count), 0.0, 1.0)
    place = weather.place
    place = replace(place, latitude=place.latitude + random.uniform(-5, 5), altitude=place.altitude + 10 * seed % 500)
    diffuse = diffuse * random.uniform(0.8, 1.2, weather.count)
    made = {"direct_normal": direct, "diffuse_horizontal": diffuse, "global_horizontal": None}
    return replace(weather, place=place, name=f"site {seed}", **made)


def write_epw(weather, path):
    """An EPW of its times, dew points and irradiances."""
    rows = [HEAD.format(name=weather.name, offset=weather.utc_offset, **vars(weather.place))]
    months, days, hours = month_day_hour(weather.local)
    for month, day, hour, dew, direct, diffuse in zip(
        months, days, np.ceil(hours).astype(int), weather.dew_point, *weather.irradiances, strict=True
    ):
        cells = ["0"] * 35
        cells[:6] = ["2023", str(month), str(day), str(hour), "60", "?9"]
        cells[6:9], cells[13:16] = ["20.0", f"{dew:.1f}", "50"], ["0", f"{direct:.1f}", f"{diffuse:.1f}"]
        rows.append(",".join(cells) + "\n")
    path.write_text("".join(rows))


def cpu_seconds():
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def main(file, count, kind):
    weather = sd.read_weather(file)
    planes = [sd.Plane(tilt * deg, turn * deg) for tilt in (0, 15, 30, 45, 90) for turn in (0, 90, 180, 270)]
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"site{seed}.{kind}" for seed in range(count)]
        for seed, path in enumerate(paths):
            (write_wea if kind == "wea" else write_epw)(perturbed(weather, seed), path)
        before, start = cpu_seconds(), time.perf_counter()
        data, _ = portfolio([Site(k + 2, f"site {k}", str(path)) for k, path in enumerate(paths)], planes)
        wall, cpu = time.perf_counter() - start, cpu_seconds() - before
    sums = data.irradiation.sum("month").values
    print(
        f"{count} different .{kind} files by {len(planes)} planes: {wall:.1f} s, {cpu:.1f} CPU s of all processes, "
        f"{np.isfinite(sums).all(axis=1).sum()} done, {sums.min():.0f}-{sums.max():.0f} kWh m-2"
    )


if __name__ == "__main__":
    words = sys.argv[1:]
    main(words[0], int(words[1]) if len(words) > 1 else 500, words[2] if len(words) > 2 else "wea")
