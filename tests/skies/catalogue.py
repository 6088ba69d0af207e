"""One of every sky, for the contract tests: name -> a function of (sun, xp-array maker) that makes it."""

import skydome as sd


def irradiances(sun, one):
    """Direct normal and diffuse horizontal irradiance that go with the sun's height."""
    sine = abs(sun[..., 2])
    return one * 900.0 * sine / (sine + 0.3), one * (10.0 + 110.0 * sine)


SKIES = {
    "uniform": lambda sun, one: sd.Uniform(one * 1000.0),
    "moon-spencer": lambda sun, one: sd.MoonSpencer(zenith_luminance=one * 9000.0),
    "cie-1": lambda sun, one: sd.CIE(sun, 1, zenith_luminance=one * 9000.0),
    "cie-12": lambda sun, one: sd.CIE(sun, 12, illuminance=one * 12_000.0),
    "cie-15": lambda sun, one: sd.CIE(sun, 15, illuminance=one * 12_000.0),
    "cie-clear": lambda sun, one: sd.CIEClear(sun, zenith_luminance=one * 3000.0),
    "cie-intermediate": lambda sun, one: sd.CIEIntermediate(sun, one * 3000.0),
    "perez": lambda sun, one: sd.Perez(
        sun, one * -1.0, one * -0.32, one * 10.0, one * -3.0, one * 0.45, illuminance=one * 12_000.0
    ),
    "perez-all-weather": lambda sun, one: sd.PerezAllWeather(sun, *irradiances(sun, one)),
    "perez-gendaylit": lambda sun, one: sd.PerezAllWeather(sun, *irradiances(sun, one), compat="gendaylit"),
    "preetham": lambda sun, one: sd.Preetham(sun, one * 3.2),
    "hosek-wilkie": lambda sun, one: sd.HosekWilkie(sun, one * 3.2, one * 0.3),
    "hosek-wilkie-rgb": lambda sun, one: sd.HosekWilkieRGB(sun, one * 3.2, one * 0.3),
    "daylight": lambda sun, one: sd.Daylight(sd.CIE(sun, 12, illuminance=one * 12_000.0)),
    "blend": lambda sun, one: sd.Blend(
        sd.Preetham(sun, one * 4.0), sd.Daylight(sd.MoonSpencer(zenith_luminance=one * 9000.0)), one * 0.3
    ),
    "doubled": lambda sun, one: sd.HosekWilkie(sun, one * 3.2, one * 0.3) * 2.0,
    "sun-disc": lambda sun, one: sd.SunDisc(sun, one * 3.2),
}
