"""A sky that changes another: what it does not tell itself is that one's."""

from abc import abstractmethod
from typing import Any

from skydome.ground.arrays import Array
from skydome.skies.sky import Sky, SunlitSky


class WrappedSky(Sky):
    """A sky made of another, `wrapped`, whose day, sun and ground are its own."""

    @property
    @abstractmethod
    def wrapped(self) -> Sky:
        """The other sky."""

    @property
    def is_day(self) -> Array:
        """True where the other sky's sun is up."""
        return self.wrapped.is_day

    @property
    def valid(self) -> Array:
        """True where the other sky is valid."""
        return self.wrapped.valid

    @property
    def sunlit(self) -> SunlitSky | None:
        """The other sky's, so that `SunDisc.of` finds the sun."""
        return self.wrapped.sunlit

    @property
    def has_night(self) -> bool:
        """Whether the other sky goes dark with a sun."""
        return self.wrapped.has_night

    @property
    def albedo(self) -> Any:
        """That of the other sky's ground."""
        return self.wrapped.albedo


class WrappedSunlitSky(WrappedSky, SunlitSky):
    """A sky of a `sun` of its own, made of another that knows the air which that sun shines through."""

    @property
    @abstractmethod
    def wrapped(self) -> SunlitSky:
        """The other sky."""

    @property
    def sunlit(self) -> SunlitSky:
        """This sky."""
        return self

    @property
    def haze(self) -> Any:
        """Turbidity of the other sky's air, where it was made for one."""
        return self.wrapped.haze

    @property
    def far_air(self) -> Any:
        """The air of the other sky, that far things fade in."""
        return self.wrapped.far_air

    @property
    def sun_distance(self) -> Any:
        """Distance of the sun, AU, that the other sky knows."""
        return self.wrapped.sun_distance

    @property
    def direct_normal_illuminance(self) -> Any:
        """Illuminance of the sun on a plane that faces it, lx, as the other sky knows it."""
        return self.wrapped.direct_normal_illuminance

    def own_disc(self, angular_radius: Any) -> SunlitSky | None:
        """The sun's disc through the other sky's air, where it bends light."""
        return self.wrapped.own_disc(angular_radius)
