"""Make the table of the earth's course about the sun: VSOP87 as SPA shortens it.

Run: python scripts/make_sun_table.py (needs pvlib, which carries the printed figures)
"""

from pathlib import Path

DATA = Path(__file__).parents[1] / "src" / "skydome" / "ground" / "data"
HEADER = """\
# Earth about the sun: heliocentric longitude, latitude (radians, ecliptic and equinox of date) and distance (AU) as
# sums of t^power amplitude cos(phase + rate t), t in thousands of Julian years (TT) since J2000.
# quantity: 0 longitude, 1 latitude, 2 distance. amplitude: 1e-8 of the unit; phase: rad; rate: rad per thousand years.
# Source: VSOP87D (Bretagnon and Francou 1988, Astronomy and Astrophysics 202, 309) as shortened by Meeus 1991 and
# printed in Reda and Andreas 2004 (NREL/TP-560-34302), Table A4.2; read from pvlib. Made by scripts/make_sun_table.py.
"""


def main():
    from pvlib import spa

    lines = [HEADER + "quantity,power,amplitude,phase,rate"]
    for quantity, letter in enumerate("LBR"):
        for power in range(6):
            rows = getattr(spa, f"{letter}{power}", ())
            lines += [f"{quantity},{power}," + ",".join(f"{float(v):.12g}" for v in row) for row in rows]
    (DATA / "vsop87_earth.csv").write_text("\n".join(lines) + "\n", "utf-8")


if __name__ == "__main__":
    main()
