"""Random calls of the library: numbers from beyond, odd shapes and kinds; light that is light, or one sentence."""

import random
import warnings

import numpy as np

import skydome as sd

NUMBERS = [
    0.0,
    1.0,
    -1.0,
    0.2,
    3.0,
    5.5,
    10.0,
    284.0,
    800.0,
    1e9,
    1e300,
    -1e300,
    1e-300,
    float("nan"),
    float("inf"),
    -float("inf"),
    1,
    -3,
    True,
    None,
    "3",
    [],
    [3.0],
    (1.0, 2.0),
    np.float32(2.5),
    np.float16(2.5),
    np.array([2.0, 3.0]),
    np.array([]),
    np.array([[2.0], [3.0]]),
    np.array(["a"]),
    3 + 1j,
    {},
]
GOOD = [0.0, 0.2, 1.0, 3.0, 5.0, 100.0, 800.0]
SUNS = [
    np.array([0.0, 0.6, 0.8]),
    np.array([0.0, 0.999, 0.0447]),
    np.array([0.0, 0.0, 1.0]),
    np.array([0.0, 0.6, -0.8]),
    np.array([[0.0, 0.6, 0.8], [0.6, 0.0, 0.8]]),
    [0.0, 0.6, 0.8],
]
BAD_SUNS = [
    np.zeros(3),
    np.ones(3),
    np.array([np.nan, 0, 1]),
    np.ones((2, 2)),
    [],
    None,
    "south",
    3.0,
    np.array([0, 0, 1]),
]
VIEWS = [
    np.array([0.0, 0.0, 1.0]),
    np.array([[0.0, 0.6, 0.8], [1.0, 0.0, 0.0]]),
    np.array([0.0, 0.6, 0.8], np.float32),
    np.array([0.0, 0.6, -0.8]),
    np.zeros((0, 3)),
    np.array([0.0, 1.0, 1e-17]),
]
BAD_VIEWS = [
    np.zeros(3),
    [],
    None,
    "up",
    True,
    np.ones((3, 2)),
    np.array([np.inf, 0, 0]),
    np.array([0, 0, 1], np.float16),
]


def made(chance):
    """A sky, of parameters drawn; whatever it raises is the caller's."""

    def number(sense=0.75):
        return chance.choice(GOOD if chance.random() < sense else NUMBERS)

    sun = chance.choice(SUNS if chance.random() < 0.85 else BAD_SUNS)
    check = {"check": chance.choice(["raise", "clamp", "nan", "raise", "x"])}
    kinds = [
        lambda: sd.Preetham(sun, number(), **check),
        lambda: sd.HosekWilkie(sun, number(), number(), **check),
        lambda: sd.HosekWilkieRGB(sun, number(), number(), **check),
        lambda: sd.Perez(sun, *(number() for _ in range(5)), illuminance=number(), **check),
        lambda: sd.PerezAllWeather(sun, number(), number(), dew_point=number(), **check),
        lambda: sd.CIE(sun, chance.choice([1, 7, 15, 0, 99, 1.5, None]), zenith_luminance=number(), **check),
        lambda: sd.CIEClear(sun, illuminance=number(), **check),
        lambda: sd.CIEIntermediate(sun, number(), **check),
        lambda: sd.Uniform(number(), **check),
        lambda: sd.MoonSpencer(zenith_luminance=number(), illuminance=number() if chance.random() < 0.2 else None),
        lambda: sd.SunDisc(sun, number(), **check),
        lambda: sd.SunDisc(sun, 3.0, direct_normal_illuminance=number(), **check),
        lambda: sd.blend(sd.Uniform(1.0), sd.Preetham(sun, 3.0), number()),
        lambda: sd.Preetham(sun, 3.0) + number() * sd.Uniform(1.0),
        lambda: sd.Daylight(sd.Uniform(1.0), (number(), number())),
    ]
    return chance.choice(kinds)()


def asked(chance, sky):
    """The light of a sky, by one of its methods."""
    views = chance.choice(VIEWS if chance.random() < 0.85 else BAD_VIEWS)
    wavelengths = chance.choice([[450.0, 550.0], [550.0], [], [np.nan], [700.0, 400.0], None, 550.0, [-1.0, 5.0]])
    methods = [
        lambda: sky.luminance(views),
        lambda: sky.luminance(views),
        lambda: sky.xyz(views),
        lambda: sky.rgb(views),
        lambda: sky.radiance(views, wavelengths),
        lambda: sd.illuminance(sky, views),
        lambda: sd.render(sky, chance.choice([16, 15, 0, -2, 1 << 40, 16.5, None])).pixels,
    ]
    return chance.choice(methods)()


def unsound(sky, light, signed):
    """What is wrong with light, "" for nothing: NaN is said only where it was asked for."""
    values = np.asarray(light)
    if values.dtype.kind != "f":
        return f"light of {values.dtype}"
    if not np.isfinite(values).all() and "nan" not in str(sky.parameters()):
        return f"light is not finite: {values.ravel()[:3]}"
    lit = values[np.isfinite(values)]
    if not signed and "'weights': [-" not in str(sky.parameters()) and lit.min(initial=0.0) < 0:
        return f"light is negative: {lit.min()}"
    return ""


def run(count, seed=0, report=lambda done: None):
    """The faults of so many calls, each with the number that draws it again."""
    found = []
    for k in range(count):
        chance, sky = random.Random(f"{seed} {k}"), None
        try:
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                sky = made(chance)
                state = chance.getstate()
                light = asked(chance, sky)
                chance.setstate(state)
                chance.choice(VIEWS)
            wrong = unsound(sky, light, signed=np.shape(light)[-1:] == (3,))
            if wrong:
                found.append((k, type(sky).__name__, wrong, str(sky.parameters())[:200]))
        except (ValueError, TypeError, AttributeError) as error:
            if isinstance(error, AttributeError) and "object has no attribute" not in str(error):
                found.append((k, repr(error)))
            elif "\n" in str(error) or not str(error):
                found.append((k, f"not one line: {error!r}"))
        except Exception as error:
            found.append((k, type(sky).__name__, repr(error)[:200]))
        report(k + 1)
    return found


if __name__ == "__main__":
    import sys
    from collections import Counter

    faults = run(int(sys.argv[1]), int(sys.argv[2]))
    print(len(faults), "faults", Counter(str(fault[1]) for fault in faults).most_common(20))
    for fault in faults[:40]:
        print(fault)
