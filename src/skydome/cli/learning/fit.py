"""`skydome fit`: from a store of simulated skies to the tables of a sky model of one's own."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Argument, Option

from skydome.cli.doors import progress, require_output
from skydome.cli.options import AsJson
from skydome.cli.printing import show_facts
from skydome.ground.extras import required

if TYPE_CHECKING:
    from skydome.own_air.family import SkyFamily

ENDINGS = {"hosek-wilkie": ".npz", "preetham": ".json"}


def fit(
    store: Annotated[Path, Argument(help="The Zarr store that `skydome simulate` has filled.")],
    output: Annotated[
        Path, Option("--output", "-o", help="The file to write, .npz (hosek-wilkie) or .json (preetham).")
    ],
    form: Annotated[str, Option(metavar="hosek-wilkie|preetham", help="Whose formula is fitted.")] = "hosek-wilkie",
    lowest: Annotated[float, Option(metavar="DEGREES", help="Suns below this elevation are left out.")] = 5.0,
    albedo: Annotated[float, Option(help="The ground's, for Preetham's formula, which has none.")] = 0.0,
    as_json: AsJson = False,
) -> None:
    """Fit a sky model's formula to simulated skies; `--model hosek-wilkie --tables FILE` shows the result.

    hosek-wilkie: each of the nine numbers a quintic Bezier curve of the sun's height, at the store's turbidities and
    albedos. preetham: five letters linear in turbidity and the values at the zenith: `--numbers FILE` takes them.
    """
    from skydome.ground.units import deg
    from skydome.own_air.family import SkyFamily

    if form not in ENDINGS:
        raise ValueError(f"--form must be one of {', '.join(ENDINGS)}, got {form!r}")
    require_output(output, f"the file of {form}", (ENDINGS[form],))
    for name, value, high in (("--lowest", lowest, 89.0), ("--albedo", albedo, 1.0)):
        if not 0 <= value <= high:
            raise ValueError(f"{name} must lie in [0, {high:g}], got {value:g}")
    required("scipy", "fit", "a fit")
    family = SkyFamily.from_store(store, lowest * deg)
    facts = tables_facts(family, output) if form == "hosek-wilkie" else numbers_facts(family, output, albedo)
    show_facts(facts, as_json)


def numbers_facts(family: "SkyFamily", output: Path, albedo: float) -> dict[str, Any]:
    """Preetham's numbers, fitted and written."""
    from skydome.own_air.preetham_fit import preetham_fit

    numbers = preetham_fit(family, albedo)
    numbers.save(output)
    return {"file": str(output), "turbidities": family.turbidities.tolist(), "albedo": albedo}


def tables_facts(family: "SkyFamily", output: Path) -> dict[str, Any]:
    """Hosek and Wilkie's tables, fitted and written with progress on stderr."""
    from skydome.own_air.bezier_family import bezier_family

    with progress("fitting wavelengths") as report:
        tables = bezier_family(family, report)
    tables.save(output)
    return facts_of(output, tables)


def facts_of(path: Path, tables: Any) -> dict[str, Any]:
    """What was fitted, and the relative RMS errors."""
    square = tables.error**2
    return {
        "file": str(path),
        "turbidities": tables.turbidities.tolist(),
        "albedos": tables.albedos.tolist(),
        "wavelengths_nm": tables.wavelengths.tolist(),
        "relative_rms_error": float(square.mean() ** 0.5),
        "by_turbidity": (square.mean(axis=(1, 2)) ** 0.5).tolist(),
        "by_wavelength": (square.mean(axis=(0, 1)) ** 0.5).tolist(),
    }
