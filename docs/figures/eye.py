"""Figures of the eye: views without and with its scattering (eye.png), the spreads (eye_spreads.png), and the measured
tables of eye.md: each spread, and the veil in whole pictures, over Stiles and Holladay's veil.
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from drawing import table, update

import skydome as sd
from skydome import deg
from skydome.eye.point_spread import (
    MESOPIC,
    PHOTOPIC,
    PIGMENTS,
    SCOTOPIC,
    CIETotal,
    PointSpread,
    StilesHolladay,
    stiles_holladay,
)
from skydome.eye.streaks import Needles
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, auto_exposure, tone_mapped

HERE = Path(__file__).parent
PANEL = 480
ANGLES = (1, 2, 3, 5, 7, 10, 15, 20, 30)
AGES = (25, 45, 60, 80)


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
    south = sd.Camera(170 * deg, 18 * deg, 60 * deg, PANEL)
    cases = [
        ("25 years", sd.Eye(25), day, south),
        ("75 years", sd.Eye(75), day, south),
        ("75 years, blue eyes (CIE)", sd.Eye(75, "blue"), day, south),
        ("sunset, 60 years", sd.Eye(60), evening, sd.Camera(285 * deg, 8 * deg, 60 * deg, PANEL)),
        ("the sun 6° outside, 60 years", sd.Eye(60), day, sd.Camera(140 * deg, 18 * deg, 60 * deg, PANEL)),
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
    for age, tint in ((20, "C3"), (60, "C4"), (80, "C5")):
        left.loglog(angle / deg, CIETotal(age)(angle), tint, label=f"CIE 135/1, {age} years, brown")
        left.loglog(angle / deg, StilesHolladay(age)(angle), tint, ls=":", label=f"StilesHolladay({age})")
    left.set(xlabel="angle from the source, degrees", ylabel="luminance per illuminance, sr⁻¹")
    left.legend(fontsize=8)
    turn = np.linspace(-np.pi, np.pi, 2000, dtype=np.float32)
    for a in (2, 5, 12):
        ring = Needles(radius=0.2666 * deg).factor(np.full_like(turn, a * deg), turn)
        right.plot(turn / deg, ring[:, 1], lw=0.9, label=f"{a}° from the sun")
    right.set(xlabel="turn about the sun, degrees", ylabel="factor (mean 1)", xlim=(-180, 180))
    right.legend(fontsize=8)
    save(figure, "eye_spreads.png")


def row_of(name: str, spread: PointSpread, age: float) -> tuple[str, ...]:
    """The spread over Stiles and Holladay's veil at that age, and the angles where it is within 15 % of it."""
    at, fine = np.array(ANGLES) * deg, np.linspace(1, 30, 2901)
    near = np.abs(spread(fine * deg) / stiles_holladay(fine * deg, age) - 1) <= 0.15
    parts = [part for part in np.split(fine[near], np.nonzero(np.diff(fine[near]) > 0.015)[0] + 1) if part.size]
    spans = ", ".join(f"{part[0]:.1f}-{part[-1]:.1f}" for part in parts) or "nowhere"
    return (name, *(f"{ratio:.2f}" for ratio in spread(at) / stiles_holladay(at, age)), spans)


def in_pictures() -> list[tuple[str, ...]]:
    """The veil about a sun in whole pictures, over Stiles and Holladay's: needles, halo and all."""
    sun = sd.direction(180 * deg, 40 * deg)
    sky = sd.HosekWilkie(sun, 3.0)
    disc = sd.SunDisc.of(sky)
    bare, sunny = sd.render(sky, height=512), sd.render(sky + disc, height=512)
    view = sd.Camera(180 * deg, 40 * deg, 62 * deg, 1024)
    angle = np.arccos(np.clip(view.directions() @ sun, -1, 1)) / deg
    rows = []
    for age in AGES:
        eye = sd.Eye(age)
        veil = (eye.look(sunny, view).eye - eye.look(bare, view).eye) @ sd.SRGB.to_xyz[1]
        veil /= float(disc.illuminance(sun)) * stiles_holladay(angle * deg, age)
        rings = [veil[np.abs(angle / a - 1) < 0.03].mean() for a in ANGLES]
        rows.append((f"{age} years", *(f"{ring:.2f}" for ring in rings)))
    return rows


def tables() -> dict[str, str]:
    """The measured tables of eye.md."""
    named = {"Spencer, photopic": PHOTOPIC, "Spencer, mesopic": MESOPIC, "Spencer, scotopic": SCOTOPIC}
    rows = [row_of(f"{name} (A = 0)", spread, 0) for name, spread in named.items()]
    rows += [row_of(f"Spencer, photopic (A = {age})", PHOTOPIC, age) for age in AGES]
    for age in AGES:
        rows += [row_of(f"CIE 135/1, {age} years, {iris}", CIETotal(age, p), age) for iris, p in PIGMENTS.items()]
    rows += [row_of(f"`StilesHolladay`, {age} years", StilesHolladay(age), age) for age in AGES]
    angles = [f"{a}°" for a in ANGLES]
    return {
        "ratios": table(["spread", *angles, "within 15 % at"], rows),
        "pictures": table(["eye", *angles], in_pictures()),
    }


def save(figure: plt.Figure, name: str) -> None:
    """Write a figure."""
    figure.savefig(HERE / name, dpi=100, pil_kwargs={"optimize": True})
    plt.close(figure)
    print(name, (HERE / name).stat().st_size)


if __name__ == "__main__":
    views()
    spreads()
    update("eye.md", tables())
