"""Whatever stands in the place of one argument, at every door: one sentence of ours, never Python's or NumPy's own."""

import inspect
import linecache
import traceback
import warnings
from dataclasses import replace

import numpy as np
import pytest

import skydome as sd

SUN, VIEWS = sd.direction(2.0, 0.7), sd.direction([0.0, 1.0], 0.5)
AROUND = sd.direction(np.linspace(0, 6, 20), np.linspace(0.1, 1.2, 20))
TURIN, NOON = sd.Place(45.07, 7.69), "2026-06-21T12:00+02:00"
NIGHT = "2026-01-03T22:00Z"
AIR = sd.Atmosphere.from_turbidity(3.0)
MOONLIT = replace(sd.clear_air(), sunlight=sd.Spectrum([300.0, 2500.0], [1e-6, 1e-6]))
SKY, HW, DISC = sd.Preetham(SUN, 3.0), sd.HosekWilkie(SUN, 3.0), sd.SunDisc(SUN, 3.0)
WHOLE, MAP, VIEW = HW + DISC, sd.render(HW, 16), sd.Camera(width=32, height=32)
WEATHER = sd.Weather(
    TURIN,
    np.array(["2026-06-21T11"], "M8[s]"),
    np.array(["2026-06-21T12"], "M8[s]"),
    *(np.array([value]) for value in (700.0, 100.0, 8.0)),
)
YEAR = sd.year(WEATHER, patches="tregenza")
LIGHT = sd.on_planes(WEATHER, sd.Plane())
NETWORK = sd.NeuralSky.load("preetham", SUN).network
BASIS = sd.preetham_harmonics(SUN, 3.0)
ANGLES = {"elevation_a": 0.5, "elevation_b": 0.2, "azimuth_difference": 1.0}
LIT, AT = {"sun": SUN, "turbidity": 3.0}, {"directions": VIEWS, "wavelengths": [450.0]}

CALLS = {
    "Place": {"latitude": 45.0, "longitude": 7.0, "altitude": 0.0},
    "direction": {"azimuth": 1.0, "elevation": 0.5},
    "azimuth": {"directions": VIEWS},
    "elevation": {"directions": VIEWS},
    "angle_between": {"a": VIEWS, "b": VIEWS},
    "unit": {"vectors": VIEWS},
    "sun_direction": {"place": TURIN, "time": NOON, "refraction": False},
    "sun_angles": {"place": TURIN, "time": NOON},
    "preetham_sun_direction": {"place": TURIN, "time": NOON},
    "earth_sun_distance": {"time": NOON},
    "solar_radius": {"time": NOON},
    "sun_events": {"place": TURIN, "day": "2026-06-21", "zone": "Europe/Rome"},
    "Spectrum": {"wavelengths": [400.0, 500.0], "values": [1.0, 2.0]},
    "colour_temperature": {"xyz": [1.0, 1.0, 1.0]},
    "duv": {"xyz": [1.0, 1.0, 1.0]},
    "daylight_spectrum": {"xyz": [1.0, 1.0, 1.0], "wavelengths": [400.0, 500.0]},
    "Aerosol": {}, "Molecules": {}, "Ozone": {}, "Atmosphere": {}, "ClearAir": {}, "clear_air": {}, "Junge": {},
    "Cloud": {}, "Water": {}, "Ice": {}, "HexagonalIce": {}, "NitrogenDioxide": {},
    "Lognormal": {"median_radius": 1e-7, "deviation": 2.0},
    "GammaSizes": {"radius": 1e-6, "variance": 0.1},
    "MieParticles": {"sizes": sd.Lognormal(1e-7, 2.0), "count": 10},
    "Uniform": {"value": 100.0},
    "MoonSpencer": {"zenith_luminance": 100.0},
    "CIE": {"sun": SUN, "type": 12, "zenith_luminance": 1e3},
    "CIEClear": {"sun": SUN, "zenith_luminance": 1e3},
    "CIEIntermediate": {"sun": SUN, "zenith_luminance": 1e3},
    "Perez": {"sun": SUN, "a": -1.0, "b": -0.3, "c": 10.0, "d": -3.0, "e": 0.4, "zenith_luminance": 1e3},
    "PerezAllWeather": {"sun": SUN, "direct_normal_irradiance": 700.0, "diffuse_horizontal_irradiance": 100.0},
    "Preetham": LIT, "HosekWilkie": LIT, "HosekWilkieRGB": LIT, "SunDisc": LIT, "PreethamSun": LIT,
    "Daylight": {"sky": sd.Uniform(1.0)},
    "AtmosphereSun": {"sun": SUN, "atmosphere": AIR},
    "CapturedSky": {"map": MAP},
    "physical_sky": {"sun": SUN},
    "PhysicalSky": {"sun": SUN},
    "DiscreteOrdinates": {"sun": SUN, "atmosphere": AIR},
    "Nishita93": {"sun": SUN, "atmosphere": AIR},
    "Nishita96": {"sun": SUN, "atmosphere": AIR},
    "held": {"sky": sd.Nishita93(SUN, AIR)},
    "OvercastSky": {"sun": SUN},
    "overcast_share": {"turbidity": 7.0},
    "blend": {"clear": HW, "overcast": sd.Daylight(sd.Uniform(1.0)), "fraction": 0.5},
    "luminance_series": {"sky": SKY, "directions": VIEWS},
    "clear_zenith_luminance": LIT,
    "overcast_zenith_luminance": {"sun": SUN},
    "render": {"sky": HW, "height": 16, "dtype": np.float32},
    "render_rows": {"sky": HW, "height": 16, "disc": True},
    "render_pixels": {"sky": HW, "height": 16},
    "illuminance": {"sky": HW, "normal": sd.EAST, "ground_albedo": 0.2},
    "irradiance": {"sky": HW, "wavelengths": [450.0, 500.0], "normal": sd.EAST, "ground_albedo": 0.2},
    "patch_means": {"sky": SKY, "division": "tregenza", "tolerance": 1e-2},
    "SphericalHarmonics": {"coefficients": np.ones((3, 9))},
    "sample": {"sky": SKY, "n": 4, "seed": 0},
    "sample_density": {"sky": SKY, "directions": VIEWS},
    "EnvironmentMap": {"pixels": np.ones((4, 8, 3)), "projection": sd.Equirectangular()},
    "load": {"path": "none.exr"},
    "Equirectangular": {"azimuth_left": 0.0},
    "Fisheye": {"coverage": 3.0},
    "target": {"name": "pbrt"},
    "obstructed_illuminance": {"sky": SKY, "surroundings": sd.Horizon([0.0, 1.0, 2.0], [0.1, 0.2, 0.1])},
    "StreetCanyon": {"height": 10.0, "width": 8.0},
    "Horizon": {"azimuths": [0.0, 1.0, 2.0], "elevations": [0.1, 0.2, 0.1]},
    "MeshScene": {"vertices": [[0.0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]},
    "LightInRGB": {},
    "LightInWavelengths": {"wavelengths": [400.0, 500.0]},
    "aerial_perspective": {"sky": WHOLE, "distance": 1e3, "direction": sd.NORTH},
    "AirLight": {"sky": WHOLE},
    "WardLarson": {"air": sd.AirLight(WHOLE)},
    "WardLarsonMeanSky": {"air": sd.AirLight(WHOLE)},
    "Eye": {}, "Camera": {}, "HalfSphere": {}, "StilesHolladay": {}, "CIETotal": {}, "Spencer": {}, "LensFlare": {},
    "PHOTOPIC": {"angle": 0.1},
    "glare": {"environment": MAP, "azimuth": 0.0, "elevation": 0.0, "side": 100},
    "Elevation": {"heights": np.zeros((4, 4)), "dx": 30.0, "dy": 30.0},
    "read_elevation": {"path": "none.tif"},
    "read_weather": {"path": "none.epw"},
    "year": {"weather": "none.epw", "patches": "tregenza"},
    "shader": {"sky": HW},
    "fit": {"model": sd.Preetham, "directions": AROUND, "observed": SKY.luminance(AROUND), "initial": LIT,
            "free": ["turbidity"]},
    "separation_arccos": ANGLES, "separation_haversine": ANGLES, "separation_vincenty": ANGLES,
    "sun_path": {"place": TURIN, "day": "2026-06-21", "step": 60.0},
    "RGBSpace": {"name": "own", "red": (0.64, 0.33), "green": (0.3, 0.6), "blue": (0.15, 0.06), "white": (0.3, 0.3)},
    "meteorological_range": {"turbidity": 3.0},
    "MatsuuraIwata": {"sun": SUN, "zenith_luminance": 1e3},
    "BrungerHooper": {"sun": SUN, "zenith_luminance": 1e3},
    "Igawa": {"sun": SUN, "direct_normal_irradiance": 700.0, "diffuse_horizontal_irradiance": 100.0},
    "ColourByLuminance": {"sky": sd.Uniform(1.0)},
    "ColourOf": {"sky": sd.Uniform(1.0), "like": SKY},
    "NeuralSky": {"sun": SUN, "network": NETWORK},
    "NeuralSpectralSky": {"sun": SUN, "network": NETWORK},
    "PathTraced": {"sun": SUN, "atmosphere": AIR},
    "Prague": {"sun": SUN, "data": "none.dat"},
    "SkyBasis": {"basis": BASIS.basis, "coefficients": BASIS.coefficients[..., 0]},
    "ColourSkyBasis": {"basis": BASIS.basis, "coefficients": BASIS.coefficients},
    "preetham_harmonics": {"sun": SUN, "turbidity": 3.0},
    "EquirectangularOfWidth": {"width": 40},
    "SkyView": {"width": 40},
    "EqualAreaSquare": {}, "CubeMap": {}, "LightInLux": {}, "LightInXYZ": {}, "HoffmanPreetham": {},
    "MESOPIC": {"angle": 0.1}, "SCOTOPIC": {"angle": 0.1},
    "render_terrain": {"elevation": sd.Elevation(np.zeros((4, 4)), 30.0, 30.0), "camera": sd.Camera(width=8, height=8),
                       "sky": WHOLE, "samples": 1},
    "Weather": {"place": TURIN, "start": WEATHER.start, "end": WEATHER.end, "direct_normal": np.array([700.0]),
                "diffuse_horizontal": np.array([100.0]), "dew_point": np.array([8.0])},
    "quality": {"weather": WEATHER},
    "repaired": {"weather": WEATHER},
    "downscaled": {"weather": WEATHER, "minutes": 5},
    "Plane": {},
    "on_planes": {"year": WEATHER, "planes": sd.Plane()},
    "monthly_sums": {"light": LIGHT},
    "cumulative_sky": {"skies": YEAR},
    "shader_numbers": {"sky": HW},
    "save_scene": {"sky": WHOLE, "path": "no/such/sky.usda", "height": 16},
    "ScannedSky": {"scans": ()},
    "moon_direction": {"place": TURIN, "time": NOON}, "moon_angles": {"place": TURIN, "time": NOON},
    "moon_distance": {"place": TURIN, "time": NOON}, "lunar_radius": {"place": TURIN, "time": NOON},
    "moon_phase": {"place": TURIN, "time": NOON}, "planets": {"place": TURIN, "time": NOON},
    "moon_events": {"place": TURIN, "day": "2026-06-21"},
    "Gases": {},
    "HarrisonCoombes": {"sun": SUN, "zenith_luminance": 1e3},
    "Pokrowski": {"sun": SUN, "zenith_luminance": 1e3},
    "TakagiDaylight": {"sky": sd.Uniform(1.0)},
    "takagi_colour_temperature": {"luminance": 1e3},
    "ASRCCIE": {"sun": SUN, "direct_normal_irradiance": 700.0, "diffuse_horizontal_irradiance": 100.0},
    "FlatSpectrum": {"sky": sd.Uniform(1.0)},
    "gensky_sun": {"sun": SUN},
    "PrecomputedScattering": {"sun": SUN, "atmosphere": AIR},
    "Hillaire": {"sun": SUN, "atmosphere": AIR},
    "SkyFromHeight": {"sun": SUN, "atmosphere": AIR},
    "Klassen87": {"sun": SUN},
    "LayeredFog": {"tops": (100.0, 300.0), "extinctions": (1e-2, 1e-3), "ambient": (5000.0, 5200.0, 5600.0)},
    "night_vision": {"picture": MAP},
    "save_spectra": {"sky": HW, "path": "no/such/folder.exr", "wavelengths": [450.0, 550.0]},
    "Moonlight": {"sun": SUN, "atmosphere": MOONLIT},
    "MoonDisc": {"sun": SUN, "atmosphere": MOONLIT, "toward_sun": sd.EAST, "north": sd.NORTH},
    "Airglow": {}, "SkyGlow": {}, "Starlight": {"turn": np.eye(3)}, "ZodiacalLight": {"turn": np.eye(3)},
    "surface_magnitude": {"luminance": 1e-3},
    "v_magnitude": {"sky": HW, "directions": sd.ZENITH},
    "sky_at": {"place": TURIN, "time": NOON},
    "light_at": {"place": TURIN, "times": [NOON]},
    "Cumulus": {}, "Stratocumulus": {}, "Altocumulus": {}, "Cirrus": {}, "CloudField": {},
    "CloudySky": {"clear": sd.PhysicalSky(SUN), "field": sd.CloudField()},
    "CloudTracing": {"sky": sd.CloudySky(sd.PhysicalSky(SUN), sd.CloudField()), "directions": VIEWS},
    "clouds_for": {"dni": 420.0, "dhi": 210.0, "sun": sd.direction(0.0, 0.01)},  # too low a sun: nothing is sought
    "broadband": {"sky": HW}, "uv_index": {"sky": HW}, "photosynthetic_photon_flux": {"sky": HW},
}  # fmt: skip
"""Public names, each with arguments that it takes (but for the file)."""

ANSWERS = {
    "SunEvents", "SunPath", "SkySampler", "PlaneView", "Received", "Bands", "AerialPerspective", "TerrainPicture",
    "SkyScene", "SunLamp", "Fit", "MoonPhase", "MoonEvents", "Planet", "ScatteringTables", "Stars", "Planets",
    "Eclipse", "LunarEclipse", "WholeSky", "Broadband", "MultipleScatteringTable", "ScatteringTextures", "DiffuseField",
    "MeasuredClouds", "ShadowMap",
}  # fmt: skip
"""What functions of ours answer with, or classes made by their own methods; nobody makes them by hand."""

ABSTRACT = {"Sky", "ColourSky", "SpectralSky"}

PAGES = {"explore"}
"""Opens a page; `tests/explorer` asks it."""

METHODS = [
    (HW.luminance, {"directions": VIEWS}),
    (HW.rgb, {"directions": VIEWS, "space": sd.SRGB}),
    (HW.radiance, AT), (SKY.radiance, AT), (DISC.radiance, AT), (sd.PhysicalSky(SUN).radiance, AT),
    (DISC.illuminance, {"normal": sd.EAST}),
    (DISC.of_size, {"angular_radius": 0.01}),
    (sd.SunDisc.of, {"sky": HW}),
    (MAP.illuminance, {"normal": sd.EAST}),
    (MAP.save, {"path": "no/such/folder.exr", "target": "native"}),
    (MAP.rotated, {"angle": 0.1}),
    (sd.CapturedSky(MAP).luminance, {"directions": VIEWS}),
    (sd.Eye().look, {"environment": MAP, "view": VIEW}),
    (sd.LensFlare().look, {"environment": MAP, "view": VIEW}),
    (sd.Atmosphere.from_turbidity, {"turbidity": 3.0}),
    (sd.Weather.from_frame, {"frame": None, "place": TURIN}),
    (sd.Spectrum([400.0, 500.0], [1.0, 2.0]).at, {"wavelengths": [450.0]}),
    (sd.Place.parse, {"text": "45,7"}),
    (sd.LunarEclipse.at, {"time": NIGHT}),
    *((kind.over, {"place": TURIN, "time": NIGHT}) for kind in (
        sd.Stars, sd.Planets, sd.Starlight, sd.ZodiacalLight, sd.Moonlight, sd.MoonDisc, sd.Eclipse)),
]  # fmt: skip

WRONG = {
    "word": "red", "None": None, "words": ["a"], "mapping": {}, "shape": np.zeros((2, 5)), "object": object(),
    "nan": float("nan"), "number": 7.0, "bool": True, "empty": [],
}  # fmt: skip


def not_ours(error):
    """Where an error comes from, if no `raise` of ours made it."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    lines = [linecache.getline(last.filename, k) for k in range(last.lineno - 3, last.lineno + 1)]
    ours = "/skydome/" in last.filename and any("raise " in line for line in lines)
    return "" if ours else f"{type(error).__name__}: {error} ({last.filename}, line {last.lineno})"


def faults(call, good):
    """What is wrong with the answers to one wrong argument at a time."""
    for name, parameter in inspect.signature(call).parameters.items():
        for kind, value in WRONG.items():
            if parameter.kind is parameter.VAR_KEYWORD or (value is None and parameter.default is None):
                continue
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    call(**(good | {name: value}))
            except Exception as error:
                if wrong := not_ours(error):
                    yield f"{name} = {kind}: {wrong}"
                elif len(str(error).splitlines()) != 1 or len(str(error)) > 400:
                    yield f"{name} = {kind}: no line: {error}"


def test_every_public_name_is_asked():
    public = {name for name in sd.WHERE if callable(getattr(sd, name))}
    assert public == CALLS.keys() | ANSWERS | ABSTRACT | PAGES


@pytest.mark.parametrize("name", CALLS)
def test_a_wrong_argument_gets_a_sentence(name):
    assert list(faults(getattr(sd, name), CALLS[name])) == []


@pytest.mark.parametrize(("call", "good"), METHODS, ids=lambda part: getattr(part, "__qualname__", ""))
def test_a_wrong_argument_of_a_method_gets_a_sentence(call, good):
    assert list(faults(call, good)) == []


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: sd.Camera("north"), "azimuth must be a number in .* got str 'north'"),
        (lambda: sd.Eye("x"), "age must be a number in .5, 100. years, .* got str 'x'"),
        (lambda: HW.radiance(sd.ZENITH, "red"), "wavelengths must be numbers, got str 'red'"),
        (lambda: sd.Place("45", 7.0), "latitude must be a number in .* got str '45'"),
        (lambda: sd.render(HW, 16, space="sRGB"), "space must be of kind RGBSpace, as SRGB, got str 'sRGB'"),
        (lambda: sd.Preetham(SUN, "hazy"), "turbidity must be a number in .2, 6., or an array of such, got str 'hazy'"),
        (lambda: sd.Place([45.0, 46.0], 7.0), "latitude must be one number, got list"),
        (lambda: sd.Preetham(SUN, True), "turbidity must be a number in .2, 6., or an array of such, got bool True"),
        (lambda: sd.Preetham(SUN, [True, False]), r"turbidity must be a number .* got list \[True, False\]"),
        (lambda: sd.CloudField(cover=1 + 1e-12), r"cover must lie in .0, 1., got 1\.000000000001"),
        (lambda: sd.CloudField(seed=True), "seed must be a number in .* got bool True"),
        (lambda: HW.luminance(np.array([True, False, False])), "expected an array or a number, got ndarray"),
        (lambda: HW.radiance(sd.ZENITH, [True]), r"wavelengths must be numbers, got list \[True\]"),
        (lambda: sd.LensFlare(ghosts=2.5), "ghosts must be one whole number, got float 2.5"),
        (lambda: sd.Stars.over("x", NIGHT), "place must be of kind Place, as .* got str 'x'"),
        (lambda: sd.MoonDisc.over(TURIN, [NIGHT, NIGHT]), r"time must be one time, got times of shape \(2,\)"),
        (lambda: sd.sky_at(TURIN, NIGHT, glow=6), "glow must be of kind SkyGlow or None, as .* got int 6"),
        (lambda: sd.sky_at(TURIN, NIGHT, only=[]), "only must name one part or more of sky, .* got none"),
        (lambda: sd.sky_at(TURIN, NIGHT, only="mon"), "a part must be one of sky, .* got 'mon'"),
        (lambda: sd.sky_at(TURIN, NOON).without("xx"), "a part must be one of sky, .* got 'xx'"),
        (lambda: sd.surface_magnitude([1.0, 0.0]), "luminance must be above 0 cd m-2, got 0"),
        (lambda: sd.Atmosphere.from_visibility(100.0), r"metres must lie in \[.* m, got 100"),
        (lambda: sd.v_magnitude(HW, -sd.ZENITH), "light toward directions must be above 0 W m-2 sr-1 nm-1 in V, got 0"),
        (lambda: sd.surface_magnitude(-1), "luminance must be above 0 cd m-2, got -1"),
        (lambda: sd.azimuth([1.0, 2.0]), r"directions must have shape \(\.\.\., 3\), got \(2,\)"),
    ],
)
def test_sentences(call, told):
    with pytest.raises((TypeError, ValueError), match=told):
        call()
