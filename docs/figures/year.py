"""A year of skies at Greensboro (TMY3, from pvlib's own data): `python docs/figures/year.py`."""

from pathlib import Path

import pvlib
from PIL import Image

import skydome as sd
from skydome.figures.skies import save_figure
from skydome.figures.years import year_figure

HERE = Path(__file__).parent

if __name__ == "__main__":
    data = sd.year(Path(pvlib.__file__).parent / "data" / "723170TYA.CSV")
    figure = year_figure(data, "Greensboro, North Carolina: a typical year of skies")
    figure.set_dpi(85)
    save_figure(figure, HERE / "year.png")
    with Image.open(HERE / "year.png") as picture:
        picture.convert("RGB").quantize(160).save(HERE / "year.png", optimize=True)
