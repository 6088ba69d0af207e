"""A place on the earth."""

from dataclasses import dataclass
from typing import ClassVar

from skydome.ground.arguments import require_kind
from skydome.ground.limits.ranges import Bounded, Range


@dataclass(frozen=True)
class Place(Bounded):
    """A place: latitude and longitude in degrees, north and east positive, altitude in metres above the sea.

    >>> Place(latitude=45.07, longitude=7.69, altitude=240)
    Place(latitude=45.07, longitude=7.69, altitude=240)
    """

    latitude: float
    longitude: float
    altitude: float = 0.0
    bounds: ClassVar = {
        "latitude": Range(-90.0, 90.0),
        "longitude": Range(-180.0, 180.0),
        "altitude": Range(-500.0, 40_000.0),  # the pressure formula ends above
    }

    def __post_init__(self) -> None:
        self.require_bounds()

    @classmethod
    def required(cls, value: object) -> None:
        """TypeError unless the value is a place; two bare numbers do not tell which is which."""
        require_kind(value, cls, "place", "Place(latitude=45.07, longitude=7.69)")

    @classmethod
    def parse(cls, text: str) -> "Place":
        """The place written `latitude,longitude[,altitude]` in degrees and metres; ValueError for anything else.

        >>> Place.parse("45.07,7.69,240")
        Place(latitude=45.07, longitude=7.69, altitude=240.0)
        """
        require_kind(text, str, "place", "45.07,7.69,240")
        try:
            numbers = [float(part) for part in text.split(",")]
        except ValueError:
            numbers = []
        if len(numbers) not in (2, 3):
            raise ValueError(f"place must read latitude,longitude[,altitude] such as 45.07,7.69,240, got {text!r}")
        return cls(*numbers)
