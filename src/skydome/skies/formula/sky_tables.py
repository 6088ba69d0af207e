"""Tables of a sky model in Hosek and Wilkie's form: the nine numbers as quintic Bezier curves of the sun's height.

They stand at nodes of turbidity and ground albedo, linear between them, for bands of wavelengths, linear in radiance.
`skydome.own_air.bezier_family` makes them for air of one's own; `HosekWilkie(..., tables=...)` is their sky.
"""

from dataclasses import dataclass, fields
from os import PathLike
from typing import Any

import numpy as np

from skydome.ground.arrays import Array, at_least, constant, limited, namespace
from skydome.ground.files.reading import arrays_in
from skydome.ground.interpolation import weights

BINOMIAL = np.array([1.0, 5.0, 10.0, 10.0, 5.0, 1.0])
POINTS = BINOMIAL.size
FORM = 1
"""Number of the file's layout."""
MOST_BYTES = 256 * 2**20
"""Size, unpacked, above which a file is refused."""


def control_weights(sun_elevation: Array) -> Array:
    """Weights of the six control points, (..., 6): Bernstein polynomials in (elevation / 90 deg)^(1/3)."""
    s = (limited(sun_elevation, 1e-12, np.pi / 2) / (np.pi / 2)) ** (1 / 3)
    k = constant(np.arange(6.0), s)
    s = s[..., None]
    return constant(BINOMIAL, s) * s**k * (1 - s) ** (5 - k)


def held_weights(nodes: np.ndarray, value: Array) -> Array:
    """Linear weights of `nodes` (N,) at each value (...,), (..., N); held beyond the ends."""
    return weights(nodes, limited(value, float(nodes[0]), float(nodes[-1])))


def blended(table: np.ndarray, turbidity: Array, albedo: Array, control: Array) -> Array:
    """Coefficients (..., channels, 10) of a table (T, A, 6, channels, 10), by weights of its first three axes.

    `turbidity` (..., T), `control` (..., 6), `albedo` (..., 1 or channels, A).
    """
    xp = namespace(turbidity, control)
    nodes, albedos, _, channels, _ = table.shape
    both = turbidity[..., :, None] * control[..., None, :]
    both = xp.reshape(both, (*tuple(both.shape)[:-2], nodes * POINTS))
    numbers = both @ constant(table.transpose(0, 2, 1, 3, 4).reshape(nodes * POINTS, -1), both)
    numbers = xp.reshape(numbers, (*tuple(numbers.shape)[:-1], albedos, channels, 10))
    first = numbers[..., 0, :, :] * albedo[..., 0, None]
    return sum((numbers[..., k, :, :] * albedo[..., k, None] for k in range(1, albedos)), first)


@dataclass(frozen=True, eq=False)
class SkyTables:
    """Control points (T, A, 6, W, 10) of R A ... I for turbidities (T,), albedos (A,) and wavelengths (W,), nm.

    Light is in W m-2 sr-1 nm-1. `lowest` is the least elevation of the sun that was fitted, radians: a lower sun is
    taken as standing there. `error` (T, A, W): relative RMS error of each fit. ValueError for what does not agree.
    """

    turbidities: np.ndarray
    albedos: np.ndarray
    wavelengths: np.ndarray
    control: np.ndarray
    error: np.ndarray
    lowest: float = 0.0

    def __post_init__(self) -> None:
        for name in ("turbidities", "albedos", "wavelengths", "control", "error"):
            object.__setattr__(self, name, np.asarray(getattr(self, name), dtype=np.float64))
        for name in ("turbidities", "albedos", "wavelengths"):
            nodes = getattr(self, name)
            if nodes.ndim != 1 or not nodes.size or not np.isfinite(nodes).all() or (np.diff(nodes) <= 0).any():
                raise ValueError(f"{name} of sky tables must be a row of rising numbers, got {nodes.tolist()}")
        counts = self.turbidities.size, self.albedos.size, self.wavelengths.size
        wanted = (*counts[:2], POINTS, counts[2], 10)
        if self.control.shape != wanted or self.error.shape != counts:
            raise ValueError(
                f"control points of shape {wanted} and errors {counts} are needed, got {self.control.shape} and "
                f"{self.error.shape}"
            )
        if not np.isfinite(self.control).all() or not 0 <= self.lowest < np.pi / 2:
            raise ValueError("control points must be finite, and the lowest sun lie in [0, 90) degrees")

    def coefficients(self, turbidity: Array, albedo: Array, sun_elevation: Array) -> Array:
        """R A ... I of every band, shape (..., W, 10); `albedo` (..., 1) or (..., W)."""
        control = control_weights(at_least(sun_elevation, self.lowest))
        shares = (held_weights(self.turbidities, turbidity), held_weights(self.albedos, albedo))
        return blended(self.control, *shares, control)

    def save(self, path: str | PathLike[str]) -> None:
        """Write to a .npz file, whole or not at all."""
        from skydome.ground.writing import appearing

        with appearing(path) as beside, beside.open("wb") as file:
            np.savez_compressed(file, sky_tables=FORM, **vars(self))

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "SkyTables":
        """From a .npz file; nothing in it is ever run. ValueError for a file that holds something else, or too much.

        >>> import tempfile
        >>> folder = tempfile.mkdtemp()
        >>> SkyTables([3.0], [0.1], [550.0], np.ones((1, 1, 6, 1, 10)), [[[0.01]]]).save(f"{folder}/one.npz")
        >>> SkyTables.load(f"{folder}/one.npz").control.shape
        (1, 1, 6, 1, 10)
        """
        held: dict[str, Any] = dict(
            arrays_in(path, "sky tables", {"sky_tables", *(item.name for item in fields(cls))}, MOST_BYTES)
        )
        wrong = sorted(name for name, value in held.items() if value.dtype.kind not in "fiu")
        if wrong:
            raise ValueError(f"{path} is damaged: {wrong[0]} must be numbers, got {held[wrong[0]].dtype}")
        if held.pop("sky_tables").tolist() != FORM:
            raise ValueError(f"{path} holds sky tables of another form than {FORM}")
        lowest = held.pop("lowest")
        if lowest.shape != ():
            raise ValueError(f"{path} is damaged: the lowest sun must be one number, got shape {lowest.shape}")
        return cls(**held, lowest=float(lowest))
