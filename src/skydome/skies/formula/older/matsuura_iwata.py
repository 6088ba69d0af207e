"""Matsuura and Iwata's sky between clear and overcast, the third model of Radiance's gensky."""

from dataclasses import dataclass
from typing import ClassVar

from skydome.skies.cie import CIEIntermediate


@dataclass(frozen=True, eq=False)
class MatsuuraIwata(CIEIntermediate):
    """The sky that Mardaljevic and others name after Matsuura and Iwata: gensky's model of option i.

    Its formula is the CIE's intermediate one (`CIEIntermediate`), as gensky and CIE 110 have it; level by
    zenith_luminance, cd m-2, or illuminance, lx. Their model of all weather mixes a clear, an intermediate and an
    overcast sky: `blend` does so, with shares of one's own.

    >>> import skydome as sd
    >>> sky = sd.MatsuuraIwata(sd.direction(azimuth=0.0, elevation=0.6), illuminance=20_000.0)
    >>> bool(abs(sd.illuminance(sky) / 20_000 - 1) < 1e-3)
    True
    """

    source: ClassVar[str] = "Matsuura and Iwata 1990; Radiance, skybright.cal"
