"""Light through dusk against published tables, and what the night costs.

python benchmarks/night.py light | zenith | tracer | speed | first
"""

import sys
import time

import numpy as np

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import xyz_weights
from skydome.sun.refraction import standard_pressure

PLACE, NEW_MOON = sd.Place(50.0, 8.0), np.datetime64("2026-04-16T17:00")

SEIDELMANN = (
    (5.0, -0.8, (2.88, 22.26, -207.64, 1034.30)),
    (-0.8, -5.0, (2.88, 21.81, -258.11, -858.36)),
    (-5.0, -12.0, (2.70, 12.17, -431.69, -1899.83)),
    (-12.0, -18.0, (13.84, 262.72, 1447.42, 2797.93)),
)
"""Elevations between which log10 of lx is a polynomial of the elevation over 90 degrees (Seidelmann 1992)."""


FAINT = ("airglow", "zodiacal light", "starlight")
"""The faint glows by their names in `sky_at`."""


def seidelmann(elevation: float) -> float:
    """Illuminance by the table, lx."""
    for upper, lower, powers in SEIDELMANN:
        if lower <= elevation <= upper:
            return float(10 ** np.polynomial.polynomial.polyval(elevation / 90, powers))
    return float("nan")


def light() -> None:
    """The light on the level by the sun's elevation in two airs, over the table's; the largest fall within a minute."""
    minutes = NEW_MOON + np.arange(0, 260) * np.timedelta64(1, "m")
    heights = np.degrees(np.arcsin(sd.sun_direction(PLACE, minutes)[:, 2]))
    dusk = {depth: sd.light_at(PLACE, minutes, sd.clear_air(depth)) for depth in (0.1, 0.3)}
    for elevation in (0.0, -1.0, -2.5, -4.0, -6.0, -8.0, -10.0, -12.0, -15.0, -18.0):
        wanted = seidelmann(elevation)
        row = [np.exp(np.interp(-elevation, -heights, np.log(found.total))) for found in dusk.values()]
        print(f"{elevation:6.1f} table {wanted:.4g} lx;", ", ".join(f"{lx:.4g} ({lx / wanted:.2f})" for lx in row))
    steps = np.diff(np.log(dusk[0.1].total))
    print(f"largest fall within a minute {1 - np.exp(steps.min()):.3f} at {heights[steps.argmin()]:.1f} degrees")
    print("at the end:", {name: f"{part[-1]:.2g}" for name, part in dusk[0.1].parts.items()})
    for name in FAINT:
        whole = sd.sky_at(PLACE, minutes[-1], only=name)
        print(f"{name}: zenith {float(sd.v_magnitude(whole, sd.ZENITH)):.2f} mag arcsec-2 in V")


BETWEEN_STARS = 15.0
"""Starlight left between the stars that photometers leave out, stars of the 10th magnitude a square degree."""


def zenith() -> None:
    """Dark zeniths in V, each hour of a night a week through 2026: with all starlight, and between the stars."""
    for where, latitude, altitude in (("La Palma", 28.76, 2400.0), ("Paranal", -24.6, 2600.0), ("45 N", 45.0, 500.0)):
        place = sd.Place(latitude, 0.0, altitude=altitude)
        air = sd.clear_air(0.05 if altitude > 1500 else 0.1, pressure=float(standard_pressure(altitude)))
        weeks = np.datetime64("2026-01-01T00:00") + np.arange(52) * np.timedelta64(7, "D")
        times = (weeks[:, None] + np.arange(-6, 7) * np.timedelta64(1, "h")).ravel()
        dark = times[sd.sun_direction(place, times)[:, 2] < np.sin(np.radians(-18.0))]
        dust = [tenth_stars(sd.ZodiacalLight.over(place, time, air)) for time in dark]
        stars = [tenth_stars(sd.Starlight.over(place, time, air)) for time in dark]
        print(f"{where}, {len(dark)} hours: zodiacal light {spread(dust, 0)}, starlight {spread(stars, 0)}")
        for flux in (70.0, 100.0, 129.0, 200.0):
            airglow = tenth_stars(sd.Airglow(air, solar_flux=flux))
            for of, light in (("all starlight", np.array(stars)), ("between the stars", BETWEEN_STARS)):
                found = 27.78 - 2.5 * np.log10(airglow + np.array(dust) + light)
                inside = np.mean((found >= 21.6) & (found <= 22.1))
                print(f"  flux {flux:g}, airglow {airglow:.0f}, {of}: {spread(found, 2)}, {inside:.0%} in 21.6-22.1")


def tenth_stars(sky: sd.Sky) -> float:
    """The zenith in V, stars of the 10th magnitude a square degree."""
    return float(10 ** (-0.4 * (sd.v_magnitude(sky, sd.ZENITH) - 27.78)))


def spread(values: list[float] | np.ndarray, digits: int) -> str:
    """Least, median, most."""
    return " / ".join(f"{value:.{digits}f}" for value in np.percentile(values, [0, 50, 100]))


def tracer() -> None:
    """Light of civil twilight on the level by the path tracer and by the physical sky, over the table's."""
    views, angles = hemisphere(10, 12)
    bands = np.arange(420.0, 681.0, 20.0)
    luminous = xyz_weights(bands)[:, 1]
    for elevation in (-1.0, -2.5, -4.0, -6.0):
        sun, wanted = sd.direction(0.0, elevation * sd.deg), seidelmann(elevation)
        for depth in (0.006, 0.0):
            air = sd.clear_air(stratospheric_depth=depth)
            traced = [
                sd.PathTraced(sun, air, refraction=bent).job(views, bands).start().more(60).radiance
                for bent in (False, True)
            ]
            light = [*traced, sd.PhysicalSky(sun, air).radiance(views, bands)]
            level = [float((angles * views[:, 2]) @ one @ luminous) / wanted for one in light]
            told = zip(("straight rays", "bent", "the physical sky"), level, strict=True)
            print(f"{elevation:5.1f}, stratosphere {depth:g}:", ", ".join(f"{name} {x:.2f}" for name, x in told))


def speed() -> None:
    """CPU seconds; the first call of a new process is `python benchmarks/night.py first`."""
    quarters = np.datetime64("2026-01-18T12:00") + np.arange(96) * np.timedelta64(15, "m")
    start = time.process_time()
    sd.light_at(PLACE, quarters)
    print(f"light_at, 96 quarter hours: {time.process_time() - start:.1f} CPU seconds")
    start = time.process_time()
    for hour in quarters[::4]:
        sd.render(sd.sky_at(PLACE, hour), 512)
    print(f"24 frames of 1024 x 512: {(time.process_time() - start) / 24:.2f} CPU seconds each")


def first() -> None:
    """`sky_at` under a full moon and its map 2048 x 1024, from the import on (the process so far)."""
    sky = sd.sky_at(PLACE, "2026-01-03T22:00Z")
    between = time.process_time()
    sd.render(sky, 1024)
    print(f"sky {between:.2f}, map {time.process_time() - between:.2f}, whole {time.process_time():.2f} CPU seconds")


if __name__ == "__main__":
    {"light": light, "zenith": zenith, "tracer": tracer, "speed": speed, "first": first}[sys.argv[1]]()
