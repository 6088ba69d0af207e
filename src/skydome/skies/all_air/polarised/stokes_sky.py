"""The rung of skies whose polarisation is known: Stokes parameters, degree and angle."""

from abc import abstractmethod
from typing import Any

from skydome.ground.arrays import Array, namespace, safe_divide, safe_sqrt
from skydome.skies.physical.atmosphere_sky import AtmosphereSky


class StokesSky(AtmosphereSky):
    """A sky that knows Stokes I, Q and U of its light.

    Q and U are told by the electric field toward the zenith and to the left of it, as one sees them looking at the
    sky: Q = <up^2> - <left^2>, U = 2 <up left>. At the zenith itself the view counts as one to the north.
    """

    @abstractmethod
    def stokes(self, directions: Array, wavelengths: Any) -> Array:
        """Stokes I, Q, U toward each direction (..., 3) at wavelengths (W,) nm, W m-2 sr-1 nm-1, shape (..., W, 3)."""

    def degree_of_polarisation(self, directions: Array, wavelengths: Any) -> Array:
        """Degree of linear polarisation toward each direction (..., 3), 0 to 1, shape (..., W); 0 where it is dark.

        >>> import skydome as sd
        >>> sky = sd.PhysicalSky(sd.direction(azimuth=180 * sd.deg, elevation=10 * sd.deg))
        >>> bool(0.5 < sky.degree_of_polarisation(sd.ZENITH, [550.0])[0] < 0.7)
        True
        """
        stokes = self.stokes(directions, wavelengths)
        q, u = stokes[..., 1], stokes[..., 2]
        return safe_divide(safe_sqrt(q * q + u * u), stokes[..., 0])

    def angle_of_polarisation(self, directions: Array, wavelengths: Any) -> Array:
        """Angle of the electric field, radians in [-pi/2, pi/2], shape (..., W).

        0 is vertical, toward the zenith, and it grows anticlockwise as one sees it looking at the sky: the
        astronomers' convention with the zenith in place of the pole.

        >>> import skydome as sd
        >>> sky = sd.PhysicalSky(sd.direction(azimuth=180 * sd.deg, elevation=10 * sd.deg))
        >>> toward = sd.direction(azimuth=[0.0, 90 * sd.deg], elevation=45 * sd.deg)
        >>> sky.angle_of_polarisation(toward, [650.0])[:, 0].round(1).tolist()
        [1.6, 0.1]
        """
        stokes = self.stokes(directions, wavelengths)
        return namespace(stokes).atan2(stokes[..., 2], stokes[..., 1]) / 2
