"""From a formula's channels to the light asked for: luminance, XYZ, RGB or a spectrum."""

from dataclasses import dataclass, replace

import numpy as np

from skydome.ground.arrays import Array, constant, safe_divide
from skydome.light.colour import xyz_from_xyY


@dataclass(frozen=True, eq=False)
class Quantity:
    """matrix (K, C) times the channels; None is the channels themselves.

    With `chromatic` the channels are x, y, Y and become X, Y, Z first. With `balance` (3,) the XYZ are then multiplied
    by Y / (balance . XYZ): a spectrum's amounts, so that its luminance stays Y.
    """

    matrix: np.ndarray | None = None
    chromatic: bool = False
    balance: np.ndarray | None = None

    def of(self, channels: Array) -> Array:
        """The light (..., K) of channels (..., C); any array library."""
        light = xyz_from_xyY(channels) if self.chromatic else channels
        if self.balance is not None:
            light = light * safe_divide(light[..., 1], light @ constant(self.balance, light))[..., None]
        return light if self.matrix is None else light @ constant(self.matrix.T, light)

    def then(self, matrix: np.ndarray) -> "Quantity":
        """The light `matrix` (K', K) times this one."""
        return replace(self, matrix=matrix if self.matrix is None else matrix @ self.matrix)

    def size(self, channels: int) -> int:
        """Numbers in the light of so many channels: K."""
        return channels if self.matrix is None else len(self.matrix)

    @property
    def gains(self) -> np.ndarray | None:
        """The diagonal (C,) where each channel is only multiplied by a number >= 0, so that a level can take it up."""
        m = self.matrix
        if m is None or self.chromatic or m.shape[0] != m.shape[1] or (m < 0).any() or (m != np.diag(np.diag(m))).any():
            return None
        return np.diag(m)
