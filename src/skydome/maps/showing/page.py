"""What people see of a thing: in a notebook a table with units and a picture, on Matplotlib's axes a map."""

from base64 import b64encode
from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.maps.equirectangular import Equirectangular

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COMPASS = {0: "N", 90: "E", 180: "S", 270: "W"}


def table_of(title: str, rows: Mapping[str, str], picture: bytes | None = None) -> str:
    """A title, names and values as a table, and a PNG, as HTML that asks nothing of the net.

    >>> table_of("Sky", {"sun": "5 < 6"})
    '<div><strong>Sky</strong><table><tr><th>sun</th><td>5 &lt; 6</td></tr></table></div>'
    """
    body = "".join(f"<tr><th>{escape(name)}</th><td>{escape(value)}</td></tr>" for name, value in rows.items())
    shown = (
        ""
        if picture is None
        else f'<img style="display:block" alt="{escape(title)}" src="data:image/png;base64,{encoded(picture)}"/>'
    )
    return f"<div><strong>{escape(title)}</strong>{shown}<table>{body}</table></div>"


def encoded(picture: bytes) -> str:
    """Bytes as text within a page."""
    return b64encode(picture).decode("ascii")


def own_axes(width: float = 6.0, height: float = 5.5) -> "Axes":
    """Axes of a figure of their own, in inches, drawn by Agg."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained", dpi=100)
    FigureCanvasAgg(figure)
    return figure.add_subplot()


def draw_map(projection: Any, picture: np.ndarray, ax: "Axes | None") -> "Axes":
    """A developed map (H, W, 3) on axes: angles and compass letters along an equirectangular one, none else."""
    rows, columns, _ = picture.shape
    ax = own_axes(8.0, 0.8 + 8.0 * rows / columns) if ax is None else ax
    if not isinstance(projection, Equirectangular):
        ax.imshow(picture)
        ax.set_axis_off()
        return ax
    ax.imshow(picture, extent=(0.0, 360.0, -90.0, 90.0), aspect="equal")
    left, turn = np.degrees(projection.azimuth_left), -1 if projection.mirrored else 1
    places = {(turn * (azimuth - left)) % 360: letter for azimuth, letter in COMPASS.items()}
    ax.set_xticks(list(places), list(places.values()))
    ax.set_yticks(range(-90, 91, 30))
    ax.set_ylabel("elevation, degrees")
    return ax
