"""The notice that light is asked for where real air absorbs by gases that an air lacks."""

import warnings

import numpy as np
from numpy.typing import ArrayLike

GAS_BANDS = (
    ("oxygen band at 687 nm", 686.0, 695.0),
    ("water band at 720 nm", 714.0, 736.0),
    ("oxygen band at 761 nm", 758.0, 771.0),
    ("water band at 820 nm", 810.0, 838.0),
    ("water band at 940 nm", 890.0, 1000.0),
    ("gas beyond 1080 nm", 1080.0, float("inf")),
)
"""Absorption of the earth's gases by name, from and to, nm (told by the measured sky of 2013)."""


class MissingBands(UserWarning):
    """Light is asked for where the real air absorbs by gases that the air here does not have."""


def tell_missing_bands(wavelengths: ArrayLike) -> None:
    """`MissingBands`, a warning, where wavelengths lie in bands of the earth's gases."""
    w = np.ravel(wavelengths)
    met = [name for name, low, high in GAS_BANDS if ((w >= low) & (w <= high)).any()]
    if met:
        warnings.warn(
            f"the air has no {', '.join(met)}: there the sky comes out too bright (761 nm by 73 %, 940 nm by 56 %); "
            "give it gases=Gases()",
            MissingBands,
            stacklevel=5,
        )
