"""Scattering in the eye over a flat picture: a convolution by FFT, as if the picture's plane were the eye's sphere."""

import numpy as np

from skydome.eye.glow import disc_glow
from skydome.eye.point_spread import PointSpread

REACH = (
    0.5  # of the picture's longer side: how far light is scattered; the rest counts as coming from as bright a place
)


def blurred(picture: np.ndarray, pixel: float, spread: PointSpread) -> np.ndarray:
    """The picture (H, W, 3) float32 with its light scattered; pixels are `pixel` radians wide.

    What lies outside the picture is taken to be as bright as what lies inside, weighted by the spread: an even
    picture stays even. The pixel's own share of the spread is exact however sharp its core is.
    """
    from scipy.fft import next_fast_len, rfft2

    reach = max(8, int(REACH * max(picture.shape[:2])))
    size = [next_fast_len(n + reach, real=True) for n in picture.shape[:2]]
    weights = kernel(reach, pixel, spread)
    placed = np.zeros(size, dtype=np.float32)
    rows, columns = (min(2 * reach + 1, n) for n in size)
    shift = [(rows - 1) // 2, (columns - 1) // 2]
    cut = weights[reach - shift[0] : reach - shift[0] + rows, reach - shift[1] : reach - shift[1] + columns]
    placed[:rows, :columns] = cut
    placed = np.roll(placed, (-shift[0], -shift[1]), axis=(0, 1))
    response = rfft2(placed, workers=-1).real.astype(np.float32)  # the kernel is even
    known = scattered(np.ones(picture.shape[:2], dtype=np.float32), response)
    result = np.empty_like(picture)
    for channel in range(picture.shape[2]):
        np.divide(scattered(picture[..., channel], response), known, out=result[..., channel])
    return result


def scattered(plane: np.ndarray, response: np.ndarray) -> np.ndarray:
    """One channel (H, W) convolved with the kernel whose transform is `response` (h, w / 2 + 1)."""
    from scipy.fft import irfft2, rfft2

    width = 2 * (response.shape[1] - 1)
    size = (response.shape[0], width)
    spectrum = rfft2(plane, s=size, workers=-1)
    spectrum *= response
    convolved: np.ndarray = irfft2(spectrum, s=size, workers=-1)
    return convolved[: plane.shape[0], : plane.shape[1]]


def kernel(reach: int, pixel: float, spread: PointSpread) -> np.ndarray:
    """Share of a pixel's light in each pixel up to `reach` away, (2 reach + 1, 2 reach + 1); its sum is below 1.

    A pixel counts as a disc of its area; the middle is what the others leave of the light within their circle.
    """
    angle, glow = disc_glow(spread, pixel / np.sqrt(np.pi))
    steps = np.arange(-reach, reach + 1)
    distance = np.arctan(np.hypot(steps[:, None], steps) * pixel)
    weights: np.ndarray = np.interp(distance, angle, glow[:, 1]) * (pixel**2 * np.cos(distance) ** 3)
    weights[distance > np.arctan(reach * pixel)] = 0.0
    weights[reach, reach] = 0.0
    inside = float(spread.within(np.arctan(reach * pixel)))
    weights[reach, reach] = inside - weights.sum()
    return weights
