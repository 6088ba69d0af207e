"""The tables as textures in the layout that Bruneton's demo and three-geospatial read, and files of them.

Texel order: transmittance (radius, view), irradiance (height, sun), scattering (radius, view, angle x sun), all RGBA;
RGB are the wavelengths from the longest. Scattering: RGB is Rayleigh's single scattering without its phase function and
all higher orders over Rayleigh's phase function; A is the red of the haze's single scattering. Irradiance is that of
the sky alone. The readers have the published sizes built in, and the parameters of the air besides.
"""

import json
from abc import ABC, abstractmethod
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.air.phase_laws import Rayleigh
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.ground.writing import appearing
from skydome.skies.physical.precomputed.grid import PUBLISHED, Sizes
from skydome.skies.physical.precomputed.tables import ScatteringTables

BANDS = (440.0, 550.0, 680.0)
"""Wavelengths, nm, at which both readers stand: blue, green, red."""
DEMO_LOWEST_SUN = float(np.cos(np.radians(102.0)))
GEOSPATIAL_LOWEST_SUN = float(np.cos(np.radians(120.0)))
"""Cosines of the lowest suns' zenith angles that the demo and three-geospatial have built in."""


@dataclass(frozen=True, eq=False)
class ScatteringTextures:
    """Transmittance, scattering and irradiance as RGBA texels, and the `parameters` that a reader must be told.

    >>> import skydome as sd
    >>> from skydome.skies.physical.precomputed.grid import SMALL
    >>> tables = sd.ScatteringTables.of(sd.Atmosphere.bruneton2016(), BANDS, 4, SMALL, DEMO_LOWEST_SUN)
    >>> ScatteringTextures.of(tables).scattering.shape
    (12, 24, 144, 4)
    """

    transmittance: np.ndarray
    """(radii, views, 4), A is 1."""
    scattering: np.ndarray
    """(radii, views, angles x suns, 4), W m-2 nm-1."""
    irradiance: np.ndarray
    """(heights, suns, 4), W m-2 nm-1, A is 1."""
    parameters: dict[str, Any]

    @classmethod
    def of(cls, tables: ScatteringTables) -> "ScatteringTextures":
        """Those of tables at three wavelengths; ValueError for others, and for air without molecules."""
        require_kind(tables, ScatteringTables, "tables", "ScatteringTables.of(atmosphere, wavelengths)")
        if tables.wavelengths.size != 3:
            raise ValueError(f"textures need tables at three wavelengths, got {tables.wavelengths.size}")
        if not isinstance(tables.laws[0], Rayleigh):
            raise ValueError(
                f"the first of the air that scatters must be molecules, got {type(tables.laws[0]).__name__}"
            )
        air, sun = tables.orders.air, tables.atmosphere.sun_at(tables.wavelengths)
        through = np.exp(-air.depth)
        light = (scattering_texels(tables) * np.concatenate([sun[::-1], sun[-1:]])).astype(np.float32)
        return cls(with_one(through[..., ::-1]), light, with_one((irradiance(tables) * sun)[..., ::-1]), told(tables))


def with_one(rgb: np.ndarray) -> np.ndarray:
    """RGB (..., 3) with an A of 1."""
    return np.concatenate([rgb, np.ones((*rgb.shape[:-1], 1))], axis=-1).astype(np.float32)


def rayleigh_phase(nu: np.ndarray) -> np.ndarray:
    """The readers' phase function of molecules, sr-1."""
    return np.asarray(3 / (16 * np.pi) * (1 + nu**2))


def scattering_texels(tables: ScatteringTables) -> Array:
    """RGBA (radii, views, angles x suns, 4) of scattering, for a sun of 1."""
    _, views, suns, angles = tables.orders.nodes
    middle, spread = views[..., None] * suns, np.sqrt((1 - views[..., None] ** 2) * (1 - suns**2))
    nu = np.clip(angles, (middle - spread)[..., None], (middle + spread)[..., None])
    rgb = tables.once[0] + tables.multiple / rayleigh_phase(nu)[..., None]
    red = tables.once[1:, ..., -1].sum(axis=0)
    texels = np.concatenate([rgb[..., ::-1], red[..., None]], axis=-1)  # (R, V, S, A, 4)
    return np.moveaxis(texels, 3, 2).reshape(*texels.shape[:2], -1, 4).astype(np.float32)


def irradiance(tables: ScatteringTables) -> Array:
    """The sky's irradiance of the horizontal at even heights under even cosines of the sun, (heights, suns, W)."""
    rows, columns = tables.orders.sizes.irradiance
    radii, suns = np.linspace(tables.shell.bottom, tables.shell.top, rows), np.linspace(-1, 1, columns)
    orders = tables.orders
    return np.asarray(orders.fall_on(radii, suns, 1, tables.once, tables.multiple) + orders.fall_on(
        radii, suns, 2, tables.once, tables.multiple
    ))  # fmt: skip


def told(tables: ScatteringTables) -> dict[str, Any]:
    """What a reader must be told of the air, by three-geospatial's names; coefficients at the ground, km-1."""
    air, w, sun = tables.atmosphere, tables.wavelengths, tables.atmosphere.sun_at(tables.wavelengths)
    ground = 1000 * tables.orders.air.scattering[0, :, ::-1]
    extinction = 1000 * sum(part.profile.density(0.0) * part.depth(w) for part in air.constituents)[::-1]
    mean = [float(law.mean_cosine([w[-1]])[0]) for law in tables.laws[1:]]
    return {
        "wavelengths": w[::-1].tolist(),
        "solarIrradiance": sun[::-1].tolist(),
        "bottomRadius": tables.shell.bottom,
        "topRadius": tables.shell.top,
        "muSMin": tables.shell.lowest_sun,
        "rayleighScattering": ground[0].tolist(),
        "mieScattering": ground[1:].sum(axis=0).tolist(),
        "extinction": extinction.tolist(),
        "miePhaseFunctionG": mean[0] if mean else 0.0,
        "groundAlbedo": air.albedo_at(w)[::-1].tolist(),
        "sizes": list(shapes(tables.orders.sizes)["scattering"][:3]),
    }


def shapes(sizes: Sizes) -> dict[str, tuple[int, ...]]:
    """Shapes of the three textures."""
    return {
        "transmittance": (*sizes.transmittance, 4),
        "scattering": (sizes.heights, sizes.views, sizes.angles * sizes.suns, 4),
        "irradiance": (*sizes.irradiance, 4),
    }


@dataclass(frozen=True)
class TextureFiles(ABC):
    """A form of files: `transmittance`, `scattering`, `irradiance` and atmosphere.json in a folder."""

    suffix: str

    @abstractmethod
    def write(self, path: Path, texels: np.ndarray) -> None:
        """Write one texture."""

    @abstractmethod
    def read(self, path: Path, shape: tuple[int, ...]) -> np.ndarray:
        """Texels of one texture, float32; ValueError where the file has another size."""

    def save(self, textures: ScatteringTextures, folder: str | PathLike[str]) -> None:
        """Write all of them into a folder, which is made where it is missing."""
        place = Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        for name in shapes(PUBLISHED):
            self.write(place / f"{name}{self.suffix}", getattr(textures, name))
        with appearing(place / "atmosphere.json") as beside:
            beside.write_text(json.dumps(textures.parameters, indent=1), "utf-8")

    def load(self, folder: str | PathLike[str], sizes: Sizes = PUBLISHED) -> ScatteringTextures:
        """Those in a folder, of so many texels."""
        place = Path(folder)
        texels = {name: self.read(place / f"{name}{self.suffix}", shape) for name, shape in shapes(sizes).items()}
        known = place / "atmosphere.json"
        return ScatteringTextures(**texels, parameters=json.loads(known.read_text("utf-8")) if known.exists() else {})


@dataclass(frozen=True)
class RawFiles(TextureFiles):
    """Texels one after the other, RGBA, little-endian, without a header."""

    kind: str

    def write(self, path: Path, texels: np.ndarray) -> None:
        """Write one texture."""
        with appearing(path) as beside:
            beside.write_bytes(texels.astype(self.kind).tobytes())

    def read(self, path: Path, shape: tuple[int, ...]) -> np.ndarray:
        """Texels of one texture."""
        expected = int(np.prod(shape)) * np.dtype(self.kind).itemsize
        if path.stat().st_size != expected:
            raise ValueError(f"{path} must have {expected} bytes for texels {shape}, got {path.stat().st_size}")
        return np.frombuffer(path.read_bytes(), self.kind).reshape(shape).astype(np.float32)


@dataclass(frozen=True)
class ExrFiles(TextureFiles):
    """OpenEXR of half floats, RGBA, the last row first, slices of a volume one below the other."""

    def write(self, path: Path, texels: np.ndarray) -> None:
        """Write one texture."""
        from skydome.ground import exr

        exr.write(path, {"RGBA": texels.reshape(-1, *texels.shape[-2:])[::-1]}, half=True)

    def read(self, path: Path, shape: tuple[int, ...]) -> np.ndarray:
        """Texels of one texture; A, which `exr.read` leaves out, is read beside."""
        import OpenEXR

        channels = OpenEXR.File(str(path), separate_channels=True).channels()
        texels = np.stack([np.asarray(channels[name].pixels, dtype=np.float32) for name in "RGBA"], axis=-1)
        if texels.size != np.prod(shape):
            raise ValueError(f"{path} must have texels {shape}, got {texels.shape}")
        return texels[::-1].reshape(shape)


DEMO = RawFiles(".dat", "<f4")
"""Bruneton's WebGL demo."""
GEOSPATIAL = RawFiles(".bin", "<f2")
"""three-geospatial (takram), format 'binary'."""
GEOSPATIAL_EXR = ExrFiles(".exr")
"""three-geospatial, format 'exr', its usual one."""
