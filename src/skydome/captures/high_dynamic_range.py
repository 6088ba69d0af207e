"""Whether a picture in an HDR file is one."""

import numpy as np

CLIPPED_SHARE = 0.01
LEVELS_OF_8_BIT = 256
TELL = "is an LDR picture stored as HDR and cannot tell how bright the sky is; how to tell:"


def require_hdr(pixels: np.ndarray, name: str) -> None:
    """ValueError for an 8 bit picture in an HDR file: few levels, or many texels at the one largest value."""
    bright = pixels.max(axis=-1)
    peak = float(bright.max())
    if peak <= 0:
        raise ValueError(f"{name}: the map is black")
    levels = max(np.unique(pixels[..., k]).size for k in range(3))
    if levels <= LEVELS_OF_8_BIT and pixels[..., 0].size >= 16 * LEVELS_OF_8_BIT and levels > 1:
        raise ValueError(f"{name} {TELL} its channels hold {levels} different values at most, a capture thousands")
    share = float(np.mean(bright >= peak * (1 - 1e-6)))
    if share > CLIPPED_SHARE and np.ptp(bright) > 0:
        raise ValueError(f"{name} {TELL} {share:.1%} of its texels share the largest value {peak:g}: they are clipped")
