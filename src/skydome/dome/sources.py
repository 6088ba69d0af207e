"""Skies ready to be painted: each kind knows its rows of an equirectangular map, or its light toward any direction."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from skydome.dome.dome_rows import paint_dome
from skydome.dome.held_rows import held_kernel, paint_held
from skydome.dome.integrals import colourless
from skydome.dome.network_rows import NetworkLight, network_kernel, paint_network, rgb_network
from skydome.dome.sky_rows import paint
from skydome.ground.arrays import as_numpy
from skydome.light.colour import RGBSpace
from skydome.maps.equirectangular import Equirectangular
from skydome.skies.colour_sky import ColourSky
from skydome.skies.formula.fast import Light, chosen, many_skies
from skydome.skies.neural.fast import light_by_kernel, light_by_numpy
from skydome.skies.night.held_dome import HeldDome
from skydome.skies.physical.held import HeldSky
from skydome.skies.sky import Sky


@dataclass(frozen=True, eq=False)
class Source(ABC):
    """A `sky` in the colours of a `space`; `kernel`: the compiled module to take, None for NumPy."""

    sky: Sky
    space: RGBSpace
    kernel: Any
    has_rows: ClassVar[bool] = True
    """Whether it can paint rows."""

    def paint(self, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
        """Write rows of a map, all above the horizon, into `out` (r, W, 3)."""
        raise TypeError(f"{type(self).__name__} paints no rows")

    @abstractmethod
    def toward(self, directions: np.ndarray) -> np.ndarray:
        """RGB toward directions (..., 3), (..., 3)."""


@dataclass(frozen=True, eq=False)
class AnySource(Source):
    """A sky that is asked direction by direction."""

    has_rows: ClassVar[bool] = False

    def toward(self, directions: np.ndarray) -> np.ndarray:
        """As the sky itself says."""
        if not isinstance(self.sky, ColourSky):
            raise TypeError(colourless(self.sky))
        return as_numpy(self.sky.rgb(directions, self.space))


@dataclass(frozen=True, eq=False)
class FormulaSource(AnySource):
    """A sky of the nine-number formula."""

    light: Light
    has_rows: ClassVar[bool] = True

    def paint(self, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
        """Each row's factors once."""
        paint(self.kernel, self.light, projection, height, rows, out)

    def toward(self, directions: np.ndarray) -> np.ndarray:
        """Compiled, or as the sky says."""
        if self.kernel is None:
            return super().toward(directions)
        light = np.empty(directions.shape, np.float32)
        many_skies(self.kernel, self.light, directions.reshape(-1, 3), light)
        return light


@dataclass(frozen=True, eq=False)
class NetworkSource(Source):
    """A neural sky, float32."""

    light: NetworkLight

    def paint(self, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
        """What a row shares goes into the biases."""
        paint_network(self.kernel, self.light, projection, height, rows, out)

    def toward(self, directions: np.ndarray) -> np.ndarray:
        """Through the network, compiled or in NumPy."""
        views = directions.reshape(-1, 3).astype(np.float32)
        if self.kernel is not None:
            return light_by_kernel(self.light.network, views, self.kernel, self.light.matrix).reshape(directions.shape)
        shown = light_by_numpy(self.light.network, views) @ self.light.matrix.T.astype(np.float32)
        return shown.reshape(directions.shape)


@dataclass(frozen=True, eq=False)
class HeldSource(AnySource):
    """A sky held in a table, and what multiplies it."""

    held: HeldSky
    factor: float
    has_rows: ClassVar[bool] = True

    def paint(self, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
        """The table's fields for each row once."""
        matrix = self.factor * np.asarray(self.space.from_xyz)
        paint_held(self.kernel, self.held.rows, self.held.sun, matrix, projection, height, rows, out)


@dataclass(frozen=True, eq=False)
class DomeSource(AnySource):
    """A smooth sky on a grid of the dome, `colours` (rings, columns, 3) in the space; several are one."""

    colours: np.ndarray
    has_rows: ClassVar[bool] = True

    def paint(self, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
        """Each row's ring once."""
        paint_dome(self.colours, projection, height, rows, out)

    def toward(self, directions: np.ndarray) -> np.ndarray:
        """Between the grid's places."""
        assert isinstance(self.sky, ColourSky)
        return np.asarray(HeldDome(self.sky, self.colours).xyz(directions))


def sources_of(skies: Sequence[Sky], space: RGBSpace, texels: int) -> list[Source]:
    """The skies ready to be painted, those on grids of the dome as one."""
    sources = [source_of(sky, space, texels) for sky in skies]
    domes = [source for source in sources if isinstance(source, DomeSource)]
    if len(domes) < 2:
        return sources
    whole = replace(domes[0], colours=np.sum([source.colours for source in domes], axis=0))
    return [*(source for source in sources if not isinstance(source, DomeSource)), whole]


def source_of(sky: Sky, space: RGBSpace, texels: int) -> Source:
    """A sky ready to be painted; `texels` of the whole float32 map, 0 for float64, which takes no network's numbers."""
    sky = sky.for_maps
    inner, factor = sky.single
    light = rgb_light(sky, space)
    if light is not None:
        return FormulaSource(sky, space, chosen(3 * texels // 2, light.coefficients) if texels else None, light)
    network = rgb_network(sky, space) if texels else None
    if network is not None:
        return NetworkSource(sky, space, network_kernel(network, texels // 2), network)
    if isinstance(inner, HeldDome):
        return DomeSource(sky, space, None, inner.colours @ (np.asarray(space.from_xyz, np.float32).T * float(factor)))
    if isinstance(inner, HeldSky):
        return HeldSource(sky, space, held_kernel(texels), inner, float(as_numpy(factor)))
    return AnySource(sky, space, None)


def rgb_light(sky: Sky, space: RGBSpace) -> Light | None:
    """The numbers of one nine-number sky's RGB, also of one multiplied or given a colour; None for other skies."""
    inner, factor = sky.single
    light = inner.rgb_formula(space) if isinstance(inner, ColourSky) else None
    return None if light is None else light._replace(quantity=light.quantity.then(float(factor) * np.eye(light.size)))
