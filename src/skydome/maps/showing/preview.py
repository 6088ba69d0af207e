"""A map as a photographer would see it: exposed, tone-mapped, encoded for the screen."""

from collections.abc import Callable, Iterator

import numpy as np

from skydome.ground.limits.ranges import require
from skydome.ground.limits.sizes import row_parts
from skydome.ground.png import in_bytes
from skydome.light.colour import SRGB, encode_srgb
from skydome.light.tone import EXPOSURE, Curve, Filmic, auto_exposure, thinning, tone_mapped
from skydome.maps.by_rows.map_rows import MapRows
from skydome.maps.pixels import MapPixels


def preview(environment: MapPixels, exposure: float | None = None, curve: Curve | None = None) -> np.ndarray:
    """sRGB-encoded values (H, W, 3) in 0..1 of a map; `exposure` per cd m-2, chosen from the content unless given.

    Colours outside sRGB are cut at its edge; the curve (default `Filmic`) keeps hues (see `tone_mapped`).

    >>> grey = MapPixels(np.full((4, 8, 3), 2000.0))
    >>> preview(grey)[0, 0].round(3).tolist()
    [0.553, 0.553, 0.553]
    """
    if exposure is None:
        exposure = usual_exposure(environment)
    else:
        require("exposure", exposure, EXPOSURE)
    return developer(environment, exposure, curve)(environment.pixels)


def preview_rows(
    source: MapRows,
    blocks: Iterator[np.ndarray],
    exposure: float,
    curve: Curve | None,
    report: Callable[[float, float], None],
) -> Iterator[np.ndarray]:
    """The same of a map's blocks of rows, as bytes (r, W, 3); `report` takes the rows done and all rows."""
    developed = developer(source, exposure, curve)
    for part, pixels in zip(source.parts(), blocks, strict=True):
        for rows in row_parts(len(pixels)):
            yield in_bytes(developed(pixels[rows]))
        report(part.stop, source.height)


def usual_exposure(source: MapRows) -> float:
    """The factor, per cd m-2, that brings a map's usual luminance to its key (see `auto_exposure`)."""
    rows, columns = source.size
    step = thinning(rows * columns)
    weights = (source.space.to_xyz[1] * source.white_luminance).astype(source.pixel_type)
    light = [
        (pixels[-part.start % step :: step] @ weights)[:, ::step]
        for part, pixels in zip(source.parts(), source.blocks(), strict=True)
    ]
    angles = np.broadcast_to(source.projection.solid_angles(source.height), (rows, columns))
    return auto_exposure(np.concatenate(light), angles[::step, ::step])


def developer(source: MapRows, exposure: float, curve: Curve | None) -> Callable[[np.ndarray], np.ndarray]:
    """What makes sRGB-encoded values of a map's pixels (..., 3)."""
    to_srgb = SRGB.from_xyz @ source.space.to_xyz * (source.white_luminance * exposure)
    matrix, shown = to_srgb.T.astype(source.pixel_type), curve or Filmic()

    def developed(pixels: np.ndarray) -> np.ndarray:
        encoded: np.ndarray = encode_srgb(tone_mapped(pixels @ matrix, shown))
        return encoded

    return developed
