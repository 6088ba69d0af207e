"""Write the tables of the light floor: `python scripts/make_light_tables.py` (needs colour-science).

`cie_1931_2deg.csv` comes from colour-science; `preetham_1999_table_2.csv` is transcribed below from the paper and
checked against colour-science's CIE daylight basis, so that a slip of the pen is found.
"""

import warnings
from pathlib import Path

import numpy as np

DATA = Path(__file__).parents[1] / "src" / "skydome" / "ground" / "data"

CIE_HEADER = """\
# CIE 1931 2-degree standard observer colour matching functions, 360-830 nm at 1 nm, dimensionless.
# Source: CIE 15 (Colorimetry), Table T.4 at 1 nm as tabulated by CVRL, taken from colour-science {version}.
# Licence: colour-science is BSD-3-Clause (https://www.colour-science.org). Written by scripts/make_light_tables.py.
"""

TABLE_2_HEADER = """\
# Preetham, Shirley, Smits 1999, A Practical Analytic Model for Daylight, Table 2, https://doi.org/10.1145/311535.311545
# K (dimensionless); S0, S1, S2 (relative, daylight basis of Wyszecki and Stiles 1982); sun_radiance (W m-2 nm-1 sr-1,
# top of the atmosphere, nan where the paper prints a dash); k_o, k_wa (m-1) and k_g, 0 where the paper prints a dash.
# Licence: figures published in the paper, transcribed for this library. Written by scripts/make_light_tables.py.
"""

COLUMNS = ["wavelength_nm", "K", "S0", "S1", "S2", "sun_radiance", "k_o", "k_wa", "k_g"]

TABLE_2 = """\
380 0.650 63.4 38.5 3 16559 - - -
390 0.653 65.8 35 1.2 16233.7 - - -
400 0.656 94.8 43.4 -1.1 21127.5 - - -
410 0.658 104.8 46.3 -0.5 25888.2 - - -
420 0.661 105.9 43.9 -0.7 25829.1 - - -
430 0.662 96.8 37.1 -1.2 24232.3 - - -
440 0.663 113.9 36.7 -2.6 26760.5 - - -
450 0.666 125.6 35.9 -2.9 29658.3 0.3 - -
460 0.667 125.5 32.6 -2.8 30545.4 0.6 - -
470 0.669 121.3 27.9 -2.6 30057.5 0.9 - -
480 0.670 121.3 24.3 -2.6 30663.7 1.4 - -
490 0.671 113.5 20.1 -1.8 28830.4 2.1 - -
500 0.672 113.1 16.2 -1.5 28712.1 3 - -
510 0.673 110.8 13.2 -1.3 27825 4 - -
520 0.674 106.5 8.6 -1.2 27100.6 4.8 - -
530 0.676 108.8 6.1 -1 27233.6 6.3 - -
540 0.677 105.3 4.2 -0.5 26361.3 7.5 - -
550 0.678 104.4 1.9 -0.3 25503.8 8.5 - -
560 0.679 100 0 0 25060.2 10.3 - -
570 0.679 96 -1.6 0.2 25311.6 12 - -
580 0.680 95.1 -3.5 0.5 25355.9 12 - -
590 0.681 89.1 -3.5 2.1 25134.2 11.5 - -
600 0.682 90.5 -5.8 3.2 24631.5 12.5 - -
610 0.682 90.3 -7.2 4.1 24173.2 12 - -
620 0.683 88.4 -8.6 4.7 23685.3 10.5 - -
630 0.684 84 -9.5 5.1 23212.1 9 - -
640 0.684 85.1 -10.9 6.7 22827.7 7.9 - -
650 0.685 81.9 -10.7 7.3 22339.8 6.7 - -
660 0.685 82.6 -12 8.6 21970.2 5.7 - -
670 0.685 84.9 -14 9.8 21526.7 4.8 - -
680 0.686 81.3 -13.6 10.2 21097.9 3.6 - -
690 0.686 71.9 -12 8.3 20728.3 2.8 1.6 -
700 0.687 74.3 -13.3 9.6 20240.4 2.3 2.4 -
710 0.687 76.4 -12.9 8.5 19870.8 1.8 1.25 -
720 0.688 63.3 -10.6 7 19427.2 1.4 100 -
730 0.688 71.7 -11.6 7.6 19072.4 1.1 87 -
740 0.689 77 -12.2 8 18628.9 1 6.1 -
750 0.689 65.2 -10.2 6.7 18259.2 0.9 0.1 -
760 0.689 47.7 -7.8 5.2 - 0.7 1e-03 3.0
770 0.689 68.6 -11.2 7.4 - 0.4 1e-03 0.21
780 0.689 65 -10.4 6.8 - - 0.06 -
"""


def table_2() -> np.ndarray:
    """Table 2 as (41, 9): a dash means no absorption (0), and an unknown radiance of the sun (nan)."""
    cells = [line.split() for line in TABLE_2.splitlines()]
    missing = {5: "nan"}
    return np.array([[float(missing.get(k, "0") if c == "-" else c) for k, c in enumerate(row)] for row in cells])


def write(name: str, header: str, columns: list[str], rows: np.ndarray) -> None:
    lines = [",".join(f"{value:.12g}" for value in row) for row in rows]
    (DATA / name).write_text(header + ",".join(columns) + "\n" + "\n".join(lines) + "\n", encoding="utf-8")


def main() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import colour
        from colour.colorimetry import SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES as BASIS

    observer = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    rows = np.column_stack([observer.wavelengths, observer.values])
    write("cie_1931_2deg.csv", CIE_HEADER.format(version=colour.__version__), ["wavelength_nm", "x", "y", "z"], rows)
    transcribed = table_2()
    for column, name in enumerate(["S0", "S1", "S2"], start=2):
        np.testing.assert_allclose(transcribed[:, column], BASIS[name][transcribed[:, 0]], atol=1e-9)
    write("preetham_1999_table_2.csv", TABLE_2_HEADER, COLUMNS, transcribed)


if __name__ == "__main__":
    main()
