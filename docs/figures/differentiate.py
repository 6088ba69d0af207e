"""Draws docs/figures/differentiate.png: turbidity and sun found in a noisy map by gradient descent, step by step.

python docs/figures/differentiate.py
"""

from pathlib import Path

import numpy as np
import torch

import skydome as sd

TRUTH = {"turbidity": 4.3, "azimuth": 215.0, "elevation": 28.0}
STARTS = [(2.0, 150.0, 60.0), (8.0, 250.0, 12.0), (3.0, 300.0, 45.0)]
STEPS = 300


def observed(height=96, seed=3):
    """A photographer's map of the true sky: the disc in it, 10 % noise, clouds; and which texels to believe."""
    sun = sd.direction(TRUTH["azimuth"] * sd.deg, TRUTH["elevation"] * sd.deg)
    sky = sd.HosekWilkieRGB(sun, TRUTH["turbidity"])
    picture = sd.render(sky + sd.SunDisc.of(sky), height)
    random = np.random.default_rng(seed)
    pixels = picture.pixels * (1 + 0.1 * random.standard_normal(picture.pixels.shape))
    views = picture.projection.directions(height)
    cloud = np.zeros(views.shape[:2], bool)
    for _ in range(9):
        centre = sd.direction(random.uniform(0, 2 * np.pi), random.uniform(0.15, 1.1))
        cloud |= views @ centre > np.cos(random.uniform(0.08, 0.3))
    pixels[cloud] = 9000.0 * random.uniform(0.7, 1.3, (cloud.sum(), 1))
    glare = picture.luminance() > 100 * np.median(picture.luminance()[: height // 2])
    return pixels, views, (views[..., 2] > 0.02) & ~cloud & ~glare


def descend(pixels, views, believed, start):
    """Turbidity, azimuth and elevation (degrees) after each step of Adam, (STEPS + 1, 3)."""
    data = torch.tensor(pixels[believed])
    toward = torch.tensor(views[believed])
    low, span = 1.0, 9.0
    turbidity = torch.logit(torch.tensor((start[0] - low) / span, dtype=torch.float64)).requires_grad_()
    heading = torch.deg2rad(torch.tensor(start[1:], dtype=torch.float64)).requires_grad_()
    optimiser = torch.optim.Adam([turbidity, heading], lr=0.05)
    decay = torch.optim.lr_scheduler.ExponentialLR(optimiser, 0.985)
    path = []
    for _ in range(STEPS + 1):
        t = low + span * torch.sigmoid(turbidity)
        path.append([t.item(), *torch.rad2deg(heading.detach()).tolist()])
        optimiser.zero_grad()
        light = sd.HosekWilkieRGB(sd.direction(heading[0], heading[1]), t).rgb(toward)
        difference = torch.log(light.clamp_min(1.0)) - torch.log(data.clamp_min(1.0))
        torch.nn.functional.huber_loss(difference, torch.zeros_like(difference), delta=0.3).backward()
        optimiser.step()
        decay.step()
    return np.array(path)


def tone(pixels, believed):
    """The map as a picture: exposed for the sky, what is not believed pale red."""
    from skydome.light.colour import encode_srgb

    exposure = 0.8 / np.percentile(pixels[believed], 97)
    shown = np.clip(encode_srgb(np.clip(pixels * exposure, 0, 1)), 0, 1)
    shown[~believed] = 0.5 * shown[~believed] + 0.5 * np.array([0.85, 0.35, 0.3])
    return shown


def draw(pixels, believed, paths):
    """The picture above, the three unknowns below."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 6.2), dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    grid = figure.add_gridspec(2, 3, height_ratios=[1.0, 1.25])
    axes = figure.add_subplot(grid[0, :])
    half = len(pixels) // 2
    axes.imshow(tone(pixels, believed)[:half], extent=(0, 360, 0, 90), aspect="auto")
    axes.plot(TRUTH["azimuth"], TRUTH["elevation"], "+", color="black", markersize=12)
    axes.set_xlabel("azimuth, degrees clockwise from north")
    axes.set_ylabel("elevation, degrees")
    axes.set_title("the map: 10 % noise, cloud and glare (red) left out, + the true sun", fontsize=10)
    for k, (name, truth) in enumerate(TRUTH.items()):
        axes = figure.add_subplot(grid[1, k])
        for path in paths:
            axes.plot(path[:, k], linewidth=1.5)
        axes.axhline(truth, color="black", linestyle="--", linewidth=0.8)
        axes.set_title(f"{name} (true: {truth:g})", fontsize=10)
        axes.set_xlabel("step of Adam")
    return figure


def main():
    pixels, views, believed = observed()
    paths = [descend(pixels, views, believed, start) for start in STARTS]
    for start, path in zip(STARTS, paths, strict=True):
        print(start, "->", path[-1].round(3).tolist())
    draw(pixels, believed, paths).savefig(Path(__file__).with_suffix(".png"))


if __name__ == "__main__":
    main()
