"""The light of a sky on land and behind it: the sun's disc, the rest by direction, and what a camera sees of both."""

import numpy as np

from skydome.dome.integrals import discs_and_rest
from skydome.eye.view import Camera
from skydome.ground.directions import direction, tangent_frame, unit
from skydome.ground.quadrature import gauss_legendre
from skydome.haze.horizon_light import HORIZON
from skydome.light.colour import rgb_from_xyz
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky

SECTORS, RINGS = 16, 8
"""Azimuths of the skyline about each vertex, and elevations at which the sky is taken."""

SUN_POINTS = 4000
"""Points of the sun's disc that are laid onto the picture."""

ROWS = 64
"""Of a picture, at a time."""


def sun_of(sky: Sky) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Direction to the sun in a sky, two tangents as long as its disc's radius, and normal irradiance in RGB.

    Each (3,); dark without a disc.
    """
    discs, _ = discs_and_rest(sky)
    if not discs:
        return np.array([0.0, 0.0, 1.0]), np.zeros(3), np.zeros(3), np.zeros(3)
    disc, weight = discs[0]
    light = np.maximum(rgb_from_xyz(np.asarray(disc.normal_xyz)) * weight, 0.0)
    sun = np.asarray(disc.sun, dtype=np.float64)
    across, upward = (np.asarray(axis) * np.tan(disc.angular_radius) for axis in tangent_frame(sun))
    return sun, across, upward, light


def skylight_of(sky: Sky) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Azimuths (K,), elevations (M,), weights (M,) and the sky's RGB there (K, M, 3), without the sun's disc."""
    sines, steps = gauss_legendre(RINGS)
    azimuths, elevations = np.arange(SECTORS) * (2 * np.pi / SECTORS), np.arcsin(sines)
    nodes = direction(azimuths[:, None], elevations)
    light = np.maximum(rgb_of(discs_and_rest(sky)[1], nodes), 0.0)
    return azimuths, elevations, steps * (2 * np.pi / SECTORS), np.ascontiguousarray(light)


def rgb_of(skies: list[Sky], directions: np.ndarray) -> np.ndarray:
    """The sum of their RGB (..., 3); TypeError for a sky without colour."""
    total = np.zeros(directions.shape)
    for sky in skies:
        if not isinstance(sky, ColourSky):
            raise TypeError(f"{type(sky).__name__} knows luminance only; give it colour with Daylight(sky)")
        total = total + np.asarray(sky.rgb(directions))
    return total


def background_of(sky: Sky, camera: Camera, share: float = 1.0) -> np.ndarray:
    """RGB (H, W, 3) of the sky with a share of the sun's disc, whose energy is right at every resolution."""
    discs, rest = discs_and_rest(sky)
    height, width = camera.shape
    image = np.zeros((height, width, 3))
    for first in range(0, height, ROWS):
        last = min(first + ROWS, height)
        views = camera.directions(first, last)
        views[..., 2] = np.maximum(views[..., 2], HORIZON)  # a pixel on the horizon has sky in its upper part
        image[first:last] = np.maximum(rgb_of(rest, unit(views)), 0.0)
    for disc, weight in discs:
        points, light = disc.points(SUN_POINTS)
        row, column = (np.floor(place) for place in camera.place(points))  # NaN behind the camera
        seen = (row >= 0) & (row < height) & (column >= 0) & (column < width)
        radiance = (
            np.maximum(rgb_from_xyz(light) * (weight * share), 0.0)[seen]
            / camera.solid_angle_toward(points[seen])[:, None]
        )
        np.add.at(image, (row[seen].astype(int), column[seen].astype(int)), radiance)
    return image
