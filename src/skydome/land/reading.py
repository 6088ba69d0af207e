"""Elevation models from GeoTIFF, .npz and .hgt files."""

import os
import re
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.arguments import require_file
from skydome.ground.extras import required
from skydome.ground.files.reading import arrays_in, decoding
from skydome.ground.units import deg
from skydome.land.elevation import Elevation, Extent, without_holes

METRES_A_DEGREE = 111_195.0
BYTES_A_CELL = 100
"""What a cell takes while it is read and while a picture is made: heights, copies, what is missing, the pyramid."""

SHARE_OF_MEMORY = 0.25
"""Of the machine's memory that a model may take; larger models are coarsened while they are read."""

FEET = {"ft": 0.3048, "foot": 0.3048, "feet": 0.3048, "us survey foot": 0.3048006, "us-ft": 0.3048006}


def spacing(degrees_x: float, degrees_y: float, latitude: float) -> tuple[float, float]:
    """Metres, east and north, of a step in degrees at a latitude on the sphere."""
    if not -89 <= latitude <= 89:
        raise ValueError(f"the model's latitude must lie in [-89, 89] degrees, got {latitude:g}")
    return abs(degrees_x) * METRES_A_DEGREE * float(np.cos(latitude * deg)), abs(degrees_y) * METRES_A_DEGREE


def cells_that_fit() -> int:
    """How many cells of a model go into the machine's memory, at least 4 million: 40 million of 16 GiB."""
    return max(4_000_000, int(SHARE_OF_MEMORY * memory() / BYTES_A_CELL))


def most_bytes() -> int:
    """Bytes of arrays, unpacked, that a file may hold: what a machine reads beside its copies in float64."""
    return min(1 << 30, int(SHARE_OF_MEMORY / 4 * memory()))


def memory() -> int:
    """Bytes of memory that the machine has; 8 GiB where it does not tell."""
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return 8 << 30


def read_elevation(path: str | PathLike[str], vertical_unit: str | None = None, cells: int | None = None) -> Elevation:
    """The elevation model in a GeoTIFF (needs rasterio), .npz or .hgt file; larger ones are coarsened to `cells`.

    `cells`: as many as go into a quarter of the machine's memory unless given; `notes` say what was done.

    `vertical_unit`: "m" or "ft" where the file does not say; metres are taken else. ValueError in one line for files
    without georeference, mostly holes, or no elevation.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     np.savez(f"{folder}/hill.npz", elevation=np.eye(3), dx=30.0, dy=30.0)
    ...     read_elevation(f"{folder}/hill.npz").heights.shape
    (3, 3)
    """
    path = require_file(path, "an elevation model")
    if vertical_unit is not None and vertical_unit.lower() not in {"m", "metre", "metres", *FEET}:
        raise ValueError(f'the vertical unit must be "m" or "ft", got {vertical_unit!r}')
    kinds = {".tif": read_geotiff, ".tiff": read_geotiff, ".npz": read_npz, ".hgt": read_hgt}
    if path.suffix.lower() not in kinds:
        raise ValueError(f"an elevation model must end in {', '.join(kinds)}, got {path.name!r}")
    if cells is not None and cells < 4:
        raise ValueError(f"an elevation model must keep 4 cells or more, got {cells}")
    return kinds[path.suffix.lower()](path, vertical_unit, cells_that_fit() if cells is None else cells)


VOIDS = (-32768.0, -32767.0, -9999.0)
"""Values that usually stand for a missing height, even where the file does not say so."""

HIGHEST = 12_000.0
"""No land or sea floor lies further from sea level, m: such heights are taken as missing."""


def finished(raw: np.ndarray, hole: np.ndarray, unit: str | None, step: int, known: dict[str, Any]) -> Elevation:
    """The model of raw heights: coarsened by `step`, holes filled, in metres."""
    notes: tuple[str, ...] = ()
    scale = FEET.get((unit or "m").strip().lower(), 1.0)
    hole = hole | np.isin(raw, VOIDS) | (abs(raw * scale) > HIGHEST)
    if step > 1:
        rows, columns = (size // step * step for size in raw.shape)
        blocks = (rows // step, step, columns // step, step)
        weight = (~hole[:rows, :columns]).reshape(blocks).sum(axis=(1, 3))
        total = np.where(hole, 0.0, raw)[:rows, :columns].reshape(blocks).sum(axis=(1, 3))
        raw, hole = np.where(weight > 0, total / np.maximum(weight, 1), 0.0), weight == 0
        notes = (coarsened(step, raw.shape),)
    heights, filled = without_holes(raw.astype(np.float64), hole)
    notes += filled + (("heights in feet turned into metres",) if scale != 1 else ())
    known = known | {"dx": known["dx"] * step, "dy": known["dy"] * step}
    return Elevation(heights * scale, notes=(*known.pop("notes", ()), *notes), **known)


def coarsened(step: int, shape: tuple[int, ...]) -> str:
    """What to say of a model that was coarsened to a shape."""
    return f"coarsened {step} times, to {shape[0]} x {shape[1]} cells, which fit into memory or were asked for"


def step_for(rows: int, columns: int, cells: int) -> int:
    """By how much a grid is coarsened to at most `cells`; ValueError beyond 40,000 x 40,000."""
    if rows * columns > 40_000**2:
        raise ValueError(
            f"an elevation model may have at most 40000 x 40000 cells, got {rows} x {columns}; cut it first"
        )
    return max(1, int(np.ceil(np.sqrt(rows * columns / cells))))


def read_geotiff(path: Path, unit: str | None, cells: int) -> Elevation:
    """A GeoTIFF's first band, with the horizontal and vertical units that it states."""
    import warnings

    rasterio = required("rasterio", "terrain", "reading GeoTIFF")
    from rasterio.errors import NotGeoreferencedWarning, RasterioIOError

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        try:
            source = rasterio.open(path)
        except RasterioIOError as error:
            raise ValueError(f"cannot read {path.name}, which is damaged or no GeoTIFF") from error
        with source:
            if source.crs is None or source.transform.is_identity:
                raise ValueError(f"{path.name} has no georeference; give it one (gdal_edit.py -a_srs ... -a_ullr ...)")
            if source.transform.b or source.transform.d or source.transform.e > 0:
                raise ValueError(f"{path.name} must have north at the top; turn it first (gdalwarp in.tif out.tif)")
            if min(source.shape) < 2:
                raise ValueError(f"{path.name} must hold 2 x 2 heights or more, got {source.height} x {source.width}")
            step = step_for(source.height, source.width, cells)
            shape = (max(2, source.height // step), max(2, source.width // step))
            band = source.read(1, out_shape=shape, masked=True, resampling=rasterio.enums.Resampling.average)
            with np.errstate(invalid="ignore"):  # damaged files hold signalling NaN, which are holes
                raw = band.filled(0).astype(np.float64)
            hole = np.ma.getmaskarray(band) | ~np.isfinite(raw)
            middle = source.xy(source.height // 2, source.width // 2)
            notes = (coarsened(step, shape),) if step > 1 else ()
            stretch = source.height / shape[0], source.width / shape[1]
            known = georeference(source, middle, stretch) | {"notes": notes}
            return finished(raw, hole, unit or source.units[0], 1, known)


def georeference(source: Any, middle: tuple[float, float], stretch: tuple[float, float]) -> dict[str, Any]:
    """Spacing in metres and the middle in degrees of an open raster."""
    from rasterio.warp import transform

    degrees_x, degrees_y = source.res[0] * stretch[1], source.res[1] * stretch[0]
    longitudes, latitudes = transform(source.crs, "EPSG:4326", [middle[0]], [middle[1]])
    if source.crs.is_geographic:
        dx, dy = spacing(degrees_x, degrees_y, latitudes[0])
    else:
        metre = float(source.crs.linear_units_factor[1])
        dx, dy = degrees_x * metre, degrees_y * metre
    turn, margin = source.transform, (stretch[1] / 2, stretch[0] / 2)
    west, east = (turn.c + turn.a * column for column in (margin[0], source.width - margin[0]))
    north, south = (turn.f + turn.e * row for row in (margin[1], source.height - margin[1]))
    extent = Extent(source.crs, west, north, east, south)
    place = {"latitude": float(latitudes[0]), "longitude": float(longitudes[0])}
    return {"dx": dx, "dy": dy, "extent": extent} | place


def read_npz(path: Path, unit: str | None, cells: int) -> Elevation:
    """Arrays `elevation`, `dx`, `dy` (m, or degrees if `xmin`, `xmax`, `ymin`, `ymax` are there); NaN is a hole."""
    edges = {"xmin", "xmax", "ymin", "ymax"}
    stored = arrays_in(path, "an elevation model", {"elevation", "dx", "dy"}, most_bytes(), edges)
    with decoding(path, "an elevation model"):
        raw = np.asarray(stored["elevation"], dtype=np.float64)
        dx, dy = abs(float(stored["dx"])), abs(float(stored["dy"]))
        known: dict[str, Any] = {"dx": dx, "dy": dy}
        if edges <= set(stored):
            west, east, south, north = (float(stored[name]) for name in ("xmin", "xmax", "ymin", "ymax"))
            known = {"latitude": (south + north) / 2, "longitude": (west + east) / 2}
            known["dx"], known["dy"] = spacing(dx, dy, known["latitude"])
    if raw.ndim != 2:
        raise ValueError(f"elevation in {path.name} must have shape (rows, columns), got {raw.shape}")
    hole = ~np.isfinite(raw)
    return finished(np.where(hole, 0.0, raw), hole, unit, step_for(raw.shape[0], raw.shape[1], cells), known)


def read_hgt(path: Path, unit: str | None, cells: int) -> Elevation:
    """An SRTM tile, named by its south-west corner as N36W085.hgt: 1201 or 3601 heights a side; -32768 is a hole."""
    named = re.match(r"([NS])(\d{2})([EW])(\d{3})", path.stem.upper())
    if named is None:
        raise ValueError(f"an .hgt file must be named by its corner, such as N36W085.hgt, got {path.name!r}")
    raw = np.fromfile(path, dtype=">i2")
    side = round(raw.size**0.5)
    if side not in (1201, 3601) or side * side != raw.size:
        raise ValueError(f"an .hgt file must hold 1201 x 1201 or 3601 x 3601 heights, got {raw.size} in {path.name}")
    latitude = int(named[2]) * (1 if named[1] == "N" else -1) + 0.5
    longitude = int(named[4]) * (1 if named[3] == "E" else -1) + 0.5
    dx, dy = spacing(1 / (side - 1), 1 / (side - 1), latitude)
    heights = raw.reshape(side, side).astype(np.float64)
    known = {"dx": dx, "dy": dy, "latitude": latitude, "longitude": longitude}
    return finished(heights, heights == -32768, unit, step_for(side, side, cells), known)
