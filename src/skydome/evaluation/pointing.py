"""Where each scan's instrument really looked: a turn about the vertical and a lean, fitted apart from any air.

A measured azimuth is known to a few degrees only, and near the sun light changes by a tenth in a degree. What a model
is off by with its scans pointed anew is its own error; how far they had to be pointed stands beside it.
"""

from dataclasses import dataclass, replace

import numpy as np

from skydome.evaluation.evaluation import Comparison, SkyOf, band_mean, compared
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.ground.directions import angle_between, rotate_about_vertical
from skydome.ground.units import deg

MOST_TURN, MOST_LEAN = 8 * deg, 4 * deg
"""Limits of the fit."""


@dataclass(frozen=True, eq=False)
class Pointing:
    """Of each scan (C,), radians: the turn of its directions clockwise, and their lean toward east and north."""

    turn: np.ndarray
    east: np.ndarray
    north: np.ndarray

    @property
    def tilt(self) -> np.ndarray:
        """How far the vertical leans, radians, (C,)."""
        return np.asarray(np.hypot(self.east, self.north))

    def applied(self, sky: MeasuredSky) -> MeasuredSky:
        """The measured sky with its directions pointed so; samples that were valid stay so."""
        parts = zip(sky.directions, self.turn, self.east, self.north, strict=True)
        directions = np.stack([pointed(views, *angles) for views, *angles in parts])
        angles = angle_between(directions, sky.suns[:, None, :])
        return replace(sky, directions=directions, sun_angles=np.asarray(angles))


def pointed(views: np.ndarray, turn: float, east: float, north: float) -> np.ndarray:
    """Directions (D, 3) turned clockwise about the vertical, then leant with it toward east and north, radians.

    >>> pointed(np.array([[0.0, 0.0, 1.0]]), 1.0, 0.01, 0.0).round(4).tolist()
    [[0.01, 0.0, 1.0]]
    """
    turned = np.asarray(rotate_about_vertical(views, turn))
    lean = np.hypot(east, north)
    axis = np.array([-north, east, 0.0]) / max(lean, 1e-300)
    along = (turned @ axis)[:, None] * axis
    return np.asarray(turned * np.cos(lean) + np.cross(axis, turned) * np.sin(lean) + along * (1 - np.cos(lean)))


def fitted_pointing(sky: MeasuredSky, skies: list[SkyOf]) -> Pointing:
    """The pointing of each scan that makes its measure least under its model, by least squares."""
    found = [pointing_of(sky.some([k]), make) for k, make in enumerate(skies)]
    return Pointing(*np.transpose(found))


def pointing_of(scan: MeasuredSky, make: SkyOf) -> np.ndarray:
    """Turn and leans (3,) of a sky of one scan."""
    from scipy.optimize import least_squares

    use, limits = scan.valid[0], np.array([MOST_TURN, MOST_LEAN, MOST_LEAN])
    measured, views = scan.band()[0, use], scan.directions[0, use]
    model = make(scan.suns[0], float(scan.sun_distances[0]))

    def residuals(steps: np.ndarray) -> np.ndarray:
        return np.asarray((band_mean(model, pointed(views, *(steps * limits))) - measured) / measured.mean())

    return np.asarray(least_squares(residuals, np.zeros(3), bounds=(-1, 1), diff_step=0.01, xtol=1e-4).x * limits)


@dataclass(frozen=True, eq=False)
class Repointed:
    """A model against the sky whose scans were pointed for it."""

    comparison: Comparison
    pointing: Pointing

    @classmethod
    def of(cls, name: str, sky: MeasuredSky, skies: list[SkyOf]) -> "Repointed":
        """Fitted to each scan of a sky; `skies` has the model of each."""
        pointing = fitted_pointing(sky, skies)
        anew = pointing.applied(sky)
        parts = [compared(name, anew.some([k]), make) for k, make in enumerate(skies)]
        light, xyz = (np.concatenate([getattr(part, field) for part in parts]) for field in ("model", "model_xyz"))
        return cls(Comparison(name, anew, light, xyz), pointing)

    def figures(self) -> dict[str, float]:
        """Errors with the scans pointed anew, and by how much they were, degrees."""
        return {
            "pointed_error": float(self.comparison.errors().mean()),
            "pointed_error_beyond_20_degrees": float(self.comparison.errors(beyond=True).mean()),
            "turn_least_deg": float(self.pointing.turn.min() / deg),
            "turn_most_deg": float(self.pointing.turn.max() / deg),
            "tilt_mean_deg": float(self.pointing.tilt.mean() / deg),
        }
