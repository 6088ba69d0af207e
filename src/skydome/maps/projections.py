"""Every projection by name."""

from skydome.maps.cube import CubeMap
from skydome.maps.equal_area_square import EqualAreaSquare
from skydome.maps.equirectangular import Equirectangular, EquirectangularOfWidth
from skydome.maps.fisheye import Equidistant, Equisolid, Fisheye, Lens
from skydome.maps.level_probe import LevelProbe
from skydome.maps.projection import Projection
from skydome.maps.sky_view import SkyView

__all__ = [
    "CubeMap",
    "EqualAreaSquare",
    "Equidistant",
    "Equirectangular",
    "EquirectangularOfWidth",
    "Equisolid",
    "Fisheye",
    "Lens",
    "LevelProbe",
    "Projection",
    "SkyView",
]
