"""What every sky can do for those who look: a picture and a table with units in a notebook, a plot on axes."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from skydome.ground import png
from skydome.ground.arrays import Array, as_numpy
from skydome.ground.directions import ZENITH, azimuth, elevation
from skydome.ground.extras import required
from skydome.ground.units import deg
from skydome.maps.pixels import MapPixels
from skydome.maps.projections import Fisheye
from skydome.maps.showing.page import own_axes, table_of
from skydome.maps.showing.preview import preview

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIDE = 160
"""Pixels across the picture of a sky."""


class Shown:
    """A sky's looks; what it needs of a sky is `luminance`, `parameters` and `ranges`."""

    ranges: ClassVar[Mapping[str, Any]]
    quick_to_see: ClassVar[bool] = True
    """Whether its light toward some thousand directions is soon there, so that a notebook shows a picture."""

    @property
    def parts(self) -> tuple[Any, ...]:
        """The skies of which this one is the sum."""
        return (self,)

    @property
    def pictured(self) -> bool:
        """Whether a notebook shows a picture: all of its parts are quick to see."""
        return all(part.single[0].quick_to_see for part in self.parts)

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2."""
        raise NotImplementedError

    def parameters(self) -> dict[str, Any]:
        """Class name and parameters."""
        raise NotImplementedError

    def screen_rgb(self, directions: Array) -> Array:
        """Linear sRGB (..., 3) by which a picture shows the sky: grey where no colour is known."""
        return np.asarray(as_numpy(self.luminance(directions)))[..., None] * np.ones(3)

    def plot(self, ax: "Axes | None" = None) -> "Axes":
        """The sky looking up in false colour, cd m-2, on `ax` or on axes of its own: north up, east at the left.

        >>> import skydome as sd
        >>> sd.MoonSpencer(zenith_luminance=9000.0).plot().get_aspect()
        1.0
        """
        required("matplotlib", "plot", "a plot")
        from skydome.maps.showing.dome_axes import draw_compass, draw_luminance

        self._require_one()
        ax = own_axes() if ax is None else ax
        draw_luminance(ax, self)
        draw_compass(ax)
        return ax

    def _require_one(self) -> None:
        """ValueError for a sky of many conditions, which is no one picture."""
        shape = np.shape(as_numpy(self.luminance(ZENITH)))
        if shape:
            raise ValueError(f"one sky can be shown at a time, got one of shape {shape}")

    def _repr_png_(self) -> bytes | None:
        """The sky looking up as a notebook shows it; None for a sky of many conditions, or one slow to ask."""
        if not self.pictured or np.shape(as_numpy(self.luminance(ZENITH))):
            return None
        dome = Fisheye()
        rgb = np.asarray(as_numpy(self.screen_rgb(dome.directions(SIDE))), dtype=np.float64)
        rgb = np.where(dome.valid(SIDE)[..., None] & np.isfinite(rgb), rgb, 0.0)
        picture = preview(MapPixels(rgb, dome))
        picture[~dome.valid(SIDE)] = 1.0
        return png.as_bytes(picture)

    def _repr_html_(self) -> str:
        """A table of the sky's parameters with their units, and its picture."""
        told = self.parameters()
        rows = {name: self._told(name, value) for name, value in told.items() if name not in ("model", "check")}
        if self.pictured and not np.shape(as_numpy(zenith := self.luminance(ZENITH))):
            rows["luminance at the zenith"] = f"{float(zenith):,.5g} cd m⁻²"
        shown = {name.replace("_", " "): value for name, value in rows.items() if value}
        return table_of(told["model"], shown, self._repr_png_())

    def _told(self, name: str, value: Any) -> str:
        """A parameter as text, with its unit where it has one; "" for what is not given."""
        if value is None or isinstance(value, dict):
            return "" if value is None else str(value.get("model", ""))
        if name == "sun" and np.shape(value) == (3,):
            toward = np.asarray(value, dtype=float)
            return f"azimuth {float(azimuth(toward)) / deg:.2f}°, elevation {float(elevation(toward)) / deg:.2f}°"
        if name == "members":
            return " + ".join(str(member["model"]) for member in value)
        unit = getattr(self.ranges.get(name), "unit", "")
        text = f"{value:.6g}" if isinstance(value, float) else str(value)
        return f"{text} {unit}".strip() if len(text) < 80 else f"{text[:76]} ..."
