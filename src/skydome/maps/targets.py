"""Where each renderer puts north, and which numbers it takes: one small table."""

import math
from dataclasses import dataclass, field

import numpy as np

from skydome.ground.arguments import require_word
from skydome.light.colour import RADIANCE, REC2020, SRGB, RGBSpace
from skydome.maps.projections import (
    CubeMap,
    EqualAreaSquare,
    Equidistant,
    Equirectangular,
    Equisolid,
    Fisheye,
    LevelProbe,
    Projection,
)

Matrix = tuple[tuple[float, float, float], ...]
Z_UP: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))  # x east, y north, z up: ours
Y_UP: Matrix = ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0))  # x east, y up, z south


@dataclass(frozen=True)
class Target:
    """A renderer's convention: how its map is laid out, and which of its axes are east, north and up.

    `to_frame` turns our vectors (x east, y north, z up) into the renderer's: `v @ np.array(to_frame).T`. `spaces` are
    the only RGB spaces that it takes the numbers for; none named: it reads the file's primaries, or can be told them.
    `only_half`: it keeps light in half floats, whatever the file has.
    """

    name: str
    projection: Projection
    to_frame: Matrix
    note: str
    source: str = field(repr=False)
    spaces: tuple[RGBSpace, ...] = field(default=(), repr=False)
    only_half: bool = field(default=False, repr=False)

    def frame_vectors(self, directions: np.ndarray) -> np.ndarray:
        """Directions (..., 3) of ours as the renderer's vectors (..., 3).

        >>> target("usd").frame_vectors(np.array([0.0, 1.0, 0.0])).tolist()   # north
        [0.0, 0.0, -1.0]
        """
        turned: np.ndarray = np.asarray(directions) @ np.array(self.to_frame).T
        return turned

    def takes(self, space: RGBSpace) -> bool:
        """Whether numbers in that RGB space are seen in their own colours there.

        >>> target("mitsuba").takes(SRGB), target("mitsuba").takes(REC2020), target("pbrt").takes(REC2020)
        (True, False, True)
        """
        return not self.spaces or space in self.spaces


NORTH_LEFT = Equirectangular()
SOUTH_LEFT = Equirectangular(azimuth_left=math.pi)
WEST_LEFT = Equirectangular(azimuth_left=1.5 * math.pi)

ANGULAR = LevelProbe(Fisheye(2 * math.pi, Equidistant()))
MIRROR_BALL = LevelProbe(Fisheye(2 * math.pi, Equisolid()))
PROBE = "looking level: north in the middle, up at the top, east at the right, south at the rim"
SKY_DISC = "the sky looking up, equidistant: north at the top, east at the left"

TARGETS: tuple[Target, ...] = (
    Target("native", NORTH_LEFT, Z_UP, "z up; north at the left edge, south at the centre", "this library"),
    Target("blender", WEST_LEFT, Z_UP, "z up; east (+X) at the centre", "Blender, camera/projection.h"),
    Target("mitsuba", NORTH_LEFT, Y_UP, "y up; south (+Z) at the centre", "Mitsuba 3, envmap.cpp", (SRGB,)),
    Target("openexr", NORTH_LEFT, Y_UP, "y up; south (+Z) at the centre; texel centres", "OpenEXR, ImfEnvmap.h"),
    Target("usd", NORTH_LEFT, Y_UP, "y up, on z-up stages too; south (+Z) at the centre", "usdLux schema.usda"),
    Target("three", WEST_LEFT, Y_UP, "y up; east (+X) at the centre", "three.js, equirectUv", (SRGB,), only_half=True),
    Target("skylibs", SOUTH_LEFT, Y_UP, "y up; north (-Z) at the centre", "skylibs, envmap/projections.py"),
    Target(
        "pbrt",
        EqualAreaSquare(),
        Z_UP,
        "z up in the middle, +X right, +Y at the bottom",
        "pbrt-v4, Clarberg 2008",
        (SRGB, REC2020),
    ),
    Target("radiance", NORTH_LEFT, Z_UP, "z up; the .rad of `--scene` lays it out", "this library", (RADIANCE,)),
    Target("cube", CubeMap(), Y_UP, "y up; strip of faces +X -X +Y -Y +Z -Z", "OpenGL 4.6, table 8.19"),
    Target("angular", ANGULAR, Y_UP, f"y up; {PROBE}", "Debevec 1998, light probes"),
    Target("mirror-ball", MIRROR_BALL, Y_UP, f"y up; {PROBE}", "Debevec 1998, light probes"),
    Target("fisheye", Fisheye(), Z_UP, SKY_DISC, "as sky plots are drawn"),
)


def target(name: str) -> Target:
    """The renderer's convention by name; ValueError lists the names there are.

    >>> target("pbrt").projection
    EqualAreaSquare()
    """
    known = {entry.name: entry for entry in TARGETS}
    return known[require_word(name, known, "target")]
