"""One air and wavelength under all suns: how far Bezier curves of A, B, E and H are off, and in which way.

The light is linear in the control points of C, D, F, G and I, which follow (variable projection): each ground albedo
has its own, A, B, E and H are shared, so that light mixed between albedos is what it should be.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.directions import direction
from skydome.own_air.family import SkyFamily
from skydome.own_air.refit import basis, fitted
from skydome.skies.formula.perez_formula import gradation_term, indicatrix_terms, view_geometry
from skydome.skies.formula.sky_tables import POINTS, control_weights
from skydome.skies.physical.refitted import OFFSET

CURVES, LINEAR = 4, 5
State = tuple[Array, Array, list[Array]]
"""Differences (A, rows), linear control points (A, 5, 6), and orthonormal bases of the columns."""
RIDGE = 1e-4
"""Residual that stands for a linear control point as large as the mean light: it keeps great sums from cancelling."""


@dataclass(frozen=True, eq=False)
class AllSuns:
    """Geometry (E, D), weights 1 / light (A, E, D) and Bezier weights (E, 6) of light (A, E, D)."""

    family: SkyFamily
    light: np.ndarray
    cosine: np.ndarray
    angle: np.ndarray
    share: np.ndarray
    curve: np.ndarray

    @classmethod
    def of(cls, family: SkyFamily, light: np.ndarray) -> "AllSuns":
        """The problem of light (A, E, D)."""
        views, heights = family.views, family.elevations
        geometry = [view_geometry(views.directions, direction(np.pi, h)) for h in heights]
        cosine, angle = (np.stack([part[k] for part in geometry]) for k in range(2))
        share = np.sqrt(views.solid_angles / views.solid_angles.sum() / heights.size / len(light)) / light
        return cls(family, light, cosine, angle, share, np.asarray(control_weights(heights)))

    def numbers(self, x: np.ndarray) -> Array:
        """A, B, E and H of each sun, (E, 4), of control points (24,)."""
        return self.curve @ x.reshape(CURVES, POINTS).T

    def solved(self, x: np.ndarray) -> State:
        """The state at control points (24,) of A, B, E and H."""
        values = self.numbers(x)
        parts = np.stack([basis(v, c, g) for v, c, g in zip(values, self.cosine, self.angle, strict=True)])
        spread = np.einsum("edl,ep->edlp", parts, self.curve)
        differences, linear, bases = [], [], []
        for light, share in zip(self.light, self.share, strict=True):
            matrix = (spread * share[..., None, None]).reshape(light.size, -1)
            ridge = RIDGE / light.mean() * np.eye(matrix.shape[1])
            q, r = np.linalg.qr(np.concatenate([matrix, ridge]))
            target = np.concatenate([(light * share).ravel(), np.zeros(len(ridge))])
            answer = np.linalg.solve(r, q.T @ target)
            differences.append(np.concatenate([matrix, ridge]) @ answer - target)
            linear.append(answer.reshape(LINEAR, POINTS))
            bases.append(q)
        return np.stack(differences), np.stack(linear), bases

    def jacobian(self, x: np.ndarray, linear: np.ndarray, bases: list[Array]) -> Array:
        """How the differences change with control points, (A, rows, 24), without what the linear ones make up for."""
        values, found = self.numbers(x), []
        for points, share, base in zip(linear, self.share, bases, strict=True):
            curves = self.curve @ points.T
            rates = [slope(v, w, c, g) for v, w, c, g in zip(values, curves, self.cosine, self.angle, strict=True)]
            change = np.einsum("edk,ed,ep->edkp", np.stack(rates), share, self.curve).reshape(share.size, -1)
            change = np.concatenate([change, np.zeros((len(base) - share.size, change.shape[1]))])
            found.append(change - base @ (base.T @ change))
        return np.stack(found)

    def middle(self) -> Array:
        """A, B, E, H of the sun in the middle, fitted by itself, as constant curves, (24,)."""
        middle = self.family.elevations.size // 2
        sun = direction(np.pi, self.family.elevations[middle])
        return np.repeat(fitted(self.family.views, sun, self.light[0, middle])[0][[1, 2, 5, 8]], POINTS)

    def points(self, x: np.ndarray) -> tuple[Array, Array]:
        """Control points of all ten, (A, 6, 10), and the relative RMS errors, (A,)."""
        a, b, e, h = x.reshape(CURVES, POINTS)
        differences, linear, _ = self.solved(x)
        rows = [np.stack([np.ones(POINTS), a, b, c, d, e, f, g, h, i], axis=-1) for c, d, f, g, i in linear]
        square = (differences[:, : self.share[0].size] ** 2).sum(axis=1) * len(self.light)
        return np.stack(rows), np.sqrt(square)


def slope(x: Any, linear: Array, cosine: np.ndarray, angle: np.ndarray) -> Array:
    """Derivatives of the formula by A, B, E and H, (D, 4), at A, B, E, H (4,) and C, D, F, G, I (5,)."""
    a, b, e, h = x
    c, d, f, g, i = linear
    fall = gradation_term(b, cosine, OFFSET, OFFSET)
    glow, square, chi, root = indicatrix_terms(e, h, cosine, angle)
    inner, outer = c + d * glow + f * square + g * chi + i * root, 1 + a * fall
    by_h = g * chi * -3 * (h - np.cos(angle)) / (1 + h * h - 2 * h * np.cos(angle))
    return np.stack(
        [fall * inner, a * fall / (cosine + OFFSET) * inner, outer * d * glow * angle, outer * by_h], axis=-1
    )
