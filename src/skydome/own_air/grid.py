"""A whole grid of simulated skies in a Zarr store: independent pieces, computed by Dask, each written once.

A piece is one turbidity and albedo: all suns, views and wavelengths. It is written whole under its own name, and only
then counts as there, so that a killed worker loses its own piece at most and a restart computes what is missing.
"""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, fields
from hashlib import sha256
from itertools import product
from os import PathLike
from pathlib import Path
from typing import ClassVar

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Ozone
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.ground.arrays import Array, brief
from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.ground.files.folders import folder_appearing
from skydome.ground.files.reading import toml_in
from skydome.ground.limits.ranges import SHARE, Bounded, Range
from skydome.ground.limits.sizes import require_count, require_memory
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates
from skydome.years.stores.cluster import cluster_client

AXES = ("turbidities", "albedos", "elevations", "zenith_angles", "azimuths", "wavelengths")
LEAST_ELEVATION = 1e-6
"""Degrees at which a sun on the horizon is taken: light is smooth down to there, and at 0 the solver has night."""
FORM = 2
"""Number of the store's layout and of the simulation's meaning; a change makes old stores another grid."""


@dataclass(frozen=True)
class Grid(Bounded):
    """Turbidities, ground albedos, sun elevations (degrees), wavelengths (nm), and views: zenith angles x azimuths.

    The usual one is Hosek and Wilkie's whole grid: turbidity 1-10, albedo 0 and 1, elevations (n / 45)^3 90 degrees for
    n = 0 ... 45, 11 bands. Suns below 5 degrees are less certain (docs/models/physical.md says by how much).
    """

    turbidities: tuple[float, ...] = tuple(float(t) for t in range(1, 11))
    albedos: tuple[float, ...] = (0.0, 1.0)
    elevations: tuple[float, ...] = tuple(round((n / 45) ** 3 * 90, 9) for n in range(46))
    wavelengths: tuple[float, ...] = tuple(float(w) for w in range(320, 721, 40))
    zenith_angles: tuple[float, ...] = tuple(float(z) for z in range(2, 89, 4))
    azimuths: tuple[float, ...] = tuple(float(a) for a in range(0, 181, 12))
    streams: int = 16
    ozone: float = 330.0
    asymmetry: float = field(default=0.76)
    bounds: ClassVar = DiscreteOrdinates.bounds | {
        "turbidities": Range(1, 64),
        "albedos": SHARE,
        "elevations": Range(0, 90, "degrees"),
        "wavelengths": Range(300, 1100, "nm"),
        "zenith_angles": Range(0, 89.9, "degrees"),
        "azimuths": Range(0, 360, "degrees"),
        "ozone": Ozone.bounds["column"],
        "asymmetry": Range(-0.99, 0.99),
    }

    def __post_init__(self) -> None:
        for name in AXES:
            values = np.ravel(getattr(self, name)).astype(np.float64)
            if not values.size or len(set(values.tolist())) < values.size:
                got = brief(values.tolist(), typed=False)
                raise ValueError(f"{name} must be one number or more, each once, got {got}")
            object.__setattr__(self, name, tuple(values.tolist()))
        self.require_bounds()
        if self.streams % 2:
            raise ValueError(f"streams must be even, got {self.streams}")

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "Grid":
        """From a .toml file whose keys are this class's; ValueError for a key that is none."""
        held = toml_in(path, "a grid of skies")
        unknown = sorted(set(held) - {item.name for item in fields(cls)})
        if unknown:
            known = ", ".join(item.name for item in fields(cls))
            raise ValueError(f"a grid's keys must be among {known}, got {unknown[0]!r}")
        try:
            return cls(**held)
        except (TypeError, OverflowError) as error:
            raise ValueError(f"a grid's values must be numbers or lists of them, got other things in {path}") from error

    @property
    def pieces(self) -> list[tuple[int, int]]:
        """Indices of turbidity and albedo of every piece."""
        return list(product(range(len(self.turbidities)), range(len(self.albedos))))

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the whole: turbidities, albedos, elevations, zenith angles, azimuths, wavelengths."""
        return tuple(len(getattr(self, name)) for name in AXES)

    def fingerprint(self) -> str:
        """A hash of everything that the light depends on."""
        return sha256(json.dumps([FORM, asdict(self)], sort_keys=True).encode()).hexdigest()


def simulated(grid: Grid, piece: tuple[int, int]) -> Array:
    """Radiance of one piece for sunlight of irradiance 1, sr-1, float32 (elevations, zenith angles, azimuths, W)."""
    turbidity, albedo = grid.turbidities[piece[0]], grid.albedos[piece[1]]
    aerosol = Aerosol(albedo=1.0, phase=HenyeyGreenstein((grid.asymmetry,)))
    air = Atmosphere.from_turbidity(turbidity, aerosol, albedo=albedo, ozone=grid.ozone, gases=None)
    zenith, azimuth = np.meshgrid(np.radians(grid.zenith_angles), np.radians(grid.azimuths), indexing="ij")
    views = direction(azimuth, np.pi / 2 - zenith)
    suns = direction(np.zeros(len(grid.elevations)), np.radians(np.maximum(grid.elevations, LEAST_ELEVATION)))
    light = [DiscreteOrdinates(sun, air, grid.streams).radiance(views, grid.wavelengths) for sun in suns]
    return (np.stack(light) / air.sun_at(grid.wavelengths)).astype(np.float32)


def prepared(grid: Grid, path: Path) -> None:
    """Make the store's frame where it is not there; ValueError where it holds another grid.

    Several may begin one store at once: the first to be ready makes it, the others take that one.
    """
    import zarr

    if not path.exists():
        try:
            with folder_appearing(path) as beside:
                make_frame(grid, beside)
            return
        except FileExistsError:
            pass  # another was sooner
    try:
        held = zarr.open_group(path, mode="r").attrs.get("fingerprint")
    except Exception as error:
        raise ValueError(f"{path} is there and is no Zarr store") from error
    if held != grid.fingerprint():
        raise ValueError(f"{path} holds another grid; choose another path, or remove it")


def make_frame(grid: Grid, path: Path) -> None:
    """A store without any light: what is not there reads as NaN."""
    import zarr

    group = zarr.open_group(path, mode="w-")
    chunks = (1, 1, *grid.shape[2:])
    group.create_array("radiance", shape=grid.shape, chunks=chunks, dtype="float32", fill_value=np.nan)
    for name in AXES:
        values = np.asarray(getattr(grid, name))
        group.create_array(name, shape=values.shape, dtype="float64")[:] = values
    group.attrs.update(
        {"grid": asdict(grid), "unit": "sr-1 for sunlight of irradiance 1", "fingerprint": grid.fingerprint()}
    )


def is_there(path: Path, piece: tuple[int, int]) -> bool:
    """True where a piece is written and can be read whole: not empty, cut short, or lost."""
    import zarr

    chunk = path / "radiance" / "c" / str(piece[0]) / str(piece[1]) / "0/0/0/0"
    if not chunk.exists():
        return False
    try:
        light = zarr.open_group(path, mode="r")["radiance"][piece[0], piece[1]]
    except Exception:  # by zarr, and by whichever library packs the chunk
        return False
    return bool(np.isfinite(light).all())


def write_piece(grid: Grid, path: str, piece: tuple[int, int]) -> tuple[int, int]:
    """Compute a piece and write it, unless it is there: the same bytes whoever does it, and however often."""
    import zarr

    if not is_there(Path(path), piece):
        zarr.open_group(path, mode="r+")["radiance"][piece[0], piece[1]] = simulated(grid, piece)
    return piece


def simulate(
    grid: Grid,
    path: str | PathLike[str],
    scheduler: str | None = None,
    workers: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> int:
    """Fill a Zarr store with a grid's light; the count of pieces computed now.

    What is there is not computed again. `workers` 0 is this process alone, more are a cluster on this machine;
    `scheduler` is the address of a Dask scheduler whose workers see the same files. `progress(done, of)` is called
    after each piece.
    """
    required("nanodisort", "rt", "a simulation")
    required("zarr", "scale", "a simulation")
    require_count(len(grid.pieces), 100_000, "pieces of a grid")
    require_memory(np.prod(grid.shape[2:], dtype=float) * 24, "a piece of the grid")
    path = Path(path)
    report = progress or (lambda done, of: None)
    if scheduler is None and workers == 0:
        prepared(grid, path)
        missing = [piece for piece in grid.pieces if not is_there(path, piece)]
        for k, piece in enumerate(missing):
            write_piece(grid, str(path), piece)
            report(k + 1, len(missing))
        return len(missing)
    from distributed import as_completed

    with cluster_client("a simulation by many workers", scheduler, min(workers, len(grid.pieces))) as client:
        prepared(grid, path)
        missing = [piece for piece in grid.pieces if not is_there(path, piece)]
        jobs = client.map(lambda piece: write_piece(grid, str(path.resolve()), piece), missing, pure=False, retries=3)
        for k, done in enumerate(as_completed(jobs)):
            done.result()
            report(k + 1, len(missing))
    return len(missing)
