"""Sites by planes a minute: 500 copies of one weather file by 20 planes, `python benchmarks/portfolio.py FILE [SITES]`.

Reports wall time, and CPU seconds of all processes, which do not depend on what else runs.
"""

import os
import sys
import time

import skydome as sd
from skydome import deg
from skydome.years.planes.portfolio import portfolio
from skydome.years.stores.sites_store import Site

if __name__ == "__main__":
    file, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 500
    planes = [sd.Plane(tilt * deg, turn * deg) for tilt in (0, 15, 30, 45, 90) for turn in (0, 90, 180, 270)]
    sites = [Site(k + 2, f"site {k}", file) for k in range(count)]
    start = time.perf_counter()
    data, notes = portfolio(sites, planes)
    wall, times = time.perf_counter() - start, os.times()
    cpu = times.user + times.system + times.children_user + times.children_system
    mean = float(data.irradiation.sum("month").mean())
    print(f"{count} sites by {len(planes)} planes: {wall:.1f} s, {cpu:.1f} CPU s, mean {mean:.1f} kWh m-2")
