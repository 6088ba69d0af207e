"""Files that were cut, flipped, filled and swapped: read right, or refused in one ValueError or OSError."""

import json
import random
import warnings
from pathlib import Path

import numpy as np

import skydome as sd

SUN = np.array([0.0, 0.6, 0.8])
ROWS = "".join(f"{month} 21 {hour}.5 {600 + hour} {100 + month}\n" for month in (6, 7) for hour in range(24))
TAPE = (
    "place Turin\nlatitude 45.07\nlongitude -7.69\ntime_zone -15\nsite_elevation 240\nweather_data_file_units 1\n"
    + ROWS
)


def whole_files(folder):
    """One small good file of every kind that is read, and what reads it."""
    from skydome.maps.loading import load
    from skydome.own_air.grid import Grid
    from skydome.skies.formula.sky_tables import SkyTables
    from skydome.skies.neural.files import load_network, save_network, shipped_network
    from skydome.skies.physical.refitted import Numbers
    from skydome.skies.preetham import PreethamNumbers
    from skydome.years.gendaymtx import text as matrix_text
    from skydome.years.stores.sites import read_sites
    from skydome.years.weather.reading import read_weather

    picture = sd.render(sd.Preetham(SUN, 3.0), 16)
    picture.save(folder / "map.exr")
    picture.save(folder / "map.hdr")
    SkyTables([3.0], [0.1], [550.0], np.ones((1, 1, 6, 1, 10)), [[[0.01]]]).save(folder / "tables.npz")
    Numbers(np.array([0.1, 0.5]), np.array([500.0]), np.ones((2, 1, 10)), np.zeros((2, 1))).save(folder / "numbers.npz")
    PreethamNumbers.PRINTED.save(folder / "numbers.json")
    save_network(folder / "net.safetensors", shipped_network("preetham")[0], {})
    (folder / "grid.toml").write_text("turbidities = [2.0, 3.0]\nalbedos = [0.0, 1.0]\nstreams = 8\n")
    (folder / "tape.wea").write_text(TAPE)
    (folder / "sites.csv").write_text("name,file\nTurin,tape.wea\nMilan,tape.wea\n")
    with (folder / "sky.mtx").open("wb") as file:
        matrix_text.write(file, [np.ones((3, 2, 3), np.float32)], (3, 2), (45.0, 7.0), "ascii")
    np.savez(folder / "land.npz", elevation=np.arange(16.0).reshape(4, 4), dx=30.0, dy=30.0)
    readers = {
        "map.exr": load, "map.hdr": load, "tables.npz": SkyTables.load, "numbers.npz": Numbers.load,
        "numbers.json": PreethamNumbers.load, "net.safetensors": load_network, "grid.toml": Grid.load,
        "tape.wea": read_weather, "sites.csv": read_sites, "sky.mtx": matrix_text.read,
        "land.npz": elevation_of,
    }  # fmt: skip
    return {name: ((folder / name).read_bytes(), read) for name, read in readers.items()}


def elevation_of(path):
    from skydome.land.reading import read_elevation

    return read_elevation(path)


def damaged(content, chance):
    """The bytes with one kind of damage, sometimes several."""
    data = bytearray(content)
    for _ in range(chance.choice([1, 1, 1, 2, 8])):
        place = chance.randrange(len(data)) if data else 0
        kind = chance.randrange(9)
        if kind == 0:
            data = data[:place]
        elif kind == 1 and data:
            data[place] ^= 1 << chance.randrange(8)
        elif kind == 2 and data:
            data[place] = chance.randrange(256)
        elif kind == 3:
            data[place:place] = bytes(chance.randrange(256) for _ in range(chance.choice([1, 7, 100])))
        elif kind == 4:
            del data[place : place + chance.choice([1, 3, 50])]
        elif kind == 5:
            data[place : place + 4] = chance.choice([b"\xff" * 4, b"\0" * 4, b"nan ", b"1e99", b"-999", b"\n\n\n\n"])
        elif kind == 6:
            data = data + data[place:]
        elif kind == 7:
            data = data.replace(b"\n", chance.choice([b"\r", b"\r\n", b"\0", b""]))
        else:
            data[place:place] = chance.choice([b"[" * 5000, b"9" * 5000, b"\xef\xbb\xbf", b"\x1f\x8b"])
    return bytes(data)


def sound(value):
    """True where what was read holds no NaN light; weather may lack hours, and land has no light."""
    pixels = getattr(value, "pixels", None)
    return pixels is None or bool(np.isfinite(pixels).all() and np.isfinite(value.illuminance()))


def run(count, folder, seed=0, report=lambda done: None):
    """The faults of so many damaged files: name, number of the case, and what was raised."""
    chance, found = random.Random(seed), []
    whole = whole_files(folder)
    place = folder / "damaged"
    place.mkdir(exist_ok=True)
    (place / "tape.wea").write_bytes(whole["tape.wea"][0])
    for k in range(count):
        name = chance.choice(list(whole))
        content, read = whole[name]
        path = place / f"case{Path(name).suffix}"
        path.write_bytes(damaged(content, chance))
        try:
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                held = read(path)
            if not sound(held):
                found.append((name, k, "NaN was read"))
        except (ValueError, OSError) as error:
            if "\n" in str(error) or not str(error):
                found.append((name, k, f"not one line: {error!r}"))
        except Exception as error:
            found.append((name, k, repr(error)[:300]))
        report(k + 1)
    return found


if __name__ == "__main__":
    import sys
    import tempfile

    with tempfile.TemporaryDirectory() as here:
        print(json.dumps(run(int(sys.argv[1]), Path(here), int(sys.argv[2])), indent=1))
