"""OpenEXR files with depth: linear RGB and Z."""

from os import PathLike

import numpy as np

from skydome.ground.writing import appearing


def write_exr_with_depth(path: str | PathLike[str], rgb: np.ndarray, depth: np.ndarray) -> None:
    """Write RGB (H, W, 3) and Z (H, W), m along the ray, infinite in the sky, as float32; atomically."""
    import OpenEXR

    if not np.isfinite(rgb).all() or np.isnan(depth).any():
        raise ValueError("a picture must be finite to be written, got NaN or infinity")
    channels = {"RGB": np.ascontiguousarray(rgb, np.float32), "Z": np.ascontiguousarray(depth, np.float32)}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, "whiteLuminance": 1.0}
    with appearing(path) as beside:
        OpenEXR.File(header, channels).write(str(beside))
