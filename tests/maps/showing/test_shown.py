"""How skies and maps show themselves: pictures, tables with units, axes, arrays."""

from io import BytesIO

import numpy as np
import pytest
from PIL import Image

import skydome as sd

SUN = sd.direction(2.0, 0.7)
SKY = sd.HosekWilkie(SUN, 3.0)


def opened(png):
    """A PNG's pixels (H, W, 3)."""
    return np.asarray(Image.open(BytesIO(png)).convert("RGB"))


def test_a_sky_is_pictured_looking_up():
    """Bluer than red, brightest toward the sun: north-east is up and left."""
    pixels = opened(SKY._repr_png_())
    rows, columns, _ = pixels.shape
    assert rows == columns
    middle = pixels[rows // 2, columns // 2].astype(int)
    assert middle[2] > middle[0] > 0
    row, column, _ = sd.Fisheye().pixels(SUN, rows)
    assert pixels[int(row), int(column)].sum() > pixels[rows - int(row), columns - int(column)].sum() > 0
    assert (pixels[0, 0] == 255).all()  # off the disc


def test_a_sky_without_colour_is_grey():
    pixels = opened(sd.CIE(SUN, 12, illuminance=12_000.0)._repr_png_())
    assert (pixels.max(axis=-1) - pixels.min(axis=-1)).max() <= 1


def test_a_table_has_units():
    page = sd.Perez(SUN, -1.0, -0.32, 10.0, -3.0, 0.45, illuminance=12_000.0)._repr_html_()
    assert "azimuth 114.59°, elevation 40.11°" in page
    assert "cd m⁻²" in page
    assert "<img" in page
    assert "HosekWilkie + SunDisc" in (SKY + sd.SunDisc.of(SKY))._repr_html_()


def test_many_conditions_have_a_table_and_no_picture():
    many = sd.Preetham(SUN, turbidity=np.array([2.0, 3.0]))
    assert many._repr_png_() is None
    assert "<img" not in many._repr_html_()
    with pytest.raises(ValueError, match="one sky can be shown at a time"):
        many.plot()


def test_a_slow_sky_is_not_asked():
    slow = sd.DiscreteOrdinates(SUN)
    assert slow._repr_png_() is None
    assert (slow + SKY)._repr_png_() is None
    assert "DiscreteOrdinates" in slow._repr_html_()


def test_a_sky_on_axes_of_ones_own():
    from matplotlib.figure import Figure

    ax = Figure().add_subplot()
    assert SKY.plot(ax=ax) is ax
    assert {text.get_text() for text in ax.texts} >= {"N", "E", "S", "W"}


def test_a_map_is_an_array_and_shows_itself():
    picture = sd.render(SKY + sd.SunDisc.of(SKY), 32)
    np.testing.assert_array_equal(np.asarray(picture), picture.pixels)
    assert np.asarray(picture, dtype=np.float64).dtype == np.float64
    assert picture.shape == (32, 64, 3)
    assert opened(picture._repr_png_()).shape == (32, 64, 3)
    assert opened(sd.render(SKY, 600)._repr_png_()).shape[1] <= 512
    page = picture._repr_html_()
    assert f"{float(picture.illuminance()):,.0f} lx" in page
    assert "RGB times 1 is cd m⁻² (sRGB)" in page


def test_a_map_on_axes_says_where_north_is():
    blender = sd.target("blender").projection
    ax = sd.render(SKY, 32, projection=blender).plot()
    ticks = {label.get_text(): round(place) for place, label in zip(ax.get_xticks(), ax.get_xticklabels(), strict=True)}
    assert ticks == {"N": 90, "E": 180, "S": 270, "W": 0}
    assert not sd.render(SKY, 32, projection=sd.Fisheye()).plot().axison
