# ruff: noqa: E501
"""Make the tables of the air: the sun above the air, ozone, gases, Rayleigh scattering, grass.

Run: python scripts/make_air_tables.py
"""

from pathlib import Path

import numpy as np

DATA = Path(__file__).parents[1] / "src" / "skydome" / "ground" / "data"
DOBSON_CM = 2.6867e19  # molecules cm-2 in a centimetre of ozone at standard pressure and temperature
CHAPPUIS = """1.18e-27 2.182e-28 2.818e-28 6.636e-28 1.527e-27 2.763e-27 5.52e-27 8.451e-27 1.582e-26 2.316e-26 3.669e-26
4.924e-26 7.752e-26 9.016e-26 1.48e-25 1.602e-25 2.139e-25 2.755e-25 3.091e-25 3.5e-25 4.266e-25 4.672e-25 4.398e-25
4.701e-25 5.019e-25 4.305e-25 3.74e-25 3.215e-25 2.662e-25 2.238e-25 1.852e-25 1.473e-25 1.209e-25 9.423e-26 7.455e-26
6.566e-26 5.105e-26 4.15e-26 4.228e-26 3.237e-26 2.451e-26 2.801e-26 2.534e-26 1.624e-26 1.465e-26 2.078e-26 1.383e-26
7.105e-27"""
NITROGEN_DIOXIDE = """1.32 1.61 1.88 2.16 2.53 2.87 3.17 3.58 4.02 4.18 4.62 4.97 5.09 5.49 5.61 5.90 5.93 6.01 6.30 5.97 6.44
5.82 6.24 5.91 5.99 5.70 5.44 5.59 4.88 4.88 4.98 4.16 4.36 4.14 3.37 3.87 3.37 2.54 3.08 2.94 1.82 2.43 2.31 1.60 1.61
1.79 1.53 1.06 1.08 1.27 1.10 .797 .605 .870 .848 .471 .447 .469 .539 .408 .395 .185 .254 .353 .257 .196 .121 .133 .153
.192 .135 .0873 .0566"""  # 1e-19 cm2


def hat_means(knots, known, values, half_width):
    """Means of a spectrum under triangles of the given half width about each knot."""
    fine = np.arange(known[0], known[-1] + 0.125, 0.25)
    spectrum = np.interp(fine, known, values)
    hats = np.maximum(0.0, 1 - np.abs(fine - knots[:, None]) / half_width)
    return (hats @ spectrum) / hats.sum(axis=1)


def write(name, header, heading, rows):
    lines = [f"# {line}" for line in header] + [heading] + [",".join(f"{v:.6g}" for v in row) for row in rows]
    (DATA / f"{name}.csv").write_text("\n".join(lines) + "\n", "utf-8")


def sun():
    from pvlib.spectrum import get_reference_spectra

    table = get_reference_spectra(standard="ASTM G173-03")["extraterrestrial"]
    spans = (np.arange(290.0, 1101.0, 5.0), np.arange(1110.0, 2501.0, 10.0), np.arange(2550.0, 3951.0, 50.0))
    knots = np.concatenate(spans)
    known, light = table.index.to_numpy(), table.to_numpy()
    values = np.concatenate(
        [hat_means(span, known, light, width) for span, width in zip(spans, (5, 10, 50), strict=True)]
    )
    write(
        "solar_astm_g173",
        [
            "Solar spectral irradiance above the air at 1 AU, W m-2 nm-1: ASTM G173-03, extraterrestrial column (Gueymard),",
            "as pvlib carries it; mean under a triangle about each wavelength of 5 nm half width, 10 beyond 1100 nm, 50 beyond 2500.",
            "Made by scripts/make_air_tables.py.",
        ],
        "wavelength_nm,irradiance",
        np.stack([knots, values], axis=-1),
    )


def ozone():
    from pvlib.spectrum.spectrl2 import _SPECTRL2_COEFFS as SPECTRL2

    use = SPECTRL2["wavelength"] <= 350
    short = np.stack([SPECTRL2["wavelength"][use], SPECTRL2["ozone_absorption"][use] / DOBSON_CM * 1e-4], axis=-1)
    values = np.array([float(v) for v in CHAPPUIS.split()])
    long = np.stack([365.0 + 10 * np.arange(values.size), values], axis=-1)
    write(
        "ozone_cross_section",
        [
            "Absorption cross section of ozone, m2 per molecule.",
            "300-350 nm (Hartley-Huggins): Leckner 1978 in Bird and Riordan 1986 (SPECTRL2), as pvlib carries it, / 2.6867e23 m-3.",
            "365-835 nm (Chappuis): Serdyuchenko, Gorshelev et al. 2014, University of Bremen, 233 K, means over 10 nm about the",
            "wavelength, as E. Bruneton lists them (precomputed_atmospheric_scattering, 2017). Made by scripts/make_air_tables.py.",
        ],
        "wavelength_nm,cross_section",
        np.concatenate([short, long]),
    )


def nitrogen_dioxide():
    edges = np.concatenate([[298.507, 303.030, 307.692], np.arange(312.5, 663.0, 5.0)])
    values = np.array([float(v) for v in NITROGEN_DIOXIDE.split()]) * 1e-23
    write(
        "nitrogen_dioxide_cross_section",
        [
            "Absorption cross section of nitrogen dioxide at 294 K, m2 per molecule, means over about 5 nm about the wavelength:",
            "Sander et al. 2006, Chemical Kinetics and Photochemical Data for Use in Atmospheric Studies, Evaluation 15 (JPL",
            "Publication 06-2, of the United States' government), from Vandaele et al. 1998. Made by scripts/make_air_tables.py.",
        ],
        "wavelength_nm,cross_section",
        np.stack([(edges[:-1] + edges[1:]) / 2, values], axis=-1),
    )


def gases():
    from pvlib.spectrum.spectrl2 import _SPECTRL2_COEFFS as SPECTRL2

    write(
        "spectrl2_gases",
        [
            "Absorption of water vapour, cm-1, and of the uniformly mixed gases by wavelength: Bird and Riordan 1986 (SPECTRL2),",
            "table 2-2, after Leckner 1978; a figure for each band of lines, as pvlib (BSD-3-Clause) carries it.",
            "Made by scripts/make_air_tables.py.",
        ],
        "wavelength_nm,water,mixed",
        np.stack([SPECTRL2[k] for k in ("wavelength", "water_vapor_absorption", "mixed_absorption")], axis=-1),
    )


def penndorf_and_grass():
    penndorf = """70.45 62.82 56.20 50.43 45.40 40.98 37.08 33.65 30.60 27.89 25.48 23.33 21.40 19.66 18.10 16.69 15.42 14.26
    13.21 12.26 11.39 10.60 9.876 9.212 8.604 8.045 7.531 7.057 6.620 6.217 5.844 5.498 5.178 4.881 4.605 4.348 4.109 3.886
    3.678 3.484 3.302 3.132 2.973 2.824 2.684 2.583 2.481 2.380"""
    values = np.array([float(v) for v in penndorf.split()]) * 1e-6
    write(
        "penndorf_1957",
        [
            "Rayleigh scattering coefficient of air at 0 C and 1013.25 hPa, m-1: Penndorf 1957, Table III.",
            "As listed by E. Bruneton (clear-sky-models, 2016).",
        ],
        "wavelength_nm,coefficient",
        np.stack([360.0 + 10 * np.arange(48), values], axis=-1),
    )
    grass = """.018 .019 .019 .020 .022 .024 .027 .029 .030 .031 .032 .032 .032 .033 .035 .040 .055 .073 .084 .089 .089 .079
    .069 .063 .061 .057 .052 .051 .048 .042 .039 .035 .035 .043 .087 .156 .234 .334 .437 .513 .553 .571 .579 .581 .587"""
    values = np.array([float(v) for v in grass.split()])
    write(
        "grass_albedo",
        [
            "Spectral albedo of grass: Feister and Grewe 1995, Photochemistry and Photobiology 62, 736-744.",
            "As listed by E. Bruneton (clear-sky-models, 2016).",
        ],
        "wavelength_nm,albedo",
        np.stack([360.0 + 10 * np.arange(45), values], axis=-1),
    )


if __name__ == "__main__":
    sun()
    ozone()
    nitrogen_dioxide()
    gases()
    penndorf_and_grass()
