"""`skydome fit`: from a store of simulated skies to the tables of a sky model of one's own."""

from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.options import AsJson
from skydome.cli.printing import show


def fit(
    store: Annotated[Path, Argument(help="The Zarr store that `skydome simulate` has filled.")],
    output: Annotated[Path, Option("--output", "-o", help="The tables' file, .npz.")],
    lowest: Annotated[float, Option(metavar="DEGREES", help="Suns below this elevation are left out.")] = 5.0,
    as_json: AsJson = False,
) -> None:
    """Fit Hosek and Wilkie's formula to simulated skies; `--model hosek-wilkie --tables FILE` shows the result.

    Each of the nine numbers is a quintic Bezier curve of the sun's height, at the store's turbidities and albedos.
    """
    from rich.console import Console
    from rich.progress import Progress

    from skydome.ground.units import deg
    from skydome.study.bezier_family import bezier_family
    from skydome.study.sky_family import SkyFamily

    if output.suffix != ".npz":
        raise ValueError(f"the tables' file must end in .npz, got {output.name}")
    if not output.parent.is_dir():
        raise FileNotFoundError(f"the folder to write to must exist, got {output.parent}")
    if not 0 <= lowest < 90:
        raise ValueError(f"--lowest must lie in [0, 90) degrees, got {lowest:g}")
    family = SkyFamily.from_store(store, lowest * deg)
    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("fitting wavelengths", total=None)
        tables = bezier_family(family, lambda done, of: bar.update(task, completed=done, total=of))
    tables.save(output)
    facts = facts_of(output, tables)
    show(facts, {name: told(value) for name, value in facts.items()}, as_json)


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


def told(value: Any) -> str:
    """A fact in a line."""
    if isinstance(value, list):
        return ", ".join(f"{number:.4g}" for number in value)
    return f"{value:.4f}" if isinstance(value, float) else str(value)
