"""mars.png: a day and a sunset under the air of Mars, and its whole sky by the amount of dust."""

import numpy as np
from drawing import canvas, common_exposure, disc_picture, dome_light, font, keep, sky_toward, to_bytes
from PIL import Image

import skydome as sd
from skydome.light.spectrum import xyz_weights
from skydome.light.tone import Filmic, auto_exposure, tone_mapped
from skydome.skies.colour_sky import SpectralSky

deg = sd.deg
WIDTH, HEIGHT, FOV = 560, 360, 70 * deg
SIDE = 2 * 180
STREAMS = 48  # fewer are too bright beside the sun, where the dust scatters most
RADIUS = 0.2666 / 1.524 * deg
BANDS = SpectralSky.bands


def colours(radiance):
    """Linear sRGB (..., 3) of spectral radiance (..., W)."""
    return (radiance @ xyz_weights(BANDS)) @ sd.SRGB.from_xyz.T


def direct(air, sun):
    """Irradiance of the sun's beam at the ground on a plane that faces it, (W,)."""
    return air.sun_at(BANDS) * air.transmittance(sun[2], BANDS)


def ground(air, sky, sun):
    """Radiance of the level ground, (W,): its albedo in sun and sky."""
    sky_light = sd.irradiance(sky, BANDS, sd.ZENITH)
    return air.albedo_at(BANDS) / np.pi * (direct(air, sun) * sun[2] + sky_light)


def view_of(air, sun, azimuth, elevation, stops=0.0):
    """Linear sRGB of what a camera sees, and the exposure that suits it; the sun's disc is drawn pixel by pixel."""
    sky = sd.DiscreteOrdinates(sun, air, streams=STREAMS)
    frame = sd.Camera(azimuth * deg, elevation * deg, FOV, WIDTH, HEIGHT)
    toward = frame.directions()
    up = toward[..., 2] > 0
    light = np.empty((HEIGHT, WIDTH, BANDS.size))
    light[up] = sky.radiance(toward[up], BANDS)
    light[~up] = ground(air, sky, sun)
    picture = colours(light)
    exposure = auto_exposure(picture @ [0.2126, 0.7152, 0.0722], frame.solid_angles()) * 2.0**stops
    disc = np.clip((RADIUS - sd.angle_between(toward, sun)) / frame.pixel + 0.5, 0, 1)
    return picture + disc[..., None] * colours(direct(air, sun) / (np.pi * RADIUS**2)), exposure


def main():
    image, draw = canvas(2 * WIDTH + 30, HEIGHT + 380)
    scenes = (
        ("The sun 30° high, out of the picture to the right", sky_toward(30.0, 260.0), 200.0, 14.0, 0.0),
        ("The sun 5° high, exposed for its surroundings", sky_toward(5.0, 270.0), 270.0, 14.0, -2.0),
    )
    for place, (name, sun, azimuth, elevation, stops) in enumerate(scenes):
        picture, exposure = view_of(sd.Atmosphere.mars(), sun, azimuth, elevation, stops)
        shown = to_bytes(tone_mapped(picture * exposure, Filmic()))
        left = 10 + place * (WIDTH + 10)
        image.paste(Image.fromarray(shown), (left, 30))
        draw.text((left + WIDTH / 2, 15), name, fill=(30, 30, 30), font=font(15), anchor="mm")
    suns = [(0.2, 40.0), (0.5, 40.0), (1.0, 40.0), (0.5, 10.0)]
    skies = [
        sd.DiscreteOrdinates(sky_toward(height), sd.Atmosphere.mars(depth), streams=STREAMS) for depth, height in suns
    ]
    lights = [dome_light(sky, SIDE) for sky in skies]
    for place, ((depth, height), light) in enumerate(zip(suns, lights, strict=True)):
        exposure = common_exposure([light])
        left = 100 + place * 260
        image.paste(Image.fromarray(disc_picture(*light, exposure, zoom=2)), (left, HEIGHT + 75))
        text = f"dust {depth}, sun {height:.0f}°"
        draw.text((left + 90, HEIGHT + 60), text, fill=(30, 30, 30), font=font(15), anchor="mm")
    print(keep(image.crop((0, 0, image.width, HEIGHT + 265)), "mars"))


if __name__ == "__main__":
    main()
