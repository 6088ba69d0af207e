"""A place on the earth."""

from dataclasses import dataclass

from skydome.ground.arguments import require_kind

LIMITS = {"latitude": (-90.0, 90.0), "longitude": (-180.0, 180.0), "altitude": (-500.0, 40000.0)}
"""What a `Place` allows: degrees, degrees, metres (the pressure formula ends above 40 km)."""


@dataclass(frozen=True)
class Place:
    """A place: latitude and longitude in degrees, north and east positive, altitude in metres above the sea.

    >>> Place(latitude=45.07, longitude=7.69, altitude=240)
    Place(latitude=45.07, longitude=7.69, altitude=240)
    """

    latitude: float
    longitude: float
    altitude: float = 0.0

    def __post_init__(self) -> None:
        for name, (low, high) in LIMITS.items():
            value = getattr(self, name)
            if not low <= value <= high:
                raise ValueError(f"{name} must lie in [{low:g}, {high:g}], got {value}")

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
        try:
            numbers = [float(part) for part in text.split(",")]
        except ValueError:
            numbers = []
        if len(numbers) not in (2, 3):
            raise ValueError(f"place must read latitude,longitude[,altitude] such as 45.07,7.69,240, got {text!r}")
        return cls(*numbers)
