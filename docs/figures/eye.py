"""Figures of the eye: views without and with its scattering (eye.png), and the spreads (eye_spreads.png)."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import skydome as sd
from skydome import deg
from skydome.ground.tone import Filmic, auto_exposure, tone_mapped
from skydome.light.colour import encode_srgb
from skydome.scene.point_spread import MESOPIC, PHOTOPIC, SCOTOPIC, CIETotal, stiles_holladay
from skydome.scene.streaks import Needles

HERE = Path(__file__).parent
PANEL = 480


def sky_map(azimuth: float, elevation: float, turbidity: float) -> sd.EnvironmentMap:
    """A clear sky with its sun."""
    sky = sd.HosekWilkie(sd.direction(azimuth * deg, elevation * deg), turbidity)
    return sd.render(sky + sd.SunDisc.of(sky), height=512)


def screen(picture: np.ndarray, exposure: float) -> np.ndarray:
    """A picture for the screen."""
    return encode_srgb(tone_mapped(picture * np.float32(exposure), Filmic()))


def views() -> None:
    """Day, sunset, the sun outside the picture, and a camera's lens; above without, below with."""
    day, evening = sky_map(180, 25, 3.0), sky_map(290, 4, 3.5)
    south = sd.View(170 * deg, 18 * deg, 60 * deg, PANEL)
    cases = [
        ("25 years, brown eyes", sd.Eye(25, "brown"), day, south),
        ("60 years, blue eyes", sd.Eye(60, "blue"), day, south),
        ("sunset, 60 years, blue", sd.Eye(60, "blue"), evening, sd.View(285 * deg, 8 * deg, 60 * deg, PANEL)),
        ("the sun 6° outside", sd.Eye(60, "blue"), day, sd.View(140 * deg, 18 * deg, 60 * deg, PANEL)),
        ("a camera's lens", sd.LensFlare(seed=5), day, south),
    ]
    figure, axes = plt.subplots(2, len(cases), figsize=(2.4 * len(cases), 5.1), layout="constrained")
    for (name, looker, sky, view), (above, below) in zip(cases, axes.T, strict=True):
        seen = looker.look(sky, view)
        exposure = auto_exposure(seen.eye @ sd.SRGB.to_xyz[1], view.solid_angles())
        above.imshow(screen(seen.plain, exposure))
        below.imshow(screen(seen.eye, exposure))
        above.set_title(name, fontsize=10)
    for panel in axes.flat:
        panel.set_axis_off()
    save(figure, "eye.png")


def spreads() -> None:
    """The spreads over angle, and a ring of needles."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    angle = np.geomspace(0.1, 90, 1000) * deg
    named = {"photopic": PHOTOPIC, "mesopic": MESOPIC, "scotopic": SCOTOPIC}
    for name, spread in named.items():
        left.loglog(angle / deg, spread(angle), "--", lw=1, label=f"Spencer 1995, {name}")
    for age in (20, 60, 80):
        left.loglog(angle / deg, CIETotal(age)(angle), label=f"CIE 135/1, {age} years, brown")
    valid = (angle > 1 * deg) & (angle < 30 * deg)
    left.loglog(angle[valid] / deg, stiles_holladay(angle[valid], 20), "k:", lw=2, label="Stiles-Holladay, 20 years")
    left.set(xlabel="angle from the source, degrees", ylabel="luminance per illuminance, sr⁻¹")
    left.legend(fontsize=8)
    turn = np.linspace(-np.pi, np.pi, 2000, dtype=np.float32)
    for a in (2, 5, 12):
        ring = Needles(radius=0.2666 * deg).factor(np.full_like(turn, a * deg), turn)
        right.plot(turn / deg, ring[:, 1], lw=0.9, label=f"{a}° from the sun")
    right.set(xlabel="turn about the sun, degrees", ylabel="factor (mean 1)", xlim=(-180, 180))
    right.legend(fontsize=8)
    save(figure, "eye_spreads.png")


def save(figure: plt.Figure, name: str) -> None:
    """Write a figure."""
    figure.savefig(HERE / name, dpi=100, pil_kwargs={"optimize": True})
    plt.close(figure)
    print(name, (HERE / name).stat().st_size)


if __name__ == "__main__":
    views()
    spreads()
