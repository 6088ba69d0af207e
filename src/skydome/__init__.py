"""skydome: the light of the sky in every direction, by the published models, in stated units and one frame.

Frame: x east, y north, z up; azimuth clockwise from north; directions point toward the light. Angles in radians
(`30 * deg`), places in degrees, wavelengths in nm, luminance in cd m-2, spectral radiance in W m-2 sr-1 nm-1.
"""

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

HOME = {
    "ground.units": "deg km",
    "ground.directions": "ZENITH NORTH EAST SOUTH WEST direction azimuth elevation angle_between unit "
    "separation_arccos separation_haversine separation_vincenty",
    "sun.place": "Place",
    "sun.position": "sun_direction sun_angles earth_sun_distance solar_radius",
    "sun.preetham_position": "preetham_sun_direction",
    "sun.events": "sun_events SunEvents",
    "sun.path": "sun_path SunPath",
    "moon.position": "moon_direction moon_angles moon_distance lunar_radius",
    "moon.phase": "moon_phase MoonPhase",
    "moon.events": "moon_events MoonEvents",
    "stars.planets": "planets Planet",
    "light.spectrum": "Spectrum",
    "light.colour": "SRGB SRGB_PRINTED REC2020 ACESCG RADIANCE RGBSpace",
    "light.colour_temperature": "colour_temperature duv",
    "light.daylight": "daylight_spectrum",
    "air.atmosphere": "Atmosphere",
    "air.constituents": "Aerosol Molecules NitrogenDioxide Ozone",
    "air.gases.gases": "Gases",
    "air.clouds.cloud": "Cloud",
    "air.clouds.particles": "Water Ice",
    "air.clouds.crystals.hexagonal_ice": "HexagonalIce",
    "air.mie": "MieParticles",
    "air.size_distributions": "Lognormal Junge GammaSizes",
    "air.transmittance": "ClearAir",
    "air.turbidity": "meteorological_range",
    "skies.sky": "Sky",
    "skies.colour_sky": "ColourSky SpectralSky",
    "skies.clouds.blend": "blend overcast_share",
    "skies.uniform": "Uniform MoonSpencer",
    "skies.clouds.overcast": "OvercastSky",
    "skies.cie": "CIE CIEClear CIEIntermediate",
    "skies.formula.older.matsuura_iwata": "MatsuuraIwata",
    "skies.formula.older.brunger_hooper": "BrungerHooper",
    "skies.formula.older.harrison_coombes": "HarrisonCoombes",
    "skies.formula.older.pokrowski": "Pokrowski",
    "skies.formula.older.takagi": "TakagiDaylight takagi_colour_temperature",
    "skies.formula.older.asrc_cie": "ASRCCIE",
    "skies.formula.level": "clear_zenith_luminance overcast_zenith_luminance",
    "skies.perez": "Perez",
    "skies.perez_all_weather": "PerezAllWeather",
    "skies.formula.igawa": "Igawa",
    "skies.preetham": "Preetham",
    "skies.hosek_wilkie": "HosekWilkie HosekWilkieRGB",
    "skies.wrapped.daylight_sky": "Daylight FlatSpectrum ColourByLuminance ColourOf",
    "skies.suns.sun_disc": "SunDisc",
    "skies.suns.preetham_sun": "PreethamSun",
    "skies.suns.gensky_sun": "gensky_sun",
    "skies.suns.atmosphere_sun": "AtmosphereSun",
    "skies.neural.sky": "NeuralSky NeuralSpectralSky",
    "skies.captured": "CapturedSky",
    "skies.physical.choice": "physical_sky",
    "skies.all_air.from_heights.diffuse_field": "DiffuseField",
    "skies.all_air.from_heights.sky": "SkyFromHeight",
    "skies.all_air.sky": "PhysicalSky",
    "skies.all_air.taught_air": "clear_air",
    "skies.physical.discrete_ordinates": "DiscreteOrdinates",
    "skies.physical.nishita": "Nishita93 Nishita96",
    "skies.physical.klassen": "Klassen87",
    "skies.physical.held": "held",
    "skies.path_tracing.sky": "PathTraced",
    "skies.physical.precomputed.tables": "ScatteringTables",
    "skies.physical.precomputed.sky": "PrecomputedScattering",
    "skies.physical.precomputed.textures": "ScatteringTextures",
    "skies.physical.precomputed.hillaire": "Hillaire MultipleScatteringTable",
    "skies.physical.prague.sky": "Prague",
    "skies.night.moon.moonlight": "Moonlight",
    "skies.night.moon.moon_disc": "MoonDisc",
    "skies.night.moon.lunar_eclipse": "LunarEclipse",
    "skies.night.stars": "Stars Planets",
    "skies.night.starlight": "Starlight",
    "skies.night.zodiacal": "ZodiacalLight",
    "skies.night.airglow": "Airglow",
    "skies.night.skyglow": "SkyGlow",
    "skies.night.magnitudes": "surface_magnitude v_magnitude",
    "skies.night.eclipse": "Eclipse",
    "skies.night.sky_at": "sky_at WholeSky",
    "skies.night.through_time": "light_at",
    "skies.clouds.fields.field": "CloudField",
    "skies.clouds.fields.kinds": "Cumulus Stratocumulus Altocumulus Cirrus",
    "skies.clouds.fields.sky": "CloudySky",
    "skies.clouds.fields.reference": "CloudTracing",
    "skies.clouds.fields.shadows": "ShadowMap",
    "skies.series": "luminance_series",
    "dome.render": "render",
    "dome.map_rows": "render_rows",
    "dome.render_pixels": "render_pixels",
    "dome.integrals": "illuminance irradiance",
    "dome.energy.broadband": "broadband Broadband",
    "dome.energy.measured_clouds": "clouds_for MeasuredClouds",
    "dome.energy.doses": "uv_index photosynthetic_photon_flux",
    "dome.patch_means": "patch_means",
    "dome.harmonics": "SphericalHarmonics",
    "dome.bases.sky_basis": "SkyBasis ColourSkyBasis",
    "dome.bases.preetham_harmonics": "preetham_harmonics",
    "dome.sampling": "SkySampler sample sample_density",
    "maps.environment_map": "EnvironmentMap",
    "maps.loading": "load",
    "maps.equirectangular": "Equirectangular EquirectangularOfWidth",
    "maps.sky_view": "SkyView",
    "maps.equal_area_square": "EqualAreaSquare",
    "maps.cube": "CubeMap",
    "maps.fisheye": "Fisheye",
    "maps.targets": "target",
    "surroundings.obstruction": "obstructed_illuminance PlaneView Received",
    "surroundings.bands": "Bands",
    "surroundings.canyon": "StreetCanyon",
    "surroundings.horizon": "Horizon",
    "surroundings.mesh": "MeshScene",
    "surroundings.light_kinds": "LightInLux LightInXYZ LightInRGB LightInWavelengths",
    "haze.aerial_perspective": "aerial_perspective AerialPerspective AirLight",
    "haze.uniform_density": "HoffmanPreetham",
    "haze.layered_fog": "LayeredFog",
    "haze.ward_larson": "WardLarson WardLarsonMeanSky",
    "eye.eye": "Eye",
    "eye.night_vision": "night_vision",
    "eye.view": "Camera HalfSphere",
    "eye.glare": "glare",
    "eye.point_spread": "StilesHolladay CIETotal Spencer PHOTOPIC MESOPIC SCOTOPIC",
    "eye.lens_flare": "LensFlare",
    "land.picture": "render_terrain",
    "land.terrain_picture": "TerrainPicture",
    "land.elevation": "Elevation",
    "land.reading": "read_elevation",
    "years.weather.weather": "Weather",
    "years.weather.reading": "read_weather",
    "years.quality.report": "quality",
    "years.quality.repairs": "repaired",
    "years.downscaling.downscaled": "downscaled",
    "years.skies.series": "year",
    "years.planes.plane": "Plane",
    "years.planes.light": "on_planes",
    "years.planes.sums": "monthly_sums cumulative_sky",
    "export.shaders": "shader shader_numbers",
    "export.spectral_pictures": "save_spectra",
    "export.scenes.saving": "save_scene",
    "export.scenes.scene": "SkyScene",
    "export.scenes.sun_lamp": "SunLamp",
    "fitting.fit": "fit Fit",
    "captures.scanned_sky": "ScannedSky",
    "explorer.widget": "explore",
}
"""Module -> its public names, in the order of reading; a module is imported when a name of it is first asked for.

`scripts/make_face.py` writes from it what type checkers read (`__init__.pyi`) and what people read (`docs/api.md`).
"""

WHERE = {name: f"skydome.{module}" for module, names in HOME.items() for name in names.split()}

__all__ = ["__version__", *WHERE]


def __getattr__(name: str) -> Any:
    """Import a public name from its home on first use."""
    if name not in WHERE:
        raise AttributeError(f"module 'skydome' has no attribute {name!r}")
    value = getattr(import_module(WHERE[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Every public name."""
    return sorted(__all__)
