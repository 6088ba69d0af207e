"""One of every sky, for the contract tests: name -> a function that makes it.

`SKIES` answer in the sun's own library: made from a sun and a number 1 of any library (contract in `test_contract.py`).
`PHYSICAL` ones compute in NumPy for one sun or many: made from a sun (`test_contract_physical.py`).
"""

import tempfile
from functools import cache
from pathlib import Path

import numpy as np

import skydome as sd
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.clouds.fields.kinds import Slab
from skydome.skies.physical.precomputed.grid import SMALL
from skydome.skies.physical.refitted import Refitted
from skydome.skies.preetham import PreethamNumbers


def irradiances(sun, one):
    """Direct normal and diffuse horizontal irradiance that go with the sun's height."""
    sine = abs(sun[..., 2])
    return one * 900.0 * sine / (sine + 0.3), one * (10.0 + 110.0 * sine)


SKIES = {
    "uniform": lambda sun, one: sd.Uniform(one * 1000.0),
    "moon-spencer": lambda sun, one: sd.MoonSpencer(zenith_luminance=one * 9000.0),
    "overcast": lambda sun, one: sd.OvercastSky(sun, one * 20.0, one * 0.3),
    "cie-1": lambda sun, one: sd.CIE(sun, 1, zenith_luminance=one * 9000.0),
    "cie-12": lambda sun, one: sd.CIE(sun, 12, illuminance=one * 12_000.0),
    "cie-15": lambda sun, one: sd.CIE(sun, 15, illuminance=one * 12_000.0),
    "cie-clear": lambda sun, one: sd.CIEClear(sun, zenith_luminance=one * 3000.0),
    "cie-intermediate": lambda sun, one: sd.CIEIntermediate(sun, one * 3000.0),
    "matsuura-iwata": lambda sun, one: sd.MatsuuraIwata(sun, illuminance=one * 15_000.0),
    "brunger-hooper": lambda sun, one: sd.BrungerHooper(sun, illuminance=one * 12_000.0),
    "harrison-coombes": lambda sun, one: sd.HarrisonCoombes(sun, cloud=0.3, illuminance=one * 12_000.0),
    "pokrowski": lambda sun, one: sd.Pokrowski(sun, illuminance=one * 12_000.0),
    "perez": lambda sun, one: sd.Perez(
        sun, one * -1.0, one * -0.32, one * 10.0, one * -3.0, one * 0.45, illuminance=one * 12_000.0
    ),
    "perez-all-weather": lambda sun, one: sd.PerezAllWeather(sun, *irradiances(sun, one)),
    "perez-gendaylit": lambda sun, one: sd.PerezAllWeather(sun, *irradiances(sun, one), compat="gendaylit"),
    "perez-smooth": lambda sun, one: sd.PerezAllWeather(sun, *irradiances(sun, one), smooth=True),
    "asrc-cie": lambda sun, one: sd.ASRCCIE(
        sun,
        **dict(zip(("direct_normal_irradiance", "diffuse_horizontal_irradiance"), irradiances(sun, one), strict=True)),
    ),
    "igawa": lambda sun, one: sd.Igawa(sun, *irradiances(sun, one)),
    "preetham": lambda sun, one: sd.Preetham(sun, one * 3.2),
    "preetham-authors": lambda sun, one: sd.Preetham(sun, one * 3.2, PreethamNumbers.AUTHORS),
    "hosek-wilkie": lambda sun, one: sd.HosekWilkie(sun, one * 3.2, one * 0.3),
    "hosek-wilkie-rgb": lambda sun, one: sd.HosekWilkieRGB(sun, one * 3.2, one * 0.3),
    "daylight": lambda sun, one: sd.Daylight(sd.CIE(sun, 12, illuminance=one * 12_000.0)),
    "colour-by-luminance": lambda sun, one: sd.ColourByLuminance(sd.CIE(sun, 12, illuminance=one * 12_000.0)),
    "takagi": lambda sun, one: sd.TakagiDaylight(sd.CIE(sun, 12, illuminance=one * 12_000.0)),
    "flat-spectrum": lambda sun, one: sd.FlatSpectrum(sd.CIE(sun, 12, illuminance=one * 12_000.0)),
    "colour-of": lambda sun, one: sd.ColourOf(
        sd.CIE(sun, 12, illuminance=one * 12_000.0), like=sd.Preetham(sun, one * 3.2)
    ),
    "blend": lambda sun, one: sd.blend(
        sd.Preetham(sun, one * 4.0), sd.Daylight(sd.MoonSpencer(zenith_luminance=one * 9000.0)), one * 0.3
    ),
    "doubled": lambda sun, one: sd.HosekWilkie(sun, one * 3.2, one * 0.3) * 2.0,
    "sun-disc": lambda sun, one: sd.SunDisc(sun, one * 3.2),
    "preetham-sun": lambda sun, one: sd.PreethamSun(sun, one * 3.2),
    "neural": lambda sun, one: sd.NeuralSky.load("hosek-wilkie", sun, turbidity=one * 3.2),
    "neural-preetham": lambda sun, one: sd.NeuralSky.load("preetham", sun, turbidity=one * 3.2),
    "neural-spectral": lambda sun, one: sd.NeuralSpectralSky.load(
        "hosek-wilkie-spectral", sun, turbidity=one * 3.2, albedo=one * 0.3
    ),
    "captured": lambda sun, one: sd.CapturedSky(OVERCAST) * one,
    "basis": lambda sun, one: sd.SkyBasis.fit(sd.MoonSpencer(zenith_luminance=9000.0), "steerable", 3) * one,
    "basis-in-colour": lambda sun, one: (
        sd.SkyBasis.fit(sd.Daylight(sd.MoonSpencer(zenith_luminance=9000.0)), "hemispherical", 4) * one
    ),
    "sky-and-sun": lambda sun, one: sd.HosekWilkie(sun, one * 3.2, one * 0.3) + sd.SunDisc(sun, one * 3.2),
}

OVERCAST = sd.render(sd.Daylight(sd.MoonSpencer(zenith_luminance=9000.0)), height=64)
AIR = sd.Atmosphere.standard(aerosol_depth=0.15)


def numbers():
    """A Hosek-Wilkie sky's letters at all suns and wavelengths, as a refitted sky has them; light in sr-1."""
    from skydome.skies.physical.refitted import Numbers

    letters = [0.02, -1.1, -0.3, 0.5, 2.0, -3.0, 0.2, 0.05, 0.6, 0.3]
    elevations, wavelengths = np.radians([1.0, 20.0, 90.0]), np.array([380.0, 580.0, 780.0])
    coefficients = np.broadcast_to(letters, (3, 3, 10)) * np.linspace(1, 1.2, 3)[:, None, None]
    return Numbers(elevations, wavelengths, coefficients, np.zeros((3, 3)))


def prague_file(path):
    """A small file in the layout of the Prague model: 2 of each kind, suns at -4, 2, 30 and 90 degrees, 12 bands."""
    rng = np.random.default_rng(5)
    lists = [[20.0, 131.8], [0.0, 1.0], [0.0, 5000.0], [-4.0, 2.0, 30.0, 90.0]]
    breaks = [np.linspace(0, np.pi, n) for n in (13, 9, 5)]
    counted = b"".join(np.int32(len(part)).tobytes() + np.float64(part).tobytes() for part in lists)
    counted += np.int32(12).tobytes() + np.float64([340.0, 40.0]).tobytes() + np.int32(2).tobytes()
    counted += b"".join(np.int32(len(part)).tobytes() + part.tobytes() for part in breaks)
    skies = []
    for _ in range(2 * 2 * 2 * 4 * 12):
        for _ in range(2):
            sun, zenith = (rng.uniform(0.2, 1, len(part)).astype(np.float16) for part in breaks[:2])
            skies.append(sun.tobytes() + np.float64(7.0).tobytes() + zenith.tobytes())
        skies.append(rng.uniform(0.5, 1, 5).astype(np.float16).tobytes())
    passage = np.int32([3, 4, 2, 2, 2]).tobytes() + np.float32([0.0, 5000.0, 20.0, 131.8]).tobytes()
    passage += rng.uniform(0.3, 0.6, 2 * 3 * 4 * 2).astype(np.float32).tobytes()
    passage += rng.uniform(0.3, 0.6, 2 * 2 * 12 * 2).astype(np.float32).tobytes()
    polarised = np.int32(1).tobytes() + b"".join(np.int32(len(p)).tobytes() + p.tobytes() for p in breaks[:2])
    polarised += rng.uniform(-0.6, 0.6, (2 * 2 * 2 * 4 * 12, 22)).astype(np.float32).tobytes()
    path.write_bytes(counted + b"".join(skies) + passage + polarised)
    return path


OVERCAST_SKY = sd.Daylight(sd.MoonSpencer(zenith_luminance=9000.0))


def scan_of(sky, time=0.0):
    """A scan of a sky on eight rings of 24 samples."""
    from skydome.captures.scans import Scan

    height, around = np.meshgrid(np.radians([6, 18, 30, 42, 54, 66, 78, 88]), np.arange(24) * np.pi / 12, indexing="ij")
    views = sd.direction(around.ravel(), height.ravel())
    return Scan(views, np.broadcast_to(sd.SOUTH, views.shape), np.asarray(sky.rgb(views)), time)


@cache
def tables():
    """Tables of scattered light that all suns share."""
    return sd.ScatteringTables.of(AIR, NODES, 2, SMALL)


@cache
def psi():
    """Hillaire's table."""
    return sd.MultipleScatteringTable.of(AIR, NODES)


@cache
def field():
    """The light inside the air."""
    return sd.DiffuseField.of(AIR, NODES)


PRAGUE = prague_file(Path(tempfile.mkdtemp()) / "prague.dat")

PHYSICAL = {
    "prague": lambda sun: sd.Prague(sun, PRAGUE),
    "scanned": lambda sun: sd.ScannedSky((scan_of(OVERCAST_SKY),)),
    "klassen-87": lambda sun: sd.Klassen87(sun, AIR),
    "nishita-93": lambda sun: sd.Nishita93(sun, AIR),
    "nishita-96": lambda sun: sd.Nishita96(sun, AIR, rings=4),
    "discrete-ordinates": lambda sun: sd.DiscreteOrdinates(sun, AIR),
    "mars": lambda sun: sd.Nishita93(sun, sd.Atmosphere.mars()),
    "refitted": lambda sun: Refitted(sun, numbers()),
    "path-traced": lambda sun: sd.PathTraced(sun, AIR, relative_error=0.5),
    "held": lambda sun: sd.held(sd.Nishita93(sun, AIR)),
    "precomputed": lambda sun: sd.PrecomputedScattering.by(tables(), sun),
    "hillaire": lambda sun: sd.Hillaire.by(psi(), sun),
    "from-height": lambda sun: sd.SkyFromHeight.by(field(), sun),
    "physical-sky": lambda sun: sd.PhysicalSky(sun, sd.clear_air(0.15)),
    "cloudy": lambda sun: sd.CloudySky(sd.PhysicalSky(sun), sd.CloudField(Slab(), cover=1.0, extinction=0.002)),
    "physical": lambda sun: sd.physical_sky(sun, AIR, relative_error=0.5),
    "atmosphere-sun": lambda sun: sd.AtmosphereSun(sun, AIR),
    "captured-square": lambda sun: sd.CapturedSky(OVERCAST.resampled(sd.EqualAreaSquare(), 128)),
    "captured-with-sun": lambda sun: sd.CapturedSky(
        sd.render(sd.HosekWilkie(sun if sun[2] > 0 else -sun, 3.0), height=64), sun
    ),
}
ONE_SUN = ("path-traced", "held", "captured-with-sun", "cloudy")
"""Those that have one sun."""
LOWEST = {
    "nishita-93": -12.0,
    "nishita-96": -12.0,
    "mars": -12.0,
    "path-traced": -12.0,
    "held": -12.0,
    "precomputed": -8.0,
    "hillaire": -4.0,
    "from-height": -4.0,
    "physical-sky": -18.0,
    "cloudy": -18.0,
    "physical": -12.0,
    "prague": -4.0,
}
"""Elevation of the sun, degrees, at which the light of those ends that have some when it has set; of others 0."""
ANY_SUN = ("captured-square", "captured-with-sun", "scanned")
"""Those whose light was captured, wherever the sun stood."""
