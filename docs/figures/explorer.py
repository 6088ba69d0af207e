"""The explorer in Chromium, docs/figures/explorer_*.png: `python docs/figures/explorer.py`, or only those named.

Pictures of 1440 x 900, and of a phone; their colours are dithered into a palette, so that no bands show.
"""

import io
import shutil
import sys
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, sync_playwright

from skydome.explorer.serving import page_server

TURIN = "?v=1&place=45.07,7.687&name=Turin, Italy&zone=Europe/Rome&date=2026-06-21"
FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
DESK, PHONE = {"width": 1440, "height": 900}, {"width": 390, "height": 844}
SHOWN = {
    "noon": (f"{TURIN}&time=12:30&model=physical&turbidity=2.4", DESK),
    "sunset": (f"{TURIN}&time=20:52&model=physical&view=panorama&look=290&turbidity=2.6", DESK),
    "dusk": (f"{TURIN}&time=21:50&model=physical&view=panorama&look=300", DESK),
    "night": (f"{TURIN}&date=2026-01-03&time=22:40&model=physical&theme=dark", DESK),
    "stars": (f"{TURIN}&date=2026-01-18&time=22:00&model=physical&turbidity=2&theme=dark&view=panorama&look=180", DESK),
    "clouds": (
        f"{TURIN}&time=18:50&model=physical&turbidity=2.4&clouds=cumulus&clouded=0.4&seed=7&view=panorama&look=290",
        DESK,
    ),
    "overcast": (f"{TURIN}&time=16:30&model=overcast&depth=3&view=panorama&look=250&theme=dark", DESK),
    "false": (f"{TURIN}&time=16:30&model=physical&show=luminance&theme=light", DESK),
    "compare": (f"{TURIN}&time=17:10&model=physical&beside=preetham&theme=light&wipe=0.5", DESK),
    "year": (f"{TURIN}&theme=dark", DESK),
    "phone": (f"{TURIN}&time=18:40&model=physical", PHONE),
}


def year(page: Page) -> None:
    """Give the page a year's weather: the sun of every hour through air that changes from day to day."""
    import skydome as sd

    place = sd.Place(45.07, 7.69)
    rows = ["LOCATION,Torino,-,ITA,a made year,160590,45.07,7.69,1.0,240.0", *["-"] * 7]
    import numpy as np

    hours = np.datetime64("2026-01-01T00:30") - np.timedelta64(1, "h") + np.arange(8760) * np.timedelta64(1, "h")
    high = np.maximum(np.asarray(sd.sun_direction(place, hours))[:, 2], 0.0)
    clear = np.repeat(np.clip(np.random.default_rng(3).beta(1.6, 0.8, 365), 0.05, 1.0), 24)
    direct = 950 * clear**2 * np.exp(-0.09 / np.maximum(high, 0.02)) * (high > 0)
    diffuse = (60 + 330 * (1 - clear) * clear**0.3) * high**0.7
    for k, hour in enumerate(hours + np.timedelta64(90, "m")):
        day = (hour - np.timedelta64(1, "h")).astype(object)
        total = diffuse[k] + direct[k] * high[k]
        hours_light = f"{total:.0f},{direct[k]:.0f},{diffuse[k]:.0f}"
        rows.append(f"2026,{day.month},{day.day},{k % 24 + 1},0,x,12,6,50,99000,0,0,0,{hours_light}")
    show = "text => document.getElementById('skydome-explorer').explorer.year.show(text, 'torino.epw')"
    page.evaluate(show, "\n".join(rows))


def shot(page: Page, name: str, address: str) -> Image.Image:
    """One picture."""
    query, _ = SHOWN[name]
    page.goto(address + query)
    for _ in range(400):
        if page.evaluate("document.getElementById('skydome-explorer').explorer?.took.length > 0"):
            break
        page.wait_for_timeout(50)
    if name == "year":
        year(page)
    page.wait_for_timeout(9000)
    while not page.evaluate("document.getElementById('skydome-explorer').explorer.clouds.settled"):
        page.wait_for_timeout(500)
    return Image.open(io.BytesIO(page.screenshot(full_page=name == "phone")))


def main() -> None:
    """Take them."""
    with sync_playwright() as started, page_server() as server:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for name in sys.argv[1:] or SHOWN:
            scale = 1.5 if name == "phone" else 1
            context = browser.new_context(viewport=SHOWN[name][1], device_scale_factor=scale, color_scheme="dark")
            image = shot(context.new_page(), name, server.address).convert("RGB")
            palette = image.quantize(256, kmeans=1)
            small = image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)
            small.save(Path(__file__).with_name(f"explorer_{name}.png"), optimize=True)
            context.close()
        browser.close()


if __name__ == "__main__":
    main()
