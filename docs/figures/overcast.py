"""overcast.png: skies under a layer of cloud by its depth, how they darken toward the horizon, and their spectrum."""

import matplotlib.pyplot as plt
import numpy as np
from drawing import common_exposure, disc_picture, dome_light, keep_plot, sky_toward

import skydome as sd

DEPTHS = (1.5, 3.0, 6.0, 12.0, 25.0, 50.0)
SUNS = (40.0, 8.0)
SIDE = 360


def domes(axes):
    """A row for each sun, a column for each depth, each sky exposed by itself."""
    for row, elevation in zip(axes, SUNS, strict=True):
        for place, depth in zip(row, DEPTHS, strict=True):
            sky = sd.OvercastSky(sky_toward(elevation), depth)
            light, valid = dome_light(sky, SIDE)
            place.imshow(disc_picture(light, valid, common_exposure([(light, valid)]), 1))
            place.set_axis_off()
            level = float(sd.illuminance(sky)) / 1000
            place.set_title(f"depth {depth:g}, sun {elevation:g}°\n{level:.2g} klx", fontsize=8)


def gradation(axis):
    """Luminance over that of the zenith, 90 degrees from the sun."""
    height = np.linspace(1.0, 90.0, 60)
    views, few = (sd.direction(np.pi / 2, np.radians(angles)) for angles in (height, height[::6]))
    for depth, colour in ((6.0, "#c97b2b"), (20.0, "#2b6cc9"), (50.0, "#26547c")):
        sky = sd.OvercastSky(sky_toward(40.0), depth)
        truth = sd.DiscreteOrdinates(sky.sun, sky.atmosphere, streams=32)
        axis.plot(height, sky.luminance(views) / sky.luminance(sd.ZENITH), color=colour, label=f"depth {depth:g}")
        dots = truth.radiance(few, [560.0]) / truth.radiance(sd.ZENITH, [560.0])
        axis.plot(height[::6], dots[:, 0], ".", color=colour)
    snow = sd.OvercastSky(sky_toward(40.0), 20.0, albedo=0.8)
    axis.plot(height, snow.luminance(views) / snow.luminance(sd.ZENITH), "--", color="#2b6cc9", label="20, over snow")
    axis.plot(height, (1 + 2 * np.sin(np.radians(height))) / 3, "k:", label="CIE overcast, 1 : 3")
    axis.set(xlabel="elevation, degrees", ylabel="luminance over the zenith's", ylim=(0.2, 1.15))
    axis.legend(fontsize=7)


def spectrum(axis):
    """Spectra of the zenith, 1 at 560 nm, with discrete ordinates' (dots) and two daylights."""
    w = np.arange(380.0, 781.0, 10.0)
    for elevation, colour in ((40.0, "#2b6cc9"), (8.0, "#7c2655")):
        sky = sd.OvercastSky(sky_toward(elevation), 20.0)
        light = sky.radiance(sd.ZENITH, sky.bands)
        axis.plot(w, light / light[18], color=colour, label=f"depth 20, sun {elevation:g}°")
        truth = sd.DiscreteOrdinates(sky.sun, sky.atmosphere, streams=16).radiance(sd.ZENITH, sky.bands)
        axis.plot(w[::2], (truth / truth[18])[::2], ".", color=colour)
    daylight = sd.daylight_spectrum([0.3147, 0.3275, 0.3578], w)
    axis.plot(w, daylight / daylight[18], "k:", label="CIE daylight, 6415 K")
    axis.set(xlabel="wavelength, nm", ylabel="radiance, 1 at 560 nm", ylim=(0.3, 1.7))
    axis.yaxis.tick_right()
    axis.yaxis.set_label_position("right")
    axis.legend(fontsize=7)


def main():
    figure = plt.figure(figsize=(10.5, 7.0))
    grid = figure.add_gridspec(3, 6, height_ratios=(1, 1, 1.7), hspace=0.35)
    domes([[figure.add_subplot(grid[row, k]) for k in range(6)] for row in range(2)])
    gradation(figure.add_subplot(grid[2, :3]))
    spectrum(figure.add_subplot(grid[2, 3:]))
    keep_plot(figure, "overcast")


if __name__ == "__main__":
    main()
