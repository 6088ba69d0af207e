"""Minutes made of hours against minutes measured: `python benchmarks/minutes.py bsrn-pay0616.dat.gz 46.815,6.944,491`.

The file is one month of a station of the Baseline Surface Radiation Network (station-to-archive; that of Payerne, June
2016, is among the tests' data of pvlib's source). Its hourly means are made into minutes by ten seeds.
"""

import sys
import warnings

import numpy as np
from pvlib.iotools import read_bsrn

import skydome as sd
from skydome.years.downscaling.skartveit_olseth import CLASSES
from skydome.years.quality.checks import Looked
from skydome.years.quality.clear_sky import ineichen
from skydome.years.quality.report import HIGH_SUN, monthly_turbidity

SEEDS = range(10)


def figures(weather, whole, linke, step):
    """Standard deviation within the hour in four classes of its clear-sky index, then of all hours, and the changes."""
    looked = Looked.at(weather)
    clear = ineichen(looked.zenith, looked.extraterrestrial, weather.place.altitude, linke).global_horizontal
    index = np.where(looked.cosine > HIGH_SUN, whole / np.maximum(clear, 1e-9), np.nan)
    by_hour = index.reshape(-1, 60 // step)
    by_hour = by_hour[np.isfinite(by_hour).all(axis=1)]
    group, spread = np.searchsorted(CLASSES, by_hour.mean(axis=1)), by_hour.std(axis=1)
    change = np.abs(np.diff(by_hour, axis=1)).ravel()
    direct = weather.direct_normal[np.isfinite(index)]
    return [
        *(spread[group == k].mean() for k in range(4)), spread.mean(), change.mean(), (change > 0.1).mean(),
        (by_hour > 1.1).mean(), (direct > 500).mean(), (direct < 50).mean(),
    ]  # fmt: skip


def main(file, place):
    warnings.simplefilter("ignore")
    data = read_bsrn(file)[0][["ghi", "dni", "dhi"]]
    hourly = data.resample("1h").agg(lambda values: values.mean() if values.notna().sum() > 55 else np.nan)
    record = sd.Weather.from_frame(hourly, place, label="start", seconds=3600)
    linke = np.nanmean(monthly_turbidity(Looked.at(record)))
    names = "sd <.3  .3-.6  .6-.9  >.9    all change  >.1   >1.1 dni>500 <50"
    print(f"{'':12} {names}")
    for step in (1, 5, 15):
        finer = data.resample(f"{step}min").mean()
        measured = sd.Weather.from_frame(finer[["dni", "dhi"]], place, label="start", seconds=60 * step)
        rows = [figures(measured, finer["ghi"].values, linke, step)]
        made = [sd.downscaled(record, step, seed) for seed in SEEDS]
        each = np.array([figures(fine, fine.global_horizontal, linke, step) for fine in made])
        rows += [each.mean(axis=0), each.std(axis=0)]
        for name, row in zip(("measured", "made", "of seeds"), rows, strict=True):
            print(f"{step:2} {name:9} " + " ".join(f"{value:6.3f}" for value in row))


if __name__ == "__main__":
    main(sys.argv[1], sd.Place.parse(sys.argv[2]))
