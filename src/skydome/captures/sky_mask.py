"""Which texels of a capture show sky: above the horizon and above the skyline that colour and gradient draw.

Each texel gets points for being sky (not darker than the sky above it and about it, not textured, of the sky's colour);
in each column the skyline is where the points from the zenith down are most, plus those of a strong edge just there: a
cloud costs points that the sky below it wins back, a hill or a house goes on losing. The idea of an optimal border per
column: Shen and Wang, "Sky region detection in a single image for autonomous ground robot navigation" (2013).
"""

from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground import png
from skydome.ground.directions import angle_between, elevation
from skydome.ground.units import deg
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.equirectangular import Equirectangular

GLARE = 6 * deg
ALIKE = 0.1
DARKER = 0.8  # log: what is this much darker than the sky at its height is a branch, a mast, a wire
REFERENCE = (30 * deg, 65 * deg)
"""Elevations between which a column's own sky is taken for its reference."""
EDGE = 4.0
"""Texels of sky that an edge of 1 (in log luminance or colour) is worth."""


def sky_mask(picture: EnvironmentMap, sun: np.ndarray | None = None, horizon: float = 0.0) -> np.ndarray:
    """True where the map shows sky, (H, W) bool: above `horizon` (radians) and above the skyline found in the picture.

    A map that is not equirectangular is brought into that layout and the mask back. `sun` (3,), if known, keeps the
    sun's glare from being taken for a border. Meant as a beginning: write it with `write_mask`, paint it right, and
    read it back with `read_mask`.

    >>> import skydome as sd
    >>> sky = sd.render(sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0), height=64)
    >>> bool(sky_mask(sky)[:31].all()), bool(sky_mask(sky)[32:].any())
    (True, False)
    """
    if not isinstance(picture.projection, Equirectangular):
        flat = picture.resampled(Equirectangular())
        row, column, _ = flat.projection.pixels(picture.projection.directions(picture.height), flat.height)
        mask: np.ndarray = sky_mask(flat, sun, horizon)[row.astype(int), column.astype(int)]
        return np.asarray(mask & picture.projection.valid(picture.height))
    toward = picture.projection.directions(picture.height)
    above = elevation(toward) > horizon
    glare = np.zeros(above.shape, bool) if sun is None else angle_between(toward, sun) < GLARE
    colour = log_colour(picture)
    points = np.where(glare, 1.0, sky_points(colour, elevation(toward)[:, 0]))
    edge = np.where(glare, 0.0, downward_gradient(colour))
    border = best_border(points, edge, above)
    mask = above & (np.arange(picture.height)[:, None] < border)
    mask = mask & ~(dark_against_sky(colour[..., 0], mask) & ~glare)
    return grown(mask, colour[..., 0], above)


def log_colour(picture: EnvironmentMap) -> np.ndarray:
    """Log luminance, and logs of red / green and blue / green, (H, W, 3); dark and negative values are held up."""
    rgb = np.maximum(picture.pixels.astype(np.float64), 0.0)
    floor = 1e-4 * max(float(np.mean(np.minimum(rgb, 10 * np.median(rgb) + 1e-12))), 1e-12)
    red, green, blue = np.moveaxis(np.log(rgb + floor), -1, 0)
    return np.stack([(red + green + blue) / 3, red - green, blue - green], axis=-1)


def downward_gradient(colour: np.ndarray) -> np.ndarray:
    """How much each texel differs from those two rows above it, in log luminance and colour, (H, W)."""
    difference = np.zeros(colour.shape)
    difference[2:] = colour[2:] - colour[:-2]
    size: np.ndarray = np.sqrt((difference**2 * [1.0, 4.0, 4.0]).sum(axis=-1))
    return size


def sky_points(colour: np.ndarray, elevations: np.ndarray) -> np.ndarray:
    """1 for a texel like the sky, down to -1.5 for one that is darker, textured or of another colour, (H, W)."""
    from scipy.ndimage import generic_gradient_magnitude, sobel, uniform_filter

    brightness = colour[..., 0]
    own = (elevations > REFERENCE[0]) & (elevations < REFERENCE[1])
    column = np.median(colour[own], axis=0)
    column[:, 0] = np.percentile(brightness[own], 20, axis=0)  # its darkest sky: the blue between clouds
    row = np.percentile(brightness, 70, axis=1)
    darker = np.clip((np.minimum(row[:, None], column[None, :, 0]) - brightness) / 0.5, 0.0, 2.0)
    rough = generic_gradient_magnitude(brightness, sobel, mode="wrap") / 8
    textured = np.clip(uniform_filter(rough, 5, mode="wrap") / 0.12 - 0.5, 0.0, 1.5)
    tint = np.abs(colour[..., 1:] - column[None, :, 1:]).sum(axis=-1)
    redder = np.clip((tint - 0.6) / 0.6, 0.0, 1.0)
    points: np.ndarray = 1 - np.minimum(darker + textured + 0.5 * redder, 2.5)
    return points


def best_border(points: np.ndarray, edge: np.ndarray, above: np.ndarray) -> np.ndarray:
    """The first row (W,) of each column that is no sky: where the points above and the edge there are most."""
    horizon = above.sum(axis=0)
    total = np.concatenate([np.zeros((1, points.shape[1])), np.cumsum(points, axis=0)])
    total[:-1] += EDGE * np.minimum(edge, 1.0)
    rows = np.arange(total.shape[0])[:, None]
    rewarded = np.where(rows <= horizon, total, -np.inf)
    border: np.ndarray = rewarded.shape[0] - 1 - np.argmax(rewarded[::-1], axis=0)
    return border


def dark_against_sky(brightness: np.ndarray, sky: np.ndarray) -> np.ndarray:
    """True for texels much darker than the sky left and right of them at the same height."""
    from scipy.ndimage import percentile_filter

    width = max(3, brightness.shape[1] // 24)
    usual = percentile_filter(brightness, 60, size=(1, width), mode="wrap")
    return np.asarray(sky & (brightness < usual - DARKER))


def grown(mask: np.ndarray, brightness: np.ndarray, above: np.ndarray) -> np.ndarray:
    """The mask with what lies beside it at the same height and looks alike: edges of houses cost it a few texels."""
    for _ in range(4):
        for side in (1, -1):
            alike = np.abs(brightness - np.roll(brightness, side, axis=1)) < ALIKE
            mask = mask | (above & alike & np.roll(mask, side, axis=1))
    return mask


def write_mask(path: str | PathLike[str], mask: np.ndarray) -> None:
    """Write a mask as a PNG to paint in: white is sky, black is not; atomically."""
    png.write(path, np.repeat(mask[..., None].astype(np.float64), 3, axis=-1), {"mask": "white: sky"})


def read_mask(path: str | PathLike[str], shape: tuple[int, int]) -> np.ndarray:
    """The mask of a PNG, bool of `shape`; True where it is lighter than middle grey. ValueError for another size."""
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(path) as image:
            grey = np.asarray(image.convert("L"))
    except (UnidentifiedImageError, OSError) as error:
        raise ValueError(f"cannot read the mask {Path(path).name}: {error}") from error
    if grey.shape != tuple(shape):
        size, wanted = f"{grey.shape[1]} x {grey.shape[0]}", f"{shape[1]} x {shape[0]}"
        raise ValueError(f"the mask must have the size of its map, {wanted}, got {size} in {Path(path).name}")
    return grey >= 128
