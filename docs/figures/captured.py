"""captured_animation.png and captured_masks.png: frames between captures, and skies found."""

import numpy as np
from drawing import FIGURES, canvas, keep, to_bytes, write
from PIL import Image

import skydome as sd
from skydome.captures.animation import Animation
from skydome.captures.capture import Capture
from skydome.captures.capture_training import train_captures
from skydome.light.tone import Filmic, auto_exposure, tone_mapped

PLACE = sd.Place(45.07, 7.69, 240)
HEIGHT, COUNT = 128, 8


def skyline(height):
    """True for ground and houses, (H, W)."""
    column = np.arange(2 * height)
    rise = 0.05 + 0.03 * np.sin(column / height * 9) + 0.06 * ((column // (height // 8)) % 3 == 1)
    return np.arange(height)[:, None] >= height / 2 - height * rise


def photographs():
    """Maps of a clear day with a skyline and grain, and their times."""
    rng = np.random.default_rng(0)
    times = np.datetime64("2026-06-21T05:00") + np.arange(COUNT) * np.timedelta64(110, "m")
    pictures = []
    for time in times:
        sky = sd.HosekWilkie(sd.sun_direction(PLACE, time), 3.0)
        pixels = sd.render(sky + sd.SunDisc.of(sky), HEIGHT).pixels
        pixels *= rng.lognormal(0, 0.01, pixels.shape).astype(np.float32)
        below = skyline(HEIGHT)
        pixels[below] = np.array([0.6, 0.8, 0.4]) * 0.3 * np.median(pixels[: HEIGHT // 4])
        pictures.append(sd.EnvironmentMap(pixels))
    return times, pictures


def shown(picture, exposure):
    return tone_mapped(picture.pixels * exposure, Filmic())


def main():
    times, pictures = photographs()
    captures = [Capture.of(p, sun=sd.sun_direction(PLACE, t), time=t) for p, t in zip(pictures, times, strict=True)]
    animation = Animation(captures, train_captures(captures))
    image, draw = canvas(4 * 2 * HEIGHT + 50, 3 * (HEIGHT + 22) + 10)
    moments = np.linspace(animation.times[1], animation.times[2], 4)
    exposure = auto_exposure(captures[1].picture.luminance())
    first, second = (captures[k].picture.pixels for k in (1, 2))
    for k, moment in enumerate(moments):
        share = k / 3
        rows = (
            animation.frame(moment),
            sd.EnvironmentMap((1 - share) * first + share * second),
            true_map(moment, times[0]),
        )
        for row, picture in enumerate(rows):
            place = (10 + k * (2 * HEIGHT + 10), 22 + row * (HEIGHT + 22))
            image.paste(Image.fromarray(to_bytes(shown(picture, exposure))), place)
            name = ("network with faded residual", "cross-fade", "the sky itself")[row]
            write(draw, (place[0], place[1] - 10), f"{name}, {share:.0%}", 12, "lm")
    keep(image, "captured_animation")
    masks(captures)


def true_map(moment, start):
    sky = sd.HosekWilkie(sd.sun_direction(PLACE, start + np.timedelta64(int(moment), "s")), 3.0)
    pixels = sd.render(sky + sd.SunDisc.of(sky), HEIGHT).pixels
    pixels[skyline(HEIGHT)] = np.array([0.6, 0.8, 0.4]) * 0.3 * np.median(pixels[: HEIGHT // 4])
    return sd.EnvironmentMap(pixels)


def masks(captures):
    """Three captures, what is no sky (or is the sun itself) in red."""
    image, draw = canvas(3 * (2 * HEIGHT + 10) + 10, HEIGHT + 34)
    for k, index in enumerate((0, 3, 7)):
        capture = captures[index]
        picture = shown(capture.picture, auto_exposure(capture.picture.luminance()))
        tinted = np.where(capture.sky[..., None], picture, 0.4 * picture + [0.25, 0.0, 0.0])
        place = (10 + k * (2 * HEIGHT + 10), 24)
        image.paste(Image.fromarray(to_bytes(tinted)), place)
        right = float(np.mean((capture.sky == ~skyline(HEIGHT))[: HEIGHT // 2]))
        write(draw, (place[0], 12), f"{right:.1%} of the upper half right", 12, "lm")
    keep(image, "captured_masks")


if __name__ == "__main__":
    main()
    print(*(path.name for path in FIGURES.glob("captured_*.png")))
