"""quality.png: the light in Denver's TMY; daylight.png: an office's facade and desks, and a field of panels.

Denver's file is public and not part of this package; SKYDOME_DATA names the folder where `weather/denver.epw.gz` lies.
"""

import os
import warnings
from pathlib import Path

from PIL import Image

import skydome as sd
from skydome.figures.skies import save_figure
from skydome.figures.weather import weather_figure

HERE = Path(__file__).parent
FILE = Path(os.environ.get("SKYDOME_DATA", "data")) / "weather" / "denver.epw.gz"


def keep(figure, name, dpi=85):
    """The figure as a small PNG beside this script."""
    figure.set_dpi(dpi)
    save_figure(figure, HERE / name)
    with Image.open(HERE / name) as picture:
        picture.convert("RGB").quantize(96).save(HERE / name, optimize=True)


if __name__ == "__main__":
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # Denver's columns are at odds: that is what the picture shows
        weather = sd.read_weather(FILE)
        keep(weather_figure(sd.quality(weather)), "quality.png")
