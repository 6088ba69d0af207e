"""The page as a widget of notebooks (Jupyter, marimo), from the same files."""

from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from skydome.explorer.address import address, address_of
from skydome.ground.extras import required
from skydome.skies.sky import Sky


def explore(sky: Sky | None = None, **state: Any) -> Any:
    """The explorer in a notebook, an anywidget: drag the sun, read the light; `address` tells what is shown.

    `sky` is one of the catalogue, without it a usual one; `state` are values by their names in the page's address, such
    as view="panorama". Setting `address` changes what is shown. ImportError without anywidget, TypeError for a sky that
    the page does not know.

    >>> import skydome as sd
    >>> widget = sd.explore(sd.HosekWilkie(sd.direction(0.0, 0.5), turbidity=2.5), view="panorama")
    >>> widget.address
    '?v=1&model=hosek-wilkie&sun=0,28.64789&turbidity=2.5&albedo=0.2&view=panorama'
    """
    given = address(**state) if sky is None else address_of(sky) + address(**state).removeprefix("?v=1")
    return widget_class()(address=given)


@cache
def widget_class() -> Any:
    """The widget's class, made when it is first asked for."""
    anywidget = required("anywidget", "jupyter", "the explorer in a notebook")
    traitlets = required("traitlets", "jupyter", "the explorer in a notebook")
    page = Path(str(files("skydome.explorer") / "page"))

    class Explorer(anywidget.AnyWidget):  # type: ignore[misc, name-defined]
        """The page's own module and style sheet in a cell."""

        _esm = page / "explorer.js"
        _css = page / "explorer.css"
        address = traitlets.Unicode("").tag(sync=True)

    return Explorer
